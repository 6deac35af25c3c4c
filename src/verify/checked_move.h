// A program as one list of moves, each with what is known and what was found out about it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "model/control.h"
#include "model/findings.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/part.h"
#include "verify/gouge.h"

namespace clearcut::verify {

/// What one move's cutter met.
struct MoveLoad {
  double cutting_mm = 0;  ///< length in contact with material
  double air_mm = 0;      ///< length below the stock's top without contact
  double over_limit_mm = 0;
  double climb_mm = 0;
  double conventional_mm = 0;
  double angle_mm_deg = 0;  ///< integral of the contact angle over the length, degree mm
  double max_deg = 0;
  Place max_at;
  std::array<double, 18> histogram_mm{};
  double axial_mm = 0;  ///< greatest height of material above the tip
  Place axial_at;
  std::optional<Place> rapid_contact;   ///< where a rapid touches material
  std::optional<Place> plunge_contact;  ///< where a cutter that may not plunge does
  std::optional<CuttingLoad> forces;    ///< where the material of the work is known
  double force_mm_n = 0;                ///< integral of the force over the length, N mm
};

/// Radius of the part of a cutter's end that is flat: its floor needs no cusps. mm.
inline double flat_radius_of(const Tool& tool) {
  if (tool.kind == ToolKind::kBallEndMill) return 0;
  return std::max(0.0, tool.radius() - tool.corner_radius);
}

struct JudgedMove {
  const Move* move = nullptr;
  const Tool* tool = nullptr;  ///< null: unknown
  int tool_number = 0;
  bool clockwise = true;
  double rpm = 0;
  bool earlier = false;                   ///< of a program that has run before: cuts, but counts nothing
  int workingstep = -1;                   ///< whose work it is, for grouping only
  int layer = -1;                         ///< index among the workingstep's layers
  const ControlState* control = nullptr;  ///< what the control holds; null: unknown
  double path_tolerance = 0;              ///< mm; the control may round the corners at its ends by this
  double doubt = 0;                       ///< mm; the control may make another arc of it, this far away
  double time_s = 0;                      ///< with the waits before it
  double waits_s = 0;
  double time_naive_s = 0;
  std::optional<Gouge> gouge;
  MoveLoad load;

  bool feeds() const { return !is_rapid(move->kind); }
  double radius() const { return tool ? tool->radius() : 0; }
  double low_z() const { return std::min(move->z_from, move->z_to); }
  bool is_flat() const { return move->z_from == move->z_to; }
  /// Whether a feed move was seen to take material away.
  bool cuts() const {
    return feeds() && (load.axial_mm > 0 || load.cutting_mm > 0 || load.plunge_contact.has_value());
  }
  /// mm the tip goes down for each mm of advance in plan; infinite straight down.
  double slope() const {
    const double down = move->z_from - move->z_to;
    if (down <= 0) return 0;
    return move->is_vertical() ? HUGE_VAL : down / move->path.length();
  }
};

/// Depths at which a workingstep cuts, descending.
using LayerHeights = std::vector<double>;

struct JudgedProgram {
  std::vector<JudgedMove> moves;
  std::vector<LayerHeights> layers;  ///< by workingstep
};

/// Lists the moves of `toolpath` with their tools, times, and the workingstep and layer they belong to: by
/// the section's number, else its label, else by place and depth. The moves of `earlier`, if any, go before, and belong to
/// no workingstep. With `control` every move knows what the control held, and times hold the waits.
JudgedProgram judged_program(const Part& part, const Toolpath& toolpath, const Machine& machine,
                             const Toolpath* earlier = nullptr, const ControlTable* control = nullptr);

}  // namespace clearcut::verify
