#include "support/stepped_solid.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace clearcut::test_support {
namespace {

using Point = std::array<double, 3>;
using Polygon = std::vector<Point>;  // counter-clockwise seen from outside

constexpr const char* kHead =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
    "FILE_NAME('stepped','2024-01-01T00:00:00',(''),(''),'','','');\n"
    "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n"
    "#1=APPLICATION_CONTEXT('core data');\n#2=PRODUCT_CONTEXT('',#1,'mechanical');\n"
    "#3=PRODUCT('stepped','stepped','',(#2));\n#4=PRODUCT_DEFINITION_FORMATION('','',#3);\n"
    "#5=PRODUCT_DEFINITION_CONTEXT('part "
    "definition',#1,'design');\n#6=PRODUCT_DEFINITION('design','',#4,#5);\n"
    "#7=PRODUCT_DEFINITION_SHAPE('','',#6);\n#8=SHAPE_DEFINITION_REPRESENTATION(#7,#9);\n"
    "#9=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#10),#11);\n#10=MANIFOLD_SOLID_BREP('',#16);\n"
    "#11=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#15))"
    "GLOBAL_UNIT_ASSIGNED_CONTEXT((#12,#13,#14))REPRESENTATION_CONTEXT('',''));\n"
    "#12=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
    "#13=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
    "#14=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n"
    "#15=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#12,'','');\n";
constexpr int kShell = 16;

std::string real(double value) {
  const std::string text = fmt::format("{:.12f}", value);
  return text.substr(0, text.find_last_not_of('0') + 1);
}

Point unit(const Point& from, const Point& to) {
  Point way{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  for (double& part : way) part = part > 0 ? 1 : part < 0 ? -1 : 0;
  return way;
}

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

class Writer {
 public:
  void add_face(const Polygon& r) {
    const int axis = add(fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", triple("CARTESIAN_POINT", r[0]),
                                     triple("DIRECTION", cross(unit(r[0], r[1]), unit(r.front(), r.back()))),
                                     triple("DIRECTION", unit(r[0], r[1]))));
    const int plane = add(fmt::format("PLANE('',#{})", axis));
    std::string loop;
    for (std::size_t i = 0; i < r.size(); ++i)
      loop += fmt::format("{}#{}", i ? "," : "", oriented(r[i], r[(i + 1) % r.size()]));
    const int bound = add(fmt::format("FACE_OUTER_BOUND('',#{},.T.)", add("EDGE_LOOP('',(" + loop + "))")));
    faces_ += fmt::format("{}#{}", faces_.empty() ? "" : ",",
                          add(fmt::format("ADVANCED_FACE('',(#{}),#{},.T.)", bound, plane)));
  }

  std::string text() const {
    return kHead + fmt::format("#{}=CLOSED_SHELL('',({}));\n", kShell, faces_) + data_ +
           "ENDSEC;\nEND-ISO-10303-21;\n";
  }

 private:
  int add(const std::string& entity) {
    data_ += fmt::format("#{}={};\n", ++last_, entity);
    return last_;
  }

  int triple(const char* entity, const Point& p) {
    return add(fmt::format("{}('',({},{},{}))", entity, real(p[0]), real(p[1]), real(p[2])));
  }

  int vertex(const Point& p) {
    const auto [at, fresh] = vertices_.try_emplace(p, 0);
    if (fresh) at->second = add(fmt::format("VERTEX_POINT('',#{})", triple("CARTESIAN_POINT", p)));
    return at->second;
  }

  /// Both faces of an edge share it.
  int oriented(const Point& from, const Point& to) {
    const bool forward = from < to;
    const Point &a = forward ? from : to, &b = forward ? to : from;
    const auto [at, fresh] = edges_.try_emplace({a, b}, 0);
    if (fresh) {
      const int way = add(fmt::format("VECTOR('',#{},1.)", triple("DIRECTION", unit(a, b))));
      const int line = add(fmt::format("LINE('',#{},#{})", triple("CARTESIAN_POINT", a), way));
      const int start = vertex(a), end = vertex(b);
      at->second = add(fmt::format("EDGE_CURVE('',#{},#{},#{},.T.)", start, end, line));
    }
    return add(fmt::format("ORIENTED_EDGE('',*,*,#{},.{}.)", at->second, forward ? 'T' : 'F'));
  }

  std::map<Point, int> vertices_;
  std::map<std::pair<Point, Point>, int> edges_;
  std::string faces_, data_;
  int last_ = kShell;
};

/// The blocks of a solid as faces.
class Blocks {
 public:
  explicit Blocks(const SteppedSolid& solid) : solid_(solid) {
    for (std::size_t j = 0; j + 1 < solid.y.size(); ++j)
      for (std::size_t i = 0; i + 1 < solid.x.size(); ++i)
        if (height(i, j) > solid.bottom) add(i, j);
  }

