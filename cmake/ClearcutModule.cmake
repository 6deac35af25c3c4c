# clearcut_add_module(NAME): the folder src/NAME becomes the static library clearcut_NAME, and every
# *_test.cpp beside its sources one test executable NAME_test. What a module may include is read from
# src/dependencies.txt, which also gives the link order; a test compares the includes with that file.
file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/src/dependencies.txt CLEARCUT_DEPENDENCY_LINES REGEX "^[a-z]")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/dependencies.txt)

function(clearcut_add_module name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/${name}/*.cpp)
  set(tests ${sources})
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")

  set(uses "")
  foreach(line ${CLEARCUT_DEPENDENCY_LINES})
    if(line MATCHES "^${name}:(.*)$")
      string(STRIP "${CMAKE_MATCH_1}" uses)
      string(REPLACE " " ";" uses "${uses}")
    endif()
  endforeach()
  list(TRANSFORM uses PREPEND clearcut_)

  if(sources)
    add_library(clearcut_${name} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(clearcut_${name} PRIVATE clearcut_options)
  else()
    add_library(clearcut_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(clearcut_${name} ${scope} ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(clearcut_${name} ${scope} ${uses})

  if(CLEARCUT_TESTS AND tests)
    add_executable(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE clearcut_${name} clearcut_options clearcut_testing)
    include(GoogleTest)
    gtest_discover_tests(${name}_test TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 60)
  endif()
endfunction()
