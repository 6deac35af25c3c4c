#include "link/sections/high_rapids.h"

#include <algorithm>

#include "stock/cutting_load.h"

namespace clearcut::link {
namespace {

/// mm. Material thinner than this, beside or below the cutter, is due to rounding.
constexpr double kRounding = 1e-3;
/// mm; least increase of the next tried height: places found on a boundary may be below it.
constexpr double kHigher = 0.05;

/// mm; the lowest height, `z` or above, at which a cutter meets no material along `path`.
double clear_height(const Edge& path, const CutterProfile& cutter, double z,
                    const stock::Material& material) {
  while (z < material.z_top()) {
    const auto met = material.in_reach(path, cutter, z + kRounding);
    if (!met) return z;
    z = std::max(material.height(*met), z + kHigher);
  }
  return z;
}

/// The moves of a section, written anew one by one.
class Rewriter {
 public:
  Rewriter(const Tool& tool, const HighRapids& options, stock::Material& material)
      : tool_(tool),
        cutter_(outer_profile(tool).narrowed(kRounding)),
        options_(options),
        material_(material) {}

  void add(const Move& move) {
    if (moves_.empty()) z_ = move.z_from;
    if (!is_rapid(move.kind)) return add_feed(move);
    if (move.is_vertical()) return go_to_height(move.path.from, move.z_to);
    if (move.z_from == move.z_to) return cross(move);
    return_to(move);
    append(move);
  }

  std::vector<Move> take() { return std::move(moves_); }

 private:
  void append(const Move& move) {
    moves_.push_back(move);
    z_ = move.z_to;
  }

  void vertical(Vec2 at, double z, MoveKind kind, MmPerMin feed) {
    if (z != z_) append({Edge::line(at, at), z_, z, kind, feed, 0});
  }

  /// Moves from the end of a lifted rapid back to the start of the next move.
  void return_to(const Move& next) {
    if (z_ != next.z_from) go_to_height(next.path.from, next.z_from);
  }

  void add_feed(const Move& move) {
    return_to(move);
    append(move);
    stock::remove_cut(material_, move, tool_);
  }

  void go_to_height(Vec2 at, double z) {
    if (z >= z_) return vertical(at, z, MoveKind::kRapid, {});
    const double met = clear_height(Edge::line(at, at), cutter_, z, material_);
    if (met <= z) return vertical(at, z, MoveKind::kRapid, {});
    vertical(at, std::min(z_, met + options_.above_material), MoveKind::kRapid, {});
    vertical(at, z, MoveKind::kPlunge, options_.plunge_feed);
    if (moves_.back().kind == MoveKind::kPlunge) stock::remove_cut(material_, moves_.back(), tool_);
  }

  void cross(Move move) {
    const double met = clear_height(move.path, cutter_, move.z_from, material_);
    if (met <= move.z_from) {
      return_to(move);
      return append(move);
    }
    const double high = std::max(z_, met + options_.above_material);
    if (!moves_.empty() && moves_.back().is_vertical() && is_rapid(moves_.back().kind) && high > z_) {
      moves_.back().z_to = z_ = high;
    }
    vertical(move.path.from, high, MoveKind::kRapid, {});
    move.z_from = move.z_to = high;
    append(move);
  }

  const Tool& tool_;
  const CutterProfile cutter_;
  const HighRapids& options_;
  stock::Material& material_;
  std::vector<Move> moves_;
  double z_ = 0;  ///< mm; height of the cutter
};

}  // namespace

void keep_rapids_high(Section& section, const Tool& tool, const HighRapids& options,
                      stock::Material& material) {
  Rewriter rewriter(tool, options, material);
  for (const Move& move : section.moves) rewriter.add(move);
  section.moves = rewriter.take();
}

}  // namespace clearcut::link
