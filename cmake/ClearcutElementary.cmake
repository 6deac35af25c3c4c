# Elementary functions that are the same on every processor (src/base/elementary.h): musl's, plain C, which Debian's musl-dev
# holds compiled for this machine and which emscripten's C library has as they are. They are taken out of musl's library under
# names of their own, clearcut_musl_sin for sin, so that no other function of it comes along and the C library's stay themselves.
set(CLEARCUT_ELEMENTARY sin cos tan asin acos atan atan2 exp exp2 expm1 log log2 log10 pow)

if(EMSCRIPTEN)
  list(TRANSFORM CLEARCUT_ELEMENTARY REPLACE "(.+)" "clearcut_musl_\\1=\\1" OUTPUT_VARIABLE definitions)
  set_source_files_properties(src/base/elementary.cpp PROPERTIES COMPILE_DEFINITIONS "${definitions}" COMPILE_OPTIONS -fno-builtin
    SKIP_PRECOMPILE_HEADERS ON)
elseif(WIN32)
  # The same sources, compiled for Windows, whose programs call functions otherwise.
  enable_language(C)
  set(musl_files ${CLEARCUT_ELEMENTARY} __sin __cos __tan __rem_pio2 __rem_pio2_large scalbn floor __math_divzero __math_invalid
    __math_oflow __math_uflow __math_xflow exp_data log_data log2_data pow_data round lround llround)
  # mingw-w64's own square root is one of 80 bits, rounded twice, and its round() makes 1 of the number below 0.5: musl's take the
  # place of both, of the second for every caller.
  list(TRANSFORM musl_files REPLACE "(.+)" "${CLEARCUT_MUSL_SOURCES}/\\1.c")
  add_library(clearcut_musl OBJECT ${musl_files} ${CLEARCUT_MUSL_SOURCES}/x86_64/sqrt.c)
  list(TRANSFORM CLEARCUT_ELEMENTARY REPLACE "(.+)" "\\1=clearcut_musl_\\1" OUTPUT_VARIABLE definitions)
  target_compile_definitions(clearcut_musl PRIVATE ${definitions} scalbn=clearcut_musl_scalbn floor=clearcut_musl_floor sqrt=clearcut_musl_sqrt)
  target_include_directories(clearcut_musl PRIVATE cmake/windows/musl ${CLEARCUT_MUSL_SOURCES}/../internal ${CLEARCUT_MUSL_SOURCES}/../../arch/generic)
  target_compile_options(clearcut_musl PRIVATE -std=c99 -O2 -ffp-contract=off -fno-builtin -frounding-math -w "SHELL:-include features.h")
  set(CLEARCUT_ELEMENTARY_OBJECT $<TARGET_OBJECTS:clearcut_musl>)
else()
  # Debian's folder, then those of other distributions.
  find_file(CLEARCUT_MUSL libc.a NO_DEFAULT_PATH PATHS /usr/lib/${CMAKE_SYSTEM_PROCESSOR}-linux-musl /usr/lib/musl/lib
    /usr/${CMAKE_SYSTEM_PROCESSOR}-linux-musl/lib64 /usr/${CMAKE_SYSTEM_PROCESSOR}-linux-musl/lib)
  if(NOT CLEARCUT_MUSL)
    message(FATAL_ERROR "musl's libc.a is missing, of which sine and its kin are taken; install musl-dev (scripts/setup.sh build) or set CLEARCUT_MUSL")
  endif()
  set(CLEARCUT_ELEMENTARY_OBJECT ${PROJECT_BINARY_DIR}/elementary_musl.o)
  list(TRANSFORM CLEARCUT_ELEMENTARY REPLACE "(.+)" "-u;\\1" OUTPUT_VARIABLE wanted)
  list(TRANSFORM CLEARCUT_ELEMENTARY REPLACE "(.+)" "--redefine-sym;\\1=clearcut_musl_\\1;-G;clearcut_musl_\\1;-G;\\1" OUTPUT_VARIABLE names)
  add_custom_command(OUTPUT ${CLEARCUT_ELEMENTARY_OBJECT}
    COMMAND ${CMAKE_CXX_COMPILER} -r -nostdlib ${wanted} -o elementary_all.o ${CLEARCUT_MUSL}
    COMMAND ${CMAKE_OBJCOPY} ${names} elementary_all.o ${CLEARCUT_ELEMENTARY_OBJECT}
    DEPENDS ${CLEARCUT_MUSL} VERBATIM)
  set_source_files_properties(${CLEARCUT_ELEMENTARY_OBJECT} PROPERTIES EXTERNAL_OBJECT TRUE GENERATED TRUE)
endif()
