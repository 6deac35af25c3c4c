#include "serve/connections/socket.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace clearcut::serve {

void prepare_socket(socket_t /*socket*/) {}

bool is_ready(socket_t socket, Direction direction, std::chrono::milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (true) {
    const short events = direction == Direction::kInput ? POLLIN : POLLOUT;
    pollfd one{socket, events, 0};
    const int ready = ::poll(&one, 1, static_cast<int>(time.count()));
    if (ready >= 0) return ready > 0;
    if (errno != EINTR) return false;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    time = std::max(left, std::chrono::milliseconds(0));
  }
}

ssize_t receive_now(socket_t socket, char* data, std::size_t size) {
  return ::recv(socket, data, size, MSG_DONTWAIT);
}

ssize_t send_now(socket_t socket, const char* data, std::size_t size) {
  return ::send(socket, data, size, MSG_DONTWAIT | MSG_NOSIGNAL);
}

bool has_ended(socket_t socket) {
  char next = 0;
  return ::recv(socket, &next, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
}

void shut_socket(socket_t socket) {
  ::shutdown(socket, SHUT_RDWR);
}

void close_socket(socket_t socket) {
  ::close(socket);
}

}  // namespace clearcut::serve
