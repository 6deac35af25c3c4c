// clearcut-check PROGRAM PART WITNESS: checks a proof that a milling program makes a part. docs/claim.md states what is proven and why
// (its lemmas are named here, L1 to L6), docs/witness.md the bytes of a witness. Needs a C++20 compiler with 128-bit integers alone:
//
//     g++ -std=c++20 -o clearcut-check clearcut_check.cpp
//
// Lengths are whole nanometres below 2^30, so that every product fits 128 bits. There is no floating-point number in this file. What is
// not understood is refused.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace clearcut_check {

using Int = long long;
__extension__ typedef __int128 Wide;
using Text = std::string;

constexpr Int kLargest = Int(1) << 30;  // nm; coordinates and centers of arcs
constexpr Int kHome = kLargest - 1;     // nm; height that stands for the machine's own upper end
constexpr Int kEdge = 4;                // nm; how far rounded corners may lie outside an arc's sector (L4)
constexpr Int kChord = 25;              // nm; how far chords may leave their arcs
constexpr Int kWidestPiece = 100'000;   // nm; how far a tiling's boundary may be from its wall
constexpr Int kRadiiDiffer = 20'000;    // nm; between an arc's start and end
constexpr Int kShortestArc = 2'000;     // nm; shorter ones may be full circles to some controls
constexpr Int kStepChord = 150;  // nm; the same of those whose ends are places of an arc for its engagement
constexpr Int kStep = 20'000;    // nm; between places of a line at which its engagement may be looked at
constexpr Int kMillimetre = 1'000'000, kInch = 25'400'000;

/// Why something is not accepted: 1 the proof does not hold, 2 a file cannot be understood.
struct Refusal {
  int code;
  Text what;
};
[[noreturn]] void refuse(const Text& what) {
  throw Refusal{1, what};
}
[[noreturn]] void reject(const Text& what) {
  throw Refusal{2, what};
}
Text text(Int value) {
  return std::to_string(value);
}
Text mm(Int nm) {
  Text digits = text((nm < 0 ? -nm : nm) % kMillimetre + kMillimetre).substr(1);
  while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
  return (nm < 0 ? "-" : "") + text((nm < 0 ? -nm : nm) / kMillimetre) + "." + digits;
}

// ------------------------------------------------------------------------------------------ exact geometry

struct Point {
  Int x = 0, y = 0;
  auto operator<=>(const Point&) const = default;
  Point operator-(Point b) const { return {x - b.x, y - b.y}; }
  Point operator+(Point b) const { return {x + b.x, y + b.y}; }
  Point left() const { return {-y, x}; }
  bool in_range() const { return std::max({x, -x, y, -y}) < kLargest; }
  Text place() const { return "X" + mm(x) + " Y" + mm(y); }
};
using Points = std::vector<Point>;
Wide cross(Point a, Point b) {
  return Wide(a.x) * b.y - Wide(a.y) * b.x;
}
Wide dot(Point a, Point b) {
  return Wide(a.x) * b.x + Wide(a.y) * b.y;
}
Wide square(Point a) {
  return dot(a, a);
}
Wide square(Wide a) {
  return a * a;
}
/// The greatest number of at most `bits` + 1 bits whose square is no greater.
template <typename Number>
Number root_of_bits(Number value, int bits) {
  Number root = 0;
  for (Number bit = Number(1) << bits; bit > 0; bit >>= 1)
    if ((root + bit) * (root + bit) <= value) root += bit;
  return root;
}
Wide root_down(Wide value) {
  return value >> 62 == 0 ? root_of_bits(Int(value), 30) : root_of_bits(value, 62);
}
Wide root_up(Wide value) {
  return value > 0 ? root_down(value - 1) + 1 : 0;
}
/// value / by, to the nearest integer; by > 0.
Wide nearest_quotient(Wide value, Wide by) {
  return value >= 0 ? (value + by / 2) / by : -((-value + by / 2) / by);
}
/// Whether value >= bound * |n|, exactly; bound may be negative.
bool reaches(Wide value, Wide bound, Point n) {
  if ((value >= 0) != (bound > 0)) return value >= 0;
  const Wide own = square(value), other = square(bound) * square(n);
  return value >= 0 ? own >= other : own <= other;
}

/// The convex hull, counter-clockwise, without collinear points.
Points hull_of(Points points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Points hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const Point p : points) {
      while (hull.size() >= base + 2 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// A line from a to b, or any curve from a to b whose direction from `center` turns monotonically, and whose distance from it stays
/// within low and high. Directions from `center`: counter-clockwise it goes from `first` to `last`; a full turn where they are equal.
struct Curve {
  Point a, b;
  bool arc = false, clockwise = false;
  Point center{}, first{}, last{};
  Int low = 0, high = 0;
  bool full() const { return first == last; }
  bool opposite() const { return cross(first, last) == 0 && dot(first, last) < 0; }
  bool half() const { return !full() && (cross(first, last) > 0 || opposite()); }  // up to 180 degrees
  /// Whether direction v lies in its sector, ends included.
  bool sees(Point v) const {
    if (full()) return true;
    if (!half()) return !(cross(last, v) > 0 && cross(v, first) > 0);
    return cross(first, v) >= 0 && cross(v, last) >= 0 &&
           !(cross(first, v) == 0 && dot(first, v) < 0 && dot(last, v) < 0);
  }
};
/// Names the center and what follows from it; `wider` is added to the distances of the ends from it.
Curve arc_of(Point a, Point b, Point center, bool clockwise, Int wider, const Text& where) {
  if (!center.in_range()) reject(where + ": an arc's center is beyond 1.07 m");
  Curve c{a, b, true, clockwise, center, (clockwise ? b : a) - center, (clockwise ? a : b) - center};
  c.low = Int(root_down(std::min(square(c.first), square(c.last)))) - wider;
  c.high = Int(root_up(std::max(square(c.first), square(c.last)))) + wider;
  if (c.low < kShortestArc || c.high - c.low > kRadiiDiffer)
    reject(where + ": an arc whose radii are too small or differ");
  if (a != b && (square(b - a) < square(kShortestArc) || (cross(c.first, c.last) == 0 && !c.opposite())))
    reject(where + ": an arc so short that some take it for a full circle");
  return c;
}

/// Whether p is no farther than t from the segment ab (L2).
bool near_segment(Point p, Point a, Point b, Wide t) {
  const Wide along = dot(p - a, b - a);
  if (t < 0) return false;
  if (along <= 0) return square(p - a) <= square(t);
  if (along >= square(b - a)) return square(p - b) <= square(t);
  return square(cross(p - a, b - a)) <= square(t) * square(b - a);
}
bool segments_cross(Point a, Point b, Point c, Point d) {
  const auto part = [](Point p, Point q, Point r, Point s) {
    const Wide u = cross(q - p, r - p), v = cross(q - p, s - p);
    return (u > 0 && v < 0) || (u < 0 && v > 0);
  };
  return part(a, b, c, d) && part(c, d, a, b);
}
/// What the edge ab adds to the winding number about p, which is on no edge.
Int turn_about(Point p, Point a, Point b) {
  if ((a.y <= p.y) == (b.y <= p.y)) return 0;
  const Wide side = cross(b - a, p - a);
  return a.y <= p.y ? side > 0 : -(side < 0);
}
/// Whether two segments are farther apart than t.
bool segments_apart(Point a, Point b, Point c, Point d, Wide t) {
  return !segments_cross(a, b, c, d) && !near_segment(a, c, d, t) && !near_segment(b, c, d, t) &&
         !near_segment(c, a, b, t) && !near_segment(d, a, b, t);
}

/// Whether n . v >= bound * |n| for all corners v, seen from `from`.
bool all_reach(const Points& corners, Point n, Wide bound, Point from) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](Point v) { return reaches(dot(n, v - from), bound, n); });
}
/// Whether all of `hull` lies in the sector, but for kEdge beyond its first and its last ray (L4).
bool in_sector(const Curve& c, const Points& hull) {
  if (c.full()) return true;
  const bool after = all_reach(hull, c.first.left(), -kEdge, c.center);
  const bool before = all_reach(hull, Point{} - c.last.left(), -kEdge, c.center);
  if (c.half())
    return after && before &&
           (dot(c.first, c.last) < 0 ||
            (all_reach(hull, c.first, -kEdge, c.center) && all_reach(hull, c.last, -kEdge, c.center)));
  if (after || before) return true;
  for (const Point n :
       {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}})  // half planes that the gap stays out of
    if (dot(n, c.first) <= 0 && dot(n, c.last) <= 0 && all_reach(hull, n, -kEdge, c.center)) return true;
  return false;
}
/// Whether all of `hull` lies no farther than t from the curve, whichever curve it is (L2, L4).
bool hull_within(const Curve& c, const Points& hull, Wide t) {
  if (!c.arc)
    return std::all_of(hull.begin(), hull.end(), [&](Point p) { return near_segment(p, c.a, c.b, t); });
  t -= 2 * kEdge;
  if (t < 0 || !in_sector(c, hull)) return false;
  for (const Point p : hull)
    if (square(p - c.center) > square(c.low + t)) return false;
  if (c.high <= t) return true;
  for (std::size_t i = 0; i < hull.size(); ++i) {  // something separates it from the center
    const Point side = (hull[(i + 1) % hull.size()] - hull[i]).left();
    for (const Point n : {hull[i] - c.center, side, Point{} - side})
      if (n != Point{} && all_reach(hull, n, c.high - t, c.center)) return true;
  }
  return false;
}
/// The same, or all of it no farther than t from one of the curve's ends (L3).
bool near_curve(const Curve& c, const Points& hull, Wide t) {
  return hull_within(c, hull, t) || hull_within({c.a, c.a}, hull, t) || hull_within({c.b, c.b}, hull, t);
}
/// Whether two hulls are at least t apart (L5).
bool apart(const Points& a, const Points& b, Wide t) {
  Points normals{b[0] -
                 a[0]};  // from a to b; the first one between the corners that are nearest to each other
  for (const Point p : a)
    for (const Point q : b)
      if (square(q - p) < square(normals[0])) normals[0] = q - p;
  for (const Points* hull : {&a, &b})
    for (std::size_t i = 0; i < hull->size(); ++i) {
      const Point side = ((*hull)[(i + 1) % hull->size()] - (*hull)[i]).left();
      normals.insert(normals.end(), {side, Point{} - side});
    }
  return std::any_of(normals.begin(), normals.end(), [&](Point n) {
    Wide most = dot(n, a[0]), least = dot(n, b[0]);
    for (const Point p : a) most = std::max(most, dot(n, p));
    for (const Point p : b) least = std::min(least, dot(n, p));
    return n != Point{} && reaches(least - most, t, n);
  });
}

