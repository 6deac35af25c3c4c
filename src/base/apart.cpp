#include "base/apart.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace clearcut::inline base {
namespace {

[[noreturn]] void give_up(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// An open file, closed at the end.
class File {
 public:
  File(int number, const char* what) : number_(number) {
    if (number_ < 0) give_up(what);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { close(); }

  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

/// A file in memory: a pipe would have to be written while the answer is read.
void fill(const File& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file.number(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) give_up("write");
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  if (lseek(file.number(), 0, SEEK_SET) != 0) give_up("lseek");
}

std::string read_all(int pipe) {
  std::string text;
  std::array<char, 65536> chunk{};
  for (;;) {
    const ssize_t got = ::read(pipe, chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(chunk.data(), static_cast<std::size_t>(got));
  }
}

/// Between fork and exec: only async-signal-safe calls.
[[noreturn]] void become(char* const* command, int input, int output, int nowhere, int seconds) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const auto limit = static_cast<rlim_t>(seconds);
  const rlimit time{limit, limit + 1};
  setrlimit(RLIMIT_CPU, &time);
  if (dup2(input, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 && dup2(nowhere, STDERR_FILENO) >= 0)
    execv(command[0], command);
  _exit(127);
}

}  // namespace

std::optional<std::string> done_apart(const std::vector<std::string>& command, std::string_view input,
                                      int seconds) {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const File given(memfd_create("input", MFD_CLOEXEC), "memfd_create");
  fill(given, input);
  const File nowhere(open("/dev/null", O_WRONLY | O_CLOEXEC), "/dev/null");
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) give_up("pipe");
  const File answer(ends[0], "pipe");
  File asked(ends[1], "pipe");
  const pid_t program = fork();
  if (program < 0) give_up("fork");
  if (program == 0) become(arguments.data(), given.number(), asked.number(), nowhere.number(), seconds);
  asked.close();
  std::string text = read_all(answer.number());
  int status = 0;
  while (waitpid(program, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return text;
}

}  // namespace clearcut::inline base
