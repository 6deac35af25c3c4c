#include "link/short_order.h"

#include <algorithm>
#include <set>

#include "order/search/visit_order.h"

namespace clearcut::link {
namespace {

/// Number of places on a ring considered for its start: those nearest to other passes.
constexpr std::size_t kRingStarts = 6;

/// The cuts first to last - 1 of a linker.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
};

std::vector<Run> runs_of(const Work& work, const std::vector<Cut>& cuts, Together together) {
  std::vector<Run> runs;
  Box swept;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const WorkItem& item = work.items()[cuts[i].item];
    const bool joined =
        i > 0 && (together == Together::kAreas ? swept.overlaps(item.path) : cuts[i].stayed_down);
    if (joined) {
      runs.back().last = i + 1;
    } else {
      runs.push_back({i, i + 1});
      swept = {};
    }
    swept.add(item.swept);
  }
  return runs;
}

class ShortOrder {
 public:
  ShortOrder(const Work& work, const Linker& linker, Together together)
      : work_(work), linker_(linker), cuts_(linker.cuts()), runs_(runs_of(work, cuts_, together)) {}

  std::vector<Task> tasks() {
    if (runs_.size() < 2) return {};
    order::VisitQuestion question;
    for (const Run& run : runs_) add_visit(run, question);
    question.precedence = precedence();
    question.fixed_first = work_.layer(0).layer().start || work_.layer(0).open();
    question.ordered_before = true;
    const auto begins = beginnings(question);
    const auto travel = [&](const order::VisitStep& a, const order::VisitStep& b, bool low) {
      const Run& from = runs_[a.visit];
      const CutterAt at{question.visits[a.visit].ways[a.way].end,
                        work_.layer_of(cuts_[from.last - 1].item).layer().z};
      return linker_.travel(at, begins[b.visit][b.way], low);
    };
    question.travel = [&](const order::VisitStep& a, const order::VisitStep& b) {
      return travel(a, b, true);
    };
    question.far_travel = [&](const order::VisitStep& a, const order::VisitStep& b) {
      return travel(a, b, false);
    };
    return tasks_of(order::order_visits(question));
  }

 private:
  std::vector<std::vector<Beginning>> beginnings(const order::VisitQuestion& question) const {
    std::vector<std::vector<Beginning>> begins(runs_.size());
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      for (const order::VisitWay& way : question.visits[r].ways)
        begins[r].push_back(linker_.beginning(cuts_[runs_[r].first].item, way.begin));
    }
    return begins;
  }

  void add_visit(const Run& run, order::VisitQuestion& question) {
    const Cut& first = cuts_[run.first];
    order::Visit visit;
    std::vector<PassStart> starts{first.start};
    visit.ways.push_back({first.begin, cuts_[run.last - 1].end, 0});
    const Pass& pass = work_.pass(first.item);
    const bool alone = run.last == run.first + 1;
    if (alone && pass.closed && pass.kinds.empty()) {
      for (const Vec2 other : nearest_others(run)) {
        const PassStart start = nearest_start(pass, other);
        starts.push_back(start);
        visit.ways.push_back({start.point, start.point, 0});
      }
    } else if (alone && !pass.closed && pass.reversible) {
      PassStart turned = first.start;
      turned.backwards = !turned.backwards;
      turned.point = first.end;
      starts.push_back(turned);
      visit.ways.push_back({first.end, first.begin, 0});
    }
    question.visits.push_back(std::move(visit));
    starts_.push_back(std::move(starts));
  }

  std::vector<Vec2> nearest_others(const Run& own) const {
    std::vector<Vec2> places;
    for (const Run& run : runs_) {
      if (run.first != own.first) places.push_back(work_.items()[cuts_[run.first].item].path.center());
    }
    const Vec2 here = work_.items()[cuts_[own.first].item].path.center();
    std::stable_sort(places.begin(), places.end(),
                     [&](Vec2 a, Vec2 b) { return norm_squared(a - here) < norm_squared(b - here); });
    if (places.size() > kRingStarts) places.resize(kRingStarts);
    return places;
  }

  std::vector<std::pair<std::size_t, std::size_t>> precedence() const {
    std::vector<std::size_t> run_of(work_.items().size());
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      for (std::size_t i = runs_[r].first; i < runs_[r].last; ++i) run_of[cuts_[i].item] = r;
    }
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t item = 0; item < work_.items().size(); ++item) {
      for (const std::size_t before : work_.before(item)) {
        if (run_of[before] != run_of[item]) pairs.insert({run_of[before], run_of[item]});
      }
    }
    return {pairs.begin(), pairs.end()};
  }

  std::vector<Task> tasks_of(const std::vector<order::VisitStep>& steps) const {
    std::vector<Task> tasks;
    for (const order::VisitStep& step : steps) {
      const Run& run = runs_[step.visit];
      for (std::size_t i = run.first; i < run.last; ++i) {
        tasks.push_back({cuts_[i].item, std::nullopt});
        if (i == run.first && (i + 1 == run.last || tasks.size() == 1))
          tasks.back().start = starts_[step.visit][step.way];
      }
    }
    return tasks;
  }

  const Work& work_;
  const Linker& linker_;
  const std::vector<Cut>& cuts_;
  std::vector<Run> runs_;
  /// For each run and each manner of cutting it: the starts of its passes.
  std::vector<std::vector<PassStart>> starts_;
};

}  // namespace

std::vector<Task> short_order(const Work& work, const Linker& linker, Together together) {
  return ShortOrder(work, linker, together).tasks();
}

}  // namespace clearcut::link
