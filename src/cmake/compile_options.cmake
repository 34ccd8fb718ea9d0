# The flags of our own targets. They are private: whoever links lcpush keeps their own.
function(lcpush_compile_options target)
  # Same input, same bits: no fused multiply-add where one compiler sees it and another does not.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
                                           -Wdouble-promotion)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Inlined into Eigen's storage and packet code, gcc 12 sees these two where they are not.
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized -Wno-array-bounds)
  endif()
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF
                                             COMPILE_WARNING_AS_ERROR "${LCPUSH_WARNINGS_AS_ERRORS}")
  if(LCPUSH_SANITIZE)
    # Eigen's own checks of sizes and indices are assertions: NDEBUG would take them out.
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined
                                             -fno-sanitize-recover=all -fno-omit-frame-pointer -UNDEBUG)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
      # Eigen takes blocks of empty matrices, whose address is an offset from null; none is read.
      target_compile_options(${target} PRIVATE -fno-sanitize=pointer-overflow)
    endif()
  endif()
endfunction()

# A room is compiled in one go: its files share most of what they include and instantiate, and so do
# rooms of fractions, of pictures and of reports. With LCPUSH_UNITY off, each file is compiled alone.
function(lcpush_compile_rooms target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD "${LCPUSH_UNITY}" UNITY_BUILD_MODE GROUP)
  if(NOT LCPUSH_UNITY) # what nearly every file reads is parsed once
    target_precompile_headers(${target} PRIVATE <Eigen/Core> <algorithm> <cmath> <string> <vector>)
  endif()
  foreach(source IN LISTS ARGN)
    cmake_path(GET source PARENT_PATH room)
    cmake_path(GET room FILENAME room)
    string(REGEX REPLACE "^(certify|play)$" "pivots" room ${room})
    string(REGEX REPLACE "^picture$" "draw" room ${room})
    string(REGEX REPLACE "^commands$" "report" room ${room})
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room})
  endforeach()
endfunction()
