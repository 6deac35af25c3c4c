#include "planes.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Pln.hxx>

namespace clearcut {
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

}  // namespace clearcut
