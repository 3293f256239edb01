# Flags shared by every target of ours: `target_link_libraries(x PRIVATE project_options)`.
add_library(project_options INTERFACE)
target_compile_options(project_options INTERFACE -Wall -Wextra -Wconversion -Wshadow -fno-math-errno -fno-trapping-math
                       -ffp-contract=off -fvisibility=hidden)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
if(WHITTLE_SANITIZE)
  # Half of the time that these tests take goes into compiling, so there is no optimisation; -g1 still names lines. The
  # null check is off because the address sanitizer stops at null pointers anyway, and because checking each use of a member
  # makes the grammar take 1.4 times as long. float-cast-overflow is off: a double beyond an integer's range is converted as
  # the processor does it. Warnings are the release build's.
  set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O0 -g1 -w")
  add_compile_options(-fsanitize=${WHITTLE_SANITIZE} -fno-sanitize=null,alignment,float-cast-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${WHITTLE_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    add_compile_definitions(__SANITIZE_ADDRESS__=1)  # g++ defines it by itself; with it, tests run an eighth of their cases
  endif()
endif()
if(WHITTLE_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)  # counts branches; targets without a main link libFuzzer's
endif()

# Unity builds of twenty sources each, because most of the compiler's work is reading headers. Names in unnamed namespaces
# must therefore differ within a target. While you work on one file, -DCMAKE_UNITY_BUILD=OFF compiles it alone.
set(CMAKE_UNITY_BUILD ON CACHE BOOL "compile several sources at a time")
set(CMAKE_UNITY_BUILD_BATCH_SIZE 20)

# Levels of x86-64 (psABI: v2, v3, v4) for which a kernel module is built. Other processors have v2's alone, in words of their own
# (numbers/instructions.h), and x86-64's signs of char.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set(WHITTLE_ISA_LEVELS v2 v3 v4 CACHE STRING "levels of x86-64 to build")
  set(WHITTLE_ISA_FLAG -march=x86-64-)
else()
  set(WHITTLE_ISA_LEVELS v2 CACHE STRING "levels of x86-64 to build" FORCE)
  add_compile_options(-fsigned-char)
  # xsimd asks for the headers of x86-64's compilers.
  foreach(header IN ITEMS emmintrin xmmintrin pmmintrin tmmintrin smmintrin nmmintrin)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/x86/${header}.h CONTENT "#include \"numbers/instructions.h\"\n")
  endforeach()
  include_directories(BEFORE ${PROJECT_BINARY_DIR}/x86 ${PROJECT_SOURCE_DIR})
endif()

# Programs and the modules that they open at run time go into one folder: a program looks for modules beside itself.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})

# `cmake --install` puts modules into a folder of their own. The program finds it by a relative path, so that what was
# installed may be moved.
include(GNUInstallDirs)
set(WHITTLE_MODULE_FOLDER ${CMAKE_INSTALL_LIBDIR}/whittle)
file(RELATIVE_PATH WHITTLE_MODULES_FROM_PROGRAM /${CMAKE_INSTALL_BINDIR} /${WHITTLE_MODULE_FOLDER})