  std::string text() const { return writer_.text(); }

 private:
  /// Out of range, also by one below 0, nothing stands.
  double height(std::size_t i, std::size_t j) const {
    return i < solid_.x.size() - 1 && j < solid_.y.size() - 1 ? solid_.heights[j][i] : solid_.bottom;
  }

  void add(std::size_t i, std::size_t j) {
    const double x0 = solid_.x[i], x1 = solid_.x[i + 1], y0 = solid_.y[j], y1 = solid_.y[j + 1];
    const double top = height(i, j), low = solid_.bottom;
    writer_.add_face({{x0, y0, top}, {x1, y0, top}, {x1, y1, top}, {x0, y1, top}});
    writer_.add_face({{x0, y1, low}, {x1, y1, low}, {x1, y0, low}, {x0, y0, low}});
    add_wall({i, j}, {i + 1, j}, height(i, j - 1), top);
    add_wall({i + 1, j}, {i + 1, j + 1}, height(i + 1, j), top);
    add_wall({i + 1, j + 1}, {i, j + 1}, height(i, j + 1), top);
    add_wall({i, j + 1}, {i, j}, height(i - 1, j), top);
  }

  using Corner = std::array<std::size_t, 2>;

  /// Between the low and the high end, ascending: where walls that meet there begin and end, so that they share edges.
  std::vector<Point> up_along(const Corner& corner, double low, double high) const {
    const auto [i, j] = corner;
    std::set<double> heights{low, high};
    for (const double z : {height(i, j), height(i - 1, j), height(i, j - 1), height(i - 1, j - 1)})
      if (z > low && z < high) heights.insert(z);
    std::vector<Point> points;
    for (const double z : heights) points.push_back({solid_.x[i], solid_.y[j], z});
    return points;
  }

  /// From the height of a neighbour up to the block's own.
  void add_wall(const Corner& from, const Corner& to, double low, double high) {
    if (low >= high) return;
    const Polygon left = up_along(from, low, high);
    Polygon wall{left.front()};
    const Polygon right = up_along(to, low, high);
    wall.insert(wall.end(), right.begin(), right.end());
    wall.insert(wall.end(), left.rbegin(), left.rend() - 1);
    writer_.add_face(wall);
  }

  const SteppedSolid& solid_;
  Writer writer_;
};

}  // namespace

std::string step_text(const SteppedSolid& solid) {
  return Blocks(solid).text();
}

std::string stepped_foot_text() {
  Writer writer;
  writer.add_face({{0, 20, 0}, {30, 20, 0}, {30, 0, 0}, {0, 0, 0}});
  writer.add_face({{0, 0, 10}, {10, 0, 10}, {10, 20, 10}, {0, 20, 10}});
  writer.add_face({{10, 0, 2}, {30, 0, 2}, {30, 7, 2}, {10, 7, 2}});
  writer.add_face({{10, 7, 6}, {30, 7, 6}, {30, 20, 6}, {10, 20, 6}});
  writer.add_face({{10, 7, 2}, {30, 7, 2}, {30, 7, 6}, {10, 7, 6}});
  writer.add_face({{10, 0, 2}, {10, 7, 2}, {10, 7, 6}, {10, 20, 6}, {10, 20, 10}, {10, 0, 10}});
  writer.add_face({{0, 0, 0}, {30, 0, 0}, {30, 0, 2}, {10, 0, 2}, {10, 0, 10}, {0, 0, 10}});
  writer.add_face({{30, 0, 0}, {30, 20, 0}, {30, 20, 6}, {30, 7, 6}, {30, 7, 2}, {30, 0, 2}});
  writer.add_face({{30, 20, 0}, {0, 20, 0}, {0, 20, 10}, {10, 20, 10}, {10, 20, 6}, {30, 20, 6}});
  writer.add_face({{0, 20, 0}, {0, 0, 0}, {0, 0, 10}, {0, 20, 10}});
  return writer.text();
}

std::string broken_block_text(double width, double depth, double height, double chamfer) {
  const auto corners = [&](double in, double z) {
    return Polygon{{in, in, z}, {width - in, in, z}, {width - in, depth - in, z}, {in, depth - in, z}};
  };
  const Polygon low = corners(0, 0), foot = corners(0, height - chamfer), top = corners(chamfer, height);
  Writer writer;
  writer.add_face({low.rbegin(), low.rend()});
  writer.add_face(top);
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t next = (i + 1) % low.size();
    writer.add_face({low[i], low[next], foot[next], foot[i]});
    writer.add_face({foot[i], foot[next], top[next], top[i]});
  }
  return writer.text();
}

}  // namespace clearcut::test_support
