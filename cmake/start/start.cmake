# A release build's start, by clang, with which it is tested. Most of the start of a small picture is the loader's: shared libraries are mapped, some 2,000 of libstdc++'s names
# looked up, and each page that this writes to is a fault of its own. So the program has the C++ runtime, fmt and zlib within
# and stands at a place of its own, and kernels take the runtime from whoever opens them (docs/speed.md).
set(WHITTLE_LEAN_START OFF)
if(CMAKE_BUILD_TYPE STREQUAL Release AND CMAKE_CXX_COMPILER_ID STREQUAL Clang AND WHITTLE_ISA_LEVELS AND NOT WHITTLE_TRAIN AND NOT WHITTLE_SANITIZE AND NOT WHITTLE_FUZZ)
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
  # Shared libraries that come later on the line are left out where nothing asks for them any more. libgcc_s stays: an exception that comes
  # through libc (std::call_once) is unwound by that one, and two that unwind one exception abort.
  target_link_options(${program} PRIVATE -static-libstdc++ -no-pie @${names}
                      LINKER:--as-needed,--push-state,--whole-archive,-l:libz.a,--pop-state)
endfunction()
