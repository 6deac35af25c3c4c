// Reference load for a program's feeds.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "model/options/feed_rule.h"

namespace clearcut::verify {

/// mm/min; feed at the reference: stated by the rule, else for the tool, else the feed of the workingstep.
struct LoadReference {
  FeedRule rule;
  std::vector<MmPerMin> feed_of_step = {};
  std::map<int, MmPerMin> feed_of_tool = {};  ///< feed by number of the tool

  /// 0 if not stated. Moves without a workingstep are compared with the least of all feeds.
  double feed(int workingstep, int tool) const {
    if (rule.feed) return rule.feed->mm_per_min();
    if (const auto own = feed_of_tool.find(tool); own != feed_of_tool.end()) return own->second.mm_per_min();
    if (feed_of_step.empty()) return 0;
    const auto step = static_cast<std::size_t>(workingstep);
    if (workingstep >= 0 && step < feed_of_step.size()) return feed_of_step[step].mm_per_min();
    return std::min_element(feed_of_step.begin(), feed_of_step.end())->mm_per_min();
  }
  double cap(int workingstep, int tool) const {
    return rule.cap ? rule.cap->mm_per_min() : kUsualCap * feed(workingstep, tool);
  }

  /// Default cap as a multiple of the reference's feed.
  static constexpr double kUsualCap = 2;
};

}  // namespace clearcut::verify
