# The packages of ClearcutDependencies.cmake for the preset web (WebAssembly by emscripten): headers by a folder of links into
# /usr/include, the three compiled libraries from Debian's sources (scripts/sources.sh), stand-ins in cmake/web for TBB,
# OpenSSL's digest and what emscripten's standard library lacks.
set(web_sources ${PROJECT_SOURCE_DIR}/build/web-sources)
set(web_include ${PROJECT_BINARY_DIR}/include)
set(CLEARCUT_WEB_FOLDER ${PROJECT_SOURCE_DIR}/cmake/web)

include(ClearcutDebianSources)
clearcut_debian_source(clipper ${web_sources} libpolyclipping-*/cpp/clipper.cpp)
clearcut_debian_source(pugixml ${web_sources} pugixml-*/src/pugixml.cpp)
clearcut_debian_source(fmt_source ${web_sources} fmtlib-*/src/format.cc)

clearcut_debian_headers(${web_include} boost fmt nlohmann toml++ CLI fast_float polyclipping pugixml.hpp pugiconfig.hpp)
execute_process(COMMAND em-config EMSCRIPTEN_ROOT OUTPUT_VARIABLE emscripten_root OUTPUT_STRIP_TRAILING_WHITESPACE)

# Before every other folder, so that the stand-ins are found first.
include_directories(BEFORE SYSTEM ${CLEARCUT_WEB_FOLDER}/include ${web_include})
add_library(clearcut_web_headers INTERFACE)
foreach(name Boost::headers nlohmann_json::nlohmann_json PkgConfig::tomlplusplus CLI11::CLI11 TBB::tbb)
  add_library(${name} ALIAS clearcut_web_headers)
endforeach()

enable_language(C)
add_library(clearcut_web_packages STATIC ${clipper} ${pugixml} ${fmt_source} ${CLEARCUT_WEB_FOLDER}/sha256.c
  ${CLEARCUT_WEB_FOLDER}/to_chars.cpp)
set_source_files_properties(${CLEARCUT_WEB_FOLDER}/sha256.c PROPERTIES
  COMPILE_OPTIONS "-I${emscripten_root}/system/lib/libc/musl/src/crypt")
target_compile_options(clearcut_web_packages PRIVATE -ffp-contract=off -w)

foreach(name fmt::fmt pugixml::pugixml PkgConfig::polyclipping OpenSSL::Crypto)
  add_library(${name} ALIAS clearcut_web_packages)
endforeach()
# Debian's Node finds the parser that emscripten's linker uses there; another Node has to be told.
set(CMAKE_C_LINKER_LAUNCHER ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs)
set(CMAKE_CXX_LINKER_LAUNCHER ${CMAKE_C_LINKER_LAUNCHER})
# Compiled by emscripten's clang at once, with emscripten's flags: its own script takes as long to start as most sources take to
# compile.
execute_process(COMMAND em-config CLANG_ADD_VERSION OUTPUT_VARIABLE clang_version OUTPUT_STRIP_TRAILING_WHITESPACE)
find_program(CLEARCUT_WEB_CLANG NAMES clang++-${clang_version} REQUIRED)
separate_arguments(web_flags UNIX_COMMAND "${CMAKE_CXX_FLAGS}")
execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${web_flags} --cflags OUTPUT_VARIABLE web_flags OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
set(CMAKE_CXX_COMPILE_OBJECT "${CLEARCUT_WEB_CLANG} ${web_flags} <DEFINES> <INCLUDES> <FLAGS> -o <OBJECT> -c <SOURCE>")
