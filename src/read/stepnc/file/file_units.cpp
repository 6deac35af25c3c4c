#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "read/stepnc/file/entity_list.h"

namespace clearcut::read::stepnc {
namespace {

/// Units that are converted from others that are converted, before it counts as a circle.
constexpr int kMostConversions = 8;
/// Of two factors: less is rounding of the decimals that files write.
constexpr double kSameFactor = 1e-6;

struct Prefix {
  std::string_view name;
  double factor;
};
constexpr Prefix kPrefixes[] = {{"KILO", 1e3},   {"HECTO", 1e2},  {"DECA", 10},    {"DECI", 0.1},
                                {"CENTI", 0.01}, {"MILLI", 1e-3}, {"MICRO", 1e-6}, {"NANO", 1e-9}};

enum class Quantity { kLength, kAngle, kOther };

/// Of a length mm, of an angle radians.
struct Unit {
  Quantity quantity = Quantity::kOther;
  double size = 1;
};

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    const auto capital = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; };
    return capital(x) == capital(y);
  });
}

class UnitReader {
 public:
  UnitReader(const P21File& file, Diagnostics& diagnostics) : file_(file), diagnostics_(diagnostics) {}

  FileUnits read() {
    for (const P21Entity& entity : file_.entities) {
      const P21Record* context = record(entity, "GLOBAL_UNIT_ASSIGNED_CONTEXT");
      if (context) assign(entity, *context);
    }
    FileUnits units;
    if (length_) units.mm_per_length = length_->size;
    if (angle_) units.radians_per_angle = angle_->size;
    if (length_ && std::abs(length_->size - 1) > kSameFactor)
      diagnostics_.note(file_.place(length_->line), "lengths of the file are read in units of " +
                                                        trimmed(length_->size, 6) +
                                                        " mm, as its global unit says");
    if (!length_) warn_of_loose_units();
    return units;
  }

 private:
  struct Assigned {
    double size = 1;
    int line = 0;
  };

  const P21Record* record(const P21Entity& entity, std::string_view keyword) const {
    for (const P21Record& one : file_.records_of(entity))
      if (same_word(one.keyword, keyword)) return &one;
    return nullptr;
  }

  [[noreturn]] void fail(const P21Entity& entity, const std::string& what) const {
    throw InputError(file_.place(entity.line), "#" + std::to_string(entity.id) + ": " + what);
  }

  const P21Entity& referred(const P21Entity& from, const P21Value& value) const {
    const P21Entity* entity = value.kind == P21Kind::kReference ? file_.find(value.id) : nullptr;
    if (entity == nullptr) fail(from, "a unit is missing that it refers to; add it");
    return *entity;
  }

  void assign(const P21Entity& entity, const P21Record& context) {
    const auto arguments = file_.arguments(context);
    if (arguments.empty() || arguments[0].kind != P21Kind::kList) return;
    for (const P21Value& value : file_.children(arguments[0])) {
      const P21Entity& stated = referred(entity, value);
      const Unit unit = unit_of(stated, 0);
      if (unit.quantity == Quantity::kLength) take(length_, unit, stated, "length");
      if (unit.quantity == Quantity::kAngle) take(angle_, unit, stated, "plane angle");
    }
  }

  void take(std::optional<Assigned>& assigned, const Unit& unit, const P21Entity& entity, const char* what) {
    if (assigned && std::abs(assigned->size / unit.size - 1) > kSameFactor)
      fail(entity, std::string("a second unit of ") + what + ", another than on line " +
                       std::to_string(assigned->line) + "; write the file in one");
    if (!assigned) assigned = Assigned{unit.size, entity.line};
  }

