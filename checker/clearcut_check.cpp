// clearcut-check PROGRAM PART WITNESS: checks a proof that a milling program makes a pocket. docs/claim.md states what is proven and
// why (its lemmas are named here, L1 to L6), docs/witness.md the bytes of a witness. This file needs nothing but a C++20 compiler
// with 128-bit integers:
//
//     g++ -std=c++20 -o clearcut-check clearcut_check.cpp
//
// Lengths are whole nanometres. Coordinates lie below 2^29, centres of arcs below 2^30, so that every product below fits 128 bits.
// There is no floating-point number in this file. What is not understood is refused.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace clearcut_check {

using Int = long long;
__extension__ typedef __int128 Wide;
using Text = std::string;

constexpr Int kLargest = Int(1) << 29;  // nm; coordinates of a part and a program
constexpr Int kHome = kLargest - 1;     // nm; height that stands for the machine's own upper end
constexpr Int kEdge = 4;                // nm; how far rounded corners may lie outside an arc's sector (L4)
constexpr Int kChord = 150;             // nm; how far chords may leave their arcs
constexpr Int kWidestPiece = 100'000;   // nm; how far a tiling's boundary may be from its wall
constexpr Int kRadiiDiffer = 20'000;    // nm; between an arc's start and end
constexpr Int kShortestArc = 2'000;     // nm; shorter ones may be full circles to some controls

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
/// A length in mm.
Text mm(Int nm) {
  const Int size = nm < 0 ? -nm : nm;
  Text digits = text(size % 1'000'000 + 1'000'000).substr(1);
  while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
  return (nm < 0 ? "-" : "") + text(size / 1'000'000) + "." + digits;
}

// ---------------------------------------------------------------------------------------------- exact geometry

struct Point {
  Int x = 0, y = 0;
  bool operator==(const Point&) const = default;
};
Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
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

Wide root_down(Wide value) {
  Wide root = 0;
  for (Wide bit = Wide(1) << 62; bit > 0; bit >>= 1)
    if (square(root + bit) <= value) root += bit;
  return root;
}
Wide root_up(Wide value) {
  const Wide root = root_down(value);
  return root * root == value ? root : root + 1;
}
/// value / by, to the nearest integer; by > 0.
Wide nearest_quotient(Wide value, Wide by) {
  const Wide half = by / 2;
  return value >= 0 ? (value + half) / by : -((-value + half) / by);
}
/// Whether `value` >= `bound` * |n|, exactly; bound may be negative.
bool reaches(Wide value, Wide bound, Point n) {
  if (value >= 0 && bound <= 0) return true;
  if (value < 0 && bound >= 0) return false;
  const bool larger = square(value) >= square(bound) * square(n);
  return value >= 0 ? larger : square(value) <= square(bound) * square(n);
}

using Points = std::vector<Point>;

/// The convex hull, counter-clockwise, without collinear points.
Points hull_of(Points points) {
  std::sort(points.begin(), points.end(),
            [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
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
  /// Whether it turns by no more than 90, by no more than 180 degrees.
  bool quarter() const { return !full() && cross(first, last) >= 0 && dot(first, last) >= 0; }
  bool half() const {
    return !full() && (cross(first, last) > 0 || (cross(first, last) == 0 && dot(first, last) < 0));
  }
  /// Whether direction v lies in its sector, ends included.
  bool sees(Point v) const {
    if (full()) return true;
    if (half())
      return cross(first, v) >= 0 && cross(v, last) >= 0 &&
             !(cross(first, v) == 0 && dot(first, v) < 0 && dot(last, v) < 0);
    return !(cross(last, v) > 0 && cross(v, first) > 0);
  }
};

/// Whether p is no farther than t from the segment ab.
bool near_segment(Point p, Point a, Point b, Wide t) {
  if (t < 0) return false;
  const Point d = b - a;
  const Wide along = dot(p - a, d);
  if (along <= 0) return square(p - a) <= square(t);
  if (along >= square(d)) return square(p - b) <= square(t);
  return square(cross(p - a, d)) <= square(t) * square(d);
}
bool segments_meet(Point a, Point b, Point c, Point d) {
  const auto side = [](Point p, Point q, Point r) {
    const Wide v = cross(q - p, r - p);
    return v > 0 ? 1 : v < 0 ? -1 : 0;
  };
  const int c1 = side(a, b, c), d1 = side(a, b, d), a2 = side(c, d, a), b2 = side(c, d, b);
  if (c1 * d1 < 0 && a2 * b2 < 0) return true;
  return near_segment(a, c, d, 0) || near_segment(b, c, d, 0) || near_segment(c, a, b, 0) ||
         near_segment(d, a, b, 0);
}
/// Whether two segments are farther apart than t.
bool segments_apart(Point a, Point b, Point c, Point d, Wide t) {
  return !segments_meet(a, b, c, d) && !near_segment(a, c, d, t) && !near_segment(b, c, d, t) &&
         !near_segment(c, a, b, t) && !near_segment(d, a, b, t);
}

/// Whether all of `hull` (seen from the center) lies in the sector, but for kEdge beyond its first and its last ray (L4).
bool in_sector(const Curve& c, const Points& hull) {
  const auto left_of = [&](Point ray, Int side) {
    return std::all_of(hull.begin(), hull.end(),
                       [&](Point v) { return reaches(side * cross(ray, v - c.center), -kEdge, ray); });
  };
  const auto before = [&](Point ray) {
    return std::all_of(hull.begin(), hull.end(),
                       [&](Point v) { return reaches(dot(ray, v - c.center), -kEdge, ray); });
  };
  if (c.full()) return true;
  if (c.half() || c.quarter()) {
    if (!left_of(c.first, 1) || !left_of(c.last, -1)) return false;
    return !c.quarter() || (before(c.first) && before(c.last));
  }
  if (left_of(c.first, 1) || left_of(c.last, -1)) return true;
  for (const Point n :
       {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}})  // half planes that the gap stays out of
    if (dot(n, c.first) <= 0 && dot(n, c.last) <= 0 && before(n)) return true;
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
  const Wide inside = c.high - t;  // the hull has to stay this far from the center
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point p = hull[i] - c.center, d = hull[(i + 1) % hull.size()] - hull[i];
    const Point normal{-d.y, d.x};
    if (d != Point{} && hull.size() > 2 && reaches(dot(normal, p), inside, normal)) return true;
    if (p != Point{} && std::all_of(hull.begin(), hull.end(),
                                    [&](Point v) { return reaches(dot(p, v - c.center), inside, p); }))
      return true;
    if (hull.size() == 2 && (reaches(cross(d, p), inside, d) || reaches(-cross(d, p), inside, d)))
      return true;
  }
  return false;
}

/// The same, or all of it no farther than t from one of the curve's ends (L3).
bool near_curve(const Curve& c, const Points& hull, Wide t) {
  return hull_within(c, hull, t) || hull_within({c.a, c.a}, hull, t) || hull_within({c.b, c.b}, hull, t);
}

/// Whether two hulls are at least t apart (L5).
bool apart(const Points& a, const Points& b, Wide t) {
  const auto separates = [&](Point n) {  // a on the lower side
    Wide most = dot(n, a[0]), least = dot(n, b[0]);
    for (const Point p : a) most = std::max(most, dot(n, p));
    for (const Point p : b) least = std::min(least, dot(n, p));
    return n != Point{} && reaches(least - most, t, n);
  };
  Point between = b[0] - a[0];
  for (const Point p : a)
    for (const Point q : b)
      if (square(q - p) < square(between)) between = q - p;
  if (separates(between)) return true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point d = a[(i + 1) % a.size()] - a[i];
    if (separates({d.y, -d.x}) || (a.size() == 2 && separates({-d.y, d.x}))) return true;
  }
  for (std::size_t i = 0; i < b.size(); ++i) {
    const Point d = b[(i + 1) % b.size()] - b[i];
    if (separates({-d.y, d.x}) || (b.size() == 2 && separates({d.y, -d.x}))) return true;
  }
  return false;
}

/// How far the chord uv, directions from the center, and the part of the curve that it spans are apart at most, measured along rays.
Wide chord_error(const Curve& c, Point u, Point v) {
  const Point d = v - u;
  Wide least = std::min(square(u), square(v));
  if (dot(u, d) < 0 && dot(v, d) > 0) least = square(cross(u, v)) / square(d);
  return std::max(Wide(c.high) - root_down(least), root_up(std::max(square(u), square(v))) - c.low);
}

/// Adds the chords from direction u to v (less than 180 degrees on) to `out`, without u: halved until they are near the curve.
void halve(const Curve& c, Point u, Point v, int depth, Points& out) {
  if (depth == 0 || (dot(u, v) > 0 && chord_error(c, u, v) <= kChord + (c.high - c.low) + 3))
    return out.push_back(v);
  const Point sum = u + v;
  const Wide size = root_down(square(sum)), radius = (Wide(c.low) + c.high) / 2;
  if (size == 0) return out.push_back(v);
  const Point middle{Int(nearest_quotient(sum.x * radius, size)),
                     Int(nearest_quotient(sum.y * radius, size))};
  halve(c, u, middle, depth - 1, out);
  halve(c, middle, v, depth - 1, out);
}