/// How far the chord uv, directions from the center, and the part of the curve that it spans are apart at most, measured along rays.
Wide chord_error(const Curve& c, Point u, Point v) {
  const Point d = v - u;
  Wide least = std::min(square(u), square(v));
  if (dot(u, d) < 0 && dot(v, d) > 0) least = square(cross(u, v)) / square(d);
  return std::max(Wide(c.high) - root_down(least), root_up(std::max(square(u), square(v))) - c.low);
}
/// Adds the chords from direction u to v (less than 180 degrees on) to `out`, without u: halved until they are near the curve.
void halve(const Curve& c, Point u, Point v, Int most, int depth, Points& out) {
  const Point sum = u + v;
  const Wide size = root_down(square(sum)), radius = (Wide(c.low) + c.high) / 2;
  const bool near = dot(u, v) > 0 && chord_error(c, u, v) <= most + (c.high - c.low) + 3;
  if (depth == 0 || near || size == 0) return out.push_back(v);
  const Point middle{Int(nearest_quotient(sum.x * radius, size)),
                     Int(nearest_quotient(sum.y * radius, size))};
  halve(c, u, middle, most, depth - 1, out);
  halve(c, middle, v, most, depth - 1, out);
}
/// A polyline from a to b that stays within `error` of the curve, point by point in order (L6).
struct Chords {
  Points points;
  Wide error = 0;
};
Chords chords_of(const Curve& c, Int most = kChord) {
  if (!c.arc) return {{c.a, c.b}, 0};
  const Int r = (c.low + c.high) / 2;
  Points rays{c.first};  // from the center, counter-clockwise, ends as they are
  Points axes{{r, 0}, {0, r}, {-r, 0}, {0, -r}};
  std::rotate(axes.begin(),
              std::find_if(axes.begin(), axes.end(),
                           [&](Point a) { return cross(c.first, a) > 0 && dot(c.first, a) >= 0; }),
              axes.end());
  for (const Point axis : axes) {  // those that the curve passes before its end
    if ((cross(rays.back(), c.last) > 0 && cross(c.last, axis) >= 0) || axis == c.last) break;
    rays.push_back(axis);
  }
  rays.push_back(c.last);
  Chords out{{c.first}, 0};
  for (std::size_t i = 1; i < rays.size(); ++i) halve(c, rays[i - 1], rays[i], most, 24, out.points);
  for (std::size_t i = 1; i < out.points.size();
       ++i) {  // nothing of this is trusted: turns, sector, distance
    const Point u = out.points[i - 1], v = out.points[i];
    const bool past = !c.full() && cross(u, c.last) >= 0 && dot(u, c.last) >= 0 && cross(c.last, v) > 0;
    const bool again =
        c.full() && i + 1 < out.points.size() && cross(u, c.first) > 0 && cross(c.first, v) >= 0;
    if (cross(u, v) <= 0 || !c.sees(v) || past || again) reject("an arc is too small to be divided");
    out.error = std::max(out.error, chord_error(c, u, v));
  }
  for (Point& p : out.points) {
    p = p + c.center;
    if (!p.in_range()) reject("an arc reaches beyond 1.07 m");
  }
  if (c.clockwise) std::reverse(out.points.begin(), out.points.end());
  return out;
}

struct Box {
  Int x0 = kLargest * 4, y0 = kLargest * 4, x1 = -kLargest * 4, y1 = -kLargest * 4;
  void add(Point p) {
    x0 = std::min(x0, p.x), y0 = std::min(y0, p.y), x1 = std::max(x1, p.x), y1 = std::max(y1, p.y);
  }
  Box grown(Wide by) const { return {x0 - Int(by), y0 - Int(by), x1 + Int(by), y1 + Int(by)}; }
  bool meets(const Box& b) const { return x0 <= b.x1 && b.x0 <= x1 && y0 <= b.y1 && b.y0 <= y1; }
};
Box box_of(const Points& points) {
  Box box;
  for (const Point p : points) box.add(p);
  return box;
}
/// Boxes, and which of them meet one. Some are visited more than once.
class Grid {
 public:
  explicit Grid(std::vector<Box> boxes = {}) : boxes_(std::move(boxes)), cells_(kSide * kSide) {
    for (const Box& b : boxes_) all_.add({b.x0, b.y0}), all_.add({b.x1, b.y1});
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      each_cell(boxes_[i], [&](std::size_t cell) { return cells_[cell].push_back(i), true; });
  }
  /// Stops, and returns false, where `visit` returns false.
  bool visit_all(const Box& box, const std::function<bool(std::size_t)>& visit) const {
    return boxes_.empty() || each_cell(box, [&](std::size_t cell) {
             return std::all_of(cells_[cell].begin(), cells_[cell].end(),
                                [&](std::size_t i) { return !boxes_[i].meets(box) || visit(i); });
           });
  }

 private:
  static constexpr Int kSide = 128;
  bool each_cell(const Box& box, const std::function<bool(std::size_t)>& visit) const {
    const auto place = [](Int at, Int low, Int high) {
      return std::clamp<Int>((at - low) * kSide / (high - low + 1), 0, kSide - 1);
    };
    for (Int i = place(box.x0, all_.x0, all_.x1); i <= place(box.x1, all_.x0, all_.x1); ++i)
      for (Int k = place(box.y0, all_.y0, all_.y1); k <= place(box.y1, all_.y0, all_.y1); ++k)
        if (!visit(std::size_t(i * kSide + k))) return false;
    return true;
  }
  std::vector<Box> boxes_;
  std::vector<std::vector<std::size_t>> cells_;
  Box all_;
};

/// v turned by an angle in 1/10000 degrees, to the nearest place but for 1 nm. Series of sine and cosine in units of 2^-60.
Point turned(Point v, Int angle) {
  angle = (angle % 3'600'000 + 3'600'000) % 3'600'000;
  for (; angle >= 900'000; angle -= 900'000) v = v.left();
  const Wide one = Wide(1) << 60, x = Wide(3'622'009'729'038'561'421) * angle / 1'800'000;  // pi * 2^60
  Wide term = one, cosine = 0, sine = 0;
  for (int n = 0; n < 40; term = term * x / one / ++n) (n % 2 ? sine : cosine) += n % 4 < 2 ? term : -term;
  return {Int(nearest_quotient(v.x * cosine - v.y * sine, one)),
          Int(nearest_quotient(v.x * sine + v.y * cosine, one))};
}

// ------------------------------------------------------------------------------------------ numbers and files

/// digits * 10^exponent; `point` where one was written.
struct Number {
  Wide digits = 0;
  int exponent = 0;
  bool point = false;
};
/// Reads a number at `at` and moves it on; at most 18 digits count, later ones are cut off where `cut`, else refused.
Number number_at(const Text& in, std::size_t& at, bool cut, const Text& where) {
  Number out;
  const bool negative = at < in.size() && in[at] == '-';
  bool any = false;
  if (at < in.size() && (in[at] == '+' || in[at] == '-')) ++at;
  for (int count = 0; at < in.size() && (in[at] == '.' || (in[at] >= '0' && in[at] <= '9')); ++at) {
    if (in[at] == '.' && out.point) reject(where + ": a number with two points");
    out.point = out.point || in[at] == '.';
    if (in[at] == '.') continue;
    any = true;
    if (count < 18) out.digits = out.digits * 10 + (in[at] - '0');
    if (count >= 18 && !cut) reject(where + ": a number with more than 18 digits");
    out.exponent += (count >= 18) - out.point;
    count += out.digits != 0 && count < 18;
    if (out.exponent < -1000 || out.exponent > 1000) reject(where + ": a number with too many digits");
  }
  if (!any) reject(where + ": a number is missing");
  if (negative) out.digits = -out.digits;
  return out;
}
/// The value in units of 1 / `unit`, to the nearest; `exact` refuses what is no whole number of them.
Int scaled(Number n, Int unit, bool exact, const Text& where) {
  Wide value = n.digits * unit, by = 1;
  const Wide most = Wide(1) << 60;
  for (; n.exponent > 0 && value != 0 && value < most * most && value > -most * most / 16; --n.exponent)
    value *= 10;
  for (; n.exponent < 0 && by < most * most / 16; ++n.exponent) by *= 10;
  if (exact && (value % by != 0 || n.exponent < 0))
    reject(where + ": a length is no whole number of nanometres");
  value = n.exponent < 0 ? 0 : nearest_quotient(value, by);
  if (value > most || value < -most || (n.exponent > 0 && value != 0))
    reject(where + ": a number is too large");
  return Int(value);
}
Int within_range(Int nm, const Text& where) {
  if (nm >= kLargest || nm <= -kLargest) reject(where + ": a coordinate is beyond 1.07 m");
  return nm;
}
Text read_file(const Text& path) {
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) reject(path + ": cannot be read");
  Text out;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) out += char(c);
  std::fclose(file);
  return out;
}

/// SHA-256 (FIPS 180-4) as 32 bytes. Its constants are the first bits of roots of primes, taken here by integers.
Text sha256(Text data) {
  std::vector<std::uint32_t> k, h;
  for (Wide n = 2; k.size() < 64; ++n) {
    bool prime = true;
    for (Wide d = 2; d * d <= n; ++d) prime = prime && n % d != 0;
    if (!prime) continue;
    if (h.size() < 8) h.push_back(std::uint32_t(root_down(n << 64)));
    Wide cube_root = 0;
    for (Wide bit = Wide(1) << 35; bit > 0; bit >>= 1)
      if (square(cube_root + bit) * (cube_root + bit) <= n << 96) cube_root += bit;
    k.push_back(std::uint32_t(cube_root));
  }
  const std::uint64_t bits = data.size() * 8;
  data += char(0x80);
  while (data.size() % 64 != 56) data += char(0);
  for (int shift = 56; shift >= 0; shift -= 8) data += char(bits >> shift);
  const auto turn = [](std::uint32_t v, int by) { return (v >> by) | (v << (32 - by)); };
  for (std::size_t at = 0; at < data.size(); at += 64) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i)
      w[i / 4] = (w[i / 4] << 8) | static_cast<unsigned char>(data[at + i]);
    for (std::size_t i = 16; i < 64; ++i) {
      const std::uint32_t a = w[i - 15], b = w[i - 2];
      w[i] = w[i - 16] + (turn(a, 7) ^ turn(a, 18) ^ (a >> 3)) + w[i - 7] +
             (turn(b, 17) ^ turn(b, 19) ^ (b >> 10));
    }
    auto v = h;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint32_t e = v[4], a = v[0];
      const std::uint32_t one =
          v[7] + (turn(e, 6) ^ turn(e, 11) ^ turn(e, 25)) + ((e & v[5]) ^ (~e & v[6])) + k[i] + w[i];
      const std::uint32_t two =
          (turn(a, 2) ^ turn(a, 13) ^ turn(a, 22)) + ((a & v[1]) ^ (a & v[2]) ^ (v[1] & v[2]));
      v = {one + two, v[0], v[1], v[2], v[3] + one, v[4], v[5], v[6]};
    }
    for (std::size_t i = 0; i < 8; ++i) h[i] += v[i];
  }
  Text out;
  for (const std::uint32_t word : h)
    for (int shift = 24; shift >= 0; shift -= 8) out += char(word >> shift);
  return out;
}
Text hex(const Text& bytes) {
  Text out;
  for (const unsigned char c : bytes) out += "0123456789abcdef"[c >> 4], out += "0123456789abcdef"[c & 15];
  return out;
}

// ------------------------------------------------------------------------------------------ the part

struct Json {
  char kind = 'n';          // { [ " 0 t f n
  Text word;                // of texts and numbers
  std::vector<Text> names;  // of the items of an object
  std::vector<Json> items;
  Text where;
  const Json* find(const Text& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? nullptr : &items[std::size_t(found - names.begin())];
  }
  [[noreturn]] void fail(const Text& what) const { reject(where + ": " + what); }
  const std::vector<Json>& list() const {
    if (kind != '[') fail("a list is expected");
    return items;
  }
  Int number(Int unit) const {
    std::size_t end = 0;
    Number n = number_at(kind == '0' ? word : "", end, true, where);
    if (end < word.size() && (word[end] == 'e' || word[end] == 'E')) {
      const Int power = scaled(number_at(word, ++end, false, where), 1, true, where);
      if (power > 99 || power < -99) fail("an exponent out of range");
      n.exponent += int(power);
    }
    if (end != word.size()) fail("'" + word + "' is no number");
    return scaled(n, unit, false, where);
  }
};
class JsonReader {
 public:
  JsonReader(const Text& in, const Text& file) : in_(in), file_(file) {}
  Json whole() {
    Json value = read(0);
    if (takes(0)) reject(where() + ": something follows the end");
    return value;
  }

