#include "order/search/exchange_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace clearcut::order {

namespace {

constexpr int kSecondBreadth = 10;
constexpr int kThirdBreadth = 5;
constexpr int kLongestSegment = 30;
/// Greatest number of values kept of edges, and of corners: triples of 48 points take 0.9 MB in each search.
constexpr std::size_t kMostKnownValues = std::size_t{48} * 48 * 48;

std::vector<int> with_extra(const Problem& problem, const Tour& tour) {
  std::vector<int> nodes(tour.begin(), tour.end());
  if (!problem.closed()) nodes.push_back(problem.size());
  return nodes;
}

/// Gains below this are rounding.
double least_gain(double value) {
  return kSameValue * (1 + std::abs(value));
}

}  // namespace

ExchangeSearch::ExchangeSearch(const Moves& moves, const Objective& objective, const Neighbours& neighbours,
                               const Tour& start, std::uint64_t seed)
    : moves_(moves),
      straight_(moves.has_detours() ? std::make_unique<Straight>(moves.problem()) : nullptr),
      objective_(objective),
      neighbours_(neighbours),
      extra_(moves.problem().closed() ? -1 : moves.problem().size()),
      path_(with_extra(moves.problem(), start)),
      known_edges_(moves.problem().points.size() * moves.problem().points.size()),
      known_corners_(moves.problem().points.size() * moves.problem().points.size() *
                     moves.problem().points.size()),
      random_(seed),
      value_(evaluate(objective, moves, start)),
      path_value_(objective.path_dependent() ? objective.path_value(moves) : nullptr),
      queued_(static_cast<std::size_t>(path_.size())),
      rules_(groups_of(moves.problem())) {
  if (path_value_) path_part_ = path_value_->of(start);
}

ExchangeSearch::Straight::Straight(const Problem& problem)
    : without_detours([&] {
        Problem copy = problem;
        copy.detour = nullptr;
        return copy;
      }()),
      moves(without_detours) {}

double ExchangeSearch::least_edge(int a, int b) const {
  if (!straight_ || a == extra_ || b == extra_) return edge(a, b);
  return objective_.edge(straight_->moves, a, b);
}

/// An evaluation costs about as much as the path is long.
void ExchangeSearch::allow_evaluations() {
  constexpr long long kPointsEvaluated = 200000, kMost = 400, kLeast = 50;
  evaluations_left_ = std::clamp(kPointsEvaluated / path_.size(), kLeast, kMost);
}

