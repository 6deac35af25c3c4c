// Cuts treated as made before.
#pragma once

#include <utility>

#include "model/move.h"

namespace clearcut::pipeline {

/// Collects moves; moves that do not follow each other start new sections.
class Sweeps {
 public:
  /// `like`: section with the tool and the data of earlier cuts.
  void add(const Section& like, const Move& move);
  void append(Toolpath other);
  Toolpath take() { return std::move(out_); }

 private:
  Toolpath out_;
};

}  // namespace clearcut::pipeline
