# The files of src/report/viewer become texts in the program: html_page.cpp in the build folder, written anew whenever one
# of them changes. No Node is needed.
set(viewer_folder ${PROJECT_SOURCE_DIR}/src/report/viewer)
set(viewer_template ${PROJECT_SOURCE_DIR}/src/report/viewer/html_page.cpp.in)
set(viewer_source ${PROJECT_BINARY_DIR}/generated/report/html_page.cpp)
file(GLOB viewer_files CONFIGURE_DEPENDS ${viewer_folder}/*.js ${viewer_folder}/space/*.js ${viewer_folder}/*.css ${viewer_folder}/*.html)
add_custom_command(OUTPUT ${viewer_source}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${viewer_folder} -DTEMPLATE=${viewer_template} -DOUTPUT=${viewer_source}
          -DSTYLE=viewer.css -DBODY=body.html -P ${PROJECT_SOURCE_DIR}/cmake/EmbedViewer.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${viewer_source}
  DEPENDS ${viewer_files} ${viewer_folder}/scripts.txt ${viewer_template} ${PROJECT_SOURCE_DIR}/cmake/EmbedViewer.cmake
  COMMENT "Embedding the viewer" VERBATIM)
target_sources(clearcut_report PRIVATE ${viewer_source})
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")  # warns of literals that other compilers need not take
  set_source_files_properties(${viewer_source} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
endif()
