// User's options for data missing in a file.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "geometry/box.h"
#include "geometry/region.h"
#include "model/hole.h"
#include "model/part.h"
#include "options/plan_options.h"

namespace clearcut::inline options {

/// Treatment of open curves not closed by other curves.
enum class OpenCurves {
  kRefuse,  ///< InputError naming the place: a wall may be missing
  kSkip     ///< left out and reported
};

/// Role of the outlines of a layer.
enum class LayerRole {
  kPocket,
  kIsland,
  kHole,
  kIgnore,
  kProfile,  ///< cut out along the outside; outlines within are cut out along their inside, and so on
  kInside,   ///< the reverse
  kEngrave,  ///< the cutter's centre on the line; lines may be open
  kChamfer,
  kFace,
  kStock,    ///< the stock block
  kVCarve,   ///< carved with a V-bit between the outlines
  kIsolate,  ///< the drawn areas remain, and a band around every piece is milled: copper of a circuit board
  kStep,     ///< a pocket whose floor remains if deeper pockets overlap it
  kTSlot     ///< a slot with an undercut along the line; lines may be open
};

/// A pocket, or a step in one.
constexpr bool is_pocket(LayerRole role) {
  return role == LayerRole::kPocket || role == LayerRole::kStep;
}

/// A user's rule for the layers (DXF) or colours (SVG, "#ff0000") that match a pattern; it takes precedence over
/// their names. The first matching rule counts. A pattern without matching layer may also be "outer" or numbers of
/// outlines, "2,5".
struct LayerRule {
  std::string pattern;  ///< name, * for anything, any case
  std::optional<LayerRole> role;
  std::optional<double> depth;  ///< mm
  std::optional<double> top;    ///< mm
  bool asked = false;           ///< given as an option: must match, and other rules fill its absent values
  std::optional<HoleRequest> hole = {};
  std::optional<double> width = {};  ///< mm; width of the band around isolated areas
};

/// A closed outline of a drawing as a person sees it.
struct OutlineSummary {
  int number = 0;  ///< from 1, as in `--op profile:3`
  std::string layer;
  std::string role;
  bool says_role = false;       ///< the role was stated; else it is the default interpretation of the outline
  std::optional<double> depth;  ///< mm
  Box box;
  Loop loop;                       ///< the outline itself, mm; in the sense of rotation as drawn
  double area = 0;                 ///< mm2, islands not taken out
  std::optional<double> diameter;  ///< diameter of circles
  int within = 0;                  ///< number of the next enclosing outline; 0: none
};

/// An option of the command answering a question: "--op" and "profile:outer".
struct DrawingAnswer {
  std::string option, value;
};

/// A question to the user about a drawing.
struct DrawingQuestion {
  std::string where;  ///< file and layer
  std::string text;
  std::vector<DrawingAnswer> answers;  ///< possible answers, in the order of the text
};

/// Content of a drawing, even with open questions.
struct DrawingOverview {
  std::vector<OutlineSummary> outlines;
  int lines = 0;                       ///< number of lines to engrave
  bool lines_have_depths = true;       ///< all of these
  std::string question;                ///< question asked by a plan; "" if none
  std::vector<DrawingAnswer> answers;  ///< answers to the question
  /// Without a question: reason for which a plan would be refused, for example an unstated depth.
  std::string missing;
};

/// The stock stated in a job, if it differs from the solid's own box. mm.
struct StockRequest {
  std::optional<std::array<double, 2>> x, y;  ///< lowest and highest; absent: the solid with the margin
  double margin = 0;
  std::array<double, 2> z{};  ///< bottom and top
};

/// mm. Depth of through cuts and through holes below the solid, or below the stock of a drawing.
inline constexpr double kBreakthrough = 0.5;

/// Options only for a solid (STEP).
struct SolidOptions {
  std::string up;       ///< side that faces up: +Z, -Z, +X, -X, +Y, -Y or face12; "": as in the file
  double turn_deg = 0;  ///< counter-clockwise about the vertical, afterwards
  std::string body;     ///< name or number from 1 of the body to make; "all": all as one part
  std::optional<double> breakthrough;  ///< mm, >= 0; absent: kBreakthrough
  std::vector<double> drills;          ///< mm; diameters at hand, beside those of `tools`
  /// At hand. Through holes of a drill's width go deeper by its point; edges broken as a cone leans, and fillets as
  /// round as a cutter's end, are features.
  std::vector<Tool> tools = {};
  std::optional<StockRequest> stock;  ///< absent: the solid's bounding box
  /// The same job has other set-ups: they cut faces with other directions.
  bool has_other_setups = false;
  /// The solid is a stock: its orientation and a possible full block are not questioned.
  bool is_stock = false;
};

struct ReadOptions {
  std::optional<std::string> unit;  ///< "mm", "cm", "m", "in", "pt", "px", ...: overrides the file's own
  std::optional<double> depth;      ///< mm, > 0: overrides every depth in the file
  std::optional<double> depth_if_missing;  ///< mm, > 0: assumed, with a warning, if the file states none
  std::optional<double> top;               ///< mm: z of the drawing's plane
  std::vector<std::string> layers;  ///< only these layers of a drawing (names or patterns with *); empty: all
  std::vector<LayerRule> layer_rules;
  std::optional<OpenCurves> open_curves;  ///< absent: refused
  /// Strokes of an SVG are areas of their width; default: lines without any.
  std::optional<bool> stroke_areas;
  std::optional<bool> text_outlines;  ///< letters of a drawing are outlines; default: left out
  std::optional<double> join_gap;     ///< mm; overrules tol.join_gap
  /// Drawings of unclear meaning or odd size are refused with the possible answers.
  bool ask_if_unclear = false;
  double scale = 1;             ///< scale of drawings, after conversion of units
  bool mirror = false;          ///< drawings are mirrored left to right: seen from below
  bool scale_is_right = false;  ///< the size was stated and is not questioned
  /// Filled in if given; then no depth is needed, and unclear or open outlines are listed instead of refused.
  DrawingOverview* overview = nullptr;
  std::optional<bool> find_arcs;  ///< find arcs again in runs of short lines; default: drawings yes, JSON no
  SolidOptions solid;
  std::optional<Stock> block;  ///< stock block of the part; a file stating another one is refused
  Tolerances tol;
};

}  // namespace clearcut::inline options
