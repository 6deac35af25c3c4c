#include "read/gcode/motion/frame.h"

namespace clearcut::read::gcode {

Frame::Frame(const std::optional<std::array<Axes, kSystems>>& origins) {
  if (!origins) return;
  known_ = true;
  origins_ = *origins;
  base_ = origins_[0];
}

double Frame::shift(std::size_t axis) const {
  const double origin = system_ == kElsewhere ? base_[axis] : origins_[index(system_)][axis];
  return origin + local_[axis] + (axis == 2 ? length_ : 0) - base_[axis];
}

void Frame::set_origin(int system, std::size_t axis, double value, bool moved) {
  origins_[index(system)][axis] = value;
  if (system == 1 && !known_ && !moved) base_[axis] = value;
}

void Frame::set_local(std::size_t axis, double value) {
  local_[axis] = value;
  kept_local_ = local_;
}

void Frame::name_place(std::size_t axis, double place, double value) {
  local_[axis] += place - (value + shift(axis));
  kept_local_ = local_;
}

void Frame::clear_local(bool keep) {
  if (keep) {
    kept_local_ = local_;
  } else {
    kept_local_ = Axes{};
  }
  local_ = {};
}

bool Frame::restore_local() {
  if (!kept_local_) return false;
  local_ = *kept_local_;
  return true;
}

}  // namespace clearcut::read::gcode
