// From groups of curves at one depth to the Part, common to DXF and SVG, and the conditions for items read
// differently than drawn, or not read at all.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/part.h"
#include "options/read_options.h"
#include "read/repair/repair.h"

namespace clearcut::read {

/// The condition for all items read differently than drawn, docs/conditions.md.
inline constexpr const char* kNotAsDrawn = "not-as-drawn";
/// The condition for items of the input not made by the program.
inline constexpr const char* kLeftOut = "left-out";

/// Meaning of a layer's name for its outlines; see docs/input.md.
struct LayerMeaning {
  LayerRole role = LayerRole::kPocket;
  bool says_role = false;       ///< a word of the name does
  std::optional<double> depth;  ///< in units of the drawing
  bool depth_in_mm = false;     ///< stated in the name: "POCKET 6MM"
  std::optional<double> top;    ///< in units of the drawing
  std::optional<double> start;  ///< start depth of V-carving, likewise
  std::optional<double> width;  ///< width of isolation, likewise
  std::optional<HoleRequest> hole;
};
/// "POCKET_D5" is a depth of 5, and so are "POCKET 5mm", "5MM POCKET" and "POCKET-5" of pockets, profiles and lines;
/// "TOP-2" a top of -2, "ISLAND" or "BOSS" an island, "HOLE" or "DRILL" round holes (see hole_words.h), "PROFILE",
/// "CUTOUT", "OUTLINE" or "OUTSIDE" a shape cut out along its outside, "INSIDE" along its inside, "ENGRAVE" or "ON" a
/// line to follow, "VCARVE" an area carved by a V-bit (its depth is a limit), "ISOLATE" an area that remains with a
/// band milled around it, of the width in "W0.4", "CHAMFER" or "DEBURR" edges to break, "FACE", "STOCK", "IGNORE",
/// "CONSTRUCTION", "DIM..." or "DEFPOINTS" nothing to mill. Any case; words end at anything but letters.
LayerMeaning meaning_of_layer(std::string_view name);
/// The same of the kind in `--op KIND:SELECTION`, in which "STEP" has a meaning not used in names of layers.
LayerMeaning meaning_of_kind(std::string_view kind);
/// Whether `name` matches `pattern`: case is ignored, * matches any text.
bool matches(std::string_view pattern, std::string_view name);

/// Curves of one depth.
struct DrawnGroup {
  std::string name;   ///< layer, or colour
  std::string where;  ///< file and layer: begins messages
  LayerRole role = LayerRole::kPocket;
  bool says_role = false;                      ///< the role is stated by the name, a rule, or an option
  std::optional<double> depth;                 ///< mm
  std::optional<double> top;                   ///< mm
  double start = 0;                            ///< mm; for V-carving: depth at which its outline is as drawn
  std::optional<double> width = {};            ///< mm; width of the band around isolated areas
  std::optional<LayerRule> broken_edges = {};  ///< its outlines get a chamfer besides
  std::optional<HoleRequest> hole = {};
  bool has_pens = false;  ///< some of its lines are drawn with a width that was not requested to count
  std::vector<RawCurve> curves;
};

/// Lets the first rule matching `name` override the values taken from the group's name.
void apply_rules(const std::vector<LayerRule>& rules, const std::string& name, DrawnGroup& group);

/// Number of entities left out, by name.
using LeftOut = std::map<std::string, int>;
/// "2 IMAGE, 1 3DFACE on layer D5"; "" for nothing.
std::string listed(const LeftOut& left_out);
/// Reports the parts of `file` left out, if any; `what` ends in a colon.
void report_left_out(Diagnostics& diagnostics, const std::string& file, const LeftOut& left_out,
                     const std::string& what);

/// Throws InputError if the user is to be asked and the drawing is larger than 2 m or smaller than 1 mm.
void question_size(const std::vector<DrawnGroup>& groups, const std::string& file,
                   const ReadOptions& options);

/// Repairs every group and makes one closed pocket (or round hole) of every region, shallow ones first, each with one
/// roughing (drilling) workingstep. Islands' groups are cut out of all others; profiles come last, inner ones first.
/// Throws InputError when nothing is left, a depth is missing, or the role of the outermost outline is unclear.
void add_drawn_features(Part& part, std::vector<DrawnGroup> groups, const ReadOptions& options);

/// The diameter when the region is one full circle.
std::optional<double> circle_diameter(const Region& region, const Tolerances& tol);

/// `length`, mm, named `what`; throws InputError at `place` unless it is above 0 and below a kilometre.
double checked_length(double length, const std::string& what, const std::string& place);
/// `depth`, mm; throws InputError at `place` unless it is above 0 and below a kilometre.
double checked_depth(double depth, const std::string& place);

/// Appends the features, each with its workingstep; names already in use get a number. Cost O(features).
void add_features(Part& part, std::vector<Feature> features);

}  // namespace clearcut::read