  Unit unit_of(const P21Entity& entity, int depth) const {
    if (depth > kMostConversions) fail(entity, "its unit is converted from itself; correct it");
    const bool is_length = record(entity, "LENGTH_UNIT") != nullptr;
    const bool is_angle = record(entity, "PLANE_ANGLE_UNIT") != nullptr;
    if (!is_length && !is_angle) return {};
    Unit unit{is_length ? Quantity::kLength : Quantity::kAngle, 1};
    if (const P21Record* si = record(entity, "SI_UNIT")) {
      unit.size = si_size(entity, *si, unit.quantity);
    } else if (const P21Record* conversion = record(entity, "CONVERSION_BASED_UNIT")) {
      unit.size = converted_size(entity, *conversion, unit.quantity, depth);
    } else {
      fail(entity, "its unit is neither an SI_UNIT nor a CONVERSION_BASED_UNIT; write it as one of them");
    }
    return unit;
  }

  /// SI_UNIT(prefix, name): METRE or RADIAN; a unit without dimensions may have * before them.
  double si_size(const P21Entity& entity, const P21Record& si, Quantity quantity) const {
    std::vector<P21Value> given;
    for (const P21Value& value : file_.arguments(si))
      if (value.kind != P21Kind::kDerived) given.push_back(value);
    if (given.size() != 2 || given[1].kind != P21Kind::kEnum)
      fail(entity, "its SI_UNIT has no prefix and name; correct it");
    const char* name = quantity == Quantity::kLength ? "METRE" : "RADIAN";
    if (!same_word(given[1].text, name))
      fail(entity, std::string("its SI_UNIT is no .") + name + ".; correct it");
    return (quantity == Quantity::kLength ? 1000 : 1) * prefix_of(entity, given[0]);
  }

  double prefix_of(const P21Entity& entity, const P21Value& value) const {
    if (value.kind != P21Kind::kEnum) return 1;
    for (const Prefix& prefix : kPrefixes)
      if (same_word(value.text, prefix.name)) return prefix.factor;
    fail(entity, "its prefix ." + std::string(value.text) + ". is not known; correct it");
  }

  /// CONVERSION_BASED_UNIT(name, measure with unit).
  double converted_size(const P21Entity& entity, const P21Record& conversion, Quantity quantity,
                        int depth) const {
    const auto arguments = file_.arguments(conversion);
    if (arguments.size() < 2) fail(entity, "its unit has no conversion factor; correct it");
    const P21Entity& measure = referred(entity, arguments[1]);
    const auto parts = file_.arguments(file_.records[measure.first_record]);
    if (parts.size() < 2) fail(measure, "a measure with its unit is needed here; correct it");
    const double number = number_in(measure, parts[0]);
    const P21Entity& base_unit = referred(measure, parts[1]);
    const Unit unit = unit_of(base_unit, depth + 1);
    if (unit.quantity != quantity) fail(measure, "its unit is of another quantity; correct it");
    return number * unit.size;
  }

  double number_in(const P21Entity& entity, const P21Value& value) const {
    P21Value plain = value;
    if (value.kind == P21Kind::kTyped && value.count == 1) plain = file_.children(value)[0];
    const bool is_number = plain.kind == P21Kind::kReal || plain.kind == P21Kind::kInteger;
    if (!is_number || !(plain.number > 0))
      fail(entity, "its conversion factor is no number above 0; correct it");
    return plain.number;
  }

  /// Files of other kinds state units; who writes them here may have meant them.
  void warn_of_loose_units() {
    for (const P21Entity& entity : file_.entities) {
      if (!record(entity, "CONVERSION_BASED_UNIT") || !record(entity, "LENGTH_UNIT")) continue;
      diagnostics_.warn(file_.place(entity.line),
                        "#" + std::to_string(entity.id) +
                            ": this unit of length is not used, because no GLOBAL_UNIT_ASSIGNED_CONTEXT "
                            "assigns it: lengths are mm");
    }
  }

  const P21File& file_;
  Diagnostics& diagnostics_;
  std::optional<Assigned> length_, angle_;
};

}  // namespace

FileUnits file_units(const P21File& file, Diagnostics& diagnostics) {
  return UnitReader(file, diagnostics).read();
}

}  // namespace clearcut::read::stepnc
