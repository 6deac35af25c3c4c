#include "read/tools/tool_library.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "model/tool.h"
#include "read/common/text.h"
#include "read/drawing/drawing.h"
#include "read/tools/formats.h"

namespace clearcut::read {
namespace {

constexpr std::size_t kLargestLibrary = std::size_t{64} << 20;
/// mm. No cutter is wider.
constexpr double kWidest = 1000;

const std::vector<std::string>& kind_names() {
  static const std::vector<std::string> names{"endmill",    "facemill",  "ball",        "bullnose",  "drill",
                                              "reamer",     "vbit",      "chamfer",     "spotdrill", "tap",
                                              "threadmill", "boringbar", "counterbore", "tapered",   "tslot"};
  return names;
}

std::optional<MmPerMin> feed_of(DataSection& section, const std::string& key) {
  const auto value = section.positive(key);
  return value ? std::optional(MmPerMin::of(*value)) : std::nullopt;
}

/// The feeds and speeds of a [[tool]], as one preset when there are any.
std::vector<CuttingPreset> presets_of(DataSection& section) {
  CuttingPreset preset;
  preset.name = "library";
  preset.cutting.feed = feed_of(section, "feed");
  preset.cutting.plunge_feed = feed_of(section, "plunge_feed");
  preset.cutting.ramp_feed = feed_of(section, "ramp_feed");
  preset.cutting.slot_feed = feed_of(section, "slot_feed");
  preset.cutting.spindle_rpm = section.positive("spindle");
  preset.cutting.spindle_clockwise = !section.flag("counter_clockwise").value_or(false);
  preset.cutting.coolant = coolant_in(section);
  preset.stepdown = section.positive("stepdown");
  preset.stepover = section.positive("stepover");
  const CuttingData& cutting = preset.cutting;
  const bool any = cutting.feed || cutting.plunge_feed || cutting.ramp_feed || cutting.slot_feed ||
                   cutting.spindle_rpm || !cutting.spindle_clockwise || cutting.coolant || preset.stepdown ||
                   preset.stepover;
  return any ? std::vector{preset} : std::vector<CuttingPreset>{};
}

/// tip_angle in degrees and tip_diameter, of tools with a conical end.
void read_cone(DataSection& section, Tool& tool) {
  const auto angle = section.positive("tip_angle");
  const auto tip = section.not_negative("tip_diameter");
  const bool cone = row_of(tool.kind).use == ToolUse::kEdges;
  const bool drill = tool.kind == ToolKind::kDrill && !tip;
  if (!cone && !drill && (angle || tip))
    section.fail_at(angle ? "tip_angle" : "tip_diameter", "is not of this kind of tool");
  if (!cone && !angle) return;
  if (!angle) section.fail("tip_angle is missing; add tip_angle = 60 (degrees between the flanks)");
  if (*angle < kSharpestCone || *angle > kBluntestCone)
    section.fail_at("tip_angle", "must lie between 5 and 170 degrees");
  tool.tip_angle = Radians::of_degrees(*angle);
  tool.tip_diameter = tip.value_or(0);
  if (tool.tip_diameter >= tool.diameter) section.fail_at("tip_diameter", "is not less than the diameter");
}

/// Tapered end mills: taper_angle, degrees of each side, from the flat tip up along the flutes. T-slot cutters: a
/// disc on its neck.
void read_shape(DataSection& section, Tool& tool) {
  const auto taper = section.positive("taper_angle");
  if (taper && tool.kind != ToolKind::kTapered) section.fail_at("taper_angle", "is not of this kind of tool");
  if (tool.kind == ToolKind::kTapered) {
    if (!taper || !tool.flute_length)
      section.fail("a tapered end mill needs taper_angle = 5 (degrees of each side) and flute_length");
    if (*taper < kLeastTaper || *taper > kMostTaper)
      section.fail_at("taper_angle", "must lie between 0.1 and 45 degrees");
    if (tool.corner_radius > 0)
      section.fail_at("corner_radius", "is not of tapered end mills: their tips are flat");
    tool.tip_angle = Radians::of_degrees(2 * *taper);
  }
  const bool has_neck = tool.shank_diameter > 0 && tool.shank_diameter < tool.diameter && tool.flute_length;
  if (tool.kind == ToolKind::kTSlot && !has_neck)
    section.fail(
        "a T-slot cutter needs flute_length, the height of its disc, and a narrower shank_diameter, its "
        "neck");
}

/// Taps: thread = "M6", or pitch in mm. Thread mills with many rows of teeth: pitch and flute_length.
void read_thread(DataSection& section, Tool& tool, const std::optional<Thread>& thread) {
  const auto pitch = section.positive("pitch");
  const auto floating = section.flag("floating"), left = section.flag("left_hand");
  const bool tap = tool.kind == ToolKind::kTap, mill = tool.kind == ToolKind::kThreadMill;
  if (pitch && !tap && !mill) section.fail_at("pitch", "is not of this kind of tool");
  if ((floating || left) && !tap)
    section.fail_at(floating ? "floating" : "left_hand", "is not of this kind of tool");
  tool.pitch = thread ? thread->pitch : pitch.value_or(0);
  tool.left_hand = (thread && thread->left_hand) || left.value_or(false);
  tool.floating = floating.value_or(false);
  if (thread && tool.name.empty()) tool.name = thread->name;
  if (tap && !(tool.pitch > 0)) section.fail("thread is missing; add thread = \"M6\", or diameter and pitch");
  if (mill && tool.pitch > 0 && !tool.flute_length)
    section.fail("flute_length is missing: how far its rows of teeth reach");
}

/// Nothing if no thread is stated.
std::optional<Thread> thread_of(DataSection& section, ToolKind kind) {
  const auto text = section.text("thread");
  if (!text) return std::nullopt;
  const auto thread = thread_named(*text);
  if (kind != ToolKind::kTap) section.fail_at("thread", "is not of this kind of tool");
  if (!thread) section.fail_at("thread", "is unknown; write \"M6\", \"M6x0.75\", \"1/4-20\" or \"#10-24\"");
  return thread;
}

/// The holder by its diameter and the tool's projection from it; a shank wider than the cutter begins above the
/// flutes.
void read_holder(DataSection& section, Tool& tool) {
  tool.stickout = section.positive("stickout");
  tool.holder_diameter = section.positive("holder_diameter").value_or(0);
  tool.shank_diameter = section.positive("shank_diameter").value_or(0);
  if (tool.stickout.has_value() != (tool.holder_diameter > 0))
    section.fail("a holder needs both stickout and holder_diameter, mm");
  if (tool.shank_diameter > tool.diameter && !tool.flute_length)
    section.fail("a shank wider than the cutter needs flute_length, mm: where it begins");
}

/// Material of the edges.
void read_edges(DataSection& section, Tool& tool) {
  const std::vector<std::string> materials{"carbide", "hss"};
  if (const auto material = section.choice("material", materials)) tool.high_speed_steel = *material == 1;
  tool.coated = section.flag("coated").value_or(false);
}

/// Name of a tool in messages; `place` in the file, from 0.
std::string called(const Tool& tool, std::size_t place) {
  if (!tool.name.empty()) return "tool '" + printable(tool.name) + "'";
  if (tool.number > 0) return "tool T" + std::to_string(tool.number);
  return "tool " + std::to_string(place + 1) + " of the list";
}

}  // namespace

std::optional<Coolant> coolant_in(DataSection& section) {
  if (!section.has("coolant")) return std::nullopt;
  if (section.is_flag("coolant")) return *section.flag("coolant") ? Coolant::kFlood : Coolant::kOff;
  return coolant_named(coolant_names()[*section.choice("coolant", coolant_names())]);
}

std::string text_of(const DataValue& object, const char* key) {
  const DataValue* value = object.is_object() ? object.find(key) : nullptr;
  return value && value->is_string() ? value->text : "";
}

LibraryTool tool_of_section(DataSection section) {
  LibraryTool out;
  const auto kind = section.choice("kind", kind_names());
  out.tool.kind = *tool_kind_named(kind_names()[kind.value_or(0)]);
  const auto thread = thread_of(section, out.tool.kind);
  auto diameter = section.positive("diameter");
  if (!diameter && thread) diameter = thread->diameter;
  if (!diameter) section.fail("diameter is missing; add diameter = 6");
  out.tool.diameter = *diameter;
  out.tool.number = static_cast<int>(std::clamp(section.number("number").value_or(0), 0.0, 1e6));
  out.tool.name = section.text("name").value_or("");
  out.tool.corner_radius = section.not_negative("corner_radius").value_or(0);
  if (out.tool.kind == ToolKind::kBallEndMill) out.tool.corner_radius = *diameter / 2;
  if (out.tool.corner_radius > *diameter / 2)
    section.fail_at("corner_radius", "is larger than the tool's radius");
  read_cone(section, out.tool);
  out.tool.teeth = static_cast<int>(std::clamp(section.positive("teeth").value_or(2), 1.0, 100.0));
  out.tool.flute_length = section.positive("flute_length");
  read_holder(section, out.tool);
  read_shape(section, out.tool);
  out.tool.max_spindle_rpm = section.positive("max_spindle");
  read_thread(section, out.tool, thread);
  read_edges(section, out.tool);
  out.tool.center_cutting = section.flag("center_cutting").value_or(true);
  out.presets = presets_of(section);
  section.refuse_unknown();
  return out;
}

const CuttingPreset* preset_of(const LibraryTool& tool, const std::string& name) {
  for (const CuttingPreset& preset : tool.presets) {
    if (name.empty() || matches(name, preset.name)) return &preset;
  }
  return nullptr;
}

void settle(ToolLibrary& library, const std::string& where) {
  std::set<int> taken;
  std::vector<LibraryTool> kept;
  int highest = 0;
  for (const LibraryTool& entry : library.tools) highest = std::max(highest, entry.tool.number);
  for (std::size_t i = 0; i < library.tools.size(); ++i) {
    LibraryTool& entry = library.tools[i];
    Tool& tool = entry.tool;
    const std::string name = called(tool, i);
    if (!(tool.diameter > 0) || tool.diameter > kWidest) {
      library.diagnostics.skip(where, name + " has no usable diameter and was dropped");
      continue;
    }
    if (tool.number <= 0 || !taken.insert(tool.number).second) {
      const int number = ++highest;
      library.diagnostics.note(where, name + " got the number " + std::to_string(number) +
                                          (tool.number > 0 ? ": its own is taken" : ": it had none"));
      tool.number = number;
      taken.insert(number);
    }
    if (tool.name.empty()) tool.name = "T" + std::to_string(tool.number);
    kept.push_back(std::move(entry));
  }
  library.tools = std::move(kept);
}

ToolLibrary read_tool_library_text(std::string_view text, const std::string& file_name,
                                   const ToolOptions& options) {
  const std::string extension = capitals(std::filesystem::path(file_name).extension().string());
  ToolLibrary library;
  if (extension == ".FCTB") {
    if (const auto tool = read_freecad_bit(text, file_name, library.diagnostics))
      library.tools.push_back(*tool);
  } else if (extension == ".FCTL") {
    library = read_freecad_library(text, file_name);
  } else if (extension == ".TBL") {
    library = read_linuxcnc_table(text, file_name, options);
  } else if (extension == ".JSON") {
    library = read_fusion_library(text, file_name);
  } else if (extension == ".TOML") {
    library = read_own_library(text, file_name);
  } else {
    throw InputError(file_name,
                     "unknown kind of tool library; give .toml, .fctl, .fctb, .tbl or Fusion's .json");
  }
  settle(library, file_name);
  if (library.tools.empty()) {
    const auto& said = library.diagnostics.items();
    throw InputError(file_name,
                     "no usable tool in it" + (said.empty() ? "" : " (" + said.front().what + ")"));
  }
  return library;
}

ToolLibrary read_tool_library(const std::filesystem::path& file, const ToolOptions& options) {
  return read_tool_library_text(read_file(file.string(), kLargestLibrary), file.string(), options);
}

ToolLibrary read_own_library(std::string_view text, const std::string& file_name) {
  const DataValue root = parse_toml(text, file_name);
  DataSection section(root, file_name, "");
  ToolLibrary library;
  for (DataSection& tool : section.sections("tool"))
    library.tools.push_back(tool_of_section(std::move(tool)));
  section.refuse_unknown();
  return library;
}

}  // namespace clearcut::read
