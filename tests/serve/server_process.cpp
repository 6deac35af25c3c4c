#include "serve/server_process.h"

#include <arpa/inet.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace clearcut::test_support {
namespace {

/// "http://127.0.0.1:41873/"
int port_in(const std::string& line) {
  const auto colon = line.rfind(':');
  if (!line.starts_with("http://127.0.0.1:")) throw std::runtime_error("no address: " + line);
  return std::stoi(line.substr(colon + 1));
}

std::string first_line(int stream) {
  std::string line;
  for (char c = 0; ::read(stream, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

}  // namespace

ServerProcess::ServerProcess(const std::vector<std::string>& options) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  std::vector<std::string> words{CLEARCUT_COMMAND, "serve", "--port", "0"};
  words.insert(words.end(), options.begin(), options.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  process_ = ::fork();
  if (process_ == 0) {
    ::setenv("TMPDIR", temporary_.path("").c_str(), 1);
    ::dup2(ends[1], 1);
    ::close(ends[0]);
    ::close(ends[1]);
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  const std::string line = first_line(ends[0]);
  ::close(ends[0]);
  port_ = port_in(line);
}

ServerProcess::~ServerProcess() {
  if (process_ > 0) end(SIGTERM);
}

httplib::Client ServerProcess::client() const {
  httplib::Client client("127.0.0.1", port_);
  client.set_read_timeout(120);
  return client;
}

int ServerProcess::end(int signal) {
  int status = 0;
  ::kill(process_, signal);
  ::waitpid(process_, &status, 0);
  process_ = -1;
  return status;
}

std::size_t ServerProcess::files_of_plans() const {
  std::size_t count = 0;
  std::error_code vanished;
  for (auto at = std::filesystem::recursive_directory_iterator(temporary_.path(""), vanished);
       at != std::filesystem::recursive_directory_iterator(); at.increment(vanished)) {
    if (at->is_regular_file(vanished) && at->path().filename() != "options.json") ++count;
  }
  return count;
}

httplib::MultipartFormDataItems form_of(const std::string& part_name, const std::string& part,
                                        const std::string& options) {
  return {{"part", part, part_name, "application/octet-stream"}, {"options", options, "", ""}};
}

std::string posted(const ServerProcess& server, const httplib::MultipartFormDataItems& form,
                   const std::string& path) {
  auto client = server.client();
  const auto answer = client.Post(path, form);
  if (!answer || answer->status != 202) throw std::runtime_error(answer ? answer->body : "no answer");
  return nlohmann::json::parse(answer->body).at("id");
}

std::string fetched(const ServerProcess& server, const std::string& path) {
  auto client = server.client();
  const auto answer = client.Get(path);
  return answer && answer->status == 200 ? answer->body : "no answer to " + path;
}

nlohmann::json state_at_end(const ServerProcess& server, const std::string& id) {
  auto client = server.client();
  const auto events = client.Get("/plan/" + id + "/events");
  if (!events || events->status != 200) throw std::runtime_error("no events of " + id);
  nlohmann::json state;
  std::istringstream lines(events->body);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("data: ")) state = nlohmann::json::parse(line.substr(6));
  }
  return state;
}

std::string answer_to(int port, const std::string& bytes, bool ends) {
  const int connection = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(connection, reinterpret_cast<sockaddr*>(&place), sizeof place) != 0)
    throw std::runtime_error("no connection");
  [[maybe_unused]] const auto sent = ::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (ends) ::shutdown(connection, SHUT_WR);
  std::string answer;
  std::array<char, 4096> buffer{};
  for (ssize_t got = 0; (got = ::recv(connection, buffer.data(), buffer.size(), 0)) > 0;)
    answer.append(buffer.data(), static_cast<std::size_t>(got));
  ::close(connection);
  return answer;
}

}  // namespace clearcut::test_support
