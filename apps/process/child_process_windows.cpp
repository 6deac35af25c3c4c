// Stands in for child_process.cpp on Windows: a job object limits the child's memory and ends it with its own children.
#include <clearcut/error.h>
#include <clearcut/programs.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <thread>

#include "process/child_process.h"
#include "process/windows_job.h"

namespace clearcut::process {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
constexpr DWORD kPollMilliseconds = 5;
/// Exit codes from here on are those of exceptions: access violations, stack overflows.
constexpr DWORD kFirstException = 0xC0000000;

HANDLE open_for_child(const wchar_t* name, DWORD access, DWORD disposition) {
  SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
  return CreateFileW(name, access, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, &inherited,
                     disposition, FILE_ATTRIBUTE_NORMAL, nullptr);
}

/// Its three streams, and the list of them: the child inherits no handle of another's.
class Streams {
 public:
  explicit Streams(const ChildPlace& place)
      : nothing_(open_for_child(L"NUL", GENERIC_READ, OPEN_EXISTING)),
        log_(open_for_child(fs::path(place.log).c_str(), GENERIC_WRITE, CREATE_ALWAYS)),
        output_(place.output.empty()
                    ? nullptr
                    : open_for_child(fs::path(place.output).c_str(), GENERIC_WRITE, CREATE_ALWAYS)) {
    const HANDLE output = place.output.empty() ? log_.get() : output_.get();
    start_.StartupInfo.cb = sizeof start_;
    start_.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
    start_.StartupInfo.hStdInput = nothing_.get();
    start_.StartupInfo.hStdOutput = output;
    start_.StartupInfo.hStdError = log_.get();
    inherited_ = {nothing_.get(), log_.get(), output};
    start_.lpAttributeList = reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(list_.data());
    SIZE_T size = list_.size();
    const SIZE_T count = output == log_.get() ? 2 : 3;
    InitializeProcThreadAttributeList(start_.lpAttributeList, 1, 0, &size);
    UpdateProcThreadAttribute(start_.lpAttributeList, 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, inherited_.data(),
                              count * sizeof(HANDLE), nullptr, nullptr);
  }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;
  ~Streams() { DeleteProcThreadAttributeList(start_.lpAttributeList); }

  bool are_open(const ChildPlace& place) const {
    return log_.is_open() && (place.output.empty() || output_.is_open());
  }
  STARTUPINFOW* start() { return &start_.StartupInfo; }

 private:
  Handle nothing_, log_, output_;
  std::array<HANDLE, 3> inherited_{};
  alignas(std::max_align_t) std::array<char, 256> list_{};
  STARTUPINFOEXW start_{};
};

PROCESS_INFORMATION started(const std::vector<std::string>& words, const ChildPlace& place) {
  Streams streams(place);
  std::wstring line = fs::path(command_line(words)).wstring();
  const fs::path folder(place.folder);
  PROCESS_INFORMATION made{};
  if (!streams.are_open(place) ||
      !CreateProcessW(fs::path(words.front()).c_str(), line.data(), nullptr, nullptr, TRUE,
                      CREATE_SUSPENDED | CREATE_NO_WINDOW | EXTENDED_STARTUPINFO_PRESENT, nullptr,
                      folder.empty() ? nullptr : folder.c_str(), streams.start(), &made))
    throw InputError("a process", "cannot be started; let fewer run at once");
  return made;
}

ChildEnd end_of(HANDLE process) {
  DWORD code = 1;
  GetExitCodeProcess(process, &code);
  const auto how = code >= kFirstException ? ChildEnd::How::kSignalled : ChildEnd::How::kExited;
  return {how, static_cast<int>(code)};
}

}  // namespace

ChildEnd run_child(const std::vector<std::string>& words, const ChildPlace& place, const ChildLimits& limits,
                   const std::function<bool()>& goes_on) {
  const Handle job(new_job(kLimitsMemory ? limits.bytes : 0));
  const PROCESS_INFORMATION made = started(words, place);
  const Handle process(made.hProcess), thread(made.hThread);
  AssignProcessToJobObject(job.get(), process.get());
  ResumeThread(thread.get());

  const auto began = Clock::now();
  bool timed_out = false, stopped = false;
  while (WaitForSingleObject(process.get(), kPollMilliseconds) == WAIT_TIMEOUT) {
    if (timed_out || stopped) continue;
    stopped = goes_on && !goes_on();
    timed_out = !stopped && limits.seconds > 0 &&
                std::chrono::duration<double>(Clock::now() - began).count() > limits.seconds;
    if (timed_out || stopped) TerminateJobObject(job.get(), kFirstException);
  }
  if (stopped) return {ChildEnd::How::kStopped, 0};
  return timed_out ? ChildEnd{ChildEnd::How::kTimedOut, 0} : end_of(process.get());
}

}  // namespace clearcut::process
