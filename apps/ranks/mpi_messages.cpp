#define OMPI_SKIP_MPICXX 1
#include "ranks/mpi_messages.h"

#include <mpi.h>

#include <algorithm>
#include <list>
#include <set>
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

/// A message being received. If its sender dies halfway the message stays here: waiting for it would never end.
struct Coming {
  int from = 0;
  std::string bytes;
  MPI_Request request{};
  bool has_arrived = false;
};

/// In the order of sending, for each sender. A list, because MPI keeps the bytes' addresses.
std::list<Coming>& on_their_way_here() {
  static std::list<Coming> all;
  return all;
}

/// Begins to receive the available messages.
bool begin_receiving() {
  for (;;) {
    int found = 0, bytes = 0;
    MPI_Message message{};
    MPI_Status status{};
    if (MPI_Improbe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &found, &message, &status) != MPI_SUCCESS)
      return false;
    if (found == 0) return true;
    if (MPI_Get_count(&status, MPI_BYTE, &bytes) != MPI_SUCCESS) return false;
    Coming& coming = on_their_way_here().emplace_back();
    coming.from = status.MPI_SOURCE;
    coming.bytes.resize(static_cast<std::size_t>(bytes));
    if (MPI_Imrecv(coming.bytes.data(), bytes, MPI_BYTE, &message, &coming.request) == MPI_SUCCESS) continue;
    on_their_way_here().pop_back();
    return false;
  }
}

bool has_arrived(Coming& coming) {
  int done = 0;
  if (!coming.has_arrived && MPI_Test(&coming.request, &done, MPI_STATUS_IGNORE) == MPI_SUCCESS)
    coming.has_arrived = done != 0;
  return coming.has_arrived;
}

/// The first complete message without an incomplete earlier one of the same sender; null if there is none.
Coming* first_arrived() {
  std::set<int> awaited;
  for (Coming& coming : on_their_way_here()) {
    if (awaited.contains(coming.from)) continue;
    if (has_arrived(coming)) return &coming;
    awaited.insert(coming.from);
  }
  return nullptr;
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
  const bool is_good = begin_receiving();
  const Coming* first = first_arrived();
  *is_there = first != nullptr;
  if (first == nullptr) return is_good;
  *from = first->from;
  *size = first->bytes.size();
  return true;
}

bool take(int from, char* bytes, std::size_t size) {
  auto& all = on_their_way_here();
  const auto found =
      std::find_if(all.begin(), all.end(), [from](const Coming& coming) { return coming.from == from; });
  if (found == all.end() || !found->has_arrived || found->bytes.size() != size) return false;
  std::copy(found->bytes.begin(), found->bytes.end(), bytes);
  all.erase(found);
  return true;
}

bool leave() {
  return MPI_Finalize() == MPI_SUCCESS;
}

}  // namespace

extern "C" const ClearcutMpi* clearcut_mpi() {
  static const ClearcutMpi functions{kClearcutMpiVersion, join, send, probe, take, leave};
  return &functions;
}