 private:
  Text where() const { return file_ + ":" + text(line_); }
  /// The next character that is no blank, where it is `c`; any, and not taken, where c is 0.
  bool takes(char c) {
    for (; at_ < in_.size() && Text(" \t\r\n").find(in_[at_]) != Text::npos; ++at_) line_ += in_[at_] == '\n';
    if (at_ >= in_.size() || (c != 0 && in_[at_] != c)) return false;
    at_ += c != 0;
    return true;
  }
  void need(char c) {
    if (!takes(c)) reject(where() + ": '" + Text(1, c) + "' is missing");
  }
  Text quoted() {
    const std::size_t start = at_;
    for (; at_ < in_.size() && in_[at_] != '"'; ++at_) at_ += in_[at_] == '\\';
    const Text out =
        in_.substr(start, at_ - start);  // escapes stay as they are: no name that matters has one
    if (at_++ >= in_.size() || out.find('\n') != Text::npos) reject(where() + ": a text does not end");
    return out;
  }
  Json read(int depth) {
    Json out;
    if (depth > 20 || !takes(0)) reject(where() + ": too deeply nested, or cut off");
    out.where = where();
    if (takes('{') || takes('[')) {
      out.kind = in_[at_ - 1];
      while (!takes(out.kind == '{' ? '}' : ']')) {
        if (!out.items.empty()) need(',');
        if (out.kind == '{') {
          need('"');
          out.names.push_back(quoted());
          if (out.names.back().find('\\') != Text::npos) out.fail("a name with an escape");
          if (std::count(out.names.begin(), out.names.end(), out.names.back()) > 1)
            out.fail("a name stands twice");
          need(':');
        }
        out.items.push_back(read(depth + 1));
      }
    } else if (takes('"')) {
      out.kind = '"';
      out.word = quoted();
    } else {
      const std::size_t end = std::min(in_.find_first_of(",]} \t\r\n", at_), in_.size());
      out.word = in_.substr(at_, end - at_);
      const bool named = out.word == "true" || out.word == "false" || out.word == "null";
      out.kind = named ? out.word[0] : '0';
      if (!named) out.number(1);
      at_ = end;
    }
    return out;
  }
  const Text& in_;
  const Text file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

struct Wall {
  Curve curve;
  std::size_t outline = 0;
};
/// A chord of a wall.
struct Segment {
  Point a, b;
  Wide error;
  std::size_t wall;
};
/// What outlines enclose: outer ones counter-clockwise, islands clockwise.
struct Region {
  std::vector<Wall> walls;
  std::vector<Segment> segments;
  std::size_t outlines = 0;
  Grid grid;
  /// Winding number of the walls' chords about p, without one outline.
  Int winding(Point p, std::size_t without) const {
    Int turns = 0;
    for (const Segment& s : segments)
      if (walls[s.wall].outline != without) turns += turn_about(p, s.a, s.b);
    return turns;
  }
};
/// The wall from a to b with this bulge, tangent of a quarter of its angle, in units of 1e-12. Its true center is at most 0.71 nm from
/// the one taken here, so that distances from it differ by as much.
Curve bulged(Point a, Point b, Int bulge, const Text& where) {
  const Wide p = bulge, q = 1'000'000'000'000, sign = p < 0 ? -1 : 1;
  if (bulge == 0) return {a, b};
  if (p > 100 * q || p < -100 * q) reject(where + ": a bulge above 100");
  const Point across = (b - a).left();
  const auto middle = [&](Int u, Int v, Int n) {
    const Wide at =
        nearest_quotient((Wide(u) + v) * (2 * p * q * sign) + sign * (q * q - p * p) * n, 4 * p * q * sign);
    return Int(std::clamp<Wide>(at, -kLargest, kLargest));
  };
  return arc_of(a, b, {middle(a.x, b.x, across.x), middle(a.y, b.y, across.y)}, bulge < 0, 2, where);
}

struct Feature {
  Text name, why_not;  // why it cannot be claimed
  Int top = 0, floor = 0;
  bool through = false;    // the point of a drill may be below its floor
  Region target, allowed;  // what is to be cut, where the cutter may be
};
struct Part {
  std::vector<Feature> features;
  std::optional<Box> stock;
  Int top = -kLargest;
};

/// Adds an outline that runs counter-clockwise, or `island`, clockwise. `far`: beyond the range means as far as that reaches.
void add_outline(Region& region, const Json& outline, Int unit, bool island, bool far) {
  std::vector<Wall> walls;
  std::vector<std::pair<Point, Int>> vertices;
  for (const Json& item : outline.list()) {
    if (item.list().size() < 2 || item.items.size() > 3) item.fail("a vertex is [x, y] or [x, y, bulge]");
    const auto coordinate = [&](std::size_t i) {
      const Int nm = item.items[i].number(unit);
      return far ? std::clamp<Int>(nm, 1 - kLargest, kLargest - 1) : within_range(nm, item.where);
    };
    vertices.push_back({{coordinate(0), coordinate(1)},
                        item.items.size() == 3 ? item.items[2].number(1'000'000'000'000) : 0});
  }
  Wide area = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point a = vertices[i].first, b = vertices[(i + 1) % vertices.size()].first;
    if (a == b) continue;
    walls.push_back({bulged(a, b, vertices[i].second, outline.where), region.outlines});
    const Chords chords = chords_of(walls.back().curve);
    for (std::size_t k = 1; k < chords.points.size(); ++k)
      area += cross(chords.points[k - 1], chords.points[k]);
  }
  if (area == 0) outline.fail("an outline without area");
  if ((area > 0) == island) {  // turned, so that what is to be cut lies to the left
    std::reverse(walls.begin(), walls.end());
    for (Wall& wall : walls)
      std::swap(wall.curve.a, wall.curve.b), wall.curve.clockwise = wall.curve.arc && !wall.curve.clockwise;
  }
  for (const Wall& wall : walls) {
    const Chords chords = chords_of(wall.curve);
    for (std::size_t k = 1; k < chords.points.size(); ++k)
      region.segments.push_back({chords.points[k - 1], chords.points[k], chords.error, region.walls.size()});
    region.walls.push_back(wall);
  }
  ++region.outlines;
}
/// Outlines are simple and apart, each island lies in one outer outline and in no other outline: the winding number is 0 or 1.
void finish(Region& region, const Json& where) {
  std::vector<Box> boxes;
  for (const Segment& s : region.segments) boxes.push_back(box_of({s.a, s.b}).grown(s.error));
  region.grid = Grid(boxes);
  const auto fold = [](Point a, Point b, Point c) {
    return cross(b - a, c - b) == 0 && dot(b - a, c - b) < 0;
  };
  for (std::size_t i = 0; i < region.segments.size(); ++i)
    region.grid.visit_all(boxes[i], [&](std::size_t k) {
      const Segment &s = region.segments[i], &other = region.segments[k];
      const bool one = region.walls[s.wall].outline == region.walls[other.wall].outline;
      const bool before = one && s.b == other.a, after = one && s.a == other.b;
      const bool meet = before || after
                            ? (before && fold(s.a, s.b, other.b)) || (after && fold(other.a, other.b, s.b))
                            : !segments_apart(s.a, s.b, other.a, other.b, 0);
      if (k > i && meet)
        where.fail("outlines cross near " + s.a.place() + "; repair them first (clearcut convert)");
      return true;
    });
  for (std::size_t i = 0; i < region.segments.size(); ++i) {
    const std::size_t outline = region.walls[region.segments[i].wall].outline;
    if (i > 0 && region.walls[region.segments[i - 1].wall].outline == outline) continue;
    Wide area = 0;
    for (const Segment& s : region.segments)
      if (region.walls[s.wall].outline == outline) area += cross(s.a, s.b);
    if (region.winding(region.segments[i].a, outline) != (area < 0 ? 1 : 0))
      where.fail("an outline lies in another one, or an island outside, near " +
                 region.segments[i].a.place());
  }
}
Region read_region(const std::vector<const Json*>& parts, Int unit, bool far) {
  Region region;
  for (const Json* part : parts) {
    const Json *outer = part->find("outer"), *islands = part->find("islands");
    if (!outer) part->fail("\"outer\" is missing");
    add_outline(region, *outer, unit, false, far);
    if (islands)
      for (const Json& island : islands->list()) add_outline(region, island, unit, true, far);
  }
  finish(region, *parts[0]);
  return region;
}
/// `alone`: the file is this feature, so that units and stock stand beside its outlines.
Feature read_feature(const Json& pocket, Int unit, bool alone) {
  Feature f;
  std::set<Text> known{"name",      "outer",   "islands", "top",    "depth",  "kind",        "through",
                       "slope_rad", "allowed", "line",    "closed", "beyond", "floor_fillet"};
  if (alone) known.insert({"units", "stock"});
  for (const Text& name : pocket.names)
    if (!known.count(name)) pocket.fail("\"" + name + "\" is not claimed");
  if (const Json* name = pocket.find("name")) f.name = name->word;
  if (const Json* top = pocket.find("top")) f.top = within_range(top->number(unit), top->where);
  if (!pocket.find("depth")) pocket.fail("\"depth\" is missing");
  f.floor = within_range(f.top - pocket.find("depth")->number(unit), pocket.where);
  if (f.floor >= f.top) pocket.fail("the depth must be above 0");
  f.through = pocket.find("through") && pocket.find("through")->kind == 't';
  const Json *slope = pocket.find("slope_rad"), *allowed = pocket.find("allowed"),
             *fillet = pocket.find("floor_fillet");
  if (slope && slope->number(kMillimetre) != 0) f.why_not = "its walls lean";
  if (fillet && fillet->number(unit) != 0) f.why_not = "its floor meets its walls in a fillet";
  if (pocket.find("line")) return f.why_not = "the cutter follows a line", f;
  f.target = read_region({&pocket}, unit, false);
  std::vector<const Json*> parts;
  if (allowed)
    for (const Json& one : allowed->list()) {
      parts.push_back(&one);
      for (const Text& name : one.names)
        if (name != "outer" && name != "islands") one.fail("\"" + name + "\" is not claimed");
    }
  f.allowed = parts.empty() ? f.target : read_region(parts, unit, true);
  return f;
}
Part read_part(const Text& in, const Text& file) {
  const Json root = JsonReader(in, file).whole();
  const Json *units = root.find("units"), *pockets = root.find("pockets"), *stock = root.find("stock");
  if (units && units->word != "mm" && units->word != "inch") units->fail("units other than mm and inch");
  const Int unit = units && units->word == "inch" ? kInch : kMillimetre;
  Part part;
  if (!pockets) part.features.push_back(read_feature(root, unit, true));
  for (const Text& name : root.names)
    if (pockets && !std::set<Text>{"name", "units", "stock", "pockets"}.count(name))
      root.fail("\"" + name + "\" beside \"pockets\" is not claimed");
  if (pockets)
    for (const Json& pocket : pockets->list()) part.features.push_back(read_feature(pocket, unit, false));
  for (const Feature& f : part.features) part.top = std::max(part.top, f.top);
  if (!stock) return part;
  const auto side = [&](const Text& axis, std::size_t i) {
    const Json* range = stock->find(axis);
    if (!range || range->list().size() != 2) stock->fail("a stock has x, y and z, each [low, high]");
    if (range->items[0].number(unit) >= range->items[1].number(unit)) range->fail("a range that is empty");
    return within_range(range->items[i].number(unit), range->where);
  };
  part.stock = {side("x", 0), side("y", 0), side("x", 1), side("y", 1)};
  part.top = std::max(part.top, side("z", 1));
  return part;
}

// ------------------------------------------------------------------------------------------ the program

struct Move {
  Curve path;
  Int z0 = 0, z1 = 0;
  bool rapid = false;
  int line = 0;
  Int tool = 0;
  Int lowest() const { return std::min(z0, z1); }
  bool only_rises() const { return !path.arc && path.a == path.b && z1 >= z0; }
  Text name() const { return "line " + text(line) + " of the program "; }
};
struct Program {
  std::vector<Move> moves;
  Int blending = 0;     // nm; how far the control may leave the path in the plane
  Int lift = 0;         // nm; the same of heights, which ends of helices have exactly
  bool dogleg = false;  // rapids may not be straight
  Int rounding = 0;     // nm; how far ends of helices may be from where they are taken to be
  bool stated = false;  // whether the program says how exactly it is followed
};

