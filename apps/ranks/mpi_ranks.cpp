#include <clearcut/error.h>
#include <clearcut/programs.h>
#include <dlfcn.h>
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "ranks/mpi_messages.h"
#include "ranks/ranks.h"

namespace clearcut::ranks {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& what) {
  throw InputError("--mpi", what);
}

/// clearcut-mpi.so beside the command, at its build place, or at its installed place.
const ClearcutMpi& loaded() {
  const fs::path folder = fs::path(own_program()).parent_path();
  for (const fs::path& file :
       {folder / "clearcut-mpi.so", folder.parent_path() / "lib" / "clearcut" / "clearcut-mpi.so"}) {
    if (!fs::exists(file)) continue;
    // MPI loads further parts, which search its functions among those of the whole program.
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (library == nullptr) refuse(fmt::format("{} cannot be loaded: {}", file.string(), dlerror()));
    const auto function = reinterpret_cast<decltype(&clearcut_mpi)>(dlsym(library, kClearcutMpiFunction));
    if (function == nullptr || function()->version != kClearcutMpiVersion)
      refuse(file.string() + " belongs to another version of clearcut; install both anew");
    return *function();
  }
  refuse(
      "this installation has no MPI; install the package clearcut-mpi, or libopenmpi-dev and openmpi-bin and "
      "build again");
}

class MpiRanks : public Ranks {
 public:
  MpiRanks() : mpi_(loaded()) {
    if (!mpi_.join(&number_, &count_, &here_)) refuse("MPI does not start; try `mpirun -n 2 hostname`");
  }

  int number() const override { return number_; }
  int count() const override { return count_; }
  int here() const override { return here_; }

  void send(int to, const std::string& text) override { mpi_.send(to, text.data(), text.size()); }

  std::optional<Message> receive() override {
    bool is_there = false;
    std::size_t size = 0;
    Message message;
    if (!mpi_.probe(&is_there, &message.from, &size) || !is_there) return std::nullopt;
    message.text.resize(size);
    if (!mpi_.take(message.from, message.text.data(), size)) return std::nullopt;
    return message;
  }

  void leave(double seconds, int exit_code) override {
    std::fflush(nullptr);
    std::thread([seconds, exit_code] {
      std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
      std::_Exit(exit_code);
    }).detach();
    mpi_.leave();
  }

 private:
  const ClearcutMpi& mpi_;
  int number_ = 0, count_ = 1, here_ = 1;
};

}  // namespace

std::unique_ptr<Ranks> mpi_ranks() {
  return std::make_unique<MpiRanks>();
}

}  // namespace clearcut::ranks
