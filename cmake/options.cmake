# Flags shared by every target of ours: `target_link_libraries(x PRIVATE project_options)`.
add_library(project_options INTERFACE)
target_compile_options(project_options INTERFACE -Wall -Wextra -Wconversion -Wshadow -fno-math-errno -fno-trapping-math
                       -ffp-contract=off -fvisibility=hidden)
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
if(WHITTLE_SANITIZE)
  # Compiling is most of the time that ./check spends here: no optimisation, lines are named all the same. Null pointers
  # stop the address sanitizer too; with the checks for them at every use of a member a grammar takes 1.4 times as long.
  # A double beyond an integer's range is converted as the processor does.
  set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O0 -g1")
  add_compile_options(-fsanitize=${WHITTLE_SANITIZE} -fno-sanitize=null,alignment,float-cast-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${WHITTLE_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    add_compile_definitions(__SANITIZE_ADDRESS__=1)  # as g++ says it: tests ask an eighth of their cases then
  endif()
endif()
if(WHITTLE_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)  # counts branches; the target that has no main links the rest
endif()

# Twenty sources of a target at a time: NNN of the compiler's work. Names in unnamed namespaces must differ within
# a folder; -DCMAKE_UNITY_BUILD=OFF while one file is worked on.
set(CMAKE_UNITY_BUILD ON CACHE BOOL "compile several sources at a time")
set(CMAKE_UNITY_BUILD_BATCH_SIZE 20)

# Levels of x86-64 that get a kernel module of their own.
set(WHITTLE_ISA_LEVELS v2 v3 v4 CACHE STRING "levels of x86-64 to build")

# One folder for programs and the modules that they open at run time, so that each finds them beside itself.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})

# `cmake --install` puts the modules apart; the program finds them by the way from its own folder, wherever that is moved to.
include(GNUInstallDirs)
set(WHITTLE_MODULE_FOLDER ${CMAKE_INSTALL_LIBDIR}/whittle)
file(RELATIVE_PATH WHITTLE_MODULES_FROM_PROGRAM /${CMAKE_INSTALL_BINDIR} /${WHITTLE_MODULE_FOLDER})
