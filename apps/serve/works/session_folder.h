// The only folder in which the server stores files.
#pragma once

#include <sys/types.h>

#include <string>

namespace clearcut::serve {

/// A new folder not readable by other users. It is removed with this object, and also if this process is killed: a
/// separate process waits for this. Must be made before the first thread.
class SessionFolder {
 public:
  SessionFolder();
  ~SessionFolder();
  SessionFolder(const SessionFolder&) = delete;
  SessionFolder& operator=(const SessionFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int alive_ = -1;  ///< closed at any end of this process
  pid_t remover_ = -1;
};

}  // namespace clearcut::serve