/// A polyline that stays within `error` of the curve, point by point in order (L6).
struct Chords {
  Points points;
  Wide error = 0;
};
Chords chords_of(const Curve& c) {
  if (!c.arc) return {{c.a, c.b}, 0};
  Points rays{c.first};  // from the center, counter-clockwise, ends as they are
  const Int r = (c.low + c.high) / 2;
  std::array<Point, 4> axes{{{r, 0}, {0, r}, {-r, 0}, {0, -r}}};
  const auto start = std::find_if(axes.begin(), axes.end(),
                                  [&](Point a) { return cross(c.first, a) > 0 && dot(c.first, a) >= 0; });
  if (start == axes.end()) reject("an arc is too small to be divided");
  std::rotate(axes.begin(), start, axes.end());
  const Point end = c.last;
  for (const Point axis : axes) {  // those that the curve passes before its end
    const bool passes_end = cross(rays.back(), end) > 0 && cross(end, axis) >= 0;
    if (passes_end || axis == end) break;
    rays.push_back(axis);
  }
  Chords out{{c.first}, 0};
  for (std::size_t i = 1; i < rays.size(); ++i) halve(c, rays[i - 1], rays[i], 24, out.points);
  halve(c, rays.back(), end, 24, out.points);
  for (std::size_t i = 1; i < out.points.size();
       ++i) {  // nothing of the construction is trusted: turns, sector, distance
    const Point u = out.points[i - 1], v = out.points[i];
    const bool past = !c.full() && cross(u, end) >= 0 && dot(u, end) >= 0 && cross(end, v) > 0;
    if (cross(u, v) <= 0 || !c.sees(v) || past) reject("an arc is too small to be divided");
    out.error = std::max(out.error, chord_error(c, u, v));
  }
  if (c.full()) {  // exactly one turn: `first` is passed at the end alone
    for (std::size_t i = 1; i + 1 < out.points.size(); ++i)
      if (cross(out.points[i - 1], c.first) > 0 && cross(c.first, out.points[i]) >= 0)
        reject("an arc turns more than once");
  }
  for (Point& p : out.points) p = p + c.center;
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

/// Boxes, and which of them meet one: a tree of halves.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes)
      : boxes_(std::move(boxes)), order_(boxes_.size()), nodes_(4 * boxes_.size() + 4) {
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
    if (!order_.empty()) build(0, 0, order_.size());
  }
  /// Stops, and returns false, where `visit` returns false.
  bool visit_all(const Box& box, const std::function<bool(std::size_t)>& visit) const {
    return order_.empty() || ask(0, 0, order_.size(), box, visit);
  }

 private:
  void build(std::size_t node, std::size_t from, std::size_t to) {
    Box& all = nodes_[node];
    for (std::size_t i = from; i < to; ++i)
      all.add({boxes_[order_[i]].x0, boxes_[order_[i]].y0}),
          all.add({boxes_[order_[i]].x1, boxes_[order_[i]].y1});
    if (to - from < 2) return;
    const bool wide = all.x1 - all.x0 > all.y1 - all.y0;
    const std::size_t middle = (from + to) / 2;
    const auto place = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
    std::nth_element(order_.begin() + place(from), order_.begin() + place(middle), order_.begin() + place(to),
                     [&](std::size_t a, std::size_t b) {
                       return wide ? boxes_[a].x0 + boxes_[a].x1 < boxes_[b].x0 + boxes_[b].x1
                                   : boxes_[a].y0 + boxes_[a].y1 < boxes_[b].y0 + boxes_[b].y1;
                     });
    build(2 * node + 1, from, middle);
    build(2 * node + 2, middle, to);
  }
  bool ask(std::size_t node, std::size_t from, std::size_t to, const Box& box,
           const std::function<bool(std::size_t)>& visit) const {
    if (!nodes_[node].meets(box)) return true;
    if (to - from == 1) return visit(order_[from]);
    const std::size_t middle = (from + to) / 2;
    return ask(2 * node + 1, from, middle, box, visit) && ask(2 * node + 2, middle, to, box, visit);
  }
  std::vector<Box> boxes_;
  std::vector<std::size_t> order_;
  std::vector<Box> nodes_;
};

/// v turned by an angle in 1/10000 degrees, to the nearest place but for 1 nm. Series for sine and cosine of less than 90 degrees in units of 2^-60.
Point turned(Point v, Int angle) {
  angle = (angle % 3'600'000 + 3'600'000) % 3'600'000;
  for (; angle >= 900'000; angle -= 900'000) v = {-v.y, v.x};
  const Wide one = Wide(1) << 60, pi = 3'622'009'729'038'561'421;  // pi * 2^60
  const Wide x = pi * angle / 1'800'000;
  Wide term = one, cosine = 0, sine = 0;
  for (int n = 0; n < 40; ++n) {
    (n % 2 ? sine : cosine) += n % 4 < 2 ? term : -term;
    term = term * x / one / (n + 1);
  }
  return {Int(nearest_quotient(v.x * cosine - v.y * sine, one)),
          Int(nearest_quotient(v.x * sine + v.y * cosine, one))};
}

// ---------------------------------------------------------------------------------------------- numbers and files

/// digits * 10^exponent; `point` where one was written.
struct Number {
  Wide digits = 0;
  int exponent = 0;
  bool point = false;
};
/// Reads a number at `at` and moves it on; at most 18 digits count, later ones are cut off where `cut`, else refused.
Number number_at(std::string_view in, std::size_t& at, bool cut, const Text& where) {
  Number out;
  bool negative = false, any = false;
  int count = 0;
  if (at < in.size() && (in[at] == '+' || in[at] == '-')) negative = in[at++] == '-';
  for (; at < in.size() && (in[at] == '.' || (in[at] >= '0' && in[at] <= '9')); ++at) {
    if (in[at] == '.') {
      if (out.point) reject(where + ": a number with two points");
      out.point = true;
      continue;
    }
    any = true;
    if (count >= 18) {
      if (!cut) reject(where + ": a number with more than 18 digits");
      if (!out.point) ++out.exponent;
      continue;
    }
    out.digits = out.digits * 10 + (in[at] - '0');
    if (out.digits != 0) ++count;
    if (out.point) --out.exponent;
    if (out.exponent < -1000) reject(where + ": a number with too many digits");
  }
  if (!any) reject(where + ": a number is missing");
  if (negative) out.digits = -out.digits;
  return out;
}
/// The value in units of 1 / `unit`, to the nearest; `exact` refuses what is no whole number of them.
Int scaled(Number n, Int unit, bool exact, const Text& where) {
  Wide value = n.digits * unit;
  for (; n.exponent > 0 && value != 0; --n.exponent) {
    if (value > (Wide(1) << 100) || value < -(Wide(1) << 100)) reject(where + ": a number is too large");
    value *= 10;
  }
  Wide by = 1;
  for (; n.exponent < 0 && by < Wide(1'000'000'000'000'000'000) * 1'000'000'000'000'000'000; ++n.exponent)
    by *= 10;
  if (n.exponent < 0) value = 0;  // below 1e-12 nm
  if (exact && (value % by != 0 || n.exponent < 0))
    reject(where + ": a length is no whole number of nanometres");
  value = nearest_quotient(value, by);
  if (value > (Wide(1) << 60) || value < -(Wide(1) << 60)) reject(where + ": a number is too large");
  return Int(value);
}
Int within_range(Int nm, const Text& where) {
  if (nm >= kLargest || nm <= -kLargest) reject(where + ": a coordinate is beyond 536.87 mm");
  return nm;
}
constexpr Int kMillimetre = 1'000'000, kInch = 25'400'000;

