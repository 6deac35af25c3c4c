// The finished part in the forms that cutters are checked against.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "model/part.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {

/// The part as it has to come out, the same with external threads as their own mills may cut them, and parts in which of the
/// features with draft only one is cut. May be asked by several threads at once.
class FinishedParts {
 public:
  /// Keeps a reference to `part`, which must outlive it.
  explicit FinishedParts(const Part& part);

  const FinishedPart& plain() const { return plain_; }
  const FinishedPart& for_tool(const Tool& tool) const {
    return threaded_ && tool.kind == ToolKind::kThreadMill ? *threaded_ : plain_;
  }
  /// The features with draft that hold p.
  std::vector<int> drafted_at(Vec2 p) const;
  /// The part in which no feature with draft is cut but this one: its solid holds that of the whole part. Made when first asked for.
  const FinishedPart& with_one_draft(int feature) const;

 private:
  const Part& part_;
  FinishedPart plain_;
  std::optional<FinishedPart> threaded_;
  std::vector<int> drafted_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<FinishedPart>> with_one_;  ///< by feature
};

}  // namespace clearcut::verify
