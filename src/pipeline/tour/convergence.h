// Decrease of the best value of a search.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/tour/tour.h"

namespace clearcut::pipeline {

/// Keeps the values better than all earlier ones, and passes each on. Of more than kMost every second one is kept, of
/// twice as many every fourth, and so on, and always the first and the last.
class Convergence {
 public:
  static constexpr std::size_t kMost = 1000;

  /// `improved` may be empty.
  explicit Convergence(std::function<void(const TourSample&)> improved) : improved_(std::move(improved)) {}

  void add(const TourSample& sample) {
    if (last_ && sample.best >= last_->best) return;
    last_ = sample;
    if (count_++ % stride_ == 0) {
      if (samples_.size() == kEven) leave_out_every_other();
      samples_.push_back(sample);
    }
    if (improved_) improved_(sample);
  }
  std::vector<TourSample> take() {
    if (last_ && last_->best < samples_.back().best) samples_.push_back(*last_);
    return std::move(samples_);
  }

 private:
  /// Even, so that a count of kEven strides is also one of the next stride; with room for the last value.
  static constexpr std::size_t kEven = kMost - 2;

  void leave_out_every_other() {
    for (std::size_t i = 0; 2 * i < samples_.size(); ++i) samples_[i] = samples_[2 * i];
    samples_.resize(samples_.size() / 2);
    stride_ *= 2;
  }

  std::function<void(const TourSample&)> improved_;
  std::vector<TourSample> samples_;
  std::optional<TourSample> last_;
  std::size_t count_ = 0, stride_ = 1;
};

}  // namespace clearcut::pipeline
