// Stands in for own_process.cpp on Windows.
#include <clearcut/error.h>
#include <clearcut/programs.h>
#include <stdlib.h>
#include <windows.h>
// After windows.h, whose types it uses.
#include <bcrypt.h>

#include <filesystem>

#include "process/own_process.h"
#include "process/windows_job.h"

namespace clearcut::process {

HANDLE new_job(std::uint64_t bytes) {
  const HANDLE job = CreateJobObjectW(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  if (bytes > 0) limits.BasicLimitInformation.LimitFlags |= JOB_OBJECT_LIMIT_PROCESS_MEMORY;
  limits.ProcessMemoryLimit = bytes;
  SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
  return job;
}

/// No process of Windows becomes another: this one waits for it, and ends as it does. Ctrl-C is for the other.
void replace_by(const std::string& program, const std::vector<std::string>& words) {
  namespace fs = std::filesystem;
  STARTUPINFOW start{};
  start.cb = sizeof start;
  std::wstring line = fs::path(command_line(words)).wstring();
  const Handle job(new_job(0));
  PROCESS_INFORMATION made{};
  SetConsoleCtrlHandler(nullptr, FALSE);
  if (!CreateProcessW(fs::path(program).c_str(), line.data(), nullptr, nullptr, TRUE, CREATE_SUSPENDED,
                      nullptr, nullptr, &start, &made))
    return;
  SetConsoleCtrlHandler([](DWORD) -> BOOL { return TRUE; }, TRUE);
  AssignProcessToJobObject(job.get(), made.hProcess);
  ResumeThread(made.hThread);
  WaitForSingleObject(made.hProcess, INFINITE);
  DWORD code = 1;
  GetExitCodeProcess(made.hProcess, &code);
  ExitProcess(code);
}

std::uint64_t memory_share(int jobs) {
  MEMORYSTATUSEX memory{};
  memory.dwLength = sizeof memory;
  GlobalMemoryStatusEx(&memory);
  return memory.ullTotalPhys / static_cast<std::uint64_t>(jobs);
}

void set_variable(const char* name, const std::string& value) {
  _putenv_s(name, value.c_str());
}

void fill_randomly(std::span<unsigned char> bytes) {
  if (BCryptGenRandom(nullptr, bytes.data(), static_cast<ULONG>(bytes.size()),
                      BCRYPT_USE_SYSTEM_PREFERRED_RNG) != 0)
    throw InternalError("no random numbers");
}

}  // namespace clearcut::process
