#include "order/genetic/selection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "order/genetic/operator_context.h"

namespace clearcut::order {

namespace {

int below(int count, Random& random) {
  return static_cast<int>(random.below(static_cast<std::uint64_t>(count)));
}

class RandomSelection final : public Selection {
 public:
  int pick(std::span<const double> ranked, Random& random) const override {
    return below(static_cast<int>(ranked.size()), random);
  }
};

class RankSelection final : public Selection {
 public:
  int pick(std::span<const double> ranked, Random& random) const override {
    const int n = static_cast<int>(ranked.size());
    int ticket = below(n * (n + 1) / 2, random);
    int rank = 0;
    while (ticket >= n - rank) ticket -= n - rank++;
    return rank;
  }
};

class Roulette final : public Selection {
 public:
  int pick(std::span<const double> ranked, Random& random) const override {
    double total = 0;
    for (const double value : ranked) total += fitness(value, ranked.front());
    double ticket = random.unit() * total;
    for (std::size_t i = 0; i < ranked.size(); ++i) {
      ticket -= fitness(ranked[i], ranked.front());
      if (ticket < 0) return static_cast<int>(i);
    }
    return static_cast<int>(ranked.size()) - 1;
  }

 private:
  /// 1 / value has no meaning at 0 and below: there the best individual counts as value 1.
  static double fitness(double value, double best) { return 1 / (best > 0 ? value : value - best + 1); }
};

class Tournament final : public Selection {
 public:
  explicit Tournament(int size) : size_(std::max(1, size)) {}
  int pick(std::span<const double> ranked, Random& random) const override {
    int best = static_cast<int>(ranked.size()) - 1;
    for (int i = 0; i < size_; ++i) best = std::min(best, below(static_cast<int>(ranked.size()), random));
    return best;
  }

 private:
  int size_;
};

class Truncation final : public Selection {
 public:
  explicit Truncation(double share) : share_(share) {}
  int pick(std::span<const double> ranked, Random& random) const override {
    const int n = static_cast<int>(ranked.size());
    return below(std::clamp(static_cast<int>(std::lround(share_ * n)), 1, n), random);
  }

 private:
  double share_;
};

const NamedMakers<std::unique_ptr<Selection> (*)()>& selection_makers() {
  static const NamedMakers<std::unique_ptr<Selection> (*)()> all{
      "selection",
      {{"random", random_selection},
       {"rank", rank_selection},
       {"roulette", roulette_selection},
       {"tournament", [] { return tournament_selection(); }},
       {"truncation", [] { return truncation_selection(); }}}};
  return all;
}

}  // namespace

std::unique_ptr<Selection> random_selection() {
  return std::make_unique<RandomSelection>();
}
std::unique_ptr<Selection> rank_selection() {
  return std::make_unique<RankSelection>();
}
std::unique_ptr<Selection> roulette_selection() {
  return std::make_unique<Roulette>();
}
std::unique_ptr<Selection> tournament_selection(int size) {
  return std::make_unique<Tournament>(size);
}
std::unique_ptr<Selection> truncation_selection(double share) {
  return std::make_unique<Truncation>(share);
}

const std::vector<std::string>& selection_names() {
  static const std::vector<std::string> names = selection_makers().names();
  return names;
}

std::unique_ptr<Selection> selection_named(const std::string& name) {
  return selection_makers().at(name)();
}

namespace {

bool same_value(double a, double b) {
  return std::abs(a - b) <= kSameValue * std::abs(b);
}

/// Whether the pool has exactly these genes already.
bool has_copy(const Pool& pool, const Individual& child) {
  for (int i = 0; i < pool.size(); ++i) {
    const Individual& other = pool.at(i);
    if (same_value(other.value, child.value) && other.genome.genes() == child.genome.genes()) return true;
  }
  return false;
}

class Distinct final : public Replacement {
 public:
  bool wants(const Pool& pool, double value, int /*first_parent*/) const override {
    return value < pool.worst().value || same_value(value, pool.worst().value);
  }
  void offer(Pool& pool, Individual& child, int /*first_parent*/) override {
    if (wants(pool, child.value, 0) && !has_copy(pool, child))
      pool.replace(pool.at_rank(pool.size() - 1), child);
  }
};

class Worst final : public Replacement {
 public:
  bool wants(const Pool& pool, double value, int /*first_parent*/) const override {
    return value < pool.worst().value;
  }
  void offer(Pool& pool, Individual& child, int /*first_parent*/) override {
    if (wants(pool, child.value, 0)) pool.replace(pool.at_rank(pool.size() - 1), child);
  }
};

class Parent final : public Replacement {
 public:
  bool wants(const Pool& pool, double value, int first_parent) const override {
    const double parent = pool.at(first_parent).value;
    return value < parent || same_value(value, parent);
  }
  void offer(Pool& pool, Individual& child, int first_parent) override {
    if (wants(pool, child.value, first_parent)) pool.replace(first_parent, child);
  }
};

class WholeGeneration final : public Replacement {
 public:
  bool wants(const Pool& /*pool*/, double /*value*/, int /*first_parent*/) const override { return true; }
  void offer(Pool& /*pool*/, Individual& child, int /*first_parent*/) override { children_.push_back(child); }
  void end_generation(Pool& pool) override {
    std::stable_sort(children_.begin(), children_.end(),
                     [](const Individual& a, const Individual& b) { return a.value < b.value; });
    std::vector<int> leaving;
    for (int rank = pool.size() - 1; rank > 0; --rank) leaving.push_back(pool.at_rank(rank));
    for (std::size_t i = 0; i < std::min(leaving.size(), children_.size()); ++i)
      pool.replace(leaving[i], children_[i]);
    children_.clear();
  }

 private:
  std::vector<Individual> children_;
};

const NamedMakers<std::unique_ptr<Replacement> (*)()>& replacement_makers() {
  static const NamedMakers<std::unique_ptr<Replacement> (*)()> all{"replacement",
                                                                   {{"distinct", replace_distinct},
                                                                    {"worst", replace_worst},
                                                                    {"parent", replace_parent},
                                                                    {"generation", replace_generation}}};
  return all;
}

}  // namespace

std::unique_ptr<Replacement> replace_worst() {
  return std::make_unique<Worst>();
}
std::unique_ptr<Replacement> replace_distinct() {
  return std::make_unique<Distinct>();
}
std::unique_ptr<Replacement> replace_parent() {
  return std::make_unique<Parent>();
}
std::unique_ptr<Replacement> replace_generation() {
  return std::make_unique<WholeGeneration>();
}

const std::vector<std::string>& replacement_names() {
  static const std::vector<std::string> names = replacement_makers().names();
  return names;
}

std::unique_ptr<Replacement> replacement_named(const std::string& name) {
  return replacement_makers().at(name)();
}

}  // namespace clearcut::order
