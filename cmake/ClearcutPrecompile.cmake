# Gives the modules named one precompiled header, made with the first of them; all are compiled with the same options.
function(clearcut_precompile first)
  if(NOT CLEARCUT_PRECOMPILED_HEADERS)
    return()
  endif()
  target_precompile_headers(clearcut_${first} PRIVATE <fmt/format.h> <algorithm> <array> <cmath> <functional> <map> <memory>
    <numeric> <optional> <string> <vector>)
  foreach(module IN LISTS ARGN)
    target_precompile_headers(clearcut_${module} REUSE_FROM clearcut_${first})
  endforeach()
endfunction()

# The same for test programs, with the headers of the test library. All have to be compiled with the same options.
function(clearcut_precompile_tests first)
  if(NOT CLEARCUT_PRECOMPILED_HEADERS)
    return()
  endif()
  target_precompile_headers(${first} PRIVATE <gmock/gmock.h> <gtest/gtest.h> <fmt/format.h> <algorithm> <array> <cmath>
    <functional> <map> <numeric> <optional> <string> <vector>)
  foreach(test IN LISTS ARGN)
    target_precompile_headers(${test} REUSE_FROM ${first})
  endforeach()
endfunction()