Text read_file(const Text& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) reject(path + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// SHA-256 (FIPS 180-4) as 32 bytes. Its constants are the first bits of roots of primes, taken here by integers.
Text sha256(Text data) {
  std::array<std::uint32_t, 64> k{};
  std::array<std::uint32_t, 8> h{};
  std::size_t count = 0;
  for (Int n = 2; count < 64; ++n) {
    bool prime = true;
    for (Int d = 2; d * d <= n; ++d) prime = prime && n % d != 0;
    if (!prime) continue;
    if (count < 8) h[count] = static_cast<std::uint32_t>(root_down(Wide(n) << 64));
    Wide cube_root = 0;
    for (Wide bit = Wide(1) << 35; bit > 0; bit >>= 1)
      if ((cube_root + bit) * (cube_root + bit) * (cube_root + bit) <= Wide(n) << 96) cube_root += bit;
    k[count++] = static_cast<std::uint32_t>(cube_root);
  }
  const std::uint64_t bits = data.size() * 8;
  data += char(0x80);
  while (data.size() % 64 != 56) data += char(0);
  for (int shift = 56; shift >= 0; shift -= 8) data += static_cast<char>(bits >> shift);
  const auto turned = [](std::uint32_t v, int by) { return (v >> by) | (v << (32 - by)); };
  for (std::size_t at = 0; at < data.size(); at += 64) {
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 64; ++i)
      w[i / 4] = i / 4 < 16 ? (w[i / 4] << 8) | static_cast<unsigned char>(data[at + i]) : 0;
    for (std::size_t i = 16; i < 64; ++i) {
      const std::uint32_t a = w[i - 15], b = w[i - 2];
      w[i] = w[i - 16] + (turned(a, 7) ^ turned(a, 18) ^ (a >> 3)) + w[i - 7] +
             (turned(b, 17) ^ turned(b, 19) ^ (b >> 10));
    }
    auto v = h;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::uint32_t e = v[4], a = v[0];
      const std::uint32_t one =
          v[7] + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + ((e & v[5]) ^ (~e & v[6])) + k[i] + w[i];
      const std::uint32_t two =
          (turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + ((a & v[1]) ^ (a & v[2]) ^ (v[1] & v[2]));
      v = {one + two, v[0], v[1], v[2], v[3] + one, v[4], v[5], v[6]};
    }
    for (std::size_t i = 0; i < 8; ++i) h[i] += v[i];
  }
  Text out;
  for (const std::uint32_t word : h)
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(word >> shift);
  return out;
}
Text hex(const Text& bytes) {
  Text out;
  for (const char c : bytes)
    out += "0123456789abcdef"[static_cast<unsigned char>(c) >> 4], out += "0123456789abcdef"[c & 15];
  return out;
}

// ---------------------------------------------------------------------------------------------- the part

struct Json {
  char kind = 'n';          // { [ " 0 t f n
  Text word;                // of texts and numbers
  std::vector<Text> names;  // of the items of an object
  std::vector<Json> items;
  int line = 0;
};

class JsonReader {
 public:
  JsonReader(std::string_view in, Text file) : in_(in), file_(std::move(file)) {}
  Json whole() {
    Json value = read(0);
    skip();
    if (at_ != in_.size()) fail("something follows the end");
    return value;
  }

 private:
  [[noreturn]] void fail(const Text& what) const { reject(file_ + ":" + text(line_) + ": " + what); }
  void skip() {
    for (; at_ < in_.size() && (in_[at_] == ' ' || in_[at_] == '\t' || in_[at_] == '\n' || in_[at_] == '\r');
         ++at_)
      line_ += in_[at_] == '\n';
  }
  bool takes(char c) {
    skip();
    if (at_ >= in_.size() || in_[at_] != c) return false;
    return ++at_, true;
  }
  Text quoted() {
    Text out;
    for (; at_ < in_.size() && in_[at_] != '"'; ++at_) {
      if (in_[at_] == '\n') fail("a text does not end");
      if (in_[at_] == '\\') out += in_[at_++];  // escapes stay as they are: no name that matters has one
      if (at_ < in_.size()) out += in_[at_];
    }
    if (at_++ >= in_.size()) fail("a text does not end");
    return out;
  }
  Json read(int depth) {
    if (depth > 20) fail("too deeply nested");
    skip();
    Json out;
    out.line = line_;
    if (takes('{')) {
      for (out.kind = '{'; !takes('}');) {
        if (!out.names.empty() && !takes(',')) fail("a comma is missing");
        if (!takes('"')) fail("a name is missing");
        const Text name = quoted();
        if (std::find(out.names.begin(), out.names.end(), name) != out.names.end())
          fail("\"" + name + "\" stands twice");
        if (!takes(':')) fail("a colon is missing");
        out.names.push_back(name);
        out.items.push_back(read(depth + 1));
      }
    } else if (takes('[')) {
      for (out.kind = '['; !takes(']');) {
        if (!out.items.empty() && !takes(',')) fail("a comma is missing");
        out.items.push_back(read(depth + 1));
      }
    } else if (takes('"')) {
      out.kind = '"';
      out.word = quoted();
    } else {
      while (at_ < in_.size() && (std::string_view("+-.").find(in_[at_]) != std::string_view::npos ||
                                  (in_[at_] >= '0' && in_[at_] <= '9') ||
                                  (in_[at_] >= 'a' && in_[at_] <= 'z') || in_[at_] == 'E'))
        out.word += in_[at_++];
      if (out.word.empty()) fail("a value is missing");
      const bool number = out.word[0] == '-' || (out.word[0] >= '0' && out.word[0] <= '9');
      out.kind = number ? '0' : out.word[0];
      if (!number && out.word != "true" && out.word != "false" && out.word != "null")
        fail("'" + out.word + "' is no value");
    }
    return out;
  }
  std::string_view in_;
  Text file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

struct Wall {
  Curve curve;
  std::size_t outline = 0;
};
struct Part {
  std::vector<std::vector<Wall>> outlines;  // outer counter-clockwise, islands clockwise
  Int top = 0, floor = 0;
};

class PartReader {
 public:
  PartReader(std::string_view in, const Text& file) : file_(file), root_(JsonReader(in, file).whole()) {}
  Part read() {
    only(root_, {"name", "units", "stock", "pockets", "outer", "islands", "top", "depth", "kind", "through",
                 "slope_rad"});
    if (const Json* units = find(root_, "units")) {
      if (units->word != "mm" && units->word != "inch") fail(*units, "units other than mm and inch");
      unit_ = units->word == "mm" ? kMillimetre : kInch;
    }
    const Json* pockets = find(root_, "pockets");
    if (pockets && (find(root_, "outer") || pockets->items.size() != 1))
      fail(*pockets, "one pocket alone can be checked");
    const Json& pocket = pockets ? pockets->items[0] : root_;
    if (pockets) only(pocket, {"name", "outer", "islands", "top", "depth", "kind", "through", "slope_rad"});
    const Json* kind = find(pocket, "kind");
    if (kind && kind->word != "closed_pocket") fail(*kind, "kinds other than closed_pocket are not claimed");
    const Json* slope = find(pocket, "slope_rad");
    if (slope && number(*slope, kMillimetre) != 0) fail(*slope, "leaning walls are not claimed");
    if (const Json* top = find(pocket, "top")) part_.top = within_range(number(*top, unit_), at(*top));
    const Json *depth = find(pocket, "depth"), *outer = find(pocket, "outer");
    if (!depth || !outer) fail(pocket, "\"outer\" or \"depth\" is missing");
    part_.floor = within_range(part_.top - number(*depth, unit_), at(*depth));
    if (part_.floor >= part_.top) fail(*depth, "the depth must be above 0");
    if (const Json* stock = find(root_, "stock")) refuse_higher(*stock);
    add_outline(*outer);
    const Json* islands = find(pocket, "islands");
    if (islands && islands->kind != '[') fail(*islands, "islands are a list of outlines");
    if (islands)
      for (const Json& island : islands->items) add_outline(island);
    return part_;
  }

