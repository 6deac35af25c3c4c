// One plan or check: request, progress, and result.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace clearcut::serve {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

enum class WorkState : unsigned char { kWaiting, kRunning, kDone, kFailed, kCancelled };

std::string name_of(WorkState state);

/// Its outcome, as read from its folder.
struct WorkEnd {
  WorkState state = WorkState::kDone;
  int exit_code = 0;
  std::string verdict;  ///< verdict of the certificate; "" if there is none
  std::string message;  ///< one line: why there is no result
};

/// Everything but `folder`, `words` and `is_cancelled` is guarded by the list's mutex.
struct Work {
  std::string id;
  /// Files of the request and results/; the folder around it is removed in the end.
  std::filesystem::path folder;
  std::vector<std::string> words;
  bool has_verdict = true;  ///< a certificate states the outcome
  std::atomic<bool> is_cancelled = false;

  WorkState state = WorkState::kWaiting;
  WorkEnd end;
  Json progress;                      ///< last reported: stage, done, most
  std::vector<std::string> messages;  ///< warnings and notes, in their order
  unsigned version = 0;               ///< counts changes
  Clock::time_point began, ended;

  Work(std::string name, std::filesystem::path place) : id(std::move(name)), folder(std::move(place)) {}
  ~Work();
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
};

/// Reads the child's standard error: lines of progress (JSON) and messages.
class ChildTalk {
 public:
  explicit ChildTalk(std::filesystem::path log) : log_(std::move(log)) {}
  /// Reads the output since the last call; only whole lines.
  void read(Json& progress, std::vector<std::string>& messages);

 private:
  std::filesystem::path log_;
  std::uintmax_t at_ = 0;
  std::string rest_;
};

/// Verdict and message of a work whose child ended with this code, from its folder.
WorkEnd end_of(const Work& work, int exit_code);

}  // namespace clearcut::serve
