#include "report/certificate/figure_relations.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/units.h"
#include "model/results/findings.h"

namespace clearcut::report {
namespace {

using Json = nlohmann::ordered_json;

/// Degrees; width of a class of the histogram of engagement.
constexpr double kClass = 10;
constexpr std::size_t kClasses = 18;
/// Degrees. Smaller changes of direction are no turns.
constexpr double kLeastTurn = 0.1;
/// Share of a time that rounding of feeds may take from it.
constexpr double kTimeShare = 1e-3;
/// mm of feed that length bounds may differ by, computed again from rounded numbers.
constexpr double kBoundRounding = 1e-3;

/// What holds for a figure of the whole, of which features and layers have a share.
enum class Share : unsigned char {
  kSum,             ///< the whole is the sum of its features; layers have no more than their feature
  kSumOfFeatures,   ///< likewise, and nothing is known of layers
  kSumOfLayers,     ///< the sum at both levels
  kSumInPlans,      ///< likewise kSum, of programs whose moves are grouped by features
  kMost,            ///< the whole has the greatest of its features; layers have no more than their feature
  kMostOfFeatures,  ///< likewise, and layers have no more than the whole
  kNone
};

struct Figure {
  const char* path;
  Share share;
  bool needs_part = false;   ///< null where no part was given
  bool is_of_moves = true;   ///< of moves, which may belong to no feature
  bool is_optional = false;  ///< not in all certificates
};
constexpr Figure kFigures[] = {
    {"feed_mm", Share::kSum},
    {"rapid_mm", Share::kSum},
    {"plunge_mm", Share::kSum},
    {"turns", Share::kSumInPlans},
    {"turn_angle_deg", Share::kSumInPlans},
    {"retracts", Share::kNone},
    {"time_s", Share::kSum},
    {"waits_s", Share::kSum},
    {"time_naive_s", Share::kSum},
    {"uncut_mm2", Share::kSumOfFeatures, true, false},
    {"uncut_thickness_mm", Share::kMostOfFeatures, true, false},
    {"path_tolerance_mm", Share::kMostOfFeatures, false, false},
    {"gouge_mm", Share::kMost, true},
    {"unreachable_mm2", Share::kSumOfFeatures, true, false},
    {"rapid_in_material", Share::kSum},
    {"max_axial_mm", Share::kMost},
    {"engagement/max_deg", Share::kMost},
    {"engagement/mean_deg", Share::kNone},
    {"engagement/over_limit_mm", Share::kSum},
    {"engagement/climb_mm", Share::kSum},
    {"engagement/conventional_mm", Share::kSum},
    {"entries/count", Share::kSum},
    {"entries/length_mm", Share::kSum},
    {"entries/max_deg", Share::kMost},
    {"entries/max_axial_mm", Share::kMost},
    {"air_cut_mm", Share::kSum},
    {"lower_bound_mm", Share::kSumOfLayers, true, false},
    {"load/max_force_n", Share::kMost, false, true, true},
    {"load/mean_force_n", Share::kNone, false, true, true},
    {"load/max_power_w", Share::kMost, false, true, true},
    {"load/energy_j", Share::kSum, false, true, true},
    {"load/removed_mm3", Share::kSum, false, true, true},
    {"load/tool_wear", Share::kSum, false, true, true},
    {"reference_load/share", Share::kMost, false, true, true},
};

struct Pair {
  const char* less;
  const char* more;
};
constexpr Pair kNoMoreThan[] = {
    {"plunge_mm", "feed_mm"},
    {"waits_s", "time_s"},
    {"air_cut_mm", "feed_mm"},
    {"lower_bound_mm", "feed_mm"},
    {"entries/length_mm", "feed_mm"},
    {"entries/max_axial_mm", "max_axial_mm"},
    {"engagement/mean_deg", "engagement/max_deg"},
    {"load/mean_force_n", "load/max_force_n"},
};

/// A figure above 0 requires that the other one is there and not 0.
struct Needs {
  const char* figure;
  const char* other;
};
constexpr Needs kNeeds[] = {
    {"gouge_mm", "gouge_at"},
    {"engagement/max_deg", "engagement/max_at"},
    {"entries/max_deg", "entries/max_at"},
    {"turn_angle_deg", "turns"},
    {"retracts", "feed_mm"},
    {"load/max_force_n", "load/max_force_at"},
};

/// Whether something is there: a number above 0, or a place.
bool is_there(const Json& value) {
  return value.is_number() ? value.get<double>() > 0 : !value.is_null();
}

/// The figures of the whole, a feature or a layer, with their path in the certificate.
struct FiguresAt {
  const Json& json;
  std::string at;  ///< "" for the whole, "/features/0", ...

