#include "moves.h"

#include "interruptible.h"

namespace clearcut::python {

std::size_t Moves::size() const {
  std::size_t count = 0;
  for (const Section& section : toolpath_->sections) count += section.moves.size();
  return count;
}

py::array_t<double> Moves::times() {
  if (!times_) times_ = times_of_moves(*part_, *toolpath_, *control_, options_);
  return py::array_t<double>(static_cast<py::ssize_t>(times_->size()), times_->data());
}

py::array_t<double> Moves::engagement(double MoveFigures::*figure) {
  if (!figures_) {
    figures_ = interruptible(py::none(), [all = *this](std::stop_token cancel) {
      PlanOptions options = all.options_;
      options.cancel = std::move(cancel);
      return figures_of_moves(*all.part_, *all.toolpath_, *all.control_, options);
    });
  }
  py::array_t<double> array(static_cast<py::ssize_t>(figures_->size()));
  double* to = array.mutable_data();
  for (const MoveFigures& one : *figures_) *to++ = one.*figure;
  return array;
}

namespace {

using Class = py::class_<Moves>;

template <class Value, class Of>
void add_column(Class& moves, const char* name, const char* text, Of of) {
  moves.def_property_readonly(
      name, [of](const Moves& self) { return self.column<Value>(of); }, text);
}

void add_places(Class& moves) {
  const auto add = [&moves](const char* name, const char* text, auto of) {
    add_column<double>(moves, name, text, of);
  };
  add("x", "End of each move, mm.", [](const Section&, const Move& move) { return move.path.to.x; });
  add("y", "End of each move, mm.", [](const Section&, const Move& move) { return move.path.to.y; });
  add("z", "Height of the tool's tip at the end of each move, mm.",
      [](const Section&, const Move& move) { return move.z_to; });
  add("from_x", "Start of each move, mm.", [](const Section&, const Move& move) { return move.path.from.x; });
  add("from_y", "Start of each move, mm.", [](const Section&, const Move& move) { return move.path.from.y; });
  add("from_z", "Height of the tool's tip at the start of each move, mm.",
      [](const Section&, const Move& move) { return move.z_from; });
  add("center_x", "Centre of each arc, mm; not a number for lines.", [](const Section&, const Move& move) {
    return move.path.is_arc() ? move.path.center.x : std::nan("");
  });
  add("center_y", "Centre of each arc, mm; not a number for lines.", [](const Section&, const Move& move) {
    return move.path.is_arc() ? move.path.center.y : std::nan("");
  });
  add("length", doc("Move::length"), [](const Section&, const Move& move) { return move.length(); });
  add("feed", doc("Move::feed"), [](const Section&, const Move& move) { return move.feed.mm_per_min(); });
}

void add_words(Class& moves) {
  add_column<std::int8_t>(
      moves, "turn", "1 counter-clockwise arc, -1 clockwise, 0 line.",
      [](const Section&, const Move& move) { return static_cast<std::int8_t>(move.path.turn); });
  add_column<std::uint8_t>(
      moves, "kind", "What each move does: index into Moves.kinds.",
      [](const Section&, const Move& move) { return static_cast<std::uint8_t>(move.kind); });
  add_column<int>(moves, "line", doc("Move::line"),
                  [](const Section&, const Move& move) { return move.line; });
  add_column<int>(moves, "tool", doc("Section::tool_number"),
                  [](const Section& section, const Move&) { return section.tool_number; });
  add_column<int>(moves, "workingstep", doc("Section::workingstep"),
                  [](const Section& section, const Move&) { return section.workingstep; });
}

std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(MoveKind::kRetract); ++kind)
    names.emplace_back(name_of(static_cast<MoveKind>(kind)));
  return names;
}

}  // namespace

void add_moves(py::module_& module) {
  Class moves(
      module, "Moves",
      "The moves of a program, section after section, as NumPy columns. Each is made when it is asked for.");
  moves.def("__len__", &Moves::size);
  moves.def_property_readonly_static("kinds", [](const py::object&) { return kinds(); });
  add_places(moves);
  add_words(moves);
  moves.def_property_readonly("time", &Moves::times, doc("MoveFigures::time_s"));
  const auto figure = [&moves](const char* name, const char* text, double MoveFigures::*of) {
    moves.def_property_readonly(
        name, [of](Moves& self) { return self.engagement(of); }, text);
  };
  figure("engagement", "Greatest engagement of each move, degrees; 0 where nothing is cut, and for entries.",
         &MoveFigures::max_engagement_deg);
  figure("mean_engagement", doc("MoveFigures::mean_engagement_deg"), &MoveFigures::mean_engagement_deg);
  figure("cutting_mm", doc("MoveFigures::cutting_mm"), &MoveFigures::cutting_mm);
  figure("air_mm", doc("MoveFigures::air_mm"), &MoveFigures::air_mm);
}

}  // namespace clearcut::python
