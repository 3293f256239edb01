# precompiled(TARGET HEADER...): the library headers that most sources of TARGET include are read once, and with them the
# headers of ours that all of them include. Pays where a target has more than five batches of sources. ccache needs
# -fpch-preprocess and its sloppiness (CMakePresets.json) to cache files that use them.
function(precompiled target)
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits> <map> <memory> <optional> <set> <stdexcept>
    <string> <string_view> <utility> <variant> <vector> <glm/glm.hpp> ${ARGN})
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(${target} PRIVATE -fpch-preprocess)
  else()
    target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
endfunction()

# precompiled_like(OWNER TARGET...): the same file as OWNER's, which has to be made without options that TARGET lacks.
function(precompiled_like owner)
  foreach(target ${ARGN})
    target_precompile_headers(${target} REUSE_FROM ${owner})
    if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU)
      target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
    endif()
  endforeach()
endfunction()
