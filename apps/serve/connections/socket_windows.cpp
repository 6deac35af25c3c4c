// Stands in for socket.cpp on Windows, whose sockets do not wait once they are told so.
#include "serve/connections/socket.h"

namespace clearcut::serve {

void prepare_socket(socket_t socket) {
  u_long on = 1;
  ioctlsocket(socket, static_cast<long>(FIONBIO), &on);
}

bool is_ready(socket_t socket, Direction direction, std::chrono::milliseconds time) {
  const SHORT events = direction == Direction::kInput ? POLLRDNORM : POLLWRNORM;
  WSAPOLLFD one{socket, events, 0};
  return WSAPoll(&one, 1, static_cast<int>(time.count())) > 0;
}

ssize_t receive_now(socket_t socket, char* data, std::size_t size) {
  return ::recv(socket, data, static_cast<int>(size), 0);
}

ssize_t send_now(socket_t socket, const char* data, std::size_t size) {
  return ::send(socket, data, static_cast<int>(size), 0);
}

bool has_ended(socket_t socket) {
  char next = 0;
  return ::recv(socket, &next, 1, MSG_PEEK) == 0;
}

void shut_socket(socket_t socket) {
  ::shutdown(socket, SD_BOTH);
}

void close_socket(socket_t socket) {
  ::closesocket(socket);
}

}  // namespace clearcut::serve
