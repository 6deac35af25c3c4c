// A feature as its entities describe it, in workpiece coordinates, before the stock and the depth reading are
// known.
#pragma once

#include "model/part.h"
#include "read/stepnc/shapes/members.h"
#include "read/stepnc/shapes/profile.h"

namespace clearcut::read::stepnc {

enum class SlotEnd { kOpen, kRound, kFlat };

enum class HoleBottom { kFlat, kThrough, kCone, kBall, kFlatWithRadius };

/// A length and how far it may be off, mm.
struct Toleranced {
  double size = 0;
  double below = 0;
  double above = 0;
};

/// What a shaped cutter makes along the course of a slot by its own form.
struct Groove {
  std::optional<Radians> sides;  ///< of a vee, between its sides; absent: half round, as wide as the slot
};

/// The undercut of a slot, by a disc. mm.
struct Undercut {
  double width = 0;
  double height = 0;
};

/// The edge between two features that is to be broken.
struct BrokenEdge {
  Node first;  ///< the angle is against its face, and the offset lies on it
  Node second;
  Radians angle;      ///< between the first feature's face and the chamfer
  double offset = 0;  ///< mm on the first feature's face
};

/// What ends a round hole.
struct HoleEnd {
  HoleBottom bottom = HoleBottom::kFlat;
  double radius = 0;             ///< of balls and of the corner of flat ends, mm
  std::optional<Radians> angle;  ///< of cones, between opposite flanks
};

struct Draft {
  explicit Draft(const Node& feature) : node(feature) {}

  Node node;
  std::string name;
  Frame placement;  ///< in the workpiece
  FeatureKind kind = FeatureKind::kClosedPocket;

  double placement_z = 0;
  double depth_z = 0;  ///< of the depth plane, in the feature's frame, as written
  std::optional<double>
      below_blank;          ///< mm; of regions, whose floor lies that deep below the raw piece's top
  bool through = false;     ///< the bottom condition says so
  double raised_floor = 0;  ///< mm of the depth that are not prismatic, and stay
  Radians wall_slope;
  std::optional<double> hole_diameter;
  Toleranced hole;                         ///< of round holes: what their diameter may be
  HoleEnd hole_end;                        ///< of round holes
  std::optional<Thread> thread;            ///< of threads: their hole is made by other features
  std::optional<Toleranced> floor_fillet;  ///< between floor and walls

  Loop boundary;           ///< closed outline; empty where there is none
  Loop unplaced_boundary;  ///< the same without the profile's own placement; empty if that is none
  std::vector<Loop> bosses;
  std::vector<std::uint64_t> boss_ids;
  std::vector<double> boss_tops;  ///< of each of them: z of its top in the feature's frame, as written
  Path wall;                      ///< steps and open pockets: material on its left
  bool wall_is_step = false;
  Path course;                       ///< slots: middle line
  double width = 0;                  ///< slots; 0 for those of vees, whose depth says how wide they are
  std::optional<Groove> groove;      ///< slots
  std::optional<Undercut> undercut;  ///< slots
  std::optional<BrokenEdge> edge;    ///< chamfers, which have no place of their own
  SlotEnd ends[2] = {SlotEnd::kFlat, SlotEnd::kFlat};
  bool ends_given = false;
};

/// Reads a feature at its place. Throws InputError naming it for what is missing, tilted, or not machinable yet.
Draft draft_feature(const Member& member, Context& context);

}  // namespace clearcut::read::stepnc
