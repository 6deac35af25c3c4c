#include "pipeline/steps/stated_step.h"

#include <algorithm>

#include "base/tolerances.h"
#include "link/moves.h"
#include "pipeline/steps/certify.h"

namespace clearcut::pipeline {
namespace {

/// The feed of a move without a stated one.
MmPerMin usual_feed(MoveKind kind, const link::LinkOptions& link) {
  switch (kind) {
    case MoveKind::kRapid:
      return MmPerMin::of(0);
    case MoveKind::kPlunge:
      return link.plunge_feed;
    case MoveKind::kRamp:
      return link.ramp_feed;
    case MoveKind::kLeadIn:
    case MoveKind::kLeadOut:
      return link.lead_feed.value_or(link.feed);
    case MoveKind::kCut:
    case MoveKind::kLink:
    case MoveKind::kRetract:
      break;
  }
  return link.feed;
}

/// Writes the moves of one path with the lifts between them.
class StatedMoves {
 public:
  /// `top_z`: top of all remaining material.
  StatedMoves(const StatedMove& first, double top_z, const link::LinkOptions& link)
      : link_(link), top_z_(top_z), moves_(first.path.from, std::max(link.safe_z, first.z_from)) {}

  void add(const StatedMove& move) {
    const bool goes_on = distance(move.path.from, moves_.at()) <= kSamePlaceMm &&
                         std::abs(move.z_from - moves_.z()) <= kSamePlaceMm;
    if (!goes_on) go_over(move.path.from, move.z_from);
    const MmPerMin feed = move.feed.value_or(usual_feed(move.kind, link_));
    Edge path = move.path;
    path.from = moves_.at();
    if (move.path.from == move.path.to) path.to = path.from;
    moves_.append({{path, moves_.z(), move.z_to, move.kind, feed, 0}});
    ++count_;
    if (move.dwell_s > 0) dwells_.push_back({count_ - 1, move.dwell_s});
  }

  Section finished() {
    if (moves_.z() < link_.safe_z) rapid(link_.safe_z);
    Section section;
    section.moves = moves_.take();
    section.dwells = std::move(dwells_);
    return section;
  }

 private:
  void rapid(double z) {
    if (z == moves_.z()) return;
    moves_.vertical(z, MoveKind::kRapid, MmPerMin::of(0));
    ++count_;
  }
  void go_over(Vec2 to, double z) {
    rapid(std::max({link_.safe_z, z, moves_.z()}));
    if (to != moves_.at()) {
      moves_.line(to, MoveKind::kRapid, MmPerMin::of(0));
      ++count_;
    }
    rapid(std::max(z, std::min({link_.cross_z, link_.safe_z, top_z_ + link_.above_material})));
    if (z == moves_.z()) return;
    moves_.vertical(z, MoveKind::kPlunge, link_.plunge_feed);
    ++count_;
  }

  const link::LinkOptions& link_;
  double top_z_;
  link::MoveList moves_;
  std::vector<Dwell> dwells_;
  std::size_t count_ = 0;
};

}  // namespace

std::optional<Section> stated_step(int workingstep, const ResolvedPlan& plan) {
  const StatedPath* path = path_of(plan.part.workplan.at(static_cast<std::size_t>(workingstep)));
  if (path == nullptr) return std::nullopt;
  Section section;
  if (!path->moves.empty()) {
    const link::LinkOptions link = link_options(plan, workingstep, EntryKind::kPlunge);
    StatedMoves moves(path->moves.front(), plan.part.top_z(), link);
    for (const StatedMove& move : path->moves) moves.add(move);
    section = moves.finished();
  }
  describe(section, workingstep, plan);
  return section;
}

}  // namespace clearcut::pipeline
