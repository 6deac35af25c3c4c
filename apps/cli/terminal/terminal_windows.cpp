// Stands in for terminal.cpp on Windows: Ctrl-C, Ctrl-Break and the end of the console arrive on a thread of their own.
#include <windows.h>

#include <atomic>
#include <string_view>

#include "terminal/terminal.h"

namespace clearcut::cli {
namespace {

/// As a shell reports the end by Ctrl-C.
constexpr int kInterrupted = 130;

bool is_console(DWORD stream) {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(stream), &mode) != 0;
}

std::atomic<int> holders = 0;
std::atomic<bool> caught = false;

[[noreturn]] void end_interrupted() {
  const std::string_view text =
      errors_are_for_terminal() ? "\r\x1b[Kclearcut: stopped\n" : "clearcut: stopped\n";
  DWORD written = 0;
  WriteFile(GetStdHandle(STD_ERROR_HANDLE), text.data(), static_cast<DWORD>(text.size()), &written, nullptr);
  ExitProcess(kInterrupted);
}

BOOL WINAPI interrupted(DWORD) {
  if (holders == 0) end_interrupted();
  caught = true;
  return TRUE;
}

}  // namespace

bool output_is_terminal() {
  return is_console(STD_OUTPUT_HANDLE);
}

bool errors_are_for_terminal() {
  return is_console(STD_ERROR_HANDLE);
}

std::optional<std::size_t> terminal_columns() {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  if (GetConsoleScreenBufferInfo(GetStdHandle(STD_OUTPUT_HANDLE), &info) == 0) return std::nullopt;
  const int columns = info.srWindow.Right - info.srWindow.Left + 1;
  return columns > 0 ? std::optional(static_cast<std::size_t>(columns)) : std::nullopt;
}

void say_when_interrupted() {
  SetConsoleCtrlHandler(interrupted, TRUE);
}

struct SignalsHeld::Before {};

SignalsHeld::SignalsHeld() : earlier_(0) {
  ++holders;
}

SignalsHeld::~SignalsHeld() {
  if (--holders == 0 && caught) end_interrupted();
}

bool SignalsHeld::any() {
  return caught;
}

}  // namespace clearcut::cli
