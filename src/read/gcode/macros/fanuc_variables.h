// Fanuc's variables: local, common and those of the system.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "read/gcode/control/control.h"
#include "read/gcode/macros/macro_line.h"

namespace clearcut::read::gcode {

/// Keeps a reference to the control.
class FanucVariables : public MacroStore {
 public:
  using Locals = std::map<int, MacroValue>;

  explicit FanucVariables(Control& control) : control_(control) { locals_.emplace_back(); }

  MacroValue numbered(int number) override;
  double named(const std::string& name) override;
  bool exists(const std::string&) const override { return false; }
  void assign(const Assignment& assignment) override;
  double angle_below_zero(double degrees) override;

  /// Of a macro that G65 calls.
  void enter(Locals locals) { locals_.push_back(std::move(locals)); }
  void leave() { locals_.pop_back(); }
  std::size_t macros() const { return locals_.size() - 1; }

 private:
  MacroValue unstated(int number);
  MacroValue of_system(int number);
  std::optional<double> of_place(int number);
  void set_system(int number, double value);

  Control& control_;
  std::deque<Locals> locals_;
  std::map<int, MacroValue> common_;
};

/// Local variables of a macro by the words of its call, in both ways of counting I, J, K. Throws InputError(place, ...).
FanucVariables::Locals arguments_of(const std::vector<ArgumentWord>& words, const std::string& place);

}  // namespace clearcut::read::gcode
