#include "order/genetic/pool.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace clearcut::order {

Pool::Pool(std::vector<Individual> individuals, bool closed)
    : closed_(closed),
      individuals_(std::move(individuals)),
      ranked_(individuals_.size()),
      values_(individuals_.size()),
      known_(individuals_.size() * individuals_.size(), Known::kNo) {
  std::iota(ranked_.begin(), ranked_.end(), 0);
  rank();
}

/// Insertion sort: after a replacement only one is out of place.
void Pool::rank() {
  const auto is_before = [&](int a, int b) {
    return at(a).value < at(b).value || (at(a).value <= at(b).value && a < b);
  };
  for (std::size_t i = 1; i < ranked_.size(); ++i) {
    for (std::size_t j = i; j > 0 && is_before(ranked_[j], ranked_[j - 1]); --j)
      std::swap(ranked_[j], ranked_[j - 1]);
  }
  for (std::size_t i = 0; i < ranked_.size(); ++i) values_[i] = at(ranked_[i]).value;
}

double Pool::mean_value() const {
  return std::accumulate(values_.begin(), values_.end(), 0.0) / static_cast<double>(size());
}

void Pool::replace(int i, Individual& by) {
  std::swap(individuals_[static_cast<std::size_t>(i)], by);
  for (int j = 0; j < size(); ++j) known(i, j) = known(j, i) = Known::kNo;
  rank();
}

bool Pool::too_similar(int i, int j, double most) {
  if (most >= 1) return false;
  Known& answer = known(std::min(i, j), std::max(i, j));
  if (answer == Known::kNo) {
    const bool similar = shared_edges(at(i).genome, at(j).genome, closed_, most) > most;
    answer = similar ? Known::kSimilar : Known::kDifferent;
  }
  return answer == Known::kSimilar;
}

namespace {

/// Builds one path.
class Walk {
 public:
  Walk(const OperatorContext& context, int breadth)
      : problem_(context.moves.problem()),
        context_(context),
        breadth_(static_cast<std::size_t>(breadth)),
        waiting_(problem_.points.size(), 0),
        used_(problem_.points.size(), 0) {
    for (const Precedence& p : problem_.precedence) ++waiting_[static_cast<std::size_t>(p.after)];
    for (int v = 0; v < problem_.size(); ++v) unused_.push_back(v);
  }

  Tour run(Random& random) {
    int at = problem_.start >= 0 ? problem_.start : any_allowed(random);
    visit(at);
    while (static_cast<int>(tour_.size()) < problem_.size()) {
      at = next(at, random);
      visit(at);
    }
    return std::move(tour_);
  }

 private:
  bool is_allowed(int v) const {
    const auto i = static_cast<std::size_t>(v);
    const bool too_early = v == problem_.end && static_cast<int>(tour_.size()) + 1 < problem_.size();
    return !used_[i] && waiting_[i] == 0 && !too_early;
  }
  int any_allowed(Random& random) const {
    std::vector<int> allowed;
    for (int v = 0; v < problem_.size(); ++v) {
      if (is_allowed(v)) allowed.push_back(v);
    }
    return allowed[random.below(allowed.size())];
  }
  int next(int at, Random& random) {
    near_.clear();
    for (const int v : context_.neighbours.nearest(at)) {
      if (is_allowed(v)) near_.push_back(v);
      if (near_.size() == breadth_) break;
    }
    return near_.empty() ? nearest_unused(at) : near_[random.below(near_.size())];
  }
  int nearest_unused(int at) {
    std::erase_if(unused_, [&](int v) { return used_[static_cast<std::size_t>(v)] != 0; });
    int best = -1;
    double best_squared = std::numeric_limits<double>::infinity();
    for (const int v : unused_) {
      const Vec2 d =
          problem_.points[static_cast<std::size_t>(v)] - problem_.points[static_cast<std::size_t>(at)];
      if (!is_allowed(v) || dot(d, d) >= best_squared) continue;
      best = v;
      best_squared = dot(d, d);
    }
    return best;
  }
  void visit(int v) {
    tour_.push_back(v);
    used_[static_cast<std::size_t>(v)] = 1;
    for (const Precedence& p : problem_.precedence)
      waiting_[static_cast<std::size_t>(p.after)] -= p.before == v ? 1 : 0;
  }

  const Problem& problem_;
  const OperatorContext& context_;
  std::size_t breadth_;
  std::vector<int> waiting_;
  std::vector<char> used_;
  std::vector<int> unused_, near_;
  Tour tour_;
};

double most_similar(const std::vector<Genome>& others, const Genome& genome, bool closed, double enough) {
  double most = 0;
  for (const Genome& other : others) {
    most = std::max(most, shared_edges(genome, other, closed, enough));
    if (most > enough) break;
  }
  return most;
}

}  // namespace

Tour nearest_path(const OperatorContext& context, int breadth, Random& random) {
  return Walk(context, breadth).run(random);
}

std::vector<Genome> first_population(const OperatorContext& context, int count, double most_shared,
                                     int breadth, Random& random) {
  constexpr int kTries = 10;
  std::vector<Genome> population;
  for (int i = 0; i < count; ++i) {
    Genome best;
    double least = std::numeric_limits<double>::infinity();
    for (int tried = 0; tried < kTries && least > most_shared; ++tried) {
      Genome genome(nearest_path(context, breadth, random));
      // The share is exact up to the least one so far, so that the least similar individual can be found.
      const double shared = most_similar(population, genome, context.closed(), std::min(least, 1.0));
      if (shared >= least) continue;
      least = shared;
      best = std::move(genome);
    }
    population.push_back(std::move(best));
  }
  return population;
}

}  // namespace clearcut::order
