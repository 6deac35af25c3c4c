// Writes bracket.step (the pocket of bracket.json in a block), nested.step, the
// same as nested_nurbs.step with every surface a spline, awkward.step, where much is not for a cutter
// from above, on_edge.step and sideways.step, which must be turned, disc.step, which fills no box, two_sided.step, which takes
// two set-ups, handle.step with curved faces on a plate, and the assembly plate_and_pins.step.
#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <iostream>

#include "base/units.h"
#include "read/job/read_part.h"

namespace {

using namespace clearcut;

TopoDS_Wire wire_of(const Loop& loop) {
  BRepBuilderAPI_MakeWire wire;
  for (const Edge& edge : loop) {
    const gp_Pnt from(edge.from.x, edge.from.y, 0), to(edge.to.x, edge.to.y, 0);
    if (!edge.is_arc()) {
      wire.Add(BRepBuilderAPI_MakeEdge(from, to));
      continue;
    }
    const gp_Dir axis(0, 0, edge.turn == Turn::kCounterClockwise ? 1 : -1);
    const gp_Circ circle(gp_Ax2(gp_Pnt(edge.center.x, edge.center.y, 0), axis), edge.radius());
    wire.Add(BRepBuilderAPI_MakeEdge(circle, from, to));
  }
  return wire;
}

/// What a region sweeps from z 0 down to z -depth.
TopoDS_Shape swept(const Region& region, double depth) {
  BRepBuilderAPI_MakeFace face(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), wire_of(region.outer()));
  for (const Loop& island : region.islands()) face.Add(wire_of(island));
  return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, -depth));
}

TopoDS_Shape block(const Box& plan, double height) {
  return BRepPrimAPI_MakeBox(gp_Pnt(plan.min.x, plan.min.y, -height), gp_Pnt(plan.max.x, plan.max.y, 0));
}

Loop rounded(const Box& box, double radius) {
  const double bulge = std::tan(kPi / 8);
  const double x0 = box.min.x, y0 = box.min.y, x1 = box.max.x, y1 = box.max.y, r = radius;
  const BulgeVertex vertices[] = {{{x0 + r, y0}, 0},     {{x1 - r, y0}, bulge}, {{x1, y0 + r}, 0},
                                  {{x1, y1 - r}, bulge}, {{x1 - r, y1}, 0},     {{x0 + r, y1}, bulge},
                                  {{x0, y1 - r}, 0},     {{x0, y0 + r}, bulge}};
  return loop_from_bulges(vertices);
}

Loop circle(Vec2 center, double radius) {
  const BulgeVertex vertices[] = {{center - Vec2{radius, 0}, 1}, {center + Vec2{radius, 0}, 1}};
  return loop_from_bulges(vertices);
}

TopoDS_Shape bracket(const std::filesystem::path& examples) {
  const Part part = read::read_part(examples / "bracket.json", {});
  return BRepAlgoAPI_Cut(block({{-10, -10}, {90, 60}}, 15), swept(part.features[0].target[0], 5));
}

/// A pocket with a boss, a deeper one in its floor with a hole through, and a notch open to one side.
TopoDS_Shape nested() {
  TopoDS_Shape shape = block({{0, 0}, {110, 80}}, 20);
  const auto cut = [&](const Loop& outer, const std::vector<Loop>& islands, double depth) {
    shape = BRepAlgoAPI_Cut(shape, swept(Region::from_valid_loops(outer, islands), depth));
  };
  cut(rounded({{10, 10}, {70, 70}}, 6), {circle({26, 56}, 5)}, 6);
  cut(rounded({{30, 16}, {62, 44}}, 6), {}, 12);
  cut(circle({46, 30}, 6), {}, 20);
  cut(rounded({{85, 20}, {130, 60}}, 6), {}, 4);
  return shape;
}

