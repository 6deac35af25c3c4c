// Work offsets: where the program's zero lies while it runs.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace clearcut::read::gcode {

using Axes = std::array<double, 3>;

/// The frame that is checked is that of the work; `shift` leads there from the program's words. All mm.
class Frame {
 public:
  static constexpr int kSystems = 9;  ///< G54 to G59.3
  /// All further offsets: they are assumed to be equal to the zero of the work.
  static constexpr int kElsewhere = kSystems + 1;

  /// `origins`: the offsets as they are in the control, where they are known.
  explicit Frame(const std::optional<std::array<Axes, kSystems>>& origins);

  /// word + shift = place in the work's frame.
  double shift(std::size_t axis) const;
  /// The machine's own coordinate of a place is the place + this.
  double machine_zero(std::size_t axis) const { return base_[axis]; }

  int system() const { return system_; }
  void use_system(int system) { system_ = system; }
  /// G10 L2. Before any motion the first such word of the first system says where the work lies.
  void set_origin(int system, std::size_t axis, double value, bool moved);
  double origin(int system, std::size_t axis) const { return origins_[index(system)][axis]; }

  /// G52: the shift itself.
  void set_local(std::size_t axis, double value);
  /// G92: the place has these coordinates from now on.
  void name_place(std::size_t axis, double place, double value);
  void clear_local(bool keep);
  /// G92.3; false where nothing was kept.
  bool restore_local();

  /// A tool length that the program states itself (G43.1, DL).
  void set_stated_length(double length) { length_ = length; }
  double stated_length() const { return length_; }

 private:
  static std::size_t index(int system) { return static_cast<std::size_t>(system - 1); }

  std::array<Axes, kSystems> origins_{};
  Axes base_{}, local_{};
  std::optional<Axes> kept_local_;
  double length_ = 0;
  int system_ = 1;
  bool known_ = false;
};

}  // namespace clearcut::read::gcode