/// Where a control stands, and what a motion from there is.
class Track {
 public:
  Track(const Text& file, Program& out, Int top) : out_(out), top_(top), file_(file) {}

 protected:
  using Axes = std::array<std::optional<Int>, 3>;
  static constexpr Int kNoTool = -1;
  [[noreturn]] void fail(const Text& what) const { reject(where() + ": " + what); }
  Text where() const { return file_ + ":" + text(line_); }
  bool known() const { return at_[0] && at_[1] && at_[2]; }
  Point place() const { return {at_[0].value_or(0), at_[1].value_or(0)}; }
  bool at_home() const { return !at_[2] || *at_[2] == kHome; }
  bool moved() const { return at_[0] || at_[1] || at_[2] || !out_.moves.empty(); }
  void straight(const Axes& to, bool rapid) {
    const Axes from = at_;
    const bool all = known();
    for (std::size_t k = 0; k < 3; ++k)
      if (to[k]) at_[k] = to[k];
    if (!all && (!rapid || !at_[2] || *at_[2] < top_))
      fail("the first motions must be rapids above the top of the part");
    if (all && from != at_) add({{{*from[0], *from[1]}, place()}, *from[2], *at_[2], rapid});
  }
  void arc(const Axes& to, Point center, bool clockwise) {
    if (!known()) fail("an arc from an unknown place");
    const Point from = place();
    const Int below = *at_[2];
    for (std::size_t k = 0; k < 3; ++k)
      if (to[k]) at_[k] = to[k];
    add({arc_of(from, place(), center, clockwise, 0, where()), below, *at_[2], false});
  }
  /// Up to the machine's own upper end.
  void home() {
    if (known()) straight(Axes{std::nullopt, std::nullopt, kHome}, true);
    at_[2] = kHome;
  }
  /// To a place of the machine's own, at its upper end.
  void away() {
    if (!at_home()) fail("a way to the machine's own places below its upper end");
    at_[0].reset(), at_[1].reset();
  }
  /// Number 0 is no tool. `again`: the control may go through a change of the tool that is in, too.
  void change(Int number, bool again = false) {
    const Int tool = number == 0 ? kNoTool : number;
    if (at_[2] && *at_[2] < top_) fail("a tool change below the top of the part");
    if (tool == tool_ && !again) return;
    home(), away();
    tool_ = tool;
  }
  /// A cycle: over the hole, down to `clear`, by feed to `bottom`, up to `out`.
  void drill(std::optional<Int> x, std::optional<Int> y, Int clear, Int bottom, Int out) {
    if (!at_[2] || *at_[2] < clear || out < clear) fail("a cycle that begins below its own clearance");
    if (bottom > clear) fail("a cycle that ends above its own clearance");
    straight(Axes{x, y}, true);
    straight(Axes{std::nullopt, std::nullopt, clear}, true);
    straight(Axes{std::nullopt, std::nullopt, bottom}, false);
    straight(Axes{std::nullopt, std::nullopt, out}, true);
  }
  /// A number of few digits, of a word.
  Int small(const Number& value, Int times) const {
    const Int number = scaled(value, times, true, where());
    if (number < 0 || number > 99'999) fail("a word's number is out of range");
    return number;
  }
  void blend(const Number& value, bool may_be_nothing) {
    const Int nm = scaled(value, unit_, false, where());
    if (nm == 0 && !may_be_nothing) fail("a tolerance of nothing, which controls take as no bound");
    if (nm < 0 || nm > kMillimetre) fail("a tolerance out of range");
    tolerance_ += nm + 1;
    out_.blending = std::max(out_.blending, tolerance_);
    state();
  }
  /// How exactly the program is followed: of all motions where it is said before them.
  void state() { out_.stated = out_.stated || out_.moves.empty(); }

  Program& out_;
  Int top_, unit_ = kMillimetre, tool_ = 0, tolerance_ = 0;
  Axes at_;
  Text file_;
  int line_ = 0;
  bool ended_ = false;

 private:
  void add(Move move) {
    move.line = line_, move.tool = tool_;
    out_.moves.push_back(move);
  }
};

/// G-code as LinuxCNC, Grbl, Fanuc, Haas, Mach, Marlin and, after G700 or G710, Sinumerik read it: absolute, XY plane, arcs by I and J.
class IsoReader : Track {
 public:
  using Track::Track;
  void block(const Text& line) {
    ++line_;
    words_.clear(), gs_.clear(), ms_.clear();
    const bool last = !calls(line) && split(line);
    if (!words_.empty() || !gs_.empty() || !ms_.empty()) {
      if (ended_) fail("something follows the end of the program");
      codes();
      motion();
      if (!words_.empty()) fail("word " + Text(1, words_.begin()->first) + " has no meaning here");
    }
    ended_ = ended_ || last;
    begun_ = true;
  }

 private:
  /// "MCALL CYCLE81(10,1,0,-6)" of Sinumerik: a cycle at each place from here on; its first four numbers are the height after it, the
  /// reference plane, the distance above that where feeding begins, and the bottom. "MCALL" alone ends it. False for other lines.
  bool calls(const Text& line) {
    if (!sinumerik_ || line.compare(0, 5, "MCALL") != 0) return false;
    const Text call = line.substr(5, line.find_first_of(";\r", 5) - 5);
    motion_ = -1;
    if (call.find_first_not_of(' ') == Text::npos) return true;
    if (call.compare(0, 6, " CYCLE") != 0 ||
        !std::set<Text>{"81(", "82(", "83(", "85("}.count(call.substr(6, 3)))
      fail("'" + line + "' is not claimed");
    std::array<Int, 4> numbers{};
    std::size_t at = 9;
    for (Int& number : numbers) {
      number = within_range(scaled(number_at(call, at, false, where()), unit_, true, where()), where());
      if (call[at] != ',' && call[at] != ')') fail("a cycle without its heights");
      at += call[at] == ',';
    }
    if (call[at] != ',' && call[at] != ')') fail("a cycle with a relative depth");
    // Later ones are times, feeds and pecks; beyond them depths may count from elsewhere, the 13th names another axis.
    const std::size_t close = call.find(')'), most = call[7] == '1'   ? 5
                                                     : call[7] == '2' ? 6
                                                     : call[7] == '3' ? 17
                                                                      : 8;
    std::vector<std::size_t> commas;
    for (std::size_t i = 0; i < std::min(close, call.size()); ++i)
      if (call[i] == ',') commas.push_back(i);
    if (close == Text::npos || call.find_first_not_of(' ', close + 1) != Text::npos ||
        commas.size() >= most ||
        (commas.size() > 11 && call[commas[11] + 1] != ',' && call[commas[11] + 1] != ')'))
      fail("'" + line + "' is not claimed");
    if (numbers[2] < 0) fail("a cycle with a clearance below its surface");
    motion_ = kCalled, to_start_ = true, begins_ = false;
    start_ = numbers[0], clear_ = numbers[1] + numbers[2], bottom_ = numbers[3];
    return true;
  }
  static constexpr Int kCalled = 999;
  /// Fills words_, gs_, ms_. True where a second % ends the program.
  bool split(const Text& line) {
    bool comment = false;
    for (std::size_t at = 0; at < line.size();) {
      const char c = line[at++];
      if (comment || c == '(') {
        comment = c != ')';
        continue;
      }
      if (c == ';' && tape_ && line.find_first_not_of(" \t\r", at) != Text::npos)
        fail("something follows the end of a block");
      if (c == ';') break;
      if (c == ' ' || c == '\t' || c == '\r') continue;
      if (c == '%' && line.find_first_not_of(" \t\r", at) == Text::npos) return begun_;
      if (c < 'A' || c > 'Z') fail(Text("'") + c + "' is not understood");
      if (line.compare(at - 1, 5, "SUPA ") == 0) {  // Sinumerik's G53
        gs_.push_back(530), at += 4;
        continue;
      }
      if (line.compare(at - 1, 5, "CTOL=") == 0)
        at += 4;  // kept under its first letter, which no other word has
      const Number value = number_at(line, at, false, where());
      if (c == 'G' || c == 'M') (c == 'G' ? gs_ : ms_).push_back(small(value, 10));
      if (c != 'G' && c != 'M' && !words_.emplace(c, value).second) fail(Text("word ") + c + " stands twice");
      if (line.compare(at, 9, " INSERT T") == 0) {  // Marlin's M0 with a message names the tool by hand
        if (c != 'M' || ms_.back() != 0) fail("INSERT without M0");
        inserted_ = small(number_at(line, at += 9, false, where()), 1);
        return false;
      }
    }
    if (comment) fail("a comment does not end");
    return false;
  }
  bool takes_g(Int code) { return std::erase(gs_, code) > 0; }
  bool has(char letter) const { return words_.count(letter) > 0; }
  Number take(char letter) {
    const Number value = words_.at(letter);
    words_.erase(letter);
    return value;
  }
  Int length(char letter) {
    const Number n = take(letter);
    if (tape_ && !n.point) fail(Text("word ") + letter + " needs a decimal point on this control");
    const Int nm = scaled(n, unit_, true, where());
    return within_range(nm / (letter == 'I' || letter == 'J' ? 2 : 1), where()), nm;
  }
  std::optional<Int> axis(char letter) { return has(letter) ? std::optional(length(letter)) : std::nullopt; }
  void codes() {
    if (has('O') && (tape_ || moved())) fail("a second program begins");
    if (has('O')) words_.erase('O'), tape_ = out_.dogleg = true;
    for (const char c : {'N', 'S', 'F'}) words_.erase(c);
    if (takes_g(40)) {  // a dwell
      if (words_.erase('P') + words_.erase('X') > 1 || !words_.empty() || !gs_.empty() || !ms_.empty())
        fail("a dwell with other words");
      return;
    }
    for (const Int code : {200, 210, 7000, 7100}) {
      if (!takes_g(code)) continue;
      if (moved()) fail("units change after the first motion");
      unit_ = code == 200 || code == 7000 ? kInch : kMillimetre;
      sinumerik_ = sinumerik_ || code > 1000;
    }
    for (const Int code : {170, 400, 911, 940})
      takes_g(code);  // XY plane, no compensation, centers from the start, feed per minute
    if (takes_g(800)) {
      if (motion_ == kCalled) fail("G80 does not end a cycle that is called");
      motion_ = -1;
    }
    tools();
    const bool by_reference = takes_g(280), up = by_reference || takes_g(530), incremental = takes_g(910);
    in_steps_ = in_steps_ || incremental;
    if (by_reference ? !in_steps_ : incremental) fail("G28 without G91, or the other way round");
    if (takes_g(900)) {
      if (incremental) fail("G90 and G91 in one block");
      absolute_ = true, in_steps_ = false;
    }
    // By way of a place: of the one where the tool is, in steps of nothing.
    for (const char c : {'X', 'Y', 'Z'})
      if (by_reference && has(c) && words_.at(c).digits != 0) fail("G28 by way of another place");
    if (sinumerik_ && has('D')) {
      if (take('D').digits == 0 && !up) fail("D0, which is no tool's length");
      if (!up && !at_home()) fail("the tool's length changes away from the machine's upper end");
    }
    if (up) return go_home(in_steps_);
    const bool cancels = takes_g(490), sets = takes_g(430);
    if (cancels || sets) {
      if (!at_home()) fail("the tool's length changes away from the machine's upper end");
      if (has('H') && take('H').digits == 0) fail("H0, which is no tool's length");
      lacks_length_ = cancels && has_length_;
      has_length_ = has_length_ || sets;
    }
    offsets();
    if (takes_g(610) || (sinumerik_ && takes_g(600))) state();
    const bool path = takes_g(640), smooth = takes_g(1870), contour = sinumerik_ && takes_g(6420);
    if (path || smooth || contour) {
      const char first = path ? 'P' : smooth ? 'E' : 'C';
      if (!has(first)) fail("blending without a stated tolerance");
      const Number one = take(first);
      if (smooth) words_.erase('P');  // how smoothly: within the tolerance
      tolerance_ = 0;
      blend(one, false);
      if (path) blend(has('Q') ? take('Q') : one, true);
    }
    const bool to_start = takes_g(980), to_clear = takes_g(990);
    if (to_start && to_clear) fail("G98 and G99 in one block");
    if (to_start || to_clear) to_start_ = to_start, says_where_to_ = true;
    for (const Int code : {0, 10, 20, 30, 730, 740, 810, 820, 830, 840, 850, 890}) {
      if (!takes_g(code)) continue;
      if (!gs_.empty()) fail("more than one motion");
      if (motion_ == kCalled && code == 0) continue;  // the cycle follows the rapid to each place
      if (motion_ == kCalled) fail("a motion while a cycle is called");
      goes_on_ = motion_ > 700;
      motion_ = code;
      begins_ = code > 700;
    }
    if (!gs_.empty())
      fail("G" + text(gs_[0] / 10) + (gs_[0] % 10 ? "." + text(gs_[0] % 10) : "") + " is not claimed");
  }
  /// M words, and T words: with M6 or, on controls without it, alone.
  void tools() {
    std::optional<Int> tool = std::exchange(inserted_, std::nullopt);
    bool changes = false;
    const bool called = has('T');
    for (const Int code : ms_) {
      const Int m = code / 10;
      if (code % 10 != 0 || !(m <= 9 || m == 30 || (tape_ && (m == 83 || m == 84))))
        fail("M" + text(m) + " is not claimed");
      ended_ = ended_ || m == 2 || m == 30;
      changes = changes || m == 6;
    }
    if (has('T'))
      called_ = small(take('T'), 1);
    else if (changes && !called_)
      fail("M6 without T");
    if (changes && by_word_) fail("M6 after a T word without it");
    by_change_ = by_change_ || changes;
    by_word_ = by_word_ || (called && !by_change_);
    if (changes || (called && !by_change_)) tool = called_;
    if (tool && (has('X') || has('Y') || has('Z'))) fail("a tool change with a motion");
    const Int before = tool_;
    if (tool) change(*tool, changes);
    if (tool_ != before) lacks_length_ = has_length_;
  }
  /// To the machine's upper end: G53 G0 Z0, G91 G28 Z0; then to a place of its own.
  void go_home(bool incremental) {
    if (motion_ == kCalled) fail("a way home while a cycle is called");
    if (takes_g(0)) motion_ = 0;
    if (!gs_.empty() || !ms_.empty()) fail("a way home with other words");
    const bool up = has('Z');
    if (up && take('Z').digits != 0) fail("a way home other than Z0");
    if (up && (has('X') || has('Y')) && !at_home()) fail("a way home that does not go straight up first");
    if (up) home();
    for (const char c : {'X', 'Y'})
      if (has(c)) take(c), away();
    if (incremental) absolute_ = false;
  }
  void offsets() {
    Int offset = 0;
    for (const Int code : {540, 550, 560, 570, 580, 590, 591, 592, 593, 541, 1540}) {
      if (!takes_g(code)) continue;
      if (sinumerik_ && code >= 580) fail("G58 and G59 shift axes on this control, which is not claimed");
      offset = code * 1000;
      if ((code == 541 || code == 1540 || code == 590) && has('P')) offset += small(take('P'), 1);
    }
    for (Int code = 5050; sinumerik_ && code <= 5990; code += 10)
      if (takes_g(code)) offset = code * 1000;
    if (offset != 0 && offset != offset_ && moved()) fail("the work offset changes after the first motion");
    if (offset != 0) offset_ = offset;
  }
  void motion() {
    const std::optional<Int> x = axis('X'), y = axis('Y'), z = axis('Z');
    const bool arc_motion = motion_ == 20 || motion_ == 30, has_center = arc_motion && (has('I') || has('J'));
    Point center = place();
    if (has_center) center = center + Point{axis('I').value_or(0), axis('J').value_or(0)};
    if (!x && !y && !z && !has_center) return;
    if (motion_ < 0 || !absolute_) fail(motion_ < 0 ? "axis words without a motion" : "motion before G90");
    if (lacks_length_ && (z || !at_home()))
      fail("a motion without the tool's length, which the program set before");
    if (arc_motion && !has_center) fail("an arc without I and J");
    if (motion_ > 700) return cycle(x, y, z);
    arc_motion ? arc({x, y, z}, center, motion_ == 20) : straight({x, y, z}, motion_ == 0);
  }
  void cycle(std::optional<Int> x, std::optional<Int> y, std::optional<Int> z) {
    if (begins_ && (!z || !has('R') || !at_[2])) fail("a cycle without Z and R");
    if (begins_ && goes_on_ && start_ != *at_[2]) fail("a cycle begins within another, at another height");
    if (std::exchange(begins_, false)) start_ = *at_[2];
    if (motion_ == kCalled && (z || has('R'))) fail("a height between the calls of a cycle");
    if (z) bottom_ = *z;
    if (has('R')) clear_ = length('R');
    for (const char c : {'P', 'Q'}) words_.erase(c);
    if (motion_ != kCalled && !says_where_to_ && start_ != clear_) fail("a cycle without G98 or G99");
    drill(x, y, clear_, bottom_, to_start_ ? start_ : clear_);
  }