  double operator[](std::string_view path) const { return number_at(json, path); }
  std::string name(std::string_view path) const { return at + "/" + std::string(path); }
};

struct Basis {
  bool without_part = false;
  bool may_be_endless = false;        ///< moves without a feed never end
  bool is_planned = false;            ///< a plan's, whose sections belong to features
  bool rapids_know_one_speed = true;  ///< the machine states no speeds of single axes
  std::optional<double> engagement_limit_deg;
  double uncut_limit_mm = 0;
};

/// In steps of the last digit, where `count` rounded numbers were added.
double rounding_of(std::size_t count) {
  return kLastDigit * static_cast<double>(count + 2);
}

constexpr const char* kPlaces[] = {"uncut_at", "gouge_at", "engagement/max_at", "entries/max_at",
                                   "load/max_force_at"};

/// Every figure is a number, and every place has its coordinates.
void check_numbers(const FiguresAt& figures, const Basis& basis, Sentences& out) {
  for (const Figure& one : kFigures) {
    const bool may_be_none =
        one.is_optional || (one.needs_part && basis.without_part) || basis.may_be_endless;
    if (!may_be_none && !field_at(figures.json, one.path).is_number())
      out.push_back(figures.name(one.path) + ": is no number, and no fault says why");
  }
  for (const char* path : kPlaces) {
    const Json& place = field_at(figures.json, path);
    const auto is_number = [&](const char* axis) { return field_at(place, axis).is_number(); };
    if (!place.is_null() && !(is_number("x") && is_number("y") && is_number("z")))
      out.push_back(figures.name(path) + ": is no place");
  }
}

void check_pairs(const FiguresAt& figures, Sentences& out) {
  for (const Pair& pair : kNoMoreThan) {
    if (figures[pair.less] > figures[pair.more] + rounding_of(0))
      out.push_back(figures.name(pair.less) + ": is more than " + pair.more);
  }
  for (const Needs& needs : kNeeds) {
    if (is_there(field_at(figures.json, needs.figure)) && !is_there(field_at(figures.json, needs.other)))
      out.push_back(figures.name(needs.figure) + ": is there without " + needs.other);
  }
}

/// Lengths by classes of engagement.
struct Classes {
  std::vector<double> mm;
  double sum = 0;
  double least_mm_deg = 0;  ///< sum of the lengths times the least angle of their class
  std::size_t highest = 0;  ///< behind the highest class with any length

