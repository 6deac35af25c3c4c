// The passes of all layers of one feature as pieces of work, and what has to come before what.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"
#include "geometry/route/legal_route.h"
#include "model/pass.h"

namespace clearcut::link {

/// One layer: its passes, and where the cutter may be.
class LayerWork {
 public:
  LayerWork(const LayerPasses& layer, double tool_radius);

  const LayerPasses& layer() const { return *layer_; }
  const LegalArea& legal() const { return legal_; }
  /// Paths round corners; made for the first that asks. Not to be moved from then on.
  const LegalRoutes& routes() const;
  /// All places at which the cutter touches what is to be removed; beside them everything is cleared already. Made for the
  /// first that asks.
  const Regions& touching() const;
  /// Whether the cutter may leave the material sideways.
  bool open() const { return open_; }
  /// Outer rings of open layers are cut from the air inwards, so they run the other way round.
  bool turned_round(std::size_t pass) const;
  /// Of a pass and the one around it: which of the two has to wait; -1 without one around it.
  int later_of_tree_edge(std::size_t pass) const;
  /// The connected part of the legal area around p; -1 where it is in none.
  int part_around(Vec2 p) const;
  std::size_t parts() const { return layer_->legal.size(); }

 private:
  const LayerPasses* layer_;
  LegalArea legal_;
  double tool_radius_;
  mutable std::unique_ptr<LegalRoutes> routes_;
  mutable std::optional<Regions> touching_;
  bool open_ = false;
};

/// A pass of a layer.
struct WorkItem {
  std::size_t layer = 0;
  std::size_t pass = 0;
  Box path;   ///< of the centre
  Box swept;  ///< of the cutter
};

/// All passes, layer by layer, with their precedence.
///
/// Rings     wait for those they surround, or the other way round (see LayerPasses::outside_in).
/// Depth     a pass waits for those of higher layers on whose material it, its entry or its lead may come.
class Work {
 public:
  Work(const std::vector<LayerPasses>& layers, double tool_radius);

  const std::vector<WorkItem>& items() const { return items_; }
  const LayerWork& layer_of(std::size_t item) const { return layers_[items_[item].layer]; }
  const LayerWork& layer(std::size_t index) const { return layers_[index]; }
  const Pass& pass(std::size_t item) const { return layer_of(item).layer().passes[items_[item].pass]; }
  const std::vector<std::size_t>& before(std::size_t item) const { return before_[item]; }
  const std::vector<std::size_t>& after(std::size_t item) const { return after_[item]; }
  double tool_radius() const { return tool_radius_; }

  /// Whether precedence leaves one order alone, the one of the items.
  bool has_one_order() const;
  /// Whether so many passes can be looked at together; otherwise precedence between layers is not known, and
  /// layers have to be cut one after the other.
  bool layers_may_mix() const { return layers_may_mix_; }

 private:
  void add(std::size_t before, std::size_t after);
  void add_rings(std::size_t first);
  void add_depths();
  bool is_above(std::size_t high, std::size_t low) const;

  double tool_radius_;
  std::vector<LayerWork> layers_;
  std::vector<WorkItem> items_;
  std::vector<std::vector<std::size_t>> before_;
  std::vector<std::vector<std::size_t>> after_;
  bool layers_may_mix_ = true;
};

/// What is cut already, and what may be next.
class Progress {
 public:
  enum class Layers { kOneByOne, kMixed };
  Progress(const Work& work, Layers layers);

  bool available(std::size_t item) const;
  bool done(std::size_t item) const { return done_[item]; }
  bool finished() const { return left_ == 0; }
  void mark_done(std::size_t item);

  /// Whether nothing of higher layers stands where the cutter's centre goes through the box `travel` in `layer`.
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