Tour ExchangeSearch::tour() const {
  std::vector<int> nodes = path_.nodes();
  if (extra_ < 0) return nodes;
  std::rotate(nodes.begin(), nodes.begin() + path_.position(extra_), nodes.end());
  nodes.erase(nodes.begin());
  if (!is_valid(moves_.problem(), nodes)) std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

ExchangeSearch::KnownValues::KnownValues(std::size_t count)
    : values_(count <= kMostKnownValues ? count : 0, std::numeric_limits<double>::quiet_NaN()) {}

double ExchangeSearch::edge(int a, int b) const {
  if (a == extra_ || b == extra_) return 0;
  const std::size_t n = moves_.problem().points.size();
  return known_edges_.at(static_cast<std::size_t>(a) * n + static_cast<std::size_t>(b),
                         [&] { return objective_.edge(moves_, a, b); });
}

double ExchangeSearch::corner(int a, int b, int c) const {
  if (a == extra_ || b == extra_ || c == extra_) return 0;
  const std::size_t n = moves_.problem().points.size();
  return known_corners_.at(
      (static_cast<std::size_t>(a) * n + static_cast<std::size_t>(b)) * n + static_cast<std::size_t>(c),
      [&] { return objective_.corner(moves_, a, b, c); });
}

double ExchangeSearch::corner_now(int v) const {
  return corner(path_.previous(v), v, path_.next(v));
}

double ExchangeSearch::local_change(const Exchange& exchange) const {
  const int ends = 2 * exchange.count;
  double change = 0;
  for (int i = 0; i < ends; i += 2) {
    change -= edge(exchange.t[i], exchange.t[i + 1]);
    change += edge(exchange.t[i + 1], exchange.t[i + 2 == ends ? 0 : i + 2]);
  }
  for (int i = 0; i < ends; ++i) {
    const int v = exchange.t[i];
    std::array<int, 2> around{path_.previous(v), path_.next(v)};
    bool first = true;
    for (int j = 0; j < ends; ++j) {
      if (exchange.t[j] != v) continue;
      first = first && j >= i;
      const int leaves = exchange.t[j ^ 1];
      const int enters = exchange.t[j % 2 == 1 ? (j + 1 == ends ? 0 : j + 1) : (j == 0 ? ends - 1 : j - 1)];
      // marked, so that the edge is not removed again
      (around[0] == leaves ? around[0] : around[1]) = ~enters;
    }
    if (!first) continue;  // a node with both edges exchanged is counted once
    for (int& w : around) w = w < 0 ? ~w : w;
    change += corner(around[0], v, around[1]) - corner_now(v);
  }
  return change;
}

double ExchangeSearch::release(int i) const {
  const int a = exchange_.t[2 * i], b = exchange_.t[2 * i + 1];
  return edge(a, b) + corner_now(a) + corner_now(b);
}

int ExchangeSearch::candidate_count(int v, int most) const {
  return v == extra_ ? 0 : std::min(most, neighbours_.count()) + (extra_ >= 0 ? 1 : 0);
}

/// The extra node comes last in every list.
int ExchangeSearch::candidate(int v, int i, int most) const {
  return i < std::min(most, neighbours_.count()) ? neighbours_.of(v)[i] : extra_;
}

double ExchangeSearch::stretch_value(int before, int length) const {
  const int n = path_.size();
  const int edges = std::min(length + 1, n), corners = std::min(length + 2, n);
  const auto node = [&](int offset) { return path_.at((before + offset + n) % n); };
  double value = 0;
  for (int i = 0; i < edges; ++i) value += edge(node(i), node(i + 1));
  for (int i = 0; i < corners; ++i) value += corner(node(i - 1), node(i), node(i + 1));
  return value;
}

/// Many nodes often have the same nodes before them, such as everything else before all cut-outs: thousands of rules are then
/// one group, which holds if its last earlier node comes before its first later one.
std::vector<ExchangeSearch::RuleGroup> ExchangeSearch::groups_of(const Problem& problem) {
  std::map<int, std::vector<int>> before;
  for (const Precedence& rule : problem.precedence) before[rule.after].push_back(rule.before);
  std::map<std::vector<int>, std::vector<int>> after;
  for (auto& [node, earlier] : before) {
    std::sort(earlier.begin(), earlier.end());
    after[std::move(earlier)].push_back(node);
  }
  std::vector<RuleGroup> groups;
  for (const auto& [earlier, later] : after) groups.push_back({earlier, later});
  return groups;
}

bool ExchangeSearch::keeps_rules() const {
  const Problem& problem = moves_.problem();
  if (extra_ < 0) return true;
  if (problem.start < 0 && problem.end < 0 && rules_.empty()) return true;
  const int n = path_.size(), origin = path_.position(extra_);
  const auto rank = [&](int v) {
    const int from_origin = path_.position(v) - origin;
    return from_origin < 0 ? from_origin + n : from_origin;
  };
  const auto holds = [&](bool backwards) {
    const int first = backwards ? n - 1 : 1, last = backwards ? 1 : n - 1;
    if (problem.start >= 0 && rank(problem.start) != first) return false;
    if (problem.end >= 0 && rank(problem.end) != last) return false;
    const auto place = [&](int v) { return backwards ? n - rank(v) : rank(v); };
    const auto comes_first = [&](int a, int b) { return place(a) < place(b); };
    // The rule that was broken last is the likeliest to be broken again.
    Precedence& broken = broken_[backwards ? 1 : 0];
    if (broken.before != broken.after && !comes_first(broken.before, broken.after)) return false;
    for (const RuleGroup& group : rules_) {
      const int earlier = *std::max_element(group.before.begin(), group.before.end(), comes_first);
      const int later = *std::min_element(group.after.begin(), group.after.end(), comes_first);
      if (comes_first(earlier, later)) continue;
      broken = {earlier, later};
      return false;
    }
    return true;
  };
  return holds(false) || holds(true);
}

bool ExchangeSearch::accept_if_better() {
  const double change = local_change(exchange_);
  const bool whole = asks_path();
  if (change > slack() - least_gain(value_)) return false;
  if (!path_.is_tour(exchange_)) return false;
  path_.apply(exchange_);
  double path_part = path_part_;
  bool better = keeps_rules();
  if (better && whole && evaluations_left_-- <= 0) better = false;
  if (better && whole) {
    path_part = path_value_->of(tour());
    better = change + path_part - path_part_ < -least_gain(value_);
  }
  if (!better) {
    path_.undo_last();
    return false;
  }
  value_ += change + path_part - path_part_;
  path_part_ = path_part;
  for (int i = 0; i < 2 * exchange_.count; ++i) touch(exchange_.t[i]);
  return true;
}

double ExchangeSearch::slack() const {
  // Greatest gain by one exchange in the part depending on the whole path.
  constexpr double kMostGained = 0.1;
  return asks_path() ? kMostGained * path_part_ : 0;
}

bool ExchangeSearch::asks_path() const {
  return path_value_ && !repairing_;
}

// The balance kept while an exchange is built: cost of the removed edges and of the corners at their ends, less the
// cost of the added edges and of their certain corners. Some rotation of every improving exchange keeps this balance
// positive throughout [lin1973], so all other exchanges can be skipped.
double ExchangeSearch::corners_made(int a, int b, int not_a, int not_b) const {
  const auto other = [&](int v, int gone) {
    return path_.next(v) == gone ? path_.previous(v) : path_.next(v);
  };
  return edge(a, b) + corner(other(a, not_a), a, b) + corner(a, b, other(b, not_b));
}

/// Closes the exchange if closing can be profitable.
bool ExchangeSearch::try_closing(double balance) {
  const int first = exchange_.t[0], last = exchange_.t[2 * exchange_.count - 1];
  if (balance - least_edge(last, first) <= 0 || balance - edge(last, first) <= 0) return false;
  return accept_if_better();
}

/// Adds the edge from the loose end t[2 depth - 1] to its candidates and removes the next, for exchanges of
/// `depth` + 1 edges and, from depth 1, one more.
bool ExchangeSearch::extend(int depth, double balance) {
  const int loose = exchange_.t[2 * depth - 1], partner = exchange_.t[2 * depth - 2];
  const int breadth = depth == 1 ? kSecondBreadth : kThirdBreadth;
  for (int i = 0; i < candidate_count(loose, breadth); ++i) {
    const int c = candidate(loose, i, breadth);
    if (c == path_.next(loose) || c == path_.previous(loose)) continue;
    if (balance - least_edge(loose, c) <= 0 || balance - edge(loose, c) <= 0) continue;
    for (const int d : {path_.next(c), path_.previous(c)}) {
      if (d == exchange_.t[0] || is_removed(c, d, depth)) continue;
      const double rest = balance - corners_made(loose, c, partner, d);
      if (rest <= 0) continue;
      exchange_.t[2 * depth] = c;
      exchange_.t[2 * depth + 1] = d;
      exchange_.count = depth + 1;
      const double next_balance = rest + release(depth);
      // A third edge only if the other two gain by themselves: evaluating the whole path for all is too costly.
      if (try_closing(next_balance) || (depth == 1 && extend(2, next_balance - slack()))) return true;
    }
  }
  return false;
}

bool ExchangeSearch::is_removed(int a, int b, int depth) const {
  for (int i = 0; i < depth; ++i) {
    if (std::minmax(exchange_.t[2 * i], exchange_.t[2 * i + 1]) == std::minmax(a, b)) return true;
  }
  return false;
}

bool ExchangeSearch::improve_node(int t0) {
  for (const int t1 : {path_.next(t0), path_.previous(t0)}) {
    exchange_.t[0] = t0;
    exchange_.t[1] = t1;
    const double balance = release(0) + slack();
    if (balance > 0 && extend(1, balance)) return true;
  }
  return false;
}

void ExchangeSearch::touch(int v) {
  if (queued_[v]) return;
  queued_[v] = true;
  queue_.push_back(v);
}

void ExchangeSearch::drain(const StopWatch& watch) {
  while (head_ < queue_.size()) {
    const int v = queue_[head_++];
    queued_[v] = false;
    while (!watch.over() && (!asks_path() || evaluations_left_ > 0) && improve_node(v)) {
    }
  }
  queue_.clear();
  head_ = 0;
}

void ExchangeSearch::descend(const StopWatch& watch) {
  allow_evaluations();
  for (const int v : std::vector<int>(path_.nodes())) touch(v);
  drain(watch);
  path_.commit();
}

/// Three neighbouring segments in reverse order, as in the chained search for length.
void ExchangeSearch::kick() {
  const int n = path_.size();
  const int longest = std::min(kLongestSegment, (n - 2) / 3);
  const int before = static_cast<int>(random_.below(static_cast<std::uint64_t>(n)));
  std::array<int, 4> last{};
  for (int i = 1; i < 4; ++i)
    last[i] = last[i - 1] + 1 + static_cast<int>(random_.below(static_cast<std::uint64_t>(longest)));
  const auto node = [&](int offset) {
    return path_.at(before + offset < n ? before + offset : before + offset - n);
  };
  segments_.clear();
  for (int i = 3; i > 0; --i) {
    for (int offset = last[i - 1] + 1; offset <= last[i]; ++offset) segments_.push_back(node(offset));
  }
  std::array<int, 8> ends;
  for (int i = 0; i < 4; ++i) {
    ends[2 * i] = node(last[i]);
    ends[2 * i + 1] = node(last[i] + 1);
  }
  value_ -= stretch_value(before, last[3]);
  path_.rewrite(before + 1 == n ? 0 : before + 1, segments_);
  value_ += stretch_value(before, last[3]);
  for (const int v : ends) touch(v);
}

void ExchangeSearch::repair(const StopWatch& watch) {
  const double path_part = path_part_;
  // Weight of edges and corners from which on a kick is repaired by these only, and the whole path is evaluated once.
  constexpr double kCounts = 0.01;
  repairing_ = path_value_ && value_ - path_part_ > kCounts * path_part_;
  if (repairing_) drain(watch);
  repairing_ = false;
  if (path_value_) {
    --evaluations_left_;
    path_part_ = path_value_->of(tour());
    value_ += path_part_ - path_part;
  }
  drain(watch);
}

void ExchangeSearch::run(long long kicks, double enough, const StopWatch& watch) {
  if (path_.size() < 8) return;
  allow_evaluations();
  for (long long i = 0; i < kicks && value_ > enough && !watch.over(); ++i) {
    if (path_value_ && evaluations_left_ <= 0) return;
    const double old_value = value_, old_path_part = path_part_;
    kick();
    const bool keeps = keeps_rules();
    if (keeps) repair(watch);
    if (keeps && value_ <= old_value + least_gain(old_value)) {
      path_.commit();
    } else {
      path_.undo();
      value_ = old_value;
      path_part_ = old_path_part;
      for (; head_ < queue_.size(); ++head_) queued_[queue_[head_]] = false;
      queue_.clear();
      head_ = 0;
    }
  }
}

}  // namespace clearcut::order
