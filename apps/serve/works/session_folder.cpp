#include "serve/works/session_folder.h"

#include <clearcut/error.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <thread>

namespace clearcut::serve {
namespace {

namespace fs = std::filesystem;

/// A child being killed may still write: repeats until the folder is removed, or two seconds have passed.
void remove_whole(const std::string& folder) {
  constexpr int kTries = 20;
  std::error_code failed;
  for (int i = 0; i < kTries; ++i) {
    fs::remove_all(folder, failed);
    if (!fs::exists(folder, failed)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

/// Reads until the other end is closed by the end of its process.
[[noreturn]] void remove_at_end(int closed, const std::string& folder) {
  setsid();  // Ctrl-C is for the server
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_IGN);
  const int nothing = open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) dup2(nothing, stream);
  char byte = 0;
  while (read(closed, &byte, 1) < 0 && errno == EINTR) {
  }
  remove_whole(folder);
  _exit(0);
}

}  // namespace

struct SessionFolder::Watch {
  int alive = -1;  ///< closed at any end of this process
  pid_t remover = -1;
};

SessionFolder::SessionFolder() : watch_(std::make_unique<Watch>()) {
  std::string pattern = (fs::temp_directory_path() / "clearcut-serve-XXXXXX").string();
  std::array<int, 2> ends{};
  if (mkdtemp(pattern.data()) == nullptr || pipe2(ends.data(), O_CLOEXEC) != 0)
    throw InputError("the folder for temporary files", "cannot be used; set TMPDIR to one that has room");
  path_ = pattern;
  watch_->remover = fork();
  if (watch_->remover == 0) {
    close(ends[1]);
    remove_at_end(ends[0], path_);
  }
  close(ends[0]);
  watch_->alive = ends[1];
}

SessionFolder::~SessionFolder() {
  remove_whole(path_);
  close(watch_->alive);
  if (watch_->remover > 0) waitpid(watch_->remover, nullptr, 0);
}

}  // namespace clearcut::serve
