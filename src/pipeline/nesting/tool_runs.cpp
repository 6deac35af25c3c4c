#include "pipeline/nesting/tool_runs.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace clearcut::pipeline {
namespace {

/// How many of its runs each kind has done.
using Done = std::vector<std::size_t>;

/// Reached from the state `before` of the stay before by a stay of `tool`.
struct State {
  Done done;
  std::size_t before = 0;
  int tool = 0;
};

std::size_t runs_in(const Done& done) {
  return std::accumulate(done.begin(), done.end(), std::size_t{0});
}

/// What is done after `tool` has worked on all kinds whose next tool it is: never worse than to leave one of them out.
Done after(const Done& done, int tool, const std::vector<std::vector<int>>& tools) {
  Done next = done;
  for (std::size_t kind = 0; kind < tools.size(); ++kind)
    if (next[kind] < tools[kind].size() && tools[kind][next[kind]] == tool) ++next[kind];
  return next;
}

/// The states one stay further, each once; the furthest first.
std::vector<State> next_states(const std::vector<State>& states, const std::vector<std::vector<int>>& tools) {
  std::vector<State> next;
  std::set<Done> known;
  for (std::size_t i = 0; i < states.size(); ++i) {
    std::set<int> tried;
    for (std::size_t kind = 0; kind < tools.size(); ++kind) {
      if (states[i].done[kind] >= tools[kind].size()) continue;
      const int tool = tools[kind][states[i].done[kind]];
      if (!tried.insert(tool).second) continue;
      Done done = after(states[i].done, tool, tools);
      if (known.insert(done).second) next.push_back({std::move(done), i, tool});
    }
  }
  std::stable_sort(next.begin(), next.end(),
                   [](const State& a, const State& b) { return runs_in(a.done) > runs_in(b.done); });
  if (next.size() > kMostStates) next.resize(kMostStates);
  return next;
}

/// The tools of the shortest way found from nothing to everything done.
std::vector<int> common_sequence(const std::vector<std::vector<int>>& tools) {
  std::size_t all = 0;
  for (const auto& one : tools) all += one.size();
  std::vector<std::vector<State>> stays{{{Done(tools.size(), 0), 0, 0}}};
  while (runs_in(stays.back().front().done) < all) stays.push_back(next_states(stays.back(), tools));
  std::vector<int> sequence;
  std::size_t at = 0;
  for (std::size_t stay = stays.size() - 1; stay > 0; --stay) {
    sequence.push_back(stays[stay][at].tool);
    at = stays[stay][at].before;
  }
  std::reverse(sequence.begin(), sequence.end());
  return sequence;
}

}  // namespace

std::vector<SharedRun> merged_runs(const std::vector<std::vector<int>>& tools) {
  // From the end backwards: what joins a stay as soon as it can then does so as late as it can.
  std::vector<std::vector<int>> back = tools;
  for (auto& one : back) std::reverse(one.begin(), one.end());
  std::vector<SharedRun> runs;
  Done done(tools.size(), 0);
  for (const int tool : common_sequence(back)) {
    SharedRun run{tool, {}};
    const Done next = after(done, tool, back);
    for (std::size_t kind = 0; kind < tools.size(); ++kind)
      if (next[kind] > done[kind]) run.shares.push_back({kind, tools[kind].size() - 1 - done[kind]});
    done = next;
    runs.push_back(std::move(run));
  }
  std::reverse(runs.begin(), runs.end());
  return runs;
}

}  // namespace clearcut::pipeline
