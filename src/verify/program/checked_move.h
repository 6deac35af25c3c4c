// A program as one list of moves, each with its tool, its time, and what checking found.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/rare.h"
#include "model/control.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "verify/program/gouge.h"

namespace clearcut::verify {

/// Cutting length by classes of engagement: a move has few of them.
class AngleClasses {
 public:
  static constexpr int kCount = 18;  ///< of 10 degrees each

  void add(double angle_deg, double length_mm) {
    const int number = std::min(kCount - 1, static_cast<int>(angle_deg / 10));
    for (Share& share : shares_)
      if (share.number == number) return void(share.length_mm += length_mm);
    shares_.push_back({number, length_mm});
  }
  void add_to(std::array<double, kCount>& histogram_mm) const {
    for (const Share& share : shares_)
      histogram_mm[static_cast<std::size_t>(share.number)] += share.length_mm;
  }

 private:
  struct Share {
    int number = 0;
    double length_mm = 0;
  };
  std::vector<Share> shares_;
};

/// What an entry takes on one move: its engagement counts apart.
struct EntryLoad {
  bool begins = false;   ///< the first move of its entry that meets material
  double length_mm = 0;  ///< in material
  double max_deg = 0;    ///< the angle of the circle in material, where it is greatest
  double max_axial_mm = 0;
  Place max_at;
};

/// What a tool takes that its kind cannot.
struct Overcut {
  Place at;
  double taken_mm = 0;  ///< sideways square to its way, down the radius of what stands below it
  bool sideways = false;
};

/// What the cutter engages on one move.
struct MoveLoad {
  double cutting_mm = 0;  ///< mm on which the cutter engages
  double air_mm = 0;      ///< mm below the top of the stock on which it does not
  double over_limit_mm = 0;
  double climb_mm = 0;
  double conventional_mm = 0;
  double angle_mm_deg = 0;  ///< integral of the engagement over the length, degree mm
  double max_deg = 0;
  Place max_at;
  AngleClasses classes;
  double axial_mm = 0;  ///< mm; greatest height of material above the tip
  Place axial_at;
  Rare<Place> rapid_contact;   ///< a place where a rapid touches material
  Rare<Place> plunge_contact;  ///< a place where a cutter that must not plunge does so
  Rare<Place>
      holder_contact;  ///< a place where the holder, or a shank wider than the cutter, touches material
  Rare<EntryLoad> entry;
  Rare<Overcut> overcut;
  Rare<ReferenceLoad> reference;  ///< only where feeds go by the load
  bool by_flank = false;          ///< a cone cuts beside its tip alone
  bool is_shank = false;          ///< which of them: the shank
  Rare<CuttingLoad> forces;       ///< only if the work's material is known
  double force_mm_n = 0;          ///< N mm; integral of the force over the length
};

/// A move of the program, with what is known about it and what checking found.
struct CheckedMove {
  const Move* move = nullptr;
  const Tool* tool = nullptr;  ///< null: unknown
  int tool_number = 0;
  bool clockwise = true;
  double rpm = 0;
  /// Belongs to a program that ran before: it removes material, but is not in the figures.
  bool earlier = false;
  std::optional<double> carried_below = {};  ///< of cuts that an earlier set-up made, see Section
  bool is_of_stock = false;                  ///< what the stock lacks, see Section
  int workingstep = -1;                      ///< the one that it belongs to; -1: none. Used for grouping only
  int layer = -1;                            ///< index among the workingstep's layers
  const ControlState* control = nullptr;     ///< what the control held at this move; null: unknown
  double path_tolerance = 0;                 ///< mm; the control may round the corners at both ends by this
  double doubt = 0;                          ///< mm; how far the control's arc may lie from the written one
  double time_s = 0;                         ///< with the waits before the move
  double waits_s = 0;
  double time_naive_s = 0;
  std::optional<Gouge> gouge;
  Rare<Gouge> into_stock_to_leave;  ///< how deep it cuts into what was to be left
  MoveLoad load;

  bool feeds() const { return !is_rapid(move->kind); }
  double radius() const { return tool ? tool->radius() : 0; }
  /// Whether it is a cut of an earlier set-up: it was checked there.
  bool is_carried() const { return carried_below.has_value(); }
  /// Whether what it removed is gone from z on down.
  bool counts_below(double z) const { return !carried_below || *carried_below >= z; }
  double low_z() const { return std::min(move->z_from, move->z_to); }
  bool is_flat() const { return move->z_from == move->z_to; }
  /// Whether a feed move was found to remove material.
  bool cuts() const {
    return feeds() && (load.axial_mm > 0 || load.cutting_mm > 0 || load.plunge_contact.has_value());
  }
  /// The same, also where only the flank of a cone is in material.
  bool works() const { return cuts() || (feeds() && load.by_flank); }
  /// mm that the tip goes down for each mm of advance in plan view; infinite straight down.
  double slope() const {
    const double down = move->z_from - move->z_to;
    if (down <= 0) return 0;
    return move->is_vertical() ? HUGE_VAL : down / move->path.length();
  }
};

/// Heights at which a workingstep cuts, mm, in descending order.
using LayerHeights = std::vector<double>;

/// All moves, and the layers of each workingstep.
struct CheckedProgram {
  std::vector<CheckedMove> moves;
  std::vector<LayerHeights> layers;  ///< for each workingstep
};

/// Lists the moves of `toolpath` with their tools, times, workingstep and layer. The workingstep is found by
/// the section's number, else by its label, else by place and depth. Moves of `earlier` come first and belong
/// to no workingstep. With `control` every move knows what the control held, and times include waits.
CheckedProgram checked_program(const Part& part, const Toolpath& toolpath, const Machine& machine,
                               const Toolpath* earlier = nullptr, const ControlTable* control = nullptr,
                               const ControlTable* earlier_control = nullptr);

}  // namespace clearcut::verify
