#include "resolve/values/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "base/error.h"
#include "options/value.h"

namespace clearcut::resolve {
namespace {

/// The value named `name` among several.
template <typename Value, std::size_t kCount>
Value named(const std::array<Value, kCount>& values, const std::string& name, const std::string& place) {
  std::string known;
  for (const Value value : values) {
    if (name == name_of(value)) return value;
    known += (known.empty() ? "" : ", ") + std::string(name_of(value));
  }
  throw InputError(place, "'" + name + "' is unknown; use one of " + known);
}

/// Whether `name` is the published one, and not Clearcut's own.
bool is_first(const std::string& published, const std::string& ours, const std::string& name,
              const std::string& place) {
  if (name != published && name != ours)
    throw InputError(place, "'" + name + "' is unknown; use one of " + published + ", " + ours);
  return name == published;
}

struct StepNcName {
  const char* theirs;
  const char* ours;
};

/// Strategies of ISO 14649-11. Strokes in only one direction are not supported: they are cut in both directions, and
/// the reader reports this. Clearcut's strategies end with a pass along the walls, as required by
/// bidirectional_contour.
constexpr StepNcName kStepNcNames[] = {
    {"contour_parallel", "contour"},     {"contour_spiral", "spiral"}, {"bidirectional", "zigzag"},
    {"bidirectional_milling", "zigzag"}, {"unidirectional", "zigzag"}, {"unidirectional_milling", "zigzag"},
    {"bidirectional_contour", "zigzag"},
};

}  // namespace

const StrategyEntry* strategy_named(const std::string& name, const StrategyTable& strategies,
                                    const std::string& place) {
  if (name == "auto") return nullptr;
  if (const StrategyEntry* entry = strategies.find(name)) return entry;
  std::vector<std::string> names{"auto"};
  for (const StrategyEntry& entry : strategies.entries()) names.push_back(entry.name);
  const std::string meant = nearest_name(name, names);
  const std::string hint = meant.empty() ? "" : "did you mean '" + meant + "'? ";
  const std::string what = place == "--strategy" ? "" : "strategy ";  // the place already contains this word
  throw InputError(
      place, fmt::format("{}'{}' is unknown; {}use one of {}", what, name, hint, fmt::join(names, ", ")));
}

std::string strategy_of_stepnc(const std::string& name) {
  for (const StepNcName& one : kStepNcNames)
    if (name == one.theirs) return one.ours;
  return "";
}

EntryKind entry_named(const std::string& name, const std::string& place) {
  return named(std::array{EntryKind::kHelix, EntryKind::kRamp, EntryKind::kZigzagRamp, EntryKind::kPlunge},
               name, place);
}

Coolant coolant_named(const std::string& name, const std::string& place) {
  return named(std::array{Coolant::kOff, Coolant::kFlood, Coolant::kMist, Coolant::kBoth}, name, place);
}

CutDirection direction_named(const std::string& name, const std::string& place) {
  return named(std::array{CutDirection::kClimb, CutDirection::kConventional}, name, place);
}

const char* name_of(CutDirection direction) {
  return direction == CutDirection::kClimb ? "climb" : "conventional";
}

const char* name_of(FeedBy by) {
  return by == FeedBy::kChip ? "chip" : "removal";
}

ContourOrder order_named(const std::string& name, const std::string& place) {
  return named(std::array{ContourOrder::kInsideOut, ContourOrder::kOutsideIn}, name, place);
}

const char* name_of(ContourOrder order) {
  return order == ContourOrder::kInsideOut ? "inside-out" : "outside-in";
}

const char* name_of(Finish finish) {
  switch (finish) {
    case Finish::kNone:
      return "none";
    case Finish::kWalls:
      return "walls";
    case Finish::kFloor:
      return "floor";
    case Finish::kAll:
      break;
  }
  return "all";
}

TabShape tab_shape_named(const std::string& name, const std::string& place) {
  return named(std::array{TabShape::kSquare, TabShape::kTriangular}, name, place);
}

const char* name_of(TabShape shape) {
  return shape == TabShape::kSquare ? "square" : "triangular";
}

bool is_bisector_passage(const std::string& name, const std::string& place) {
  return is_first("bisector", "shortest", name, place);
}

bool is_reflex_corner(const std::string& name, const std::string& place) {
  return is_first("corner", "round", name, place);
}

bool is_published_grid(const std::string& name, const std::string& place) {
  return is_first("published", "ours", name, place);
}

bool is_published_solver(const std::string& name, const std::string& place) {
  return is_first("published", "modern", name, place);
}

}  // namespace clearcut::resolve
