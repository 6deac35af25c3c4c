#include <algorithm>
#include <map>
#include <utility>

#include "plan/carve/carve.h"

namespace clearcut::plan::carve {
namespace {

using Key = std::pair<double, double>;

Key key_of(const AxisPoint& p) {
  return {p.point.x, p.point.y};
}

/// Joins chains with common end points, each used once.
class Walker {
 public:
  explicit Walker(std::vector<Chain> chains) : chains_(std::move(chains)), used_(chains_.size(), 0) {
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      if (chains_[i].size() < 2) continue;
      at_[key_of(chains_[i].front())].push_back(i);
      at_[key_of(chains_[i].back())].push_back(i);
    }
  }

  std::vector<Chain> walk() {
    std::vector<Chain> out;
    // Begins at points of an odd number of chains, because this gives fewer pieces.
    for (const bool loose : {true, false}) {
      for (std::size_t i = 0; i < chains_.size(); ++i) {
        if (used_[i]) continue;
        const bool begins = chains_[i].size() < 2 || degree(chains_[i].front()) % 2 == 1;
        const bool ends = chains_[i].size() > 1 && degree(chains_[i].back()) % 2 == 1;
        if (loose && !begins && !ends) continue;
        out.push_back(walk_from(i, loose && !begins));
      }
    }
    return out;
  }

 private:
  std::size_t degree(const AxisPoint& p) const {
    const auto found = at_.find(key_of(p));
    if (found == at_.end()) return 1;
    return static_cast<std::size_t>(
        std::count_if(found->second.begin(), found->second.end(), [&](std::size_t i) { return !used_[i]; }));
  }

  Chain take(std::size_t i, bool backwards) {
    used_[i] = 1;
    Chain chain = std::move(chains_[i]);
    if (backwards) std::reverse(chain.begin(), chain.end());
    return chain;
  }

  Chain walk_from(std::size_t first, bool backwards) {
    Chain walk = take(first, backwards);
    while (walk.size() > 1) {
      const Key here = key_of(walk.back());
      const auto& near = at_[here];
      const auto next = std::find_if(near.begin(), near.end(), [&](std::size_t i) { return !used_[i]; });
      if (next == near.end()) break;
      const Chain more = take(*next, key_of(chains_[*next].front()) != here);
      walk.insert(walk.end(), more.begin() + 1, more.end());
    }
    return walk;
  }

  std::vector<Chain> chains_;
  std::vector<char> used_;
  std::map<Key, std::vector<std::size_t>> at_;
};

/// The point between a and b with the clearance `clearance` mm.
AxisPoint crossing(const AxisPoint& a, const AxisPoint& b, double clearance) {
  AxisPoint p = part_way(a, b, (clearance - a.clearance) / (b.clearance - a.clearance));
  p.clearance = clearance;
  return p;
}

bool passes(const AxisPoint& a, const AxisPoint& b, double clearance) {
  return (a.clearance - clearance) * (b.clearance - clearance) < 0;
}

}  // namespace

AxisPoint part_way(const AxisPoint& a, const AxisPoint& b, double t) {
  if (t <= 0) return a;
  if (t >= 1) return b;
  return {lerp(a.point, b.point, t), a.clearance + (b.clearance - a.clearance) * t};
}

Chain with_points_at(const Chain& chain, double clearance) {
  Chain out;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (i > 0 && passes(chain[i - 1], chain[i], clearance))
      out.push_back(crossing(chain[i - 1], chain[i], clearance));
    out.push_back(chain[i]);
  }
  return out;
}

std::vector<Chain> between(const Chain& chain, double low, double high) {
  const Chain cut = with_points_at(with_points_at(chain, low), high);
  const auto inside = [&](const AxisPoint& p) { return p.clearance >= low && p.clearance <= high; };
  std::vector<Chain> parts;
  if (cut.size() == 1 && inside(cut.front())) parts.push_back(cut);
  Chain part;
  for (std::size_t i = 0; i + 1 < cut.size(); ++i) {
    if (!inside(cut[i]) || !inside(cut[i + 1])) {
      if (part.size() > 1) parts.push_back(std::move(part));
      part = {};
      continue;
    }
    if (part.empty()) part.push_back(cut[i]);
    part.push_back(cut[i + 1]);
  }
  if (part.size() > 1) parts.push_back(std::move(part));
  return parts;
}

std::vector<Chain> joined(std::vector<Chain> chains) {
  return Walker(std::move(chains)).walk();
}

}  // namespace clearcut::plan::carve
