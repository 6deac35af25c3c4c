#include "bodies.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Interface_InterfaceModel.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <gp_Pln.hxx>
#include <gp_Quaternion.hxx>
#include <gp_Trsf.hxx>
#include <map>
#include <optional>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"

namespace clearcut {
namespace {

/// Identity of a solid, independent of its place in an assembly.
using Geometry = const TopoDS_TShape*;

struct Product {
  std::string name;
  int solids = 0;
};

std::string text_of(const Handle(TCollection_HAsciiString) & text) {
  return text.IsNull() ? std::string() : std::string(text->ToCString());
}

std::string name_of(const Handle(StepBasic_ProductDefinition) & definition) {
  if (definition->Formation().IsNull() || definition->Formation()->OfProduct().IsNull()) return {};
  const auto product = definition->Formation()->OfProduct();
  const std::string name = text_of(product->Name());
  return name.empty() ? text_of(product->Id()) : name;
}

/// For each solid, the product containing it with the fewest solids: the part, not the assembly.
std::map<Geometry, Product> products_of(const STEPControl_Reader& reader) {
  std::map<Geometry, Product> products;
  const auto model = reader.WS()->Model();
  const auto process = reader.WS()->TransferReader()->TransientProcess();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto definition = Handle(StepBasic_ProductDefinition)::DownCast(model->Value(i));
    if (definition.IsNull()) continue;
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process, definition);
    if (shape.IsNull()) continue;
    std::vector<Geometry> inside;
    for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
      inside.push_back(solids.Current().TShape().get());
    const Product product{name_of(definition), static_cast<int>(inside.size())};
    for (const Geometry solid : inside) {
      Product& known = products[solid];
      if (known.solids == 0 || product.solids < known.solids) known = product;
    }
  }
  return products;
}

std::string own_name(const STEPControl_Reader& reader, const TopoDS_Solid& solid) {
  const auto entity = reader.WS()->TransferReader()->EntityFromShapeResult(solid, -1);
  const auto item = Handle(StepRepr_RepresentationItem)::DownCast(entity);
  return item.IsNull() ? std::string() : text_of(item->Name());
}

std::string capitals_of(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::size_t number_of(const std::string& text) {
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc() && read.ptr == end ? number : 0;
}

}  // namespace

std::vector<NamedBody> bodies_of(STEPControl_Reader& reader, const TopoDS_Shape& shape) {
  const auto products = products_of(reader);
  std::vector<NamedBody> bodies;
  for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next()) {
    NamedBody body{TopoDS::Solid(solids.Current()), {}};
    const auto product = products.find(body.solid.TShape().get());
    if (product != products.end()) body.name = product->second.name;
    const bool shared = product == products.end() || product->second.solids > 1;
    const std::string own = shared || body.name.empty() ? own_name(reader, body.solid) : std::string();
    if (!own.empty()) body.name = own;
    bodies.push_back(std::move(body));
  }
  return bodies;
}

std::vector<NamedBody> chosen(const std::vector<NamedBody>& bodies, const std::string& choice,
                              const std::string& file_name) {
  if (choice.empty()) return bodies.size() == 1 ? bodies : std::vector<NamedBody>{};
  if (capitals_of(choice) == "ALL") return bodies;
  std::vector<NamedBody> found;
  for (const NamedBody& body : bodies)
    if (capitals_of(body.name) == capitals_of(choice)) found.push_back(body);
  const std::size_t number = number_of(choice);
  if (found.empty() && number >= 1 && number <= bodies.size()) return {bodies[number - 1]};
  if (found.empty())
    throw InputError(file_name,
                     "--body '" + choice + "': the file holds " + std::to_string(bodies.size()) +
                         " bodies and none of that name or number; `--body all` takes them as one part");
  const bool same = std::all_of(found.begin(), found.end(), [&](const NamedBody& body) {
    return body.solid.IsPartner(found.front().solid);
  });
  if (!same)
    throw InputError(file_name, "--body '" + choice + "': " + std::to_string(found.size()) +
                                    " different bodies have this name; give the number");
  return {found.front()};
}

