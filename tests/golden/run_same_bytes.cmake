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

# The least level runs everywhere; a machine without v3 refuses it by name, which is no difference.
same(v2 +WT1 --isa=v2)
file(READ /proc/cpuinfo cpu LIMIT 65536)
if(cpu MATCHES "avx2" AND cpu MATCHES "fma" AND cpu MATCHES "bmi2")
  same(v3 +WT1 --isa=v3)
endif()
if(cpu MATCHES "avx512f" AND cpu MATCHES "avx512vl" AND cpu MATCHES "avx512dq" AND cpu MATCHES "avx512bw" AND cpu MATCHES "avx512cd")
  same(v4 +WT1 --isa=v4)
endif()
