// Stands in for ending.cpp on Windows, where a job object limits memory and an event takes the place of signals.
#include <windows.h>

#include <atomic>

#include "process/windows_job.h"
#include "serve/ending.h"

namespace clearcut::serve {
namespace {

std::atomic<HANDLE> asked = nullptr;

BOOL WINAPI ask(DWORD) {
  SetEvent(asked);
  return TRUE;
}

}  // namespace

/// The job's handle stays open: the limit is this process' for good. Plans, which have limits of their own, leave the job.
void limit_memory() {
  constexpr SIZE_T kMost = SIZE_T{6} << 30;
  const HANDLE job = CreateJobObjectW(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags =
      JOB_OBJECT_LIMIT_PROCESS_MEMORY | JOB_OBJECT_LIMIT_SILENT_BREAKAWAY_OK;
  limits.ProcessMemoryLimit = kMost;
  SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
  AssignProcessToJobObject(job, GetCurrentProcess());
}

struct EndSignals::State {
  process::Handle event{CreateEventW(nullptr, TRUE, FALSE, nullptr)};
};

EndSignals::EndSignals() : state_(std::make_unique<State>()) {
  asked = state_->event.get();
  SetConsoleCtrlHandler(nullptr, FALSE);
  SetConsoleCtrlHandler(ask, TRUE);
}

EndSignals::~EndSignals() {
  SetConsoleCtrlHandler(ask, FALSE);
}

void EndSignals::wait() {
  WaitForSingleObject(state_->event.get(), INFINITE);
}

void EndSignals::release() {
  SetEvent(state_->event.get());
}

}  // namespace clearcut::serve
