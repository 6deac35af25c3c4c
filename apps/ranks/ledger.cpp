#include "ranks/ledger.h"

#include <iterator>
#include <utility>

namespace clearcut::ranks {

Ledger::Ledger(std::vector<std::string> tasks, int ranks, double now)
    : last_heard_(static_cast<std::size_t>(ranks), now), is_silent_(static_cast<std::size_t>(ranks)) {
  for (std::string& task : tasks) {
    if (holders_.emplace(task, kNobody).second) waiting_.push_back(std::move(task));
  }
}

void Ledger::heard(int rank, const std::vector<std::string>& in_hand, double now) {
  last_heard_[static_cast<std::size_t>(rank)] = now;
  is_silent_[static_cast<std::size_t>(rank)] = false;
  for (const std::string& task : in_hand) {
    const auto held = holders_.find(task);
    if (held != holders_.end() && held->second == kNobody) held->second = rank;
  }
}

std::vector<std::string> Ledger::hand_out(int rank, int most) {
  std::vector<std::string> given;
  while (static_cast<int>(given.size()) < most && !waiting_.empty()) {
    const std::string task = std::move(waiting_.front());
    waiting_.pop_front();
    const auto held = holders_.find(task);
    if (held == holders_.end() || held->second != kNobody) continue;
    held->second = rank;
    given.push_back(task);
  }
  return given;
}

void Ledger::add(const std::vector<std::string>& tasks) {
  auto place = waiting_.begin();
  for (const std::string& task : tasks) {
    if (holders_.emplace(task, kNobody).second) place = std::next(waiting_.insert(place, task));
  }
}

bool Ledger::finish(const std::string& task) {
  return holders_.erase(task) > 0;
}

std::vector<int> Ledger::take_back(double since) {
  std::vector<int> silent;
  for (std::size_t rank = 0; rank < last_heard_.size(); ++rank) {
    if (is_silent_[rank] || last_heard_[rank] >= since) continue;
    is_silent_[rank] = true;
    silent.push_back(static_cast<int>(rank));
    for (auto& [task, holder] : holders_) {
      if (holder != static_cast<int>(rank)) continue;
      holder = kNobody;
      waiting_.push_front(task);
    }
  }
  return silent;
}

}  // namespace clearcut::ranks