 private:
  Text at(const Json& value) const { return file_ + ":" + text(value.line); }
  [[noreturn]] void fail(const Json& value, const Text& what) const { reject(at(value) + ": " + what); }
  static const Json* find(const Json& value, std::string_view name) {
    for (std::size_t i = 0; i < value.names.size(); ++i)
      if (value.names[i] == name) return &value.items[i];
    return nullptr;
  }
  void only(const Json& value, const std::vector<std::string_view>& names) const {
    if (value.kind != '{') fail(value, "an object is expected");
    for (const Text& name : value.names)
      if (std::find(names.begin(), names.end(), name) == names.end())
        fail(*find(value, name), "\"" + name + "\" is not claimed");
  }
  Int number(const Json& value, Int unit) const {
    if (value.kind != '0') fail(value, "a number is expected");
    std::size_t end = 0;
    Number n = number_at(value.word, end, true, at(value));
    if (end < value.word.size() && (value.word[end] == 'e' || value.word[end] == 'E')) {
      const Number power = number_at(value.word, ++end, false, at(value));
      if (power.point || power.digits > 99 || power.digits < -99) fail(value, "an exponent out of range");
      n.exponent += int(power.digits);
    }
    if (end != value.word.size()) fail(value, "'" + value.word + "' is no number");
    return scaled(n, unit, false, at(value));
  }
  void refuse_higher(const Json& stock) {
    const Json* z = find(stock, "z");
    if (!z || z->items.size() != 2 || number(z->items[1], unit_) > part_.top)
      fail(stock, "a stock above the top is not claimed");
  }
  /// The curve from a to b with this bulge, tangent of a quarter of its angle, in units of 1e-12.
  Curve curve_of(const Json& where, Point a, Point b, Int bulge) const {
    Curve c{a, b};
    if (bulge == 0) return c;
    const Wide p = bulge, q = 1'000'000'000'000;
    if (bulge > 100 * q || bulge < -100 * q) fail(where, "a bulge above 100");
    const Point d = b - a;
    const Wide sign = p < 0 ? -1 : 1, under = 4 * p * q * sign;
    const auto middle = [&](Int u, Int v, Wide across) {
      return nearest_quotient((Wide(u) + v) * (2 * p * q * sign) + sign * (q * q - p * p) * across, under);
    };
    const Wide x = middle(a.x, b.x, -d.y), y = middle(a.y, b.y, d.x);
    if (x >= 2 * kLargest || x <= -2 * kLargest || y >= 2 * kLargest || y <= -2 * kLargest)
      fail(where, "an arc whose center is beyond 1.07 m; write it as a line");
    c.arc = true;
    c.clockwise = bulge < 0;
    c.center = {Int(x), Int(y)};
    c.first = (c.clockwise ? b : a) - c.center;
    c.last = (c.clockwise ? a : b) - c.center;
    // The true center is at most 0.71 nm away, so that radii differ by as much.
    c.low = Int(root_down(std::min(square(c.first), square(c.last)))) - 2;
    c.high = Int(root_up(std::max(square(c.first), square(c.last)))) + 2;
    if (c.low < kShortestArc || square(d) < square(kShortestArc) || cross(c.first, c.last) == 0) {
      const bool straight = cross(c.first, c.last) == 0 && dot(c.first, c.last) < 0;
      if (!straight || c.low < kShortestArc) fail(where, "an arc is too small to be checked");
    }
    return c;
  }
  void add_outline(const Json& outline) {
    if (outline.kind != '[') fail(outline, "an outline is a list of vertices");
    std::vector<std::pair<Point, Int>> vertices;
    for (const Json& item : outline.items) {
      if (item.kind != '[' || item.items.size() < 2 || item.items.size() > 3)
        fail(item, "a vertex is [x, y] or [x, y, bulge]");
      const Point p{within_range(number(item.items[0], unit_), at(item)),
                    within_range(number(item.items[1], unit_), at(item))};
      vertices.emplace_back(p, item.items.size() == 3 ? number(item.items[2], 1'000'000'000'000) : 0);
    }
    std::vector<Wall> walls;
    Wide area = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Point a = vertices[i].first, b = vertices[(i + 1) % vertices.size()].first;
      if (a == b) continue;
      walls.push_back({curve_of(outline, a, b, vertices[i].second), part_.outlines.size()});
      Points points = chords_of(walls.back().curve).points;
      if (walls.back().curve.clockwise) std::reverse(points.begin(), points.end());
      for (std::size_t k = 1; k < points.size(); ++k) area += cross(points[k - 1], points[k]);
    }
    if (area == 0) fail(outline, "an outline without area");
    if ((area > 0) != part_.outlines.empty()) {  // turned, so that the pocket lies to the left
      std::reverse(walls.begin(), walls.end());
      for (Wall& wall : walls) {
        std::swap(wall.curve.a, wall.curve.b);
        wall.curve.clockwise = wall.curve.arc && !wall.curve.clockwise;
      }
    }
    part_.outlines.push_back(std::move(walls));
  }
  Text file_;
  Json root_;
  Int unit_ = kMillimetre;
  Part part_;
};

// ---------------------------------------------------------------------------------------------- the program

struct Move {
  Curve path;
  Int z0 = 0, z1 = 0;
  bool rapid = false;
  int line = 0;
  Int lowest() const { return std::min(z0, z1); }
  bool only_rises() const { return !path.arc && path.a == path.b && z1 >= z0; }
};
struct Program {
  std::vector<Move> moves;
  Int blending = 0;     // nm; how far the control may leave the path
  bool dogleg = false;  // rapids may not be straight
  bool stated = false;  // whether the program says how exactly it is followed
};

/// Where a control stands, and what a motion from there is.
class Track {
 public:
  Track(Program& out, Int top) : out_(out), top_(top) {}
  struct Target {
    bool x = false, y = false, z = false;  // said
    Point at;
    Int height = 0;
  };
  void home() {  // up to the machine's own upper end
    if (known_x_ && known_y_ && known_z_) add({{at_, at_}, z_, kHome, true, line_});
    z_ = kHome, known_z_ = true;
  }
  void away() { known_x_ = known_y_ = false; }  // to a place of the machine's own, at the upper end
  void straight(const Target& to, bool rapid) {
    const Point from = at_;
    const Int below = z_;
    const bool all = known_x_ && known_y_ && known_z_;
    if (to.x) at_.x = to.at.x;
    if (to.y) at_.y = to.at.y;
    if (to.z) z_ = to.height;
    known_x_ = known_x_ || to.x, known_y_ = known_y_ || to.y, known_z_ = known_z_ || to.z;
    if (all) return add({{from, at_}, below, z_, rapid, line_});
    if (!rapid || !known_z_ || z_ < top_)
      reject(where() + ": the first motions must be rapids above the top of the part");
  }
  void arc(const Target& to, Point center, bool clockwise) {
    if (!known_x_ || !known_y_ || !known_z_) reject(where() + ": an arc from an unknown place");
    Curve c{at_, at_, true, clockwise, center};
    if (to.x) c.b.x = to.at.x;
    if (to.y) c.b.y = to.at.y;
    if (center.x >= 2 * kLargest || center.x <= -2 * kLargest || center.y >= 2 * kLargest ||
        center.y <= -2 * kLargest)
      reject(where() + ": an arc's center is beyond 1.07 m");
    c.first = (clockwise ? c.b : c.a) - center;
    c.last = (clockwise ? c.a : c.b) - center;
    const Wide shorter = std::min(square(c.first), square(c.last)),
               longer = std::max(square(c.first), square(c.last));
    c.low = Int(root_down(shorter)), c.high = Int(root_up(longer));
    if (c.low < kShortestArc || c.high - c.low > kRadiiDiffer)
      reject(where() + ": an arc whose radii are too small or differ");
    const bool opposite = cross(c.first, c.last) == 0 && dot(c.first, c.last) < 0;
    if (c.a != c.b &&
        (square(c.b - c.a) < square(kShortestArc) || (cross(c.first, c.last) == 0 && !opposite)))
      reject(where() + ": an arc that some controls take for a full circle");
    const Int below = z_;
    at_ = c.b;
    if (to.z) z_ = to.height;
    add({c, below, z_, false, line_});
  }
  bool moved() const { return !out_.moves.empty() || known_z_; }
  bool at_home() const { return !known_z_ || z_ == kHome; }
  Point at() const { return at_; }
  Int height() const { return known_z_ ? z_ : kHome; }
  void set_line(const Text& file, int line) { file_ = file, line_ = line; }
  Text where() const { return file_ + ":" + text(line_); }

 private:
  void add(const Move& move) {
    if (move.path.arc || move.path.a != move.path.b || move.z0 != move.z1) out_.moves.push_back(move);
  }
  Program& out_;
  Int top_;
  Point at_;
  Int z_ = 0;
  bool known_x_ = false, known_y_ = false, known_z_ = false;
  Text file_;
  int line_ = 0;
};

/// G-code as LinuxCNC, Grbl, Fanuc, Haas, Mach, Marlin and, after G700 or G710, Sinumerik read it: absolute, XY plane, arcs by I and J.
class IsoReader {
 public:
  IsoReader(const Text& file, Program& out, Int top) : file_(file), out_(out), track_(out, top) {}
  void block(Text line, int number) {
    track_.set_line(file_, number);
    words_.clear();
    gs_.clear();
    ms_.clear();
    split(line);
    begun_ = true;
    if (words_.empty() && gs_.empty() && ms_.empty()) return;
    if (ended_) fail("something follows the end of the program");
    codes();
    motion();
    if (!words_.empty()) fail("word " + Text(1, words_.begin()->first) + " has no meaning here");
  }

