#include "serve/connections/connection.h"

#include <algorithm>

namespace clearcut::serve {
namespace {

constexpr std::chrono::seconds kLongestSilence{10};
constexpr std::chrono::seconds kLongestHead{10};

/// The same until `end`.
bool is_ready_until(socket_t socket, Direction direction, Clock::time_point end) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
  return is_ready(socket, direction, std::max(left, std::chrono::milliseconds(0)));
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

bool WaitingConnections::wait(socket_t socket, Direction direction, Clock::time_point began,
                              Clock::time_point end) {
  if (is_ready_until(socket, direction, Clock::now())) return true;
  const Entry entry{began, socket};
  {
    const std::lock_guard lock(mutex_);
    waiting_.insert(entry);
    make_room();
  }
  const bool ready = is_ready_until(socket, direction, end);
  const std::lock_guard lock(mutex_);
  return waiting_.erase(entry) > 0 && ready;
}

void WaitingConnections::make_room() {
  if (open_ <= most_ || waiting_.empty()) return;
  shut_socket(waiting_.begin()->second);  // ends the wait; the waiting thread closes it
  waiting_.erase(waiting_.begin());
}

void WaitingConnections::give_up_all() {
  const std::lock_guard lock(mutex_);
  for (const auto& [began, socket] : waiting_) shut_socket(socket);
  waiting_.clear();
}

Connection::Connection(socket_t socket, WaitingConnections& waiting) : socket_(socket), waiting_(waiting) {
  prepare_socket(socket_);
}

Connection::~Connection() {
  shut_socket(socket_);
  close_socket(socket_);
}

bool Connection::is_readable() const {
  return next_ < filled_ || is_ready_until(socket_, Direction::kInput, Clock::now());
}

/// Called before every part of a long answer: nothing is sent to a client that has closed its connection.
bool Connection::is_writable() const {
  if (has_ended(socket_)) return false;
  return waiting_.wait(socket_, Direction::kOutput, began_, Clock::now() + kLongestSilence);
}

ssize_t Connection::receive(char* data, std::size_t size) {
  auto end = Clock::now() + kLongestSilence;
  if (!head_has_come_) end = std::min(end, began_ + kLongestHead);
  if (Clock::now() > end || !waiting_.wait(socket_, Direction::kInput, began_, end)) return -1;
  return receive_now(socket_, data, size);
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
  if (!waiting_.wait(socket_, Direction::kOutput, began_, Clock::now() + kLongestSilence)) return -1;
  return send_now(socket_, data, size);
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
