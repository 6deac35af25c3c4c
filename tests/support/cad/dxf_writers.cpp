#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "support/cad/dxf_texts.h"
#include "support/cad/writers.h"

namespace clearcut::test_support {
namespace {

/// Entities of a DXF, each a text of its own so that they can be shuffled.
class DxfText {
 public:
  /// `unit`: mm.
  explicit DxfText(double unit) : unit_(unit) {}

  void line(const std::string& layer, Vec2 a, Vec2 b) { add("LINE", layer, point(10, a) + point(11, b)); }
  void arc(const std::string& layer, const Edge& edge) {
    const Edge ccw = edge.turn == Turn::kClockwise ? edge.reversed() : edge;
    const auto angle = [&](Vec2 p) {
      const Vec2 v = p - ccw.center;
      return std::atan2(v.y, v.x) * 180 / kPi;
    };
    add("ARC", layer,
        point(10, ccw.center) + number(40, ccw.radius() / unit_) + number(50, angle(ccw.from)) +
            number(51, angle(ccw.to)));
  }
  void circle(const std::string& layer, Vec2 center, double diameter) {
    add("CIRCLE", layer, point(10, center) + number(40, diameter / 2 / unit_));
  }
  /// An arc of less than half a turn as a rational spline of degree 2 with one weight.
  void spline(const std::string& layer, const Edge& edge) {
    const double half = std::abs(edge.sweep()) / 2;
    const Vec2 middle =
        edge.center + unit((edge.from + edge.to) / 2.0 - edge.center) * (edge.radius() / std::cos(half));
    std::string text = "70\n12\n71\n2\n72\n6\n73\n3\n74\n0\n";
    for (const int knot : {0, 0, 0, 1, 1, 1}) text += number(40, knot);
    for (const double weight : {1.0, std::cos(half), 1.0}) text += number(41, weight);
    add("SPLINE", layer, text + point(10, edge.from) + point(10, middle) + point(10, edge.to));
  }
  void polyline(const std::string& layer, const Loop& loop) {
    std::string text = fmt::format("90\n{}\n70\n1\n43\n0\n", loop.size());
    for (const BulgeVertex& v : to_bulges(loop)) {
      text += point(10, v.point);
      if (v.bulge != 0) text += number(42, v.bulge);
    }
    add("LWPOLYLINE", layer, text);
  }
  void old_polyline(const std::string& layer, const Loop& loop) {
    std::string text = "0\nPOLYLINE\n8\n" + layer + "\n66\n1\n10\n0.0\n20\n0.0\n30\n0.0\n70\n1\n";
    for (const BulgeVertex& v : to_bulges(loop))
      text += "0\nVERTEX\n8\n" + layer + "\n" + point(10, v.point) + number(42, v.bulge);
    entities_.push_back(text + "0\nSEQEND\n8\n" + layer + "\n");
  }
  void add(const std::string& kind, const std::string& layer, const std::string& text) {
    entities_.push_back("0\n" + kind + "\n8\n" + layer + "\n" + text);
  }

  std::string point(int code, Vec2 p) const {
    return number(code, p.x / unit_) + number(code + 10, p.y / unit_) + number(code + 20, 0);
  }
  static std::string number(int code, double value) { return fmt::format("{}\n{:.12g}\n", code, value); }

  void shuffle(Random& random) {
    for (std::size_t i = entities_.size(); i > 1; --i)
      std::swap(entities_[i - 1], entities_[random.below(i)]);
  }
  /// Some entities once more.
  void repeat_some(Random& random) {
    const std::size_t count = entities_.size();
    for (std::size_t i = 0; i < count; ++i)
      if (random.below(4) == 0) entities_.push_back(entities_[i]);
  }
  /// `header`: variables; `blocks`: definitions.
  std::string text(const std::string& header, const std::string& blocks = "") const {
    std::string all;
    if (!header.empty()) all += "0\nSECTION\n2\nHEADER\n" + header + "0\nENDSEC\n";
    if (!blocks.empty()) all += "0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n";
    all += "0\nSECTION\n2\nENTITIES\n";
    for (const std::string& entity : entities_) all += entity;
    return all + "0\nENDSEC\n0\nEOF\n";
  }

