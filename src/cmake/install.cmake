# What find_package(lcpush) needs: headers, libraries, targets and the version.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lcpush)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/lcpush ${PROJECT_BINARY_DIR}/include/lcpush
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS lcpush lcpush_desktop lcpush_c EXPORT lcpushTargets
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(TARGET lcpush_desktop_shared)
  install(TARGETS lcpush_desktop_shared EXPORT lcpushTargets
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  # Where Debian's Python looks; it finds the library in the folders above.
  set(LCPUSH_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Where the Python package goes")
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/python/lcpush DESTINATION ${LCPUSH_PYTHON_DIR}
          FILES_MATCHING PATTERN "*.py" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
endif()

# Debian's place of a licence.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/lcpush
        RENAME copyright)

install(EXPORT lcpushTargets NAMESPACE lcpush:: DESTINATION ${package_dir})
configure_package_config_file(cmake/lcpushConfig.cmake.in lcpushConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(lcpushConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lcpushConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/lcpushConfigVersion.cmake DESTINATION ${package_dir})

if(LCPUSH_BUILD_TOOL)
  install(TARGETS lcpush_tool)
  # What shells and man read, made by the tool itself from the table behind --help.
  set(made "")
  foreach(reader IN ITEMS bash zsh fish man)
    set(file_bash lcpush)
    set(file_zsh _lcpush)
    set(file_fish lcpush.fish)
    set(file_man lcpush.1)
    set(place_bash ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
    set(place_zsh ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
    set(place_fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
    set(place_man ${CMAKE_INSTALL_MANDIR}/man1)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/${reader}/${file_${reader}})
    add_custom_command(
      OUTPUT ${output}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_CURRENT_BINARY_DIR}/${reader}
      COMMAND lcpush_tool completion ${reader} -o ${output}
      DEPENDS lcpush_tool)
    list(APPEND made ${output})
    install(FILES ${output} DESTINATION ${place_${reader}})
  endforeach()
  add_custom_target(lcpush_completions ALL DEPENDS ${made})
endif()
