#include "serve/works/work_list.h"

#include <clearcut/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "process/child_process.h"
#include "process/own_process.h"
#include "serve/works/result_files.h"

namespace clearcut::serve {
namespace {

using process::ChildEnd;
constexpr auto kTalkEvery = std::chrono::milliseconds(100);
constexpr auto kHouseEvery = std::chrono::seconds(2);

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

/// Outcome, for the interface, of a child that did not end by itself.
WorkEnd broken_end(const ChildEnd& child, const Settings& settings) {
  WorkEnd end;
  end.state = WorkState::kFailed;
  if (child.how == ChildEnd::How::kStopped) {
    end.state = WorkState::kCancelled;
    end.message = "cancelled";
  } else if (child.how == ChildEnd::How::kTimedOut) {
    end.message = fmt::format("took more than {:g} s, the most that this server allows", settings.seconds);
  } else {
    end.message =
        fmt::format("broke down (signal {}); it may need more memory than this server allows", child.code);
  }
  return end;
}

/// Addresses of the existing results.
Json results_of(const Work& work) {
  Json results = Json::object();
  for (const std::string& name : results_in(work.folder / "results"))
    results[name] = "/plan/" + work.id + "/" + name;
  return results;
}

}  // namespace

std::string new_id() {
  std::array<unsigned char, 16> bytes{};
  process::fill_randomly(bytes);
  std::string id;
  for (const unsigned char byte : bytes) id += fmt::format("{:02x}", byte);
  return id;
}

WorkList::WorkList(const Settings& settings) : settings_(settings) {
  for (int i = 0; i < settings.jobs; ++i) threads_.emplace_back([this] { work_on(); });
  threads_.emplace_back([this] { keep_house(); });
}

WorkList::~WorkList() {
  stop();
  threads_.clear();
}

bool WorkList::has_room() const {
  const std::lock_guard lock(mutex_);
  return !is_stopped_ && waiting_.size() < settings_.most_waiting;
}

void WorkList::add(const WorkPtr& work, bool is_kept) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(work);
  if (is_kept) kept_[work->id] = work;
  forget_old();
  changed_.notify_all();
}

WorkPtr WorkList::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = kept_.find(id);
  return found == kept_.end() ? nullptr : found->second;
}

bool WorkList::drop(const std::string& id) {
  WorkPtr work;
  const std::lock_guard lock(mutex_);
  const auto found = kept_.find(id);
  if (found == kept_.end()) return false;
  work = found->second;
  kept_.erase(found);
  work->is_cancelled = true;
  if (std::erase(waiting_, work) > 0) {
    work->state = WorkState::kCancelled;
    work->ended = Clock::now();
  }
  ++work->version;
  changed_.notify_all();
  return true;
}

bool WorkList::is_ended(const Work& work) const {
  return work.state != WorkState::kWaiting && work.state != WorkState::kRunning;
}

Json WorkList::status_locked(const Work& work) const {
  Json json{{"id", work.id}, {"state", name_of(work.state)}};
  if (work.state == WorkState::kWaiting) {
    const auto place =
        std::find_if(waiting_.begin(), waiting_.end(), [&](const auto& one) { return one.get() == &work; });
    json["ahead"] = place - waiting_.begin();
  }
  if (!work.progress.is_null()) json["progress"] = work.progress;
  if (work.state != WorkState::kWaiting && work.state != WorkState::kCancelled)
    json["seconds"] =
        seconds_between(work.began, work.state == WorkState::kRunning ? Clock::now() : work.ended);
  if (is_ended(work)) {
    json["exit_code"] = work.end.exit_code;
    if (work.end.state == WorkState::kDone) json["verdict"] = work.end.verdict;
    if (!work.end.message.empty()) json["message"] = work.end.message;
    json["messages"] = work.messages;
    json["results"] = results_of(work);
  }
  return json;
}

