# cmake -DNM=NM -DOUTPUT=FILE -DKERNELS=FILE;... -P exported_names.cmake: the names of the C++ runtime that the kernels leave to the
# program that opens them, as options of its link. Fails where a kernel lacks a name of ours, which would show at its first call, and where it
# asks for streams: a library with its own libstdc++ would share their state with the program's.
set(names "")
foreach(kernel IN LISTS KERNELS)
  execute_process(COMMAND ${NM} -D --undefined-only ${kernel} OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL " U [A-Za-z0-9_.]+\n" found "${text}\n")  # those of libc and libm have a version
  list(APPEND names ${found})
endforeach()
list(TRANSFORM names REPLACE " U |\n" "")
list(REMOVE_DUPLICATES names)
list(SORT names)
set(of_runtime "^(_Zn[wa]|_Zd[la]|_Z(T[ISV])?NK?St|_Z(T[ISV])?St|_ZT[ISV]N10__cxxabiv1|__cxa_|__gxx_|__dynamic_cast$|__once_proxy$)")
set(options "")
foreach(name IN LISTS names)
  if(NOT name MATCHES "${of_runtime}")
    message(FATAL_ERROR "a kernel lacks ${name}")
  endif()
  if(name MATCHES "ios|stream|filebuf|locale")
    message(FATAL_ERROR "a kernel uses streams: ${name}")
  endif()
  string(APPEND options "-Wl,--undefined=${name}\n-Wl,--export-dynamic-symbol=${name}\n")
endforeach()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${options}" @ONLY)
