// The commented job written by `init`.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "options/row.h"
#include "read/job/job_file.h"

namespace clearcut::read {
namespace {

/// Text in quotes, as a basic string of TOML.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string feature_line(const Feature& feature) {
  const Box around = box(feature.target);
  return fmt::format("#   {:<24} {:<14} {} x {} mm, z {} to {}\n", quoted(feature.name),
                     name_of(feature.kind), trimmed(around.width(), 2), trimmed(around.height(), 2),
                     trimmed(feature.top_z, 3), trimmed(feature.floor_z, 3));
}

/// A value as TOML: a number, true, "text", [x, y], ["a", "b"].
std::string toml_of(const Row& row, const Value& value) {
  const auto point = [](Vec2 at) { return fmt::format("[{}, {}]", at.x, at.y); };
  if (const bool* flag = std::get_if<bool>(&value)) return *flag != row.key_is_opposite ? "true" : "false";
  if (const double* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const Vec2* at = std::get_if<Vec2>(&value)) return point(*at);
  std::string items;
  if (const auto* points = std::get_if<std::vector<Vec2>>(&value)) {
    for (const Vec2 at : *points) items += (items.empty() ? "" : ", ") + point(at);
    return "[" + items + "]";
  }
  if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) {
    for (const std::string& text : *texts) items += (items.empty() ? "" : ", ") + quoted(text);
    return "[" + items + "]";
  }
  return quoted(std::get<std::string>(value));
}

/// An example of an unstated value.
std::string example_of(const Row& row) {
  if (row.kind == ValueKind::kFlag) return row.key_is_opposite ? "false" : "true";
  if (row.kind == ValueKind::kPoint) return "[10, 5]";
  if (row.kind == ValueKind::kPoints) return "[[10, 0], [50, 40]]";
  if (takes_several(row.kind)) return fmt::format("[{}]", quoted(row.shown_example()));
  return is_number(row.kind) || row.kind == ValueKind::kSeed ? row.shown_example()
                                                             : quoted(row.shown_example());
}

/// The lines of a table's options: stated ones as keys, the others as comments with an example.
std::string option_lines(JobTable table, const StatedOptions& stated) {
  std::string out;
  for (const Row& row : rows()) {
    if (row.table != table) continue;
    const auto value =
        stated.names.contains(row.name) ? row.field.get(stated.asked, row.names) : std::nullopt;
    out += value ? row.job_key() + " = " + toml_of(row, *value)
                 : fmt::format("# {} = {}", row.job_key(), example_of(row));
    out += "   # " + row.described() + "\n";
  }
  return out;
}

bool states_any(JobTable table, const StatedOptions& stated) {
  return std::any_of(rows().begin(), rows().end(),
                     [&](const Row& row) { return row.table == table && stated.names.contains(row.name); });
}

std::string part_section(const Part& part, const std::string& part_file, const StatedOptions& stated) {
  std::string out = "[part]\nfile = " + quoted(part_file) + "   # beside this job\n" +
                    option_lines(JobTable::kPart, stated) +
                    "# find_arcs = true   # arcs found again in runs of short lines\n# Features found:\n";
  for (const Feature& feature : part.features) out += feature_line(feature);
  return out +
         "\n# [[layer]]                # what the names of layers (or colours like \"#ff0000\") do not say\n"
         "# name = \"POCKET*\"\n# role = \"pocket\"          # pocket, island, hole, ignore\n# depth = 5\n# "
         "top = 0\n";
}

std::string stock_section(const Part& part) {
  if (!part.stock) {
    return "\n# [stock]                  # absent: solid everywhere outside the features\n"
           "# margin = 5               # mm around the features, or x = [0, 100] and y = [0, 60]\n"
           "# z = [-20, 0]             # bottom and top\n";
  }
  const Stock& stock = *part.stock;
  return fmt::format("\n[stock]\nx = [{}, {}]\ny = [{}, {}]\nz = [{}, {}]\n", trimmed(stock.plan.min.x, 6),
                     trimmed(stock.plan.max.x, 6), trimmed(stock.plan.min.y, 6), trimmed(stock.plan.max.y, 6),
                     trimmed(stock.z_bottom, 6), trimmed(stock.z_top, 6));
}

