// Fusion's tool library as exported JSON: {"data": [{"type", "unit", "geometry": {"DC", ...},
// "start-values"}]}.
#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/units.h"
#include "read/common/text.h"
#include "read/tools/formats.h"

namespace clearcut::read {
namespace {

std::optional<ToolKind> kind_of_type(const std::string& type) {
  static const std::map<std::string, ToolKind> kinds{{"flat end mill", ToolKind::kEndMill},
                                                     {"ball end mill", ToolKind::kBallEndMill},
                                                     {"bull nose end mill", ToolKind::kBullNoseEndMill},
                                                     {"face mill", ToolKind::kFaceMill},
                                                     {"tapered mill", ToolKind::kTapered},
                                                     {"slot mill", ToolKind::kTSlot},
                                                     {"chamfer mill", ToolKind::kChamferMill},
                                                     {"spot drill", ToolKind::kSpotDrill},
                                                     {"drill", ToolKind::kDrill},
                                                     {"reamer", ToolKind::kReamer},
                                                     {"tap right hand", ToolKind::kTap},
                                                     {"tap left hand", ToolKind::kTap},
                                                     {"thread mill", ToolKind::kThreadMill},
                                                     {"boring bar", ToolKind::kBoringBar},
                                                     {"counter bore", ToolKind::kCounterbore}};
  const auto found = kinds.find(type);
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> number_of(const DataValue* value, const char* key) {
  const DataValue* found = value && value->is_object() ? value->find(key) : nullptr;
  return found && found->is_number() ? std::optional(found->number) : std::nullopt;
}

std::optional<MmPerMin> feed_of(const DataValue& preset, const char* key, double unit) {
  const auto feed = number_of(&preset, key);
  return feed && *feed > 0 ? std::optional(MmPerMin::of(*feed * unit)) : std::nullopt;
}

bool is_true(const DataValue& value, const char* key) {
  const DataValue* found = value.find(key);
  return found && found->kind == DataValue::Kind::kBoolean && found->boolean;
}

/// "tool-coolant". Coolant through the tool is treated as flood; air by itself is no coolant switched by the program.
std::optional<Coolant> coolant_of_preset(const std::string& text, const std::string& place,
                                         Diagnostics& diagnostics) {
  static const std::map<std::string, Coolant> known{{"disabled", Coolant::kOff},
                                                    {"flood", Coolant::kFlood},
                                                    {"mist", Coolant::kMist},
                                                    {"flood and mist", Coolant::kBoth},
                                                    {"tool", Coolant::kFlood},
                                                    {"through tool", Coolant::kFlood},
                                                    {"flood and through tool", Coolant::kFlood}};
  if (text.empty()) return std::nullopt;
  const auto found = known.find(text);
  if (found != known.end()) return found->second;
  diagnostics.warn(place, "coolant '" + printable(text) + "' is unknown here and is left off");
  return Coolant::kOff;
}

CuttingPreset preset_of(const DataValue& value, double unit, double diameter, const std::string& place,
                        Diagnostics& diagnostics) {
  CuttingPreset preset;
  preset.name = text_of(value, "name");
  preset.cutting.feed = feed_of(value, "v_f", unit);
  preset.cutting.plunge_feed = feed_of(value, "v_f_plunge", unit);
  preset.cutting.ramp_feed = feed_of(value, "v_f_ramp", unit);
  const auto rpm = number_of(&value, "n");
  if (rpm && *rpm > 0) preset.cutting.spindle_rpm = rpm;
  preset.cutting.coolant = coolant_of_preset(text_of(value, "tool-coolant"), place, diagnostics);
  const auto stepdown = number_of(&value, "stepdown"), stepover = number_of(&value, "stepover");
  if (stepdown && *stepdown > 0 && is_true(value, "use-stepdown")) preset.stepdown = *stepdown * unit;
  if (stepover && *stepover > 0 && is_true(value, "use-stepover") && diameter > 0) {
    preset.stepover = *stepover * unit / diameter;
  }
  return preset;
}

Tool tool_of(const DataValue& entry, ToolKind kind, double unit) {
  const DataValue* geometry = entry.find("geometry");
  Tool tool;
  tool.kind = kind;
  tool.name = text_of(entry, "description");
  tool.number =
      static_cast<int>(std::clamp(number_of(entry.find("post-process"), "number").value_or(0), 0.0, 1e6));
  tool.diameter = unit * number_of(geometry, "DC").value_or(0);
  if (const std::string edges = text_of(entry, "BMC"); edges == "hss" || edges == "carbide")
    tool.high_speed_steel = edges == "hss";
  tool.teeth = static_cast<int>(std::clamp(number_of(geometry, "NOF").value_or(2), 1.0, 100.0));
  if (const auto length = number_of(geometry, "LCF"); length && *length > 0)
    tool.flute_length = unit * *length;
  tool.corner_radius = unit * number_of(geometry, "RE").value_or(0);
  if (kind == ToolKind::kTap || kind == ToolKind::kThreadMill)
    tool.pitch = unit * std::max(0.0, number_of(geometry, "TP").value_or(0));
  tool.left_hand = kind == ToolKind::kTap && text_of(entry, "type") == "tap left hand";
  if (kind == ToolKind::kBallEndMill) tool.corner_radius = tool.diameter / 2;
  tool.corner_radius = std::clamp(tool.corner_radius, 0.0, std::max(tool.diameter / 2, 0.0));
  return tool;
}

/// The taper of one side, given by libraries in degrees or, since no cutter tapers by less than half a degree, in
/// radians.
std::optional<Radians> taper_of(const DataValue& entry) {
  constexpr double kLeastDegrees = 0.5, kMostDegrees = 85;
  const auto angle = number_of(entry.find("geometry"), "TA");
  if (!angle || !(*angle > 0) || *angle > kMostDegrees) return std::nullopt;
  return *angle < kLeastDegrees ? Radians::of(*angle) : Radians::of_degrees(*angle);
}

/// A chamfer mill by the angle of one side, a spot drill by the angle of its point.
std::string complete_cone(const DataValue& entry, double unit, Tool& tool) {
  const DataValue* geometry = entry.find("geometry");
  if (tool.kind == ToolKind::kChamferMill) {
    const auto side = taper_of(entry);
    if (!side) return "it states no angle of its flanks (TA)";
    tool.tip_angle = Radians::of(2 * side->radians());
    tool.tip_diameter = unit * std::max(0.0, number_of(geometry, "tip-diameter").value_or(0));
  } else {
    const auto point = number_of(geometry, "SIG");
    if (!point || !(*point >= kSharpestCone) || *point > kBluntestCone)
      return "it states no angle of its point (SIG)";
    tool.tip_angle = Radians::of_degrees(*point);
  }
  tool.corner_radius = 0;
  return tool.tip_diameter < tool.diameter ? "" : "its tip is as wide as the tool";
}

/// Reads the further data needed by its kind. Returns the missing one, "" if there is none.
std::string complete_shape(const DataValue& entry, double unit, Tool& tool) {
  if (tool.kind == ToolKind::kChamferMill || tool.kind == ToolKind::kSpotDrill)
    return complete_cone(entry, unit, tool);
  if (tool.kind == ToolKind::kTap && !(tool.pitch > 0)) return "it states no pitch";
  if (tool.kind == ToolKind::kTapered) {
    const auto taper = taper_of(entry);
    if (!taper || taper->degrees() > kMostTaper || !tool.flute_length)
      return "it states no taper (TA) up to 45 degrees or no length of flutes (LCF)";
    if (tool.corner_radius > 0)
      return "its tip is rounded, and tapered end mills are read with flat tips alone";
    tool.tip_angle = Radians::of(2 * taper->radians());
  }
  if (tool.kind == ToolKind::kTSlot) {
    tool.shank_diameter = unit * number_of(entry.find("geometry"), "shoulder-diameter").value_or(0);
    if (!tool.flute_length || !(tool.shank_diameter > 0) || tool.shank_diameter >= tool.diameter)
      return "it states no neck (shoulder-diameter) narrower than its disc";
  }
  return "";
}

/// A holder is its first segment, at its widest; a tool projects from it by the length of its body.
void read_holder(const DataValue& entry, double unit, Tool& tool) {
  const DataValue* geometry = entry.find("geometry");
  if (tool.flute_length) tool.shank_diameter = unit * std::max(0.0, number_of(geometry, "SFDM").value_or(0));
  const DataValue* holder = entry.find("holder");
  const DataValue* segments = holder && holder->is_object() ? holder->find("segments") : nullptr;
  const double body = number_of(geometry, "LB").value_or(0);
  if (!segments || !segments->is_array() || segments->items.empty() || !(body > 0)) return;
  const DataValue* first = &segments->items.front();
  const double widest = std::max(number_of(first, "lower-diameter").value_or(0),
                                 number_of(first, "upper-diameter").value_or(0));
  if (!(widest > 0)) return;
  tool.stickout = unit * body;
  tool.holder_diameter = unit * widest;
}

void append_presets(const DataValue& entry, double unit, const std::string& place, LibraryTool& tool,
                    Diagnostics& diagnostics) {
  const DataValue* start = entry.find("start-values");
  const DataValue* presets = start && start->is_object() ? start->find("presets") : nullptr;
  if (!presets) return;
  for (const DataValue& preset : presets->items) {
    if (preset.is_object())
      tool.presets.push_back(preset_of(preset, unit, tool.tool.diameter, place, diagnostics));
  }
}

}  // namespace

ToolLibrary read_fusion_library(std::string_view text, const std::string& file_name) {
  const DataValue root = parse_json(text, file_name);
  const DataValue* data = root.is_object() ? root.find("data") : nullptr;
  if (!data || !data->is_array()) {
    throw InputError(file_name + ":1",
                     "this is not a Fusion tool library: no list \"data\"; export it as JSON");
  }
  ToolLibrary library;
  for (const DataValue& entry : data->items) {
    const std::string place = file_name + ":" + std::to_string(entry.line);
    const std::string type = text_of(entry, "type"), unit_name = text_of(entry, "unit");
    if (type == "holder") continue;
    const auto kind = kind_of_type(type);
    if (!kind) {
      library.diagnostics.skip(place, "tool '" + printable(text_of(entry, "description")) + "' of type '" +
                                          printable(type) + "' was dropped: it is no cutter for pockets");
      continue;
    }
    if (unit_name != "inches" && unit_name != "millimeters") {
      library.diagnostics.warn(place, "unit '" + printable(unit_name) + "' is unknown: millimetres assumed");
    }
    const double unit = unit_name == "inches" ? kMmPerInch : 1;
    LibraryTool tool{tool_of(entry, *kind, unit), {}};
    read_holder(entry, unit, tool.tool);
    if (const std::string missing = complete_shape(entry, unit, tool.tool); !missing.empty()) {
      library.diagnostics.skip(place, std::string(name_of(*kind)) + " '" + printable(tool.tool.name) +
                                          "' was dropped: " + missing);
      continue;
    }
    append_presets(entry, unit, place, tool, library.diagnostics);
    library.tools.push_back(std::move(tool));
  }
  return library;
}

}  // namespace clearcut::read
