// The finished part in the forms that cutters are checked against.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "model/part.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// What the disc of a T-slot cutter removes, under what stands.
struct Undercut {
  int feature = -1;
  EdgeTree outline;  ///< of what may be removed
  double roof =
      0;  ///< z that a disc may reach up to: the underside of what stands over it, and what digits need
};

/// The part as it has to come out, the same with external threads as their own mills may cut them, the same without what stands over
/// undercuts, and parts in which of the features with draft only one is cut. The plain part has no undercuts: its material reaches
/// from its height down everywhere, as for every cutter but their own. May be asked by several threads at once.
class FinishedParts {
 public:
  /// Keeps a reference to `part`, which must outlive it.
  explicit FinishedParts(const Part& part);

  const FinishedPart& plain() const { return plain_; }
  const FinishedPart& for_tool(const Tool& tool) const {
    return threaded_ && tool.kind == ToolKind::kThreadMill ? *threaded_ : plain_;
  }
  /// Without what stands over undercuts; the plain part where there are none.
  const FinishedPart& opened() const { return opened_.empty() ? plain_ : *opened_.begin()->second; }
  /// The same, but for undercuts in which a disc may not reach up to z.
  const FinishedPart& opened_up_to(double z) const {
    const auto found = opened_.lower_bound(z);
    return found == opened_.end() ? plain_ : *found->second;
  }
  const FinishedPart& for_feature(const Feature& feature) const {
    return feature.kind == FeatureKind::kTSlot ? opened() : plain_;
  }
  const std::vector<Undercut>& undercuts() const { return undercuts_; }
  /// The features with draft that hold p.
  std::vector<int> drafted_at(Vec2 p) const;
  /// The part in which no feature with draft is cut but this one: its solid holds that of the whole part. Made when first asked for.
  const FinishedPart& with_one_draft(int feature) const;

 private:
  const Part& part_;
  FinishedPart plain_;
  std::optional<FinishedPart> threaded_;
  std::map<double, std::unique_ptr<FinishedPart>>
      opened_;  ///< by the roof of the lowest undercut that is cut
  std::vector<Undercut> undercuts_;
  std::vector<int> drafted_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<FinishedPart>> with_one_;  ///< by feature
};

}  // namespace clearcut::verify
