#include "read/stepnc/shapes/members.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "base/units.h"

namespace clearcut::read::stepnc {

namespace {

constexpr int kDeepestPattern = 8;            // patterns of patterns of compounds ...
constexpr std::size_t kMostMembers = 10'000;  // of all patterns in one another
constexpr double kSameTurn = 1e-9;            // radians
constexpr double kRoundedStep = 5e-5;         // radians; of increments with few digits
constexpr double kSameDiameter = 0.01;        // mm; of the circle of a pattern

bool is_compound(const Node& node) {
  return node.is_any("COMPOUND_FEATURE", "COUNTERBORE_HOLE", "COUNTERSUNK_HOLE");
}

bool is_pattern(const Node& node) {
  return node.is_any("CIRCULAR_PATTERN", "RECTANGULAR_PATTERN", "GENERAL_PATTERN");
}

/// Argument 6, or 5 where the compound has no depth; of counterbores also the holes beside it.
std::vector<Node> elements_of(const Node& compound) {
  std::vector<Node> elements;
  for (std::size_t i = 4; i < (compound.is("COMPOUND_FEATURE") ? 6U : 8U); ++i)
    for (const Node& element : compound.refs(i))
      if (!element.is_any("PLANE", "ELEMENTARY_SURFACE")) elements.push_back(element);
  return elements;
}

/// In the workpiece; what is never cut needs no place.
Frame placed(const Frame& space, const Node& feature) {
  const bool has_place =
      (is_simple_feature(feature) && !feature.is("CHAMFER")) || is_compound(feature) || is_pattern(feature);
  return has_place ? composed(space, frame_of(feature.ref(3))) : space;
}

Vec3 moved(Vec3 v, Vec2 by) {
  return {v.x + by.x, v.y + by.y, v.z};
}

Vec3 rotated(Vec3 v, double angle) {
  const double c = base::cos(angle), s = base::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

/// The frame turned about the vertical through `center`, and then by `spin` about its own.
Frame turned(const Frame& frame, Vec2 center, double angle, double spin) {
  Frame result = frame;
  if (angle != 0) result.origin = moved(rotated(moved(frame.origin, -center), angle), center);
  if (spin == 0) return result;
  result.x = rotated(frame.x, spin);
  result.y = rotated(frame.y, spin);
  return result;
}

bool same_place(const Frame& a, const Frame& b) {
  return distance(in_plan(a.origin), in_plan(b.origin)) < kSamePlaceMm &&
         std::abs(a.origin.z - b.origin.z) < kSamePlaceMm;
}

int count_of(const Node& pattern, std::size_t argument, const char* what) {
  const double count = pattern.needed_number(argument, what);
  if (count != std::floor(count) || count < 1 || count > static_cast<double>(kMostMembers))
    pattern.fail(std::string(what) + " lies between 1 and " + std::to_string(kMostMembers) + "; correct it");
  return static_cast<int>(count);
}

/// Places in a pattern count from 1; files in which a 0 comes up count from 0.
class Index {
 public:
  Index(const std::vector<Node>& relocated, const std::vector<std::size_t>& relocated_arguments,
        const std::vector<Node>& missing, const std::vector<std::size_t>& missing_arguments,
        Context& context) {
    note_zero(relocated, relocated_arguments, context);
    note_zero(missing, missing_arguments, context);
  }

  /// From 0.
  int at(const Node& node, std::size_t argument, int size) const {
    const double given = node.number(argument).value_or(first_) - first_;
    if (!(given >= 0 && given < size) || given != std::floor(given))
      node.fail("its index is outside the pattern; correct it");
    return static_cast<int>(given);
  }

 private:
  void note_zero(const std::vector<Node>& nodes, const std::vector<std::size_t>& arguments,
                 Context& context) {
    for (const Node& node : nodes) {
      for (const std::size_t argument : arguments) {
        if (node.number(argument) != 0.0) continue;
        first_ = 0;
        context.note("places in the pattern are counted from 0, since one is 0", node);
      }
    }
  }

  int first_ = 1;
};

class CircularPattern {
 public:
  CircularPattern(const Node& pattern, const Frame& frame, Context& context)
      : pattern_(pattern), frame_(frame), context_(context) {}

  std::vector<Frame> members(const Frame& base_in) const {
    const Frame base = on_circle(base_in);
    const int count = count_of(pattern_, 6, "number of features");
    const bool in_degrees = are_degrees(count);
    if (in_degrees && !context_.degrees)
      context_.warn("its angles are read in degrees: in radians its members would go round more than once",
                    pattern_);
    const auto angle = [&](double value) { return in_degrees ? value * kPi / 180 : value; };
    const double step = angle(pattern_.needed_number(5, "angle increment"));
    const double spin = angle(pattern_.number(10).value_or(0));
    if (spin != 0) context_.note("each member is turned by that much more than the one before it", pattern_);
    std::vector<double> angles;
    for (int i = 0; i < count; ++i) angles.push_back(i * step);
    const auto relocated = pattern_.refs(7), missing = pattern_.refs(8);
    const Index index(relocated, {1}, missing, {0}, context_);
    for (const Node& node : relocated)
      angles[static_cast<std::size_t>(index.at(node, 1, count))] +=
          angle(node.needed_number(0, "angular offset"));
    std::set<int> omitted;
    if (!in_degrees && closes_turn(count) && relocated.empty()) {
      omitted.insert(count - 1);
      context_.warn("its last member lies on its first, one turn on, and is made once", pattern_);
    }
    for (const Node& node : missing) omitted.insert(index.at(node, 0, count));
    std::vector<Frame> result;
    for (int i = 0; i < count; ++i) {
      if (omitted.count(i)) continue;
      result.push_back(turned(base, in_plan(frame_.origin), angles[static_cast<std::size_t>(i)], i * spin));
    }
    return result;
  }

 private:
  /// Members that went round more than once in radians are meant in degrees.
  bool are_degrees(int count) const {
    return context_.degrees || (turned_in_radians(count) > 2 * kPi - kSameTurn && !closes_turn(count));
  }

  /// Whether the last member comes to lie on the first: several increments that make one turn are no degrees.
  bool closes_turn(int count) const {
    return count > 2 && std::abs(turned_in_radians(count) - 2 * kPi) <= (count - 1) * kRoundedStep;
  }

  /// From the first member to the last.
  double turned_in_radians(int count) const {
    return (count - 1) * std::abs(pattern_.needed_number(5, "angle increment"));
  }

  /// The base as the standard has it lies on the circle. Some writers place it in the pattern's frame, or at the centre.
  Frame on_circle(const Frame& base) const {
    const auto diameter = pattern_.length(9);
    const auto fits = [&](const Frame& frame) {
      const double there = 2 * distance(in_plan(frame.origin), in_plan(frame_.origin));
      return there > kSamePlaceMm && (!diameter || std::abs(there - *diameter) <= kSameDiameter);
    };
    if (fits(base)) return base;
    const Frame inside = composed(frame_, base);
    if (diameter && fits(inside)) {
      context_.warn(
          "its base feature fits the pattern's diameter only when it is placed in the pattern; so it is",
          pattern_);
      return inside;
    }
    if (distance(in_plan(base.origin), in_plan(frame_.origin)) > kSamePlaceMm) {
      context_.warn("its diameter does not fit the place of its base feature; the place counts", pattern_);
      return base;
    }
    if (!diameter || *diameter <= 0)
      pattern_.fail(
          "its base feature lies on its axis, so that all members are one; give the base its place on the "
          "circle");
    context_.warn("its base feature is placed at its centre; it is moved along x to the pattern's circle",
                  pattern_);
    Frame result = base;
    result.origin = moved(base.origin, in_plan(frame_.direction({*diameter / 2, 0, 0})));
    return result;
  }

  const Node& pattern_;
  const Frame& frame_;
  Context& context_;
};

/// A level direction of the pattern's frame, of length 1.
Vec2 row_direction(const Node& node, const Frame& frame) {
  const Vec3 axis = frame.direction(axis_of(node));
  const double length = norm(in_plan(axis));
  if (!(length > 0) || std::abs(axis.z) > 1e-6 * length)
    node.fail("the direction does not lie in the plane of the pattern; correct it");
  return in_plan(axis) / length;
}

/// Between one member and the next of `count`; a single one has no next.
double spacing_of(const Node& pattern, std::size_t argument, const char* what, int count, Context& context) {
  if (count == 1) {
    if (pattern.length(argument))
      context.note(std::string("its ") + what + " asks for nothing: there is one", pattern);
    return 0;
  }
  const double spacing = pattern.needed_length(argument, what);
  if (spacing == 0) pattern.fail(std::string(what) + " is zero; correct it");
  return spacing;
}

std::vector<Frame> rectangular_members(const Node& pattern, const Frame& frame, const Frame& base,
                                       Context& context) {
  const int rows = pattern.unset(7) ? 1 : count_of(pattern, 7, "number of rows");
  if (!pattern.unset(3) && distance(in_plan(frame.origin), in_plan(base.origin)) > kSamePlaceMm)
    context.note("its placement is not that of its base feature, which is the first member", pattern);
  const int columns = count_of(pattern, 8, "number of columns");
  if (static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns) > kMostMembers)
    pattern.fail("more than 10000 members; split the pattern");
  const Vec2 along = row_direction(pattern.needed_ref(6, "direction"), frame);
  const Vec2 column = along * spacing_of(pattern, 5, "spacing of columns", columns, context);
  const Vec2 across =
      pattern.unset(10) ? left_of(along) : row_direction(pattern.needed_ref(10, "row direction"), frame);
  const Vec2 row = across * spacing_of(pattern, 9, "spacing of rows", rows, context);
  std::vector<Vec2> shift;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) shift.push_back(row * r + column * c);
  const auto relocated = pattern.refs(11), missing = pattern.refs(12);
  const Index index(relocated, {2, 3}, missing, {0, 1}, context);
  const auto place = [&](const Node& node, std::size_t argument) {
    return static_cast<std::size_t>(index.at(node, argument, rows) * columns +
                                    index.at(node, argument + 1, columns));
  };
  for (const Node& node : relocated)
    shift[place(node, 2)] =
        shift[place(node, 2)] + row_direction(node.needed_ref(0, "offset direction"), frame) *
                                    node.needed_length(1, "offset distance");
  std::set<std::size_t> omitted;
  for (const Node& node : missing) omitted.insert(place(node, 0));
  std::vector<Frame> result;
  for (std::size_t i = 0; i < shift.size(); ++i) {
    if (omitted.count(i)) continue;
    result.push_back(base);
    result.back().origin = moved(base.origin, shift[i]);
  }
  return result;
}

/// The base, and a copy at each location, which is given in the pattern's frame.
std::vector<Frame> general_members(const Node& pattern, const Frame& frame, const Frame& base) {
  const std::vector<Node> locations = pattern.refs(5);
  if (locations.empty()) pattern.fail("it has no locations; give them");
  if (locations.size() > kMostMembers) pattern.fail("more than 10000 members; split the pattern");
  std::vector<Frame> result{base};
  for (const Node& location : locations) result.push_back(composed(frame, frame_of(location)));
  return result;
}

class Expansion {
 public:
  explicit Expansion(Context& context) : context_(context) {}

