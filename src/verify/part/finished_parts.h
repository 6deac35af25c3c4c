// The finished part in the forms used for checking cutters.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "model/part.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// The volume removed by the disc of a T-slot cutter, below remaining material.
struct Undercut {
  int feature = -1;
  EdgeTree outline;  ///< outline of the volume that may be removed
  /// Greatest z of a disc's upper side: the underside of the material above, plus an allowance for digits.
  double roof = 0;
};

/// The finished part; the same with external threads as cut by their own mills; the same without the material over
/// undercuts; and parts with only one of the features with draft cut. The plain part has no undercuts: its material
/// extends from its height down everywhere, as for every cutter except T-slot cutters. Safe to use from several
/// threads at once.
class FinishedParts {
 public:
  /// Keeps a reference to `part`, which must outlive it.
  explicit FinishedParts(const Part& part);

  const FinishedPart& plain() const { return plain_; }
  const FinishedPart& for_tool(const Tool& tool) const {
    return threaded_ && tool.kind == ToolKind::kThreadMill ? *threaded_ : plain_;
  }
  /// The part without the material over undercuts; the plain part if there are none.
  const FinishedPart& opened() const { return opened_.empty() ? plain_ : *opened_.begin()->second; }
  /// The same, except undercuts in which a disc must not reach up to z.
  const FinishedPart& opened_up_to(double z) const {
    const auto found = opened_.lower_bound(z);
    return found == opened_.end() ? plain_ : *found->second;
  }
  const FinishedPart& for_feature(const Feature& feature) const {
    return feature.kind == FeatureKind::kTSlot ? opened() : plain_;
  }
  const std::vector<Undercut>& undercuts() const { return undercuts_; }
  /// The features with draft around p.
  std::vector<int> drafted_at(Vec2 p) const;
  /// The part with only this one of the features with draft cut: its solid contains that of the whole part. Made at
  /// the first call.
  const FinishedPart& with_one_draft(int feature) const;

 private:
  const Part& part_;
  FinishedPart plain_;
  std::optional<FinishedPart> threaded_;
  /// Opened parts by the roof of the lowest cut undercut.
  std::map<double, std::unique_ptr<FinishedPart>> opened_;
  std::vector<Undercut> undercuts_;
  std::vector<int> drafted_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<FinishedPart>> with_one_;  ///< parts by feature
};

}  // namespace clearcut::verify
