// Stands in for mpi_ranks.cpp on Windows.
#include <clearcut/error.h>

#include "ranks/ranks.h"

namespace clearcut::ranks {

std::unique_ptr<Ranks> mpi_ranks() {
  throw InputError("--mpi", "is not in Clearcut for Windows; divide the parts with --share, or use Linux");
}

}  // namespace clearcut::ranks
