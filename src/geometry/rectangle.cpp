#include "geometry/rectangle.h"

namespace clearcut::inline geometry {

Loop rectangle(const Box& box) {
  const Vec2 corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  return loop_from_points(corners);
}

Region rectangular_region(const Box& box) {
  return Region::from_valid_loops(rectangle(box), {});
}

Region frame_around(const Box& box, double width) {
  return Region::from_valid_loops(rectangle(box.grown(width)), {rectangle(box)});
}

}  // namespace clearcut::inline geometry
