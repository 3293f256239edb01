# A scene without its golden_case line would never be compared.
file(GLOB_RECURSE scenes RELATIVE "${ROOT}/scenes" "${ROOT}/scenes/*.pov")
file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/CMakeLists.txt" lines REGEX "^golden_case\\(")
foreach(scene IN LISTS scenes)
  string(REGEX REPLACE "\\.pov$" "" name ${scene})
  if(NOT lines MATCHES "golden_case\\(${name} ")
    message(SEND_ERROR "scenes/${scene} has no golden_case in tests/golden/CMakeLists.txt")
  endif()
endforeach()
