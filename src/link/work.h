// The passes of all layers of one feature as items of work, their precedence, and the place on a pass at which
// cutting begins.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/route/legal_area.h"
#include "geometry/route/legal_paths.h"
#include "geometry/spatial/box_tree.h"
#include "model/layer.h"

namespace clearcut::link {

struct PassStart {
  Vec2 point;
  std::size_t edge = 0;  ///< for closed passes: the edge of the place
  double t = 0;
  bool backwards = false;  ///< for open passes: run from the last point to the first
};

/// The closed path, begun at `start`.
Path rotated_to(const Path& path, const PassStart& start);

/// The start nearest to p: anywhere on a closed pass, at an end of a reversible one, else at its beginning.
/// Cost O(edges).
PassStart nearest_start(const Pass& pass, Vec2 p);

/// One layer: its passes, and the legal area of the cutter's centre.
class LayerWork {
 public:
  LayerWork(const LayerPasses& layer, double tool_radius);

  const LayerPasses& layer() const { return *layer_; }
  const LegalArea& legal() const { return legal_; }
  /// Finds paths round corners. Made at the first call; the object must not be moved after that.
  const LegalRoutes& routes() const;
  /// Positions of the cutter's centre in which the cutter touches the target; elsewhere everything is already
  /// cleared. Made at the first call.
  const Regions& touching() const;
  /// The places of that area's boundary nearest to p, one on each of the `most` nearest edges, the nearest first.
  std::vector<Vec2> nearest_on_rim(Vec2 p, std::size_t most) const;
  /// The target as an area that is asked quickly. Made at the first call.
  const LegalArea& target_area() const;
  /// Positions of the cutter's centre in which the cutter is within the target. Made at the first call.
  const Regions& within_target() const;
  /// Whether a cutter in the legal area may reach places outside of the target. Made at the first call.
  bool reaches_beside() const;
  /// Whether the cutter may leave the material sideways.
  bool open() const { return open_; }
  /// Whether a ring is cut in the opposite direction: outer rings of open layers are cut from the air
  /// inwards.
  bool turned_round(std::size_t pass) const;
  /// Of a pass and the pass around it, the index of the one to be cut later; -1 if no pass is around it.
  int later_of_tree_edge(std::size_t pass) const;
  /// Index of the connected part of the legal area around p; -1 if there is none.
  int part_around(Vec2 p) const;
  std::size_t parts() const { return layer_->legal.size(); }

 private:
  const LayerPasses* layer_;
  LegalArea legal_;
  double tool_radius_;
  mutable std::unique_ptr<LegalRoutes> routes_;
  mutable std::optional<Regions> touching_;
  mutable std::optional<LegalArea> target_area_;
  mutable std::optional<Regions> within_target_;
  mutable std::optional<bool> reaches_beside_;
  struct Rim {
    std::vector<Edge> edges;
    BoxTree tree;
  };
  mutable std::optional<Rim> rim_;  ///< of touching_; made at the first question
  bool open_ = false;
};

/// One pass of one layer.
struct WorkItem {
  std::size_t layer = 0;
  std::size_t pass = 0;
  Box path;   ///< box of the path of the centre
  Box swept;  ///< box of the area swept by the cutter
};

/// All passes, layer by layer, with their precedence.
///
/// Sequence  A pass waits for those in Pass::after.
/// Rings     A ring waits for the rings inside it, or for the ring around it (see LayerPasses::outside_in).
/// Depth     A pass waits for passes of higher layers if the pass, its entry or its lead may touch their material.
class Work {
 public:
  Work(const std::vector<LayerPasses>& layers, double tool_radius);

  const std::vector<WorkItem>& items() const { return items_; }
  const LayerWork& layer_of(std::size_t item) const { return layers_[items_[item].layer]; }
  const LayerWork& layer(std::size_t index) const { return layers_[index]; }
  std::size_t layer_count() const { return layers_.size(); }
  const Pass& pass(std::size_t item) const { return layer_of(item).layer().passes[items_[item].pass]; }
  const std::vector<std::size_t>& before(std::size_t item) const { return before_[item]; }
  const std::vector<std::size_t>& after(std::size_t item) const { return after_[item]; }
  double tool_radius() const { return tool_radius_; }

  /// Whether precedence allows only one order, the order of the items.
  bool has_one_order() const;
  /// Whether there are few enough passes to compare those of different layers. If not, precedence between
  /// layers is unknown, and layers have to be cut one after the other.
  bool layers_may_mix() const { return layers_may_mix_; }

 private:
  void add(std::size_t before, std::size_t after);
  void add_layer(std::size_t first);
  void add_depths();
  int part_of_start(std::size_t layer, std::size_t item);
  bool is_above(std::size_t high, std::size_t low);

  double tool_radius_;
  std::vector<LayerWork> layers_;
  std::vector<WorkItem> items_;
  std::vector<std::vector<std::size_t>> before_;
  std::vector<std::vector<std::size_t>> after_;
  std::map<std::pair<std::size_t, std::size_t>, int> part_of_start_;  ///< kept by part_of_start()
  bool layers_may_mix_ = true;
};

/// The passes already cut, and the ones permitted next.
class Progress {
 public:
  enum class Layers { kOneByOne, kMixed };
  Progress(const Work& work, Layers layers);

  bool available(std::size_t item) const;
  bool done(std::size_t item) const { return done_[item]; }
  bool finished() const { return left_ == 0; }
  void mark_done(std::size_t item);

  /// Whether a cutter with its centre in the box `travel` in `layer` meets no material of higher layers.
  bool clear_above(std::size_t layer, const Box& travel) const;

 private:
  const Work& work_;
  Layers layers_;
  std::vector<bool> done_;
  std::vector<std::size_t> waiting_for_;
  std::size_t left_;
  std::size_t first_undone_ = 0;  ///< all items before it are done
};

}  // namespace clearcut::link
