// clearcut serve: passes its settings to the server, a separate program beside this one.
#include <clearcut/error.h>
#include <clearcut/programs.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "commands/commands.h"
#include "process/own_process.h"

namespace clearcut::cli {
namespace {

struct ServeCommand {
  int port = 8080;
  std::string listen = "127.0.0.1";
  std::vector<std::string> hosts;
  int jobs = 0;
  double seconds = 600;
  double megabytes = 0;
  double upload_megabytes = 32;
  double keep_minutes = 15;
};

constexpr double kMegabyte = 1 << 20;
constexpr double kMinute = 60;

std::string settings_json(const ServeCommand& command, const std::string& self) {
  return nlohmann::json{{"command", self},
                        {"port", command.port},
                        {"listen", command.listen},
                        {"hosts", command.hosts},
                        {"jobs", command.jobs},
                        {"seconds", command.seconds},
                        {"bytes", static_cast<std::uint64_t>(command.megabytes * kMegabyte)},
                        {"upload", static_cast<std::uint64_t>(command.upload_megabytes * kMegabyte)},
                        {"keep_seconds", command.keep_minutes * kMinute}}
      .dump();
}

/// Does not return.
void serve(const ServeCommand& command) {
  process::replace_by(companion("clearcut-serve"), {"clearcut-serve", settings_json(command, own_program())});
  throw InputError("serve", "this build has no server; install libcpp-httplib-dev and build again");
}

void add_limits(CLI::App& command, ServeCommand& state) {
  command.option_defaults()->group("Limits");
  command
      .add_option("--jobs", state.jobs, "Plans and checks that run at once; others wait (default: all cores)")
      ->check(CLI::PositiveNumber);
  command.add_option("--plan-time", state.seconds, "Longest time for one plan or check, s (default 600)")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--plan-memory", state.megabytes,
                  "Most memory for one plan or check, MB (default: the machine's by the number of jobs)")
      ->check(CLI::PositiveNumber);
  command.add_option("--upload", state.upload_megabytes, "Largest request, MB (default 32)")
      ->check(CLI::Range(0.001, 4096.0));
  command.add_option("--keep", state.keep_minutes, "Minutes for which results are kept (default 15)")
      ->check(CLI::PositiveNumber);
}

}  // namespace

void add_serve_command(CLI::App& app, int& /*exit_code*/) {
  auto* command = app.add_subcommand("serve", "Plan and check in a browser, and for other programs (HTTP)");
  command->group("Planning");
  auto state = std::make_shared<ServeCommand>();
  command->option_defaults()->group("Network");
  command->add_option("--port", state->port, "Port to listen on; 0: any free port (default 8080)")
      ->check(CLI::Range(0, 65535));
  command->add_option(
      "--listen", state->listen,
      "Address to listen on (default 127.0.0.1, which other machines cannot reach; 0.0.0.0: all)");
  command->add_option("--host", state->hosts,
                      "Further host name under which browsers may call the server (repeatable)");
  add_limits(*command, *state);
  command->callback([state] { serve(*state); });
}

}  // namespace clearcut::cli
