// clearcut-serve: the program behind `clearcut serve`, which passes the settings as JSON.
#include <clearcut/error.h>
#include <clearcut/file.h>

#include <cstdio>
#include <thread>

#include "process/child_process.h"
#include "process/own_process.h"
#include "serve/ending.h"
#include "serve/server.h"
#include "serve/works/session_folder.h"

namespace {

using namespace clearcut;
using namespace clearcut::serve;

constexpr int kUnusable = 2, kInternal = 3;

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
  EndSignals signals;
  // For the commands run by the server: readable lines of progress, and tables of a page's width.
  process::set_variable("CLEARCUT_PROGRESS", "json");
  process::set_variable("COLUMNS", "100");
  process::set_variable("NO_COLOR", "1");
  Service service(settings, folder.path(), options_of_command(settings.command, folder));
  Server server(service);
  const int port = server.bind();
  std::thread ender([&] {
    signals.wait();
    server.stop();
  });
  const std::string host =
      settings.listen.find(':') == std::string::npos ? settings.listen : "[" + settings.listen + "]";
  std::printf("http://%s:%d/\n", host.c_str(), port);
  std::printf("Ctrl-C ends the server; nothing is kept.\n");
  std::fflush(stdout);
  server.run();
  signals.release();
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
