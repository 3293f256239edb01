# whole_program(TARGET): in a release build, shading, walks and solids are optimised as one: up to 1.1 times on single rays, 1.5
# on many cuts. Of clang all of it is asked at once, not the parts that CMake's word stands for, with more inlining than by
# -O3 (1.01); that needs its own linker. It is told as well what its branches and calls count to (cmake/profile/README.md).
option(WHITTLE_TRAIN "kernels that count what they do, for cmake/profile/train.py" OFF)
if(WHITTLE_TRAIN)
  add_compile_definitions(WHITTLE_TRAIN)
endif()

set(WHITTLE_PROFILE "")
set(profile_text ${CMAKE_CURRENT_LIST_DIR}/profile/kernels.proftext)
if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  # Linker and reader of profiles are those of the compiler's version: older ones do not know what it writes.
  string(REGEX MATCH "^[0-9]+" clang ${CMAKE_CXX_COMPILER_VERSION})
  set(WHITTLE_LLD -fuse-ld=lld-${clang})
  if(NOT CMAKE_BUILD_TYPE STREQUAL Release)
    add_link_options(${WHITTLE_LLD})  # 0.9 s in place of 4.1 for a program without optimisation
  endif()
  find_program(WHITTLE_PROFDATA llvm-profdata-${clang})
  if(NOT WHITTLE_PROFDATA)
    message(WARNING "llvm-profdata-${clang} (Debian package llvm-${clang}) is missing: kernels are compiled without their profile")
  endif()
endif()
if(CMAKE_BUILD_TYPE STREQUAL Release AND WHITTLE_PROFDATA AND NOT WHITTLE_TRAIN)
  # Named by what it holds, so that another one compiles the kernels anew.
  file(SHA256 ${profile_text} profile_hash)
  string(SUBSTRING ${profile_hash} 0 12 profile_hash)
  set(WHITTLE_PROFILE ${PROJECT_BINARY_DIR}/kernels_${profile_hash}.profdata)
  execute_process(COMMAND ${WHITTLE_PROFDATA} merge -o ${WHITTLE_PROFILE} ${profile_text} COMMAND_ERROR_IS_FATAL ANY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${profile_text})
endif()

function(whole_program target)
  if(NOT CMAKE_BUILD_TYPE STREQUAL Release)
    return()
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    set_target_properties(${target} PROPERTIES INTERPROCEDURAL_OPTIMIZATION ON)
    return()
  endif()
  # Functions of one source are told from others by its name, not by its path, which is another one elsewhere; without the
  # values that calls are made with: clang 14 fails to count some.
  set(counted "SHELL:-mllvm -static-func-full-module-prefix=false" "SHELL:-mllvm -disable-vp=true")
  if(WHITTLE_TRAIN)
    # Counts kept in registers through loops would take clang an hour in one source.
    target_compile_options(${target} PRIVATE -fprofile-generate ${counted} "SHELL:-mllvm -do-counter-promotion=false")
    target_link_options(${target} PRIVATE -fprofile-generate ${WHITTLE_LLD})
    return()
  endif()
  target_compile_options(${target} PRIVATE -flto)
  target_link_options(${target} PRIVATE -flto ${WHITTLE_LLD} LINKER:--lto-O3,-mllvm,-inline-threshold=600)
  if(WHITTLE_PROFILE)
    # A function that has changed since it was counted is compiled as if it never had been; so is one that another clang
    # than that of train.py sees otherwise.
    target_compile_options(${target} PRIVATE -fprofile-use=${WHITTLE_PROFILE} ${counted} -Wno-profile-instr-unprofiled
                           -Wno-profile-instr-out-of-date -Wno-backend-plugin)
  endif()
endfunction()