  /// `space` is the frame that placements beside the feature's are given in.
  void expand(const Node& feature, const Frame& space, const Frame& placement, const std::string& outer_name,
              int depth) {
    if (depth > kDeepestPattern)
      feature.fail("patterns and compounds are nested more than 8 deep (or in a circle); flatten them");
    context_.spend(1, feature);
    context_.use_head(feature);
    const std::string name = feature.text(0).empty() ? outer_name : feature.text(0);
    if (is_compound(feature)) return expand_compound(feature, placement, name, depth);
    if (is_pattern(feature)) return expand_pattern(feature, space, placement, name, depth);
    if (members.size() == kMostMembers) feature.fail("more than 10000 members; split the pattern");
    members.push_back({feature, placement, name});
  }

  std::vector<Member> members;

 private:
  void expand_compound(const Node& compound, const Frame& placement, const std::string& name, int depth) {
    const std::vector<Node> elements = elements_of(compound);
    if (elements.empty()) compound.fail("it has no elements; give them");
    for (const Node& element : elements)
      expand(element, placement, placed(placement, element), name, depth + 1);
  }

  void expand_pattern(const Node& pattern, const Frame& space, const Frame& placement,
                      const std::string& name, int depth) {
    if (!is_upright(placement))
      pattern.fail(
          "its placement is tilted; only patterns seen from above (+Z) can be machined in this set-up");
    const Node base_feature = pattern.needed_ref(4, "base feature");
    const Frame base = placed(space, base_feature);
    std::vector<Frame> frames = frames_of(pattern, placement, base);
    drop_coinciding(frames, pattern);
    if (frames.empty()) pattern.fail("all its members are missing; there is nothing to make");
    for (const Frame& frame : frames)
      expand(base_feature, composed(composed(frame, inverse(base)), space), frame, name, depth + 1);
  }

