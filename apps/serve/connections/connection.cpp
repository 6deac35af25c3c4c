#include "serve/connections/connection.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace clearcut::serve {
namespace {

constexpr std::chrono::seconds kLongestSilence{10};
constexpr std::chrono::seconds kLongestHead{10};

/// Whether `socket` allows one of `events` before `end`.
bool is_ready(int socket, short events, Clock::time_point end) {
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd one{socket, events, 0};
    const int ready = ::poll(&one, 1, static_cast<int>(std::max<decltype(left)>(left, 0)));
    if (ready >= 0) return ready > 0;
    if (errno != EINTR) return false;
  }
}

}  // namespace

void WaitingConnections::opened() {
  const std::lock_guard lock(mutex_);
  ++open_;
  make_room();
}

void WaitingConnections::closed() {
  const std::lock_guard lock(mutex_);
  --open_;
}

bool WaitingConnections::wait(int socket, short events, Clock::time_point began, Clock::time_point end) {
  if (is_ready(socket, events, Clock::now())) return true;
  const Entry entry{began, socket};
  {
    const std::lock_guard lock(mutex_);
    waiting_.insert(entry);
    make_room();
  }
  const bool ready = is_ready(socket, events, end);
  const std::lock_guard lock(mutex_);
  return waiting_.erase(entry) > 0 && ready;
}

void WaitingConnections::make_room() {
  if (open_ <= most_ || waiting_.empty()) return;
  ::shutdown(waiting_.begin()->second, SHUT_RDWR);  // ends the wait; the waiting thread closes it
  waiting_.erase(waiting_.begin());
}

void WaitingConnections::give_up_all() {
  const std::lock_guard lock(mutex_);
  for (const auto& [began, socket] : waiting_) ::shutdown(socket, SHUT_RDWR);
  waiting_.clear();
}

Connection::Connection(int socket, WaitingConnections& waiting) : socket_(socket), waiting_(waiting) {}

Connection::~Connection() {
  ::shutdown(socket_, SHUT_RDWR);
  ::close(socket_);
}

bool Connection::is_readable() const {
  return next_ < filled_ || is_ready(socket_, POLLIN, Clock::now());
}

/// Called before every part of a long answer: nothing is sent to a client that has closed its connection.
bool Connection::is_writable() const {
  char next = 0;
  if (::recv(socket_, &next, 1, MSG_PEEK | MSG_DONTWAIT) == 0) return false;
  return waiting_.wait(socket_, POLLOUT, began_, Clock::now() + kLongestSilence);
}

ssize_t Connection::receive(char* data, std::size_t size) {
  auto end = Clock::now() + kLongestSilence;
  if (!head_has_come_) end = std::min(end, began_ + kLongestHead);
  if (Clock::now() > end || !waiting_.wait(socket_, POLLIN, began_, end)) return -1;
  return ::recv(socket_, data, size, MSG_DONTWAIT);
}

ssize_t Connection::read(char* data, std::size_t size) {
  if (next_ == filled_) {
    if (size >= buffer_.size()) return receive(data, size);
    const ssize_t came = receive(buffer_.data(), buffer_.size());
    if (came <= 0) return came;
    next_ = 0;
    filled_ = static_cast<std::size_t>(came);
  }
  const std::size_t taken = std::min(size, filled_ - next_);
  std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(next_), taken, data);
  next_ += taken;
  return static_cast<ssize_t>(taken);
}

ssize_t Connection::write(const char* data, std::size_t size) {
  if (!waiting_.wait(socket_, POLLOUT, began_, Clock::now() + kLongestSilence)) return -1;
  return ::send(socket_, data, size, MSG_DONTWAIT | MSG_NOSIGNAL);
}

/// Addresses of clients are neither checked nor kept.
void Connection::get_remote_ip_and_port(std::string& ip, int& port) const {
  ip.clear();
  port = 0;
}

void Connection::get_local_ip_and_port(std::string& ip, int& port) const {
  ip.clear();
  port = 0;
}

}  // namespace clearcut::serve
