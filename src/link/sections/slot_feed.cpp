#include "link/sections/slot_feed.h"

#include <algorithm>
#include <cmath>

#include "model/cutter_profile.h"

namespace clearcut::link {
namespace {

constexpr double kStepsPerRadius = 8;
/// Degrees. A link with less engagement touches nothing.
constexpr double kTouching = 1;
/// mm. Material thinner than this is due to rounding.
constexpr double kResidual = 1e-3;

/// Divides a move into equal steps and returns the slow ones among them.
std::vector<bool> slow_steps(const Move& move, double radius, int cutter, Radians limit,
                             const stock::Material& material) {
  const int count = std::max(1, static_cast<int>(std::ceil(move.path.length() * kStepsPerRadius / radius)));
  std::vector<bool> slow;
  Move raised = move;
  raised.z_from += kResidual;
  raised.z_to += kResidual;
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    slow.push_back(material.engagement(raised, t, radius - kResidual, cutter).angle > limit.radians());
  }
  // One step more on both sides, because the engagement rises before the sample at which it is measured.
  std::vector<bool> wide = slow;
  for (std::size_t i = 0; i < slow.size(); ++i) {
    if (!slow[i]) continue;
    if (i > 0) wide[i - 1] = true;
    if (i + 1 < slow.size()) wide[i + 1] = true;
  }
  return wide;
}

void append_by_speed(const Move& move, const std::vector<bool>& slow, MmPerMin slot_feed,
                     std::vector<Move>& out) {
  const double count = static_cast<double>(slow.size());
  for (std::size_t i = 0; i < slow.size();) {
    std::size_t end = i + 1;
    while (end < slow.size() && slow[end] == slow[i]) ++end;
    Move piece = move;
    const bool whole = i == 0 && end == slow.size();
    if (!whole) piece.path = move.path.part(static_cast<double>(i) / count, static_cast<double>(end) / count);
    if (i == 0) piece.path.from = move.path.from;
    if (i > 0) piece.path.from = out.back().path.to;
    if (end == slow.size()) piece.path.to = move.path.to;
    if (slow[i]) piece.feed = slot_feed;
    out.push_back(piece);
    i = end;
  }
}

}  // namespace

void slow_down_slots(Section& section, const Tool& tool, const SlowFeeds& feeds, stock::Material& material) {
  // For this tool, its own passes count with its whole circle; for other tools, with the volume removed by its
  // profile.
  const double radius = tool.radius();
  const int cutter = material.add_cutter(inner_profile(tool), radius);
  std::vector<Move> moves;
  const auto append = [&](const Move& move, Radians limit, MmPerMin feed, std::vector<Move>& out) {
    if (feed < move.feed) {
      append_by_speed(move, slow_steps(move, radius, cutter, limit, material), feed, out);
    } else {
      out.push_back(move);
    }
  };
  for (const Move& move : section.moves) {
    if (is_rapid(move.kind) || move.is_vertical() || move.z_from != move.z_to) {
      moves.push_back(move);
    } else if (move.kind == MoveKind::kLink) {
      std::vector<Move> pieces;
      append(move, Radians::of_degrees(kTouching), feeds.cut_feed, pieces);
      for (const Move& piece : pieces) append(piece, feeds.limit, feeds.slot_feed, moves);
    } else {
      append(move, feeds.limit, feeds.slot_feed, moves);
    }
    if (is_rapid(move.kind)) continue;
    if (cutter == stock::Material::kCylinder) {
      material.add(move, radius);
    } else {
      material.add_sweep(move, cutter);
    }
  }
  section.moves = std::move(moves);
}

}  // namespace clearcut::link
