#include "order/genetic/replacement.h"

#include <algorithm>
#include <cmath>

#include "order/genetic/names.h"

namespace clearcut::order {

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
