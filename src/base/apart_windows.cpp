// Stands in for apart.cpp on Windows: pipes, and a job object that limits the processor time.
#include <windows.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <thread>

#include "base/apart.h"
#include "base/programs.h"

namespace clearcut::inline base {
namespace {

[[noreturn]] void give_up(const char* what) {
  throw std::system_error(static_cast<int>(GetLastError()), std::system_category(), what);
}

class Handle {
 public:
  explicit Handle(HANDLE handle = nullptr) : handle_(handle) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { close(); }

  HANDLE get() const { return handle_; }
  HANDLE* place() { return &handle_; }
  void close() {
    if (handle_ != nullptr && handle_ != INVALID_HANDLE_VALUE) CloseHandle(handle_);
    handle_ = nullptr;
  }

 private:
  HANDLE handle_;
};

/// The ends of two pipes: this program's, and the other's, which it inherits.
struct Pipes {
  Handle input, answer;         ///< here
  Handle given, asked, unused;  ///< there
};

void make_pipe(Handle& read, Handle& write, const Handle& inherited) {
  if (!CreatePipe(read.place(), write.place(), nullptr, 0) ||
      !SetHandleInformation(inherited.get(), HANDLE_FLAG_INHERIT, HANDLE_FLAG_INHERIT))
    give_up("pipe");
}

void open_pipes(Pipes& pipes) {
  make_pipe(pipes.given, pipes.input, pipes.given);
  make_pipe(pipes.answer, pipes.asked, pipes.asked);
  SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
  *pipes.unused.place() = CreateFileW(L"NUL", GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited,
                                      OPEN_EXISTING, 0, nullptr);
}

/// Ends its processes once the processor has worked for them that long, and with this object.
HANDLE limiting_job(int seconds) {
  constexpr LONGLONG kTicks = 10'000'000;  // of 100 ns
  const HANDLE job = CreateJobObjectW(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.PerProcessUserTimeLimit.QuadPart = seconds * kTicks;
  limits.BasicLimitInformation.LimitFlags =
      JOB_OBJECT_LIMIT_PROCESS_TIME | JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
  return job;
}

std::string read_all(HANDLE pipe) {
  std::string text;
  std::array<char, 65536> chunk{};
  DWORD got = 0;
  while (ReadFile(pipe, chunk.data(), static_cast<DWORD>(chunk.size()), &got, nullptr) && got > 0)
    text.append(chunk.data(), got);
  return text;
}

void write_all(HANDLE pipe, std::string_view text) {
  constexpr std::size_t kMost = 1 << 20;
  DWORD written = 0;
  while (!text.empty() &&
         WriteFile(pipe, text.data(), static_cast<DWORD>(std::min(text.size(), kMost)), &written, nullptr))
    text.remove_prefix(written);
}

}  // namespace

std::optional<std::string> done_apart(const std::vector<std::string>& command, std::string_view input,
                                      int seconds) {
  namespace fs = std::filesystem;
  Pipes pipes;
  open_pipes(pipes);
  const Handle job(limiting_job(seconds));
  STARTUPINFOW start{};
  start.cb = sizeof start;
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdInput = pipes.given.get();
  start.hStdOutput = pipes.asked.get();
  start.hStdError = pipes.unused.get();
  std::wstring line = fs::path(command_line(command)).wstring();
  PROCESS_INFORMATION made{};
  if (!CreateProcessW(fs::path(command.front()).c_str(), line.data(), nullptr, nullptr, TRUE,
                      CREATE_SUSPENDED | CREATE_NO_WINDOW, nullptr, nullptr, &start, &made))
    return std::nullopt;
  const Handle process(made.hProcess), thread(made.hThread);
  AssignProcessToJobObject(job.get(), process.get());
  ResumeThread(thread.get());
  pipes.given.close();
  pipes.asked.close();
  std::jthread giver([&] {
    write_all(pipes.input.get(), input);
    pipes.input.close();
  });
  std::string text = read_all(pipes.answer.get());
  WaitForSingleObject(process.get(), INFINITE);
  DWORD code = 1;
  if (!GetExitCodeProcess(process.get(), &code) || code != 0) return std::nullopt;
  return text;
}

}  // namespace clearcut::inline base