 private:
  [[noreturn]] void fail(const Text& what) const { reject(track_.where() + ": " + what); }
  void split(const Text& line) {
    bool comment = false;
    for (std::size_t at = 0; at < line.size();) {
      const char c = line[at++];
      if (comment || c == '(') {
        comment = c != ')';
        continue;
      }
      if (c == ';') break;
      if (c == ' ' || c == '\t' || c == '\r') continue;
      if (c == '%' && line.find_first_not_of(" \t\r", at) == Text::npos) {  // the second one ends the program
        ended_ = ended_ || begun_;
        return;
      }
      if (c < 'A' || c > 'Z') fail(Text("'") + c + "' is not understood");
      if (line.compare(at - 1, 5, "SUPA ") == 0) {  // Sinumerik's G53
        gs_.push_back(530);
        at += 4;
        continue;
      }
      if (line.compare(at - 1, 5, "CTOL=") == 0)
        at += 4;  // kept under its first letter, which no other word here has
      const Number value = number_at(line, at, false, track_.where());
      if (c == 'G' || c == 'M') {
        (c == 'G' ? gs_ : ms_).push_back(small(value, 10));
      } else if (!words_.emplace(c, value).second) {
        fail(Text("word ") + c + " stands twice");
      }
    }
    if (comment) fail("a comment does not end");
  }
  int small(Number value, Int times) const {
    const Int tenths = scaled(value, times, true, track_.where());
    if (tenths < 0 || tenths > 99'999) fail("a word's number is out of range");
    return int(tenths);
  }
  bool takes_g(int code) {
    const auto found = std::find(gs_.begin(), gs_.end(), code);
    if (found == gs_.end()) return false;
    gs_.erase(found);
    return true;
  }
  Number take(char letter) {
    const Number value = words_.at(letter);
    words_.erase(letter);
    return value;
  }
  Int length(char letter, Int times = 1) {
    const Number n = take(letter);
    if (tape_ && !n.point) fail(Text("word ") + letter + " needs a decimal point on this control");
    const Int nm = scaled(n, unit_, true, track_.where());
    return within_range(nm / times, track_.where()), nm;
  }
  Int tolerance(char letter) {
    const Int nm = scaled(take(letter), unit_, false, track_.where());
    if (nm < 0 || nm > kMillimetre) fail("a tolerance out of range");
    return nm + 1;
  }
  void codes() {
    if (words_.count('O')) words_.erase('O'), tape_ = out_.dogleg = true;
    words_.erase('N');
    words_.erase('S');
    words_.erase('F');
    if (takes_g(40)) {  // a dwell
      if (words_.erase('P') + words_.erase('X') > 1 || !words_.empty() || !gs_.empty())
        fail("a dwell with other words");
      return;
    }
    for (const int code : {200, 210, 7000, 7100}) {
      if (!takes_g(code)) continue;
      if (track_.moved()) fail("units change after the first motion");
      unit_ = code == 200 || code == 7000 ? kInch : kMillimetre;
      sinumerik_ = sinumerik_ || code > 1000;
    }
    for (const int code :
         {170, 400, 911, 940,
          800})  // XY plane, no compensation, arcs' centers from their start, feed per minute
      if (takes_g(code) && code == 800) motion_ = -1;
    const bool by_reference = takes_g(280), up = by_reference || takes_g(530), incremental = takes_g(910);
    if (up && by_reference != incremental) fail("G28 without G91, or G53 with it");
    if (takes_g(900)) absolute_ = true;
    if (incremental && !up) fail("incremental motion (G91)");
    if (sinumerik_ && words_.count('D')) {
      if (!up && !track_.at_home()) fail("the tool's length changes away from the machine's upper end");
      words_.erase('D');
    }
    if (up) return go_home(incremental);
    if (takes_g(490) || takes_g(430)) {
      if (!track_.at_home()) fail("the tool's length changes away from the machine's upper end");
      words_.erase('H');
    }
    offsets();
    if (takes_g(610)) out_.stated = true;
    if (takes_g(640)) blend('P', 'Q');
    if (takes_g(1870)) blend('E', 'E');
    if (sinumerik_ && takes_g(6420)) blend('C', 'C');
    if (sinumerik_ && takes_g(600)) out_.stated = true;
    machine_words();
    for (const int code : {0, 10, 20, 30}) {
      if (!takes_g(code)) continue;
      if (!gs_.empty()) fail("more than one motion");
      motion_ = code / 10;
    }
    if (!gs_.empty())
      fail("G" + text(gs_[0] / 10) + (gs_[0] % 10 ? "." + text(gs_[0] % 10) : "") + " is not claimed");
  }
  /// To the machine's upper end: G53 G0 Z0, G91 G28 Z0; then to a place of its own.
  void go_home(bool incremental) {
    while (takes_g(0)) motion_ = 0;
    if (!gs_.empty() || !ms_.empty()) fail("a way home with other words");
    if (words_.count('Z')) {
      if (take('Z').digits != 0) fail("a way home other than Z0");
      track_.home();
    } else if (!track_.at_home()) {
      fail("a way to the machine's own places below its upper end");
    }
    for (const char axis : {'X', 'Y'})
      if (words_.count(axis)) take(axis), track_.away();
    if (incremental) absolute_ = false;
  }
  void offsets() {
    int offset = 0;
    for (const int code : {540, 550, 560, 570, 580, 590, 591, 592, 593, 541, 1540}) {
      if (!takes_g(code)) continue;
      if (sinumerik_ && code >= 580) fail("G58 and G59 shift axes on this control, which is not claimed");
      offset = code * 1000;
      if ((code == 541 || code == 1540 || code == 590) && words_.count('P')) offset += small(take('P'), 1);
    }
    for (int code = 5050; sinumerik_ && code <= 5990; code += 10)
      if (takes_g(code)) offset = code * 1000;
    if (offset == 0 || offset == offset_) return;
    if (track_.moved()) fail("the work offset changes after the first motion");
    offset_ = offset;
  }
  void blend(char first, char second) {
    if (!words_.count(first)) fail("blending without a stated tolerance");
    const Int path = tolerance(first);
    const Int lines = first == second ? 0 : words_.count(second) ? tolerance(second) : path;
    out_.blending = std::max(out_.blending, path + lines);
    out_.stated = true;
  }
  void machine_words() {
    for (const int code : ms_) {
      const int m = code / 10;
      const bool change = m == 6;
      if (code % 10 != 0 || !(m <= 9 || m == 30 || (tape_ && (m == 83 || m == 84))))
        fail("M" + text(m) + " is not claimed");
      if (change && changed_) fail("a second tool is not claimed");
      if (change && !track_.at_home()) fail("a tool change away from the machine's upper end");
      changed_ = changed_ || change;
      if (m == 2 || m == 30) ended_ = true;
    }
    if (!words_.count('T')) return;
    const int tool = small(take('T'), 1);
    if (tool_ >= 0 && tool != tool_) fail("a second tool is not claimed");
    tool_ = tool;
  }
  void motion() {
    Track::Target to;
    if (words_.count('X')) to.x = true, to.at.x = length('X');
    if (words_.count('Y')) to.y = true, to.at.y = length('Y');
    if (words_.count('Z')) to.z = true, to.height = length('Z');
    const bool arc = motion_ >= 2;
    Point center = track_.at();
    const bool has_center = arc && (words_.count('I') || words_.count('J'));
    if (arc && words_.count('I')) center.x += length('I', 2);
    if (arc && words_.count('J')) center.y += length('J', 2);
    if (!to.x && !to.y && !to.z && !has_center) return;
    if (motion_ < 0 || !absolute_) fail(motion_ < 0 ? "axis words without a motion" : "motion before G90");
    if (arc && !has_center) fail("an arc without I and J");
    arc ? track_.arc(to, center, motion_ == 2) : track_.straight(to, motion_ == 0);
  }

  Text file_;
  Program& out_;
  Track track_;
  std::map<char, Number> words_;
  std::vector<int> gs_, ms_;  // ten times their numbers
  Int unit_ = kMillimetre;
  int motion_ = -1, offset_ = 0, tool_ = -1;
  bool absolute_ = false, tape_ = false, sinumerik_ = false, changed_ = false, begun_ = false, ended_ = false;
};

/// Heidenhain Klartext: L, CC, C.
class KlartextReader {
 public:
  KlartextReader(const Text& file, Program& out, Int top) : file_(file), out_(out), track_(out, top) {
    out_.stated = true;
  }
  void block(Text line, int number) {
    track_.set_line(file_, number);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) return;
    std::size_t at = 0;
    while (at < line.size() && line[at] >= '0' && line[at] <= '9') ++at;
    if (at == 0 || at == line.size() || line[at] != ' ') fail("a block needs its number");
    tokens_.clear();
    for (std::size_t i = at; i < line.size() && line[i] != ';';) {
      const std::size_t end = std::min(line.find_first_of(" ;", i), line.size());
      if (end > i) tokens_.push_back(line.substr(i, end - i));
      i = end + (end < line.size() && line[end] == ' ');
    }
    if (tokens_.empty()) return;
    if (ended_) fail("something follows the end of the program");
    read(tokens_[0]);
  }

