// Words about places: work offsets, shifts, tool lengths, and the machine's own frame.
#pragma once

#include <array>

#include "read/gcode/control/control.h"

namespace clearcut::read::gcode {

/// Keeps a reference to the control.
class PlaceWords {
 public:
  explicit PlaceWords(Control& control) : control_(control) {}

  /// Executes words that use X, Y, Z for something else than motion in the work's frame; whether there were any.
  bool move_specially(const Block& block);
  void use_system(int code, const Block& block);
  void set_length(int code, const Block& block);
  /// What turns or scales places ends, where the other word has begun it.
  void end_map(int code, int made_by);

 private:
  bool uses_numbered_system(int code, const Block& block) const;
  void use_numbered_system(int code, const Block& block);
  void use_plain_system(int code);
  void go_home(const Block& block, bool first);
  Target stated_way(const Block& block);
  void go_to_reference(const Block& block, const std::array<double, 3>& reference);
  void go_to_unknown(const Block& block, const std::string& name, bool all, bool harmless);
  void store_reference(bool first);
  void machine_frame(const Block& block);
  void set_offset_table(const Block& block);
  void shift(const Block& block);
  void clear_shift(int code);
  void rotate(const Block& block);
  void refuse_second_map(int code) const;
  void scale(const Block& block);
  void set_scales(const Block& block, PlanMap& map);
  double scale_of(char letter, const Block& block) const;
  void refuse_lengths_in_plan(int code, const Block& block) const;
  void add_length(const Block& block);
  void mirror(const Block& block, bool on);

  Control& control_;
};

}  // namespace clearcut::read::gcode
