// A client's connection: what comes and goes, and how long the server waits for it.
#pragma once

#include <httplib.h>

#include <array>
#include <mutex>
#include <set>
#include <utility>

#include "serve/works/work.h"

namespace clearcut::serve {

/// The connections whose clients have to send or take something before the server can go on. While more connections are open than
/// can be served at a time, the oldest of those that wait are given up. May be used from several threads.
class WaitingConnections {
 public:
  /// `most`: connections that can be served at a time.
  explicit WaitingConnections(std::size_t most) : most_(most) {}
  void opened();
  void closed();
  /// Waits until `socket` allows `events` (POLLIN, POLLOUT), at most until `end`. False where it does not or was given up.
  bool wait(int socket, short events, Clock::time_point began, Clock::time_point end);
  void give_up_all();

 private:
  using Entry = std::pair<Clock::time_point, int>;  ///< when the connection began, its socket
  /// Gives up the connection that began first among those that wait now, where one has to make room.
  void make_room();

  std::mutex mutex_;
  std::size_t most_;
  std::size_t open_ = 0;  ///< those being served and those that wait to be
  std::set<Entry> waiting_;
};

/// One accepted socket, closed with this object. Neither side may be silent for long, and all headers of the request have to come
/// within `kLongestHead`, whatever the pace.
class Connection : public httplib::Stream {
 public:
  Connection(int socket, WaitingConnections& waiting);
  ~Connection() override;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// The headers have come; what follows may take longer.
  void end_head() { head_has_come_ = true; }

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* data, std::size_t size) override;
  ssize_t write(const char* data, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return socket_; }

 private:
  /// Of the socket, into `data`; 0 at the end, -1 where nothing came in time.
  ssize_t receive(char* data, std::size_t size);

  int socket_;
  WaitingConnections& waiting_;
  Clock::time_point began_ = Clock::now();
  bool head_has_come_ = false;
  std::array<char, 4096> buffer_{};  ///< the library reads headers letter by letter
  std::size_t next_ = 0, filled_ = 0;
};

}  // namespace clearcut::serve