 private:
  [[noreturn]] void fail(const Text& what) const { reject(track_.where() + ": " + what); }
  void read(const Text& first) {
    const Text second = tokens_.size() > 1 ? tokens_[1] : "";
    const Text last = tokens_.back();
    if (first == "BEGIN" || first == "END") {
      if (second != "PGM" || (first == "BEGIN" && track_.moved()) || (last != "MM" && last != "INCH"))
        fail("a unit is missing, or a second program begins");
      unit_ = last == "MM" ? kMillimetre : kInch;
      ended_ = first == "END";
    } else if (first == "BLK" && second == "FORM") {
      return;
    } else if (first == "TOOL" && second == "CALL") {
      const bool numbered = tokens_.size() > 2 && tokens_[2] != "Z";
      if (numbered && called_) fail("a second tool is not claimed");
      called_ = called_ || numbered;
      for (const Text& token : tokens_)
        if (token[0] == 'D') fail("a tool call with " + token);
    } else if (first == "CYCL" && second == "DEF" && tokens_.size() > 2) {
      cycle(tokens_[2], last);
    } else if (first[0] == 'M' && tokens_.size() == 1) {
      machine_word(first);
    } else if (first == "L") {
      line();
    } else if (first == "CC") {
      if (tokens_.size() != 3 || second[0] != 'X' || last[0] != 'Y') fail("a center needs X and Y");
      center_ = {length(second), length(last)};
      has_center_ = true;
    } else if (first == "C") {
      arc();
    } else if (first == "CP") {
      helix();
    } else {
      fail("'" + first + "' is not claimed");
    }
  }
  void cycle(const Text& number, const Text& last) {
    if (number == "9.0" || number == "9.1" || number == "32.0") return;
    if (number != "32.1" || last[0] != 'T') fail("cycle " + number + " is not claimed");
    std::size_t at = 1;
    const Int nm = scaled(number_at(last, at, false, track_.where()), unit_, false, track_.where());
    if (at != last.size() || nm < 0 || nm > kMillimetre) fail("a tolerance out of range");
    out_.blending = std::max(out_.blending, nm + 1);
  }
  void machine_word(const Text& word) {
    for (const char* known : {"M0", "M1", "M3", "M4", "M5", "M7", "M8", "M9", "M13", "M30"})
      if (word == known) return;
    fail(word + " is not claimed");
  }
  Int length(const Text& token) {
    std::size_t at = 1;
    const Int nm = scaled(number_at(token, at, false, track_.where()), unit_, true, track_.where());
    if (at != token.size()) fail("'" + token + "' is not understood");
    return within_range(nm, track_.where());
  }
  /// Reads X, Y, Z once each; what is left must be among `others` or a feed.
  Track::Target target(const std::vector<Text>& others) {
    Track::Target to;
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
      const Text& token = tokens_[i];
      bool Track::Target::*said = token[0] == 'X'   ? &Track::Target::x
                                  : token[0] == 'Y' ? &Track::Target::y
                                  : token[0] == 'Z' ? &Track::Target::z
                                                    : nullptr;
      const bool other = std::find(others.begin(), others.end(), token) != others.end();
      const bool feed = token.size() > 1 && token[0] == 'F' && token[1] >= '0' && token[1] <= '9';
      if (!said && !other && !feed) fail("'" + token + "' is not understood");
      if (!said) continue;
      if (to.*said) fail("an axis stands twice");
      to.*said = true;
      (token[0] == 'X' ? to.at.x : token[0] == 'Y' ? to.at.y : to.height) = length(token);
    }
    return to;
  }
  bool has(const char* token) const {
    return std::find(tokens_.begin(), tokens_.end(), token) != tokens_.end();
  }
  void line() {
    const Track::Target to = target({"R0", "FMAX", "M91"});
    if (!has("M91")) {
      if (to.x || to.y || to.z) track_.straight(to, has("FMAX"));
    } else if (to.z && to.height == 0 && !to.x && !to.y) {
      track_.home();
    } else if (!to.z && track_.at_home()) {
      track_.away();
    } else {
      fail("a way to the machine's own places below its upper end");
    }
  }
  void arc() {
    const Track::Target to = target({"DR+", "DR-", "R0"});
    if (!has_center_ || has("DR+") == has("DR-") || !to.x || !to.y || to.z)
      fail("an arc needs CC, X, Y and DR");
    track_.arc(to, center_, has("DR-"));
  }
  /// CP IPA+angle IZ-depth DR+. It ends where its angle says, within 2 nm of a whole place: that counts as blending from here on.
  void helix() {
    if (tokens_.size() < 4 || tokens_[1].substr(0, 3) != "IPA" || tokens_[2].substr(0, 2) != "IZ" ||
        !has_center_)
      fail("a helix needs CC, IPA, IZ and DR");
    std::size_t at = 3;
    const Int turn = scaled(number_at(tokens_[1], at, false, track_.where()), 10'000, true, track_.where());
    const Int rise = length(tokens_[2].substr(1));
    const std::size_t angle_size = tokens_[1].size();
    tokens_ = {tokens_.begin() + 2, tokens_.end()};
    target({"DR+", "DR-"});
    if (at != angle_size || turn == 0 || turn > 3'600'000 || turn < -3'600'000 || has("DR-") != (turn < 0) ||
        has("DR+") != (turn > 0))
      fail("a helix of more than a turn, or that turns another way than it says");
    Track::Target to{true, true, true, center_ + turned(track_.at() - center_, turn), track_.height() + rise};
    if (turn == 3'600'000 || turn == -3'600'000) to.at = track_.at();
    out_.blending += 2;
    track_.arc(to, center_, turn < 0);
  }

  Text file_;
  Program& out_;
  Track track_;
  std::vector<Text> tokens_;
  Int unit_ = kMillimetre;
  Point center_;
  bool has_center_ = false, called_ = false, ended_ = false;
};

Program read_program(const Text& in, const Text& file, Int top) {
  Program out;
  IsoReader iso(file, out, top);
  const std::size_t start = in.find_first_not_of(" \t\r\n");
  const bool klartext = start != Text::npos && in.compare(start, 11, "0 BEGIN PGM") == 0;
  if (!klartext) out.stated = false;
  KlartextReader plain(file, out, top);
  out.stated = klartext;
  int number = 0;
  for (std::size_t at = 0; at < in.size();) {
    const std::size_t end = std::min(in.find('\n', at), in.size());
    klartext ? plain.block(in.substr(at, end - at), ++number) : iso.block(in.substr(at, end - at), ++number);
    at = end + 1;
  }
  return out;
}

// ---------------------------------------------------------------------------------------------- the claims

/// What is asked, in nm.
struct Question {
  Int uncut = 10'000;  // u: how far beyond the cutter's reach in the program the floor may lie
  Int beyond = 100;    // e: centers this much closer to a wall than they may be count as out of reach
  Int gouge = 1'500;   // g: how far the cutter may reach into walls and floor
  Int rapid = 20'000;  // r: how far from the cutter's rim rapids may touch material
  Int level = 2'000;   // f: how far above the floor a move may be that cuts it
  Int radius = 0;      // 0: as the witness says
};
/// What the witness states and the claims name.
struct Stated {
  Int radius = 0, wall_stock = 0, floor_stock = 0;
};

struct Tile {
  int label = 0;       // as in docs/witness.md
  std::size_t of = 0;  // move or wall
  std::vector<std::size_t> corners;
  Points hull;
  Wide slack = 0;  // s: how far its pieces of the boundary are from their walls
};

class WitnessBytes {
 public:
  explicit WitnessBytes(const Text& bytes) : bytes_(bytes) {}
  Text take(std::size_t count) {
    if (bytes_.size() - at_ < count) refuse("the witness is cut off");
    at_ += count;
    return bytes_.substr(at_ - count, count);
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
  /// The number of things to come, each of at least a byte.
  std::size_t count() {
    const Int value = number();
    if (value > Int(bytes_.size() - at_)) refuse("the witness is cut off");
    return static_cast<std::size_t>(value);
  }
  bool ended() const { return at_ == bytes_.size(); }

 private:
  const Text& bytes_;
  std::size_t at_ = 0;
};

struct Rapid {
  std::size_t move = 0;
  std::vector<Tile> tiles;
};
struct Witness {
  Text program_hash, part_hash;
  Stated stated;
  Points vertices;
  std::vector<Tile> cover, centre;
  std::vector<Rapid> rapids;
};

std::vector<Tile> read_tiles(WitnessBytes& in, const Points& vertices) {
  std::vector<Tile> tiles(in.count());
  Int of = 0, index = 0;
  for (Tile& tile : tiles) {
    tile.label = int(std::min<Int>(in.number(), 100));
    if (tile.label == 0) of += in.signed_number();
    if (of < 0 || of > kLargest) refuse("the witness names a move or wall that cannot be");
    tile.of = static_cast<std::size_t>(of);
    tile.corners.resize(in.count());
    Points points;
    for (std::size_t& corner : tile.corners) {
      index += in.signed_number();
      if (index < 0 || index >= Int(vertices.size()))
        refuse("the witness names a vertex that it does not have");
      corner = static_cast<std::size_t>(index);
      points.push_back(vertices[corner]);
    }
    if (points.empty()) refuse("the witness has a tile without corners");
    tile.hull = hull_of(std::move(points));
  }
  return tiles;
}

Witness read_witness(const Text& bytes) {
  WitnessBytes in(bytes);
  Witness out;
  if (bytes.size() < 4 || in.take(4) != "CCW1") refuse("this is no witness of version 1");
  out.program_hash = in.take(32);
  out.part_hash = in.take(32);
  out.stated.radius = in.number(), out.stated.wall_stock = in.number(), out.stated.floor_stock = in.number();
  if (out.stated.radius < 10'000 || out.stated.radius >= kLargest || out.stated.wall_stock >= kLargest ||
      out.stated.floor_stock >= kLargest)
    refuse("the witness states a length out of range");
  out.vertices.resize(in.count());
  Point at;
  for (std::size_t i = 0; i < out.vertices.size(); ++i) {
    const Point last = at;
    at = at + Point{in.signed_number(), in.signed_number()};
    if (at.x >= kLargest || at.x <= -kLargest || at.y >= kLargest || at.y <= -kLargest)
      refuse("the witness has a vertex out of range");
    if (i > 0 && (at.x < last.x || (at.x == last.x && at.y <= last.y)))
      refuse("the witness has vertices out of order");
    out.vertices[i] = at;
  }
  out.cover = read_tiles(in, out.vertices);
  out.centre = read_tiles(in, out.vertices);
  out.rapids.resize(in.count());
  for (Rapid& rapid : out.rapids) {
    rapid.move = static_cast<std::size_t>(in.number());
    rapid.tiles = read_tiles(in, out.vertices);
  }
  if (!in.ended()) refuse("the witness has bytes after its end");
  return out;
}

/// A directed edge of tiles that nothing cancels, and a tile that has it.
struct Loose {
  std::size_t from, to, owner;
  bool used = false;
};
/// D of lemma L1, by where they start.
std::vector<Loose> loose_edges(const std::vector<Tile>& tiles) {
  struct Side {
    std::size_t low, high, owner;
    bool up;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const auto& corners = tiles[i].corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::size_t a = corners[k], b = corners[(k + 1) % corners.size()];
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), i, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  std::vector<Loose> loose;
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    Int net = 0;
    for (; end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high; ++end)
      net += sides[end].up ? 1 : -1;
    for (std::size_t k = i; k < end && net != 0; ++k) {
      if (sides[k].up != (net > 0)) continue;
      loose.push_back(net > 0 ? Loose{sides[k].low, sides[k].high, sides[k].owner}
                              : Loose{sides[k].high, sides[k].low, sides[k].owner});
      net += net > 0 ? -1 : 1;
    }
  }
  std::sort(loose.begin(), loose.end(), [](const Loose& a, const Loose& b) { return a.from < b.from; });
  return loose;
}

