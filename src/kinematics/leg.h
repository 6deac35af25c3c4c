// Moves of positive length as planners see them: length, directions at both ends, and the limits of the axes along
// them.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "kinematics/planner.h"

namespace clearcut::kinematics {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// A direction or a difference in space.
struct Vec3 {
  double x = 0, y = 0, z = 0;

  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator*(const Vec3& a, double k) { return {a.x * k, a.y * k, a.z * k}; }
};
inline double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline double norm(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

/// Greatest speeds (mm/s) and accelerations (mm/s2) of the axes.
struct AxisLimits {
  Vec3 speed, acceleration;
};
AxisLimits axis_limits(const Machine& machine);

/// The greatest value along direction `u` for which no axis exceeds its own limit.
double most_along(const Vec3& u, const Vec3& of_axes);

/// A move of positive length.
struct Leg {
  std::size_t index = 0;  ///< index of the move
  const Move* move = nullptr;
  double plan = 0;          ///< mm, in plan view
  double length = 0;        ///< mm, in space
  Vec3 first, last;         ///< unit directions of travel at its beginning and end
  double programmed = 0;    ///< mm/s; infinite for rapids and moves without a feed
  double speed = 0;         ///< mm/s; greatest speed of the axes along it
  double acceleration = 0;  ///< mm/s2 likewise
  bool rapid = false;
  bool arc = false;
  PathControl path;
  bool from_rest = false;

  double asked() const { return programmed < speed ? programmed : speed; }
  double climb() const { return move->z_to - move->z_from; }
};

/// Moves of no length are left out: they take no time and do not stop other moves; a standstill before such a move
/// becomes one before the next. Arcs have the limits of the slower of X and Y, with their share of Z.
std::vector<Leg> legs_of(std::span<const PlannedMove> moves, const Machine& machine);

/// s over `length` mm from `v0` to `v1` with at most `top` between, mm/s, at `a` mm/s2.
double ramped_time(double length, double v0, double v1, double top, double a);

}  // namespace clearcut::kinematics
