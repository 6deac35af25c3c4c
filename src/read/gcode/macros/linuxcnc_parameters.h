// LinuxCNC's parameters: numbered, named, local and global, and those in which the interpreter says its own state.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <string>

#include "read/gcode/control/control.h"
#include "read/gcode/macros/macro_line.h"

namespace clearcut::read::gcode {

/// What each call of a subroutine has of its own.
struct LocalParameters {
  static constexpr int kNumbered = 30;  ///< #1 to #30
  std::map<int, double> numbered;
  std::map<std::string, double> named;
  bool all_stated = false;  ///< arguments that were not given are 0
};

/// Keeps a reference to the control.
class LinuxCncParameters : public MacroStore {
 public:
  explicit LinuxCncParameters(Control& control) : control_(control) { locals_.emplace_back(); }

  MacroValue numbered(int number) override;
  double named(const std::string& name) override;
  bool exists(const std::string& name) const override;
  void assign(const Assignment& assignment) override;

  void enter(LocalParameters locals) { locals_.push_back(std::move(locals)); }
  void leave() { locals_.pop_back(); }
  /// What ENDSUB and RETURN hand back.
  void set_returned(std::optional<double> value);
  /// Calls of subroutines that run.
  int level = 0;

 private:
  double stated(int number);
  std::optional<double> of_state(int number);
  double unstated(int number);
  std::optional<double> of_names(const std::string& name) const;

  Control& control_;
  std::deque<LocalParameters> locals_;
  std::map<int, double> numbered_;
  std::map<std::string, double> named_;
  std::optional<double> returned_;
  bool has_returned_ = false;
};

/// Where the tool stands as the program counts, in its units.
double place_in_program(Control& control, std::size_t axis);
/// mm as the program says lengths.
double length_in_program(const Control& control, double mm);

}  // namespace clearcut::read::gcode