/// How far the piece from u to v is from the wall at most, -1 where it does not follow it.
Wide slack_of(const Curve& c, Point u, Point v) {
  if (!c.arc) {
    Wide widest = -1;
    for (Wide t = 1; t <= kWidestPiece && widest < 0; t *= 2)
      if (near_segment(u, c.a, c.b, t) && near_segment(v, c.a, c.b, t)) widest = t;
    return widest;
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

/// Whether all of `hull` lies within t of the move, of its start or of its end, as far as they are no higher than `level` (L2 to L4).
bool cut_by(const Move& move, const Points& hull, Wide t, Int level) {
  if (std::max(move.z0, move.z1) <= level) return near_curve(move.path, hull, t);
  const Point p = move.z0 <= level ? move.path.a : move.path.b;
  return move.lowest() <= level && hull_within({p, p}, hull, t);
}

class Checker {
 public:
  Checker(const Question& asked, const Part& part, const Program& program, const Witness& witness)
      : asked_(asked), part_(part), program_(program), witness_(witness), blend_(program.blending) {
    for (const auto& outline : part.outlines)
      for (const Wall& wall : outline) add_wall(wall);
  }

  /// The outlines are simple, apart, and each island lies in the outer one and in no other.
  void check_part() const {
    std::vector<Box> boxes;
    for (const Segment& s : segments_) boxes.push_back(box_of({s.a, s.b}));
    const BoxTree tree(boxes);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const Segment& s = segments_[i];
      tree.visit_all(boxes[i], [&](std::size_t k) {
        const Segment& other = segments_[k];
        if (k <= i) return true;
        const bool next = s.outline == other.outline && (s.b == other.a || s.a == other.b);
        const bool meet = !next ? segments_meet(s.a, s.b, other.a, other.b)
                                : (s.b == other.a && fold(s.a, s.b, other.b)) ||
                                      (s.a == other.b && fold(other.a, other.b, s.b));
        if (meet)
          reject("the part's outlines cross near X" + mm(s.a.x) + " Y" + mm(s.a.y) +
                 "; repair them first (clearcut convert)");
        return true;
      });
    }
    for (std::size_t i = 1; i < part_.outlines.size(); ++i) {
      if (part_.outlines[i].size() < 2) reject("an island has fewer than two walls");
      if (winding(part_.outlines[i][0].curve.a, i) != 1)
        reject("island " + text(Int(i)) + " lies outside the outline or in another island");
    }
  }

  /// C2.
  void check_gouges() const {
    const Wide reach = Wide(witness_.stated.radius) + witness_.stated.wall_stock - asked_.gouge + blend_ + 1;
    if (reach <= 0) refuse("the gouge allowed is larger than the cutter");
    std::vector<Box> boxes;
    for (const Segment& s : segments_) boxes.push_back(box_of({s.a, s.b}).grown(s.error));
    const BoxTree tree(boxes);
    bool inside = false;
    for (const Move& move : program_.moves) {
      const bool in_material = move.lowest() < part_.top;
      if (in_material && move.lowest() < part_.floor + witness_.stated.floor_stock - asked_.gouge + blend_)
        refuse(line_of(move) + "goes below the floor");
      if (in_material && !inside && winding(move.path.a, part_.outlines.size()) != 1)
        refuse(line_of(move) + "is outside of the pocket");
      inside = in_material;
      if (in_material) check_gouge(move, tree, reach);
    }
  }

  /// C1.
  void check_cover() {
    std::vector<Tile> cover = tiles_with_slack(witness_.cover, "cover"),
                      centre = tiles_with_slack(witness_.centre, "centre");
    const Wide legal = Wide(witness_.stated.radius) + witness_.stated.wall_stock + asked_.beyond;
    std::vector<Box> boxes;
    std::vector<const Tile*> maybe;
    for (std::size_t i = 0; i < centre.size(); ++i) {
      const Tile& tile = centre[i];
      if (tile.slack + 1 >= legal) refuse(name_of("centre", i, tile) + "is too far from its wall");
      if (tile.label == 1) {
        maybe.push_back(&tile);
        boxes.push_back(box_of(tile.hull));
      } else if (tile.label != 0 || tile.of >= walls_.size() ||
                 !near_curve(walls_[tile.of].curve, tile.hull, legal - 1)) {
        refuse(name_of("centre", i, tile) + "does not lie within " + mm(Int(legal)) + " mm of wall " +
               text(Int(tile.of)));
      }
    }
    const BoxTree tree(boxes);
    for (std::size_t i = 0; i < cover.size(); ++i) {
      const Tile& tile = cover[i];
      if (tile.label == 1) {
        const Wide reach = Wide(witness_.stated.radius) + tile.slack + 1;
        const bool out = tree.visit_all(box_of(tile.hull).grown(reach), [&](std::size_t k) {
          return apart(tile.hull, maybe[k]->hull, reach);
        });
        if (!out) refuse(name_of("cover", i, tile) + "is called out of reach and is not");
      } else if (tile.label != 0 ||
                 !is_cut(tile, Wide(witness_.stated.radius) + asked_.uncut - blend_ - tile.slack - 1,
                         program_.moves.size(),
                         part_.floor + witness_.stated.floor_stock + asked_.level - blend_)) {
        refuse(name_of("cover", i, tile) + "is not cut by " + move_name(tile.of));
      }
    }
  }

  /// C3.
  void check_rapids() const {
    std::size_t next = 0;
    for (std::size_t i = 0; i < program_.moves.size(); ++i) {
      const Move& move = program_.moves[i];
      if (!move.rapid || move.lowest() >= part_.top || move.only_rises()) continue;
      if (next >= witness_.rapids.size() || witness_.rapids[next].move != i)
        refuse("the witness has no tiles for the rapid of line " + text(move.line));
      check_rapid(witness_.rapids[next++], move);
    }
    if (next != witness_.rapids.size()) refuse("the witness has tiles for a move that needs none");
  }

 private:
  struct Segment {
    Point a, b;
    Wide error;
    std::size_t outline, wall;
  };
  static bool fold(Point a, Point b, Point c) { return cross(b - a, c - b) == 0 && dot(b - a, c - b) < 0; }
  void add_wall(const Wall& wall) {
    Chords chords = chords_of(wall.curve);
    if (wall.curve.clockwise) std::reverse(chords.points.begin(), chords.points.end());
    for (std::size_t k = 1; k < chords.points.size(); ++k)
      segments_.push_back(
          {chords.points[k - 1], chords.points[k], chords.error, wall.outline, walls_.size()});
    walls_.push_back(wall);
  }
  /// Of the walls' chords about p, without one outline.
  Int winding(Point p, std::size_t without) const {
    Int turns = 0;
    for (const Segment& s : segments_) {
      if (s.outline == without || (s.a.y <= p.y) == (s.b.y <= p.y)) continue;
      const Wide side = cross(s.b - s.a, p - s.a);
      if (s.a.y <= p.y && side > 0) ++turns;
      if (s.a.y > p.y && side < 0) --turns;
    }
    return turns;
  }
  Text line_of(const Move& move) const { return "line " + text(move.line) + " of the program "; }
  Text move_name(std::size_t k) const {
    return k < program_.moves.size() ? "line " + text(program_.moves[k].line) + " of the program"
                                     : "a move that the program does not have";
  }
  Text name_of(const char* tiling, std::size_t i, const Tile& tile) const {
    const Point p = tile.hull[0];
    return Text(tiling) + " tile " + text(Int(i)) + " at X" + mm(p.x) + " Y" + mm(p.y) + " ";
  }
  /// Where a rapid may run: straight, or anywhere between its ends where the control moves its axes one by one.
  Points corridor(const Move& move) const {
    const Point a = move.path.a, b = move.path.b;
    if (!program_.dogleg || a.x == b.x || a.y == b.y) return {a, b};
    return {a, {b.x, a.y}, b, {a.x, b.y}, a};
  }
  /// Whether the segment ab stays farther than t from all of a rapid's corridor.
  bool clear_of(const Move& move, Point a, Point b, Wide t) const {
    const Points around = corridor(move);
    for (std::size_t k = 1; k < around.size(); ++k)
      if (!segments_apart(a, b, around[k - 1], around[k], t)) return false;
    return around.size() < 3 || !box_of(around).meets(box_of({a}));
  }
  void check_gouge(const Move& move, const BoxTree& tree, Wide reach) const {
    Box box = box_of({move.path.a, move.path.b});
    const Curve& c = move.path;
    if (c.arc)
      box.add({c.center.x - c.high, c.center.y - c.high}),
          box.add({c.center.x + c.high, c.center.y + c.high});
    if (tree.visit_all(box.grown(reach), [](std::size_t) { return false; }))
      return;  // no wall is near: not even the box of the path
    const Chords chords = move.rapid ? Chords{corridor(move), 0} : chords_of(c);
    for (std::size_t k = 1; k < chords.points.size(); ++k) {
      const Point a = chords.points[k - 1], b = chords.points[k];
      tree.visit_all(box_of({a, b}).grown(reach + chords.error), [&](std::size_t i) {
        const Segment& s = segments_[i];
        if (!segments_apart(a, b, s.a, s.b, reach + chords.error + s.error) ||
            (move.rapid && !clear_of(move, s.a, s.b, reach + s.error)))
          refuse(line_of(move) + "comes too close to wall " + text(Int(s.wall)) + " near X" + mm(s.a.x) +
                 " Y" + mm(s.a.y));
        return true;
      });
    }
  }
  bool is_cut(const Tile& tile, Wide t, std::size_t before, Int level) const {
    if (tile.of >= before || program_.moves[tile.of].rapid) return false;
    return cut_by(program_.moves[tile.of], tile.hull, t, level);
  }
  /// L1: the loose edges are one chain along each wall; each tile knows how far its pieces are from them.
  std::vector<Tile> tiles_with_slack(std::vector<Tile> tiles, const char* tiling) const {
    std::vector<Loose> loose = loose_edges(tiles);
    const Points& vertices = witness_.vertices;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      const Curve& wall = walls_[w].curve;
      const auto start = std::lower_bound(vertices.begin(), vertices.end(), wall.a, [](Point a, Point b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
      });
      if (start == vertices.end() || *start != wall.a)
        refuse(Text("the ") + tiling + " tiling lacks the start of wall " + text(Int(w)));
      std::size_t at = static_cast<std::size_t>(start - vertices.begin());
      while (vertices[at] != wall.b) {
        auto edge = std::lower_bound(loose.begin(), loose.end(), at,
                                     [](const Loose& e, std::size_t from) { return e.from < from; });
        Wide slack = -1;
        for (; edge != loose.end() && edge->from == at; ++edge)
          if (!edge->used && (slack = slack_of(wall, vertices[at], vertices[edge->to])) >= 0) break;
        if (slack < 0)
          refuse(Text("the ") + tiling + " tiling leaves wall " + text(Int(w)) + " at X" +
                 mm(vertices[at].x) + " Y" + mm(vertices[at].y));
        edge->used = true;
        tiles[edge->owner].slack = std::max(tiles[edge->owner].slack, slack);
        at = edge->to;
      }
    }
    for (const Loose& edge : loose)
      if (!edge.used)
        refuse(Text("the ") + tiling + " tiling has an edge along no wall at X" + mm(vertices[edge.from].x) +
               " Y" + mm(vertices[edge.from].y));
    return tiles;
  }
  /// L1b.
  void check_rapid(const Rapid& rapid, const Move& move) const {
    const Wide radius = Wide(witness_.stated.radius) - asked_.rapid + blend_;
    Int turns = 0;
    const Point p = move.path.a;
    for (const Loose& edge : loose_edges(rapid.tiles)) {
      const Point a = witness_.vertices[edge.from], b = witness_.vertices[edge.to];
      if (!clear_of(move, a, b, radius + 1))
        refuse("the tiles for the rapid of line " + text(move.line) + " do not hold it");
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const Wide side = cross(b - a, p - a);
      turns += a.y <= p.y ? side > 0 : -(side < 0);
    }
    if (turns == 0 || radius < 0)
      refuse("the tiles for the rapid of line " + text(move.line) + " do not hold it");
    for (std::size_t i = 0; i < rapid.tiles.size(); ++i) {
      const Tile& tile = rapid.tiles[i];
      if (tile.label != 0 ||
          !is_cut(tile, Wide(witness_.stated.radius) - blend_ - 1, rapid.move, move.lowest() - 2 * blend_))
        refuse(name_of("rapid's", i, tile) + "is not cut before line " + text(move.line) + " by " +
               move_name(tile.of));
    }
  }

  const Question& asked_;
  const Part& part_;
  const Program& program_;
  const Witness& witness_;
  Wide blend_;
  std::vector<Wall> walls_;
  std::vector<Segment> segments_;
};

