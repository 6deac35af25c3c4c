#include "pipeline/tour/engagement_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/elementary.h"
#include "base/units.h"
#include "geometry/route/legal_area.h"
#include "stock/material.h"

namespace clearcut::pipeline {
namespace {

struct Pixel {
  int x = 0, y = 0;
};

/// Bresenham's circle: every pixel once.
std::vector<Pixel> circle_pixels(int radius) {
  std::vector<Pixel> octant;
  for (int x = radius, y = 0, error = 1 - radius; x >= y; ++y) {
    octant.push_back({x, y});
    if (error >= 0) error -= 2 * --x;
    error += 2 * y + 3;
  }
  std::vector<Pixel> circle;
  for (const Pixel p : octant) {
    for (const Pixel q : {p, Pixel{p.y, p.x}}) {
      for (const int sx : {1, -1}) {
        for (const int sy : {1, -1}) circle.push_back({sx * q.x, sy * q.y});
      }
    }
  }
  const auto before = [](Pixel a, Pixel b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
  std::sort(circle.begin(), circle.end(), before);
  circle.erase(
      std::unique(circle.begin(), circle.end(), [](Pixel a, Pixel b) { return a.x == b.x && a.y == b.y; }),
      circle.end());
  return circle;
}

/// Bresenham's line without its first pixel.
template <typename F>
void line_pixels(Pixel from, Pixel to, F&& visit) {
  const int dx = std::abs(to.x - from.x), dy = -std::abs(to.y - from.y);
  const int sx = from.x < to.x ? 1 : -1, sy = from.y < to.y ? 1 : -1;
  for (int error = dx + dy; from.x != to.x || from.y != to.y;) {
    const int twice = 2 * error;
    if (twice >= dy) error += dy, from.x += sx;
    if (twice <= dx) error += dx, from.y += sy;
    visit(from);
  }
}

class RasterEngagement final : public EngagementModel {
 public:
  RasterEngagement(EngagementTask given, double accuracy) : EngagementModel(std::move(given)) {
    size_ = raster_pixel(task().radius, accuracy);
    const int radius = static_cast<int>(std::lround(task().radius / size_));
    circle_ = circle_pixels(radius);
    lag_ = static_cast<std::size_t>(std::ceil(std::sqrt(2.0 * radius)));
    for (const Pixel p : circle_) {
      if (spans_.empty() || spans_.back().y != p.y) spans_.push_back({p.x, p.x, p.y});
      spans_.back().high = std::max(spans_.back().high, p.x);
    }
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) fronts_[front_of(dx, dy)] = front({dx, dy});
    }
    draw_map();
  }

 protected:
  void plunge(Vec2 p) override {
    cleared_at_ = pixel_of(p);
    for (const Span& span : spans_) {
      for (int x = span.low; x <= span.high; ++x) clear(cleared_at_.x + x, cleared_at_.y + span.y);
    }
  }
  double cut(const std::vector<Vec2>& move) override {
    double sum = 0;
    std::size_t steps = 0;
    for (std::size_t i = 1; i < move.size(); ++i) {
      sample_along(move[i] - move[i - 1]);
      trail_.clear();
      cleared_at_ = pixel_of(move[i - 1]);
      line_pixels(pixel_of(move[i - 1]), pixel_of(move[i]), [&](Pixel at) { trail_.push_back(at); });
      for (std::size_t k = 0; k < trail_.size(); ++k) {
        sum += engaged(trail_[k]);
        if (k >= lag_) follow(trail_[k - lag_]);
      }
      for (std::size_t k = trail_.size() - std::min(lag_, trail_.size()); k < trail_.size(); ++k)
        follow(trail_[k]);
      steps += trail_.size();
    }
    return steps == 0 ? 0 : sum / static_cast<double>(steps);
  }
  std::size_t mark() const override { return cleared_.size(); }
  void back_to(std::size_t mark) override {
    for (; cleared_.size() > mark; cleared_.pop_back()) map_[cleared_.back()] = kMaterial;
  }

 private:
  static constexpr char kNothing = 0, kMaterial = 1, kStays = 2;  ///< the ternary map
  struct Span {
    int low = 0, high = 0, y = 0;
  };
  static std::size_t front_of(int dx, int dy) { return static_cast<std::size_t>(3 * (dy + 1) + dx + 1); }

