#include "plan/adaptive/clearing/step_pictures.h"

namespace clearcut::plan::adaptive {

void StepPictures::after(std::string_view step) {
  if (sink_ == nullptr) return;
  const auto moves = path_.moves();
  if (moves.size() <= drawn_) return;
  sink_->frame(step);
  for (const Edge& edge : legal_.edges()) draw(edge, "black");
  for (std::size_t i = 0; i < moves.size(); ++i) draw(moves[i], i < drawn_ ? "silver" : "steelblue");
  drawn_ = moves.size();
}

void StepPictures::draw(const Edge& edge, std::string_view color) {
  if (!edge.is_arc()) return sink_->line(edge.from.x, edge.from.y, edge.to.x, edge.to.y, color);
  sink_->arc(edge.from.x, edge.from.y, edge.to.x, edge.to.y, edge.center.x, edge.center.y,
             edge.turn == Turn::kCounterClockwise, color);
}

}  // namespace clearcut::plan::adaptive
