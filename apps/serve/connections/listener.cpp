#include "serve/connections/listener.h"

namespace clearcut::serve {
namespace {

constexpr std::size_t kThreads = 160;  // more than those who follow plans and those who wait for a check

/// A thread out of memory during a request drops only this connection.
class Threads : public httplib::TaskQueue {
 public:
  explicit Threads(WaitingConnections& waiting) : waiting_(waiting) {}

  void enqueue(std::function<void()> action) override {
    waiting_.opened();
    pool_.enqueue([this, action = std::move(action)] {
      try {
        action();
      } catch (const std::exception&) {  // there is no client left to inform
      }
      waiting_.closed();
    });
  }
  void shutdown() override { pool_.shutdown(); }

 private:
  WaitingConnections& waiting_;
  httplib::ThreadPool pool_{kThreads};
};

}  // namespace

Listener::Listener() : waiting_(kThreads) {
  new_task_queue = [this] { return new Threads(waiting_); };
}

void Listener::end() {
  stop();
  waiting_.give_up_all();
}

/// One request per connection: the rest of a refused one is never read as another.
bool Listener::process_and_close_socket(socket_t socket) {
  Connection connection(socket, waiting_);
  bool is_closed = false;
  return process_request(connection, true, is_closed, [&](httplib::Request&) { connection.end_head(); });
}

}  // namespace clearcut::serve
