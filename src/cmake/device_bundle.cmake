# Makes a folder that compiles without anything else: the C interface, the headers that it reads, and
# Eigen's with their licence. Which ones these are, the compiler says (-M). Run by
# `cmake -DSOURCES=.. -DEIGEN=.. -DCOMPILER=.. -DVERSION=.. -DOUTPUT=.. -P device_bundle.cmake`.
#
# OUTPUT is made afresh. COMPILER is any gcc or clang of this machine: with Eigen's vector units left
# out the headers are the same for every processor.
cmake_minimum_required(VERSION 3.25)

foreach(given IN ITEMS SOURCES EIGEN COMPILER VERSION OUTPUT)
  if("${${given}}" STREQUAL "")
    message(FATAL_ERROR "device_bundle: -D${given}= is missing")
  endif()
endforeach()
list(GET EIGEN 0 EIGEN) # a second one is where it would be installed
if(EXISTS "${OUTPUT}" AND NOT EXISTS "${OUTPUT}/lcpush.cpp")
  message(FATAL_ERROR "device_bundle: ${OUTPUT} is there and is no bundle")
endif()
file(REMOVE_RECURSE "${OUTPUT}")

# The one file to compile.
file(GLOB_RECURSE parts RELATIVE "${SOURCES}" "${SOURCES}/src/c/*.cpp")
set(includes "")
foreach(part IN LISTS parts)
  string(APPEND includes "#include \"${part}\"\n")
endforeach()
file(CONFIGURE OUTPUT "${OUTPUT}/lcpush.cpp" @ONLY CONTENT
[[// lcpush @VERSION@, all of its C interface: compile this file and link the object (README.md).
#if __cplusplus < 201703L
#error "lcpush needs C++17: give the compiler -std=c++17"
#endif
#if defined(__INT_MAX__) && __INT_MAX__ < 2147483647
#error "lcpush needs an int of 32 bits: processors of 8 and 16 bits are too small for it"
#endif
#if defined(__has_include)
#if !__has_include(<cmath>)
#error "this toolchain has no headers of C++: README.md says how it reads those of another"
#endif
#endif
// These may also stand in the compiler's command.
#ifndef EIGEN_DONT_VECTORIZE
#define EIGEN_DONT_VECTORIZE // sums in one order everywhere; headers for vector units are not here
#endif
#ifndef EIGEN_UNROLLING_LIMIT
#define EIGEN_UNROLLING_LIMIT 0 // the same, and 5 KB of code less
#endif
#ifndef EIGEN_NO_DEBUG
#define EIGEN_NO_DEBUG // no assertions, which would print
#endif
#ifndef EIGEN_NO_IO
#define EIGEN_NO_IO
#endif
#ifndef EIGEN_MPL2_ONLY
#define EIGEN_MPL2_ONLY // nothing of Eigen's that is under the LGPL
#endif

@includes@]])

execute_process(
  COMMAND "${COMPILER}" -std=c++17 -M "-I${SOURCES}/include" "-I${SOURCES}" -isystem "${EIGEN}"
          "${OUTPUT}/lcpush.cpp"
  OUTPUT_VARIABLE read ERROR_VARIABLE said RESULT_VARIABLE failed)
if(failed)
  file(REMOVE_RECURSE "${OUTPUT}")
  message(FATAL_ERROR "device_bundle: ${COMPILER} does not say what it reads:\n${said}")
endif()

