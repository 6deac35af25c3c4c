// From curves as a file holds them to valid regions: the one repair of every reader.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/diagnostics.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "geometry/region.h"
#include "read/common/read_options.h"

namespace clearcut::read {

/// Curves filled together are an area of their own, whatever they cross (SVG paths).
struct Compound {
  int number = 0;
  bool nonzero = true;     ///< by the winding rule; else even-odd
  std::string paint = {};  ///< its colour: fills of one that overlap in part are one area
  friend bool operator==(const Compound&, const Compound&) = default;
  // Texts have no three-way comparison in every standard library (emscripten's).
  friend bool operator<(const Compound& a, const Compound& b) {
    return std::tie(a.number, a.nonzero, a.paint) < std::tie(b.number, b.nonzero, b.paint);
  }
};

/// A curve as a reader found it. Nothing is promised: ends may miss each other, edges may have no length,
/// centers may be wrong, numbers may be infinite.
struct RawCurve {
  Path edges;
  bool closed = false;  ///< the file says that the last end meets the first start
  std::string source;   ///< "line 120", "outer": for messages
  std::optional<Compound> compound = {};
};

/// mm. Coordinates beyond this (1 km) are taken for a mistake and refused.
inline constexpr double kLargestCoordinate = 1e6;

/// An outline that crosses itself or another beyond repair, and the refusal of it.
struct CrossingOutline {
  RawCurve curve;
  InputError refusal;
};

struct RepairOptions {
  Tolerances tol;
  std::string where;  ///< file, or file and layer: begins every message
  OpenCurves open_curves = OpenCurves::kRefuse;
  bool find_arcs = false;
  bool has_pens = false;  ///< lines have a width that can be asked for: messages say so
  /// Given, it takes the outlines that cross themselves, and the smaller of two that cross each other; else they are refused.
  std::vector<CrossingOutline>* crossing = nullptr;
  bool may_be_empty = false;  ///< what encloses nothing gives no regions, instead of an error
};

/// What else can be done with lines than to take them for outlines, for the end of a message: ", or ...".
std::string other_use_of_lines(const RepairOptions& options);

/// Shape   regions with disjoint interiors by the even-odd rule, to any depth of nesting: a loop in a
///         pocket is an island, a loop in an island is a pocket again. Valid by construction, and checked.
/// Units   mm.
/// Error   boundaries move by at most tol.join_gap, and less than 1 um where nothing was mended.
/// Throws  InputError, one line with the place, for what is beyond repair: numbers that are not finite or
///         above 1e6 mm, gaps above tol.join_gap, outlines that cross themselves or each other for more
///         than a sliver.
/// Cost    O(n log n) for n edges of ordinary drawings.
/// Every mend is listed in `diagnostics` with its place and size.
Regions repair(std::vector<RawCurve> curves, const RepairOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
