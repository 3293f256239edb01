# A stage's printed result against the text kept beside the tests; see golden.cmake.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
execute_process(COMMAND "${WHITTLE}" --dump=${STAGE} ${scene_file} WORKING_DIRECTORY "${scene_folder}"
                RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE errors)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "exit status ${status}: ${errors}")
endif()
file(WRITE "${OUT}.${STAGE}.actual.txt" "${text}")
execute_process(COMMAND "${CMAKE_COMMAND}" -E compare_files "${EXPECTED}" "${OUT}.${STAGE}.actual.txt" RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  execute_process(COMMAND diff -u "${EXPECTED}" "${OUT}.${STAGE}.actual.txt")
  message(FATAL_ERROR "the ${STAGE} dump of ${scene_file} has changed")
endif()