  Pixel pixel_of(Vec2 p) const {
    return {static_cast<int>(std::lround((p.x - origin_.x) / size_)),
            static_cast<int>(std::lround((p.y - origin_.y) / size_))};
  }
  bool in_map(int x, int y) const { return x >= 0 && y >= 0 && x < columns_ && y < rows_; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }
  void draw_map() {
    Box where = box(task().target);
    for (const Vec2 p : task().points) where.add(p);
    where = where.grown(task().radius + 2 * size_);
    origin_ = where.min;
    columns_ = static_cast<int>(where.width() / size_) + 2;
    rows_ = static_cast<int>(where.height() / size_) + 2;
    map_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kStays);
    const LegalArea target(task().target);
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) {
        if (target.contains(origin_ + Vec2{x * size_, y * size_})) map_[index(x, y)] = kMaterial;
      }
    }
  }
  void sample_along(Vec2 direction) {
    leading_.clear();
    std::copy_if(circle_.begin(), circle_.end(), std::back_inserter(leading_), [&](Pixel p) {
      return dot(direction, {1.0 * p.x, 1.0 * p.y}) > 0;
    });
  }
  double engaged(Pixel at) const {
    const auto in = std::count_if(leading_.begin(), leading_.end(), [&](Pixel p) {
      return in_map(at.x + p.x, at.y + p.y) && map_[index(at.x + p.x, at.y + p.y)] == kMaterial;
    });
    return static_cast<double>(in) / static_cast<double>(std::max<std::size_t>(leading_.size(), 1));
  }
  /// Pixels of the disc not covered one `step` before.
  std::vector<Pixel> front(Pixel step) const {
    std::vector<Pixel> pixels;
    for (const Span& span : spans_) {
      for (int x = span.low; x <= span.high; ++x) {
        const auto before = std::find_if(spans_.begin(), spans_.end(),
                                         [&](const Span& other) { return other.y == span.y + step.y; });
        if (before == spans_.end() || x + step.x < before->low || x + step.x > before->high)
          pixels.push_back({x, span.y});
      }
    }
    return pixels;
  }
  /// Clears the disc at the pixel next to the one cleared last.
  void follow(Pixel at) {
    for (const Pixel p : fronts_[front_of(at.x - cleared_at_.x, at.y - cleared_at_.y)])
      clear(at.x + p.x, at.y + p.y);
    cleared_at_ = at;
  }
  void clear(int x, int y) {
    if (!in_map(x, y) || map_[index(x, y)] != kMaterial) return;
    map_[index(x, y)] = kNothing;
    cleared_.push_back(index(x, y));
  }

  double size_ = 1;  ///< size of a pixel, mm
  Vec2 origin_;
  int columns_ = 0, rows_ = 0;
  std::vector<char> map_;
  /// Steps by which clearing follows the cutter: at its sides the circle is parallel to the path for this many
  /// pixels, which the previous step would already have cleared.
  std::size_t lag_ = 0;
  std::vector<Pixel> circle_, leading_, trail_;
  std::vector<Span> spans_;
  std::array<std::vector<Pixel>, 9> fronts_;  ///< by the disc's step
  Pixel cleared_at_;                          ///< place of the last cleared disc
  std::vector<std::size_t> cleared_;
};

class ExactEngagement final : public EngagementModel {
 public:
  explicit ExactEngagement(EngagementTask given)
      : EngagementModel(std::move(given)), material_(box(task().target), 0, {task().radius}) {}

 protected:
  void plunge(Vec2 p) override { material_.add(flat(p, p), task().radius); }
  double cut(const std::vector<Vec2>& move) override {
    double sum = 0, length = 0;
    for (std::size_t i = 1; i < move.size(); ++i) {
      const double piece = distance(move[i - 1], move[i]);
      if (piece == 0) continue;
      const Move cutting = flat(move[i - 1], move[i]);
      const int samples = 1 + static_cast<int>(8 * piece / task().radius);
      for (int k = 0; k < samples; ++k) {
        const stock::CutterEngagement contact =
            material_.engagement(cutting, (k + 0.5) / samples, task().radius);
        sum += contact.angle / kPi * piece / samples;
      }
      length += piece;
      material_.add(cutting, task().radius);
    }
    return length == 0 ? 0 : sum / length;
  }
  std::size_t mark() const override { return material_.sweeps(); }
  void back_to(std::size_t mark) override { material_.forget_beyond(mark); }

