// A server that runs while a test does, and what tests ask of it.
#pragma once

#include <httplib.h>
#include <sys/types.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "support/command.h"

namespace clearcut::test_support {

/// `clearcut serve` on a free port of this machine, with a folder for temporary files of its own. When it is let go the server has to
/// end well: one built with a sanitizer ends badly where memory leaked.
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
  /// Memory that the server itself holds; that of the commands that it runs is not counted.
  std::size_t resident_bytes() const;

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

/// A connection that stays open while a request comes in pieces.
class OpenRequest {
 public:
  OpenRequest(int port, const std::string& bytes);
  ~OpenRequest();
  OpenRequest(OpenRequest&& other) noexcept : connection_(std::exchange(other.connection_, -1)) {}
  OpenRequest& operator=(OpenRequest&&) = delete;
  /// False where the server has closed the connection.
  bool send(const std::string& bytes);
  /// Nothing more will come, which a server cannot always answer.
  void end();
  /// What the server answers until it closes the connection; throws if it does not within that time.
  std::string rest(std::chrono::seconds longest);

 private:
  int connection_ = -1;
};

}  // namespace clearcut::test_support
