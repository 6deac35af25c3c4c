// What a user may ask of a plan. Absent values are taken from the part's operations, else from the documented
// defaults of prepare().
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/tolerances.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/part.h"
#include "model/post_options.h"
#include "model/shop_options.h"

namespace clearcut::resolve {

/// The Tour text's genetic algorithm; what is left out is as published.
struct PublishedSolver {
  std::optional<long long> generations;  ///< at most; absent: until 1000 bring no gain (4.3.3)
  std::optional<int> population;
  std::optional<std::string> selection, crossover, mutation;  ///< names of operators
  std::optional<double> crossover_rate, mutation_rate;
  std::optional<double> most_shared;  ///< share of edges above which two individuals are too similar
};

struct PlanOptions {
  std::vector<Tool> tools;                ///< replace the part's own; empty keeps those
  std::string strategy = "auto";          ///< a name of strategy_names()
  std::optional<std::string> stepover;    ///< "0.4" (fraction of the diameter), "lom", "rho", "3.5mm"
  std::optional<bool> bisector_passages;  ///< of contour methods; absent: those of the published ones
  std::optional<double> angle_deg;        ///< of zigzag lines against x; absent: the fastest found
  std::optional<double> stepdown;         ///< mm
  std::optional<double> allowance;        ///< mm, on walls
  std::optional<double> allowance_floor;
  std::optional<double> engagement_deg;
  std::optional<EntryKind> entry;
  std::optional<Radians> entry_angle;
  std::optional<double> lead;         ///< mm; radius or length of leads into passes along walls, 0: none
  std::optional<Radians> lead_angle;  ///< straight leads, at this angle to the pass; absent: arcs
  std::optional<double> scallop;      ///< mm; greatest step between layers on leaning walls
  ShopOptions shop;
  std::vector<PredrilledHole> predrilled;  ///< besides the part's own
  std::optional<Toolpath> earlier;         ///< a program that has run before on this stock
  std::optional<CutDirection> direction;
  bool outside_in = false;    ///< contours from the wall inwards; false: inside-out
  std::optional<Vec2> start;  ///< where the cutting of contours should begin, or adaptive clearing go down
  CuttingData cutting;
  Machine machine;
  PostOptions post;
  std::optional<PublishedSolver> published_solver;  ///< orders grids and elements' squares; absent: ours does
  bool published_grid = false;  ///< of the strategy tour: Tour eq. 4.8, and nothing else is cut
  std::string objective = "time";
  std::optional<double> time_s;  ///< longest search
  std::uint64_t seed = 1;
  int threads = 0;            ///< 0: all cores
  std::stop_token cancel;     ///< asked to stop, the plan ends with Cancelled within a second
  ProgressCallback progress;  ///< told after each candidate; may be empty
  Tolerances tol;
};

/// How many threads the options stand for: at least one, and no more than cores.
int thread_count(const PlanOptions& options);

/// "endmill:10[:T3][:flutes=2][:corner=0.5][:name=ROUGHER][:noplunge]". Throws InputError.
Tool parse_tool(const std::string& text);

/// "X,Y:D": a hole of diameter D at (X, Y), mm. Throws InputError.
PredrilledHole parse_predrilled(const std::string& text);

/// Checks that every option is in its sensible range; throws InputError naming the first that is not.
void check(const PlanOptions& options);

}  // namespace clearcut::resolve
