#include "verify/faults/crossed_draft.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace clearcut::verify {
namespace {

/// mm. So much nearer to its axis the cutter's surface is taken to be, and so far beside anything cleared a place is solid: both together are
/// less than the smallest gouge that counts.
constexpr double kNarrower = 0.0006, kSolid = 0.0003;
/// Greatest number of cells tested for one move; more would take seconds.
constexpr int kMostCells = 400000;
/// Pieces of a sloping move at most.
constexpr int kMostPieces = 32;
constexpr double kSqrt2 = 1.41421356237309515;

struct Cell {
  Vec2 center;
  double half = 0;
};

double distance_from(const Edge& path, Vec2 p) {
  return path.from == path.to ? distance(path.from, p) : distance(path, p);
}

class SweptArea {
 public:
  SweptArea(const FinishedPart& part, const CutterProfile& cutter) : part_(part), cutter_(cutter) {}

  bool is_clear(const Edge& path, double z) {
    const Box box = path.box().grown(cutter_.widest);
    std::vector<Cell> cells{{box.center(), std::max(box.width(), box.height()) / 2}};
    while (!cells.empty()) {
      const Cell cell = cells.back();
      cells.pop_back();
      if (++looked_at_ > kMostCells) return false;
      const double far = cell.half * kSqrt2, off = distance_from(path, cell.center);
      if (off - far >= cutter_.widest) continue;
      const double cleared = part_.cleared_by(cell.center, z + cutter_.height_at(std::max(0.0, off - far)));
      if (cleared >= far) continue;
      if (cleared < -kSolid && off < cutter_.widest &&
          part_.cleared_by(cell.center, z + cutter_.height_at(off)) < -kSolid)
        return false;
      if (far < kSolid) continue;
      const double half = cell.half / 2;
      for (const Vec2 corner : {Vec2{half, half}, Vec2{-half, half}, Vec2{half, -half}, Vec2{-half, -half}})
        cells.push_back({cell.center + corner, half});
    }
    return true;
  }

 private:
  const FinishedPart& part_;
  CutterProfile cutter_;
  int looked_at_ = 0;
};

}  // namespace

bool is_clear_of_crossed_draft(const FinishedPart& part, const Move& move, const CutterProfile& cutter,
                               double slack) {
  SweptArea area(part, cutter.narrowed(kNarrower));
  const double low = std::min(move.z_from, move.z_to), high = std::max(move.z_from, move.z_to);
  if (move.is_vertical() || low == high) return area.is_clear(move.path, low + slack);
  const double span = high - low;
  const int pieces = std::clamp(static_cast<int>(std::ceil(span / kSolid)), 1, kMostPieces);
  for (int i = 0; i < pieces; ++i) {
    const double a = static_cast<double>(i) / pieces, b = (i + 1.0) / pieces;
    const double z = std::min(std::lerp(move.z_from, move.z_to, a), std::lerp(move.z_from, move.z_to, b));
    if (!area.is_clear(move.path.part(a, b), z + slack)) return false;
  }
  return true;
}

}  // namespace clearcut::verify
