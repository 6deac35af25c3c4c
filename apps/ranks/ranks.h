// Processes that mpirun or Slurm started together, and messages between them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace clearcut::ranks {

struct Message {
  int from = 0;  ///< number of the process that sent it
  std::string text;
};

/// This process among those that were started with it. Nothing here waits for another process but `leave`.
class Ranks {
 public:
  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  virtual ~Ranks() = default;

  virtual int number() const = 0;  ///< of this process, from 0
  virtual int count() const = 0;   ///< of all processes
  virtual int here() const = 0;    ///< how many of them run on this machine
  /// The text is on its way when this returns, and lost where the other process has ended.
  virtual void send(int to, const std::string& text) = 0;
  /// The next message, where there is one.
  virtual std::optional<Message> receive() = 0;
  /// The last call. Waits for the others to come here too. Some may have died: after that time the whole process ends, with `exit_code`.
  virtual void leave(double seconds, int exit_code) = 0;
};

/// The processes of an MPI job; a process that was started alone is one of one. Throws InputError where this installation has no MPI.
std::unique_ptr<Ranks> mpi_ranks();

/// Several texts as one, and back. Throws InputError for what `pack` did not write.
std::string pack(const std::vector<std::string>& texts);
std::vector<std::string> unpack(const std::string& packed);

}  // namespace clearcut::ranks
