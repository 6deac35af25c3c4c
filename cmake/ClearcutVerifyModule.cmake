# What the verify module compiles (preset verify-module): the check of programs without planners, as WebAssembly for other programs' pages.
# clearcut_verify_module_sources(): after the modules were added. Functions that nothing calls are left out by the linker; of what is left
# out here nothing is called, so that the linker names whatever a later change needs.
set(CLEARCUT_VERIFY_MODULE_WITHOUT plan order)  # modules of which only headers are included
# Per module: the sources that stay, as regular expressions of their paths.
set(CLEARCUT_VERIFY_MODULE_read "/read/(common|drawing|gcode|outline|repair|tools)/" "/read/job/(machine|read_part)[a-z_]*\\.cpp$")
set(CLEARCUT_VERIFY_MODULE_report "/report/(certificate|words)/" "/report/(result|table)\\.cpp$" "/sheet/sheet_facts\\.cpp$")
set(CLEARCUT_VERIFY_MODULE_pipeline "/pipeline/(check|check_text|copies|program_feeds|result_figures|stated_machine|texts)\\.cpp$"
  "/pipeline/nesting/" "/pipeline/steps/(certify|out_of_reach|program_conditions|section_order)\\.cpp$")
set(CLEARCUT_VERIFY_MODULE_interface "/interface/check_text\\.cpp$")

function(clearcut_verify_module_sources)
  foreach(module read report pipeline interface)
    get_target_property(sources clearcut_${module} SOURCES)
    set(kept "")
    foreach(pattern IN LISTS CLEARCUT_VERIFY_MODULE_${module})
      set(some ${sources})
      list(FILTER some INCLUDE REGEX "${pattern}")
      list(APPEND kept ${some})
    endforeach()
    set_target_properties(clearcut_${module} PROPERTIES SOURCES "${kept}")
  endforeach()
  target_sources(clearcut_pipeline PRIVATE ${PROJECT_SOURCE_DIR}/cmake/web/no_planners.cpp)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/cmake/web/no_planners.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
