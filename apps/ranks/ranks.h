// Processes started together by mpirun or Slurm, and messages between them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace clearcut::ranks {

struct Message {
  int from = 0;  ///< number of the sending process
  std::string text;
};

/// This process among those started with it. Only `leave` waits for other processes.
class Ranks {
 public:
  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  virtual ~Ranks() = default;

  virtual int number() const = 0;  ///< number of this process, from 0
  virtual int count() const = 0;   ///< number of all processes
  virtual int here() const = 0;    ///< number of processes on this machine
  /// The text is being sent when this returns; it is lost if the other process has ended.
  virtual void send(int to, const std::string& text) = 0;
  /// The next message, if there is one.
  virtual std::optional<Message> receive() = 0;
  /// The last call. Waits for this call on the other ranks. Some may have died: after `seconds` the whole process
  /// ends, with `exit_code`.
  virtual void leave(double seconds, int exit_code) = 0;
};

/// The processes of an MPI job; a process started by itself is one of one. Throws InputError if this installation has
/// no MPI.
std::unique_ptr<Ranks> mpi_ranks();

/// Several texts as one, and back. Throws InputError for text not written by `pack`.
std::string pack(const std::vector<std::string>& texts);
std::vector<std::string> unpack(const std::string& packed);

}  // namespace clearcut::ranks
