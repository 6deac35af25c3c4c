// The one place where the server keeps files.
#pragma once

#include <sys/types.h>

#include <string>

namespace clearcut::serve {

/// A new folder that nobody else may read. It is removed with this object, and also where this process is killed: a process
/// of its own waits for that. To be made before the first thread.
class SessionFolder {
 public:
  SessionFolder();
  ~SessionFolder();
  SessionFolder(const SessionFolder&) = delete;
  SessionFolder& operator=(const SessionFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int alive_ = -1;  ///< closed when this process ends, however it ends
  pid_t remover_ = -1;
};

}  // namespace clearcut::serve
