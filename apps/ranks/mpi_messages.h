// What clearcut-mpi.so offers: the one file that holds MPI. The command loads it where `--mpi` is given, so that it runs without MPI
// installed.
#pragma once

#include <cstddef>

extern "C" {

/// Functions return false where MPI reports an error.
struct ClearcutMpi {
  int version;  ///< of this struct, kClearcutMpiVersion
  /// Joins the job; `here`: processes on this machine.
  bool (*join)(int* number, int* count, int* here);
  /// Keeps a copy of the bytes until they are gone; does not wait for that.
  bool (*send)(int to, const char* bytes, std::size_t size);
  /// Whether there is a message, from whom, and how long it is; does not wait for one.
  bool (*probe)(bool* is_there, int* from, std::size_t* size);
  /// Takes the message that `probe` told of.
  bool (*take)(int from, char* bytes, std::size_t size);
  bool (*leave)();
};

/// Never null.
const ClearcutMpi* clearcut_mpi();
}

constexpr int kClearcutMpiVersion = 1;
constexpr const char* kClearcutMpiFunction = "clearcut_mpi";
