// The executables of a workplan, in the order in which they are carried out, and what AP238 files hold, for those who
// are told that these are not read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/part.h"
#include "read/part21/part21.h"
#include "read/stepnc/file/node.h"

namespace clearcut::read::stepnc {

bool is_ap238(const P21File& file);

/// The workplans with what they are made of, in order, one line an element: "workplan MAIN (#10)", "  1  workingstep POCKET (#12)".
std::vector<std::string> ap238_lines(const P21File& file);

/// The same of a text; nothing where it is no AP238 file.
std::vector<std::string> ap238_lines(std::string_view text, const std::string& file_name);

/// A machining workingstep in its place.
struct OrderedStep {
  Node node;
  std::vector<ProgramStop> stops;  ///< before it
  std::optional<Node> setup;       ///< set-up of the innermost enclosing workplan that states one
};

struct WorkOrder {
  std::vector<OrderedStep> steps;
  std::vector<Node> workplans;
};

/// Workplans, PARALLEL and NON_SEQUENTIAL in the order written; of a SELECTIVE the first element; of an IF_STATEMENT the branch, where
/// its condition can be told from constants, and of a WHILE_STATEMENT none where it is false. What is inside other branches and loops
/// is not machined: said by the names of its workingsteps, which are a fault of the verdict. Stops and messages go before the step that
/// follows; other executables are named as not followed. Throws InputError for workplans that contain themselves.
WorkOrder work_order(const Node& workplan, Context& context);

}  // namespace clearcut::read::stepnc
