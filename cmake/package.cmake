# The Debian package: cmake/package.sh builds it, tests/package/clean_root.sh tries it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME whittle)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The Whittle project <whittle@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "renderer of POV-Ray scene files with constructive solid geometry")
set(CPACK_PACKAGE_DESCRIPTION "Whittle renders scenes in the language of POV-Ray 3.7, exact solids and all, shows them while they are
edited, tells their volumes, and lets them leave as meshes. It is an independent program and speaks POV-Ray's command line.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # what the program and its modules are linked with, by dpkg-shlibdeps
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS povray-includes)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "povray, python3-numpy")  # numpy: for the Python package
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/postinst ${PROJECT_SOURCE_DIR}/packaging/prerm)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# `cmake --install` and cpack take what was built: tests need not be.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
include(CPack)