/// Throws Refusal where a claim does not follow; else the claims that hold.
Text check(const Question& asked, const Text& program_text, const Text& program_name, const Text& part_text,
           const Text& part_name, const Text& witness_text) {
  const Part part = PartReader(part_text, part_name).read();
  const Program program = read_program(program_text, program_name, part.top);
  const Witness witness = read_witness(witness_text);
  const Text program_hash = sha256(program_text), part_hash = sha256(part_text);
  if (witness.program_hash != program_hash)
    refuse("the witness is about another program (SHA-256 " + hex(witness.program_hash) + ")");
  if (witness.part_hash != part_hash)
    refuse("the witness is about another part (SHA-256 " + hex(witness.part_hash) + ")");
  const Stated& s = witness.stated;
  if (asked.radius != 0 && asked.radius != s.radius)
    refuse("the witness is about a cutter of radius " + mm(s.radius) + " mm");
  Checker checker(asked, part, program, witness);
  checker.check_part();
  checker.check_gouges();
  checker.check_cover();
  checker.check_rapids();
  const Text wall_stock = s.wall_stock ? ", " + mm(s.wall_stock) + " mm of stock left on walls" : "";
  const Text floor_stock = s.floor_stock ? ", " + mm(s.floor_stock) + " mm of stock left on the floor" : "";
  return "proven for a flat cutter of diameter " + mm(2 * s.radius) + " mm" + wall_stock + floor_stock +
         ":\n" + "C1 nothing left: what a cutter " + mm(asked.beyond) +
         " mm off the walls can reach lies within " + mm(asked.uncut) +
         " mm of what the program cuts, its tip at most " + mm(asked.level) + " mm above the floor\n" +
         "C2 nothing gouged: below the top the cutter stays in the pocket, at most " + mm(asked.gouge) +
         " mm in walls and floor\n" + "C3 no rapid in material: all but a rim of " + mm(asked.rapid) +
         " mm of the cutter runs in what was cut before\n" + "program " + hex(program_hash) + "\npart " +
         hex(part_hash) + "\n" +
         (program.stated
              ? "path followed within " + mm(program.blending) + " mm, as the program says\n"
              : "taken as true: the control follows the path exactly; the program says nothing of it\n") +
         (program.dogleg ? "" : "taken as true: rapids are straight\n") +
         "taken as true: docs/claim.md, assumptions\n";
}

int run(int count, char** arguments) {
  Question asked;
  std::vector<Text> files;
  const std::map<Text, Int Question::*> options{
      {"--uncut", &Question::uncut}, {"--beyond", &Question::beyond}, {"--gouge", &Question::gouge},
      {"--rapid", &Question::rapid}, {"--level", &Question::level},   {"--diameter", &Question::radius}};
  for (int i = 1; i < count; ++i) {
    const Text word = arguments[i];
    const auto option = options.find(word);
    if (option == options.end()) {
      if (word.substr(0, 2) == "--")
        reject(word +
               " is no option; they are --uncut --beyond --gouge --rapid --level --diameter, each with mm");
      files.push_back(word);
      continue;
    }
    const Text value = i + 1 < count ? arguments[++i] : "";
    std::size_t end = 0;
    const Int nm = scaled(number_at(value, end, false, word),
                          word == "--diameter" ? kMillimetre / 2 : kMillimetre, true, word);
    if (end != value.size() || nm < 0 || nm >= kLargest || (nm == 0 && word == "--diameter"))
      reject(word + ": '" + value + "' is no length in mm");
    asked.*(option->second) = nm;
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
