#include "verify/figures.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace clearcut::verify {
namespace {

/// Degrees. Smaller changes of direction are due to rounding and are no turns.
constexpr double kTurn = 0.1;

double degrees_between(Vec2 a, Vec2 b) {
  return std::abs(base::atan2(cross(a, b), dot(a, b))) * 180 / kPi;
}

void add_lengths(Figures& figures, const CheckedMove& checked) {
  const Move& move = *checked.move;
  const double length = move.length();
  (checked.feeds() ? figures.feed_mm : figures.rapid_mm) += length;
  if (checked.feeds() && move.is_vertical() && move.z_to < move.z_from) figures.plunge_mm += length;
  figures.time_s += checked.time_s;
  figures.waits_s += checked.waits_s;
  figures.time_naive_s += checked.time_naive_s;
}

void add_turns(Figures& figures, std::span<const CheckedMove* const> moves) {
  const Move* before = nullptr;
  for (const CheckedMove* checked : moves) {
    const Move& move = *checked->move;
    if (!checked->feeds() || move.is_vertical()) {
      before = nullptr;
      continue;
    }
    if (before && distance(before->path.to, move.path.from) < 1e-9) {
      const double turn = degrees_between(before->path.tangent_at(1), move.path.tangent_at(0));
      if (turn > kTurn) {
        ++figures.turns;
        figures.turn_angle_deg += turn;
      }
    }
    before = &move;
  }
}

void add_retracts(Figures& figures, std::span<const CheckedMove* const> moves, double top_z) {
  bool cutting = false, risen = false;
  for (const CheckedMove* checked : moves) {
    const Move& move = *checked->move;
    if (cutting && std::max(move.z_from, move.z_to) >= top_z) risen = true;
    if (checked->feeds() && checked->low_z() < top_z) {
      if (risen) ++figures.retracts;
      risen = false;
      cutting = true;
    }
  }
}

void add_forces(Figures& figures, const CuttingLoad& forces) {
  if (!figures.load) figures.load = CuttingLoad{};
  CuttingLoad& sum = *figures.load;
  sum.energy_j += forces.energy_j;
  sum.removed_mm3 += forces.removed_mm3;
  sum.wear += forces.wear;
  sum.max_power_w = std::max(sum.max_power_w, forces.max_power_w);
  if (forces.max_force_n <= sum.max_force_n) return;
  sum.max_force_n = forces.max_force_n;
  sum.max_force_at = forces.max_force_at;
}

void add_entry(Entries& entries, const EntryLoad& load) {
  if (load.begins) ++entries.count;
  entries.length_mm += load.length_mm;
  entries.max_axial_mm = std::max(entries.max_axial_mm, load.max_axial_mm);
  if (load.max_deg <= entries.max_deg) return;
  entries.max_deg = load.max_deg;
  entries.max_at = load.max_at;
}

void add_load(Figures& figures, const MoveLoad& load) {
  if (load.entry) add_entry(figures.entries, *load.entry);
  Engagement& engagement = figures.engagement;
  if (load.max_deg > engagement.max_deg) {
    engagement.max_deg = load.max_deg;
    engagement.max_at = load.max_at;
  }
  engagement.over_limit_mm += load.over_limit_mm;
  engagement.climb_mm += load.climb_mm;
  engagement.conventional_mm += load.conventional_mm;
  load.classes.add_to(engagement.histogram_mm);
  if (load.forces) add_forces(figures, *load.forces);
  figures.air_cut_mm += load.air_mm;
  figures.max_axial_mm = std::max(figures.max_axial_mm, load.axial_mm);
  if (load.reference && (!figures.reference_load || load.reference->share > figures.reference_load->share))
    figures.reference_load = *load.reference;
  if (load.rapid_contact) ++figures.rapid_in_material;
}

}  // namespace

Figures figures_of(std::span<const CheckedMove* const> moves, double top_z) {
  Figures figures;
  double cutting_mm = 0, angle_mm_deg = 0, force_mm_n = 0;
  for (const CheckedMove* checked : moves) {
    add_lengths(figures, *checked);
    add_load(figures, checked->load);
    cutting_mm += checked->load.cutting_mm;
    angle_mm_deg += checked->load.angle_mm_deg;
    force_mm_n += checked->load.force_mm_n;
    if (checked->gouge && checked->gouge->depth > figures.gouge_mm) {
      figures.gouge_mm = checked->gouge->depth;
      figures.gouge_at = Place{checked->gouge->point, checked->gouge->z, checked->move->line};
    }
  }
  if (cutting_mm > 0) figures.engagement.mean_deg = angle_mm_deg / cutting_mm;
  if (cutting_mm > 0 && figures.load) figures.load->mean_force_n = force_mm_n / cutting_mm;
  add_turns(figures, moves);
  add_retracts(figures, moves, top_z);
  return figures;
}

}  // namespace clearcut::verify
