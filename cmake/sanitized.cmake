# sanitized_test(TARGET NAME): test NAME, whose program is TARGET, runs under the sanitizers too. For fast tests of what
# reads foreign text or indexes by hand; the whole suite would take too long.
add_custom_target(sanitized_tests)
function(sanitized_test target name)
  add_dependencies(sanitized_tests ${target})
  set_tests_properties(${name} PROPERTIES LABELS sanitized)
endfunction()