  std::map<char, Number> words_;
  std::vector<Int> gs_, ms_;  // ten times their numbers
  std::optional<Int> called_, inserted_;
  Int motion_ = -1, offset_ = 0, start_ = 0, clear_ = 0, bottom_ = 0;
  bool absolute_ = false, in_steps_ = false, tape_ = false, sinumerik_ = false, begun_ = false,
       to_start_ = true, says_where_to_ = false, begins_ = false, goes_on_ = false, by_change_ = false,
       by_word_ = false, has_length_ = false, lacks_length_ = false;
};

/// Heidenhain Klartext: L, CC, C, CP and cycles of holes.
class KlartextReader : Track {
 public:
  using Track::Track;
  void block(const Text& line) {
    ++line_;
    all_ += line.substr(0, line.find(';')) + " ";
    const std::size_t end = line.find_last_not_of(" \r");
    if (end != Text::npos && line[end] == '~') return;  // goes on in the next line
    const Text whole = std::exchange(all_, "");
    tokens_.clear();
    for (std::size_t i = 0; (i = whole.find_first_not_of(" \r", i)) != Text::npos;) {
      const std::size_t next = std::min(whole.find_first_of(" \r", i), whole.size());
      if (whole[i] != '~') tokens_.push_back(whole.substr(i, next - i));
      i = next;
    }
    if (tokens_.empty()) return;
    if (tokens_[0].find_first_not_of("0123456789") != Text::npos) fail("a block needs its number");
    tokens_.erase(tokens_.begin());
    if (tokens_.empty()) return;
    if (ended_ && (tokens_[0] != "END" || closed_)) fail("something follows the end of the program");
    ended_ = ended_ || tokens_[0] == "M30";
    read(tokens_[0], tokens_.size() > 1 ? tokens_[1] : "", tokens_.back());
  }

