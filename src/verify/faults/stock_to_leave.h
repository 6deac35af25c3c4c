// Stock that operations leave on walls and floors on purpose: it must remain after the program.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "verify/part/finished_part.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// The stock left by the workplan in each feature at the end: the least of all its steps.
///
/// A place at height z is to be cleared if some feature contains it, that feature's floor with the stock left there
/// is not above z, and the place is at least the feature's allowance away from every wall at z. A feed move cutting
/// any other place outside of the part cuts into stock to leave. Allowances up to tol.uncut are ignored.
///
/// Error   Along a move that comes too near, places are sampled every kLeftStep mm.
class StockToLeave {
 public:
  /// Keeps a reference to `part`, which must outlive it.
  StockToLeave(const Part& part, const Tolerances& tol);

  /// Whether the workplan leaves anything anywhere.
  bool is_any() const { return raised_ != nullptr; }
  /// The deepest cut of a move into stock to leave, deeper than tol.uncut; `feature` is the feature of this stock.
  std::optional<Gouge> cut_by(const CheckedMove& checked) const;

 private:
  struct Left {
    double side = 0, floor = 0;  ///< mm
  };
  /// A wall with the greatest stock left on it by a feature beside it.
  struct KeptWall {
    Wall wall;
    double side = 0;
    bool is_chamfered = false;
    std::vector<int> of = {};  ///< the features leaving stock on it
  };

  /// Excludes features that cross each other.
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
  std::vector<Left> left_;                ///< stock left by feature
  std::unique_ptr<FinishedPart> raised_;  ///< the part with the stock left on its floors
  std::vector<KeptWall> walls_;
  EdgeTree tree_;                ///< tree of walls_
  std::vector<EdgeTree> lines_;  ///< outlines by feature: for profiles, the outline with stock left on it
  double most_side_ = 0;
  double most_floor_ = 0;
};

/// Finds for each of these moves the depth of its cut into stock to leave.
void check_stock_to_leave(const StockToLeave& left, std::vector<CheckedMove>& moves, std::size_t first,
                          std::size_t last);

}  // namespace clearcut::verify