Json WorkList::status(const WorkPtr& work) const {
  const std::lock_guard lock(mutex_);
  return status_locked(*work);
}

std::optional<Json> WorkList::next_status(const WorkPtr& work, unsigned& seen, double seconds) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                    [&] { return is_stopped_ || work->version != seen; });
  if (work->version == seen) return std::nullopt;
  seen = work->version;
  return status_locked(*work);
}

void WorkList::wait(const WorkPtr& work) const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return is_stopped_ || is_ended(*work); });
}

void WorkList::stop() {
  const std::lock_guard lock(mutex_);
  is_stopped_ = true;
  for (const auto& work : running_) work->is_cancelled = true;
  waiting_.clear();
  kept_.clear();
  changed_.notify_all();
}

bool WorkList::is_stopped() const {
  const std::lock_guard lock(mutex_);
  return is_stopped_;
}

void WorkList::work_on() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return is_stopped_ || !waiting_.empty(); });
    if (is_stopped_) return;
    const WorkPtr work = waiting_.front();
    waiting_.pop_front();
    running_.push_back(work);
    work->state = WorkState::kRunning;
    work->began = Clock::now();
    ++work->version;
    for (const auto& one : waiting_) ++one->version;  // moved up
    changed_.notify_all();
    lock.unlock();
    run(work);
    lock.lock();
    std::erase(running_, work);
  }
}

/// Takes a child's output since the last call.
void WorkList::listen(Work& work, ChildTalk& talk) {
  const std::lock_guard lock(mutex_);
  const Json before = work.progress;
  talk.read(work.progress, work.messages);
  if (work.progress == before) return;
  ++work.version;
  changed_.notify_all();
}

/// The command in a process of its own, watched.
WorkEnd WorkList::end_of_child(Work& work) {
  std::vector<std::string> words{settings_.command};
  words.insert(words.end(), work.words.begin(), work.words.end());
  const std::filesystem::path results = work.folder / "results";
  const process::ChildPlace place{(results / "log.txt").string(), (results / "text.txt").string(),
                                  work.folder.string(), true};
  ChildTalk talk(place.log);
  auto heard = Clock::now();
  const ChildEnd child =
      process::run_child(words, place, {settings_.seconds, settings_.bytes, settings_.file_bytes}, [&] {
        if (Clock::now() - heard >= kTalkEvery) {
          heard = Clock::now();
          listen(work, talk);
        }
        return !work.is_cancelled;
      });
  listen(work, talk);
  if (child.how != ChildEnd::How::kExited) return broken_end(child, settings_);
  return end_of(work, child.code);
}

void WorkList::run(const WorkPtr& work) {
  WorkEnd end;
  try {
    end = end_of_child(*work);
  } catch (const std::exception& error) {
    end.state = WorkState::kFailed;
    end.message = error.what();
  }
  const std::lock_guard lock(mutex_);
  work->end = end;
  work->state = end.state;
  work->ended = Clock::now();
  ++work->version;
  changed_.notify_all();
}

void WorkList::keep_house() {
  std::unique_lock lock(mutex_);
  while (!is_stopped_) {
    changed_.wait_for(lock, kHouseEvery, [&] { return is_stopped_; });
    forget_old();
  }
}

/// Under the mutex.
void WorkList::forget_old() {
  const auto now = Clock::now();
  std::erase_if(kept_, [&](const auto& one) {
    return is_ended(*one.second) && seconds_between(one.second->ended, now) > settings_.keep_seconds;
  });
  while (kept_.size() > settings_.most_kept) {
    auto oldest = kept_.end();
    for (auto one = kept_.begin(); one != kept_.end(); ++one) {
      if (is_ended(*one->second) && (oldest == kept_.end() || one->second->ended < oldest->second->ended))
        oldest = one;
    }
    if (oldest == kept_.end()) return;
    kept_.erase(oldest);
  }
}

}  // namespace clearcut::serve