 private:
  void read(const Text& first, const Text& second, const Text& last) {
    static const std::set<Text> kHarmless{"M0", "M1", "M3", "M4", "M5", "M7", "M8", "M9", "M13", "M30"};
    if (first == "BEGIN" || first == "END") {
      if (second != "PGM" || (first == "BEGIN" && moved()) || (last != "MM" && last != "INCH"))
        fail("a unit is missing, or a second program begins");
      unit_ = last == "MM" ? kMillimetre : kInch;
      ended_ = closed_ = first == "END";
    } else if (first == "TOOL" && second == "CALL") {
      for (const Text& token : tokens_)
        if (token[0] == 'D') fail("a tool call with " + token);
      if (tokens_.size() > 2 && tokens_[2] != "Z") {
        if (tokens_.size() < 4 || tokens_[3] != "Z") fail("a tool call without its axis, Z");
        change(small(number(tokens_[2], 0), 1));
      }
    } else if (first == "CYCL" && second == "DEF" && tokens_.size() > 2) {
      define(tokens_[2], last);
    } else if (first == "CYCL" && second == "CALL" && tokens_.size() == 2) {
      if (cycle_.empty()) fail("a cycle that is not defined");
      const Int surface = cycle_.at("Q203");
      if (cycle_.at("Q201") > 0 || cycle_.at("Q200") < 0)
        fail("a cycle whose bottom is above its surface, which turns it over on this control");
      drill({}, {}, surface + cycle_.at("Q200"), surface + cycle_.at("Q201"),
            surface + std::max(cycle_.at("Q200"), cycle_.at("Q204")));
    } else if (first == "L") {
      line();
    } else if (first == "CC") {
      const Axes to = target({});
      if (!to[0] || !to[1] || to[2]) fail("a center needs X and Y");
      center_ = {{*to[0], *to[1]}};
    } else if (first == "C") {
      const Axes to = target({"DR+", "DR-", "R0"});
      if (!center_ || has("DR+") == has("DR-") || !to[0] || !to[1] || to[2])
        fail("an arc needs CC, X, Y and DR");
      arc(to, *center_, has("DR-"));
    } else if (first == "CP") {
      helix(second, last);
    } else if (!(first == "BLK" && second == "FORM") && !(tokens_.size() == 1 && kHarmless.count(first))) {
      fail("'" + first + "' is not claimed");
    }
  }
  void define(const Text& cycle, const Text& last) {
    if (cycle == "9.0" || cycle == "9.1" || cycle == "32.0") return;
    if (cycle == "32.1" && last[0] == 'T') {
      tolerance_ = 0;
      return blend(number(last, 1), false);
    }
    if (!std::set<Text>{"200", "201", "206", "207"}.count(cycle)) fail("cycle " + cycle + " is not claimed");
    // Heights, depths, feeds, times and the pitch; Q395 may count depths from the end of the cylinder.
    static const std::set<Text> kNumbers{"Q200", "Q201", "Q202", "Q203", "Q204",
                                         "Q206", "Q208", "Q210", "Q211", "Q239"};
    cycle_.clear();
    for (const Text& token : tokens_) {
      const std::size_t equal = token.find('=');
      if (equal == Text::npos) continue;
      if (!kNumbers.count(token.substr(0, equal)) &&
          (token.substr(0, equal) != "Q395" || number(token, equal + 1).digits != 0))
        fail("a cycle with " + token);
      cycle_[token.substr(0, equal)] = scaled(number(token, equal + 1), unit_, false, where());
    }
    for (const char* name : {"Q200", "Q201", "Q203", "Q204"})
      if (!cycle_.count(name)) fail(Text("a cycle without ") + name);
  }
  Number number(const Text& token, std::size_t from) {
    const Number n = number_at(token, from, false, where());
    if (from != token.size()) fail("'" + token + "' is not understood");
    return n;
  }
  Int length(const Text& token, std::size_t from) {
    return within_range(scaled(number(token, from), unit_, true, where()), where());
  }
  /// X, Y, Z, once each; what is left must be among `others` or a feed.
  Axes target(const std::set<Text>& others) {
    Axes to;
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
      const Text& token = tokens_[i];
      const std::size_t k = Text("XYZ").find(token[0]);
      const bool feed = token.size() > 1 && token[0] == 'F' && token[1] >= '0' && token[1] <= '9';
      if (k == Text::npos && !feed && !others.count(token)) fail("'" + token + "' is not understood");
      if (k != Text::npos && to[k]) fail("an axis stands twice");
      if (k != Text::npos) to[k] = length(token, 1);
    }
    return to;
  }
  bool has(const char* token) const { return std::count(tokens_.begin(), tokens_.end(), token) > 0; }
  void line() {
    const Axes to = target({"R0", "FMAX", "M91"});
    const bool up = to[2] == 0 && !to[0] && !to[1];
    if (!has("M91")) return to[0] || to[1] || to[2] ? straight(to, has("FMAX")) : void();
    if (!up && to[2]) fail("a way to the machine's own places below its upper end");
    up ? home() : away();
  }
  /// CP IPA+angle IZ-depth DR+. It ends where its angle says, within 2 nm of a whole place: that counts as blending in the plane. Its
  /// height is exact.
  void helix(const Text& angle, const Text& direction) {
    if (tokens_.size() < 4 || angle.substr(0, 3) != "IPA" || tokens_[2].substr(0, 2) != "IZ" || !center_ ||
        !known())
      fail("a helix needs CC, IPA, IZ and DR");
    const Int turn = scaled(number(angle, 3), 10'000, true, where()), rise = length(tokens_[2], 2);
    if (turn == 0 || turn > 3'600'000 || turn < -3'600'000 || !has(turn > 0 ? "DR+" : "DR-") ||
        has(turn > 0 ? "DR-" : "DR+"))
      fail("a helix of more than a turn, or that turns another way than it says: " + direction);
    tokens_.erase(tokens_.begin() + 1, tokens_.begin() + 3);
    target({"DR+", "DR-"});
    const bool whole = turn == 3'600'000 || turn == -3'600'000;
    const Point end = whole ? place() : *center_ + turned(place() - *center_, turn);
    out_.rounding += 2;
    arc({within_range(end.x, where()), within_range(end.y, where()), *at_[2] + rise}, *center_, turn < 0);
  }

  Text all_;
  std::vector<Text> tokens_;
  std::map<Text, Int> cycle_;
  std::optional<Point> center_;
  bool closed_ = false;
};

Program read_program(const Text& in, const Text& file, Int top) {
  Program out;
  IsoReader iso(file, out, top);
  KlartextReader klartext(file, out, top);
  const std::size_t start = std::min(in.find_first_not_of(" \t\r\n"), in.size());
  const bool plain = in.compare(start, 11, "0 BEGIN PGM") == 0;
  out.stated = plain;
  Int number = 0;
  for (std::size_t at = 0, end = 0; at < in.size(); at = end + 1) {
    ++number;
    end = std::min(in.find('\n', at), in.size());
    Text line = in.substr(at, end - at);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    for (const unsigned char c :
         line)  // some controls begin a line, or stop, at such characters, in comments too
      if ((c < ' ' && c != '\t') || c > '~')
        reject(file + ":" + text(number) + ": a character that is none of ASCII's printed ones");
    plain ? klartext.block(line) : iso.block(line);
  }
  out.lift = out.blending;
  out.blending += out.rounding;
  return out;
}

// ------------------------------------------------------------------------------------------ the witness

/// What is asked, in nm.
struct Question {
  Int uncut = 10'000;     // u: how far beyond the cutter's reach in the program the floor may lie
  Int beyond = 100;       // e: centers this much closer to a wall than they may be count as out of reach
  Int gouge = 1'500;      // g: how far the cutter may reach into walls and floor
  Int rapid = 20'000;     // r: how far from the cutter's rim rapids may touch material
  Int level = 2'000;      // f: how far above the floor a move may be that cuts it
  Int diameter = 0;       // 0: as the witness says
  Int engagement = 0;     // greatest permitted engagement in millionths of a degree, 0: any
  bool straight = false;  // whether rapids are straight on every control
  bool each = false;      // whether the engagement of each move is printed
  bool partial = false;   // whether features without a claim, and tools that are not stated, are let pass
};
/// A cylinder that begins `point` above the tip; number 0 is the tool that is in before any is called.
struct Tool {
  Int number = 0, radius = 0, point = 0;
};
struct Tile {
  Int label = 0;       // as in docs/witness.md
  std::size_t of = 0;  // move or wall
  std::vector<std::size_t> corners;
  Points hull;
  Wide slack = 0;  // s: how far its pieces of the boundary are from their walls
};
using Tiles = std::vector<Tile>;
/// That a feature is cut: as far as a cutter of this radius can reach, but for stock to leave.
struct Claim {
  std::size_t feature = 0;
  Int radius = 0, wall_stock = 0, floor_stock = 0;
  Tiles cover, centre;
};
struct RapidTiles {
  std::size_t move = 0;
  Tiles tiles;
};
/// Directions, in tenths of a degree, in which an earlier move cut all that the rim of the cutter meets; the move's own number: where
/// there is no stock.
struct FreeSector {
  Int from = 0, size = 0;
  std::size_t by = 0;
};
struct RimPiece {
  Int steps = 0;
  std::vector<FreeSector> sectors;
};
struct RimMove {
  std::size_t move = 0;
  std::vector<RimPiece> pieces;
};
struct Witness {
  Text program_hash, part_hash;
  std::vector<Tool> tools;
  Points vertices;
  std::vector<Claim> claims;
  std::vector<RapidTiles> rapids;
  std::vector<RimMove> rims;
};

class WitnessReader {
 public:
  explicit WitnessReader(const Text& bytes) : bytes_(bytes) {}
  Witness whole() {
    if (take(4) != "CCW3") refuse("this is no witness of version 3");
    out_.program_hash = take(32), out_.part_hash = take(32);
    out_.tools.resize(count());
    for (Tool& tool : out_.tools) tool = {length(), length(), length()};
    out_.vertices.resize(count());
    Point at{-kLargest, -kLargest};
    for (Point& p : out_.vertices) {
      const Int dx = number();
      p = {at.x + dx, at.y + (dx > 0 ? signed_number() : 1 + number())};
      if (!p.in_range()) refuse("the witness has a vertex out of range");
      at = p;
    }
    out_.claims.resize(count());
    for (Claim& claim : out_.claims)
      claim = {std::size_t(length()), length(), length(), length(), tiles(), tiles()};
    out_.rapids.resize(count());
    for (RapidTiles& rapid : out_.rapids) rapid = {std::size_t(length()), tiles()};
    out_.rims.resize(count());
    for (RimMove& rim : out_.rims) {
      rim = {std::size_t(length()), std::vector<RimPiece>(count())};
      for (RimPiece& piece : rim.pieces) {
        piece = {length(), std::vector<FreeSector>(count())};
        for (FreeSector& sector : piece.sectors)
          sector = {length(), length(), rim.move - std::size_t(length())};
      }
    }
    if (at_ != bytes_.size()) refuse("the witness has bytes after its end");
    return out_;
  }

 private:
  Text take(std::size_t count) {
    if (bytes_.size() - at_ < count) refuse("the witness is cut off");
    return bytes_.substr((at_ += count) - count, count);
  }
  /// 7 bits a byte, low first, below 2^56, in the shortest form.
  Int number() {
    Int value = 0;
    for (int shift = 0; shift < 56; shift += 7) {
      const Int byte = static_cast<unsigned char>(take(1)[0]);
      value |= (byte & 127) << shift;
      if (byte < 128 && (byte > 0 || shift == 0)) return value;
      if (byte == 0) break;
    }
    refuse("the witness holds an overlong number at byte " + text(Int(at_)));
  }
  Int signed_number() {
    const Int value = number();
    return value % 2 ? -(value / 2) - 1 : value / 2;
  }
  Int length() {
    const Int value = number();
    if (value >= kLargest) refuse("the witness states a length or number out of range");
    return value;
  }
  /// The number of things to come, each of at least a byte.
  std::size_t count() {
    const Int value = number();
    if (value > Int(bytes_.size() - at_)) refuse("the witness is cut off");
    return std::size_t(value);
  }
  Tiles tiles() {
    Tiles tiles(count());
    Int of = 0, index = 0;
    for (Tile& tile : tiles) {
      tile.label = number();
      if (tile.label == 0) of += signed_number();
      if (of < 0 || of > kLargest) refuse("the witness names a move or wall that cannot be");
      tile.of = std::size_t(of);
      tile.corners.resize(count());
      Points points;
      for (std::size_t& corner : tile.corners) {
        index += signed_number();
        if (index < 0 || index >= Int(out_.vertices.size()))
          refuse("the witness names a vertex that it does not have");
        corner = std::size_t(index);
        points.push_back(out_.vertices[corner]);
      }
      if (points.empty()) refuse("the witness has a tile without corners");
      tile.hull = hull_of(std::move(points));
    }
    return tiles;
  }
  const Text& bytes_;
  std::size_t at_ = 0;
  Witness out_;
};

/// A directed edge of tiles that nothing cancels, and a tile that has it.
struct Loose {
  std::size_t from, to, owner;
  bool used = false;
};
/// D of lemma L1, by where they start.
std::vector<Loose> loose_edges(const Tiles& tiles) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> open;  // by ends; owners
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const auto& corners = tiles[i].corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::size_t a = corners[k], b = corners[(k + 1) % corners.size()];
      const auto back = open.find({b, a});
      if (a == b) continue;
      if (back == open.end())
        open[{a, b}].push_back(i);
      else if (back->second.pop_back(); back->second.empty())
        open.erase(back);
    }
  }
  std::vector<Loose> loose;
  for (const auto& [ends, owners] : open)
    for (const std::size_t owner : owners) loose.push_back({ends.first, ends.second, owner});
  return loose;
}
/// How far the piece from u to v is from the wall at most, -1 where it does not follow it.
Wide slack_of(const Curve& c, Point u, Point v) {
  if (!c.arc) {
    Wide t = 1;
    while (t <= kWidestPiece && !(near_segment(u, c.a, c.b, t) && near_segment(v, c.a, c.b, t))) t *= 2;
    return t <= kWidestPiece ? t : -1;
  }
  const Point from = (c.clockwise ? v : u) - c.center, to = (c.clockwise ? u : v) - c.center;
  const auto passes = [&](Point ray) { return cross(from, ray) > 0 && cross(ray, to) > 0; };
  const auto along = [](Point p, Point ray) { return cross(p, ray) == 0 && dot(p, ray) > 0; };
  // Forward from the last ray, or on to the first one, would be a second turn.
  if (along(from, c.last) || along(to, c.first)) return -1;
  if (cross(from, to) <= 0 || !c.sees(from) || !c.sees(to) || passes(c.first) || passes(c.last)) return -1;
  const Wide error = chord_error(c, from, to);
  return error <= kWidestPiece ? error : -1;
}
/// L1: the loose edges are one chain along each wall; each tile then knows how far its pieces are from them.
void take_slack(Tiles& tiles, const Region& region, const Points& vertices, const Text& name) {
  std::vector<Loose> loose = loose_edges(tiles);
  for (const Wall& wall : region.walls) {
    const auto start = std::lower_bound(vertices.begin(), vertices.end(), wall.curve.a);
    if (start == vertices.end() || *start != wall.curve.a)
      refuse(name + "lacks the corner at " + wall.curve.a.place());
    std::size_t at = std::size_t(start - vertices.begin());
    while (vertices[at] != wall.curve.b) {
      auto edge = std::lower_bound(loose.begin(), loose.end(), at,
                                   [](const Loose& e, std::size_t from) { return e.from < from; });
      Wide slack = -1;
      for (; edge != loose.end() && edge->from == at; ++edge)
        if (!edge->used && (slack = slack_of(wall.curve, vertices[at], vertices[edge->to])) >= 0) break;
      if (slack < 0) refuse(name + "leaves its wall at " + vertices[at].place());
      edge->used = true;
      tiles[edge->owner].slack = std::max(tiles[edge->owner].slack, slack);
      at = edge->to;
    }
  }
  for (const Loose& edge : loose)
    if (!edge.used) refuse(name + "has an edge along no wall at " + vertices[edge.from].place());
}

