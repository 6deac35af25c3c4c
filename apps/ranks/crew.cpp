#include "ranks/crew.h"

#include <algorithm>
#include <exception>

namespace clearcut::ranks {

Crew::Crew(Perform perform, int threads, int ahead) : perform_(std::move(perform)), most_(threads + ahead) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

Crew::~Crew() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
}

void Crew::give(const std::string& task, const std::string& input) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.emplace_back(task, input);
    in_hand_.insert(task);
  }
  changed_.notify_one();
}

int Crew::room() const {
  const std::lock_guard lock(mutex_);
  return std::max(0, most_ - static_cast<int>(in_hand_.size()) + static_cast<int>(results_.size()));
}

std::vector<std::string> Crew::in_hand() const {
  const std::lock_guard lock(mutex_);
  return {in_hand_.begin(), in_hand_.end()};
}

std::vector<std::pair<std::string, std::string>> Crew::take_results() {
  const std::lock_guard lock(mutex_);
  for (const auto& result : results_) in_hand_.erase(in_hand_.find(result.first));
  return std::exchange(results_, {});
}

std::string Crew::error() const {
  const std::lock_guard lock(mutex_);
  return error_;
}

void Crew::work() {
  for (;;) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stop_ || !waiting_.empty(); });
    if (stop_) return;
    const auto [task, input] = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    std::string result, error;
    try {
      result = perform_(task, input, stop_);
    } catch (const std::exception& exception) {
      error = exception.what();
    }
    lock.lock();
    if (error.empty())
      results_.emplace_back(task, std::move(result));
    else if (!stop_ && error_.empty())
      error_ = error;
  }
}

}  // namespace clearcut::ranks
