// A client's connection: its input and output, and the server's limits of waiting.
#pragma once

#include <array>
#include <mutex>
#include <set>
#include <utility>

#include "serve/connections/socket.h"
#include "serve/works/work.h"

namespace clearcut::serve {

/// The connections waiting for their clients to send or receive data. While more connections are open than can be
/// served at a time, the oldest waiting ones are closed. May be used from several threads.
class WaitingConnections {
 public:
  /// `most`: number of connections served at a time.
  explicit WaitingConnections(std::size_t most) : most_(most) {}
  void opened();
  void closed();
  /// Waits until `socket` is ready, at most until `end`. False if it is not or was closed.
  bool wait(socket_t socket, Direction direction, Clock::time_point began, Clock::time_point end);
  void give_up_all();

 private:
  using Entry = std::pair<Clock::time_point, socket_t>;  ///< when the connection began, its socket
  /// Closes the oldest waiting connection if room is needed.
  void make_room();

  std::mutex mutex_;
  std::size_t most_;
  std::size_t open_ = 0;  ///< connections being served or waiting
  std::set<Entry> waiting_;
};

/// One accepted socket, closed with this object. Neither side may be silent for long, and all headers of the request
/// must arrive within `kLongestHead`, at any pace.
class Connection : public httplib::Stream {
 public:
  Connection(socket_t socket, WaitingConnections& waiting);
  ~Connection() override;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// The headers have arrived; the rest may take longer.
  void end_head() { head_has_come_ = true; }

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* data, std::size_t size) override;
  ssize_t write(const char* data, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return socket_; }

 private:
  /// Receives from the socket into `data`; 0 at the end, -1 if no data arrived in time.
  ssize_t receive(char* data, std::size_t size);

  socket_t socket_;
  WaitingConnections& waiting_;
  Clock::time_point began_ = Clock::now();
  bool head_has_come_ = false;
  std::array<char, 4096> buffer_{};  ///< the library reads headers letter by letter
  std::size_t next_ = 0, filled_ = 0;
};

}  // namespace clearcut::serve
