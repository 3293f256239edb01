# golden_case(csg/bite SIZE 160x120 AGREE 0.9995 [SWITCHES +A0.3 -J] [SHOULDFAIL "reason"])
#   Renders scenes/csg/bite.pov and compares with reference_images/csg/bite.png: at least the share AGREE of the pixels
#   within 3/255 in every channel. AGREE is what was measured less 0.0005: ratchet.py measures it and writes it into the
#   line. A failure leaves bite.actual.png and bite.diff.png in the build folder, names the worst pixel and the command
#   that traces it alone. make_references.py reads the same lines, so size and switches stand once.
#   Switches of two dashes, as --faithful, are Whittle's own and stay here.
#
# golden_same_bytes(csg/bite SIZE 160x120)
#   One thread, several threads, other blocks and every kernel that was built and runs here give the same file, byte by byte.
#
# golden_dump(csg/bite scene)
#   What --dump=scene prints is dumps/csg/bite.scene.txt.

function(golden_case name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SIZE;AGREE;SHOULDFAIL" "SWITCHES")
  if(NOT DEFINED arg_AGREE)
    message(WARNING "golden_case(${name}) has no bound, so every pixel has to agree: tests/golden/ratchet.py ${name} --write measures one")
    set(arg_AGREE 1)
  endif()
  list(JOIN arg_SWITCHES " " switches)
  golden_test(golden/${name} render ${name} SIZE=${arg_SIZE} AGREE=${arg_AGREE} "SWITCHES=${switches}"
              REFERENCE=${PROJECT_SOURCE_DIR}/reference_images/${name}.png)
  if(arg_SHOULDFAIL)
    set_tests_properties(golden/${name} PROPERTIES WILL_FAIL TRUE)
  endif()
endfunction()

function(golden_same_bytes name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "SIZE" "SWITCHES")
  list(JOIN arg_SWITCHES " " switches)
  golden_test(same_bytes/${name} same_bytes ${name} SIZE=${arg_SIZE} "SWITCHES=${switches}")
  set_property(TEST same_bytes/${name} APPEND PROPERTY LABELS every_kernel)
endfunction()

function(golden_dump name stage)
  golden_test(dump/${name}.${stage} dump ${name} STAGE=${stage} EXPECTED=${CMAKE_CURRENT_SOURCE_DIR}/dumps/${name}.${stage}.txt)
endfunction()

# test name, script run_<kind>.cmake, scene, KEY=value...
function(golden_test test kind name)
  set(definitions "")
  foreach(definition IN LISTS ARGN)
    list(APPEND definitions "-D${definition}")
  endforeach()
  add_test(NAME ${test} COMMAND ${CMAKE_COMMAND} -DWHITTLE=$<TARGET_FILE:whittle> -DSCENE=${PROJECT_SOURCE_DIR}/scenes/${name}.pov
           -DOUT=${CMAKE_CURRENT_BINARY_DIR}/${name} ${definitions} -P ${CMAKE_CURRENT_SOURCE_DIR}/run_${kind}.cmake)
  set_tests_properties(${test} PROPERTIES LABELS golden TIMEOUT 120)
endfunction()
