#include "base/progress.h"

#include <mutex>
#include <utility>

namespace clearcut::inline base {
namespace {

std::mutex mutex;
std::function<void(const std::string&, double)> listener;

}  // namespace

ProgressListener::ProgressListener(std::function<void(const std::string&, double)> hear) {
  const std::lock_guard lock(mutex);
  listener = std::move(hear);
}

ProgressListener::~ProgressListener() {
  const std::lock_guard lock(mutex);
  listener = nullptr;
}

void report_progress(const std::string& what, double share) {
  const std::lock_guard lock(mutex);
  if (listener) listener(what, share);
}

}  // namespace clearcut::inline base
