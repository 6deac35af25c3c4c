# The library clearcut::clearcut: every stage in one archive, its headers, and what find_package and pkg-config need to find it.
# With CLEARCUT_SHARED_LIBRARY the same objects are a shared library as well, clearcut::shared.
# clearcut_add_library(MODULE...): from the modules that were added; after clearcut_link_packages().
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

option(CLEARCUT_SHARED_LIBRARY "Build libclearcut.so beside the archive" OFF)

function(clearcut_add_library)
  set(objects ${CLEARCUT_ELEMENTARY_OBJECT})
  foreach(module ${ARGN})
    get_target_property(kind clearcut_${module} TYPE)
    if(kind STREQUAL "STATIC_LIBRARY")
      list(APPEND objects $<TARGET_OBJECTS:clearcut_${module}>)
    endif()
  endforeach()
  add_library(clearcut_library STATIC ${objects})
  clearcut_describe_library(clearcut_library clearcut)
  if(CLEARCUT_SHARED_LIBRARY)
    add_library(clearcut_shared SHARED ${objects})
    clearcut_describe_library(clearcut_shared shared)
    # Versions that differ in the last number alone can take each other's place.
    set_target_properties(clearcut_shared PROPERTIES VERSION ${PROJECT_VERSION}
      SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    target_link_options(clearcut_shared PRIVATE -Wl,-Bsymbolic-functions -Wl,--no-undefined)
  endif()
endfunction()

# What both kinds have in common; `name` is theirs in the namespace clearcut::.
function(clearcut_describe_library target name)
  add_library(clearcut::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME clearcut EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # In the tree headers lie where they are written; installed, all of them are below include/clearcut.
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  # What the library calls. Headers of other packages are not among ours, so users need none of their include folders.
  target_link_libraries(${target} PRIVATE fmt::fmt OpenSSL::Crypto PkgConfig::polyclipping TBB::tbb pugixml::pugixml
    PkgConfig::tomlplusplus)
  if(fonts_FOUND)
    target_link_libraries(${target} PRIVATE PkgConfig::fonts)
  endif()
endfunction()

function(clearcut_install_library)
  set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/clearcut)
  install(TARGETS clearcut_library EXPORT clearcutTargets COMPONENT development)
  if(CLEARCUT_SHARED_LIBRARY)
    install(TARGETS clearcut_shared EXPORT clearcutTargets
      LIBRARY COMPONENT library NAMELINK_COMPONENT development)
  endif()
  install(EXPORT clearcutTargets NAMESPACE clearcut:: DESTINATION ${package_folder} COMPONENT development)
  set(fonts_read "${fonts_FOUND}")
  configure_package_config_file(cmake/clearcutConfig.cmake.in ${PROJECT_BINARY_DIR}/clearcutConfig.cmake
    INSTALL_DESTINATION ${package_folder})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/clearcutConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/clearcutConfig.cmake ${PROJECT_BINARY_DIR}/clearcutConfigVersion.cmake
    DESTINATION ${package_folder} COMPONENT development)
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  set(fonts_required "")
  if(fonts_FOUND)
    set(fonts_required " fontconfig freetype2")
  endif()
  configure_file(cmake/clearcut.pc.in clearcut.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/clearcut.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
  install(CODE "
    set(roots \"${PROJECT_SOURCE_DIR}/include\")
    set(values base geometry model options order)
    set(folders \"${PROJECT_SOURCE_DIR}/include;${PROJECT_SOURCE_DIR}/src;${PROJECT_BINARY_DIR}/generated\")
    set(destination \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")
    include(\"${PROJECT_SOURCE_DIR}/cmake/InstallHeaders.cmake\")" COMPONENT development)
endfunction()
