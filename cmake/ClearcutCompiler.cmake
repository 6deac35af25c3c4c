# Warnings are errors; sanitizers and the compiler cache are switched here and nowhere else.
add_library(clearcut_options INTERFACE)
target_compile_options(clearcut_options INTERFACE
  -Wall -Wextra -Wpedantic -Werror -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-align
  -Woverloaded-virtual -Wnull-dereference -Wdouble-promotion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 reports false dangling, overflow and null findings inside optimised standard containers.
  target_compile_options(clearcut_options INTERFACE -Wno-null-dereference -Wno-restrict -Wno-stringop-overflow
    -Wno-array-bounds -Wno-maybe-uninitialized)
endif()
# No contraction of a*b+c: the same bytes on every machine.
target_compile_options(clearcut_options INTERFACE -ffp-contract=off)

if(CLEARCUT_SANITIZE)
  target_compile_options(clearcut_options INTERFACE -fsanitize=${CLEARCUT_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  target_link_options(clearcut_options INTERFACE -fsanitize=${CLEARCUT_SANITIZE})
endif()

find_program(CLEARCUT_CCACHE ccache)
if(CLEARCUT_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CLEARCUT_CCACHE})
endif()
