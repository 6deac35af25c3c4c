#include "link/sections/load_feeds.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "model/cutter_profile.h"
#include "stock/cutting_load.h"

namespace clearcut::link {
namespace {

/// mm, and share of the radius: greatest distance between places at which the load is computed.
constexpr double kLongestSample = 0.04, kSampleOfRadius = 0.02;
/// mm from the beginning of a move at which the load is also computed.
constexpr double kCorner = 0.01;
/// mm. Material thinner than this is due to rounding.
constexpr double kThinnest = 1e-3;
/// Usable share of the reference: between two samples the load may be slightly greater than at both.
constexpr double kUsed = 0.985;
/// Between two samples whose feeds differ by a greater share the load is computed in the middle, too, so often one
/// within the other.
constexpr double kAlike = 0.01;
constexpr int kHalvings = 5;
/// s. A word for another feed has to gain as much: on a pocket of 100 mm 0.001 gains 2 % of the time by equal chips
/// and has five times the words of 0.02.
constexpr double kWorthAWord = 0.01;
/// mm/min. Feeds below are not rounded to whole numbers.
constexpr double kWholeFeeds = 20;

/// A stretch of a move with the highest feed allowed by the load.
struct Stretch {
  std::size_t move = 0;
  double t_from = 0, t_to = 1;
  double length = 0;    ///< mm
  double feed = 0;      ///< mm/min
  bool joined = false;  ///< may share one feed with the previous stretch
};

/// Neighbouring stretches with one feed.
struct Run {
  double length = 0, feed = 0;
  std::ptrdiff_t before = -1, after = -1;
  std::size_t first = 0, last = 0;  ///< stretches, to before `last`
  int version = 0;
  bool gone = false;
};

/// s; time of a run of `length` mm at `fast` between neighbours at `slow`, mm/s, with the acceleration at both ends.
double time_between(double length, double fast, double slow, double acceleration) {
  const double ramps = (fast * fast - slow * slow) / acceleration;
  if (length >= ramps) return length / fast + (fast - slow) * (fast - slow) / (acceleration * fast);
  const double top = std::sqrt(slow * slow + acceleration * length);
  return 2 * (top - slow) / acceleration;
}

double rounded_down(double feed) {
  return feed < kWholeFeeds ? feed : std::floor(feed + 1e-6);
}

/// Gives neighbours one feed wherever this costs less than a further feed word.
class Joiner {
 public:
  Joiner(std::vector<Stretch>& stretches, double acceleration)
      : stretches_(stretches), acceleration_(acceleration) {
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      Run run{stretches[i].length, stretches[i].feed, -1, -1, i, i + 1};
      if (stretches[i].joined) {
        run.before = static_cast<std::ptrdiff_t>(i) - 1;
        runs_[i - 1].after = static_cast<std::ptrdiff_t>(i);
      }
      runs_.push_back(run);
    }
  }

  void join() {
    for (std::size_t i = 0; i < runs_.size(); ++i) offer(static_cast<std::ptrdiff_t>(i));
    while (!queue_.empty()) {
      const Offer offer = queue_.top();
      queue_.pop();
      if (is_current(offer)) join_with_next(offer.run);
    }
    for (const Run& run : runs_) {
      if (run.gone) continue;
      for (std::size_t i = run.first; i < run.last; ++i) stretches_[i].feed = run.feed;
    }
  }

 private:
  /// A candidate for joining a run with the next one.
  struct Offer {
    double cost = 0;  ///< s
    std::ptrdiff_t run = 0;
    int version = 0, next_version = 0;
    bool operator<(const Offer& other) const { return cost > other.cost; }
  };

  Run& at(std::ptrdiff_t i) { return runs_[static_cast<std::size_t>(i)]; }

  double cost_of(const Run& a, const Run& b) const {
    const Run& fast = a.feed >= b.feed ? a : b;
    const double high = fast.feed / 60, low = std::min(a.feed, b.feed) / 60;
    if (high <= low) return 0;
    return fast.length / low - time_between(fast.length, high, low, acceleration_);
  }

  void offer(std::ptrdiff_t i) {
    if (i < 0 || at(i).gone || at(i).after < 0) return;
    const Run& run = at(i);
    const Run& next = at(run.after);
    const double cost = cost_of(run, next);
    if (cost < kWorthAWord) queue_.push({cost, i, run.version, next.version});
  }

  bool is_current(const Offer& offer) {
    const Run& run = at(offer.run);
    return !run.gone && run.version == offer.version && run.after >= 0 &&
           at(run.after).version == offer.next_version;
  }

  void join_with_next(std::ptrdiff_t i) {
    Run& run = at(i);
    Run& next = at(run.after);
    run.length += next.length;
    run.feed = std::min(run.feed, next.feed);
    run.last = next.last;
    run.after = next.after;
    ++run.version;
    next.gone = true;
    if (run.after >= 0) at(run.after).before = i;
    offer(run.before);
    offer(i);
  }

