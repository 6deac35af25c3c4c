#include "read/step_solid/orientation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/text.h"
#include "read/common/text.h"
#include "read/step_solid/step_solid.h"

namespace clearcut::read {
namespace {

/// Height and length over thickness from which on a sheet on its edge counts as a mistake.
constexpr double kSheet = 5;
/// Sides tried for a proposal, as many as a box has beside its top: each costs the kernel's reading anew.
constexpr int kMostTries = 5;
/// Bodies named one by one before the rest is counted.
constexpr std::size_t kMostBodies = 12;

std::string size_text(double a, double b) {
  return trimmed(a, 3) + " x " + trimmed(b, 3);
}

std::string name_and_size(const SolidBody& body) {
  return (body.name.empty() ? std::string("without a name") : "'" + body.name + "'") + " (" +
         trimmed(body.width, 1) + " x " + trimmed(body.depth, 1) + " x " + trimmed(body.height, 1) + ")";
}

/// "1 'PLATE' (180 x 150 x 20), 2, 5 'BOLT' (...)": bodies of one name and size together.
std::string listed(const std::vector<SolidBody>& bodies) {
  std::vector<std::pair<std::string, std::string>> groups;  // name and size, numbers
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string text = name_and_size(bodies[i]);
    const auto [at, fresh] = known.try_emplace(text, groups.size());
    if (fresh) groups.emplace_back(text, "");
    std::string& numbers = groups[at->second].second;
    numbers += (numbers.empty() ? "" : ", ") + std::to_string(i + 1);
  }
  std::string out;
  for (std::size_t i = 0; i < std::min(groups.size(), kMostBodies); ++i)
    out += (i ? "; " : "") + groups[i].second + " " + groups[i].first;
  if (groups.size() > kMostBodies)
    out += "; and " + std::to_string(groups.size() - kMostBodies) + " more kinds";
  return out;
}

/// A name common to several bodies may be no valid choice.
std::string example_of(const std::vector<SolidBody>& bodies) {
  const std::string& name = bodies.front().name;
  const auto named_so = std::count_if(bodies.begin(), bodies.end(), [&](const SolidBody& body) {
    return capitals(body.name) == capitals(name);
  });
  return name.empty() || named_so > 1 ? "1" : "\"" + name + "\"";
}

/// Flat area in one axis direction or its opposite, and the better of both: more heights, then larger.
struct FlatPair {
  double area = 0;
  const FlatSide* better = nullptr;
};

FlatPair flat_along(const SolidModel& solid, char axis) {
  FlatPair pair;
  for (const FlatSide& side : solid.sides) {
    if (side.up.size() != 2 || side.up[1] != axis) continue;
    pair.area = std::max(pair.area, side.area);
    if (!pair.better || side.heights > pair.better->heights) pair.better = &side;
  }
  return pair;
}

bool leans(const FlatSide& side) {
  return side.up.rfind("face", 0) == 0;
}

/// The largest side or the one opposite to it: the one with more heights, then the more upward one.
const FlatSide& better_of_largest(const SolidModel& solid) {
  constexpr double kSame = 1e-4;  // degrees, mm
  const FlatSide& largest = solid.sides.front();
  const FlatSide* better = &largest;
  for (const FlatSide& other : solid.sides) {
    const bool is_opposite = std::abs(other.lean + largest.lean - 180) < kSame &&
                             std::abs(other.thickness - largest.thickness) < kSame;
    if (!is_opposite || !leans(other) || other.heights < better->heights) continue;
    if (other.heights > better->heights || other.lean < better->lean) better = &other;
  }
  return *better;
}

/// A sheet on its edge, in both interpretations; `upright`, `flat`: thickness of material for milling as in the file
/// and lying flat, "" if not known.
struct SheetOnEdge {
  double thickness = 0, height = 0;  // mm
  std::string upright, flat;
  std::string up;  ///< side up when lying flat
};

std::string reading(const std::string& how, bool offered, double depth, const std::string& out_of,
                    const std::string& option) {
  if (!offered) return how + " no floor looks up and nothing goes through";
  return how + " it is milled " + trimmed(depth, 3) + " mm deep" + out_of + " (" + option + ")";
}

/// Only sides with something to mill are named; if neither is one, the sheet is not questioned.
void refuse_edge(const std::string& file_name, const SheetOnEdge& sheet, const OffersFloors& offers) {
  const bool upright = offers("+Z"), flat = offers(sheet.up);
  if (!upright && !flat) return;
  throw InputError(
      file_name, "a sheet of " + trimmed(sheet.thickness, 3) + " mm stands on its edge: " +
                     reading("as it lies", upright, sheet.height, sheet.upright, "--up +Z if that is meant") +
                     "; " + reading("lying flat", flat, sheet.thickness, sheet.flat, "--up " + sheet.up));
}

/// A sheet on its edge, turned about the vertical.
void refuse_turned_sheet(const SolidModel& solid, const std::string& file_name, const OffersFloors& offers) {
  constexpr double kUpright = 0.01;  // degrees
  if (solid.bodies.size() != 1 || solid.sides.empty()) return;
  const FlatSide& side = better_of_largest(solid);
  const double height = solid.z_top - solid.z_bottom;
  if (!leans(side) || std::abs(side.lean - 90) > kUpright || !(side.thickness > 0)) return;
  if (height < kSheet * side.thickness || side.area < kSheet * side.thickness * height) return;
  refuse_edge(file_name, {side.thickness, height, "", "", side.up}, offers);
}

}  // namespace

