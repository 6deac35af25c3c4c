// From curves as a file holds them to valid regions, the one repair of every reader, and the list of mends of one
// kind: each with place and size, long lists cut short with their largest.
#pragma once

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/diagnostics.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "geometry/region.h"
#include "geometry/vec2.h"
#include "options/read_options.h"

namespace clearcut::read {

/// Lengths with enough digits for small values: "0.0125", "1.3e-09".
std::string short_number(double value);
/// "(10.5, -3)".
std::string place_text(Vec2 p);

/// Collects mends of one kind and reports them in order of happening.
class Mends {
 public:
  explicit Mends(std::string what) : what_(std::move(what)) {}
  void add(Vec2 place, double size) { mends_.push_back({place, size}); }
  bool empty() const { return mends_.empty(); }
  /// One diagnostic each, "<where> at (x, y)": "<what> of <size> mm"; after the first 100 a single one for the rest.
  void report(const std::string& where, Diagnostics& diagnostics) const;

 private:
  struct Mend {
    Vec2 place;
    double size = 0;
  };
  std::string what_;
  std::vector<Mend> mends_;
};

/// Curves filled together are an area of their own, regardless of crossings (SVG paths).
struct Compound {
  int number = 0;
  bool nonzero = true;     ///< filled by the nonzero winding rule; else even-odd
  std::string paint = {};  ///< its colour: partly overlapping fills of one colour are one area
  friend bool operator==(const Compound&, const Compound&) = default;
  // Texts have no three-way comparison in every standard library (emscripten's).
  friend bool operator<(const Compound& a, const Compound& b) {
    return std::tie(a.number, a.nonzero, a.paint) < std::tie(b.number, b.nonzero, b.paint);
  }
};

/// A curve as read, without guarantees: ends may miss each other, edges may have no length,
/// centers may be wrong, numbers may be infinite.
struct RawCurve {
  Path edges;
  bool closed = false;  ///< the file declares the curve as closed
  std::string source;   ///< "line 120", "outer": for messages
  std::optional<Compound> compound = {};
};

/// mm. Coordinates beyond this (1 km) are taken for a mistake and refused.
inline constexpr double kLargestCoordinate = 1e6;

/// An outline crossing itself or another beyond repair, and the message of refusal.
struct CrossingOutline {
  RawCurve curve;
  InputError refusal;
};

struct RepairOptions {
  Tolerances tol;
  std::string where;  ///< file, or file and layer: begins every message
  OpenCurves open_curves = OpenCurves::kRefuse;
  bool find_arcs = false;
  bool has_pens = false;  ///< lines have a width that can be requested: mentioned in messages
  /// If given, receives self-crossing outlines, and the smaller of two crossing ones; else they are refused.
  std::vector<CrossingOutline>* crossing = nullptr;
  bool may_be_empty = false;  ///< outlines without area give no regions, instead of an error
};

/// Alternative use of lines other than as outlines, for the end of a message: ", or ...".
std::string other_use_of_lines(const RepairOptions& options);

/// Shape   regions with disjoint interiors by the even-odd rule, to any depth of nesting: a loop in a
///         pocket is an island, a loop in an island is a pocket again. Valid by construction, and checked.
/// Units   mm.
/// Error   boundaries move by at most tol.join_gap, and less than 1 um without mends.
/// Throws  InputError, one line with the place, for input beyond repair: numbers not finite or above 1e6 mm, gaps
///         above tol.join_gap, outlines crossing themselves or each other by more than a sliver.
/// Cost    O(n log n) for n edges of ordinary drawings.
/// Every mend is listed in `diagnostics` with its place and size.
Regions repair(std::vector<RawCurve> curves, const RepairOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
