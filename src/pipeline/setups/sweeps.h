// Cuts that count as made before.
#pragma once

#include <utility>

#include "model/move.h"

namespace clearcut::pipeline {

/// Collects moves; those that do not follow each other are sections of their own.
class Sweeps {
 public:
  /// `like`: whose tool it is, and what is said of cuts made before.
  void add(const Section& like, const Move& move);
  void append(Toolpath other);
  Toolpath take() { return std::move(out_); }

 private:
  Toolpath out_;
};

}  // namespace clearcut::pipeline
