// All plans and checks of the session: a queue, so many at once, and results for a while.
#pragma once

#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "serve/settings.h"
#include "serve/works/work.h"

namespace clearcut::serve {

using WorkPtr = std::shared_ptr<Work>;

class WorkList {
 public:
  explicit WorkList(const Settings& settings);
  /// Ends all running work.
  ~WorkList();
  WorkList(const WorkList&) = delete;
  WorkList& operator=(const WorkList&) = delete;

  /// Whether another may join.
  bool has_room() const;
  /// Queues the work; its folder is removed with its last owner. `is_kept`: the work can be found by its name
  /// afterwards.
  void add(const WorkPtr& work, bool is_kept);
  /// Null if there is none, or it is gone.
  WorkPtr find(const std::string& id) const;
  /// Stops the work if running, and forgets it. False if there is none.
  bool drop(const std::string& id);

  /// The state in the form of the interface.
  Json status(const WorkPtr& work) const;
  /// The same once its version differs from `seen`, which is then updated; null after `seconds` without a change.
  std::optional<Json> next_status(const WorkPtr& work, unsigned& seen, double seconds) const;
  /// Waits for its end.
  void wait(const WorkPtr& work) const;
  /// Ends all work; all waiting calls return.
  void stop();
  bool is_stopped() const;

 private:
  void work_on();
  void run(const WorkPtr& work);
  WorkEnd end_of_child(Work& work);
  void listen(Work& work, ChildTalk& talk);
  void keep_house();
  void forget_old();
  bool is_ended(const Work& work) const;
  Json status_locked(const Work& work) const;

  const Settings& settings_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::deque<WorkPtr> waiting_;
  std::vector<WorkPtr> running_;
  std::map<std::string, WorkPtr> kept_;
  bool is_stopped_ = false;
  std::vector<std::jthread> threads_;
};

/// An unguessable name.
std::string new_id();

}  // namespace clearcut::serve
