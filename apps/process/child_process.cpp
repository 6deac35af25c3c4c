#include "process/child_process.h"

#include <clearcut/error.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace clearcut::process {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kPollInterval = std::chrono::milliseconds(5);
constexpr int kNotStarted = 127;

/// In the child: only calls safe between fork and exec, as in all following functions.
void limit(decltype(RLIMIT_AS) resource, std::uint64_t most) {
  if (most == 0) return;
  const rlimit both{most, most};
  setrlimit(resource, &both);
}

void set_signals_back() {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPIPE, SIG_DFL);
}

bool connect_streams(const ChildPlace& place) {
  const int mode = O_WRONLY | O_CREAT | O_TRUNC;
  const int log = open(place.log.c_str(), mode, 0644);
  const int output = place.output.empty() ? log : open(place.output.c_str(), mode, 0644);
  const int nothing = open("/dev/null", O_RDONLY);
  return log >= 0 && output >= 0 && dup2(nothing, 0) >= 0 && dup2(output, 1) >= 0 && dup2(log, 2) >= 0;
}

[[noreturn]] void become(char* const* words, const ChildPlace& place, const ChildLimits& limits,
                         pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // its parent has ended
  if (getppid() != parent) _exit(kNotStarted);
  if (place.is_apart) setpgid(0, 0);
  set_signals_back();
  if (!connect_streams(place)) _exit(kNotStarted);
  close_range(3, ~0U, 0);  // connections of others
  if (!place.folder.empty() && chdir(place.folder.c_str()) != 0) _exit(kNotStarted);
  if (kLimitsMemory) limit(RLIMIT_AS, limits.bytes);
  limit(RLIMIT_FSIZE, limits.file_bytes);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  execv(words[0], words);
  _exit(kNotStarted);
}

ChildEnd end_of(int status) {
  if (WIFSIGNALED(status)) return {ChildEnd::How::kSignalled, WTERMSIG(status)};
  return {ChildEnd::How::kExited, WEXITSTATUS(status)};
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& words, const ChildPlace& place, const ChildLimits& limits,
                   const std::function<bool()>& goes_on) {
  std::vector<char*> pointers;
  for (const auto& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  const pid_t self = getpid();
  const pid_t child = fork();
  if (child < 0) throw InputError("a process", "cannot be started; let fewer run at once");
  if (child == 0) become(pointers.data(), place, limits, self);
  if (place.is_apart) setpgid(child, child);  // whichever of the two is first

  const auto began = Clock::now();
  bool timed_out = false, stopped = false;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(kPollInterval);
    if (timed_out || stopped) continue;
    stopped = goes_on && !goes_on();
    timed_out = !stopped && limits.seconds > 0 &&
                std::chrono::duration<double>(Clock::now() - began).count() > limits.seconds;
    if (timed_out || stopped) kill(place.is_apart ? -child : child, SIGKILL);
  }
  if (stopped) return {ChildEnd::How::kStopped, 0};
  return timed_out ? ChildEnd{ChildEnd::How::kTimedOut, 0} : end_of(status);
}

}  // namespace clearcut::process
