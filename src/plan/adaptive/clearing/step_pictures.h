// Draws what adaptive clearing has cut after each of its steps. docs/adaptive.md shows such pictures.
#pragma once

#include <cstddef>
#include <string_view>

#include "base/files/debug_sink.h"
#include "geometry/region.h"
#include "plan/adaptive/clearing/clearing_path.h"

namespace clearcut::plan::adaptive {

/// A picture of one legal area for each step. References are kept.
class StepPictures {
 public:
  /// Draws nothing if `sink` is null.
  StepPictures(DebugSink* sink, const Region& legal, const ClearingPath& path)
      : sink_(sink), legal_(legal), path_(path) {}

  /// To be called after a step: the legal area in black, the moves of earlier steps in grey, those of this step, links
  /// included, in blue. No picture if the step has cut nothing.
  void after(std::string_view step);

 private:
  void draw(const Edge& edge, std::string_view color);

  DebugSink* sink_;
  const Region& legal_;
  const ClearingPath& path_;
  std::size_t drawn_ = 0;  ///< number of moves at the last picture
};

}  // namespace clearcut::plan::adaptive
