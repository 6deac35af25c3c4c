// A program as one list of moves, each with its tool, its time, and the results of checking, and the additional
// material that a control may cut by rounding a corner of the path within its tolerance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "base/containers.h"
#include "model/control.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "verify/program/shaped_cutter.h"

namespace clearcut::verify {

/// Cutting length by classes of engagement: a move has few of them.
class AngleClasses {
 public:
  static constexpr int kCount = 18;  ///< number of classes of 10 degrees each

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

/// Material taken by an entry on one move: its engagement counts separately.
struct EntryLoad {
  bool begins = false;   ///< the first move of its entry in material
  double length_mm = 0;  ///< in material
  double max_deg = 0;    ///< greatest angle of the circle in material
  double max_axial_mm = 0;
  Place max_at;
};

/// Material taken by a tool beyond the ability of its kind.
struct Overcut {
  Place at;
  double taken_mm = 0;  ///< sideways: square to its path; downwards: the radius of the material below it
  bool sideways = false;
};

/// Material close to the tool above its flutes.
struct WallBeyondFlutes {
  Place at;
  double height = 0;  ///< mm over the tip
};

/// Load of the cutter on one move.
struct MoveLoad {
  double cutting_mm = 0;  ///< mm with engagement of the cutter
  double air_mm = 0;      ///< mm below the top of the stock without engagement
  double over_limit_mm = 0;
  double climb_mm = 0;
  double conventional_mm = 0;
  double angle_mm_deg = 0;  ///< integral of the engagement over the length, degree mm
  double max_deg = 0;
  Place max_at;
  AngleClasses classes;
  double axial_mm = 0;  ///< mm; greatest height of material above the tip
  Place axial_at;
  HeapOptional<Place> rapid_contact;   ///< a place at which a rapid touches material
  HeapOptional<Place> plunge_contact;  ///< a place at which a cutter plunges although it must not
  /// A place at which the holder, or a shank wider than the cutter, touches material.
  HeapOptional<Place> holder_contact;
  HeapOptional<WallBeyondFlutes> wall_beyond_flutes;
  HeapOptional<EntryLoad> entry;
  HeapOptional<Overcut> overcut;
  HeapOptional<ReferenceLoad> reference;  ///< reference load; only if feeds follow the load
  bool by_flank = false;                  ///< a cone cuts only beside its tip
  bool is_shank = false;                  ///< the shank, not the holder, touches
  HeapOptional<CuttingLoad> forces;       ///< forces; only if the work's material is known
  double force_mm_n = 0;                  ///< N mm; integral of the force over the length
};

/// A move of the program, with its data and the results of checking.
struct CheckedMove {
  const Move* move = nullptr;
  const Tool* tool = nullptr;  ///< null: unknown
  int tool_number = 0;
  bool clockwise = true;
  double rpm = 0;
  /// The move belongs to an earlier program: it removes material, but is not in the figures.
  bool earlier = false;
  std::optional<double> carried_below = {};  ///< for cuts of an earlier set-up, see Section
  /// The move represents a volume missing in the stock, see Section.
  bool is_of_stock = false;
  int workingstep = -1;                   ///< workingstep of the move; -1: none. Used only for grouping
  int layer = -1;                         ///< index among the workingstep's layers
  const ControlState* control = nullptr;  ///< state of the control at this move; null: unknown
  double path_tolerance = 0;              ///< mm; the control may round the corners at both ends by this
  /// mm; greatest deviation of the control's arc from the written one.
  double doubt = 0;
  double time_s = 0;  ///< with the waits before the move
  double waits_s = 0;
  double time_naive_s = 0;
  std::optional<Gouge> gouge;
  HeapOptional<Gouge> into_stock_to_leave;  ///< depth of its cut into stock to leave
  MoveLoad load;

  bool feeds() const { return !is_rapid(move->kind); }
  double radius() const { return tool ? tool->radius() : 0; }
  /// Whether the move is a cut of an earlier set-up, where it was checked.
  bool is_carried() const { return carried_below.has_value(); }
  /// Whether its removed volume counts from z on down.
  bool counts_below(double z) const { return !carried_below || *carried_below >= z; }
  double low_z() const { return std::min(move->z_from, move->z_to); }
  bool is_flat() const { return move->z_from == move->z_to; }
  /// Whether a feed move was found to remove material.
  bool cuts() const {
    return feeds() && (load.axial_mm > 0 || load.cutting_mm > 0 || load.plunge_contact.has_value());
  }
  /// The same, also if only the flank of a cone is in material.
  bool works() const { return cuts() || (feeds() && load.by_flank); }
  /// mm of descent of the tip for each mm of advance in plan view; infinite straight down.
  double slope() const {
    const double down = move->z_from - move->z_to;
    if (down <= 0) return 0;
    return move->is_vertical() ? HUGE_VAL : down / move->path.length();
  }
};

/// Heights of a workingstep's cuts, mm, in descending order.
using LayerHeights = std::vector<double>;

/// All moves, and the layers of each workingstep.
struct CheckedProgram {
  std::vector<CheckedMove> moves;
  std::vector<LayerHeights> layers;  ///< for each workingstep
};

/// Lists the moves of `toolpath` with their tools, times, workingstep and layer. The workingstep is found by
/// the section's number, else by its label, else by place and depth. Moves of `earlier` come first and belong
/// to no workingstep. With `control` every move has the state of the control, and times include waits.
CheckedProgram checked_program(const Part& part, const Toolpath& toolpath, const Machine& machine,
                               const Toolpath* earlier = nullptr, const ControlTable* control = nullptr,
                               const ControlTable* earlier_control = nullptr);

/// Two lines from a point of `before` to a point of `after`, through the point `tolerance` mm from the corner on the
/// inside of the turn. The control's path is between these lines and the programmed one. Nothing if the moves join
/// smoothly, or if one of them is a rapid or vertical.
std::optional<std::array<Move, 2>> rounded_corner(const CheckedMove& before, const CheckedMove& after,
                                                  double tolerance);

/// mm; the greatest tolerance of a control's corner rounding between these feed moves.
double corner_tolerance(std::span<const CheckedMove> moves);

}  // namespace clearcut::verify
