// For tests: parts as readers return them.
#pragma once

#include "geometry/region.h"
#include "read/job/read_part.h"

namespace clearcut::test_support {

inline ReadOptions depth_2() {
  ReadOptions options;
  options.depth = 2;
  return options;
}

inline double area_of(const Part& part) {
  double sum = 0;
  for (const Feature& feature : part.features) sum += area(feature.target);
  return sum;
}

}  // namespace clearcut::test_support
