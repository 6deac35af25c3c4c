// Holes other than plain drilled ones: the request and the required finished shape.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/vec2.h"

namespace clearcut::inline model {

enum class HoleKind {
  kDrilled,
  kSpotted,  ///< a conical spot that guides the drill
  kReamed,
  kBored,         ///< bored by a boring bar of the hole's size; by a mill if there is no such bar
  kCounterbored,  ///< a flat seat about a narrower hole
  kCountersunk,   ///< a cone about a narrower hole
  kTapped,
  kThreadMilled
};
/// "drill", "spot", "ream", "bore", "counterbore", "countersink", "tap", "thread".
const char* name_of(HoleKind kind);

/// A thread of 60 degrees, internal or external: ISO metric or unified. mm.
struct Thread {
  std::string name;     ///< "M6", "M20x1.5", "UNC1/4"
  double diameter = 0;  ///< major
  double pitch = 0;
  bool left_hand = false;
};

/// "M6" (coarse), "M6x0.75", "UNC1/4", "UNF1-4" (for 1/4), "UNC#10", "1/4-20", "#10-24", in any case; "LH" at the
/// end: left hand. Nothing for other texts and for sizes the tables have not.
std::optional<Thread> thread_named(std::string_view text);

/// mm; least diameter of the hole before threading: D1 = d - 1.0825 P.
double minor_diameter(const Thread& thread);
/// mm; allowed excess over minor_diameter(): tolerance 6H of ISO 965-1; 2B of unified threads is nearly equal.
double minor_tolerance(const Thread& thread);

/// mm; at the root of the external thread: d3 = d - 1.2269 P.
double root_diameter(const Thread& thread);
/// mm; permitted undersize of the boss of an external thread: its tolerance 6g of ISO 965-1.
double crest_tolerance(const Thread& thread);
/// mm; distance from the root of an external thread at which a thread mill descends.
double approach_beside(const Thread& thread);

/// Request of a layer or an option for its circles.
struct HoleRequest {
  HoleKind kind = HoleKind::kDrilled;
  std::optional<Thread> thread;
  std::optional<double> diameter;  ///< finished, instead of the circle's; units of the drawing
  bool through = false;
  bool chip_break = false;     ///< pecks only break the chip instead of clearing the hole
  std::optional<double> peck;  ///< units of the drawing
  bool external = false;       ///< threads: about a boss
};

/// Required shape of one hole; its feature's floor_z is the lowest height of the tool's end. mm.
struct HoleForm {
  HoleKind kind = HoleKind::kDrilled;
  Vec2 center;
  double diameter = 0;  ///< finished diameter; for countersinks at the top, for threads the major one
  double full_z = 0;    ///< down to this height the hole has its full diameter, or its thread
  std::optional<Thread> thread;
  bool chip_break = false;
  std::optional<double> peck;
  bool external = false;  ///< a thread around a boss: the material beside the boss is cleared first
};

}  // namespace clearcut::inline model
