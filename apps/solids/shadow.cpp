#include "shadow.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <algorithm>
#include <cmath>

#include "boxes.h"
#include "read/common/curve_fit.h"

namespace clearcut {
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
