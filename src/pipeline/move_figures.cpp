#include "pipeline/move_figures.h"

#include "verify/engagement/load.h"

namespace clearcut::pipeline {
namespace {

verify::CheckedProgram checked(const Part& part, const Toolpath& toolpath, const ControlTable& control,
                               const resolve::PlanOptions& options) {
  return verify::checked_program(part, toolpath, options.machine,
                                 options.earlier ? &*options.earlier : nullptr, &control);
}

MoveFigures figures_of(const verify::CheckedMove& move) {
  const verify::MoveLoad& load = move.load;
  const double mean = load.cutting_mm > 0 ? load.angle_mm_deg / load.cutting_mm : 0;
  return {move.time_s, load.max_deg, mean, load.cutting_mm, load.air_mm};
}

}  // namespace

std::vector<double> times_of_moves(const Part& part, const Toolpath& toolpath, const ControlTable& control,
                                   const resolve::PlanOptions& options) {
  std::vector<double> times;
  for (const verify::CheckedMove& move : checked(part, toolpath, control, options).moves) {
    if (!move.earlier) times.push_back(move.time_s);
  }
  return times;
}

std::vector<MoveFigures> figures_of_moves(const Part& part, const Toolpath& toolpath,
                                          const ControlTable& control, const resolve::PlanOptions& options) {
  verify::CheckedProgram program = checked(part, toolpath, control, options);
  verify::measure_load(part, program.moves, {options.tol, options.engagement_deg, {}, options.cancel});
  std::vector<MoveFigures> figures;
  for (const verify::CheckedMove& move : program.moves) {
    if (!move.earlier) figures.push_back(figures_of(move));
  }
  return figures;
}

}  // namespace clearcut::pipeline
