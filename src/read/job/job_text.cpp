// The commented job that `init` writes.
#include <fmt/format.h>

#include "base/text/format.h"
#include "read/job/job_file.h"

namespace clearcut::read {
namespace {

/// Text in quotes, as TOML's basic strings want it.
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

/// What was said of a solid; the rest stays as the file has it.
std::string solid_lines(const SolidOptions& solid) {
  std::string out;
  if (!solid.up.empty()) out += "up = " + quoted(solid.up) + "\n";
  if (solid.turn_deg != 0) out += "turn = " + trimmed(solid.turn_deg, 6) + "\n";
  if (!solid.body.empty()) out += "body = " + quoted(solid.body) + "\n";
  if (solid.breakthrough) out += "breakthrough = " + trimmed(*solid.breakthrough, 6) + "\n";
  return out;
}

std::string part_section(const Part& part, const std::string& part_file, const SolidOptions& solid) {
  std::string out =
      "[part]\nfile = " + quoted(part_file) + "   # beside this job\n" + solid_lines(solid) +
      "# unit = \"mm\"              # of a drawing that names none: mm, cm, m, in, px\n"
      "# depth = 5                # mm, of every feature, before what the drawing says\n"
      "# top = 0                  # mm, z of the drawing's plane\n"
      "# layers = [\"POCKET*\"]     # only these layers\n"
      "# scale = 1                # of a drawing\n"
      "# origin = \"corner\"        # the program's zero: corner or centre of the block's top, or [x, y, z]\n"
      "# join_gap = 0.01          # mm, gaps up to this are closed and reported\n"
      "# open_curves = \"refuse\"   # or skip\n"
      "# strokes = \"lines\"        # of an SVG; or areas, as wide as they are drawn\n"
      "# text = \"skip\"            # of a drawing; or outlines, its letters by the machine's fonts\n"
      "# find_arcs = true         # arcs found again in runs of short lines\n";
  out += "# Features found:\n";
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

std::string tool_sections(const Part& part) {
  std::string out =
      "\n# [tools]\n# library = \"tools.toml\"    # or FreeCAD .fctl/.fctb, LinuxCNC .tbl, Fusion .json\n"
      "# use = [1, 2]             # numbers; absent: all\n# preset = \"Aluminium\"     # of the library; "
      "absent: the first\n"
      "# Kinds: endmill, facemill, ball, bullnose, drill, reamer, vbit, chamfer, spotdrill (these with "
      "tip_angle in\n# degrees, tip_diameter), tapered (with taper_angle, degrees of each side), tslot. "
      "Feeds may stand here too: feed, "
      "plunge_feed,\n"
      "# ramp_feed, slot_feed (mm/min), spindle (rpm), coolant, stepdown (mm), stepover (fraction).\n";
  bool any = false;
  for (const Tool& tool : part.tools) {
    if (tool.kind == ToolKind::kOther) continue;
    out += tool_section(tool);
    any = true;
  }
  return any ? out : out + "\n[[tool]]\nnumber = 1\nkind = \"endmill\"\ndiameter = 6\nteeth = 2\n";
}

const char* const kRest = R"(
[plan]                     # for all operations; absent values: the part's file, then the defaults
# strategy = "auto"        # auto, contour, adaptive, lom, rho, second, fixed
# stepover = 0.4           # fraction of the diameter, or "3.5mm", "lom", "rho"
# stepdown = 2             # mm
# allowance = 0            # mm left on walls
# allowance_floor = 0      # mm left on floors
# entry = "helix"          # helix, ramp, zigzag, plunge
# entry_angle = 3          # degrees
# helix_diameter = 5       # mm, widest helix; helix_min: narrowest
# lead = 0                 # mm, radius of the arcs into and out of passes along walls
# lead_angle = 45          # degrees: lines of that length at this angle instead
# lead_overlap = 0         # mm that passes along walls run on over their start
# direction = "climb"      # climb, conventional
# angle = 0                # degrees, of zigzag lines against x; absent: the fastest
# order = "inside-out"     # of contours; or outside-in
# start = [10, 5]          # where contours begin, or adaptive clearing goes down
# feed = 1000              # mm/min; also plunge_feed, ramp_feed, slot_feed
# lead_feed = 1000         # mm/min; link_feed: between passes
# overrun = 0              # mm that open sides are cut beyond their edge
# link_lift = 0            # mm, ways between passes are run this much higher
# slot_angle = 150         # degrees of engagement above which slot_feed rules
# spindle = 12000          # rpm
# coolant = "off"          # flood, mist, both
# scallop = 0.5            # mm, steps that layers may leave on drafted walls
# passage = "shortest"     # of contours: bisector (of a corner; the published methods' own), shortest
# grid = "ours"            # of the strategy tour: ours, published
# solver = "modern"        # of the strategy tour: modern, published (also generations, population, selection, crossover,
                           # mutation, crossover_rate, mutation_rate, most_shared)
# rest = false             # true: all tools given, larger ones first, each on what is left
# after = "before.ngc"     # a program that has run before: only what it left is cut
# finish = "walls"         # walls, floor, all: finishing after everything else
# finish_stock = 0.3       # mm left on walls for it; finish_stock_floor = 0.2
# finish_depths = 1        # in how many depths walls are finished
# tabs = 0                 # that hold what each profile cuts free; tab_width = 4, tab_height = 2
# tab_spacing = 100        # mm from one tab to the next, at most, instead of a number; or tab_at = [[10, 0], [50, 40]]
# tab_shape = "triangular" # risen over without a stop; or square
# skin = 0.3               # mm left under profiles instead
# dogbones = "corner"      # or t-bone: relief in inside corners
# style = "machinist"      # in metals; or fastest: what is chosen where nobody says how
# material = "steel"       # for feeds, speeds and forces: aluminium, brass, steel, alloy-steel, stainless, cast-iron, titanium,
                           # plastic, softwood, hardwood, mdf
# clearance = 10           # z of rapid travel, mm
# engagement = 90          # largest engagement angle, degrees
# objective = "time"       # length, turns, angle, engagement, time
# time = 10                # longest search, s
# seed = 1
# accept = ["g55"]         # conditions of the verdict that hold at the machine, by name

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

# [machine]
# file = "mill.toml"       # the same keys
# rapid = 5000             # mm/min
# acceleration = 500       # mm/s2
# junction_deviation = 0.01  # mm
# max_feed = 3000          # mm/min
# max_spindle = 24000      # rpm; min_spindle likewise
# spindle_power = 800      # W, at the cutter; spindle_torque in Nm: for feeds by material
# kind = "router"          # or "mill": usual speeds and power where none are stated
# travel = {x = [0, 300], y = [0, 200], z = [-80, 20]}   # mm

[output]
# program = "out.ngc"
# post = "linuxcnc"        # grbl, fanuc, haas, heidenhain, mach3, mach4, marlin
# work_offset = "G54"      # to G59, and what the controller has besides: "G59.1", "G54.1 P12", "G154 P7"
# end_position = "home"    # or [x, y] at the safe height, or "none"; absent: as the controller is used
# inch = false
# decimals = 4             # of coordinates; default: what the controller resolves
# arcs = true              # false: lines only
# tool_change = true       # false: a pause (M0) instead of M6
# length_offset = true     # false: no G43
# exact_stop = false       # G61 instead of blending
# program_number = 100     # O word of Fanuc and Haas programs; later set-ups count on
# block_numbers = false    # N words
# optional_stop = false    # M1 before every tool but the first
# spindle_wait = 2         # s after the spindle starts
# certificate = "out.json"
# svg = "out.svg"
# report = "out.html"
# setup_sheet = "setup.html"  # or setup.pdf
# result = "out.edges"     # the cuts as segments, x y to x y in each line
)";

}  // namespace

std::string job_text(const Part& part, const std::string& part_file, const SolidOptions& solid) {
  return "# A job for clearcut. Lengths in mm, feeds in mm/min, angles in degrees. Lines after # show what "
         "may be said,\n"
         "# with its default or an example.\n\n" +
         part_section(part, part_file, solid) + stock_section(part) + tool_sections(part) + kRest;
}

}  // namespace clearcut::read
