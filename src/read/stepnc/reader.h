// The mapping of a STEP-NC program to a part, step by step; read_stepnc() is its face.
#pragma once

#include <limits>
#include <map>
#include <set>

#include "base/error.h"
#include "read/stepnc/file/entity_list.h"
#include "read/stepnc/operation.h"
#include "read/stepnc/setup.h"
#include "read/stepnc/shapes/regions.h"

namespace clearcut::read::stepnc {

inline constexpr double kEverywhere = std::numeric_limits<double>::infinity();
inline constexpr double kLevel = 0.01;  ///< mm; heights nearer than this are one

/// A closed line at the top of a wall.
struct WallEdge {
  Loop line;
  double top = 0;
  bool air_inside = true;
  Radians wall_slope;
};

/// Reads one file once. Features are drafted, made, worked on by workingsteps in their order, and checked for what they ask for; at last
/// whatever nobody used is named.
class Reader {
 public:
  Reader(const P21File& file, const Tolerances& tol, const FileUnits& units)
      : context_(file, tol, is_degrees(units)) {}

  Diagnostics& diagnostics() { return context_.diagnostics; }
  const Program& program() const { return program_; }

  /// `number`: of the set-up; 0 for all steps as if they were one.
  Part read(int number);

 private:
  static bool is_degrees(const FileUnits& units) {
    return units.radians_per_angle && std::abs(*units.radians_per_angle - kPi / 180) < 1e-6;
  }
  void tell_context();
  void doubt_several_setups(int number);
  Node start_of_program() const;
  void draft_features();
  void draft_members(const Node& feature, const std::vector<Member>& members);
  std::size_t draft_index(const Member& member);
  Draft laid_on_blank(Draft draft) const;
  void choose_depth_reading();
  void derive_stock();
  void check_clearance();
  void make_features();
  void make_feature(std::size_t draft);
  std::vector<Draft> unmachined(const Node& owner);
  std::vector<WallEdge> edges_of(const Node& owner);
  std::vector<double> floors_of(const Node& owner);
  std::vector<WallEdge> edges_between(const Node& walls, const Node& face);
  void make_chamfer(std::size_t draft);
  int make_groove(std::size_t draft);
  int undercut_of(std::size_t draft, const Node& step);
  void check_disc(std::size_t draft, const Tool& tool, const Node& step) const;
  int groove_of(std::size_t draft, const StatedOperation& stated);
  bool is_groove_alone(std::size_t draft) const;
  void check_form_cutter(std::size_t draft, const StatedOperation& stated, const Node& step) const;
  void check_rounded_bottoms();
  void check_undercuts();
  std::map<std::uint64_t, StatedUse> tool_uses() const;
  std::vector<double> zone_floors(const Draft& draft, double top, double floor);
  std::vector<FeatureRegions> zone_regions(const Draft& draft, double top, const std::vector<double>& floors);
  double boss_top(const Draft& draft, std::size_t boss) const {
    return (absolute_depths_ ? 0.0 : draft.placement_z) + draft.boss_tops[boss];
  }
  void report_left_out(const std::vector<std::size_t>& drafts);
  void make_workingsteps(const Tools& tools);
  void tell_stops_after_the_last(const std::vector<ProgramStop>& stops);
  void make_workingstep(const Node& step, const Tools& tools);
  std::optional<StatedPath> stated_path(const Node& feature, const Node& node, const Operation& operation,
                                        const std::vector<std::size_t>& drafts);
  std::vector<std::size_t> sound_drafts(const Node& feature) const;
  void check_part(std::size_t draft, const Node& step, const StatedOperation& stated) const;
  void use_overcut(const Node& operation, const std::vector<std::size_t>& drafts);
  std::vector<int> features_for(std::size_t draft, const StatedOperation& stated, const Node& node);
  int hole_for(std::size_t draft, const StatedOperation& stated, const Node& node);
  std::size_t operations_on(const Node& feature) const;
  int spot_for(const Draft& draft, const Feature& hole, const StatedOperation& stated, const Node& node);
  void check_core(const Feature& like, const Thread& thread, double full_z, const Node& node) const;
  int thread_for(std::size_t draft, const StatedOperation& stated, const Node& node);
  int countersink_for(const Draft& draft, const Feature& hole, const StatedOperation& stated,
                      const Node& node);
  int add_hole(const Feature& like, const Draft& draft, const std::string& name, double width, double floor);
  void check_previous(std::size_t draft, const StatedOperation& stated, const Node& node);
  void check_holes();
  void check_through_ends();
  void check_members();
  void check_hole_end(const Draft& draft, const std::vector<std::size_t>& steps);
  void check_fillets();
  bool fillets_are_in_plan() const;
  void check_fillet(std::size_t index, const std::vector<std::size_t>& steps);
  void drop_unused_features();
  void set_tops(int setup);
  void set_tops_on_carried_stock();
  void drop_finished_steps();
  double floor_of(const Draft& draft) const;
  double regions_top_ = 0;  // z of the top of the zone before, while zones are made
  std::string unique_name(const Draft& draft);
  std::string unique_name(const std::string& base);
  void tell_what_is_read();
  void tell_of_entries();
  void take_material();
  void leave_out(const Node& step, const InputError& error);
  std::string within_file(const InputError& error) const;  ///< its text, for messages that name the file
  Feature& feature_of(const Workingstep& step) {
    return part_.features[static_cast<std::size_t>(step.feature)];
  }
  /// The lowest zone of a draft; most have no other.
  Feature& feature_of_draft(std::size_t draft) {
    return part_.features[static_cast<std::size_t>(features_of_draft_[draft].back())];
  }
  double top_of_draft(std::size_t draft) const {
    return part_.features[static_cast<std::size_t>(features_of_draft_[draft].front())].top_z;
  }
  const Tool& tool_of_step(std::size_t step) const {
    return part_.tools[static_cast<std::size_t>(part_.workplan[step].operation.tool)];
  }

  Context context_;
  Program program_;
  Part part_;
  std::vector<Draft> drafts_;  // of simple features, in order of first use
  /// Feature entity -> drafts_: one, or the members of a pattern or compound.
  std::map<std::uint64_t, std::vector<std::size_t>> drafts_of_;
  std::multimap<std::uint64_t, std::size_t> drafts_by_entity_;  // simple feature entity -> drafts_
  std::map<std::uint64_t, InputError> bad_features_;
  std::map<std::size_t, InputError> bad_drafts_;
  /// -> Part::features, none where it failed; several where bosses end below the top: the zones above them first.
  std::vector<std::vector<int>> features_of_draft_;
  std::map<std::size_t, std::vector<std::size_t>> steps_of_draft_;  // -> Part::workplan
  std::set<std::string> names_;
  std::map<std::string, int> copies_;     // of a name after the first
  std::map<std::size_t, int> undercuts_;  // of drafts_ -> Part::features
  std::map<std::size_t, int> grooves_;    // of drafts_ -> Part::features
  std::set<std::uint64_t> left_out_;      // features whose workingsteps were left out
  bool absolute_depths_ = false;
  bool fillets_in_plan_ = false;
  bool has_own_holes_ = false;  ///< features that operations on holes have added
  std::optional<InputError> first_error_;
};

}  // namespace clearcut::read::stepnc
