#include "read/outline/read_elements.h"

#include <cmath>

#include "base/files/file.h"
#include "read/common/data_value.h"
#include "read/tools/tool_library.h"

namespace clearcut::read {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 24;
constexpr double kMostNumber = 99999;  // T words

const std::vector<std::string> kKinds{"line", "arc", "rectangle", "hole", "slot"};
const std::vector<std::string> kCorners{"lower-left", "lower-right", "upper-left", "upper-right"};

template <class Value>
Value required(const std::optional<Value>& value, const DataSection& section, const std::string& key) {
  if (!value) section.fail(key + " is missing; add it");
  return *value;
}

Vec2 required_point(DataSection& section, const std::string& key) {
  const auto pair = required(section.pair(key), section, key);
  return {pair[0], pair[1]};
}

double required_number(DataSection& section, const std::string& key) {
  return required(section.number(key), section, key);
}

int whole(DataSection& section, const std::string& key, double value) {
  if (value != std::floor(value) || value < 1 || value > kMostNumber)
    section.fail_at(key, "must be a whole number from 1 to 99999");
  return static_cast<int>(value);
}

Stock stock_of(DataSection section) {
  const auto x = required(section.range("x"), section, "x");
  const auto y = required(section.range("y"), section, "y");
  const auto z = required(section.range("z"), section, "z");
  section.refuse_unknown();
  return {{{x[0], y[0]}, {x[1], y[1]}}, z[0], z[1]};
}

CuttingData cutting_of(DataSection& section, CuttingData base) {
  if (const auto feed = section.positive("feed")) base.feed = MmPerMin::of(*feed);
  if (const auto plunge = section.positive("plunge_feed")) base.plunge_feed = MmPerMin::of(*plunge);
  if (const auto spindle = section.positive("spindle")) base.spindle_rpm = spindle;
  if (const auto coolant = coolant_in(section)) base.coolant = coolant;
  return base;
}

/// A tool with the default cutting data of its elements.
struct ToolEntry {
  Tool tool;
  CuttingData cutting;
};

ToolEntry tool_of(DataSection section, std::size_t place) {
  ToolEntry entry;
  const double number = section.number("number").value_or(static_cast<double>(place + 1));
  entry.tool.number = whole(section, "number", number);
  if (const auto name = section.text("name")) entry.tool.name = *name;
  const std::string kind = section.text("kind").value_or("endmill");
  const auto known = tool_kind_named(kind);
  if (!known)
    section.fail_at("kind", "'" + kind + "' is unknown; use endmill, bullnose, ball, drill or facemill");
  entry.tool.kind = *known;
  entry.tool.diameter = required(section.positive("diameter"), section, "diameter");
  entry.tool.flute_length = section.positive("flute_length");
  entry.tool.max_spindle_rpm = section.positive("max_spindle");
  entry.cutting = cutting_of(section, {});
  section.refuse_unknown();
  return entry;
}

void read_rectangle(DataSection& section, DesignElement& element) {
  element.from = required_point(section, "base");
  element.base = static_cast<Corner>(section.choice("corner", kCorners).value_or(0));
  element.length = required_number(section, "length");
  element.width = required_number(section, "width");
}

void read_arc(DataSection& section, DesignElement& element) {
  element.radius = required_number(section, "radius");
  const auto clockwise = required(section.choice("direction", {"ccw", "cw"}), section, "direction");
  element.direction = clockwise == 1 ? Turn::kClockwise : Turn::kCounterClockwise;
}

void read_shape(DataSection& section, DesignElement& element) {
  if (element.kind == ElementKind::kRectangle) return read_rectangle(section, element);
  if (element.kind == ElementKind::kHole) {
    element.from = element.to = required_point(section, "center");
    element.width = required_number(section, "diameter");
    return;
  }
  element.from = required_point(section, "from");
  element.to = required_point(section, "to");
  if (element.kind == ElementKind::kArc) read_arc(section, element);
  if (element.kind == ElementKind::kSlot) element.width = required_number(section, "width");
}

DesignElement element_of(DataSection section, const std::string& file_name, std::size_t place,
                         const std::vector<ToolEntry>& tools) {
  DesignElement element;
  element.source = file_name + ":" + std::to_string(section.line());
  element.id = section.text("id").value_or("element " + std::to_string(place + 1));
  element.kind = static_cast<ElementKind>(required(section.choice("kind", kKinds), section, "kind"));
  read_shape(section, element);
  element.tool =
      whole(section, "tool", section.number("tool").value_or(tools.empty() ? 1 : tools[0].tool.number));
  element.depth = required_number(section, "depth");
  element.stepdown = section.positive("stepdown");
  CuttingData base;
  for (const auto& entry : tools) {
    if (entry.tool.number == element.tool) base = entry.cutting;
  }
  element.cutting = cutting_of(section, base);
  section.refuse_unknown();
  return element;
}

}  // namespace

ElementJob read_elements_text(std::string_view text, const std::string& file_name) {
  const DataValue root = parse_toml(text, file_name);
  DataSection section(root, file_name, "");
  ElementJob job;
  job.source_file = file_name;
  job.name = section.text("name").value_or(std::filesystem::path(file_name).stem().string());
  job.resolution = section.positive("resolution").value_or(1.0);
  const auto rule = section.choice("middle_row", {"keep", "strict"}).value_or(0);
  job.middle_row = rule == 1 ? MiddleRow::kStrict : MiddleRow::kKeep;
  job.stock = stock_of(required(section.section("stock"), section, "[stock]"));
  std::vector<ToolEntry> tools;
  for (auto& entry : section.sections("tool")) tools.push_back(tool_of(entry, tools.size()));
  for (const auto& entry : tools) job.tools.push_back(entry.tool);
  for (auto& entry : section.sections("element"))
    job.elements.push_back(element_of(entry, file_name, job.elements.size(), tools));
  section.refuse_unknown();
  return job;
}

ElementJob read_elements(const std::filesystem::path& file) {
  return read_elements_text(read_file(file.string(), kLargestFile), file.string());
}

}  // namespace clearcut::read
