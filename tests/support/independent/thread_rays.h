// What thread mills cut of a thread, seen along rays from its axis. Shares no code with the product.
#pragma once

#include <string>
#include <vector>

#include "support/independent/made_part.h"

namespace clearcut::test_support {

class ThreadRays {
 public:
  explicit ThreadRays(const MadeThread& thread);

  /// A way of a thread mill, at the feed or not: a crest that a rapid meets is gone as well.
  void cut(const MadeCutter& mill, const BodyWay& way);

  /// What is wrong with the thread; "" where nothing is.
  std::string wrong() const;

 private:
  /// A tooth's tip at this height and this distance from the thread's axis.
  struct Touch {
    double z = 0, radius = 0;
    double turns = 0;  ///< of its direction, counter-clockwise from x
  };
  void touch(const MadeCutter& mill, double x, double y, double z);
  double beyond_crest(const Touch& touch) const;
  double helix_turns(const Touch& touch) const;
  std::string off_helix() const;
  std::string not_cut(const std::vector<Touch>& ray) const;

  MadeThread thread_;
  std::vector<std::vector<Touch>> rays_;
};

}  // namespace clearcut::test_support
