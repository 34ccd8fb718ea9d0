# What find_package(lcpush) needs: headers, libraries, targets and the version.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lcpush)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/lcpush ${PROJECT_BINARY_DIR}/include/lcpush
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS lcpush lcpush_desktop lcpush_c EXPORT lcpushTargets
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT lcpushTargets NAMESPACE lcpush:: DESTINATION ${package_dir})

configure_package_config_file(cmake/lcpushConfig.cmake.in lcpushConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(lcpushConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lcpushConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/lcpushConfigVersion.cmake DESTINATION ${package_dir})

if(LCPUSH_BUILD_TOOL)
  install(TARGETS lcpush_tool)
endif()
