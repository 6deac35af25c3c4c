#include "faces.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_Plane.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>
#include <gp_Torus.hxx>

#include "base/elementary.h"
#include "base/units.h"
#include "read/common/curve_fit.h"

namespace clearcut {
namespace {

struct Range {
  double least = 0;
  double most = 0;
};

/// Range of a cos t + b sin t for t from `first` to `last`.
Range wave(double a, double b, double first, double last) {
  const auto at = [&](double t) { return a * base::cos(t) + b * base::sin(t); };
  const double height = base::hypot(a, b), crest = base::atan2(b, a);
  const auto reaches = [&](double t) { return t + 2 * kPi * std::ceil((first - t) / (2 * kPi)) <= last; };
  return {reaches(crest + kPi) ? -height : std::min(at(first), at(last)),
          reaches(crest) ? height : std::max(at(first), at(last))};
}

/// Range of a torus along one axis of space, from its middle. The coordinate of a point at u, v is (R + r cos v)
/// times the component of the direction of u along this axis, plus r sin v times the component of the torus' own
/// axis: for each v it is linear in the former component.
Range along(const gp_Torus& torus, int axis, const BRepAdaptor_Surface& part) {
  const double r = torus.MinorRadius();
  const Range turned = wave(torus.XAxis().Direction().Coord(axis), torus.YAxis().Direction().Coord(axis),
                            part.FirstUParameter(), part.LastUParameter());
  Range all{HUGE_VAL, -HUGE_VAL};
  for (const double a : {turned.least, turned.most}) {
    const Range round =
        wave(r * a, r * torus.Axis().Direction().Coord(axis), part.FirstVParameter(), part.LastVParameter());
    all.least = std::min(all.least, torus.MajorRadius() * a + round.least);
    all.most = std::max(all.most, torus.MajorRadius() * a + round.most);
  }
  return all;
}

Bnd_Box box_of_torus(const BRepAdaptor_Surface& part) {
  const gp_Torus torus = part.Torus();
  double low[3], high[3];
  for (int axis = 1; axis <= 3; ++axis) {
    const Range range = along(torus, axis, part);
    low[axis - 1] = torus.Location().Coord(axis) + range.least;
    high[axis - 1] = torus.Location().Coord(axis) + range.most;
  }
  Bnd_Box box;
  box.Update(low[0], low[1], low[2], high[0], high[1], high[2]);
  return box;
}

/// Whether the kernel computes boxes of such surfaces by formulas.
bool is_simple(GeomAbs_SurfaceType type) {
  return type == GeomAbs_Plane || type == GeomAbs_Cylinder || type == GeomAbs_Cone || type == GeomAbs_Sphere;
}

}  // namespace

Bnd_Box box_of(const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face);
  Bnd_Box box;
  if (surface.GetType() == GeomAbs_Torus) {
    box = box_of_torus(surface);
    box.Enlarge(BRep_Tool::Tolerance(face));
    return box;
  }
  BRepBndLib::Add(face, box, false);
  if (is_simple(surface.GetType())) return box;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
    BRepBndLib::Add(edges.Current(), box, false);
  return box;
}

Bnd_Box box_of_faces(const TopoDS_Shape& shape) {
  Bnd_Box box;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
    box.Add(box_of(TopoDS::Face(faces.Current())));
  return box;
}

namespace {

/// mm. Greatest distance of a surface from its plane: the least significant difference of heights.
constexpr double kFlat = 1e-4;

/// The plane of a flat surface, with its normal on the same side; null for surfaces that are not flat, or already
/// planes.
Handle(Geom_Plane) plane_of(const TopoDS_Face& face) {
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (surface.IsNull() || surface->IsKind(STANDARD_TYPE(Geom_Plane))) return nullptr;
  const GeomLib_IsPlanarSurface flat(surface, kFlat);
  if (!flat.IsPlanar()) return nullptr;
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  gp_Pnt middle;
  gp_Vec along_u, along_v;
  surface->D1((u0 + u1) / 2, (v0 + v1) / 2, middle, along_u, along_v);
  const gp_Vec normal = along_u.Crossed(along_v);
  if (normal.Magnitude() < 1e-12) return nullptr;
  gp_Dir direction = flat.Plan().Axis().Direction();
  if (normal.Dot(direction) < 0) direction.Reverse();
  return new Geom_Plane(gp_Pln(flat.Plan().Location(), direction));
}

TopoDS_Shape face_with_plane(const TopoDS_Face& face) {
  const Handle(Geom_Plane) plane = plane_of(face);
  if (plane.IsNull()) return face;
  const BRep_Builder builder;
  TopoDS_Face out = TopoDS::Face(face.EmptyCopied());
  builder.UpdateFace(out, plane, TopLoc_Location(), BRep_Tool::Tolerance(face));
  builder.NaturalRestriction(out, false);
  for (TopoDS_Iterator wires(face, false, false); wires.More(); wires.Next()) builder.Add(out, wires.Value());
  return out;
}

}  // namespace

TopoDS_Shape with_planes(const TopoDS_Shape& shape) {
  if (shape.ShapeType() == TopAbs_FACE) return face_with_plane(TopoDS::Face(shape));
  if (shape.ShapeType() > TopAbs_FACE) return shape;
  const BRep_Builder builder;
  TopoDS_Shape out = shape.EmptyCopied();
  for (TopoDS_Iterator parts(shape, false, false); parts.More(); parts.Next())
    builder.Add(out, with_planes(parts.Value()));
  return out;
}

namespace {

/// Radians between neighbouring triangles: the distance to the face decides.
constexpr double kTurn = 1;
/// Least tolerance as a share of the face's size. Finer triangles of large faces take too long.
constexpr double kFinest = 1.0 / 20000;
/// mm2. Smaller triangles in plan view are vertical.
constexpr double kUpright = 1e-12;

double fineness(const TopoDS_Face& face) {
  const Bnd_Box box = box_of(face);
  return std::max(read::kCurveTolerance, std::sqrt(box.SquareExtent()) * kFinest);
}

}  // namespace

std::vector<Path> shadow_of(const TopoDS_Face& face) {
  BRepTools::Clean(face);
  const BRepMesh_IncrementalMesh mesh(face, fineness(face), false, kTurn);
  TopLoc_Location place;
  const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, place);
  std::vector<Path> shadow;
  if (triangles.IsNull()) return shadow;
  const auto plan_of = [&](int node) {
    const gp_Pnt p = triangles->Node(node).Transformed(place.Transformation());
    return Vec2{p.X(), p.Y()};
  };
  for (int i = 1; i <= triangles->NbTriangles(); ++i) {
    int nodes[3] = {};
    triangles->Triangle(i).Get(nodes[0], nodes[1], nodes[2]);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(nodes[1], nodes[2]);
    const Vec2 a = plan_of(nodes[0]), b = plan_of(nodes[1]), c = plan_of(nodes[2]);
    if (cross(b - a, c - a) <= kUpright) continue;
    shadow.push_back({Edge::line(a, b), Edge::line(b, c), Edge::line(c, a)});
  }
  return shadow;
}

}  // namespace clearcut
