// From the CAD kernel's shapes to the faces used by the library.
#include "solid_answer.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <ctime>
#include <iostream>
#include <sstream>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "bodies.h"
#include "faces.h"
#include "read/common/curve_fit.h"
#include "read/step_solid/solid_model.h"

namespace clearcut {
namespace {

/// A direction's component below this counts as zero: 1 um over a metre.
constexpr double kSquare = 1e-6;
/// mm. Shorter edges in plan view are vertical edges of the solid.
constexpr double kVertical = 1e-6;
/// mm. The kernel's box is replaced by the faces' own extents if it differs by less.
constexpr double kBoxSlack = 1e-3;

Vec2 plan_of(const gp_Pnt& p) {
  return {p.X(), p.Y()};
}

std::string surface_name(GeomAbs_SurfaceType type) {
  switch (type) {
    case GeomAbs_Plane:
      return "plane";
    case GeomAbs_Cylinder:
      return "cylinder";
    case GeomAbs_Cone:
      return "cone";
    case GeomAbs_Sphere:
      return "sphere";
    case GeomAbs_Torus:
      return "torus";
    default:
      return "free surface";
  }
}

/// A horizontal circle or part of it, in the direction of its parameter.
Path circular(const gp_Circ& circle, double first, double last) {
  const Vec2 center = plan_of(circle.Location());
  const auto turn = circle.Axis().Direction().Z() > 0 ? Turn::kCounterClockwise : Turn::kClockwise;
  const auto at = [&](double t) {
    const gp_XYZ p = circle.Location().XYZ() +
                     circle.XAxis().Direction().XYZ() * (circle.Radius() * base::cos(t)) +
                     circle.YAxis().Direction().XYZ() * (circle.Radius() * base::sin(t));
    return Vec2{p.X(), p.Y()};
  };
  const double middle = (first + last) / 2;
  const bool full = last - first > 2 * kPi - 1e-9;
  const Vec2 end = full ? at(first) : at(last);
  if (!full && last - first < 1.5 * kPi) return {Edge::arc(at(first), end, center, turn)};
  return {Edge::arc(at(first), at(middle), center, turn), Edge::arc(at(middle), end, center, turn)};
}

/// An edge in plan view, in the sense of its orientation; empty for vertical ones.
Path projected(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return {};
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  const Vec2 from = plan_of(curve.Value(first)), to = plan_of(curve.Value(last));
  Path path;
  if (curve.GetType() == GeomAbs_Line) {
    if (distance(from, to) > kVertical) path = {Edge::line(from, to)};
  } else if (curve.GetType() == GeomAbs_Circle &&
             std::abs(curve.Circle().Axis().Direction().Z()) > 1 - kSquare * kSquare) {
    path = circular(curve.Circle(), first, last);
  } else {
    read::append_fitted([&](double t) { return plan_of(curve.Value(first + t * (last - first))); },
                        read::kCurveTolerance, path);
  }
  return edge.Orientation() == TopAbs_REVERSED ? reversed(path) : path;
}

gp_Vec outward(const BRepAdaptor_Surface& surface, const TopoDS_Face& face, double u, double v) {
  gp_Pnt p;
  gp_Vec du, dv;
  surface.D1(u, v, p, du, dv);
  gp_Vec normal = du.Crossed(dv);
  if (normal.Magnitude() < 1e-12) return {0, 0, 0};
  normal.Normalize();
  if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
  return normal;
}

/// By the normals on a grid over the face; one of them for a plane.
read::Facing facing_of(const BRepAdaptor_Surface& surface, const TopoDS_Face& face) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  const int steps = surface.GetType() == GeomAbs_Plane ? 1 : 16;
  bool up = false, down = false;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const double z = outward(surface, face, u0 + (u1 - u0) * i / steps, v0 + (v1 - v0) * j / steps).Z();
      up = up || z > kSquare;
      down = down || z < -kSquare;
    }
  }
  if (up && down) return read::Facing::kMixed;
  if (up) return read::Facing::kUp;
  return down ? read::Facing::kDown : read::Facing::kUpright;
}

/// The middle of the longest edge at the face's lowest height; of its box if it has none there.
Vec2 middle_of_foot(const TopoDS_Face& face, const read::SolidFace& described) {
  Vec2 middle = described.plan.center();
  double longest = 0;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    const gp_Pnt from = curve.Value(curve.FirstParameter()), to = curve.Value(curve.LastParameter());
    const double across = base::hypot(to.X() - from.X(), to.Y() - from.Y());
    if (std::max(from.Z(), to.Z()) > described.z_low + kBoxSlack || across <= longest) continue;
    longest = across;
    middle = {(from.X() + to.X()) / 2, (from.Y() + to.Y()) / 2};
  }
  return middle;
}

