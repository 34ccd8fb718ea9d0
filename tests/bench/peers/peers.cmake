# lcpush against the solvers of other libraries, those that are found (Debian: libdart-dev,
# libsiconos-numerics-dev, libbullet-dev). The headers alone, compiled for this machine's processor;
# the others run as they are installed, so the files that call them are compiled without that.
add_library(lcpush_peer_solvers OBJECT bench/peers/dart.cpp bench/peers/siconos.cpp
                                       bench/peers/bullet.cpp)
lcpush_compile_options(lcpush_peer_solvers)
target_compile_features(lcpush_peer_solvers PRIVATE cxx_std_17)
target_include_directories(lcpush_peer_solvers PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(lcpush_peer_solvers PRIVATE Eigen3::Eigen)

add_executable(peers bench/peers.cpp)
lcpush_compile_options(peers)
target_compile_options(peers PRIVATE -O3 -march=native)
target_include_directories(peers PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(peers PRIVATE lcpush::lcpush lcpush_peer_solvers)
set_target_properties(peers PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})

function(lcpush_add_peer name definition header suffix)
  find_path(LCPUSH_${name}_INCLUDE ${header} PATH_SUFFIXES ${suffix})
  set(found ${LCPUSH_${name}_INCLUDE})
  set(libraries)
  foreach(library IN LISTS ARGN)
    find_library(LCPUSH_${library}_LIBRARY ${library})
    if(NOT LCPUSH_${library}_LIBRARY)
      set(found OFF)
    endif()
    list(APPEND libraries ${LCPUSH_${library}_LIBRARY})
  endforeach()
  if(NOT found)
    message(STATUS "Not compared with ${name}: it was not found")
    return()
  endif()
  target_include_directories(lcpush_peer_solvers SYSTEM PRIVATE ${LCPUSH_${name}_INCLUDE})
  target_compile_definitions(lcpush_peer_solvers PRIVATE ${definition})
  target_link_libraries(peers PRIVATE ${libraries})
endfunction()

lcpush_add_peer(DART LCPUSH_HAS_DART dart/lcpsolver/Lemke.hpp "" dart)
lcpush_add_peer(Siconos LCPUSH_HAS_SICONOS numerics/LCP_Solvers.h siconos siconos_numerics)
lcpush_add_peer(Bullet LCPUSH_HAS_BULLET BulletDynamics/MLCPSolvers/btLemkeAlgorithm.h bullet
                BulletDynamics-float64 LinearMath-float64)
