find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(TBB REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(GIF REQUIRED)
find_package(xsimd REQUIRED)
# Debian's target asks for a library "xtl", which is headers for complex numbers that nothing here uses.
set_target_properties(xsimd PROPERTIES INTERFACE_LINK_LIBRARIES "")
find_package(pegtl REQUIRED)
find_package(Catch2 QUIET)  # 2 or 3; without it there are no tests: ./run does not install it

# The package's own CMake file carries an include path that does not exist on Debian 12; pkg-config is right.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