void refuse_assembly(const SolidModel& solid, const std::string& file_name) {
  if (!solid.faces.empty()) return;
  throw InputError(file_name,
                   "an assembly of " + std::to_string(solid.bodies.size()) +
                       " bodies; choose the one to make by name or number, for example --body " +
                       example_of(solid.bodies) +
                       ", or take all as one part with --body all. Bodies: " + listed(solid.bodies));
}

void refuse_sheet_on_edge(const SolidModel& solid, const std::string& file_name, const OffersFloors& offers) {
  refuse_turned_sheet(solid, file_name, offers);
  // As in the file: the turn about the vertical does not change heights.
  const SolidBody& body = solid.bodies.front();
  const double height = solid.z_top - solid.z_bottom;
  const bool along_x = body.width < body.depth;
  const double thickness = along_x ? body.width : body.depth, across = along_x ? body.depth : body.width;
  if (solid.bodies.size() != 1 || height < kSheet * thickness || across < kSheet * thickness) return;
  const FlatPair flat = flat_along(solid, along_x ? 'X' : 'Y');
  if (!flat.better || flat.area < solid.sides.front().area) return;
  refuse_edge(file_name,
              {thickness, height, " out of " + size_text(body.width, body.depth) + " mm",
               " out of " + size_text(across, height) + " mm", flat.better->up},
              offers);
}

void refuse_askew(const SolidModel& solid, const std::string& file_name) {
  const bool has_level = std::any_of(solid.faces.begin(), solid.faces.end(), [](const SolidFace& face) {
    return face.level && face.facing == Facing::kUp;
  });
  if (has_level || solid.sides.empty() || !leans(solid.sides.front())) return;
  const FlatSide& side = better_of_largest(solid);
  throw InputError(file_name, "nothing flat looks up: the solid lies askew, its largest flat side (" +
                                  trimmed(side.area, 1) + " mm2) looks " + trimmed(side.lean, 4) +
                                  " degrees away from +Z; turn the solid with --up " + side.up +
                                  " (--up +Z if it is meant as it lies)");
}

void refuse_without_floor(const SolidModel& solid, const std::string& file_name, const std::string& up,
                          const std::string& why, const OffersFloors& offers) {
  const std::string what = why + "; ";
  std::string tried;
  int tries = 0;
  for (const FlatSide& side : solid.sides) {
    if (side.up == (up.empty() ? "+Z" : up)) continue;
    if (++tries > kMostTries) break;
    if (offers(side.up))
      throw InputError(file_name, what + "the largest flat side that has some is " + side.up + " (" +
                                      trimmed(side.area, 1) + " mm2 flat): turn the solid with --up " +
                                      side.up);
    tried += (tried.empty() ? "" : ", ") + side.up;
  }
  if (tries > kMostTries)
    throw InputError(file_name,
                     what + "nor from its largest flat sides (" + tried + "); name another with --up");
  throw InputError(file_name, what +
                                  (tried.empty() ? "it has no other flat side to be milled from"
                                                 : "nor from its other flat sides (" + tried + ")") +
                                  ": only flat floors and upright walls are milled here, no free surfaces");
}

// Recognises Part 21 files with a solid, only by their text.

namespace {

/// Whether entities of the file, in capitals, make faces and none a program.
bool holds_faces_alone(const std::string& text) {
  if (text.find("WORKPLAN") != std::string::npos) return false;
  return text.find("ADVANCED_FACE") != std::string::npos || text.find("FACETED_BREP") != std::string::npos;
}

}  // namespace

bool is_step_solid(std::string_view text) {
  const std::string head = capitals(std::string(text.substr(0, 65536)));
  const std::size_t at = head.find("FILE_SCHEMA");
  if (at == std::string::npos) return false;
  const std::string schema = head.substr(at, head.find(';', at) - at);
  for (const char* name : {"AUTOMOTIVE_DESIGN", "CONFIG_CONTROL_DESIGN", "AP203", "AP214", "AP242"})
    if (schema.find(name) != std::string::npos) return true;
  if (schema.find("MACHINING") != std::string::npos || schema.find("CNC") != std::string::npos) return false;
  return holds_faces_alone(capitals(std::string(text)));
}

}  // namespace clearcut::read
