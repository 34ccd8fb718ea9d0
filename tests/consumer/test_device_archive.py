"""The archive for devices: unpacked, CMake builds it as a part of another project and its example runs; ESP-IDF, Zephyr
(as far as their commands are played here) and PlatformIO find what they read; what cannot work is said in words.

    python3 test_device_archive.py CMAKE CXX SOURCE
"""
import json
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile

CMAKE, CXX, SOURCE = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
VERSION = re.search(r"^\s*VERSION (\S+)$", (SOURCE / "CMakeLists.txt").read_text(), re.M).group(1)
OWN = """cmake_minimum_required(VERSION 3.16)
project(own C CXX)
add_subdirectory(device_bundle)
add_executable(push device_bundle/main.c)
target_link_libraries(push PRIVATE lcpush)
"""
# The commands of the two systems that the bundle's CMakeLists.txt calls, as their documentation has them.
ESP = """cmake_minimum_required(VERSION 3.16)
project(own C CXX)
macro(idf_component_register)
  cmake_parse_arguments(given "" "" "SRCS;INCLUDE_DIRS" ${ARGN})
  set(COMPONENT_LIB __idf_lcpush)
  add_library(${COMPONENT_LIB} STATIC ${given_SRCS})
  target_include_directories(${COMPONENT_LIB} PUBLIC ${given_INCLUDE_DIRS})
endmacro()
add_subdirectory(device_bundle)
get_target_property(flags __idf_lcpush COMPILE_OPTIONS)
message(STATUS "flags ${flags}")
"""
ZEPHYR = """cmake_minimum_required(VERSION 3.16)
project(own C CXX)
macro(zephyr_library_named name)
  set(ZEPHYR_CURRENT_LIBRARY ${name})
  add_library(${name} STATIC "")
endmacro()
macro(zephyr_library_sources)
  target_sources(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endmacro()
add_library(zephyr_interface INTERFACE)
macro(zephyr_include_directories)
  target_include_directories(zephyr_interface INTERFACE ${ARGN})
endmacro()
add_subdirectory(device_bundle)
get_target_property(flags lcpush COMPILE_OPTIONS)
message(STATUS "flags ${flags}")
"""
REFUSED = [(["-std=c++14"], "lcpush needs C++17"),
           (["-std=c++17", "-U__INT_MAX__", "-D__INT_MAX__=32767"], "int of 32 bits"),
           (["-std=c++17", "-nostdinc++"], "no headers of C++")]


def output(*words, **more):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True, **more).stdout


with tempfile.TemporaryDirectory() as folder:
    here = pathlib.Path(folder)
    output(CMAKE, "-S", SOURCE, "-B", here / "make", "-DLCPUSH_BUILD_TESTS=OFF", f"-DCMAKE_CXX_COMPILER={CXX}")
    output(CMAKE, "--build", here / "make", "--target", "device_archive")
    with tarfile.open(here / "make" / f"lcpush-device-{VERSION}.tar.gz") as archive:
        archive.extractall(here)
    bundle = here / "device_bundle"
    for name, project in (("own", OWN), ("esp", ESP), ("zephyr", ZEPHYR)):
        (here / "CMakeLists.txt").write_text(project)
        said = output(CMAKE, "-S", here, "-B", here / name, f"-DCMAKE_CXX_COMPILER={CXX}", "-DCMAKE_BUILD_TYPE=Debug")
        if name == "own":
            output(CMAKE, "--build", here / "own")
            assert "tick 7: solved" in output(here / "own/push")
        else:
            assert "-ffp-contract=off" in re.search("flags (.*)", said)[1], said

    library = json.loads((bundle / "library.json").read_text())
    assert library["version"] == VERSION and (bundle / "include" / library["headers"]).is_file(), library
    assert f'version: "{VERSION}"' in (bundle / "idf_component.yml").read_text()
    assert "cmake: ." in (bundle / "zephyr/module.yml").read_text()

    for flags, sentence in REFUSED:
        refused = subprocess.run([CXX, *flags, f"-I{bundle}/include", "-E", "-o", "/dev/null", bundle / "lcpush.cpp"],
                                 capture_output=True, text=True)
        assert refused.returncode != 0 and sentence in refused.stderr, (flags, refused.stderr)
print("The archive builds, and says what cannot work.")
