# `cpack` in a build folder: a .deb and a .tar.gz of all that `cmake --install` installs. Name and
# version are the project's.
set(CPACK_GENERATOR "DEB;TGZ")
set(CPACK_PACKAGE_CONTACT "the lcpush authors")
set(CPACK_PACKAGE_VENDOR "lcpush")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # by dpkg-shlibdeps, which comes with g++
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libeigen3-dev, python3")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-numpy, g++, cmake")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
include(CPack)
