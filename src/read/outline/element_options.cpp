#include "read/outline/element_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "base/error.h"
#include "base/text/format.h"

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

}  // namespace clearcut::read