  std::vector<Stretch>& stretches_;
  const double acceleration_;
  std::vector<Run> runs_;
  std::priority_queue<Offer> queue_;
};

class LoadFeedSetter {
 public:
  LoadFeedSetter(Section& section, const Tool& tool, const LoadFeeds& feeds, stock::Material& material)
      : section_(section),
        feeds_(feeds),
        material_(material),
        radius_(tool.radius()),
        tool_(tool),
        cutter_(stock::add_tool(material, tool)),
        allowed_(kUsed * feeds.reference.mm_per_min() *
                 stock::load_at_feed_of_one(feeds.rule.by, feeds.rule.reference)) {}

  void set() {
    for (std::size_t i = 0; i < section_.moves.size(); ++i) {
      const Move& move = section_.moves[i];
      if (is_rapid(move.kind)) continue;
      add_stretches(i);
      stock::remove_cut(material_, move, tool_);
    }
    if (feeds_.acceleration > 0) Joiner(stretches_, feeds_.acceleration).join();
    write();
  }

 private:
  bool is_raised(const Move& move) const {
    return !move.is_vertical() && move.z_from == move.z_to &&
           std::abs(move.feed.mm_per_min() - feeds_.cutting.mm_per_min()) <= 1e-6 * move.feed.mm_per_min();
  }

  /// Highest feed without contact to material; only moves with raised feeds change their feed there.
  double most_in_air(const Move& move) const {
    return is_raised(move) ? feeds_.cap.mm_per_min() : move.feed.mm_per_min();
  }

  /// The highest feed at a place of a move; `raised` is that move, slightly higher.
  double feed_at(const Move& raised, double t) const {
    // The path and the one that it cuts beside are displaced, so that a thin chip becomes thicker.
    const auto contact = material_.engagement(raised, t, radius_ - kThinnest + 2 * feeds_.displaced, cutter_);
    const double load = stock::load_at_feed_of_one(feeds_.rule.by, contact);
    if (load <= 0) return most_in_air(raised);
    const double highest = std::min(most_in_air(raised), feeds_.cap.mm_per_min());
    return load * highest <= allowed_ ? highest : allowed_ / load;
  }

  /// A place of a move and the highest feed there.
  struct Sample {
    double t = 0, feed = 0;
  };

  /// The highest feed from one sample to another.
  double least_between(const Move& raised, const Sample& a, const Sample& b, int halvings) const {
    const double least = std::min(a.feed, b.feed);
    if (halvings == 0 || std::max(a.feed, b.feed) <= least * (1 + kAlike)) return least;
    const double t = (a.t + b.t) / 2;
    const Sample middle{t, feed_at(raised, t)};
    return std::min(least_between(raised, a, middle, halvings - 1),
                    least_between(raised, middle, b, halvings - 1));
  }

  void add_stretches(std::size_t index) {
    const Move& move = section_.moves[index];
    const bool joined = !stretches_.empty() && stretches_.back().move + 1 == index && is_raised(move) &&
                        is_raised(section_.moves[index - 1]);
    if (move.is_vertical()) {
      stretches_.push_back({index, 0, 1, move.length(), most_in_air(move), false});
      return;
    }
    const double step = std::min(kLongestSample, kSampleOfRadius * radius_);
    const int count = std::max(1, static_cast<int>(std::ceil(move.path.length() / step)));
    const double length = move.length() / count;
    Move raised = move;
    raised.z_from += kThinnest;
    raised.z_to += kThinnest;
    const bool is_lead = move.kind == MoveKind::kLeadIn || move.kind == MoveKind::kLeadOut;
    const bool divides = feeds_.divides && is_raised(move) && (feeds_.divides_leads || !is_lead);
    // Just after a corner the load is greater than in the corner.
    const double corner = std::min(kCorner / move.path.length(), 0.25 / count);
    Sample before{0, std::min(feed_at(raised, 0), feed_at(raised, corner))};
    Stretch whole{index, 0, 1, move.length(), before.feed, joined};
    for (int k = 1; k <= count; ++k) {
      const double t = static_cast<double>(k) / count;
      const Sample after{t, feed_at(raised, t)};
      const double feed = rounded_down(least_between(raised, before, after, kHalvings));
      whole.feed = std::min(whole.feed, feed);
      if (divides) stretches_.push_back({index, before.t, t, length, feed, k > 1 || joined});
      before = after;
    }
    if (!divides) stretches_.push_back(whole);
  }

