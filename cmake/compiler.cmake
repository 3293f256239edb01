# The compiler of a preset that names none: the first of those in packages.txt that is here. CXX in the environment has its usual say.
if(NOT CMAKE_CXX_COMPILER AND NOT DEFINED ENV{CXX})
  file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../packages.txt line REGEX "^[^#]*\\|")
  string(REGEX MATCHALL "clang(-[0-9]+)?|g\\+\\+" names "${line}")
  list(TRANSFORM names REPLACE "clang" "clang++")
  find_program(CMAKE_CXX_COMPILER NAMES ${names} REQUIRED)
endif()
