#include "boxes.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Torus.hxx>

#include "base/elementary.h"
#include "base/units.h"

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

}  // namespace clearcut
