# docs/certificate.schema.json becomes a text in the program.
set(schema_file ${PROJECT_SOURCE_DIR}/docs/certificate.schema.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${schema_file})
file(READ ${schema_file} certificate_schema_text)
configure_file(${PROJECT_SOURCE_DIR}/src/report/certificate/certificate_schema.cpp.in
  ${PROJECT_BINARY_DIR}/generated/report/certificate_schema.cpp @ONLY)
target_sources(clearcut_report PRIVATE ${PROJECT_BINARY_DIR}/generated/report/certificate_schema.cpp)