  /// Writes the moves anew, each divided at changes of feed.
  void write() {
    std::vector<Move> moves;
    std::size_t next = 0;
    for (std::size_t i = 0; i < section_.moves.size(); ++i) {
      const Move& move = section_.moves[i];
      if (next >= stretches_.size() || stretches_[next].move != i) {
        moves.push_back(move);
        continue;
      }
      while (next < stretches_.size() && stretches_[next].move == i) {
        std::size_t end = next + 1;
        while (end < stretches_.size() && stretches_[end].move == i &&
               stretches_[end].feed == stretches_[next].feed)
          ++end;
        moves.push_back(piece_of(move, next, end, moves));
        next = end;
      }
    }
    section_.moves = std::move(moves);
  }

  Move piece_of(const Move& move, std::size_t first, std::size_t end, const std::vector<Move>& before) const {
    const double from = stretches_[first].t_from, to = stretches_[end - 1].t_to;
    Move piece = move;
    piece.feed = MmPerMin::of(stretches_[first].feed);
    if (from <= 0 && to >= 1) return piece;
    piece.path = move.path.part(from, to);
    piece.path.from = from <= 0 ? move.path.from : before.back().path.to;
    if (to >= 1) piece.path.to = move.path.to;
    return piece;
  }

  Section& section_;
  const LoadFeeds& feeds_;
  stock::Material& material_;
  const double radius_;
  const Tool& tool_;
  const int cutter_;
  const double allowed_;  ///< mm/min times the load at a feed of one
  std::vector<Stretch> stretches_;
};

}  // namespace

void set_load_feeds(Section& section, const Tool& tool, const LoadFeeds& feeds, stock::Material& material) {
  LoadFeedSetter(section, tool, feeds, material).set();
}

namespace {

constexpr double kStepsPerRadius = 8;
/// Degrees. A link with less engagement touches nothing.
constexpr double kTouching = 1;
/// mm. Material thinner than this is due to rounding.
constexpr double kResidual = 1e-3;

/// Divides a move into equal steps and returns the slow ones among them.
std::vector<bool> slow_steps(const Move& move, double radius, int cutter, Radians limit,
                             const stock::Material& material) {
  const int count = std::max(1, static_cast<int>(std::ceil(move.path.length() * kStepsPerRadius / radius)));
  std::vector<bool> slow;
  Move raised = move;
  raised.z_from += kResidual;
  raised.z_to += kResidual;
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count;
    slow.push_back(material.engagement(raised, t, radius - kResidual, cutter).angle > limit.radians());
  }
  // One step more on both sides, because the engagement rises before the sample at which it is measured.
  std::vector<bool> wide = slow;
  for (std::size_t i = 0; i < slow.size(); ++i) {
    if (!slow[i]) continue;
    if (i > 0) wide[i - 1] = true;
    if (i + 1 < slow.size()) wide[i + 1] = true;
  }
  return wide;
}

void append_by_speed(const Move& move, const std::vector<bool>& slow, MmPerMin slot_feed,
                     std::vector<Move>& out) {
  const double count = static_cast<double>(slow.size());
  for (std::size_t i = 0; i < slow.size();) {
    std::size_t end = i + 1;
    while (end < slow.size() && slow[end] == slow[i]) ++end;
    Move piece = move;
    const bool whole = i == 0 && end == slow.size();
    if (!whole) piece.path = move.path.part(static_cast<double>(i) / count, static_cast<double>(end) / count);
    if (i == 0) piece.path.from = move.path.from;
    if (i > 0) piece.path.from = out.back().path.to;
    if (end == slow.size()) piece.path.to = move.path.to;
    if (slow[i]) piece.feed = slot_feed;
    out.push_back(piece);
    i = end;
  }
}

}  // namespace

void slow_down_slots(Section& section, const Tool& tool, const SlowFeeds& feeds, stock::Material& material) {
  // For this tool, its own passes count with its whole circle; for other tools, with the volume removed by its
  // profile.
  const double radius = tool.radius();
  const int cutter = material.add_cutter(inner_profile(tool), radius);
  std::vector<Move> moves;
  const auto append = [&](const Move& move, Radians limit, MmPerMin feed, std::vector<Move>& out) {
    if (feed < move.feed) {
      append_by_speed(move, slow_steps(move, radius, cutter, limit, material), feed, out);
    } else {
      out.push_back(move);
    }
  };
  for (const Move& move : section.moves) {
    if (is_rapid(move.kind) || move.is_vertical() || move.z_from != move.z_to) {
      moves.push_back(move);
    } else if (move.kind == MoveKind::kLink) {
      std::vector<Move> pieces;
      append(move, Radians::of_degrees(kTouching), feeds.cut_feed, pieces);
      for (const Move& piece : pieces) append(piece, feeds.limit, feeds.slot_feed, moves);
    } else {
      append(move, feeds.limit, feeds.slot_feed, moves);
    }
    if (is_rapid(move.kind)) continue;
    if (cutter == stock::Material::kCylinder) {
      material.add(move, radius);
    } else {
      material.add_sweep(move, cutter);
    }
  }
  section.moves = std::move(moves);
}

}  // namespace clearcut::link
