// clearcut-serve: the program behind `clearcut serve`, which passes the settings as JSON.
#include <clearcut/error.h>
#include <clearcut/file.h>
#include <malloc.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>

#include <cstdio>
#include <thread>

#include "process/child_process.h"
#include "serve/server.h"
#include "serve/works/result_files.h"

namespace {

using namespace clearcut;
using namespace clearcut::serve;

constexpr int kUnusable = 2, kInternal = 3;

sigset_t signals_that_end() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&set, signal);
  return set;
}

/// Memory limit of this process for small requests; plans have their own limits.
void limit_memory() {
  constexpr rlim_t kMost = rlim_t{6} << 30;
  rlimit both{};
  getrlimit(RLIMIT_AS, &both);
  both.rlim_cur = std::min(kMost, both.rlim_max);
  setrlimit(RLIMIT_AS, &both);
  mallopt(M_ARENA_MAX, 4);
}

/// The options of plan and verify, from the command itself.
std::string options_of_command(const std::string& command, const SessionFolder& folder) {
  const std::string file = folder.path() + "/options.json";
  const auto end = process::run_child({command, "generate", "options"}, {file, "", "", false}, {60, 0, 0});
  if (end.how != process::ChildEnd::How::kExited || end.code != 0)
    throw InputError(command, "does not say its options; install clearcut and clearcut-serve together");
  return read_file(file);
}

void serve_with(const Settings& settings) {
  const SessionFolder folder;
  const sigset_t ending = signals_that_end();
  pthread_sigmask(SIG_BLOCK, &ending, nullptr);
  // For the commands run by the server: readable lines of progress, and tables of a page's width.
  setenv("CLEARCUT_PROGRESS", "json", 1);
  setenv("COLUMNS", "100", 1);
  setenv("NO_COLOR", "1", 1);
  Service service(settings, folder.path(), options_of_command(settings.command, folder));
  Server server(service);
  const int port = server.bind();
  std::thread ender([&] {
    int signal = 0;
    sigwait(&ending, &signal);
    server.stop();
  });
  const std::string host =
      settings.listen.find(':') == std::string::npos ? settings.listen : "[" + settings.listen + "]";
  std::printf("http://%s:%d/\n", host.c_str(), port);
  std::printf("Ctrl-C ends the server; nothing is kept.\n");
  std::fflush(stdout);
  server.run();
  pthread_kill(ender.native_handle(), SIGTERM);
  ender.join();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw InputError("clearcut-serve", "is run by `clearcut serve`; run that");
    if (process::kLimitsMemory) limit_memory();
    serve_with(settings_of(argv[1]));
    return 0;
  } catch (const InputError& error) {
    std::fprintf(stderr, "clearcut: %s\n", error.what());
    return kUnusable;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "clearcut: internal fault: %s\n", error.what());
    return kInternal;
  }
}
