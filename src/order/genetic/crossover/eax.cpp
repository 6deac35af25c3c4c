#include <algorithm>

#include "order/genetic/operators.h"
#include "order/length/ab_cycles.h"
#include "order/length/assembly.h"

namespace clearcut::order {

namespace {

constexpr int kSmallest = 8;  // nodes; below, tours have hardly any AB-cycles

class Eax final : public Crossover {
 public:
  explicit Eax(const OperatorContext& context)
      : context_(context),
        model_(context.moves.problem(), kCandidates),
        assembly_(model_),
        cycles_(model_.size()) {}

  void cross(const Genome& first, const Genome& second, Random& random, Genome& child) override {
    child = first;
    if (model_.size() < kSmallest) return;
    Links links = links_of(model_.from_problem(first.genes()));
    cycles_.split(links, links_of(model_.from_problem(second.genes())), random);
    if (cycles_.count() == 0) return;
    const int chosen = static_cast<int>(random.below(static_cast<std::uint64_t>(cycles_.count())));
    assembly_.set_parent(links);
    if (!assembly_.build(cycles_, {&chosen, 1}, change_)) return;
    relink(links);
    Tour tour = model_.to_problem(nodes_of(links));
    align(tour, first);
    if (is_valid(context_.moves.problem(), tour)) child.assign(std::move(tour));
  }

 private:
  void relink(Links& links) const {
    const auto put = [&](int v, int old_end, int new_end) {
      auto& ends = links[static_cast<std::size_t>(v)];
      (ends[0] == old_end ? ends[0] : ends[1]) = new_end;
    };
    for (const EdgeChange& c : change_.changes) {
      if (!c.added) put(c.a, c.b, -1), put(c.b, c.a, -1);
    }
    for (const EdgeChange& c : change_.changes) {
      if (c.added) put(c.a, -1, c.b), put(c.b, -1, c.a);
    }
  }
  /// Same beginning and direction as the parent, so that most genes keep their positions.
  void align(Tour& tour, const Genome& parent) const {
    const auto agreeing = [&](const Tour& genes) {
      int count = 0;
      for (int p = 0; p < parent.size(); ++p)
        count += genes[static_cast<std::size_t>(p)] == parent.at(p) ? 1 : 0;
      return count;
    };
    const auto begin_as_parent = [&](Tour& genes) {
      if (context_.closed())
        std::rotate(genes.begin(), std::find(genes.begin(), genes.end(), parent.at(0)), genes.end());
    };
    begin_as_parent(tour);
    if (context_.free_count() < parent.size()) return;  // fixed ends give the direction
    Tour backwards(tour.rbegin(), tour.rend());
    begin_as_parent(backwards);
    if (agreeing(backwards) > agreeing(tour)) tour = std::move(backwards);
  }

  const OperatorContext& context_;
  LengthModel model_;
  Assembly assembly_;
  AbCycles cycles_;
  Child change_;
};

}  // namespace

std::unique_ptr<Crossover> eax(const OperatorContext& context) {
  return std::make_unique<Eax>(context);
}

}  // namespace clearcut::order
