// Words that change modes: units, distance, plane, feed, path control, tool, spindle, coolant, program end.
#pragma once

#include <optional>
#include <utility>

#include "read/gcode/control/control.h"

namespace clearcut::read::gcode {

/// Keeps a reference to the control.
class ModeWords {
 public:
  explicit ModeWords(Control& control) : control_(control) {}

  /// G words of modes.
  void set_modes(const Block& block);
  /// F, S, T and M words. `feed_unit`: mm for an F word of 1.
  void set_feed_and_drive(const Block& block, double feed_unit);
  /// M70 to M73.
  void save_or_restore(int m);
  /// Takes other modes as those that M70 has kept; returns those before.
  std::optional<Modes> exchange_saved(std::optional<Modes> other) { return std::exchange(saved_, other); }
  void dwell(const Block& block);
  void end(int m);

 private:
  void set_mode(int code, const Block& block);
  void set_feed_mode(FeedMode mode);
  void set_other(int code, const Block& block);
  void use_units(double unit);
  void set_path(int code, const Block& block);
  void switch_coolant(int m);
  void set_drive(int m, const Block& block);
  void state_tool(const Block& block);
  void note_unknown(int m);
  void turn_spindle_and_flood(int m);
  void select_tool(const Block& block);
  void load_tool();
  void pause(const Block& block);

  Control& control_;
  std::optional<Modes> saved_;  ///< by M70
  std::size_t hand_tool_ = 0;   ///< place in the tools that are put in by hand
};

}  // namespace clearcut::read::gcode