  std::vector<Frame> frames_of(const Node& pattern, const Frame& placement, const Frame& base) {
    if (pattern.is("CIRCULAR_PATTERN")) return CircularPattern(pattern, placement, context_).members(base);
    if (pattern.is("RECTANGULAR_PATTERN")) return rectangular_members(pattern, placement, base, context_);
    return general_members(pattern, placement, base);
  }

  /// A last member that came round to the first, or a base that is listed again, is cut once.
  void drop_coinciding(std::vector<Frame>& frames, const Node& pattern) {
    if (frames.empty()) return;
    const auto again = std::remove_if(frames.begin() + 1, frames.end(),
                                      [&](const Frame& frame) { return same_place(frame, frames[0]); });
    if (again == frames.end()) return;
    context_.note("members in the place of the first are cut once", pattern);
    frames.erase(again, frames.end());
  }

  Context& context_;
};

}  // namespace

bool is_simple_feature(const Node& node) {
  return node.is_any("CLOSED_POCKET", "OPEN_POCKET", "PLANAR_FACE", "SLOT", "STEP", "ROUND_HOLE",
                     "GENERAL_OUTSIDE_PROFILE", "CIRCULAR_CLOSED_SHAPE_PROFILE",
                     "RECTANGULAR_CLOSED_SHAPE_PROFILE", "GENERAL_SHAPE_PROFILE",
                     "PARTIAL_CIRCULAR_SHAPE_PROFILE", "RECTANGULAR_OPEN_SHAPE_PROFILE", "CATALOGUE_THREAD",
                     "DEFINED_THREAD", "CHAMFER", "REGION_PROJECTION");
}

Members::Members(Context& context, const Frame& turn) : context_(&context), turn_(turn) {
  for (const char* keyword : {"COMPOUND_FEATURE", "COUNTERBORE_HOLE", "COUNTERSUNK_HOLE"}) {
    for (const Node& compound : nodes_called(context.file, keyword)) {
      try {
        for (const Node& element : elements_of(compound)) compound_of_.emplace(element.id(), compound);
      } catch (const InputError&) {
        // of() reports it where the compound is cut.
      }
    }
  }
}

/// The frame that the feature's placement is given in.
Frame Members::space_of(const Node& feature, int depth) const {
  const auto compound = compound_of_.find(feature.id());
  if (compound == compound_of_.end()) return turn_;
  if (depth > kDeepestPattern)
    feature.fail("compounds are nested more than 8 deep (or in a circle); flatten them");
  return composed(space_of(compound->second, depth + 1), frame_of(compound->second.ref(3)));
}

std::vector<Member> Members::of(const Node& feature) const {
  Expansion expansion(*context_);
  const Frame space = space_of(feature, 0);
  expansion.expand(feature, space, placed(space, feature), "", 0);
  return std::move(expansion.members);
}

}  // namespace clearcut::read::stepnc