/// A pocket, a countersunk hole, a drilled one with its point, a corner cut off; and a hole across, a pocket
/// from below and one from the side.
TopoDS_Shape awkward() {
  TopoDS_Shape shape = block({{0, 0}, {120, 60}}, 30);
  const auto cut = [&](const TopoDS_Shape& tool) { shape = BRepAlgoAPI_Cut(shape, tool); };
  const gp_Dir down(0, 0, -1);
  cut(swept(Region::from_valid_loops(rounded({{10, 10}, {50, 50}}, 6), {}), 8));
  cut(swept(Region::from_valid_loops(circle({70, 15}, 8), {}), 10));
  cut(BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(70, 15, 0), down), 11, 8, 3));
  cut(swept(Region::from_valid_loops(circle({100, 15}, 3), {}), 12));
  cut(BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(100, 15, -12), down), 3, 0, 2));
  const Vec2 corner[] = {{110, 61}, {121, 50}, {121, 61}};
  cut(swept(Region::from_valid_loops(loop_from_points(corner), {}), 30));
  cut(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(70, -1, -22), gp_Dir(0, 1, 0)), 2.5, 62));
  cut(BRepPrimAPI_MakeBox(gp_Pnt(80, 30, -30), gp_Pnt(105, 45, -25)));
  cut(BRepPrimAPI_MakeBox(gp_Pnt(-1, 20, -28), gp_Pnt(5, 40, -20)));
  return shape;
}

/// A plate of 3 mm that stands on its edge: a pocket in the side that looks along +Y, and a hole through it.
TopoDS_Shape on_edge() {
  TopoDS_Shape shape = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(80, 3, 50));
  const auto cut = [&](const TopoDS_Shape& tool) { shape = BRepAlgoAPI_Cut(shape, tool); };
  cut(BRepPrimAPI_MakeBox(gp_Pnt(10, 2, 10), gp_Pnt(40, 4, 40)));
  cut(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(60, -1, 25), gp_Dir(0, 1, 0)), 6, 5));
  return shape;
}

/// A block with a pocket in the side that looks along -X alone.
TopoDS_Shape sideways() {
  TopoDS_Shape shape = block({{0, 0}, {20, 30}}, 40);
  return BRepAlgoAPI_Cut(shape, BRepPrimAPI_MakeBox(gp_Pnt(-1, 8, -30), gp_Pnt(6, 22, -10)));
}

/// A round plate with a hole through.
TopoDS_Shape disc() {
  TopoDS_Shape shape = swept(Region::from_valid_loops(circle({0, 0}, 30), {}), 6);
  return BRepAlgoAPI_Cut(shape, swept(Region::from_valid_loops(circle({0, 0}, 3), {}), 6));
}

/// A bracket that is milled from two sides: a pocket with a boss and a hole through it, a step with two holes above; below a
/// pocket, and counterbores about the holes.
TopoDS_Shape two_sided() {
  const Vec2 boss{32, 30}, low{77, 15}, high{77, 45};
  TopoDS_Shape shape = swept(Region::from_valid_loops(rounded({{0, 0}, {90, 60}}, 6), {}), 16);
  const auto cut = [&](const TopoDS_Shape& tool) { shape = BRepAlgoAPI_Cut(shape, tool); };
  const auto from_below = [&](const Loop& outline, double depth) {
    gp_Trsf down;
    down.SetTranslation(gp_Vec(0, 0, depth - 16));
    return BRepBuilderAPI_Transform(swept(Region::from_valid_loops(outline, {}), depth), down).Shape();
  };
  cut(swept(Region::from_valid_loops(rounded({{10, 10}, {54, 50}}, 6), {circle(boss, 8)}), 6));
  cut(BRepPrimAPI_MakeBox(gp_Pnt(64, -1, -5), gp_Pnt(91, 61, 1)));
  for (const Vec2 hole : {low, high}) cut(swept(Region::from_valid_loops(circle(hole, 3.3), {}), 16));
  cut(swept(Region::from_valid_loops(circle(boss, 4), {}), 16));
  cut(from_below(rounded({{8, 8}, {56, 52}}, 6), 4));
  for (const Vec2 hole : {low, high}) cut(from_below(circle(hole, 6), 5));
  return shape;
}

