// FreeCAD's tool bits and libraries: JSON with quantities like "3.1750 mm" or, in some locales, "2,00 mm".
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>

#include "base/error.h"
#include "base/file.h"
#include "read/common/text.h"
#include "read/tools/formats.h"

namespace clearcut::read {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kLargestBit = std::size_t{4} << 20;

/// A number with or without a unit; mm if a unit of length is given.
std::optional<double> quantity(const DataValue* value) {
  if (!value) return std::nullopt;
  if (value->is_number()) return value->number;
  if (!value->is_string()) return std::nullopt;
  std::string text = value->text;
  std::replace(text.begin(), text.end(), ',', '.');
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  std::string unit = text.substr(static_cast<std::size_t>(end - text.data()));
  unit.erase(std::remove(unit.begin(), unit.end(), ' '), unit.end());
  if (unit.empty()) return number;
  if (unit == "\"") unit = "in";
  const auto mm = mm_per_unit(unit);
  return mm ? std::optional(number * *mm) : std::nullopt;
}

/// An angle with or without its sign.
std::optional<double> degrees_of(const DataValue* value) {
  if (!value || value->is_number()) return value ? std::optional(value->number) : std::nullopt;
  std::string text = value->is_string() ? value->text : "";
  std::replace(text.begin(), text.end(), ',', '.');
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} ? std::optional(number) : std::nullopt;
}

/// "endmill.fcstd", "shape-type": "Endmill" -> "ENDMILL".
std::string shape_of(const DataValue& root) {
  for (const char* key : {"shape-type", "shape"}) {
    const DataValue* value = root.find(key);
    if (!value || !value->is_string() || value->text.empty()) continue;
    std::string name = capitals(fs::path(value->text).stem().string());
    std::erase_if(name, [](char c) { return c == '-' || c == '_' || c == ' '; });
    return name;
  }
  return "";
}

std::optional<ToolKind> kind_of_shape(const std::string& shape) {
  static const std::map<std::string, ToolKind> kinds{{"ENDMILL", ToolKind::kEndMill},
                                                     {"BALLEND", ToolKind::kBallEndMill},
                                                     {"BALLENDMILL", ToolKind::kBallEndMill},
                                                     {"BULLNOSE", ToolKind::kBullNoseEndMill},
                                                     {"TORUS", ToolKind::kBullNoseEndMill},
                                                     {"DRILL", ToolKind::kDrill},
                                                     {"REAMER", ToolKind::kReamer},
                                                     {"FACEMILL", ToolKind::kFaceMill},
                                                     {"VBIT", ToolKind::kVBit},
                                                     {"CHAMFER", ToolKind::kChamferMill}};
  const auto found = kinds.find(shape);
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

/// FreeCAD moved some values from "attribute" to "parameter".
const DataValue* value_of(const DataValue& root, const char* key) {
  for (const char* part : {"parameter", "attribute"}) {
    const DataValue* section = root.find(part);
    const DataValue* value = section && section->is_object() ? section->find(key) : nullptr;
    if (value) return value;
  }
  return nullptr;
}

/// Cones, by the angle between their flanks. False if none is stated.
bool read_cone(const DataValue& root, Tool& tool) {
  if (tool.kind != ToolKind::kVBit && tool.kind != ToolKind::kChamferMill) return true;
  const auto angle = degrees_of(value_of(root, "CuttingEdgeAngle"));
  if (!angle || *angle < kSharpestCone || *angle > kBluntestCone) return false;
  tool.tip_angle = Radians::of_degrees(*angle);
  tool.tip_diameter = std::max(0.0, quantity(value_of(root, "TipDiameter")).value_or(0));
  tool.corner_radius = 0;
  return tool.tip_diameter < tool.diameter;
}

Tool tool_of(const DataValue& root, ToolKind kind) {
  Tool tool;
  tool.number = 0;
  tool.kind = kind;
  tool.name = text_of(root, "name");
  tool.diameter = quantity(value_of(root, "Diameter")).value_or(0);
  tool.flute_length = quantity(value_of(root, "CuttingEdgeHeight"));
  if (tool.flute_length)
    tool.shank_diameter = std::max(0.0, quantity(value_of(root, "ShankDiameter")).value_or(0));
  const DataValue* edges = value_of(root, "Material");
  if (edges && edges->is_string() && (edges->text == "HSS" || edges->text == "Carbide"))
    tool.high_speed_steel = edges->text == "HSS";
  const double teeth = quantity(value_of(root, "Flutes")).value_or(2);
  if (teeth >= 1 && teeth <= 100) tool.teeth = static_cast<int>(teeth);
  for (const char* key : {"FlatRadius", "CornerRadius", "TorusRadius"}) {
    if (const auto radius = quantity(value_of(root, key))) tool.corner_radius = *radius;
  }
  if (kind == ToolKind::kBallEndMill) tool.corner_radius = tool.diameter / 2;
  tool.corner_radius = std::clamp(tool.corner_radius, 0.0, tool.diameter / 2);
  return tool;
}

/// Beside the library, in Bit beside it or beside its folder: as FreeCAD stores them.
std::optional<fs::path> find_bit(const fs::path& library, const std::string& name) {
  const fs::path folder = library.parent_path();
  for (const fs::path& place : {folder / name, folder / "Bit" / name, folder / ".." / "Bit" / name}) {
    if (is_file(place)) return place.generic_string();
  }
  return std::nullopt;
}

}  // namespace