  explicit Classes(const Json& histogram) {
    for (const Json& one : histogram) {
      mm.push_back(one.is_number() ? one.get<double>() : 0);
      if (mm.back() > 0) highest = mm.size();
      sum += mm.back();
      least_mm_deg += mm.back() * kClass * static_cast<double>(mm.size() - 1);
    }
  }
  /// The length in classes wholly above the angle, or also in the one that it lies in.
  double above(double degrees, bool wholly) const {
    double length = 0;
    for (std::size_t i = 0; i < mm.size(); ++i)
      if (kClass * static_cast<double>(wholly ? i : i + 1) > degrees) length += mm[i];
    return length;
  }
};

void check_over_limit(const FiguresAt& figures, const Classes& classes, const Basis& basis, Sentences& out) {
  constexpr const char* kPath = "engagement/over_limit_mm";
  const double over = figures[kPath], rounding = rounding_of(classes.mm.size());
  const double most = basis.engagement_limit_deg ? classes.above(*basis.engagement_limit_deg, false) : 0;
  const double least =
      basis.engagement_limit_deg ? classes.above(*basis.engagement_limit_deg + kFreeEngagementDeg, true) : 0;
  if (over > most + rounding || over < least - rounding)
    out.push_back(figures.name(kPath) + ": is not what the histogram has above the limit");
}

void check_engagement(const FiguresAt& figures, const Basis& basis, Sentences& out) {
  const Json& histogram = field_at(figures.json, "engagement/histogram");
  if (!histogram.is_array()) return;
  if (histogram.size() != kClasses ||
      !std::all_of(histogram.begin(), histogram.end(), [](const Json& one) { return one.is_number(); }))
    out.push_back(figures.name("engagement/histogram") + ": is not 18 lengths");
  const Classes classes(histogram);
  const double rounding = rounding_of(classes.mm.size());
  const double climb = figures["engagement/climb_mm"];
  const double sided = climb + figures["engagement/conventional_mm"];
  const auto say = [&](const char* path, const char* what) {
    out.push_back(figures.name(path) + ": " + what);
  };
  if (std::abs(classes.sum - sided) > rounding)
    say("engagement/histogram", "is not as long as climb and conventional cutting together");
  if (classes.sum + figures["air_cut_mm"] > figures["feed_mm"] + rounding)
    say("engagement/histogram", "is longer than the feed in material");
  const double mean = figures["engagement/mean_deg"];
  // The mean is over plunges as well, which are in no class.
  const double most_mm_deg = classes.least_mm_deg + kClass * classes.sum;
  if (mean * figures["feed_mm"] < classes.least_mm_deg * (1 - kLastDigit) - rounding ||
      mean * classes.sum > most_mm_deg * (1 + kLastDigit) + rounding || (mean > 0 && classes.sum <= 0))
    say("engagement/mean_deg", "is not the mean of the histogram");
  if (classes.highest > 0 &&
      figures["engagement/max_deg"] < kClass * static_cast<double>(classes.highest - 1) - kLastDigit)
    say("engagement/max_deg", "is less than the histogram has");
  check_over_limit(figures, classes, basis, out);
  const Json& percent = field_at(figures.json, "engagement/climb_percent");
  const double rounded = sided > 0 ? 100 * kLastDigit * (1 + 1 / sided) : 0;
  if (percent.is_number() != (sided > 0) ||
      (sided > 0 && std::abs(percent.get<double>() - 100 * climb / sided) > rounded))
    say("engagement/climb_percent", "is not the share of climb cutting");
}

void check_turns(const FiguresAt& figures, Sentences& out) {
  const double turns = figures["turns"], angle = figures["turn_angle_deg"];
  if (angle < turns * kLeastTurn - kLastDigit || angle > turns * 180 + kLastDigit)
    out.push_back(figures.name("turn_angle_deg") + ": is no sum of as many turns");
}

void check_time(const FiguresAt& figures, const Basis& basis, Sentences& out) {
  const double moving = figures["time_s"] - figures["waits_s"];
  if (basis.rapids_know_one_speed && moving < figures["time_naive_s"] * (1 - kTimeShare) - rounding_of(1))
    out.push_back(figures.name("time_s") +
                  ": is less than the length of the path over its feeds and the waits");
}

void check_uncut(const FiguresAt& figures, const Basis& basis, Sentences& out) {
  if (figures["uncut_mm2"] > 0 && figures["uncut_thickness_mm"] <= basis.uncut_limit_mm)
    out.push_back(figures.name("uncut_mm2") + ": is there, and nothing is wider than the limit");
}

void check_alone(const FiguresAt& figures, const Basis& basis, Sentences& out) {
  check_numbers(figures, basis, out);
  check_pairs(figures, out);
  check_engagement(figures, basis, out);
  check_turns(figures, out);
  check_time(figures, basis, out);
  check_uncut(figures, basis, out);
}

/// The shares of a whole, and whether they make it up.
struct Shares {
  const FiguresAt& whole;
  const std::vector<FiguresAt>& parts;
  bool are_all_moves = true;