/// 3 mm high, its outline a spline and the line that closes it.
TopoDS_Shape pad() {
  constexpr int kPoints = 8;
  TColgp_Array1OfPnt points(1, kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double t = kPi * i / (kPoints - 1);
    points(i + 1) = gp_Pnt(30 + 10 * std::cos(t), 28 + 6 * std::sin(t) + 1.5 * std::sin(3 * t), 0);
  }
  BRepBuilderAPI_MakeWire outline(BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve()),
                                  BRepBuilderAPI_MakeEdge(points(kPoints), points(1)));
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 3));
}

/// A plate with a bent round rod of 4 mm on it, half a ring of 16 mm that stands upright, and a pad. The ring's seam runs along
/// the inside of the bend, where the kernel finds no thickness.
TopoDS_Shape handle() {
  const gp_Ax2 across(gp_Pnt(30, 20, 0), gp_Dir(0, 1, 0), gp_Dir(-1, 0, 0));
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(across, 8, 2, -kPi, kPi, kPi).Shape();
  return BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(block({{0, 0}, {60, 40}}, 10), ring), pad()).Shape();
}

struct NamedShape {
  const char* name;  ///< of the product; null for the kernel's own
  TopoDS_Shape shape;
};

/// A plate with a pocket, and two pins on it.
std::vector<NamedShape> plate_and_pins() {
  TopoDS_Shape plate = block({{0, 0}, {60, 40}}, 10);
  plate = BRepAlgoAPI_Cut(plate, swept(Region::from_valid_loops(rounded({{10, 10}, {40, 30}}, 4), {}), 4));
  const auto pin = [](double x) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, 20, 0), gp_Dir(0, 0, 1)), 3, 12).Shape();
  };
  return {{"PLATE", plate}, {"PIN", pin(48)}, {"PIN", pin(55)}};
}

/// The kernel's own names are numbered.
void name_last_product(STEPControl_Writer& writer, const char* name) {
  for (int i = writer.Model()->NbEntities(); i > 0; --i) {
    const auto product = Handle(StepBasic_Product)::DownCast(writer.Model()->Value(i));
    if (product.IsNull()) continue;
    product->SetName(new TCollection_HAsciiString(name));
    product->SetId(new TCollection_HAsciiString(name));
    return;
  }
}

void write(const std::vector<NamedShape>& shapes, const std::filesystem::path& file) {
  STEPControl_Writer writer;
  // Without curves in parameter space, which any reader finds again.
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
  for (const NamedShape& shape : shapes) {
    writer.Transfer(shape.shape, STEPControl_ManifoldSolidBrep);
    if (shape.name) name_last_product(writer, shape.name);
  }
  APIHeaderSection_MakeHeader header(writer.Model());
  header.SetName(new TCollection_HAsciiString(file.stem().c_str()));
  header.SetTimeStamp(new TCollection_HAsciiString("2024-01-01T00:00:00"));
  header.Apply(writer.Model());
  writer.Write(file.c_str());
}

void write(const TopoDS_Shape& shape, const std::filesystem::path& file) {
  write(std::vector<NamedShape>{{nullptr, shape}}, file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_solids <examples folder>\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  write(bracket(folder), folder / "bracket.step");
  write(nested(), folder / "nested.step");
  write(BRepBuilderAPI_NurbsConvert(nested()), folder / "nested_nurbs.step");
  write(awkward(), folder / "awkward.step");
  write(on_edge(), folder / "on_edge.step");
  write(sideways(), folder / "sideways.step");
  write(disc(), folder / "disc.step");
  write(two_sided(), folder / "two_sided.step");
  write(handle(), folder / "handle.step");
  write(plate_and_pins(), folder / "plate_and_pins.step");
  return 0;
}
