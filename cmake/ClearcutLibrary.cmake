# The library clearcut::clearcut: every stage in one archive, its headers, and what find_package and pkg-config need to find it.
# clearcut_add_library(MODULE...): from the modules that were added; after clearcut_link_packages().
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

function(clearcut_add_library)
  set(objects "")
  foreach(module ${ARGN})
    get_target_property(kind clearcut_${module} TYPE)
    if(kind STREQUAL "STATIC_LIBRARY")
      list(APPEND objects $<TARGET_OBJECTS:clearcut_${module}>)
    endif()
  endforeach()
  add_library(clearcut_library STATIC ${objects})
  add_library(clearcut::clearcut ALIAS clearcut_library)
  set_target_properties(clearcut_library PROPERTIES OUTPUT_NAME clearcut EXPORT_NAME clearcut LINKER_LANGUAGE CXX)
  target_compile_features(clearcut_library PUBLIC cxx_std_20)
  # In the tree headers lie where they are written; installed, all of them are below include/clearcut.
  target_include_directories(clearcut_library PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  # What the archive calls. Headers of other packages are not among ours, so users need none of their include folders.
  target_link_libraries(clearcut_library PRIVATE fmt::fmt PkgConfig::polyclipping TBB::tbb pugixml::pugixml
    PkgConfig::tomlplusplus)
endfunction()

function(clearcut_install_library)
  set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/clearcut)
  install(TARGETS clearcut_library EXPORT clearcutTargets COMPONENT development)
  install(EXPORT clearcutTargets NAMESPACE clearcut:: DESTINATION ${package_folder} COMPONENT development)
  configure_package_config_file(cmake/clearcutConfig.cmake.in ${PROJECT_BINARY_DIR}/clearcutConfig.cmake
    INSTALL_DESTINATION ${package_folder})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/clearcutConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/clearcutConfig.cmake ${PROJECT_BINARY_DIR}/clearcutConfigVersion.cmake
    DESTINATION ${package_folder} COMPONENT development)
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(cmake/clearcut.pc.in clearcut.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/clearcut.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
  install(CODE "
    set(roots \"${PROJECT_SOURCE_DIR}/include\")
    set(folders \"${PROJECT_SOURCE_DIR}/include;${PROJECT_SOURCE_DIR}/src;${PROJECT_BINARY_DIR}/generated\")
    set(destination \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}\")
    include(\"${PROJECT_SOURCE_DIR}/cmake/InstallHeaders.cmake\")" COMPONENT development)
endfunction()
