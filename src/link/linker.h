// Cuts passes in a given order, or always next the pass reached soonest, or in a quicker order found from it, and
// writes the moves with their links.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "link/access_paths.h"
#include "link/entry.h"
#include "link/lead.h"
#include "link/link.h"
#include "link/moves.h"
#include "link/work.h"

namespace clearcut::link {

/// A pass to be cut next. It begins at `start` or, if absent, at its place nearest to the cutter.
struct Task {
  std::size_t item = 0;
  std::optional<PassStart> start;
};

/// A finished pass, with the start and end of its moves.
struct Cut {
  std::size_t item = 0;
  PassStart start;
  Vec2 begin;
  Vec2 end;
  bool stayed_down = false;  ///< whether the link to it stayed at depth
};

/// Position of the cutter, mm.
struct CutterAt {
  Vec2 at;
  double z = 0;
};

/// A possible start of a pass.
struct Beginning {
  std::size_t item = 0;
  Vec2 point;
  double rapid_z = 0;  ///< mm; height at which a rapid down to this place ends
};

/// Writes the moves of one section, pass by pass.
class Linker {
 public:
  Linker(const Work& work, const LinkOptions& options, Progress::Layers layers)
      : work_(work), options_(options), progress_(work, layers), cleared_(work, options) {}

  /// Cuts all passes, always next the pass reached soonest.
  void cut_nearest_first();
  /// Cuts all passes in this order, the order must respect their precedence.
  void cut_in_order(const std::vector<Task>& tasks);

  /// Seconds from `from` to the beginning of a pass, as far as known before cutting begins. `low`:
  /// the link may stay at depth or just above the layer if that is legal.
  double travel(const CutterAt& from, const Beginning& to, bool low) const;
  Beginning beginning(std::size_t item, Vec2 point) const { return {item, point, approach_z(point, item)}; }

  const std::vector<Cut>& cuts() const { return cuts_; }
  /// Sentences on requests that did not fit.
  std::vector<std::string> notes() const;
  /// All moves; ends at the safe height.
  std::vector<Move> take_moves();

 private:
  struct Candidate {
    std::size_t item = std::numeric_limits<std::size_t>::max();
    PassStart start;
    bool stay_down = false;
    double cost = std::numeric_limits<double>::infinity();
  };

  bool running() const { return !moves_.empty(); }
  const LayerWork& layer(std::size_t item) const { return work_.layer_of(item); }
  AccessPaths access_paths() const { return {work_, options_, progress_, cleared_}; }
  CutterAt here() const { return {moves_.at(), moves_.z()}; }

  Candidate choose() const;
  Candidate first_candidate() const;
  Candidate evaluate(std::size_t item, const PassStart& start) const;
  double retract_time(const CutterAt& from, const Beginning& to, double height) const;
  double straight_time(const CutterAt& from, const Beginning& to) const;
  double least_cost(std::size_t item, const PassStart& start) const;
  double retract_height(const CutterAt& from, Vec2 to, std::size_t item) const;
  double approach_z(Vec2 p, std::size_t item) const;

  void cut_pass(Candidate next);
  std::optional<Lead> lead_for_pass(const Path& path, const Candidate& next);
  bool plunges_into_material(const Lead& lead, const Candidate& next) const;
  void start_from_air(Candidate& next) const;
  double go_to(const Candidate& next, const Path& path, bool is_ring);
  std::optional<Path> access_to(Vec2 p, std::size_t item) const;
  bool stands_before(Vec2 p, std::size_t item) const;
  bool is_cleared_by_earlier_steps(Vec2 p, std::size_t item) const;
  void link_to(Vec2 p);
  void go_over(Vec2 p, std::size_t item);
  Entry entry_into(const EntryPlace& place, std::size_t item) const;
  EntryPlace entry_place(Vec2 start, const Path& path, const Path* ring, std::size_t item) const;
  double enter_material(Vec2 start, const Path& path, const Path* ring, std::size_t item);
  void rise_and_cross(Vec2 to, double height);
  Path oriented(const Candidate& next) const;
  void cut(const Path& path, const std::vector<MoveKind>& kinds);

  const Work& work_;
  const LinkOptions& options_;
  Progress progress_;
  Cleared cleared_;
  MoveList moves_{{}, 0};
  std::vector<Cut> cuts_;
  std::array<int, 4> entries_{};  ///< number of entries into material, by kind
  int without_lead_ = 0;
};

/// Groups of passes kept together while orders are compared.
enum class Together {
  kAreas,  ///< passes cut one after the other in the same area, through all layers
  kRuns    ///< passes that follow each other with links at depth
};

/// The passes in an order with a shorter estimated time of links; found from the order in which `linker` has cut them
/// all. Precedence is respected; a ring without neighbours may begin elsewhere. Empty if there is nothing to choose.
/// Cost: see order/search/visit_order.h.
std::vector<Task> short_order(const Work& work, const Linker& linker, Together together);

}  // namespace clearcut::link
