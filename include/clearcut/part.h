// What is to be made, Part with its features, tools and operations, and the files that describe it.
#pragma once

#include "clearcut/geometry.h"
#include "model/machine.h"
#include "model/part.h"
#include "model/setup_place.h"
#include "model/tool.h"
#include "post/part/part_writers.h"
#include "post/post.h"
#include "read/drawing/layer_rules.h"
#include "read/job/job_file.h"
#include "read/job/job_setups.h"
#include "read/job/machine_file.h"
#include "read/job/machine_library.h"
#include "read/job/project_file.h"
#include "read/job/read_part.h"
#include "read/stepnc/executables.h"
#include "read/tools/tool_library.h"

namespace clearcut {

// Parts: STEP-NC, STEP solids, DXF, SVG, outlines, jobs.
using read::DrawingOverview;
using read::LayerRole;
using read::LayerRule;
using read::OpenCurves;
using read::OutlineSummary;
using read::read_part;
using read::read_part_of_setup;
using read::read_part_text;
using read::ReadOptions;
using read::rule_named;
using read::rule_of_option;
using read::setups_of_program;
using read::SolidOptions;

// Jobs: a part with its stock, tools, machine and wishes.
using read::CutSettings;
using read::is_project_name;
using read::job_text;
using read::JobFile;
using read::JobOutput;
using read::OperationRule;
using read::parse_zero_point;
using read::part_of_job;
using read::part_of_setup;
using read::ProjectFile;
using read::read_job;
using read::read_job_text;
using read::read_project;
using read::StatedOptions;
using read::tools_of_job;
using read::with_zero_at;
using read::zero_of;
using read::ZeroPoint;
using read::stepnc::ap238_lines;

// Tools and machines.
using read::CuttingPreset;
using read::fill_machine_kind;
using read::library_machine;
using read::LibraryMachine;
using read::LibraryTool;
using read::machine_kinds;
using read::machine_library;
using read::machine_sources;
using read::preset_of;
using read::read_machine;
using read::read_machine_text;
using read::read_tool_library;
using read::read_tool_library_text;
using read::ToolLibrary;
using read::ToolOptions;

// Parts as text again.
using post::write_outline_json;
using post::write_stepnc;

}  // namespace clearcut