std::optional<LibraryTool> read_freecad_bit(std::string_view text, const std::string& file_name,
                                            Diagnostics& diagnostics) {
  const DataValue root = parse_json(text, file_name);
  if (!root.is_object()) throw InputError(file_name + ":1", "this is not a FreeCAD tool bit");
  const std::string shape = shape_of(root);
  const auto kind = kind_of_shape(shape);
  if (!kind) {
    diagnostics.skip(file_name, "tool '" + printable(text_of(root, "name")) + "' of shape '" +
                                    printable(shape) + "' was dropped: it is no cutter for pockets");
    return std::nullopt;
  }
  LibraryTool out;
  out.tool = tool_of(root, *kind);
  if (!read_cone(root, out.tool)) {
    diagnostics.skip(file_name,
                     "tool '" + printable(out.tool.name) +
                         "' was dropped: it states no angle between its flanks, or no tip narrower than it");
    return std::nullopt;
  }
  const DataValue* spindle = value_of(root, "SpindleDirection");
  if (spindle && spindle->text == "Reverse") {
    CuttingPreset preset;
    preset.name = "FreeCAD";
    preset.cutting.spindle_clockwise = false;
    out.presets.push_back(preset);
  }
  for (const char* dropped : {"Chipload", "Length"}) {
    if (value_of(root, dropped)) diagnostics.note(file_name, std::string(dropped) + " is not used");
  }
  return out;
}

ToolLibrary read_freecad_library(std::string_view text, const std::string& file_name) {
  const DataValue root = parse_json(text, file_name);
  const DataValue* tools = root.find("tools");
  if (!tools || !tools->is_array())
    throw InputError(file_name + ":1", "this is not a FreeCAD tool library: no \"tools\"");
  ToolLibrary library;
  for (const DataValue& entry : tools->items) {
    const std::string name = fs::path(text_of(entry, "path")).filename().string();
    const std::string place = file_name + ":" + std::to_string(entry.line);
    const auto bit = name.empty() ? std::nullopt : find_bit(file_name, name);
    if (!bit) {
      library.diagnostics.skip(
          place, "tool bit '" + printable(name) + "' was not found beside the library or in Bit");
      continue;
    }
    auto tool = read_freecad_bit(read_file(bit->string(), kLargestBit), bit->string(), library.diagnostics);
    library.files.push_back(bit->string());
    if (!tool) continue;
    tool->tool.number = static_cast<int>(std::clamp(quantity(entry.find("nr")).value_or(0), 0.0, 1e6));
    library.tools.push_back(std::move(*tool));
  }
  return library;
}

}  // namespace clearcut::read