# A rule of make as a list: blanks within names are escaped there.
string(ASCII 1 blank)
string(REPLACE "\\\n" " " read "${read}")
string(REPLACE "\\ " "${blank}" read "${read}")
string(REPLACE "$$" "$" read "${read}")
string(REPLACE "\\#" "#" read "${read}")
string(REGEX REPLACE "[ \n]+" ";" read "${read}")
list(REMOVE_ITEM read "")
list(REMOVE_DUPLICATES read)
set(of_eigen 0)
set(of_others "")
foreach(file IN LISTS read)
  string(REPLACE "${blank}" " " file "${file}")
  foreach(place IN ITEMS "${SOURCES}/include=include" "${SOURCES}/src=src" "${EIGEN}=include")
    string(REGEX MATCH "^(.*)=([a-z]+)$" found "${place}")
    set(folder "${CMAKE_MATCH_1}")
    set(target "${CMAKE_MATCH_2}")
    cmake_path(IS_PREFIX folder "${file}" NORMALIZE inside)
    if(inside)
      cmake_path(RELATIVE_PATH file BASE_DIRECTORY "${folder}" OUTPUT_VARIABLE name)
      cmake_path(GET name PARENT_PATH room)
      file(MAKE_DIRECTORY "${OUTPUT}/${target}/${room}")
      file(COPY_FILE "${file}" "${OUTPUT}/${target}/${name}")
      if(folder STREQUAL EIGEN)
        math(EXPR of_eigen "${of_eigen} + 1")
        file(READ "${file}" text LIMIT 2000)
        if(text MATCHES "Licensed under|Redistribution and use")
          string(APPEND of_others "    include/${name}\n")
        endif()
      endif()
      break()
    endif()
  endforeach()
endforeach()
if(of_eigen EQUAL 0)
  message(FATAL_ERROR "device_bundle: no header of ${EIGEN} is read")
endif()

# Eigen's licence: as it came with the headers, or at least a word of where it stands.
file(STRINGS "${EIGEN}/Eigen/src/Core/util/Macros.h" version REGEX "define EIGEN_[A-Z]+_VERSION [0-9]+")
string(REGEX REPLACE "[^0-9;]" "" version "${version}")
string(REPLACE ";" "." version "${version}")
file(GLOB texts "${EIGEN}/COPYING.MPL2" "${EIGEN}/../COPYING.MPL2"
     "${EIGEN}/../../share/licenses/eigen*/COPYING.MPL2"
     "${EIGEN}/../../share/doc/libeigen3-dev/copyright")
set(text "https://mozilla.org/MPL/2.0/ has its text.\n")
if(texts)
  list(GET texts 0 text)
  file(READ "${text}" text)
  set(text "What came with them:\n\n${text}")
endif()
file(GLOB texts "${EIGEN}/COPYING.APACHE" "${EIGEN}/../COPYING.APACHE"
     "${EIGEN}/../../share/licenses/eigen*/COPYING.APACHE" "${EIGEN}/../../share/common-licenses/Apache-2.0")
set(apache "http://www.apache.org/licenses/LICENSE-2.0 has the text of Apache 2.0.\n")
if(texts)
  list(GET texts 0 apache)
  file(READ "${apache}" apache)
endif()
file(WRITE "${OUTPUT}/LICENSE.Eigen"
     "include/Eigen holds ${of_eigen} headers of Eigen ${version}, https://eigen.tuxfamily.org, unchanged and as\n"
     "source. They are subject to the terms of the Mozilla Public License, v. 2.0, but for those that begin\n"
     "with terms of their own, BSD or Apache 2.0:\n\n${of_others}\n${text}\n${apache}")

file(COPY "${SOURCES}/LICENSE" DESTINATION "${OUTPUT}")
file(COPY_FILE "${SOURCES}/docs/embed/main.c" "${OUTPUT}/main.c")
file(READ "${SOURCES}/docs/embed/bundle.md" page)
string(REPLACE "# lcpush for a device" "# lcpush ${VERSION} for a device" page "${page}")
file(WRITE "${OUTPUT}/README.md" "${page}")

# What PlatformIO, ESP-IDF and Zephyr read of a library.
set(packages "${SOURCES}/src/cmake/bundle")
file(GLOB_RECURSE names RELATIVE "${packages}" "${packages}/*")
foreach(name IN LISTS names)
  configure_file("${packages}/${name}" "${OUTPUT}/${name}" @ONLY)
endforeach()
