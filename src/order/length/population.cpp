#include "order/length/population.h"

#include <algorithm>
#include <numeric>

#include "base/elementary.h"
#include "base/parallel.h"

namespace clearcut::order {

void EdgeCounts::add(const Links& tour) {
  for (int v = 0; v < static_cast<int>(tour.size()); ++v) {
    for (const int w : tour[v]) {
      if (v < w) change(v, w, 1);
    }
  }
}

int EdgeCounts::count(int a, int b) const {
  for (const Entry& entry : at_[std::min(a, b)]) {
    if (entry.other == std::max(a, b)) return entry.count;
  }
  return 0;
}

void EdgeCounts::change(int a, int b, int by) {
  auto& entries = at_[std::min(a, b)];
  const int other = std::max(a, b);
  for (Entry& entry : entries) {
    if (entry.other != other) continue;
    entry.count += by;
    if (entry.count == 0) {
      entry = entries.back();
      entries.pop_back();
    }
    return;
  }
  entries.push_back({other, by});
}

void EdgeCounts::apply(const std::vector<EdgeChange>& changes) {
  for (const EdgeChange& c : changes) {
    if (c.added) change(c.a, c.b, 1);
  }
  for (const EdgeChange& c : changes) {
    if (!c.added) change(c.a, c.b, -1);
  }
}

double EdgeCounts::entropy_change(const std::vector<EdgeChange>& changes, int population) const {
  const auto term = [population](int count) {
    return count <= 0 ? 0.0 : -count * base::log(static_cast<double>(count) / population);
  };
  double sum = 0;
  for (const EdgeChange& c : changes) {
    const int now = count(c.a, c.b);
    sum += term(now + (c.added ? 1 : -1)) - term(now);
  }
  return sum;
}

namespace {
/// Pairs bred from the same state of the population.
constexpr int kBatch = 8;
/// A stage ends after this many generations without a shorter best tour, or sooner without a shorter mean.
constexpr int kPatience = 50;
constexpr int kPatienceOfMean = 3;
}  // namespace

struct Population::Workspace {
  explicit Workspace(const LengthModel& model) : assembly(model), cycles(model.size()) {}
  Assembly assembly;
  AbCycles cycles;
  Child child;
  std::vector<int> order, chosen;
};

/// The child that replaces the parent; no changes: the parent is kept.
struct Population::Offspring {
  Child child;
  double worth = 0;
};

Population::Population(const LengthModel& model, std::vector<std::vector<int>> tours, Options options)
    : model_(model), counts_(model.size()), options_(options) {
  for (const auto& nodes : tours) {
    individuals_.push_back({links_of(nodes), model.tour_cost(nodes)});
    counts_.add(individuals_.back().links);
  }
}

Population::Offspring Population::breed(const Individual& a, const Individual& b, Stage stage, Random random,
                                        Workspace& workspace) const {
  Offspring best;
  auto& [assembly, cycles, child, order, chosen] = workspace;
  cycles.split(a.links, b.links, random);
  if (cycles.count() == 0) return best;
  assembly.set_parent(a.links);
  if (stage == Stage::kBlock) assembly.index_cycles(cycles);
  order.resize(static_cast<std::size_t>(cycles.count()));
  std::iota(order.begin(), order.end(), 0);
  const int children = std::min(options_.children, cycles.count());
  for (int i = 0; i < children; ++i) {
    std::swap(order[i],
              order[i + static_cast<int>(random.below(static_cast<std::uint64_t>(cycles.count() - i)))]);
    if (stage == Stage::kBlock) {
      assembly.block_around(cycles, order[i], chosen);
    } else {
      chosen.assign(1, order[i]);
    }
    if (!assembly.build(cycles, chosen, child) || child.gain <= 0) continue;
    const double lost = -counts_.entropy_change(child.changes, static_cast<int>(individuals_.size()));
    const double worth = static_cast<double>(child.gain) / std::max(lost, 1e-9);
    if (worth > best.worth) {
      best.worth = worth;
      std::swap(best.child, child);
    }
  }
  return best;
}

void Population::replace(Individual& a, const Offspring& offspring) {
  if (offspring.worth <= 0) return;
  a.cost -= offspring.child.gain;
  const auto relink = [&](int v, int old_end, int new_end) {
    (a.links[v][0] == old_end ? a.links[v][0] : a.links[v][1]) = new_end;
  };
  for (const EdgeChange& c : offspring.child.changes) {
    if (!c.added) relink(c.a, c.b, -1), relink(c.b, c.a, -1);
  }
  for (const EdgeChange& c : offspring.child.changes) {
    if (c.added) relink(c.a, -1, c.b), relink(c.b, -1, c.a);
  }
  counts_.apply(offspring.child.changes);
}

void Population::run_generation(Stage stage, const StopWatch& watch, std::vector<Workspace>& workspaces) {
  const int size = static_cast<int>(individuals_.size());
  Random random(options_.seed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(generation_));
  std::vector<int> ring(individuals_.size());
  std::iota(ring.begin(), ring.end(), 0);
  for (std::size_t i = ring.size(); i > 1; --i) std::swap(ring[i - 1], ring[random.below(i)]);
  std::vector<std::uint64_t> seeds;
  for (int i = 0; i < size; ++i) seeds.push_back(random.next());
  for (int begin = 0; begin < size && !watch.over(); begin += kBatch) {
    const int count = std::min(kBatch, size - begin);
    std::vector<Offspring> offspring(static_cast<std::size_t>(count));
    parallel_for(0, count, [&](int i) {
      const Individual& a = individuals_[ring[begin + i]];
      const Individual& b = individuals_[ring[(begin + i + 1) % size]];
      offspring[i] = breed(a, b, stage, Random(seeds[begin + i]), workspaces[i]);
    });
    for (int i = 0; i < count; ++i) replace(individuals_[ring[begin + i]], offspring[i]);
  }
  ++generation_;
}

void Population::evolve(const StopWatch& watch,
                        const std::function<bool(const std::vector<int>&, Cost)>& improved) {
  std::vector<Workspace> workspaces;
  for (int i = 0; i < std::min<int>(kBatch, static_cast<int>(individuals_.size())); ++i)
    workspaces.emplace_back(model_);
  Cost best = best_cost();
  for (const Stage stage : {Stage::kSingle, Stage::kBlock}) {
    double mean = mean_cost();
    int idle = 0, idle_mean = 0;
    while (idle < kPatience && idle_mean < kPatienceOfMean && generation_ < options_.generations &&
           !watch.over()) {
      run_generation(stage, watch, workspaces);
      ++idle;
      if (best_cost() < best) {
        best = best_cost();
        idle = 0;
        if (!improved(best_nodes(), best)) return;
      }
      idle_mean = mean_cost() < mean ? 0 : idle_mean + 1;
      mean = mean_cost();
    }
  }
}

int Population::best_index() const {
  const auto it = std::min_element(individuals_.begin(), individuals_.end(),
                                   [](const Individual& x, const Individual& y) { return x.cost < y.cost; });
  return static_cast<int>(it - individuals_.begin());
}

Population::Cost Population::best_cost() const {
  return individuals_[best_index()].cost;
}
std::vector<int> Population::best_nodes() const {
  return nodes_of(individuals_[best_index()].links);
}

double Population::mean_cost() const {
  double sum = 0;
  for (const Individual& i : individuals_) sum += static_cast<double>(i.cost);
  return sum / static_cast<double>(individuals_.size());
}

}  // namespace clearcut::order
