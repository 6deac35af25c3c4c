// A server that runs while a test does, and what tests ask of it.
#pragma once

#include <httplib.h>
#include <sys/types.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "support/command.h"

namespace clearcut::test_support {

/// `clearcut serve` on a free port of this machine, with a folder for temporary files of its own.
class ServerProcess {
 public:
  explicit ServerProcess(const std::vector<std::string>& options = {});
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  int port() const { return port_; }
  httplib::Client client() const;
  /// Ends it by a signal; gives the status of waitpid.
  int end(int signal);
  /// Names in the folder for temporary files.
  std::vector<std::string> left_behind() const { return temporary_.names(); }
  std::size_t files_of_plans() const;

 private:
  ScratchFolder temporary_;
  pid_t process_ = -1;
  int port_ = 0;
};

/// A request's files and options.
httplib::MultipartFormDataItems form_of(const std::string& part_name, const std::string& part,
                                        const std::string& options);

/// The name of what a request begins. Throws where it is refused.
std::string posted(const ServerProcess& server, const httplib::MultipartFormDataItems& form,
                   const std::string& path = "/plan");

/// What lies at an address, or why nothing does.
std::string fetched(const ServerProcess& server, const std::string& path);

/// Waits until `holds`, at most ten seconds.
template <typename Condition>
bool soon(const Condition& holds) {
  for (int i = 0; i < 200; ++i) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return holds();
}

/// The state of a plan at its end; waits for it by events.
nlohmann::json state_at_end(const ServerProcess& server, const std::string& id);

/// What the server says to bytes that are sent as they are. `ends`: nothing more will come, which a server cannot always answer.
std::string answer_to(int port, const std::string& bytes, bool ends = false);

}  // namespace clearcut::test_support
