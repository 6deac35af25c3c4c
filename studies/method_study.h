// All contour methods on many random pockets, checked alike: which are clean, which are fast, why the published ones
// fail.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "report/words/text_table.h"
#include "resolve/values/plan_options.h"

namespace clearcut::studies {

/// What one method did on one pocket.
struct MethodOutcome {
  bool planned = false;
  bool clean = false;
  double time_s = 0;  ///< kinematic
  double feed_mm = 0;
  std::string cause;  ///< of what a published rule left, by plan/contour/ring_band.h; "" where it is clean
};

struct StudyCase {
  std::uint64_t seed = 0;
  Part part;
  std::map<std::string, MethodOutcome> outcomes;  ///< by strategy
  /// The fastest clean method other than ours, where it is faster than ours by more than kSlower.
  std::optional<std::string> faster;
};

/// Share of the time by which ours may be longer and still count as equal: the rounding of printed programs.
inline constexpr double kSlower = 0.001;

struct MethodStudy {
  std::vector<StudyCase> cases;
};

/// Plans and certifies `count` random pockets from `first_seed` on by every contour method. `done` is called after
/// each. Cost about half a second a pocket.
MethodStudy study_methods(int count, std::uint64_t first_seed, const PlanOptions& options,
                          const std::function<void(const StudyCase&)>& done);

/// One row a method: how often clean, time against ours (median over pockets where both are clean), how often faster than
/// ours, and the causes of what it left.
TextTable study_table(const MethodStudy& study);

}  // namespace clearcut::studies
