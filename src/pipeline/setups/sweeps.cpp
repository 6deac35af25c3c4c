#include "pipeline/setups/solid_stock.h"

namespace clearcut::pipeline {
namespace {

bool follows(const Section& last, const Section& like, const Move& move) {
  return last.tool_number == like.tool_number && last.carried_below == like.carried_below &&
         last.is_of_stock == like.is_of_stock && last.moves.back().path.to == move.path.from &&
         last.moves.back().z_to == move.z_from;
}

}  // namespace

void Sweeps::add(const Section& like, const Move& move) {
  if (out_.sections.empty() || !follows(out_.sections.back(), like, move)) {
    Section& section = out_.sections.emplace_back();
    section.label = like.label;
    section.tool_number = like.tool_number;
    section.spindle_rpm = like.spindle_rpm;
    section.spindle_clockwise = like.spindle_clockwise;
    section.carried_below = like.carried_below;
    section.is_of_stock = like.is_of_stock;
  }
  out_.sections.back().moves.push_back(move);
}

void Sweeps::append(Toolpath other) {
  for (Section& section : other.sections) out_.sections.push_back(std::move(section));
}

}  // namespace clearcut::pipeline
