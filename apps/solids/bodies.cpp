#include "bodies.h"

#include <Interface_InterfaceModel.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>

#include "base/error.h"

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

}  // namespace clearcut