namespace {

/// Components of unit vectors differing by less are equal: 1 um over a metre.
constexpr double kSameDirection = 1e-6;
/// mm. Planes nearer to each other than this are at one height.
constexpr double kSamePlane = 1e-4;

struct Axis {
  const char* name;
  gp_XYZ direction;
  /// Rows of the rotation that makes the side face +Z.
  gp_XYZ x, y;
};

const Axis kAxes[] = {{"+Z", {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {"-Z", {0, 0, -1}, {1, 0, 0}, {0, -1, 0}},
                      {"+X", {1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {"-X", {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                      {"+Y", {0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {"-Y", {0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};

gp_Trsf turn_of_rows(const gp_XYZ& x, const gp_XYZ& y, const gp_XYZ& z) {
  gp_Trsf turn;
  turn.SetValues(x.X(), x.Y(), x.Z(), 0, y.X(), y.Y(), y.Z(), 0, z.X(), z.Y(), z.Z(), 0);
  return turn;
}

const Axis* axis_along(const gp_XYZ& direction) {
  const auto found = std::find_if(std::begin(kAxes), std::end(kAxes), [&](const Axis& axis) {
    return (axis.direction - direction).Modulus() < kSameDirection;
  });
  return found == std::end(kAxes) ? nullptr : found;
}

/// The outside's unit normal; nothing if the face is not flat.
std::optional<gp_XYZ> flat_normal(const BRepAdaptor_Surface& surface, const TopoDS_Face& face) {
  if (surface.GetType() != GeomAbs_Plane) return std::nullopt;
  const gp_Ax3 position = surface.Plane().Position();
  gp_XYZ normal = position.Direction().XYZ();
  if (!position.Direct()) normal.Reverse();
  if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
  return normal;
}

std::optional<int> face_number(const std::string& up) {
  if (up.rfind("face", 0) != 0) return std::nullopt;
  int number = 0;
  const char* end = up.data() + up.size();
  const auto read = std::from_chars(up.data() + 4, end, number);
  if (read.ec != std::errc() || read.ptr != end || number < 1) return std::nullopt;
  return number;
}

gp_XYZ normal_of_face(const TopoDS_Shape& shape, int number, const std::string& file_name) {
  TopExp_Explorer faces(shape, TopAbs_FACE);
  for (int i = 1; i < number && faces.More(); ++i) faces.Next();
  if (!faces.More())
    throw InputError(file_name, "--up face" + std::to_string(number) + ": the solid has no such face");
  const TopoDS_Face face = TopoDS::Face(faces.Current());
  const auto normal = flat_normal(BRepAdaptor_Surface(face), face);
  if (!normal)
    throw InputError(file_name,
                     "--up face" + std::to_string(number) + ": this face is not flat; name a flat one");
  return *normal;
}

gp_Trsf raising(const TopoDS_Shape& shape, const std::string& up, const std::string& file_name) {
  for (const Axis& axis : kAxes)
    if (up == axis.name) return turn_of_rows(axis.x, axis.y, axis.direction);
  const auto number = face_number(up);
  if (!number)
    throw InputError("--up",
                     "'" + up + "' is unknown; use +Z, -Z, +X, -X, +Y, -Y, or face12 for a flat face");
  const gp_XYZ normal = normal_of_face(shape, *number, file_name);
  if (const Axis* axis = axis_along(normal)) return turn_of_rows(axis->x, axis->y, axis->direction);
  gp_Trsf turn;
  turn.SetRotation(gp_Quaternion(gp_Vec(normal), gp_Vec(0, 0, 1)));
  return turn;
}

gp_Trsf about_vertical(double degrees) {
  const double quarters = degrees / 90;
  double sine = base::sin(degrees * kPi / 180), cosine = base::cos(degrees * kPi / 180);
  if (quarters == std::round(quarters)) {
    sine = std::round(sine);
    cosine = std::round(cosine);
  }
  return turn_of_rows({cosine, -sine, 0}, {sine, cosine, 0}, {0, 0, 1});
}

/// Sides while they are gathered.
struct Side {
  gp_XYZ direction;
  read::FlatSide flat;
  std::vector<double> heights;
};

Side& side_along(std::vector<Side>& sides, const gp_XYZ& direction, int number) {
  for (Side& side : sides)
    if ((side.direction - direction).Modulus() < kSameDirection) return side;
  const Axis* axis = axis_along(direction);
  Side side{direction, {}, {}};
  side.flat.up = axis ? axis->name : "face" + std::to_string(number);
  const double across = base::hypot(direction.X(), direction.Y());
  side.flat.lean = base::atan2(across, direction.Z()) * 180 / kPi;
  sides.push_back(std::move(side));
  return sides.back();
}

/// mm; 0 if no flat side faces the opposite direction.
double thickness_along(const Side& side, const std::vector<Side>& sides) {
  for (const Side& other : sides)
    if ((side.direction + other.direction).Modulus() < kSameDirection)
      return side.heights.back() + other.heights.back();
  return 0;
}

bool comes_before(const read::FlatSide& a, const read::FlatSide& b) {
  if (std::abs(a.area - b.area) > 1e-6 * (a.area + b.area)) return a.area > b.area;
  return a.heights > b.heights;
}

}  // namespace

TopoDS_Shape placed(const TopoDS_Shape& shape, const std::string& up, double degrees,
                    const std::string& file_name) {
  gp_Trsf turn;
  if (!up.empty() && up != "+Z") turn = raising(shape, up, file_name);
  if (degrees != 0) turn.PreMultiply(about_vertical(degrees));
  if (turn.Form() == gp_Identity) return shape;
  return shape.Moved(TopLoc_Location(turn));
}

std::vector<read::FlatSide> flat_sides(const TopoDS_Shape& shape) {
  constexpr std::size_t kMostSides = 64;  // a tessellated solid has a side for every facet
  std::vector<Side> sides;
  int number = 0;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    ++number;
    const TopoDS_Face face = TopoDS::Face(faces.Current());
    const BRepAdaptor_Surface surface(face);
    const auto normal = flat_normal(surface, face);
    if (!normal || (sides.size() >= kMostSides && !axis_along(*normal))) continue;
    Side& side = side_along(sides, *normal, number);
    GProp_GProps area;
    BRepGProp::SurfaceProperties(face, area);
    side.flat.area += std::abs(area.Mass());
    side.heights.push_back(surface.Plane().Location().XYZ().Dot(*normal));
  }
  std::vector<read::FlatSide> out;
  for (Side& side : sides) std::sort(side.heights.begin(), side.heights.end());
  for (Side& side : sides) {
    side.flat.thickness = thickness_along(side, sides);
    const auto same = [](double a, double b) { return b - a < kSamePlane; };
    const auto last = std::unique(side.heights.begin(), side.heights.end(), same);
    side.flat.heights = static_cast<int>(last - side.heights.begin());
    side.heights.erase(last, side.heights.end());
    out.push_back(side.flat);
  }
  std::stable_sort(out.begin(), out.end(), comes_before);
  return out;
}

}  // namespace clearcut
