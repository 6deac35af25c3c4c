// From groups of curves at one depth to the Part: what DXF and SVG have in common.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/part.h"
#include "read/common/read_options.h"
#include "read/repair/repair.h"

namespace clearcut::read {

/// What a name of a layer says about its outlines; see docs/input.md.
struct LayerMeaning {
  LayerRole role = LayerRole::kPocket;
  bool says_role = false;       ///< a word of the name does
  std::optional<double> depth;  ///< in units of the drawing
  bool depth_in_mm = false;     ///< the name says so: "POCKET 6MM"
  std::optional<double> top;    ///< in units of the drawing
  std::optional<double> start;  ///< of V-carving, likewise
  std::optional<double> width;  ///< of isolation, likewise
  std::optional<HoleRequest> hole;
};
/// "POCKET_D5" is a depth of 5, and so are "POCKET 5mm", "5MM POCKET" and "POCKET-5" of pockets, profiles and lines; "TOP-2" a top of -2, "ISLAND" or "BOSS" an island, "HOLE" or "DRILL" round
/// holes (see hole_words.h), "PROFILE", "CUTOUT", "OUTLINE" or "OUTSIDE" what is cut out along its outside, "INSIDE" along its inside, "ENGRAVE" or "ON" a
/// line to follow, "VCARVE" what a V-bit carves (its depth is a limit), "ISOLATE" what stays with a band about it milled, as wide as "W0.4" says, "CHAMFER" or "DEBURR" edges to break, "FACE", "STOCK", "IGNORE", "CONSTRUCTION", "DIM..." or "DEFPOINTS" nothing to mill. Any case; words end at
/// anything but letters.
LayerMeaning meaning_of_layer(std::string_view name);
/// The same of the kind in `--op KIND:SELECTION`, where "STEP" says more than in the name of a layer.
LayerMeaning meaning_of_kind(std::string_view kind);
/// A pocket, or a step in one.
constexpr bool is_pocket(LayerRole role) {
  return role == LayerRole::kPocket || role == LayerRole::kStep;
}
/// Whether `name` matches `pattern`: case is ignored, * stands for anything.
bool matches(std::string_view pattern, std::string_view name);

/// Curves that share a depth.
struct DrawnGroup {
  std::string name;   ///< layer, or colour
  std::string where;  ///< file and layer: begins messages
  LayerRole role = LayerRole::kPocket;
  bool says_role = false;                      ///< somebody said it: the name, a rule, an option
  std::optional<double> depth;                 ///< mm
  std::optional<double> top;                   ///< mm
  double start = 0;                            ///< mm; of V-carving: how far down its outline is as drawn
  std::optional<double> width = {};            ///< mm; of the band about what is isolated
  std::optional<LayerRule> broken_edges = {};  ///< its outlines get a chamfer besides
  std::optional<HoleRequest> hole = {};
  bool has_pens = false;  ///< lines of it are drawn with a width, which was not asked to count
  std::vector<RawCurve> curves;
};

/// Lets the first rule that matches `name` overrule what the group took from its name.
void apply_rules(const std::vector<LayerRule>& rules, const std::string& name, DrawnGroup& group);

/// How many entities were left out, by name.
using LeftOut = std::map<std::string, int>;
/// "2 IMAGE, 1 3DFACE on layer D5"; "" for nothing.
std::string listed(const LeftOut& left_out);
/// Says what of `file` was left out, if anything; `what` ends in a colon.
void report_left_out(Diagnostics& diagnostics, const std::string& file, const LeftOut& left_out,
                     const std::string& what);

/// Throws InputError where the user is to be asked and the drawing is larger than 2 m or smaller than 1 mm.
void question_size(const std::vector<DrawnGroup>& groups, const std::string& file,
                   const ReadOptions& options);

/// Repairs every group and makes one closed pocket (or round hole) of every region, shallow ones first,
/// each with one roughing (drilling) workingstep. Islands' groups are cut out of all others; profiles come last, inner ones
/// first. Throws InputError when nothing is left, a depth is missing, or it is unclear what the outermost outline is.
void add_drawn_features(Part& part, std::vector<DrawnGroup> groups, const ReadOptions& options);

/// The diameter when the region is one full circle.
std::optional<double> circle_diameter(const Region& region, const Tolerances& tol);

/// `length`, mm, that `what` names; throws InputError at `place` unless it lies above 0 and below a kilometre.
double checked_length(double length, const std::string& what, const std::string& place);
/// `depth`, mm; throws InputError at `place` unless it lies above 0 and below a kilometre.
double checked_depth(double depth, const std::string& place);

/// Appends the features, each with its workingstep; names that are taken get a number. Cost O(features).
void add_features(Part& part, std::vector<Feature> features);

}  // namespace clearcut::read