std::optional<read::WallFront> front_of(const TopoDS_Face& face, const gp_Vec& normal,
                                        const read::SolidFace& described) {
  if (std::abs(normal.Z()) > kSquare) return std::nullopt;
  if (std::abs(normal.X()) > kSquare && std::abs(normal.Y()) > kSquare) return std::nullopt;
  const Vec2 outward_plan{std::round(normal.X()), std::round(normal.Y())};
  return read::WallFront{outward_plan, middle_of_foot(face, described) + outward_plan * 0.01};
}

void take_nearest(double& value, double candidate) {
  if (std::abs(value - candidate) < kBoxSlack) value = candidate;
}

/// Radians between the vertical and a plane or an upright cone; 0 for other surfaces, and for level and upright
/// planes.
double lean_of(const BRepAdaptor_Surface& surface, const read::SolidFace& face, const gp_Vec& normal) {
  if (face.facing != read::Facing::kUp || face.level) return 0;
  if (surface.GetType() == GeomAbs_Plane) return kPi / 2 - normal.Angle(gp_Vec(0, 0, 1));
  const bool is_upright_cone = surface.GetType() == GeomAbs_Cone &&
                               std::abs(surface.Cone().Axis().Direction().Z()) > 1 - kSquare * kSquare;
  return is_upright_cone ? std::abs(surface.Cone().SemiAngle()) : 0;
}

/// mm; radius of the circle of a cylinder, torus or ball.
double radius_of(const BRepAdaptor_Surface& surface) {
  switch (surface.GetType()) {
    case GeomAbs_Cylinder:
      return surface.Cylinder().Radius();
    case GeomAbs_Sphere:
      return surface.Sphere().Radius();
    case GeomAbs_Torus:
      return surface.Torus().MinorRadius();
    default:
      return 0;
  }
}

/// mm; the radius of a face that is level at its lowest place and vertical at its highest, a radius above; 0 for all
/// others.
double fillet_of(const BRepAdaptor_Surface& surface, const TopoDS_Face& shape, const read::SolidFace& face) {
  const double radius = radius_of(surface);
  if (radius <= 0 || face.facing != read::Facing::kUp ||
      std::abs(face.z_high - face.z_low - radius) > kBoxSlack)
    return 0;
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  BRepTools::UVBounds(shape, u0, u1, v0, v1);
  constexpr int kSteps = 16;
  constexpr double kLevel = 0.99;
  double lowest = HUGE_VAL, up = 0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double u = u0 + (u1 - u0) * i / kSteps, v = v0 + (v1 - v0) * j / kSteps;
      const double z = surface.Value(u, v).Z();
      const gp_Vec normal = outward(surface, shape, u, v);
      // The pole of a ball has no normal there.
      if (z < lowest - kBoxSlack || (z < lowest + kBoxSlack && normal.Z() > up)) {
        lowest = std::min(lowest, z);
        up = normal.Magnitude() > 0 ? normal.Z() : 1;
      }
    }
  }
  return up > kLevel ? radius : 0;
}

/// Whether a whole edge is at a height.
bool is_at(const TopoDS_Edge& edge, double z) {
  if (BRep_Tool::Degenerated(edge)) return false;
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  for (const double t : {first, (first + last) / 2, last})
    if (std::abs(curve.Value(t).Z() - z) > kBoxSlack / 10) return false;
  return true;
}

/// Takes the heights of a plane or cone from its edges, for the kernel's boxes may be larger; z of the lowest, mm.
double take_heights(const TopoDS_Face& face, read::SolidFace& out) {
  double lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    if (BRep_Tool::Degenerated(edge)) continue;
    const BRepAdaptor_Curve curve(edge);
    for (const double t : {curve.FirstParameter(), curve.LastParameter()}) {
      lowest = std::min(lowest, curve.Value(t).Z());
      highest = std::max(highest, curve.Value(t).Z());
    }
  }
  take_nearest(out.z_low, lowest);
  take_nearest(out.z_high, highest);
  return lowest;
}

read::SolidFace face_of(const TopoDS_Face& face, int number) {
  const BRepAdaptor_Surface surface(face);
  read::SolidFace out;
  out.number = number;
  out.surface = surface_name(surface.GetType());
  out.facing = facing_of(surface, face);
  const Bnd_Box box = box_of(face);
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  box.Get(x0, y0, out.z_low, x1, y1, out.z_high);
  out.plan = {{x0, y0}, {x1, y1}};
  if (surface.GetType() == GeomAbs_Plane) {
    const gp_Vec normal = outward(surface, face, 0, 0);
    out.level = std::abs(normal.Z()) > 1 - kSquare * kSquare;
    if (out.level) out.z_low = out.z_high = surface.Plane().Location().Z();
    out.front = front_of(face, normal, out);
  }
  if (out.facing == read::Facing::kMixed) out.outline = shadow_of(face);
  if (out.facing != read::Facing::kUp) return out;
  out.lean = lean_of(surface, out, outward(surface, face, 0, 0));
  out.fillet = fillet_of(surface, face, out);
  const double foot = out.lean > 0 ? take_heights(face, out) : 0;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    Path path = projected(TopoDS::Edge(edges.Current()));
    if (path.empty()) continue;
    if (out.lean > 0 && is_at(TopoDS::Edge(edges.Current()), foot)) out.foot.push_back(path);
    out.outline.push_back(std::move(path));
  }
  return out;
}

