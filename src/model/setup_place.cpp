#include "model/setup_place.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::inline model {
namespace {

/// Entries of rotation matrices that differ by less than this from 0, 1 or -1 are taken as that value.
constexpr double kSameDirection = 1e-9;

using Row = SetupPlace::Row;
using Rows = std::array<Row, 3>;

struct Side {
  const char* name;
  Rows turn;
};

/// Sides turned up, as in the reader of solids.
constexpr Side kSides[] = {
    {"+Z", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},  {"-Z", {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}},
    {"+X", {{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}}}, {"-X", {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}}},
    {"+Y", {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}}}, {"-Y", {{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}}};

Row times(const Rows& turn, const Row& p) {
  Row out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = turn[i][0] * p[0] + turn[i][1] * p[1] + turn[i][2] * p[2];
  return out;
}

Rows transposed(const Rows& turn) {
  Rows out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) out[j][i] = turn[i][j];
  }
  return out;
}

/// a after b.
Rows times(const Rows& a, const Rows& b) {
  Rows out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  }
  return out;
}

/// Quarter turns are exact.
Rows about_vertical(double degrees) {
  double sine = base::sin(degrees * kPi / 180), cosine = base::cos(degrees * kPi / 180);
  if (degrees / 90 == std::round(degrees / 90)) sine = std::round(sine), cosine = std::round(cosine);
  return {{{cosine, -sine, 0}, {sine, cosine, 0}, {0, 0, 1}}};
}

Vec2 moved(Vec2 p, const SetupPlace& place) {
  const auto& [x, y, z] = place.turn;
  return {x[0] * p.x + x[1] * p.y + place.shift[0], y[0] * p.x + y[1] * p.y + place.shift[1]};
}

Turn opposite(Turn turn) {
  return static_cast<Turn>(-static_cast<int>(turn));
}

}  // namespace

std::optional<SetupPlace> place_with_up(const std::string& up, double degrees) {
  const auto* const side = std::find_if(std::begin(kSides), std::end(kSides), [&](const Side& one) {
    return up == one.name || (up.empty() && one.name == std::string("+Z"));
  });
  if (side == std::end(kSides)) return std::nullopt;
  SetupPlace place;
  place.turn = times(about_vertical(degrees), side->turn);
  return place;
}

SetupPlace between(const SetupPlace& from, const SetupPlace& to) {
  SetupPlace out;
  out.turn = times(to.turn, transposed(from.turn));
  const Row back = times(out.turn, from.shift);
  for (std::size_t i = 0; i < 3; ++i) out.shift[i] = to.shift[i] - back[i];
  return out;
}

bool keeps_boxes(const SetupPlace& place) {
  return std::all_of(place.turn.begin(), place.turn.end(), [](const Row& row) {
    return std::all_of(row.begin(), row.end(), [](double v) {
      return std::abs(v) < kSameDirection || std::abs(std::abs(v) - 1) < kSameDirection;
    });
  });
}

bool keeps_verticals(const SetupPlace& place) {
  return std::abs(std::abs(place.turn[2][2]) - 1) < kSameDirection;
}

bool turns_over(const SetupPlace& place) {
  return place.turn[2][2] < 0;
}

Stock moved(const Stock& stock, const SetupPlace& place) {
  Row a = times(place.turn, Row{stock.plan.min.x, stock.plan.min.y, stock.z_bottom});
  Row b = times(place.turn, Row{stock.plan.max.x, stock.plan.max.y, stock.z_top});
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] += place.shift[i];
    b[i] += place.shift[i];
    if (a[i] > b[i]) std::swap(a[i], b[i]);
  }
  return {{{a[0], a[1]}, {b[0], b[1]}}, a[2], b[2]};
}

Edge moved(const Edge& edge, const SetupPlace& place) {
  const Turn turn = turns_over(place) ? opposite(edge.turn) : edge.turn;
  return {moved(edge.from, place), moved(edge.to, place), edge.is_arc() ? moved(edge.center, place) : Vec2{},
          turn};
}

double moved_z(double z, const SetupPlace& place) {
  return (turns_over(place) ? -z : z) + place.shift[2];
}

}  // namespace clearcut::inline model