 private:
  static Move flat(Vec2 from, Vec2 to) {
    return {Edge::line(from, to), -1, -1, MoveKind::kCut, MmPerMin::of(1000), 0};
  }
  stock::Material material_;
};

class Engagement final : public order::Objective {
 public:
  using Cost = double (*)(double);
  Engagement(double target, std::function<std::unique_ptr<EngagementModel>()> make, Cost cost)
      : target_(target), make_(std::move(make)), cost_(cost) {}
  std::string name() const override { return "engagement"; }
  std::string unit() const override { return ""; }
  bool path_dependent() const override { return true; }
  double path(const order::Moves& moves, std::span<const int> tour) const override {
    return path_value(moves)->of(tour);
  }
  std::unique_ptr<order::PathValue> path_value(const order::Moves& /*moves*/) const override {
    return std::make_unique<Value>(target_, make_(), cost_);
  }
  Linear linear() const override { return {.exact = false}; }

 private:
  struct Value final : order::PathValue {
    Value(double wanted, std::unique_ptr<EngagementModel> of_points, Cost of_deviation)
        : target(wanted), model(std::move(of_points)), cost(of_deviation) {}
    double of(std::span<const int> tour) override {
      double sum = 0;
      for (const double share : model->along(tour)) sum += cost(share - target);
      return sum;
    }
    double target;
    std::unique_ptr<EngagementModel> model;
    Cost cost;
  };
  double target_;
  std::function<std::unique_ptr<EngagementModel>()> make_;
  Cost cost_;
};

}  // namespace

/// Legal paths are costly to compute and needed repeatedly.
const std::vector<Vec2>& EngagementModel::bends(int a, int b) {
  const auto key = (static_cast<unsigned long long>(a) << 32U) | static_cast<unsigned>(b);
  const auto [known, is_new] = bends_.try_emplace(key);
  if (is_new) known->second = task_.way(a, b);
  return known->second;
}

std::vector<Vec2> EngagementModel::move_points(int a, int b) {
  std::vector<Vec2> points{task_.points[static_cast<std::size_t>(a)]};
  if (task_.way) {
    const auto& between = bends(a, b);
    points.insert(points.end(), between.begin(), between.end());
  }
  points.push_back(task_.points[static_cast<std::size_t>(b)]);
  return points;
}

const std::vector<double>& EngagementModel::along(std::span<const int> tour) {
  std::size_t alike = 0;
  while (alike < std::min(tour.size(), last_.size()) && tour[alike] == last_[alike]) ++alike;
  // Points 0 .. alike - 1 are as before, and with them the plunge and alike - 1 moves.
  if (alike < marks_.size()) {
    back_to(marks_[alike]);
    marks_.resize(alike);
  }
  engagement_.resize(alike == 0 ? 0 : alike - 1);
  for (std::size_t i = alike; i < tour.size(); ++i) {
    marks_.push_back(mark());
    if (i == 0) {
      plunge(task_.points[static_cast<std::size_t>(tour[0])]);
    } else {
      engagement_.push_back(cut(move_points(tour[i - 1], tour[i])));
    }
  }
  last_.assign(tour.begin(), tour.end());
  return engagement_;
}

double raster_pixel(double radius, double accuracy) {
  return accuracy * std::sqrt(2.0) * kPi * radius;  // accuracy = resolution / (sqrt 2 pi r)
}

std::unique_ptr<EngagementModel> raster_engagement(EngagementTask task, double accuracy) {
  return std::make_unique<RasterEngagement>(std::move(task), accuracy);
}

std::unique_ptr<EngagementModel> exact_engagement(EngagementTask task) {
  return std::make_unique<ExactEngagement>(std::move(task));
}

double engagement_target(std::optional<double> engagement_deg) {
  return engagement_deg ? *engagement_deg / 180 : 0.5;
}

double engagement_cost(double deviation) {
  return deviation <= 0 ? -deviation : base::expm1(5 * deviation);
}

double inverse_engagement_cost(double deviation) {
  constexpr double kLeast = 0.02;  // share of the circle: the accuracy of the raster model
  if (deviation > 0) return engagement_cost(deviation);
  return 1 - kLeast / std::max(-deviation, kLeast);
}

order::ObjectivePtr engagement_objective(double target,
                                         std::function<std::unique_ptr<EngagementModel>()> make,
                                         double (*cost)(double)) {
  return std::make_shared<Engagement>(target, std::move(make), cost);
}

}  // namespace clearcut::pipeline
