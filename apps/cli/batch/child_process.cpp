#include "batch/child_process.h"

#include <clearcut/error.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace clearcut::cli {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kLook = std::chrono::milliseconds(5);
constexpr int kNotStarted = 127;

/// In the child: nothing but system calls between fork and exec, because other threads may hold locks.
[[noreturn]] void become(char* const* words, const char* log_file, const ChildLimits& limits, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody waits for it any more
  if (getppid() != parent) _exit(kNotStarted);
  const int log = open(log_file, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (log < 0 || dup2(nothing, 0) < 0 || dup2(log, 1) < 0 || dup2(log, 2) < 0) _exit(kNotStarted);
  if (limits.bytes > 0) {
    const rlimit most{limits.bytes, limits.bytes};
    setrlimit(RLIMIT_AS, &most);
  }
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  execv(words[0], words);
  _exit(kNotStarted);
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& words, const std::string& log_file,
                   const ChildLimits& limits) {
  std::vector<char*> pointers;
  for (const auto& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  const pid_t self = getpid();
  const pid_t child = fork();
  if (child < 0) throw InputError("batch", "no process can be started; lower --jobs");
  if (child == 0) become(pointers.data(), log_file.c_str(), limits, self);

  const auto began = Clock::now();
  bool timed_out = false;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(kLook);
    if (timed_out || limits.seconds <= 0) continue;
    timed_out = std::chrono::duration<double>(Clock::now() - began).count() > limits.seconds;
    if (timed_out) kill(child, SIGKILL);
  }
  if (timed_out) return {ChildEnd::How::kTimedOut, 0};
  if (WIFSIGNALED(status)) return {ChildEnd::How::kSignalled, WTERMSIG(status)};
  return {ChildEnd::How::kExited, WEXITSTATUS(status)};
}

}  // namespace clearcut::cli
