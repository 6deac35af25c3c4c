// Interface of clearcut-mpi.so, the only file with MPI. The command loads it if `--mpi` is given, so that it runs
// without MPI installed.
#pragma once

#include <cstddef>

extern "C" {

/// Functions return false if MPI reports an error.
struct ClearcutMpi {
  int version;  ///< version of this struct, kClearcutMpiVersion
  /// Joins the job; `here`: processes on this machine.
  bool (*join)(int* number, int* count, int* here);
  /// Keeps a copy of the bytes until they are sent; does not wait for this.
  bool (*send)(int to, const char* bytes, std::size_t size);
  /// Whether there is a message, its sender and its length; does not wait for one.
  bool (*probe)(bool* is_there, int* from, std::size_t* size);
  /// Takes the message found by `probe`.
  bool (*take)(int from, char* bytes, std::size_t size);
  bool (*leave)();
};

/// Never null.
const ClearcutMpi* clearcut_mpi();
}

constexpr int kClearcutMpiVersion = 1;
constexpr const char* kClearcutMpiFunction = "clearcut_mpi";
