#define OMPI_SKIP_MPICXX 1
#include "ranks/mpi_messages.h"

#include <mpi.h>

#include <list>
#include <string>

namespace {

constexpr int kTag = 1;

struct Sent {
  std::string bytes;
  MPI_Request request{};
};

/// A list, because MPI holds on to the bytes' address.
std::list<Sent>& on_their_way() {
  static std::list<Sent> all;
  return all;
}

void forget_what_arrived() {
  on_their_way().remove_if([](Sent& sent) {
    int done = 0;
    return MPI_Test(&sent.request, &done, MPI_STATUS_IGNORE) != MPI_SUCCESS || done != 0;
  });
}

bool join(int* number, int* count, int* here) {
  int given = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given) != MPI_SUCCESS) return false;
  // The death of another process is an error to report, not the end of this one.
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  MPI_Comm machine{};
  return MPI_Comm_rank(MPI_COMM_WORLD, number) == MPI_SUCCESS &&
         MPI_Comm_size(MPI_COMM_WORLD, count) == MPI_SUCCESS &&
         MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, *number, MPI_INFO_NULL, &machine) ==
             MPI_SUCCESS &&
         MPI_Comm_size(machine, here) == MPI_SUCCESS && MPI_Comm_free(&machine) == MPI_SUCCESS;
}

bool send(int to, const char* bytes, std::size_t size) {
  forget_what_arrived();
  Sent& sent = on_their_way().emplace_back(Sent{{bytes, size}, {}});
  const bool is_sent = MPI_Isend(sent.bytes.data(), static_cast<int>(size), MPI_BYTE, to, kTag,
                                 MPI_COMM_WORLD, &sent.request) == MPI_SUCCESS;
  if (!is_sent) on_their_way().pop_back();
  return is_sent;
}

bool probe(bool* is_there, int* from, std::size_t* size) {
  forget_what_arrived();
  int found = 0, bytes = 0;
  MPI_Status status{};
  if (MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &found, &status) != MPI_SUCCESS) return false;
  *is_there = found != 0;
  if (found == 0) return true;
  *from = status.MPI_SOURCE;
  if (MPI_Get_count(&status, MPI_BYTE, &bytes) != MPI_SUCCESS) return false;
  *size = static_cast<std::size_t>(bytes);
  return true;
}

bool take(int from, char* bytes, std::size_t size) {
  return MPI_Recv(bytes, static_cast<int>(size), MPI_BYTE, from, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE) ==
         MPI_SUCCESS;
}

bool leave() {
  return MPI_Finalize() == MPI_SUCCESS;
}

}  // namespace

extern "C" const ClearcutMpi* clearcut_mpi() {
  static const ClearcutMpi functions{kClearcutMpiVersion, join, send, probe, take, leave};
  return &functions;
}
