#include "post/part/stepnc_toolpaths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/elementary.h"
#include "base/tolerances.h"

namespace clearcut::post {
namespace {

constexpr double kMmPerMinOfMPerS = 60000;
constexpr double kHelixChord = 0.001;  // mm; polylines leave their helix by no more
constexpr double kHelixDigits = 1e6;   // points between the ends of a helix are rounded to 1 nm

/// Common properties of the moves of one trajectory.
struct Manner {
  const char* type = "CONTACT";
  bool is_rapid = false;
  double feed = 0;

  bool operator==(const Manner& other) const {
    return std::string_view(type) == other.type && is_rapid == other.is_rapid && feed == other.feed;
  }
};

Manner manner_of(const Move& move) {
  Manner manner;
  manner.is_rapid = is_rapid(move.kind);
  manner.feed = manner.is_rapid ? 0 : move.feed.mm_per_min();
  if (manner.is_rapid)
    manner.type = "NON_CONTACT";
  else if (move.z_to < move.z_from)
    manner.type = "APPROACH";
  else if (move.z_to > move.z_from)
    manner.type = "LIFT";
  return manner;
}

/// A range of moves.
struct Span {
  std::size_t first = 0, last = 0;
};

/// The moves without the rapids to the first descent and from the last retract: the path's reader adds these itself.
Span within_safe_height(const std::vector<Move>& moves, double safe_z) {
  const double safe = safe_z - kSamePlaceMm;
  Span span{0, moves.size()};
  while (span.first < span.last && is_rapid(moves[span.first].kind) && moves[span.first].z_to >= safe)
    ++span.first;
  while (span.last > span.first && is_rapid(moves[span.last - 1].kind) && moves[span.last - 1].z_from >= safe)
    --span.last;
  return span;
}

/// s; dwell after a move.
double dwell_after(const Section& section, std::size_t move) {
  for (const Dwell& dwell : section.dwells)
    if (dwell.after == move) return dwell.seconds;
  return 0;
}

/// The number that added to `origin` gives `value`, to the last bit if there is one.
double relative(double value, double origin) {
  const double near = value - origin;
  double low = near, high = near;
  for (int i = 0; i < 3; ++i) {
    if (origin + low == value) return low;
    if (origin + high == value) return high;
    low = std::nextafter(low, -std::numeric_limits<double>::infinity());
    high = std::nextafter(high, std::numeric_limits<double>::infinity());
  }
  return near;
}

bool is_helical(const Move& move) {
  return move.path.is_arc() && move.z_from != move.z_to;
}

}  // namespace

std::string p21_feed(MmPerMin feed) {
  const double wanted = feed.mm_per_min();
  const double close = wanted / kMmPerMinOfMPerS;
  double low = close, high = close;
  for (int i = 0; i < 4; ++i) {
    if (low * kMmPerMinOfMPerS == wanted) return p21_real(low);
    if (high * kMmPerMinOfMPerS == wanted) return p21_real(high);
    low = std::nextafter(low, 0);
    high = std::nextafter(high, std::numeric_limits<double>::infinity());
  }
  return p21_real(close);
}

std::string ToolpathWriter::point(const PathOrigin& origin, Vec2 at, double z) {
  return out_.add("CARTESIAN_POINT", {"''", p21_list({p21_real(relative(at.x, origin.plan.x)),
                                                      p21_real(relative(at.y, origin.plan.y)),
                                                      p21_real(relative(z, origin.z))})});
}

std::string ToolpathWriter::polyline(const PathOrigin& origin, const std::vector<Move>& moves,
                                     std::size_t first, std::size_t last) {
  std::vector<std::string> points{point(origin, moves[first].path.from, moves[first].z_from)};
  for (std::size_t i = first; i < last; ++i) points.push_back(point(origin, moves[i].path.to, moves[i].z_to));
  return out_.add("POLYLINE", {"''", p21_list(points)});
}

std::string ToolpathWriter::helix(const PathOrigin& origin, const Move& move) {
  const double radius = move.path.radius(), sweep = std::abs(move.path.sweep());
  const double step = radius > kHelixChord ? 2 * base::acos(1 - kHelixChord / radius) : kPi / 2;
  const int chords = std::max(2, static_cast<int>(std::ceil(sweep / step)));
  const auto rounded = [](double value) { return std::round(value * kHelixDigits) / kHelixDigits; };
  std::vector<std::string> points{point(origin, move.path.from, move.z_from)};
  for (int i = 1; i < chords; ++i) {
    const double t = static_cast<double>(i) / chords;
    const Vec2 at = move.path.at(t) - origin.plan;
    const double z = move.z_from + t * (move.z_to - move.z_from) - origin.z;
    points.push_back(
        out_.add("CARTESIAN_POINT",
                 {"''", p21_list({p21_real(rounded(at.x)), p21_real(rounded(at.y)), p21_real(rounded(z))})}));
  }
  points.push_back(point(origin, move.path.to, move.z_to));
  const Vec2 center{relative(move.path.center.x, origin.plan.x), relative(move.path.center.y, origin.plan.y)};
  const std::string name = std::string("HELIX ") +
                           (move.path.turn == Turn::kCounterClockwise ? "CCW " : "CW ") + p21_real(center.x) +
                           " " + p21_real(center.y);
  return out_.add("POLYLINE", {p21_string(name), p21_list(points)});
}

std::string ToolpathWriter::arc(const PathOrigin& origin, const Move& move) {
  if (is_helical(move)) return helix(origin, move);
  const std::string place =
      out_.add("AXIS2_PLACEMENT_3D",
               {"''", point(origin, move.path.center, move.z_from), common_.z_axis, common_.x_axis});
  const std::string circle = out_.add("CIRCLE", {"''", place, p21_real(move.path.radius())});
  return out_.add("TRIMMED_CURVE",
                  {"''", circle, p21_list({point(origin, move.path.from, move.z_from)}),
                   p21_list({point(origin, move.path.to, move.z_to)}),
                   move.path.turn == Turn::kCounterClockwise ? ".T." : ".F.", ".CARTESIAN."});
}

std::string ToolpathWriter::curve(const PathOrigin& origin, const std::vector<Move>& moves) {
  std::vector<std::string> pieces;
  for (std::size_t i = 0; i < moves.size();) {
    std::size_t end = i + 1;
    while (!moves[i].path.is_arc() && end < moves.size() && !moves[end].path.is_arc()) ++end;
    pieces.push_back(moves[i].path.is_arc() ? arc(origin, moves[i]) : polyline(origin, moves, i, end));
    i = end;
  }
  if (pieces.size() == 1) return pieces.front();
  std::vector<std::string> segments;
  for (const std::string& piece : pieces)
    segments.push_back(out_.add("COMPOSITE_CURVE_SEGMENT", {".CONTINUOUS.", ".T.", piece}));
  return out_.add("COMPOSITE_CURVE", {"''", p21_list(segments), ".F."});
}

std::string ToolpathWriter::technology(MmPerMin feed, const std::string& spindle) {
  const auto [known, is_new] = technologies_.try_emplace({feed.mm_per_min(), spindle});
  if (is_new)
    known->second = out_.add("MILLING_TECHNOLOGY",
                             {p21_feed(feed), ".TCP.", kUnset, spindle, kUnset, ".F.", ".F.", ".F.", kUnset});
  return known->second;
}

std::string ToolpathWriter::write(const Section& section, const PathOrigin& origin,
                                  const std::string& spindle) {
  const std::vector<Move>& moves = section.moves;
  const Span span = within_safe_height(moves, safe_z_);
  std::vector<std::string> trajectories;
  for (std::size_t i = span.first; i < span.last;) {
    const Manner manner = manner_of(moves[i]);
    std::vector<Move> alike;
    double dwell = 0;
    for (; i < span.last && dwell == 0 && manner_of(moves[i]) == manner; ++i) {
      alike.push_back(moves[i]);
      dwell = dwell_after(section, i);
    }
    trajectories.push_back(out_.add(
        "CUTTER_LOCATION_TRAJECTORY",
        {".T.", "." + std::string(manner.type) + ".", manner.is_rapid ? "SPEED_NAME(.RAPID.)" : kUnset,
         manner.is_rapid ? kUnset : technology(MmPerMin::of(manner.feed), spindle), kUnset, kUnset,
         curve(origin, alike), kUnset, kUnset}));
    if (dwell > 0)
      trajectories.push_back(
          out_.add("FEEDSTOP", {".T.", ".CONTACT.", kUnset, kUnset, kUnset, p21_real(dwell)}));
  }
  return trajectories.empty() ? kUnset : out_.add("TOOLPATH_LIST", {p21_list(trajectories)});
}

}  // namespace clearcut::post