// ------------------------------------------------------------------------------------------ the claims

/// The part of a move's path where `point` above it is no higher than `level`, but for 1 nm; of arcs that slope one end alone.
Curve low_part(const Move& move, Int point, Int level) {
  const Int high = std::max(move.z0, move.z1) + point, low = move.lowest() + point;
  if (high <= level) return move.path;
  const Point from = move.z0 < move.z1 ? move.path.a : move.path.b,
              d = (move.z0 < move.z1 ? move.path.b : move.path.a) - from;
  const auto share = [&](Int along) {
    return move.path.arc ? 0 : Int(nearest_quotient(Wide(along) * (level - low), high - low));
  };
  return {from, from + Point{share(d.x), share(d.y)}};
}
/// Whether all of `hull` lies within t of that part (L2 to L4).
bool cut_by(const Move& move, Int point, const Points& hull, Wide t, Int level) {
  return move.lowest() + point <= level && near_curve(low_part(move, point, level), hull, t - 1);
}

const Tool* tool_numbered(const std::vector<Tool>& tools, Int number) {
  for (const Tool& tool : tools)
    if (tool.number == number) return &tool;
  return nullptr;
}
/// Places along a move: its chords', or no more than 0.02 mm apart.
Points steps_of(const Curve& path) {
  Points points = chords_of(path, kStepChord).points;
  if (path.arc) return points;
  const Point d = path.b - path.a;
  const Int count = Int(root_up(square(d))) / kStep + 1;
  points = {path.a};
  for (Int k = 1; k <= count; ++k)
    points.push_back(path.a + Point{Int(nearest_quotient(Wide(d.x) * k, count)),
                                    Int(nearest_quotient(Wide(d.y) * k, count))});
  return points;
}

/// Engagement (C4): directions are whole tenths of a degree, counter-clockwise from x.
class Rim {
 public:
  Rim(const Part& part, const Program& program, const std::vector<Tool>& tools)
      : part_(part), program_(program), tools_(tools) {}
  /// Level feeds below the top, by tools of the witness.
  bool concerns(const Move& move) const {
    return !move.rapid && move.z0 == move.z1 && move.z0 < part_.top && tool_numbered(tools_, move.tool);
  }
  /// L7: whether the rim in these directions is in what was cut before, on all of move i from place p to q.
  bool is_free(std::size_t i, Point p, Point q, const FreeSector& sector) const {
    const Move& move = program_.moves[i];
    const Wide radius = tool_numbered(tools_, move.tool)->radius - kRim - 2 * Wide(program_.blending);
    if (radius <= 0 || sector.size < 1 || sector.size > kQuarter || sector.from >= 4 * kQuarter) return false;
    const Point a = ray(Int(radius), sector.from), b = ray(Int(radius), sector.from + sector.size),
                sum = a + b;
    const auto out = [&](Int along) {
      return Int(nearest_quotient(Wide(along) * radius * radius, radius * radius + dot(a, b)));
    };
    const Point tip{out(sum.x), out(sum.y)};
    const Points hull = hull_of({p + a, q + a, p + tip, q + tip, p + b, q + b});
    const Wide off = bend(move.path, p, q) + kRays + 2 * Wide(program_.blending);
    if (sector.by == i) return part_.stock && !part_.stock->meets(box_of(hull).grown(off));
    if (sector.by > i || program_.moves[sector.by].rapid) return false;
    const Move& before = program_.moves[sector.by];
    const Tool* tool = tool_numbered(tools_, before.tool);
    return tool && cut_by(before, tool->point, hull, tool->radius - off, move.z0);
  }
  /// Tenths of a degree in front of the cutter that may be in material on move i from steps[from] to steps[to]; all sectors must be
  /// free.
  Int engaged(std::size_t i, const Points& steps, std::size_t from, std::size_t to,
              const std::vector<FreeSector>& sectors) const {
    const Curve& path = program_.moves[i].path;
    const Point p = steps[from], q = steps[to], u = (p - path.center).left(), v = (q - path.center).left();
    Int first = path.arc ? tick_of(path.clockwise ? Point{} - v : u) : tick_of(path.b - path.a), last = first;
    if (path.arc) last = tick_of(path.clockwise ? Point{} - u : v);
    for (std::size_t k = from + 1; k <= to && path.arc;
         ++k) {  // an arc's piece turns by less than 90 degrees
      const Point w = (steps[k] - path.center).left();
      if (dot(u, w) <= 0 || (cross(u, w) > 0) == path.clockwise)
        refuse(program_.moves[i].name() + "has a piece of its rim that turns too far");
    }
    std::vector<bool> free(4 * kQuarter);
    for (const FreeSector& sector : sectors) {
      if (!is_free(i, p, q, sector))
        refuse(program_.moves[i].name() + "may meet material from " + p.place() + " to " + q.place());
      for (Int k = 0; k < sector.size; ++k) free[std::size_t((sector.from + k) % (4 * kQuarter))] = true;
    }
    Int engaged = 1;  // for the rounding of rays
    for (Int k = -kQuarter; k <= kQuarter + (last - first + 4 * kQuarter) % (4 * kQuarter); ++k)
      engaged += !free[std::size_t((first + k + 4 * kQuarter) % (4 * kQuarter))];
    return std::min(engaged, 4 * kQuarter);
  }
  /// The last whole direction that v has reached.
  Int tick_of(Point v) const {
    Int quarters = 0, low = 0;
    for (; v.x <= 0 || v.y < 0; v = Point{v.y, -v.x}) ++quarters;
    for (Int bit = 512; bit > 0; bit /= 2)
      if (low + bit < kQuarter && cross(ray(kLargest, low + bit), v) >= 0) low += bit;
    return quarters * kQuarter + low;
  }
  static constexpr Int kQuarter = 900;

