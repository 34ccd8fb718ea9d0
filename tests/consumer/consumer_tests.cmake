# Somebody else's project, built both ways: on an installed lcpush and with its sources inside.
set(consumer_prefix ${CMAKE_CURRENT_BINARY_DIR}/consumer/prefix)

add_test(NAME consumer.install COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix
                                       ${consumer_prefix})
set_tests_properties(consumer.install PROPERTIES FIXTURES_SETUP installed_lcpush)

if(Python3_FOUND AND TARGET lcpush_tool)
  add_test(NAME consumer.installed
           COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/consumer/test_installed.py
                   ${consumer_prefix})
  set_tests_properties(consumer.installed PROPERTIES FIXTURES_REQUIRED installed_lcpush)
endif()

find_program(LCPUSH_DPKG_DEB dpkg-deb)
if(LCPUSH_DPKG_DEB AND Python3_FOUND AND TARGET lcpush_tool AND TARGET lcpush_desktop_shared)
  add_test(NAME consumer.package
           COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_SOURCE_DIR}/consumer/test_package.py
                   ${CMAKE_CPACK_COMMAND} ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR})
endif()

if(Python3_FOUND)
  add_test(NAME consumer.device_archive
           COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/consumer/test_device_archive.py
                   ${CMAKE_COMMAND} ${CMAKE_CXX_COMPILER} ${PROJECT_SOURCE_DIR})
endif()

add_test(
  NAME consumer.find_package
  COMMAND
    ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer
    ${CMAKE_CURRENT_BINARY_DIR}/consumer/find_package --build-generator ${CMAKE_GENERATOR}
    --build-options -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE}
    -DCMAKE_PREFIX_PATH=${consumer_prefix} --test-command ${CMAKE_CTEST_COMMAND} --output-on-failure)
set_tests_properties(consumer.find_package PROPERTIES FIXTURES_REQUIRED installed_lcpush)

if(Python3_FOUND AND CMAKE_GENERATOR STREQUAL "Ninja") # who tells what it would run
  set(same_options "")
  foreach(option IN ITEMS CMAKE_BUILD_TYPE CMAKE_CXX_COMPILER CMAKE_CXX_COMPILER_LAUNCHER LCPUSH_UNITY
                          LCPUSH_WARNINGS_AS_ERRORS)
    list(APPEND same_options -D${option}=${${option}})
  endforeach()
  add_test(NAME consumer.add_subdirectory
           COMMAND Python3::Interpreter ${CMAKE_CURRENT_SOURCE_DIR}/consumer/test_add_subdirectory.py
                   ${CMAKE_COMMAND} ${CMAKE_MAKE_PROGRAM} ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR}
                   ${CMAKE_CURRENT_BINARY_DIR}/consumer/add_subdirectory ${same_options})
endif()
