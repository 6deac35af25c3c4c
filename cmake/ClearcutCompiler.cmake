# Warnings are errors; sanitizers and the compiler cache are switched here and nowhere else.
add_library(clearcut_compile INTERFACE)
target_compile_options(clearcut_compile INTERFACE
  -Wall -Wextra -Wpedantic -Werror -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-align
  -Woverloaded-virtual -Wnull-dereference -Wdouble-promotion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 reports false dangling, overflow and null findings inside optimised standard containers.
  target_compile_options(clearcut_compile INTERFACE -Wno-null-dereference -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread
    -Wno-array-bounds -Wno-maybe-uninitialized)
endif()
# No contraction of a*b+c: the same bytes on every machine.
target_compile_options(clearcut_compile INTERFACE -ffp-contract=off)
# Functions may be inlined although they could be replaced when the library is loaded: nobody replaces ours, and position
# independent code then costs nothing in planning time.
if(NOT EMSCRIPTEN)
  target_compile_options(clearcut_compile INTERFACE -fno-semantic-interposition)
endif()
# No path of the build in what is built: the same bytes from any folder.
target_compile_options(clearcut_compile INTERFACE -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)

if(CLEARCUT_SANITIZE)
  target_compile_options(clearcut_compile INTERFACE -fsanitize=${CLEARCUT_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  if(CLEARCUT_NO_SANITIZE)
    target_compile_options(clearcut_compile INTERFACE -fno-sanitize=${CLEARCUT_NO_SANITIZE})
  endif()
  target_link_options(clearcut_compile INTERFACE -fsanitize=${CLEARCUT_SANITIZE})
endif()

# The standard headers that nearly every source includes and fmt, parsed once, and the sources of a folder compiled as
# one: a build from nothing takes less than half of the time. Off by default, so that a change compiles one source, a
# source that forgets an include does not compile where the work is done, and clang-tidy is given no header of g++'s.
# Names in the unnamed namespaces of one folder therefore differ.
option(CLEARCUT_PRECOMPILED_HEADERS "Parse common headers once" OFF)

find_program(CLEARCUT_CCACHE ccache)
if(CLEARCUT_CCACHE AND NOT EMSCRIPTEN)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CLEARCUT_CCACHE})
  if(CLEARCUT_PRECOMPILED_HEADERS)
    # What the cache needs to know a precompiled header again (ccache's manual, "Precompiled headers").
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CLEARCUT_CCACHE})
    target_compile_options(clearcut_compile INTERFACE -fpch-preprocess)
  endif()
endif()
