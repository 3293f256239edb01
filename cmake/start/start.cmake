# A release build's start. Most of the start of a small picture is the loader's: it maps shared libraries, looks up some 2,000 of
# libstdc++'s names, and each page that it writes to is a fault of its own. So the program contains libstdc++, fmt and zlib and is linked at a
# fixed address, and kernels take the C++ runtime from whichever program opens them (docs/speed.md). Tested with clang alone.
set(WHITTLE_LEAN_START OFF)
if(CMAKE_BUILD_TYPE STREQUAL Release AND CMAKE_CXX_COMPILER_ID STREQUAL Clang AND WHITTLE_ISA_LEVELS AND NOT WHITTLE_TRAIN AND NOT WHITTLE_SANITIZE
   AND NOT WHITTLE_FUZZ)
  set(WHITTLE_LEAN_START ON)
endif()

# runtime_from_program(KERNEL): the module needs libc, libm and libgcc_s alone.
function(runtime_from_program kernel)
  target_link_options(${kernel} PRIVATE -nodefaultlibs)
  target_link_libraries(${kernel} PRIVATE m c gcc gcc_s c)
endfunction()

# lean_start(PROGRAM): as above; the names that the kernels ask for are read off them.
function(lean_start program)
  list(TRANSFORM WHITTLE_ISA_LEVELS REPLACE "(.+)" "$<TARGET_FILE:whittle_kernel_\\1>" OUTPUT_VARIABLE kernels)
  list(TRANSFORM WHITTLE_ISA_LEVELS REPLACE "(.+)" "whittle_kernel_\\1" OUTPUT_VARIABLE targets)
  set(names ${CMAKE_CURRENT_BINARY_DIR}/exported_names.rsp)
  add_custom_command(OUTPUT ${names} DEPENDS ${targets} ${PROJECT_SOURCE_DIR}/cmake/start/exported_names.cmake VERBATIM
    COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DOUTPUT=${names} "-DKERNELS=${kernels}" -P ${PROJECT_SOURCE_DIR}/cmake/start/exported_names.cmake)
  target_sources(${program} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/start/fmt.cpp ${names})
  set_source_files_properties(${PROJECT_SOURCE_DIR}/cmake/start/fmt.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
  set_property(TARGET ${program} APPEND PROPERTY LINK_DEPENDS ${names})
  # --as-needed drops the shared libraries later on the line that nothing asks for any more. libgcc_s stays shared: libc unwinds by it an
  # exception that passes through its own frames (std::call_once), and one exception unwound by two copies aborts.
  target_link_options(${program} PRIVATE -static-libstdc++ -no-pie @${names}
                      LINKER:--as-needed,--push-state,--whole-archive,-l:libz.a,--pop-state)
endfunction()
