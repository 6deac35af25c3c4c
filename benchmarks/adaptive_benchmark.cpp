// Adaptive clearing beside FreeCAD's: generation alone, moves, and nothing else (times of motion are the certificate's).
//
//   adaptive_benchmark SHAPES TABLE [RUNS]    SHAPES: folder with the outlines, TABLE: FreeCAD's figures, Markdown rows
//                                             | shape | strategy | D | step% | ... moves in column 9, seconds in the last;
//                                             freecad_adaptive.py makes it on this machine
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <sstream>
#include <string>
#include <vector>

#include "base/file.h"
#include "plan/adaptive/adaptive.h"
#include "plan/common/layers.h"
#include "read/outline/outline_reader.h"

namespace {

using namespace clearcut;

struct PeerRow {
  std::string shape;
  double diameter = 0;
  double stepover = 0;  ///< share of the diameter
  int moves = 0;
  double seconds = 0;
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, '|');) {
    const auto first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

std::vector<PeerRow> peer_rows(const std::string& table) {
  std::vector<PeerRow> rows;
  std::istringstream in(read_file(table));
  for (std::string line; std::getline(in, line);) {
    const auto cells = cells_of(line);
    if (cells.size() < 16 || cells[2] != "adaptive") continue;
    rows.push_back({cells[1], std::stod(cells[3]), std::stod(cells[4]) / 100, std::stoi(cells[9]),
                    std::stod(cells.back())});
  }
  return rows;
}

/// Seconds of this thread's work so far.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Measured {
  double seconds = 1e300;
  std::size_t moves = 0;
};

Measured measure(const Layer& layer, const plan::adaptive::AdaptiveOptions& options, int runs) {
  Measured result;
  for (int i = 0; i < runs; ++i) {
    const double start = cpu_seconds();
    const LayerPasses planned = plan::adaptive::plan_adaptive(layer, options, {});
    result.seconds = std::min(result.seconds, cpu_seconds() - start);
    result.moves = 0;
    for (const Pass& pass : planned.passes) result.moves += pass.path.size();
  }
  return result;
}

void run(const std::string& folder, const PeerRow& peer, int runs) {
  const std::string file = folder + "/" + peer.shape + ".json";
  const Part part = read::read_outline_json(read_file(file), file, Tolerances{});
  const Layer layer = plan::layers_of(part.features.at(0), Operation{}, peer.diameter / 2, {}).at(0);
  plan::adaptive::AdaptiveOptions options;
  options.engagement = Radians::of(std::acos(1 - 2 * peer.stepover));
  const Measured ours = measure(layer, options, runs);
  fmt::print("| {} | {} | {:.0f} | {:.1f} | {:.1f} | {:.1f} | {} | {} | {:.1f} |\n", peer.shape,
             peer.diameter, options.engagement.degrees(), 1e3 * ours.seconds, 1e3 * peer.seconds,
             peer.seconds / ours.seconds, ours.moves, peer.moves,
             static_cast<double>(peer.moves) / static_cast<double>(ours.moves));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "adaptive_benchmark SHAPES TABLE [RUNS]\n");
    return 2;
  }
  fmt::print(
      "| shape | D | limit | CPU ms | FreeCAD | x | moves | FreeCAD | x "
      "|\n|---|---|---|---|---|---|---|---|---|\n");
  for (const PeerRow& peer : peer_rows(argv[2])) run(argv[1], peer, argc > 3 ? std::atoi(argv[3]) : 5);
}
