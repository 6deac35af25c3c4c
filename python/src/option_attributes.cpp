#include "option_attributes.h"

#include <clearcut/options.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace clearcut::python {
namespace {

using Pair = std::pair<double, double>;

/// The value as Python has it; None for none, and an empty list for rows with several values.
py::object shown(const Row& row, const std::optional<Value>& value) {
  if (!value) return takes_several(row.kind) ? py::object(py::list()) : py::none();
  if (const double* const number = std::get_if<double>(&*value); number && row.kind == ValueKind::kWhole)
    return py::int_(std::llround(*number));
  if (row.kind == ValueKind::kSeed) return py::int_(py::str(std::get<std::string>(*value)));
  if (const Vec2* const point = std::get_if<Vec2>(&*value)) return py::cast(Pair(point->x, point->y));
  if (const auto* const points = std::get_if<std::vector<Vec2>>(&*value)) {
    py::list places;
    for (const Vec2 point : *points) places.append(py::cast(Pair(point.x, point.y)));
    return places;
  }
  return std::visit([](const auto& one) -> py::object { return py::cast(one); }, *value);
}

/// What Python states; numbers also as text with a unit, as on the command line. Throws InputError for values that the row
/// refuses.
Value value_of(const Row& row, const py::object& given, const std::string& place) {
  const auto checked = [&](Value value) {
    check_value(row, value, place);
    return value;
  };
  if (row.kind == ValueKind::kFlag) return given.cast<bool>();
  if (takes_several(row.kind) && row.kind != ValueKind::kPoints)
    return checked(given.cast<std::vector<std::string>>());
  if (row.kind == ValueKind::kPoints) {
    std::vector<Vec2> points;
    for (const auto& [x, y] : given.cast<std::vector<Pair>>()) points.push_back({x, y});
    return checked(std::move(points));
  }
  if (row.kind == ValueKind::kPoint) {
    const auto [x, y] = given.cast<Pair>();
    return checked(Vec2{x, y});
  }
  if (is_number(row.kind) && !py::isinstance<py::str>(given)) return checked(given.cast<double>());
  const bool may_be_number = row.kind == ValueKind::kStepover || row.kind == ValueKind::kSeed;
  return value_of_text(row, may_be_number ? py::str(given).cast<std::string>() : given.cast<std::string>(),
                       place);
}

/// "no-arcs" is the attribute `arcs`, which states the opposite.
std::string attribute_of(const Row& row) {
  std::string name = row.key_is_opposite ? row.name.substr(3) : row.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::optional<Value> opposite(std::optional<Value> value) {
  if (value) value = Value(!std::get<bool>(*value));
  return value;
}

void add_row(OptionsClass& options, const Row& row) {
  options.def_property(
      attribute_of(row).c_str(),
      [&row](const AskedOptions& given) {
        const Asked asked{given, {}};
        const auto value = row.field.get(asked, row.names);
        return shown(row, row.key_is_opposite ? opposite(value) : value);
      },
      [&row](AskedOptions& given, const py::object& value) {
        std::optional<Value> stated;
        if (!value.is_none()) stated = value_of(row, value, "--" + row.name);
        if (row.key_is_opposite) stated = opposite(stated);
        PlanOptions& plan = given;
        Asked asked{std::move(plan), {}};
        row.field.clear(asked);
        if (stated) row.field.set(asked, *stated, row.names);
        plan = std::move(asked.plan);
      },
      row.described().c_str());
}

}  // namespace

void add_rows(OptionsClass& options) {
  for (const Row& row : rows())
    if (row.field.is_of_plan) add_row(options, row);
}

}  // namespace clearcut::python
