#include "read/outline/read_elements.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "read/common/data_value.h"
#include "read/tools/tool_library.h"

namespace clearcut::read {
namespace {

struct Form {
  ElementKind kind;
  std::size_t numbers;
  const char* help;
};

const Form& form_of(const ElementOption& option) {
  static const std::map<std::string, Form> forms{{"line", {ElementKind::kLine, 4, "X1,Y1,X2,Y2"}},
                                                 {"arc", {ElementKind::kArc, 5, "X1,Y1,X2,Y2,RADIUS,cw|ccw"}},
                                                 {"pocket", {ElementKind::kRectangle, 4, "X,Y,LENGTH,WIDTH"}},
                                                 {"hole", {ElementKind::kHole, 3, "X,Y,DIAMETER"}},
                                                 {"slot", {ElementKind::kSlot, 5, "X1,Y1,X2,Y2,WIDTH"}}};
  const auto found = forms.find(option.kind);
  CLEARCUT_ASSERT(found != forms.end());
  return found->second;
}

std::string place_of(const ElementOption& option) {
  return "--" + option.kind + " " + option.text;
}

double number(const std::string& text, const std::string& place) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw InputError(place, "'" + text + "' is no number");
  return value;
}

double positive(const std::string& text, const std::string& place) {
  const double value = number(text, place);
  if (!(value > 0)) throw InputError(place, "'" + text + "' must be above 0");
  return value;
}

Corner corner_named(const std::string& name, const std::string& place) {
  const std::vector<std::string> names{"lower-left", "lower-right", "upper-left", "upper-right"};
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError(place,
                     "'" + name + "' is no corner; use lower-left, lower-right, upper-left or upper-right");
  return static_cast<Corner>(found - names.begin());
}

void apply_word(DesignElement& element, const std::string& word, const std::string& place) {
  const auto equal = word.find('=');
  const std::string key = word.substr(0, equal);
  const std::string value = equal == std::string::npos ? "" : word.substr(equal + 1);
  if (equal == std::string::npos && word.size() > 1 && (word[0] == 'T' || word[0] == 't')) {
    const double tool = number(word.substr(1), place);
    if (tool != std::floor(tool) || tool < 1 || tool > 99999)
      throw InputError(place, "'" + word + "' is no tool; use T1 to T99999");
    element.tool = static_cast<int>(tool);
  } else if (key == "depth") {
    element.depth = number(value, place);
  } else if (key == "stepdown") {
    element.stepdown = positive(value, place);
  } else if (key == "feed") {
    element.cutting.feed = MmPerMin::of(positive(value, place));
  } else if (key == "id" && !value.empty()) {
    element.id = value;
  } else if (key == "corner" && element.kind == ElementKind::kRectangle) {
    element.base = corner_named(value, place);
  } else {
    throw InputError(place, "'" + word +
                                "' has no meaning here; use T2, depth=, stepdown=, feed=, id= or, for "
                                "pockets, corner=");
  }
}

void read_shape(DesignElement& element, const std::vector<std::string>& parts, const Form& form,
                const std::string& place) {
  const std::size_t expected = form.numbers + (form.kind == ElementKind::kArc ? 1 : 0);
  if (parts.size() != expected) throw InputError(place, std::string("needs ") + form.help);
  std::vector<double> n;
  for (std::size_t i = 0; i < form.numbers; ++i) n.push_back(number(parts[i], place));
  element.from = element.to = {n[0], n[1]};
  if (form.kind == ElementKind::kHole) {
    element.width = n[2];
  } else if (form.kind == ElementKind::kRectangle) {
    element.length = n[2];
    element.width = n[3];
  } else {
    element.to = {n[2], n[3]};
  }
  if (form.kind == ElementKind::kSlot) element.width = n[4];
  if (form.kind != ElementKind::kArc) return;
  element.radius = n[4];
  if (parts[5] != "cw" && parts[5] != "ccw") throw InputError(place, "the direction is cw or ccw");
  element.direction = parts[5] == "cw" ? Turn::kClockwise : Turn::kCounterClockwise;
}

DesignElement element_of(const ElementOption& option, const ElementDefaults& defaults, int first_tool,
                         std::size_t place_in_job) {
  const std::string place = place_of(option);
  const Form& form = form_of(option);
  DesignElement element;
  element.source = place;
  element.id = "element " + std::to_string(place_in_job + 1);
  element.kind = form.kind;
  element.tool = first_tool;
  element.stepdown = defaults.stepdown;
  element.cutting = defaults.cutting;
  element.depth = std::numeric_limits<double>::quiet_NaN();
  const auto words = split(option.text, ':');
  read_shape(element, split(words[0], ','), form, place);
  for (std::size_t i = 1; i < words.size(); ++i) apply_word(element, words[i], place);
  if (std::isnan(element.depth)) {
    if (!defaults.depth) throw InputError(place, "has no depth; add :depth=MM or --depth MM");
    element.depth = *defaults.depth;
  }
  return element;
}

/// Roomy enough for any element, exact or not: validation compares the true shapes.
void add_to(Box& box, const DesignElement& element) {
  if (element.kind == ElementKind::kRectangle) {
    const Vec2 corner = lower_left(element);
    box.add(corner);
    box.add(corner + Vec2{element.length, element.width});
    return;
  }
  const double around = element.kind == ElementKind::kArc ? element.radius : element.width / 2;
  const Vec2 reach{around, around};
  for (const Vec2 p : {element.from, element.to}) {
    box.add(p - reach);
    box.add(p + reach);
  }
}

Stock stock_around(const ElementJob& job) {
  Box box;
  double deepest = 0, tool = 0;
  for (const auto& element : job.elements) {
    add_to(box, element);
    deepest = std::max(deepest, element.depth);
  }
  for (const auto& each : job.tools) tool = std::max(tool, each.diameter);
  const auto down = [&](double v) { return std::floor((v - tool) / job.resolution) * job.resolution; };
  const auto up = [&](double v) { return std::ceil((v + tool) / job.resolution) * job.resolution; };
  return {{{down(box.min.x), down(box.min.y)}, {up(box.max.x), up(box.max.y)}}, -deepest, 0};
}

Stock stock_of(const std::string& text) {
  const std::string place = "--stock " + text;
  const auto parts = split(text, ',');
  if (parts.size() != 6) throw InputError(place, "needs X0,X1,Y0,Y1,Z0,Z1");
  std::vector<double> n;
  for (const auto& part : parts) n.push_back(number(part, place));
  for (std::size_t i = 0; i < 6; i += 2) {
    if (!(n[i] < n[i + 1])) throw InputError(place, "each pair must rise");
  }
  return {{{n[0], n[2]}, {n[1], n[3]}}, n[4], n[5]};
}

}  // namespace

ElementJob elements_of_options(const std::vector<ElementOption>& options, const ElementDefaults& defaults) {
  ElementJob job;
  job.name = "elements";
  job.source_file = "command line";
  job.resolution = defaults.resolution;
  job.middle_row = defaults.middle_row;
  job.tools = defaults.tools;
  for (std::size_t i = 0; i < job.tools.size(); ++i) {
    if (job.tools[i].number == 0) job.tools[i].number = static_cast<int>(i) + 1;
  }
  const int first_tool = job.tools.empty() ? 1 : job.tools.front().number;
  for (const auto& option : options)
    job.elements.push_back(element_of(option, defaults, first_tool, job.elements.size()));
  job.stock = defaults.stock ? stock_of(*defaults.stock) : stock_around(job);
  return job;
}

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