 private:
  double unit_;
  std::vector<std::string> entities_;
};

std::string variable(const std::string& name, int code, const std::string& value) {
  return fmt::format("9\n${}\n{}\n{}\n", name, code, value);
}

/// One of $INSUNITS, and its millimetres.
struct DrawingUnit {
  int code = 4;
  double mm = 1;
};
constexpr DrawingUnit kInch{1, 25.4}, kMm{4, 1}, kCm{5, 10};

enum class ArcsAs { kArcs, kSplines };

/// Every edge as an entity of its own, some from end to start; ends up to `gap` mm off.
void add_loose(const CadShape& shape, const std::string& layer, ArcsAs arcs, double gap, Random& random,
               DxfText& dxf) {
  if (shape.diameter) return dxf.circle(layer, shape.center, *shape.diameter);
  for (const Edge& edge : shape.outline) {
    const Edge drawn = random.below(2) == 0 ? edge : edge.reversed();
    const bool splines = arcs == ArcsAs::kSplines && std::abs(edge.sweep()) < 0.9 * kPi;
    if (!edge.is_arc()) {
      dxf.line(layer, drawn.from, drawn.to + direction_of(random.between(0, 2 * kPi)) * gap);
    } else if (splines) {
      dxf.spline(layer, drawn);
    } else {
      dxf.arc(layer, drawn);
    }
  }
}

bool is_plate(const CadShape& shape) {
  return shape.kind == CadShapeKind::kPlate;
}

}  // namespace

CadDrawing fusion_drawing(const CadPart& part, Random& random) {
  const DrawingUnit units[] = {kMm, kCm, kInch};
  const DrawingUnit unit = units[random.below(3)];
  const bool sheet = random.below(2) == 0;
  const ArcsAs arcs = random.below(3) == 0 ? ArcsAs::kSplines : ArcsAs::kArcs;
  DxfText dxf(unit.mm);
  for (const CadShape& shape : part.shapes) {
    const char* layer = !sheet ? "0" : is_plate(shape) ? "OUTER_PROFILES" : "INTERIOR_PROFILES";
    add_loose(shape, layer, arcs, 0, random, dxf);
  }
  dxf.shuffle(random);
  const std::string header =
      variable("ACADVER", 1, "AC1027") + variable("INSUNITS", 70, fmt::format("{}", unit.code));
  return {"fusion.dxf", dxf.text(header), sheet, sheet};
}

CadDrawing solidworks_drawing(const CadPart& part, Random& random) {
  const DrawingUnit unit = random.below(2) == 0 ? kMm : kInch;
  const double gap = random.below(3) == 0 ? 0.002 : 0;
  DxfText dxf(unit.mm);
  for (const CadShape& shape : part.shapes)
    add_loose(shape, "0", random.below(2) == 0 ? ArcsAs::kSplines : ArcsAs::kArcs, gap, random, dxf);
  dxf.shuffle(random);
  const Vec2 note = part.box().max + Vec2{20, 0};
  dxf.add("MTEXT", "FORMAT", dxf.point(10, note) + "40\n3.5\n1\nSHEET 1 OF 1\n");
  const std::string header = variable("ACADVER", 1, "AC1024") +
                             variable("INSUNITS", 70, fmt::format("{}", unit.code)) +
                             variable("MEASUREMENT", 70, unit.code == 4 ? "1" : "0");
  return {"solidworks.dxf", dxf.text(header)};
}

CadDrawing librecad_drawing(const CadPart& part, Random& random) {
  const bool named = random.below(3) > 0, blocks = random.below(2) == 0;
  DxfText dxf(1);
  for (const CadShape& shape : part.shapes) {
    const char* layer = !named                                ? "0"
                        : is_plate(shape)                     ? "Profile_D6"
                        : shape.kind == CadShapeKind::kPocket ? "Pocket D3"
                                                              : "Holes_D6";
    if (!shape.diameter) {
      dxf.polyline(layer, shape.outline);
    } else if (blocks) {
      dxf.add("INSERT", layer,
              "2\nHOLE\n" + dxf.point(10, shape.center) + DxfText::number(41, *shape.diameter) +
                  DxfText::number(42, *shape.diameter) + DxfText::number(50, random.between(0, 360)));
    } else {
      dxf.circle(layer, shape.center, *shape.diameter);
    }
  }
  if (random.below(2) == 0) dxf.repeat_some(random);
  const Box around = part.box();
  dxf.add("DIMENSION", "dimensions", "2\n*D1\n" + dxf.point(10, around.min - Vec2{0, 10}) + "70\n32\n");
  dxf.add("TEXT", "dimensions", dxf.point(10, around.min - Vec2{0, 20}) + "40\n2.5\n1\nplate\n");
  const std::string hole =
      "0\nBLOCK\n8\n0\n2\nHOLE\n70\n0\n10\n0\n20\n0\n30\n0\n3\nHOLE\n"
      "0\nCIRCLE\n8\n0\n10\n0\n20\n0\n30\n0\n40\n0.5\n0\nENDBLK\n8\n0\n";
  const std::string header = variable("ACADVER", 1, "AC1021") + variable("INSUNITS", 70, "4") +
                             variable("DIMSCALE", 40, "1.0") + variable("LUNITS", 70, "2");
  return {"librecad.dxf", dxf.text(header, hole), named};
}

CadDrawing freecad_drawing(const CadPart& part, Random& random) {
  const bool named = random.below(2) == 0;
  DxfText dxf(1);
  int number = 1;
  for (const CadShape& shape : part.shapes) {
    const std::string name = is_plate(shape)                       ? "Profile"
                             : shape.kind == CadShapeKind::kPocket ? "Pocket"
                                                                   : "Hole";
    const std::string layer = named ? fmt::format("{}{:03}", name, number++) : "0";
    if (shape.diameter) {
      dxf.circle(layer, shape.center, *shape.diameter);
    } else {
      dxf.old_polyline(layer, shape.outline);
    }
  }
  return {"freecad.dxf", "999\nDXF created from FreeCAD\n" + dxf.text(variable("ACADVER", 1, "AC1009")),
          named};
}

std::string kicad_dxf(const CadPart& part, Random& random) {
  DxfText dxf(kInch.mm);
  for (const CadShape& shape : part.shapes) add_loose(shape, "Edge.Cuts", ArcsAs::kArcs, 0, random, dxf);
  if (random.below(2) == 0) dxf.repeat_some(random);
  const std::string header = variable("ANGBASE", 50, "0.0") + variable("ANGDIR", 70, "1") +
                             variable("INSUNITS", 70, "1") + variable("MEASUREMENT", 70, "0");
  return dxf.text(header);
}

std::string openscad_dxf(const std::vector<std::vector<Vec2>>& polygons) {
  std::string text;
  for (const auto& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      text +=
          fmt::format("0\nLINE\n8\n0\n10\n{:.6g}\n20\n{:.6g}\n11\n{:.6g}\n21\n{:.6g}\n", a.x, a.y, b.x, b.y);
    }
  }
  return "999\nDXF from OpenSCAD\n0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1006\n0\nENDSEC\n"
         "0\nSECTION\n2\nENTITIES\n" +
         text + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace clearcut::test_support