std::string tool_section(const Tool& tool) {
  std::string out =
      fmt::format("\n[[tool]]\nnumber = {}\nname = {}\nkind = \"{}\"\ndiameter = {}\nteeth = {}\n",
                  tool.number, quoted(tool.name), name_of(tool.kind), trimmed(tool.diameter, 6), tool.teeth);
  if (tool.corner_radius > 0 && tool.kind != ToolKind::kBallEndMill) {
    out += fmt::format("corner_radius = {}\n", trimmed(tool.corner_radius, 6));
  }
  if (tool.flute_length) out += fmt::format("flute_length = {}\n", trimmed(*tool.flute_length, 6));
  if (tool.shank_diameter > 0) out += fmt::format("shank_diameter = {}\n", trimmed(tool.shank_diameter, 6));
  if (tool.stickout)
    out += fmt::format("stickout = {}\nholder_diameter = {}\n", trimmed(*tool.stickout, 6),
                       trimmed(tool.holder_diameter, 6));
  if (tool.max_spindle_rpm) out += fmt::format("max_spindle = {}\n", trimmed(*tool.max_spindle_rpm, 3));
  if (tool.high_speed_steel)
    out += fmt::format("material = \"{}\"\n", *tool.high_speed_steel ? "hss" : "carbide");
  if (tool.coated) out += "coated = true\n";
  if (tool.tip_angle && tool.kind == ToolKind::kTapered)
    out += fmt::format("taper_angle = {}\n", trimmed(tool.tip_angle->degrees() / 2, 6));
  else if (tool.tip_angle)
    out += fmt::format("tip_angle = {}\n", trimmed(tool.tip_angle->degrees(), 6));
  if (tool.tip_diameter > 0) out += fmt::format("tip_diameter = {}\n", trimmed(tool.tip_diameter, 6));
  if (!tool.center_cutting) out += "center_cutting = false\n";
  if (tool.pitch > 0) out += fmt::format("pitch = {}\n", trimmed(tool.pitch, 6));
  if (tool.left_hand) out += "left_hand = true\n";
  if (tool.floating) out += "floating = true\n";
  return out;
}

std::string tool_sections(const Part& part, const StatedOptions& stated) {
  std::string out = states_any(JobTable::kTools, stated) ? "\n[tools]\n" : "\n# [tools]\n";
  out += option_lines(JobTable::kTools, stated);
  out +=
      "# use = [1, 2]             # numbers; absent: all\n# preset = \"Aluminium\"     # of the library; "
      "absent: the first\n"
      "# Kinds: endmill, facemill, ball, bullnose, drill, reamer, vbit, chamfer, spotdrill (these with "
      "tip_angle in\n# degrees, tip_diameter), tapered (with taper_angle, degrees of each side), tslot. "
      "Feeds may stand here too: feed, "
      "plunge_feed,\n"
      "# ramp_feed, slot_feed (mm/min), spindle (rpm), coolant, stepdown (mm), stepover (fraction).\n";
  bool any = false;
  for (const Tool& tool : part.tools) {
    if (tool.kind == ToolKind::kOther || states_any(JobTable::kTools, stated)) continue;
    out += tool_section(tool);
    any = true;
  }
  if (any || states_any(JobTable::kTools, stated)) return out;
  return out + "\n[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 6\nteeth = 2\n";
}

const char* const kAfterPlan =
    R"(# sequence = ["*"]         # names of features in the order of work; absent: whatever order is shortest

# [[operation]]            # what differs for some features; the same keys as [plan], and:
# feature = "POCKET*"      # name, * for anything
# tool = 1                 # number
# kind = "finishing"       # an operation of its own after the others; also side_finishing, bottom_finishing
# skip = false             # true: not machined

# [[predrilled]]           # a hole that is there already: entered instead of plunging
# x = 20
# y = 10
# diameter = 8

# [[keep_out]]             # a clamp, where no tool and no holder may come
# x = [0, 20]
# y = [0, 10]
# z = [-5, 25]
)";

const char* const kOfMachine =
    R"(# max_feed = 3000          # mm/min
# max_spindle = 24000      # rpm; min_spindle likewise
# spindle_power = 450      # W, at the cutter; spindle_torque in Nm: for feeds by material
# travel = {x = [0, 300], y = [0, 200], z = [-80, 20]}   # mm
)";

const char* const kFiles = R"(# program = "out.ngc"
# certificate = "out.json"
# svg = "out.svg"
# report = "out.html"
# setup_sheet = "setup.html"  # or setup.pdf
# witness = "out.ccw"     # for clearcut-check, docs/howto-recheck.md
# result = "out.edges"     # the cuts as segments, x y to x y in each line
)";

/// The whole section as comments if nothing in it is stated.
std::string machine_section(const StatedOptions& stated) {
  return std::string(states_any(JobTable::kMachine, stated) ? "\n[machine]\n" : "\n# [machine]\n") +
         option_lines(JobTable::kMachine, stated) + kOfMachine;
}

}  // namespace

std::string job_text(const Part& part, const std::string& part_file, const StatedOptions& stated) {
  return "# A job for clearcut. Lengths in mm, feeds in mm/min, angles in degrees. Lines after # show what "
         "may be said,\n"
         "# with its default or an example.\n\n" +
         part_section(part, part_file, stated) + stock_section(part) + tool_sections(part, stated) +
         "\n[plan]   # for all operations; absent values: the part's file, then the defaults\n" +
         option_lines(JobTable::kPlan, stated) + kAfterPlan + machine_section(stated) + "\n[output]\n" +
         option_lines(JobTable::kOutput, stated) + kFiles;
}

}  // namespace clearcut::read
