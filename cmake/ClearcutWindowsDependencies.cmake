# The packages of ClearcutDependencies.cmake for the preset windows: headers by a folder of links into /usr/include, compiled
# libraries from Debian's sources (scripts/sources.sh), stand-ins in cmake/windows. Everything is linked into the programs.
set(windows_sources ${PROJECT_SOURCE_DIR}/build/windows-sources)
set(windows_include ${PROJECT_BINARY_DIR}/include)
set(CLEARCUT_WINDOWS_FOLDER ${PROJECT_SOURCE_DIR}/cmake/windows)
include(ClearcutDebianSources)

clearcut_debian_source(clipper ${windows_sources} libpolyclipping-*/cpp/clipper.cpp)
clearcut_debian_source(pugixml ${windows_sources} pugixml-*/src/pugixml.cpp)
clearcut_debian_source(fmt_source ${windows_sources} fmtlib-*/src/format.cc)
clearcut_debian_source(httplib_header ${windows_sources} cpp-httplib-*/httplib.h)
clearcut_debian_source(tbb_folder ${windows_sources} onetbb-*/src/tbb)
clearcut_debian_source(CLEARCUT_MUSL_SOURCES ${windows_sources} musl-*/src/math)
clearcut_debian_headers(${windows_include} boost fmt nlohmann toml++ CLI polyclipping pugixml.hpp pugiconfig.hpp)
file(CREATE_LINK ${httplib_header} ${windows_include}/httplib.h SYMBOLIC)
cmake_path(SET tbb_include NORMALIZE ${tbb_folder}/../../include)

# g++ 12 takes texts for names of files as Latin letters; here they are UTF-8, as it writes them.
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=include/c++/bits/fs_path.h OUTPUT_VARIABLE fs_path OUTPUT_STRIP_TRAILING_WHITESPACE)
file(READ ${fs_path} text)
string(REPLACE "struct _UCvt : std::codecvt<wchar_t, char, std::mbstate_t>" "struct _UCvt : std::codecvt_utf8_utf16<wchar_t>" changed "${text}")
if(changed STREQUAL text)
  message(FATAL_ERROR "${fs_path} no longer converts names as g++ 12 does; see whether it takes UTF-8 now")
endif()
file(CONFIGURE OUTPUT ${windows_include}/bits/fs_path.h CONTENT "${changed}" @ONLY)

# Before every other folder, so that these headers are found first.
include_directories(BEFORE SYSTEM ${CLEARCUT_WINDOWS_FOLDER}/include ${windows_include} ${tbb_include})
add_compile_definitions(WIN32_LEAN_AND_MEAN NOMINMAX _WIN32_WINNT=0x0A00 __USE_MINGW_ANSI_STDIO=1)

file(GLOB tbb_sources ${tbb_folder}/*.cpp)
add_library(clearcut_windows_tbb STATIC ${tbb_sources})
target_compile_options(clearcut_windows_tbb PRIVATE -std=gnu++17 -mrtm -mwaitpkg -w)
target_compile_definitions(clearcut_windows_tbb PRIVATE __TBB_BUILD=1 __TBB_DYNAMIC_LOAD_ENABLED=0 __TBB_SOURCE_DIRECTLY_INCLUDED=1)
add_library(clearcut_windows_packages STATIC ${clipper} ${pugixml} ${fmt_source} ${CLEARCUT_WINDOWS_FOLDER}/sha256.cpp)
target_compile_options(clearcut_windows_packages PRIVATE -ffp-contract=off -w)
target_link_libraries(clearcut_windows_packages PUBLIC clearcut_windows_tbb bcrypt)
add_library(clearcut_windows_httplib INTERFACE)
target_link_libraries(clearcut_windows_httplib INTERFACE ws2_32)
set(httplib_FOUND TRUE)

foreach(name Boost::headers nlohmann_json::nlohmann_json PkgConfig::tomlplusplus CLI11::CLI11 fmt::fmt TBB::tbb pugixml::pugixml
             PkgConfig::polyclipping OpenSSL::Crypto)
  add_library(${name} ALIAS clearcut_windows_packages)
endforeach()
add_library(PkgConfig::httplib ALIAS clearcut_windows_httplib)

# Nothing but Windows is needed where a program runs; the stack is as large as on Linux; the same sources give the same bytes.
add_link_options(-static -s -Wl,--stack,8388608 -Wl,--no-insert-timestamp)
enable_language(RC)
set(CLEARCUT_PROGRAM_SOURCES ${CLEARCUT_WINDOWS_FOLDER}/program.cpp ${CLEARCUT_WINDOWS_FOLDER}/program.rc)
