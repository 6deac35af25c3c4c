# Every third-party package is asked for here, by name, and nowhere else; docs/dependencies.md says why.
# The Debian packages are listed in scripts/packages.txt.
if(EMSCRIPTEN)
  include(ClearcutWebDependencies)
elseif(WIN32)
  include(ClearcutWindowsDependencies)
else()
  find_package(Boost 1.74 REQUIRED)
  find_package(PkgConfig REQUIRED)
  pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET polyclipping)
  find_package(fmt REQUIRED)
  find_package(CLI11 REQUIRED)
  find_package(nlohmann_json REQUIRED)
  find_package(TBB REQUIRED)
  pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
  find_package(pugixml REQUIRED)
  find_package(OpenSSL 3.0 REQUIRED COMPONENTS Crypto)
  # Optional: without it STEP solids are refused with a message that names the package.
  option(CLEARCUT_STEP_SOLIDS "Read STEP solids, where Open CASCADE is found" ON)
  if(CLEARCUT_STEP_SOLIDS)
    find_package(OpenCASCADE QUIET)
  endif()
  # Optional: without both, letters of drawings are refused with a message that names them.
  option(CLEARCUT_LETTERS "Read fonts, where fontconfig and FreeType are found" ON)
  if(CLEARCUT_LETTERS)
    pkg_check_modules(fonts QUIET IMPORTED_TARGET fontconfig freetype2)
  endif()
  # Optional: without them set-up sheets are HTML alone; PDF is refused with a message that names them.
  option(CLEARCUT_PDF "Write set-up sheets as PDF, where librsvg, pango and cairo are found" ON)
  if(CLEARCUT_PDF)
    pkg_check_modules(paper QUIET IMPORTED_TARGET librsvg-2.0 pangocairo cairo-pdf)
  endif()
  # Optional: without it `clearcut serve` says which package is missing.
  pkg_check_modules(httplib QUIET IMPORTED_TARGET cpp-httplib)
  # Optional: without it `--mpi` says which package is missing.
  option(CLEARCUT_MPI "Work on the processes of an MPI job, where MPI is found" ON)
  if(CLEARCUT_MPI)
    find_package(MPI QUIET COMPONENTS CXX)
  endif()
endif()

# One interface library per role, so that a module never names a package.
add_library(clearcut_testing INTERFACE)
if(CLEARCUT_TESTS)
  find_package(GTest REQUIRED)
  target_link_libraries(clearcut_testing INTERFACE GTest::gmock GTest::gtest GTest::gtest_main pugixml::pugixml)
  # Tests do little themselves: a third of the time to compile them would go into optimising them further.
  target_compile_options(clearcut_testing INTERFACE $<$<CONFIG:Release>:-O1> $<$<CONFIG:Debug>:-O0>)
  target_compile_definitions(clearcut_testing INTERFACE
    CLEARCUT_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    CLEARCUT_BINARY_DIR="${PROJECT_BINARY_DIR}")
endif()

function(clearcut_link_packages)
  if(fonts_FOUND)  # their headers for the one source that includes them
    target_link_libraries(clearcut_read PUBLIC ${fonts_LINK_LIBRARIES})
    set_source_files_properties(src/read/lettering/face.cpp src/read/lettering/face_test.cpp PROPERTIES
      INCLUDE_DIRECTORIES "${fonts_INCLUDE_DIRS}")
  endif()
  foreach(pair "base|fmt::fmt" "base|TBB::tbb" "base|OpenSSL::Crypto" "base|nlohmann_json::nlohmann_json" "geometry|PkgConfig::polyclipping" "geometry|Boost::headers"
               "read|nlohmann_json::nlohmann_json" "read|pugixml::pugixml" "read|PkgConfig::tomlplusplus"
                "report|nlohmann_json::nlohmann_json" "pipeline|nlohmann_json::nlohmann_json"
                "studies|nlohmann_json::nlohmann_json")
    string(REPLACE "|" ";" pair "${pair}")
    list(GET pair 0 module)
    list(GET pair 1 package)
    if(NOT TARGET clearcut_${module})
      continue()
    endif()
    get_target_property(kind clearcut_${module} TYPE)
    if(kind STREQUAL "INTERFACE_LIBRARY")
      target_link_libraries(clearcut_${module} INTERFACE ${package})
    else()
      target_link_libraries(clearcut_${module} PUBLIC ${package})
    endif()
  endforeach()
endfunction()
