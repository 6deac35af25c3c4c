#include "resolve/values/plan_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <thread>

#include "base/error.h"
#include "base/text.h"
#include "model/tool.h"
#include "options/row.h"

namespace clearcut::resolve {
namespace {

/// Degrees between the flanks of a cone.
constexpr double kSharpest = 5;
/// Degrees of each side of a tapered end mill.
constexpr double kLeastTaper = 0.1, kMostTaper = 45;
constexpr double kBluntest = 170;
/// mm. Narrower cutters are not sold, and tolerances are as wide.
constexpr double kSmallestDiameter = 0.01;

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

double required_number(const std::string& text, const std::string& place, const char* what) {
  const auto value = number(text);
  if (!value) throw InputError(place, fmt::format("'{}' is not {}", text, what));
  return *value;
}

double required_length(const std::string& text, const std::string& place, const char* what) {
  const auto value = length_in_mm(text);
  if (!value) throw InputError(place, fmt::format("'{}' is not {}; write 6, 6mm or 0.25in", text, what));
  return *value;
}

std::string kind_names() {
  std::string names;
  for (const ToolKindRow& row : tool_kinds()) {
    if (row.kind != ToolKind::kOther) names += (names.empty() ? "" : ", ") + std::string(row.name);
  }
  return names;
}

int whole_number(const std::string& text, const std::string& place, const char* what, int least, int most) {
  const double value = required_number(text, place, what);
  if (value != std::floor(value) || value < least || value > most)
    throw InputError(place,
                     fmt::format("'{}' is not {}: it must be whole, from {} to {}", text, what, least, most));
  return static_cast<int>(value);
}

bool is_angle(const std::string& word) {
  return word.size() > 3 && word.ends_with("deg") && word.find('=') == std::string::npos;
}

Radians required_angle(const std::string& text, const std::string& place) {
  const auto degrees = number(is_angle(text) ? std::string_view(text).substr(0, text.size() - 3) : text);
  if (!degrees || *degrees < kSharpest || *degrees > kBluntest)
    throw InputError(place, fmt::format("'{}' is no angle between flanks; write 60deg, from {} to {}", text,
                                        kSharpest, kBluntest));
  return Radians::of_degrees(*degrees);
}

/// The angle between the flanks, of the angle of each side.
Radians required_taper(const std::string& text, const std::string& place) {
  const auto degrees = number(is_angle(text) ? std::string_view(text).substr(0, text.size() - 3) : text);
  if (!degrees || *degrees < kLeastTaper || *degrees > kMostTaper)
    throw InputError(
        place, fmt::format("'{}' is no taper; write taper=5deg, the angle of each side, from {} to {}", text,
                           kLeastTaper, kMostTaper));
  return Radians::of_degrees(2 * *degrees);
}

double required_speed(const std::string& text, const std::string& place) {
  const auto rpm = number(text);
  if (!rpm || !(*rpm > 0))
    throw InputError(place, fmt::format("'{}' is no speed above 0 rpm; write max_spindle=12000", text));
  return *rpm;
}

/// Sets the material of the edges. False if the word is no material.
bool apply_edge_word(Tool& tool, const std::string& word) {
  if (word == "hss" || word == "carbide") tool.high_speed_steel = word == "hss";
  if (word == "coated") tool.coated = true;
  return word == "hss" || word == "carbide" || word == "coated";
}

void apply_word(Tool& tool, const std::string& word, const std::string& place) {
  const auto equals = word.find('=');
  const std::string key = word.substr(0, equals);
  const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
  if (apply_edge_word(tool, word)) return;
  if (key == "noplunge" && equals == std::string::npos) {
    tool.center_cutting = false;
  } else if (key.size() > 1 && (key[0] == 'T' || key[0] == 't') && equals == std::string::npos) {
    tool.number = whole_number(key.substr(1), place, "a tool number", 1, 1'000'000);
  } else if (key == "flutes") {
    tool.teeth = whole_number(value, place, "a number of flutes", 1, 100);
  } else if (key == "corner") {
    tool.corner_radius = required_length(value, place, "a corner radius");
  } else if (key == "length") {
    tool.flute_length = required_length(value, place, "a length of flutes");
  } else if (key == "stickout") {
    tool.stickout = required_length(value, place, "a length from the tip to the holder");
  } else if (key == "holder") {
    tool.holder_diameter = required_length(value, place, "a diameter of the holder");
  } else if (key == "shank") {
    tool.shank_diameter = required_length(value, place, "a diameter of the shank");
  } else if (key == "max_spindle") {
    tool.max_spindle_rpm = required_speed(value, place);
  } else if (is_angle(word) || key == "angle") {
    tool.tip_angle = required_angle(is_angle(word) ? word : value, place);
  } else if (key == "taper") {
    tool.tip_angle = required_taper(value, place);
  } else if (key == "tip") {
    tool.tip_diameter = required_length(value, place, "a diameter of the tip");
  } else if (key == "pitch") {
    tool.pitch = required_length(value, place, "a pitch");
  } else if (word == "left") {
    tool.left_hand = true;
  } else if (word == "floating") {
    tool.floating = true;
  } else if (key == "name") {
    tool.name = value;
  } else {
    throw InputError(place,
                     fmt::format("'{}' is unknown; use T<number>, flutes=, corner=, length=, shank=, "
                                 "stickout=, holder=, max_spindle=, 60deg, tip=, taper=, pitch=, left, "
                                 "floating, hss, carbide, coated, name=, noplunge",
                                 word));
  }
}

/// Checks the shape of tapered end mills and T-slot cutters.
void check_shape(const Tool& tool, const std::string& place) {
  const bool tapered = tool.kind == ToolKind::kTapered;
  if (tapered && (!tool.tip_angle || !tool.flute_length || tool.corner_radius > 0 || tool.tip_diameter != 0))
    throw InputError(
        place,
        "a tapered end mill needs the diameter of its flat tip, the angle of each side and the length "
        "of its flutes, for example tapered:3:taper=5deg:length=20");
  if (tool.kind != ToolKind::kTSlot) return;
  if (!tool.flute_length || !(tool.shank_diameter > 0) || tool.shank_diameter >= tool.diameter)
    throw InputError(
        place,
        "a T-slot cutter needs the diameter and the height of its disc and the diameter of its neck, "
        "for example tslot:20:length=8:shank=10");
}

/// Checks the cone against the needs of the tool's kind.
void check_cone(const Tool& tool, const std::string& place) {
  if (tool.kind == ToolKind::kTapered) return;
  const bool cone = row_of(tool.kind).use == ToolUse::kEdges;
  if (cone && !tool.tip_angle)
    throw InputError(
        place,
        fmt::format("a {0} needs the angle between its flanks, for example {0}:{1}deg:{2}",
                    name_of(tool.kind), tool.kind == ToolKind::kVBit ? 60 : 90, trimmed(tool.diameter, 4)));
  const bool drill_point = tool.kind == ToolKind::kDrill && tool.tip_diameter == 0;
  if (!cone && !drill_point && (tool.tip_angle || tool.tip_diameter > 0))
    throw InputError(place, fmt::format("a {} has no tip angle and no tip diameter", name_of(tool.kind)));
  if (tool.tip_diameter < 0 || tool.tip_diameter >= tool.diameter)
    throw InputError(place, "the diameter of the tip must be 0 or more, and less than the tool's");
}

/// Checks the thread data, which taps and thread mills need and no other tool has.
void check_thread(const Tool& tool, const std::string& place) {
  const bool tap = tool.kind == ToolKind::kTap, mill = tool.kind == ToolKind::kThreadMill;
  if (tap && !(tool.pitch > 0 && tool.pitch < tool.radius()))
    throw InputError(place, "a tap needs its thread, for example tap:M6, tap:M6x0.75, tap:1/4-20, or pitch=");
  if ((tool.pitch != 0 && !tap && !mill) || tool.pitch < 0 || ((tool.left_hand || tool.floating) && !tap))
    throw InputError(place, fmt::format("a {} has no pitch, hand or floating holder", name_of(tool.kind)));
  if (mill && tool.pitch > 0 && !tool.flute_length)
    throw InputError(place,
                     "a thread mill with many rows of teeth needs how long they reach, for example "
                     "threadmill:16:pitch=1.5:length=24");
}

/// A diameter, or the thread of a tap: "M6".
void set_size(Tool& tool, const std::string& word, const std::string& place) {
  const auto thread = tool.kind == ToolKind::kTap ? thread_named(word) : std::nullopt;
  tool.diameter = thread ? thread->diameter : required_length(word, place, "a diameter");
  if (!thread) return;
  tool.pitch = thread->pitch;
  tool.left_hand = thread->left_hand;
  tool.name = thread->name;
}

void require(bool good, const char* option, const char* what) {
  if (!good) throw InputError(option, what);
}

}  // namespace

Tool parse_tool(const std::string& text) {
  const std::string place = "--tool " + text;
  auto words = split(text, ':');
  // "vbit:60deg:6" and "vbit:6:60deg" are the same.
  if (words.size() > 2 && is_angle(words[1])) std::swap(words[1], words[2]);
  if (words.size() < 2) throw InputError(place, "needs a kind and a diameter in mm, for example endmill:10");
  const auto kind = tool_kind_named(words[0]);
  if (!kind)
    throw InputError(place, fmt::format("'{}' is no kind of tool; use one of {}", words[0], kind_names()));
  Tool tool;
  tool.number = 0;
  tool.kind = *kind;
  set_size(tool, words[1], place);
  if (!(tool.diameter > 0) || tool.diameter > 1000)
    throw InputError(place, "the diameter must be above 0 and at most 1000 mm");
  if (tool.diameter < kSmallestDiameter)
    throw InputError(place,
                     fmt::format("a diameter of {} mm is less than any cutter has, {} mm; correct its unit",
                                 tool.diameter, trimmed(kSmallestDiameter, 3)));
  if (tool.kind == ToolKind::kFaceMill) tool.center_cutting = false;
  if (tool.kind == ToolKind::kBallEndMill) tool.corner_radius = tool.diameter / 2;
  for (std::size_t i = 2; i < words.size(); ++i) apply_word(tool, words[i], place);
  if (tool.corner_radius < 0 || tool.corner_radius > tool.radius())
    throw InputError(place, fmt::format("the corner radius must lie between 0 and {} mm, half the diameter",
                                        trimmed(tool.radius(), 4)));
  check_shape(tool, place);
  check_cone(tool, place);
  check_thread(tool, place);
  check_holder(tool, place);
  if (tool.flute_length && !(*tool.flute_length > 0))
    throw InputError(place, "the length of the flutes must be above 0 mm");
  return tool;
}

namespace {

/// Lowest and highest x, y and z of a block, mm.
using Sides = std::array<std::array<double, 2>, 3>;

/// Ranges LOW:HIGH; if `top` is given, sizes too: from X 0 and Y 0, down from the top.
Sides sides_of(const std::string& text, const std::string& place, std::optional<double> top,
               const char* needs) {
  const std::vector<std::string> words = split(text, ',');
  if (words.size() != 3) throw InputError(place, needs);
  Sides sides{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto colon = words[i].find(':');
    const bool is_range = colon != std::string::npos;
    if (!is_range && !top) throw InputError(place, needs);
    const double last = required_length(words[i].substr(is_range ? colon + 1 : 0), place, "a length");
    if (is_range) {
      sides[i] = {required_length(words[i].substr(0, colon), place, "a length"), last};
    } else {
      sides[i] = i == 2 ? std::array{*top - last, *top} : std::array{0.0, last};
    }
    if (!(sides[i][0] < sides[i][1]))
      throw InputError(place,
                       fmt::format("'{}' is no side of a block: a size above 0, or LOW:HIGH", words[i]));
  }
  return sides;
}

}  // namespace

PredrilledHole parse_predrilled(const std::string& text) {
  const std::string place = "--predrilled " + text;
  const auto comma = text.find(','), colon = text.find(':');
  if (comma == std::string::npos || colon == std::string::npos || colon < comma)
    throw InputError(place, "needs a place and a diameter in mm, for example 12,8.5:6");
  PredrilledHole hole;
  hole.center.x = required_number(text.substr(0, comma), place, "a coordinate");
  hole.center.y = required_number(text.substr(comma + 1, colon - comma - 1), place, "a coordinate");
  hole.diameter = required_number(text.substr(colon + 1), place, "a diameter in mm");
  if (!(hole.diameter > 0)) throw InputError(place, "the diameter must be above 0 mm");
  return hole;
}

Stock parse_stock(const std::string& text, double top) {
  const Sides sides =
      sides_of(text, "--stock " + text, top,
               "needs a size or a range for X, Y and Z, for example 100,60,20 or -5:95,0:60,-20:0");
  return {{{sides[0][0], sides[1][0]}, {sides[0][1], sides[1][1]}}, sides[2][0], sides[2][1]};
}

KeepOut parse_keep_out(const std::string& text) {
  const Sides sides = sides_of(text, "--keep-out " + text, std::nullopt,
                               "needs ranges of X, Y and Z, for example -10:15,20:40,-20:12");
  return {{{sides[0][0], sides[1][0]}, {sides[0][1], sides[1][1]}}, sides[2][0], sides[2][1]};
}

void add_places(const std::vector<std::string>& keep_outs, const std::vector<std::string>& predrilled,
                PlanOptions& options) {
  for (const std::string& text : keep_outs) options.keep_outs.push_back(parse_keep_out(text));
  for (const std::string& text : predrilled) options.predrilled.push_back(parse_predrilled(text));
}

void check_holder(const Tool& tool, const std::string& place) {
  if (tool.stickout.has_value() != (tool.holder_diameter > 0) || tool.stickout.value_or(1) <= 0)
    throw InputError(place,
                     "a holder needs its diameter and how far the tool stands out of it, for example "
                     "stickout=30:holder=40");
  if (tool.shank_diameter < 0) throw InputError(place, "the diameter of the shank must be above 0 mm");
  if (tool.shank_diameter > tool.diameter && !tool.flute_length)
    throw InputError(place, "a shank wider than the cutter needs where it begins: length= of the flutes");
}

void check(const VisitSolver& solver, const std::string& place) {
  if (!solver.is_published && solver.published.is_set())
    throw InputError(place,
                     "is not published, but settings of that solver are given; add --solver published");
}

void check(const TabOptions& tabs) {
  require(!tabs.skin || !tabs.any(), "--skin",
          "holds what tabs would hold; leave out --skin, or --tabs, --tab-spacing and --tab-at");
  require(!tabs.spacing || tabs.count == 0, "--tab-spacing",
          "says how many tabs there are; leave out --tabs");
  require(tabs.at.empty() || (tabs.count == 0 && !tabs.spacing), "--tab-at",
          "says where all tabs are; leave out --tabs and --tab-spacing");
  require(std::all_of(tabs.at.begin(), tabs.at.end(),
                      [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }),
          "--tab-at", "must be numbers of mm");
}

namespace {

/// mm. Greatest thickness left along walls by passes; between two passes, Tolerances::uncut may be left.
constexpr double kLeftAlongWalls = 0.004;

/// A path with this deviation leaves the deviation plus the stock kept against gouges; in square corners of walls,
/// the square root of two times this sum. Acute corners may have a smaller margin, as the verdict then states. The
/// stock by itself must stay within the verdict's bound of uncut material.
void refuse_narrow_bounds(double at_least, const ShopOptions& shop) {
  const MarginBounds standard;
  const double gouge = shop.margin_gouge.value_or(standard.gouge),
               uncut = shop.margin_uncut.value_or(standard.uncut);
  const double stock = std::sqrt(2.0) * MarginRule{at_least, {uncut, gouge}}.stock();
  const double needed = at_least + stock + standard.uncut;
  if (needed <= uncut && stock + kLeftAlongWalls <= standard.uncut) return;
  throw InputError(
      "--margin-at-least",
      fmt::format(
          "{} mm cannot be held where {} mm may be left and {} mm be cut too deep; allow more, for example "
          "--margin-uncut {} --margin-gouge {}",
          trimmed(at_least, 4), trimmed(uncut, 4), trimmed(gouge, 4),
          trimmed(at_least + 1.5 * standard.uncut, 4), trimmed(at_least, 4)));
}

}  // namespace

void check(const PlanOptions& options) {
  check_values(Asked{options, {}}, "--");
  check(options.tabs);
  if (options.published.solver) check(*options.published.solver, "--solver");
  const ShopOptions& shop = options.shop;
  const char* const of_rule = shop.reference_engagement_deg ? "reference-engagement"
                              : shop.reference_feed         ? "reference-feed"
                              : shop.feed_cap               ? "feed-cap"
                                                            : nullptr;
  if (of_rule && !shop.feed_by)
    throw InputError(source_of(options, of_rule).text,
                     "has no effect: feeds are as stated; add --feed-by chip or --feed-by removal");
  if (shop.margin_at_least) refuse_narrow_bounds(*shop.margin_at_least, shop);
  require(
      !options.post.inch || options.post.decimals.value_or(4) >= 4, "--decimals",
      "three decimals of an inch are steps of 0.025 mm, coarser than what is certified; use --decimals 4");
}

Source source_of(const PlanOptions& options, const std::string& name) {
  const Source* source = options.sources.find(name);
  return source ? *source : Source{Origin::kUser, "--" + name};
}

int thread_count(const PlanOptions& options) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return options.threads == 0 ? cores : std::min(options.threads, cores);
}

}  // namespace clearcut::resolve