/// The box of the whole, exact if determined by lines, circles and levels.
void set_box(const Bnd_Box& box, read::SolidModel& solid) {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  box.Get(x0, y0, solid.z_bottom, x1, y1, solid.z_top);
  Box edges;
  for (const read::SolidFace& face : solid.faces) {
    for (const Path& path : face.outline) edges.add(clearcut::box(path));
    if (!face.level) continue;
    take_nearest(solid.z_bottom, face.z_low);
    take_nearest(solid.z_top, face.z_high);
  }
  solid.plan = {{x0, y0}, {x1, y1}};
  if (edges.empty()) return;
  take_nearest(solid.plan.min.x, edges.min.x);
  take_nearest(solid.plan.min.y, edges.min.y);
  take_nearest(solid.plan.max.x, edges.max.x);
  take_nearest(solid.plan.max.y, edges.max.y);
}

/// Orients closed solids outwards; kept as one shape, so that faces are numbered once.
TopoDS_Compound facing_outwards(const std::vector<NamedBody>& bodies) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const NamedBody& body : bodies) {
    TopoDS_Solid solid = TopoDS::Solid(with_planes(body.solid));
    BRepLib::OrientClosedSolid(solid);
    builder.Add(all, solid);
  }
  return all;
}

read::SolidBody described(const NamedBody& body) {
  const Bnd_Box box = box_of_faces(body.solid);
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
  if (!box.IsVoid()) box.Get(x0, y0, z0, x1, y1, z1);
  return {body.name, x1 - x0, y1 - y0, z1 - z0};
}

/// Faces and box of the solid viewed from above.
void see_from_above(const TopoDS_Shape& shape, read::SolidModel& solid) {
  Bnd_Box box;
  box.SetGap(0);
  for (TopExp_Explorer bodies(shape, TopAbs_SOLID); bodies.More(); bodies.Next())
    BRepBndLib::AddOptimal(bodies.Current(), box, false, false);
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
    solid.faces.push_back(face_of(TopoDS::Face(faces.Current()), static_cast<int>(solid.faces.size()) + 1));
  if (!solid.faces.empty() && !box.IsVoid()) set_box(box, solid);
}

/// Prints on standard error the processor time of the stages: the kernel's own reading comprises the file and the
/// shapes.
class Stages {
 public:
  void end(const char* stage) {
    const std::clock_t now = std::clock();
    std::cerr << stage << ": " << static_cast<double>(now - began_) / CLOCKS_PER_SEC << " s\n";
    began_ = now;
  }

 private:
  std::clock_t began_ = std::clock();
};

[[noreturn]] void refuse_nothing(const std::string& file_name) {
  throw InputError(file_name, "the STEP file holds no solid; export the part as a solid body");
}

read::SolidModel read_with_kernel(std::string_view text, const std::string& file_name,
                                  const read::SolidChoice& choice) {
  Stages stages;
  STEPControl_Reader reader;
  std::istringstream stream{std::string(text)};
  if (reader.ReadStream(file_name.c_str(), stream) != IFSelect_RetDone)
    throw InputError(file_name, "Open CASCADE cannot read this STEP file; export the solid again");
  stages.end("file");
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull()) refuse_nothing(file_name);
  stages.end("shapes");
  const std::vector<NamedBody> bodies = bodies_of(reader, shape);
  if (bodies.empty()) refuse_nothing(file_name);
  const std::vector<NamedBody> wanted = chosen(bodies, choice.body, file_name);
  read::SolidModel solid;
  for (const NamedBody& body : wanted.empty() ? bodies : wanted) solid.bodies.push_back(described(body));
  if (wanted.empty()) return solid;
  const TopoDS_Compound outwards = facing_outwards(wanted);
  see_from_above(placed(outwards, choice.up, choice.turn, file_name), solid);
  if (solid.faces.empty()) refuse_nothing(file_name);
  stages.end("view from above");
  solid.sides = flat_sides(outwards);
  stages.end("flat sides");
  return solid;
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

}  // namespace

std::string solid_answer(std::string_view text, const std::string& file_name,
                         const read::SolidChoice& choice) {
  try {
    return "S" + read::bytes_of(read_with_kernel(text, file_name, choice));
  } catch (const InputError& error) {
    return std::string("E") + error.what();
  } catch (const Standard_Failure& failure) {
    const char* reason = failure.GetMessageString();
    return "E" + file_name + ": Open CASCADE cannot read this solid (" + failure.DynamicType()->Name() +
           (reason && *reason ? ": " + one_line(reason) : "") + "); export it again";
  }
}

}  // namespace clearcut
