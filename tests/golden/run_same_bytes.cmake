# The picture does not depend on the number of threads, the size of blocks or the instruction set; see golden.cmake.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")

function(same variant)
  render("${OUT}.${variant}.png" ${ARGN})
  execute_process(COMMAND "${CMAKE_COMMAND}" -E compare_files "${OUT}.one.png" "${OUT}.${variant}.png" RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${OUT}.one.png and ${OUT}.${variant}.png differ: ${ARGN}")
  endif()
endfunction()

render("${OUT}.one.png" +WT1)
same(two +WT2)
same(seven +WT7)
if(SWITCHES STREQUAL "")  # antialiasing looks at neighbours within a block, as POV-Ray's does
  same(blocks_of_10 +WT2 +BS10)
  same(blocks_of_64 +WT2 +BS64)
endif()

# Of the kernels that were built those that this processor runs.
get_filename_component(folder "${WHITTLE}" DIRECTORY)
set(needs_v2 "")
set(needs_v3 avx2 fma bmi2)
set(needs_v4 avx512f avx512vl avx512dq avx512bw avx512cd)
file(READ /proc/cpuinfo cpu LIMIT 65536)
foreach(level IN ITEMS v2 v3 v4)
  set(runs EXISTS "${folder}/libwhittle_kernel_${level}.so")
  foreach(feature IN LISTS needs_${level})
    list(APPEND runs AND cpu MATCHES ${feature})
  endforeach()
  if(${runs})
    same(${level} +WT1 --isa=${level})
  endif()
endforeach()
