// The server itself: listens, admits permitted clients, and calls the routes.
#pragma once

#include "serve/connections/listener.h"
#include "serve/routes.h"

namespace clearcut::serve {

class Server {
 public:
  explicit Server(Service& service);
  /// Binds the port and returns it. Throws InputError if it is in use.
  int bind();
  /// Until stop().
  void run();
  /// From another thread.
  void stop();

 private:
  void guard();
  void add_routes();
  void limit();

  Service& service_;
  Listener server_;
};

}  // namespace clearcut::serve
