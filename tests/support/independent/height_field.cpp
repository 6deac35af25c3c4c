#include "support/independent/height_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"

namespace clearcut::test_support {
namespace {

/// mm. Nearer to walls and floors nothing is checked: programs are rounded, and material may stay in residuals.
constexpr double kSlack = 0.012;
/// Directions in which a place is looked for from where the cutter reaches.
constexpr int kDirections = 24;

double wall_distance(const Regions& regions, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Region& region : regions) least = std::min(least, region.boundary_distance(p));
  return least;
}

struct Cell {
  Vec2 center;
  double design = 0;   ///< height that the part keeps here
  double reached = 0;  ///< height down to which a cutter of the work certainly reaches
  double height = 0;   ///< of what is certainly still there
  bool sure = true;    ///< far enough from all walls to check
};

class HeightField {
 public:
  HeightField(const Part& part, double cell) : cell_(cell) {
    Box box;
    for (const Feature& feature : part.features) box.add(clearcut::box(feature.target));
    box = box.grown(5 * cell);
    origin_ = box.min;
    columns_ = static_cast<int>(box.width() / cell) + 1;
    rows_ = static_cast<int>(box.height() / cell) + 1;
    for (int r = 0; r < rows_; ++r) {
      for (int c = 0; c < columns_; ++c)
        cells_.push_back(cell_of(part, origin_ + Vec2{(c + 0.5) * cell, (r + 0.5) * cell}));
    }
  }

  void follow(const Move& move, double radius) {
    const double length = move.path.from == move.path.to ? 0 : move.path.length();
    const int steps = static_cast<int>(std::max(length, std::abs(move.z_to - move.z_from)) / (cell_ / 2)) + 1;
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps, z = std::lerp(move.z_from, move.z_to, t);
      const Vec2 p = length > 0 ? move.path.at(t) : move.path.from;
      is_rapid(move.kind) ? pass_over(p, z, radius) : cut(p, z, radius);
    }
  }

  HeightFindings findings() {
    for (const Cell& cell : cells_) {
      if (cell.sure) note(cell.height - cell.reached - kSlack, cell.center, found_.uncut_mm, found_.uncut_at);
    }
    return found_;
  }

 private:
  static Cell cell_of(const Part& part, Vec2 p) {
    Cell cell{p, part.top_z(), part.top_z(), part.top_z(), true};
    for (const Workingstep& step : part.workplan) {
      const Feature& feature = feature_of(part, step);
      cell.sure = cell.sure && wall_distance(feature.target, p) > kSlack;
      if (!contains(feature.target, p)) continue;
      cell.design = std::min(cell.design, feature.floor_z);
      const Tool& tool = tool_of(part, step);
      const double flat = tool.radius() - tool.corner_radius;
      const double stock = step.operation.allowance_side + tool.corner_radius;
      if (reaches(feature.allowed, p, flat, stock))
        cell.reached = std::min(cell.reached, feature.floor_z + step.operation.allowance_floor);
    }
    return cell;
  }

  /// Whether a centre that leaves `stock` on all walls was found within the radius of p.
  static bool reaches(const Regions& allowed, Vec2 p, double radius, double stock) {
    for (const double share : {0.0, 0.5, 0.9}) {
      for (int i = 0; i < (share == 0 ? 1 : kDirections); ++i) {
        const Vec2 center = p + direction_of(2 * kPi * i / kDirections) * (share * radius);
        if (contains(allowed, center) && wall_distance(allowed, center) > radius + stock + kSlack)
          return true;
      }
    }
    return false;
  }

  void cut(Vec2 p, double z, double radius) {
    for_cells(p, radius + cell_, [&](Cell& cell) {
      cell.height = std::min(cell.height, z);
      if (cell.sure && distance(cell.center, p) < radius - kSlack)
        note(cell.design - z - kSlack, cell.center, found_.gouge_mm, found_.gouge_at);
    });
  }

  void pass_over(Vec2 p, double z, double radius) {
    for_cells(p, radius - cell_, [&](Cell& cell) {
      note(cell.height - z - kSlack, cell.center, found_.rapid_mm, found_.rapid_at);
    });
  }

  static void note(double depth, Vec2 at, double& worst, Vec2& worst_at) {
    if (depth <= worst) return;
    worst = depth;
    worst_at = at;
  }

  template <typename F>
  void for_cells(Vec2 p, double reach, F&& f) {
    const auto index = [&](double x, double from, int most) {
      return std::clamp(static_cast<int>((x - from) / cell_), 0, most - 1);
    };
    for (int r = index(p.y - reach, origin_.y, rows_); r <= index(p.y + reach, origin_.y, rows_); ++r) {
      for (int c = index(p.x - reach, origin_.x, columns_); c <= index(p.x + reach, origin_.x, columns_);
           ++c) {
        Cell& cell = cells_[static_cast<std::size_t>(r * columns_ + c)];
        if (distance(cell.center, p) <= reach) f(cell);
      }
    }
  }

  double cell_;
  Vec2 origin_;
  int columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
  HeightFindings found_;
};

double radius_of(const Part& part, int tool_number) {
  for (const Tool& tool : part.tools) {
    if (tool.number == tool_number) return tool.diameter / 2;
  }
  return 0;
}

}  // namespace

std::string HeightFindings::text() const {
  if (gouge_mm > 0)
    return fmt::format("gouge {:.3f} mm at ({:.2f}, {:.2f})", gouge_mm, gouge_at.x, gouge_at.y);
  if (rapid_mm > 0)
    return fmt::format("rapid {:.3f} mm in material at ({:.2f}, {:.2f})", rapid_mm, rapid_at.x, rapid_at.y);
  if (uncut_mm > 0)
    return fmt::format("uncut {:.3f} mm at ({:.2f}, {:.2f})", uncut_mm, uncut_at.x, uncut_at.y);
  return "";
}

HeightFindings simulate(const Part& part, const Toolpath& toolpath, double cell) {
  HeightField field(part, cell);
  for (const Section& section : toolpath.sections) {
    const double radius = radius_of(part, section.tool_number);
    for (const Move& move : section.moves) field.follow(move, radius);
  }
  return field.findings();
}

}  // namespace clearcut::test_support
