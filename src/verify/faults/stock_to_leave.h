// Stock that operations leave on walls and floors on purpose: it has to stand when the program is through.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "verify/part/finished_part.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// What the workplan leaves in each feature at the end: the least of all its steps.
///
/// A place at height z is to be cleared where some feature holds it, whose floor with the stock left there is not above z, and which
/// is at least that feature's allowance away from every wall that stands at z. A feed move that takes any other place, though it is
/// outside the part, cuts into stock to leave. Allowances up to tol.uncut ask for nothing.
///
/// Error   Along a move that comes too near, places are looked at every kLeftStep mm.
class StockToLeave {
 public:
  /// Keeps a reference to `part`, which must outlive it.
  StockToLeave(const Part& part, const Tolerances& tol);

  /// Whether the workplan leaves anything anywhere.
  bool is_any() const { return raised_ != nullptr; }
  /// The deepest cut of a move into stock to leave, deeper than tol.uncut; `feature` is whose stock it is.
  std::optional<Gouge> cut_by(const CheckedMove& checked) const;

 private:
  struct Left {
    double side = 0, floor = 0;  ///< mm
  };
  /// A wall with the most that any feature beside it leaves on it.
  struct KeptWall {
    Wall wall;
    double side = 0;
    bool is_chamfered = false;
    std::vector<int> of = {};  ///< the features that leave stock on it
  };

  /// Of features that cross each other nothing is asked.
  void leave_out_crossing();
  void find_walls();
  bool owes(std::size_t feature, const Wall& wall) const;
  bool is_chamfered(const Wall& wall) const;
  bool is_cleared(Vec2 p, double z) const;
  double least_apart(std::size_t feature, Vec2 p, double z, double limit) const;
  void against(const KeptWall& kept, const CheckedMove& checked, std::optional<Gouge>& worst) const;
  void at_place(const KeptWall& kept, const Tool& tool, Vec2 p, double z, std::optional<Gouge>& worst) const;
  void against_floors(const CheckedMove& checked, std::optional<Gouge>& worst) const;
  int feature_at(Vec2 p) const;

  const Part& part_;
  Tolerances tol_;
  std::vector<Left> left_;                ///< by feature
  std::unique_ptr<FinishedPart> raised_;  ///< the part with the stock that is left on its floors
  std::vector<KeptWall> walls_;
  EdgeTree tree_;                ///< of walls_
  std::vector<EdgeTree> lines_;  ///< by feature: of profiles, the outline that stock is left on
  double most_side_ = 0;
  double most_floor_ = 0;
};

/// Finds for each of these moves how deep it cuts into stock to leave.
void check_stock_to_leave(const StockToLeave& left, std::vector<CheckedMove>& moves, std::size_t first,
                          std::size_t last);

}  // namespace clearcut::verify