 private:
  static constexpr Int kRim =
      1'000;  // nm; how far within the cutter's rim engagement is measured, besides blending
  static constexpr Int kRays = 10;  // nm; rounding of rays and of their tangents' crossing
  /// How far any curve of the path may be from the chord pq.
  static Wide bend(const Curve& path, Point p, Point q) {
    return path.arc ? chord_error(path, p - path.center, q - path.center) : 1;
  }
  Point ray(Int length, Int tick) const {
    const auto [at, is_new] = rays_.try_emplace({length, tick % (4 * kQuarter)});
    if (is_new) at->second = turned({length, 0}, tick * 1'000);
    return at->second;
  }
  const Part& part_;
  const Program& program_;
  const std::vector<Tool>& tools_;
  mutable std::map<std::pair<Int, Int>, Point> rays_;
};

class Checker {
 public:
  Checker(const Question& asked, const Part& part, const Program& program, Witness& witness)
      : asked_(asked),
        part_(part),
        program_(program),
        witness_(witness),
        blend_(program.blending),
        lift_(program.lift),
        of_(part.features.size()) {
    for (Claim& claim : witness.claims) {
      if (claim.feature >= part.features.size() || of_[claim.feature])
        refuse("the witness claims a feature twice, or one that the part does not have");
      if (!part.features[claim.feature].why_not.empty())
        refuse(name_of(claim) + "cannot be claimed: " + part.features[claim.feature].why_not);
      if (std::none_of(witness.tools.begin(), witness.tools.end(),
                       [&](const Tool& tool) { return tool.radius == claim.radius; }))
        refuse(name_of(claim) + "is claimed for a cutter that is none of the tools");
      of_[claim.feature] = &claim;
    }
    for (const Tool& tool : witness.tools) {
      if (tool.radius < 10'000 || tool_of(tool.number) != &tool)
        refuse("the witness states a tool twice, or too narrow a one");
      if (asked.diameter != 0 && 2 * tool.radius != asked.diameter)
        refuse("the witness is about a cutter of diameter " + mm(2 * tool.radius) + " mm");
    }
  }
  Text name_of(const Claim& claim) const {
    return "feature " + text(Int(claim.feature)) + " (" + part_.features[claim.feature].name + ") ";
  }

  /// C2: below the top each move stays in one of the features, deep enough for it.
  void check_gouges() const {
    std::size_t last = 0;
    for (const Move& move : program_.moves) {
      const Tool* tool = tool_of(move.tool);
      if (!tool || move.lowest() - lift_ >= part_.top) continue;
      const Chords chords = move.rapid ? Chords{corridor(move), 0} : chords_of(move.path);
      Text why = "goes below all floors";
      std::size_t tried = 0;
      for (; tried < of_.size(); ++tried) {
        const std::size_t i = (last + tried) % of_.size();
        if (!stays_in(i, move, *tool, chords, why)) continue;
        last = i;
        break;
      }
      if (tried == of_.size()) refuse(move.name() + why);
    }
  }
  /// C1.
  void check_cover(Claim& claim) const {
    const Feature& feature = part_.features[claim.feature];
    const Wide legal = Wide(claim.radius) + claim.wall_stock + asked_.beyond;
    take_slack(claim.cover, feature.target, witness_.vertices, name_of(claim) + "cover ");
    if (!claim.centre.empty())
      take_slack(claim.centre, feature.allowed, witness_.vertices, name_of(claim) + "centre ");
    std::vector<Box> boxes;
    std::vector<const Tile*> maybe;
    for (const Tile& tile : claim.centre) {
      const Text name = name_of(claim) + "centre tile at " + tile.hull[0].place();
      if (tile.slack + 1 >= legal) refuse(name + " is too far from its wall");
      if (tile.label == 1)
        maybe.push_back(&tile), boxes.push_back(box_of(tile.hull));
      else if (tile.label != 0 || tile.of >= feature.allowed.walls.size() ||
               !near_curve(feature.allowed.walls[tile.of].curve, tile.hull, legal - 1))
        refuse(name + " is called illegal and is not near wall " + text(Int(tile.of)));
    }
    const Grid grid(boxes);
    if (std::none_of(claim.cover.begin(), claim.cover.end(),
                     [](const Tile& tile) { return tile.label == 0; }))
      refuse(name_of(claim) + "is claimed, and nothing of it is cut");
    for (const Tile& tile : claim.cover) {
      const Text name = name_of(claim) + "cover tile at " + tile.hull[0].place();
      const Wide reach = Wide(claim.radius) + tile.slack + 1;
      if (tile.label == 1 &&
          (claim.centre.empty() || !grid.visit_all(box_of(tile.hull).grown(reach), [&](std::size_t k) {
            return apart(tile.hull, maybe[k]->hull, reach);
          })))
        refuse(name + " is called out of reach and is not");
      if (tile.label > 1 ||
          (tile.label == 0 && !is_cut(tile, asked_.uncut - blend_ - tile.slack - 1, program_.moves.size(),
                                      feature.floor + claim.floor_stock + asked_.level - lift_, true)))
        refuse(name + " is not cut by " + move_name(tile.of));
    }
  }
  /// C3.
  void check_rapids() const {
    std::size_t next = 0;
    for (std::size_t i = 0; i < program_.moves.size(); ++i) {
      const Move& move = program_.moves[i];
      const Tool* tool = tool_of(move.tool);
      if (!tool || !move.rapid || move.lowest() >= part_.top || move.only_rises()) continue;
      if (next >= witness_.rapids.size() || witness_.rapids[next].move != i)
        refuse(move.name() + "is a rapid without tiles");
      check_rapid(witness_.rapids[next++].tiles, i, *tool);
    }
    if (next != witness_.rapids.size()) refuse("the witness has tiles for a move that needs none");
  }
  /// C4, in words; with the engagement of each move where `each`.
  Text check_engagement(bool each) const {
    const Rim rim(part_, program_, witness_.tools);
    Int most = 0, widest = 0, count = 0, others = 0, first = 0;
    std::size_t next = 0;
    Text list;
    for (std::size_t i = 0; i < program_.moves.size(); ++i) {
      const Move& move = program_.moves[i];
      if (!rim.concerns(move)) continue;
      if (next >= witness_.rims.size() || witness_.rims[next].move != i) {
        first = others++ ? first : move.line;
        continue;
      }
      const Points steps = steps_of(move.path);
      std::size_t at = 0;
      Int engaged = 0;
      for (const RimPiece& piece : witness_.rims[next++].pieces) {
        if (piece.steps < 1 || piece.steps >= Int(steps.size() - at))
          refuse(move.name() + "has too long a rim");
        const std::size_t to = at + std::size_t(piece.steps);
        engaged = std::max(engaged, rim.engaged(i, steps, at, to, piece.sectors));
        at = to;
      }
      if (at + 1 != steps.size()) refuse(move.name() + "has a rim that ends before it");
      if (asked_.engagement > 0 && engaged * (kMillimetre / 10) > asked_.engagement)
        refuse(move.name() + "has an engagement of up to " + mm(engaged * (kMillimetre / 10)) + " degrees");
      ++count;
      if (engaged > most) most = engaged, widest = move.line;
      if (each) list += "  line " + text(move.line) + " " + mm(engaged * (kMillimetre / 10)) + "\n";
    }
    if (next != witness_.rims.size()) refuse("the witness has rims for a move that needs none");
    if (others > 0 && asked_.engagement > 0 && asked_.engagement < 180 * kMillimetre)
      refuse("line " + text(first) + " of the program is a level feed without a rim");
    if (count == 0) return "";
    return "C4 engagement: at most " + mm(most * (kMillimetre / 10)) + " degrees (line " + text(widest) +
           ") on " + text(count) + " level feeds; " +
           (others ? "not claimed on " + text(others) + " more, the first in line " + text(first) + "\n"
                   : "no others\n") +
           list;
  }

 private:
  const Tool* tool_of(Int number) const { return tool_numbered(witness_.tools, number); }
  Text move_name(std::size_t k) const {
    return k < program_.moves.size() ? program_.moves[k].name() : "a move that the program does not have";
  }
  /// Where a rapid may run: straight, or anywhere between its ends where the control moves its axes one by one.
  Points corridor(const Move& move) const {
    const Point a = move.path.a, b = move.path.b;
    if (!program_.dogleg || a.x == b.x || a.y == b.y) return {a, b};
    return {a, {b.x, a.y}, b, {a.x, b.y}, a};
  }
  /// Whether the segment ab stays farther than t from a polyline, and from what it encloses where it is a rectangle.
  static bool clear_of(const Points& around, Point a, Point b, Wide t) {
    for (std::size_t k = 1; k < around.size(); ++k)
      if (!segments_apart(a, b, around[k - 1], around[k], t)) return false;
    return true;
  }
  bool stays_in(std::size_t i, const Move& move, const Tool& tool, const Chords& chords, Text& why) const {
    const Region& region = part_.features[i].allowed;
    const Claim* claim = of_[i];
    const Wide floor =
        Wide(part_.features[i].floor) + (claim ? claim->floor_stock : 0) - asked_.gouge + lift_;
    const Wide reach =
        Wide(tool.radius) + (claim ? claim->wall_stock : 0) - asked_.gouge + blend_ + 1 + chords.error;
    if (move.lowest() + (part_.features[i].through ? tool.point : 0) < floor || region.walls.empty())
      return false;
    why = "is outside of all features";
    if (reach <= 0 || region.winding(move.path.a, region.outlines) != 1) return false;
    const bool area = move.rapid && chords.points.size() > 2;
    const auto clear = [&](const Points& path) {
      return region.grid.visit_all(box_of(path).grown(reach), [&](std::size_t k) {
        const Segment& s = region.segments[k];
        const bool inside = area && box_of(chords.points).meets(box_of({s.a}));
        if (!inside && clear_of(path, s.a, s.b, reach + s.error)) return true;
        why = "comes too close to a wall near " + s.a.place();
        return false;
      });
    };
    for (std::size_t k = 1; k < chords.points.size() && !area; ++k)
      if (!clear({chords.points[k - 1], chords.points[k]})) return false;
    return !area || clear(chords.points);
  }
  /// Whether an earlier feed `of` cuts all within `beyond` of its radius; floors are those of tips, also of pointed ones.
  bool is_cut(const Tile& tile, Wide beyond, std::size_t before, Wide level, bool floors) const {
    if (tile.of >= before || program_.moves[tile.of].rapid) return false;
    const Tool* tool = tool_of(program_.moves[tile.of].tool);
    return tool && cut_by(program_.moves[tile.of], floors ? 0 : tool->point, tile.hull, tool->radius + beyond,
                          Int(level));
  }
  /// L1b.
  void check_rapid(const Tiles& tiles, std::size_t i, const Tool& tool) const {
    const Move& move = program_.moves[i];
    const Wide radius = Wide(tool.radius) - asked_.rapid + blend_;
    const Points around = corridor(move);
    Int turns = 0;
    for (const Loose& edge : loose_edges(tiles)) {
      const Point a = witness_.vertices[edge.from], b = witness_.vertices[edge.to];
      if (!clear_of(around, a, b, radius + 1) || (around.size() > 2 && box_of(around).meets(box_of({a}))))
        refuse(move.name() + "is not held by its tiles");
      turns += turn_about(move.path.a, a, b);
    }
    if (turns == 0 || radius < 0) refuse(move.name() + "is not held by its tiles");
    for (const Tile& tile : tiles) {
      const bool air = tile.label == 2 && part_.stock && !part_.stock->meets(box_of(tile.hull));
      if (!air && (tile.label != 0 || !is_cut(tile, -blend_ - 1, i, move.lowest() - 2 * lift_, false)))
        refuse(move.name() + "runs through a tile at " + tile.hull[0].place() +
               " that is not cut before by " + move_name(tile.of));
    }
  }

  const Question& asked_;
  const Part& part_;
  const Program& program_;
  const Witness& witness_;
  Wide blend_, lift_;
  std::vector<const Claim*> of_;  // by feature
};

/// Throws Refusal where a claim does not follow; else the claims that hold.
Text check(const Question& asked, const Text& program_text, const Text& program_name, const Text& part_text,
           const Text& part_name, const Text& witness_text) {
  const Part part = read_part(part_text, part_name);
  Program program = read_program(program_text, program_name, part.top);
  program.dogleg = program.dogleg && !asked.straight;
  Witness witness = WitnessReader(witness_text).whole();
  const Text program_hash = sha256(program_text), part_hash = sha256(part_text);
  if (witness.program_hash != program_hash)
    refuse("the witness is about another program (SHA-256 " + hex(witness.program_hash) + ")");
  if (witness.part_hash != part_hash)
    refuse("the witness is about another part (SHA-256 " + hex(witness.part_hash) + ")");
  Checker checker(asked, part, program, witness);
  Text tools, claimed, others;
  for (const Tool& tool : witness.tools)
    tools +=
        "proven for T" + text(tool.number) + (tool.point ? ", a drill" : ", a flat cutter") +
        " of diameter " + mm(2 * tool.radius) + " mm" +
        (tool.point ? ": floors are its tip's, walls begin above a point of " + mm(tool.point) + " mm" : "") +
        "\n";
  checker.check_gouges();
  std::set<std::size_t> has;
  for (Claim& claim : witness.claims) {
    checker.check_cover(claim);
    has.insert(claim.feature);
    claimed +=
        "  " + checker.name_of(claim) +
        (claim.centre.empty() ? "all of it"
                              : "what a cutter of diameter " + mm(2 * claim.radius) + " mm can reach") +
        (claim.wall_stock ? ", " + mm(claim.wall_stock) + " mm of stock left on walls" : "") +
        (claim.floor_stock ? ", " + mm(claim.floor_stock) + " mm of stock left on the floor" : "") + "\n";
  }
  checker.check_rapids();
  const Text engagement = checker.check_engagement(asked.each);
  for (std::size_t i = 0; i < part.features.size(); ++i)
    if (!has.count(i))
      others += "not proven to be cut: feature " + text(Int(i)) + " (" + part.features[i].name + ") " +
                part.features[i].why_not + "\n";
  std::set<Int> strange;
  for (const Move& move : program.moves)
    if (move.lowest() < part.top && !tool_numbered(witness.tools, move.tool)) strange.insert(move.tool);
  for (const Int tool : strange) others += "nothing is proven of T" + text(tool) + "\n";
  const Text claims =
      tools + "C1 nothing left: it lies within " + mm(asked.uncut) +
      " mm of what the program cuts, the tip at most " + mm(asked.level) +
      " mm above the floor, centers at least " + mm(asked.beyond) + " mm off the walls:\n" + claimed +
      "C2 nothing gouged: below the top each cutter stays in a feature, at most " + mm(asked.gouge) +
      " mm in walls and floor\n" + "C3 no rapid in material: all but a rim of " + mm(asked.rapid) +
      " mm of the cutter runs in what was cut before\n" + engagement + others + "program " +
      hex(program_hash) + "\npart " + hex(part_hash) + "\n" +
      (program.stated
           ? "path followed within " + mm(program.blending) + " mm, as the program says\n"
           : "taken as true: the control follows the path exactly; the program says nothing of it\n") +
      (program.dogleg ? "" : "taken as true: rapids are straight\n") +
      "taken as true: docs/claim.md, assumptions\n";
  if (!others.empty() && !asked.partial) refuse("not all is proven; --partial lets that pass:\n" + claims);
  return claims;
}

int run(int count, char** arguments) {
  Question asked;
  std::vector<Text> files;
  const std::map<Text, Int Question::*> options{
      {"--uncut", &Question::uncut},          {"--beyond", &Question::beyond},
      {"--gouge", &Question::gouge},          {"--rapid", &Question::rapid},
      {"--level", &Question::level},          {"--diameter", &Question::diameter},
      {"--engagement", &Question::engagement}};
  const std::map<Text, bool Question::*> flags{
      {"--straight", &Question::straight}, {"--each", &Question::each}, {"--partial", &Question::partial}};
  for (int i = 1; i < count; ++i) {
    const Text word = arguments[i], value = i + 1 < count ? arguments[i + 1] : "";
    const auto option = options.find(word);
    if (option == options.end() && word.substr(0, 2) != "--") {
      files.push_back(word);
      continue;
    }
    if (const auto flag = flags.find(word); flag != flags.end()) {
      asked.*(flag->second) = true;
      continue;
    }
    std::size_t end = 0;
    if (option == options.end())
      reject(word +
             " is no option; they are --uncut --beyond --gouge --rapid --level --diameter, each with mm, "
             "--engagement with degrees, --straight, --each and --partial");
    const Int nm = scaled(number_at(value, end, false, word), kMillimetre, true, word);
    if (end != value.size() || nm < 0 || nm >= kLargest ||
        (nm == 0 && (word == "--diameter" || word == "--engagement")))
      reject(word + ": '" + value + "' is no length in mm");
    asked.*(option->second) = nm;
    ++i;
  }
  if (files.size() != 3)
    reject(
        "usage: clearcut-check PROGRAM PART WITNESS [--uncut MM] [--gouge MM] [--rapid MM] [--diameter MM]");
  const Text claims =
      check(asked, read_file(files[0]), files[0], read_file(files[1]), files[1], read_file(files[2]));
  std::fputs(("accepted: " + files[0] + "\n" + claims).c_str(), stdout);
  return 0;
}

}  // namespace clearcut_check

#ifndef CLEARCUT_CHECK_WITHOUT_MAIN
int main(int count, char** arguments) {
  try {
    return clearcut_check::run(count, arguments);
  } catch (const clearcut_check::Refusal& refusal) {
    std::fputs(("refused: " + refusal.what + "\n").c_str(), stderr);
    return refusal.code;
  }
}
#endif
