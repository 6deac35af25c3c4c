// Items drawn by Gerber's operations: strokes, flashes and regions, in repeatable blocks.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "read/board/aperture.h"
#include "read/board/drawn.h"

namespace clearcut::read {

/// Placement of apertures: mirrored, then scaled, then turned.
struct ApertureTransform {
  bool mirror_x = false, mirror_y = false;
  double scale = 1, turn_deg = 0;

  Affine at(Vec2 place) const;
};

/// A block repeated at steps.
struct StepAndRepeat {
  int columns = 1, rows = 1;
  Vec2 step;  ///< mm
};

class GerberCanvas {
 public:
  /// `place`: place for messages, kept up to date by the caller.
  explicit GerberCanvas(const std::string& place) : place_(place), blocks_(1) {}

  /// All drawn items; throws InputError if the file ends within a block.
  std::vector<Drawn> take();

  void define(int number, Aperture aperture) { apertures_[number] = std::move(aperture); }
  void select(int number);
  void set_dark(bool dark);
  /// Transform of the following items.
  ApertureTransform& transform();

  void begin_region();
  void end_region();
  bool in_region() const { return in_region_; }

  /// D01: edges leading to `at`; no edges draw a dot. D02: a line or contour ends. D03: a flash.
  void draw_to(Vec2 at, const Path& edges);
  void lift();
  void flash(Vec2 at);

  void begin_repeat(const StepAndRepeat& repeat);
  void end_repeat();
  void begin_aperture(int number);
  void end_aperture();

 private:
  /// Items drawn together, which may be repeated elsewhere.
  struct Block {
    std::vector<Drawn> drawn;
    int aperture = 0;  ///< becomes this aperture; 0: is repeated in steps
    StepAndRepeat repeat;
  };

  [[noreturn]] void fail(const std::string& what) const;
  const Aperture& aperture() const;
  void finish_line();
  void finish_contour();
  std::vector<Path> swept(const Path& line) const;
  void draw_again(const std::vector<Drawn>& all, const Affine& map, bool dark);
  void draw(Drawn drawn);

  const std::string& place_;
  std::map<int, Aperture> apertures_;
  const Aperture* aperture_ = nullptr;
  int number_ = 0;  ///< number of the aperture
  bool dark_ = true, in_region_ = false;
  ApertureTransform transform_;
  Path contour_, stroke_;
  std::vector<Vec2> dots_;
  std::vector<Block> blocks_;  ///< the file, then blocks within blocks
  std::size_t edges_ = 0;
};

}  // namespace clearcut::read