  /// Sums, or the greatest, by `value`. `exact`: no part of the whole lies outside of the shares.
  void check(const std::string& path, const std::function<double(const Json&)>& value, bool adds, bool exact,
             Sentences& out) const {
    double all = 0;
    for (const FiguresAt& part : parts) all = adds ? all + value(part.json) : std::max(all, value(part.json));
    const double own = value(whole.json), rounding = rounding_of(adds ? parts.size() : 0);
    if (all > own + rounding || (exact && all < own - rounding))
      out.push_back(whole.name(path) + ": is not the " + (adds ? "sum" : "greatest") + " of its parts");
  }

  void check(const char* path, bool adds, bool exact, Sentences& out) const {
    check(
        path, [path](const Json& json) { return number_at(json, path); }, adds, exact, out);
  }

  void check_histogram(bool exact, Sentences& out) const {
    constexpr const char* kPath = "engagement/histogram";
    const std::size_t classes = field_at(whole.json, kPath).size();
    for (std::size_t i = 0; i < classes; ++i) {
      const auto length = [i](const Json& json) {
        const Json& all = field_at(json, kPath);
        return i < all.size() && all[i].is_number() ? all[i].get<double>() : 0.0;
      };
      check(std::string(kPath) + "/" + std::to_string(i), length, true, exact, out);
    }
  }
};

bool adds_up(Share share) {
  return share != Share::kMost && share != Share::kMostOfFeatures;
}

/// The whole and its features.
void check_features(const Shares& shares, const Basis& basis, Sentences& out) {
  double mean = 0;
  for (const FiguresAt& part : shares.parts) mean = std::max(mean, part["engagement/mean_deg"]);
  for (const Figure& one : kFigures) {
    if (one.share == Share::kNone || (one.share == Share::kSumInPlans && !basis.is_planned)) continue;
    shares.check(one.path, adds_up(one.share), shares.are_all_moves || !one.is_of_moves, out);
  }
  shares.check_histogram(shares.are_all_moves, out);
  if (shares.are_all_moves && shares.whole["engagement/mean_deg"] > mean + kLastDigit)
    out.push_back(shares.whole.name("engagement/mean_deg") + ": is more than that of any feature");
}

/// A feature and its layers.
void check_layers(const Shares& shares, const Basis& basis, Sentences& out) {
  for (const Figure& one : kFigures) {
    const bool is_of_layers = one.share == Share::kSum || one.share == Share::kMost ||
                              one.share == Share::kSumOfLayers ||
                              (one.share == Share::kSumInPlans && basis.is_planned);
    if (is_of_layers) shares.check(one.path, adds_up(one.share), one.share == Share::kSumOfLayers, out);
  }
  shares.check_histogram(false, out);
}

/// Residuals are found for all levels of a feature together, so that layers are held against the whole.
void check_layer_in_whole(const FiguresAt& whole, const FiguresAt& layer, Sentences& out) {
  for (const Figure& one : kFigures) {
    if (one.share == Share::kMostOfFeatures && layer[one.path] > whole[one.path] + kLastDigit)
      out.push_back(layer.name(one.path) + ": is more than that of the whole");
  }
}

/// mm; the bound of a feature's levels from its points and rings, as docs/report.md states it.
double bound_of(const Json& bound) {
  const double radius = number_at(bound, "cutter_radius_mm");
  double area = number_at(bound, "area_mm2"), in_rings = 0, widths = 0, widest = 0, next = 0;
  for (const Json& point : field_at(bound, "points")) area += number_at(point, "mm2");
  for (const Json& ring : field_at(bound, "rings")) {
    const double width = number_at(ring, "radius_mm") - radius;
    in_rings += number_at(ring, "mm2");
    widths += width;
    next = std::max(next, std::min(width, widest));
    widest = std::max(widest, width);
  }
  const double across = 2 * radius;
  if (field_at(bound, "rings").empty())
    return std::max(0.0, (area - number_at(bound, "paths") * kPi * radius * radius) / across);
  const double rest = std::max(0.0, area - in_rings) / across;
  return 2 * widths - widest + rest - std::max(next, std::min(rest, kPi * radius / 2));
}

void check_bounds(const FiguresAt& feature, const std::vector<FiguresAt>& layers, Sentences& out) {
  const Json& bound = field_at(feature.json, "length_bound");
  const double mm = number_at(bound, "mm");
  if (bound.is_object() &&
      std::abs(bound_of(bound) - mm) > kBoundRounding + kLastDigit * number_at(bound, "area_mm2"))
    out.push_back(feature.name("length_bound/mm") + ": does not follow from its points and rings");
  for (const FiguresAt& layer : layers) {
    const double own = layer["lower_bound_mm"];
    if (own > 0 && std::abs(own - mm) > kLastDigit)
      out.push_back(layer.name("lower_bound_mm") + ": is not that of a level of its feature");
  }
}

std::vector<FiguresAt> figures_in(const Json& list, const std::string& at) {
  std::vector<FiguresAt> all;
  for (std::size_t i = 0; i < list.size(); ++i) all.push_back({list[i], at + "/" + std::to_string(i)});
  return all;
}

void check_feature(const FiguresAt& whole, const FiguresAt& feature, const Basis& basis, Sentences& out) {
  check_alone(feature, basis, out);
  const std::vector<FiguresAt> layers = figures_in(field_at(feature.json, "layers"), feature.at + "/layers");
  for (std::size_t i = 0; i < layers.size(); ++i) {
    check_alone(layers[i], basis, out);
    check_layer_in_whole(whole, layers[i], out);
    if (i > 0 && layers[i]["z"] >= layers[i - 1]["z"])
      out.push_back(layers[i].name("z") + ": is not below the layer before it");
  }
  check_layers({feature, layers}, basis, out);
  check_bounds(feature, layers, out);
}

Basis basis_of(const Json& certificate) {
  Basis basis;
  basis.without_part = is_without_part(certificate);
  for (const Json& fault : field_at(certificate, "faults"))
    basis.may_be_endless = basis.may_be_endless || text_at(fault, "kind") == name_of(FaultKind::kNoFeed);
  basis.is_planned = text_at(certificate, "question/command") == "plan";
  basis.rapids_know_one_speed = field_at(certificate, "question/machine/axis_rapid_mm_per_min").is_null();
  const Json& limit = field_at(certificate, "question/limits/engagement_deg");
  if (limit.is_number()) basis.engagement_limit_deg = limit.get<double>();
  basis.uncut_limit_mm = number_at(certificate, "question/limits/uncut_mm");
  return basis;
}

}  // namespace

void check_figures(const Json& certificate, Sentences& out) {
  const Basis basis = basis_of(certificate);
  const FiguresAt whole{certificate, ""};
  const std::vector<FiguresAt> features = figures_in(field_at(certificate, "features"), "/features");
  check_alone(whole, basis, out);
  for (const FiguresAt& feature : features) check_feature(whole, feature, basis, out);
  // Moves that come near no feature belong to none of them.
  const bool are_attributed = std::any_of(features.begin(), features.end(), [](const FiguresAt& one) {
    return one["feed_mm"] > 0 || one["rapid_mm"] > 0;
  });
  check_features({whole, features, are_attributed}, basis, out);
}

}  // namespace clearcut::report
