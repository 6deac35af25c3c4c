// What the user may say about a file that does not say it itself.
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
#include "options/input_options.h"

namespace clearcut::read {

/// How an open curve that no other curve closes is treated.
enum class OpenCurves {
  kRefuse,  ///< InputError naming the place: a wall may be missing
  kSkip     ///< left out and reported
};

/// What the outlines of a layer are.
enum class LayerRole {
  kPocket,
  kIsland,
  kHole,
  kIgnore,
  kProfile,  ///< cut out along the outside; outlines within are cut out along their inside, and so on
  kInside,   ///< the same the other way round
  kEngrave,  ///< the cutter's centre on the line; lines may be open
  kChamfer,
  kFace,
  kStock,    ///< the block that it is made of
  kVCarve,   ///< carved with a V-bit between the outlines
  kIsolate,  ///< what is drawn stays, and a band about every piece of it is milled: copper of a circuit board
  kStep,     ///< a pocket whose floor stays where deeper pockets reach over it
  kTSlot     ///< a slot with an undercut along the line; lines may be open
};

/// What the user says about the layers (DXF) or colours (SVG, "#ff0000") that match a pattern; goes before
/// what their names say. The first matching rule counts. A pattern that no layer matches may also be "outer" or
/// numbers of outlines, "2,5".
struct LayerRule {
  std::string pattern;  ///< name, * for anything, any case
  std::optional<LayerRole> role;
  std::optional<double> depth;  ///< mm
  std::optional<double> top;    ///< mm
  bool asked = false;           ///< as an option: has to match, and other rules say what it leaves open
  std::optional<HoleRequest> hole = {};
  std::optional<double> width = {};  ///< mm; of the band about what is isolated
};

/// A closed outline of a drawing as a person sees it.
struct OutlineSummary {
  int number = 0;  ///< from 1, as in `--op profile:3`
  std::string layer;
  std::string role;
  bool says_role = false;       ///< somebody said it; else it is how the outline is read by itself
  std::optional<double> depth;  ///< mm
  Box box;
  Loop loop;                       ///< itself, mm; the way around is the one it was drawn
  double area = 0;                 ///< mm2, islands not taken out
  std::optional<double> diameter;  ///< of circles
  int within = 0;                  ///< number of the outline right around it; 0: none
};

/// An option of the command that answers a question: "--op" and "profile:outer".
struct DrawingAnswer {
  std::string option, value;
};

/// What is to be asked of a drawing.
struct DrawingQuestion {
  std::string where;  ///< file and layer
  std::string text;
  std::vector<DrawingAnswer> answers;  ///< that there are, as the text names them
};

/// What a drawing holds, whatever is still to be said about it.
struct DrawingOverview {
  std::vector<OutlineSummary> outlines;
  int lines = 0;                       ///< to engrave
  bool lines_have_depths = true;       ///< all of these
  std::string question;                ///< what a plan would ask; "" if nothing
  std::vector<DrawingAnswer> answers;  ///< to it
  std::string missing;  ///< without a question: what a plan would refuse, as a depth that nothing says
};

/// The material that a job states, where it differs from the solid's own box. mm.
struct StockRequest {
  std::optional<std::array<double, 2>> x, y;  ///< lowest and highest; absent: the solid with the margin
  double margin = 0;
  std::array<double, 2> z{};  ///< bottom and top
};

/// mm. How far through cuts and through holes go below the solid.
inline constexpr double kBreakthrough = 0.5;

/// What is said about a solid (STEP) alone.
struct SolidOptions {
  std::string up;       ///< which side looks up: +Z, -Z, +X, -X, +Y, -Y or face12; "": as it lies
  double turn_deg = 0;  ///< counter-clockwise about the vertical, after that
  std::string body;     ///< name or number from 1 of the body to make; "all": all as one part
  std::optional<double> breakthrough;  ///< mm, >= 0; absent: kBreakthrough
  std::vector<double> drills;          ///< mm; diameters at hand, beside those of `tools`
  /// At hand. Through holes of a drill's width go deeper by its point; edges broken as a cone leans, and fillets as round as a
  /// cutter's end, are features.
  std::vector<Tool> tools = {};
  std::optional<StockRequest> stock;  ///< absent: the solid's bounding box
  bool has_other_setups = false;      ///< of the same job: they make what looks another way
  bool is_stock =
      false;  ///< it is what something is made of: how it lies and that it may be a full block are no questions
};

struct ReadOptions {
  std::optional<std::string> unit;  ///< "mm", "cm", "m", "in", "pt", "px", ...: overrides the file's own
  std::optional<double> depth;      ///< mm, > 0: overrides every depth in the file
  std::optional<double> depth_if_missing;  ///< mm, > 0: assumed, with a warning, where the file says nothing
  std::optional<double> top;               ///< mm: z of the drawing's plane
  std::vector<std::string> layers;  ///< only these layers of a drawing (names or patterns with *); empty: all
  std::vector<LayerRule> layer_rules;
  std::optional<OpenCurves> open_curves;  ///< absent: refused
  std::optional<bool>
      stroke_areas;  ///< strokes of an SVG are areas of their width; default: lines without any
  std::optional<bool> text_outlines;  ///< letters of a drawing are outlines; default: left out
  std::optional<double> join_gap;     ///< mm; overrules tol.join_gap
  bool ask_if_unclear = false;  ///< drawings of unclear meaning or odd size are refused with what to say
  double scale = 1;             ///< of drawings, after units
  bool mirror = false;          ///< drawings are mirrored left to right: seen from below
  bool scale_is_right = false;  ///< the size was stated: it is not questioned
  /// Filled in where given; then no depth is needed, and what is unclear or open is listed instead of refused.
  DrawingOverview* overview = nullptr;
  std::optional<bool> find_arcs;  ///< find arcs again in runs of short lines; default: drawings yes, JSON no
  SolidOptions solid;
  std::optional<Stock> block;  ///< what the part is made of; a file that states another is refused
  Tolerances tol;
};

}  // namespace clearcut::read
