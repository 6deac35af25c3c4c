// The checker's predicates on numbers from standard input, one question a line, for bounds.py.
#define CLEARCUT_CHECK_WITHOUT_MAIN
#include <iostream>

#include "../../checker/clearcut_check.cpp"

using namespace clearcut_check;

static Point point() {
  Point p;
  std::cin >> p.x >> p.y;
  return p;
}
static Points points() {
  std::size_t count = 0;
  std::cin >> count;
  Points all(count);
  for (Point& p : all) p = point();
  return all;
}
static Curve arc() {
  Curve c;
  c.arc = true;
  c.center = point();
  c.first = point();
  c.last = point();
  std::cin >> c.low >> c.high;
  c.a = c.center + c.first;
  c.b = c.center + c.last;
  return c;
}
static Int length() {
  Int t = 0;
  std::cin >> t;
  return t;
}

int main() {
  for (std::string what; std::cin >> what;) {
    if (what == "segment") {  // p a b t
      const Point p = point(), a = point(), b = point();
      std::cout << near_segment(p, a, b, length());
    } else if (what == "segments") {  // a b c d t
      const Point a = point(), b = point(), c = point(), d = point();
      std::cout << segments_apart(a, b, c, d, length());
    } else if (what == "apart") {  // hull hull t
      const Points a = hull_of(points()), b = hull_of(points());
      std::cout << apart(a, b, length());
    } else if (what == "arc") {  // arc hull t
      const Curve c = arc();
      const Points hull = hull_of(points());
      std::cout << hull_within(c, hull, length());
    } else if (what == "chord") {  // arc u v
      const Curve c = arc();
      const Point u = point(), v = point();
      std::cout << Int(chord_error(c, u, v));
    } else if (what == "piece") {  // arc, from and to, seen from its center
      const Curve c = arc();
      const Point u = point(), v = point();
      std::cout << Int(slack_of(c, c.center + u, c.center + v));
    } else if (what == "turned") {  // v, angle in 1/10000 degrees
      const Point v = point();
      const Point p = turned(v, length());
      std::cout << p.x << ' ' << p.y;
    } else if (what == "tick") {  // v
      const Part part;
      const Program program;
      const std::vector<Tool> tools;
      std::cout << Rim(part, program, tools).tick_of(point());
    } else if (what == "low") {  // a b z0 z1 level
      Move move;
      move.path = Curve{point(), point()};
      move.z0 = length(), move.z1 = length();
      const Curve low = low_part(move, 0, length());
      std::cout << low.b.x << ' ' << low.b.y;
    } else if (what == "rim") {  // radius, the earlier move's a b, the move's a b, from, size
      Part part;
      part.top = 1;
      Program program;
      const std::vector<Tool> tools{{0, length(), 0}};
      for (int i = 0; i < 2; ++i) {
        program.moves.emplace_back();
        program.moves.back().path = Curve{point(), point()};
      }
      const Curve& path = program.moves[1].path;
      const Int from = length(), size = length();
      std::cout << Rim(part, program, tools).is_free(1, path.a, path.b, {from, size, 0});
    } else if (what == "chords") {  // arc
      const Chords all = chords_of(arc());
      std::cout << Int(all.error) << ' ' << all.points.size();
      for (const Point p : all.points) std::cout << ' ' << p.x << ' ' << p.y;
    }
    std::cout << '\n';
  }
}
