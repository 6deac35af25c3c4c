#include "read/stepnc/file/node.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "base/units.h"
#include "read/common/text.h"

namespace clearcut::read::stepnc {

namespace {

constexpr double kLargestLength = 1e6;            // mm
constexpr std::size_t kLargestWork = 20'000'000;  // curve points and edges over all features

std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

/// One line, without blanks at its ends.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c >= '\0' && c < ' ') c = ' ';
  const auto first = text.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

Node::Node(const P21File& file, const P21Entity& entity)
    : file_(&file), entity_(&entity), record_(&file.records[entity.first_record]) {
  for (const P21Record& record : file.records_of(entity))
    keyword_ += (keyword_.empty() ? "" : "+") + upper(record.keyword);
}

void Node::fail(const std::string& what_and_what_to_do) const {
  throw InputError(file_->place(line()), label() + ": " + what_and_what_to_do);
}

P21Value Node::peek(std::size_t i) const {
  const auto all = file_->arguments(*record_);
  return i < all.size() ? all[i] : P21Value{};
}

P21Value Node::value(std::size_t i) const {
  use(i);
  return peek(i);
}

void Node::use(std::size_t i) const {
  if (i < record_->count) file_->uses().use(record_->first + i);
}

bool Node::is_used(std::size_t i) const {
  return i < record_->count && file_->uses().is_used(record_->first + i);
}

std::size_t Node::arguments() const {
  return record_->count;
}

bool Node::unset(std::size_t i) const {
  const P21Kind kind = peek(i).kind;
  return kind == P21Kind::kUnset || kind == P21Kind::kDerived;
}

namespace {

/// Levels of references that are written out, and characters after which nothing more is.
constexpr int kShownLevels = 3;
constexpr std::size_t kShownLength = 160;

void show(const P21File& file, const P21Value& value, int level, std::string& out);

void show_list(const P21File& file, std::span<const P21Value> values, int level, std::string& out) {
  out += "(";
  for (std::size_t i = 0; i < values.size() && out.size() < kShownLength; ++i) {
    if (i > 0) out += ",";
    show(file, values[i], level, out);
  }
  out += ")";
}

/// A name is a label; what is meant comes after it.
void show_entity(const P21File& file, const P21Value& reference, int level, std::string& out) {
  out += "#" + std::to_string(reference.id);
  const P21Entity* entity = file.find(reference.id);
  if (entity == nullptr || level == 0) return;
  const P21Record& record = file.records[entity->first_record];
  out += " " + upper(record.keyword);
  const auto all = file.arguments(record);
  const bool is_named = !all.empty() && all[0].kind == P21Kind::kString && all[0].text.empty();
  show_list(file, all.subspan(is_named ? 1 : 0), level - 1, out);
}

void show(const P21File& file, const P21Value& value, int level, std::string& out) {
  switch (value.kind) {
    case P21Kind::kUnset:
      out += "$";
      return;
    case P21Kind::kDerived:
      out += "*";
      return;
    case P21Kind::kInteger:
    case P21Kind::kReal:
      out += trimmed(value.number, 6);
      return;
    case P21Kind::kString:
      out += "'" + one_line(p21_decoded(value.text)) + "'";
      return;
    case P21Kind::kEnum:
      out += "." + upper(value.text) + ".";
      return;
    case P21Kind::kBinary:
      out += "\"" + std::string(value.text) + "\"";
      return;
    case P21Kind::kReference:
      return show_entity(file, value, level, out);
    case P21Kind::kTyped:
      out += upper(value.text);
      return show_list(file, file.children(value), level, out);
    case P21Kind::kList:
      return show_list(file, file.children(value), level, out);
  }
}

}  // namespace

std::string Node::shown(std::size_t i) const {
  std::string out;
  show(*file_, peek(i), kShownLevels, out);
  if (out.size() > kShownLength) out = out.substr(0, kShownLength) + " ...";
  return out;
}

Node Node::resolve(const P21Value& reference) const {
  const P21Entity* entity = file_->find(reference.id);
  if (entity == nullptr)
    fail("refers to #" + std::to_string(reference.id) + ", which is not in the file; add it");
  return Node(*file_, *entity);
}

namespace {

/// By how much the middle of the field of a toleranced length lies above its size. Of PLUS_MINUS_VALUE the upper limit counts upwards;
/// the lower one downwards, whether it is written with its sign or without.
double middle_of_field(const Node& measure) {
  const auto field = measure.ref(1);
  if (!field || !field->is("PLUS_MINUS_VALUE")) return 0;
  return (field->number(0).value_or(0) - std::abs(field->number(1).value_or(0))) / 2;
}

}  // namespace

std::optional<double> Node::number_of(const P21Value& value) const {
  switch (value.kind) {
    case P21Kind::kInteger:
    case P21Kind::kReal:
      return value.number;
    case P21Kind::kTyped: {
      const auto inner = file_->children(value);
      if (inner.size() == 1 && (inner[0].kind == P21Kind::kReal || inner[0].kind == P21Kind::kInteger))
        return inner[0].number;
      return std::nullopt;
    }
    case P21Kind::kReference: {
      const Node measure = resolve(value);
      const std::size_t at = measure.is("TOLERANCED_LENGTH_MEASURE") ? 0
                             : measure.is("NUMERIC_PARAMETER")       ? 1
                                                                     : 99;
      const P21Value inner = measure.value(at);
      if (inner.kind != P21Kind::kReal && inner.kind != P21Kind::kInteger) return std::nullopt;
      return at == 0 ? inner.number + middle_of_field(measure) : inner.number;
    }
    default:
      return std::nullopt;
  }
}

std::optional<double> Node::number(std::size_t i) const {
  if (unset(i)) return std::nullopt;
  const auto result = number_of(value(i));
  if (!result) fail("argument " + std::to_string(i + 1) + " is not a number; correct it");
  return result;
}

double Node::needed_number(std::size_t i, std::string_view what) const {
  const auto result = number(i);
  if (!result) fail("no " + std::string(what) + " (argument " + std::to_string(i + 1) + "); give one");
  return *result;
}

/// A numeric parameter states its own unit.
double Node::in_mm(const P21Value& value, double number) const {
  const P21Entity* entity = value.kind == P21Kind::kReference ? file_->find(value.id) : nullptr;
  if (entity == nullptr) return number * file_->mm_per_length;
  const Node measure(*file_, *entity);
  if (!measure.is("NUMERIC_PARAMETER")) return number * file_->mm_per_length;
  const std::string unit = measure.text(2);
  if (unit.empty()) return number * file_->mm_per_length;
  const auto mm = mm_per_unit(unit);
  if (!mm) measure.fail("its unit '" + unit + "' is none of length that is known; give it in MM");
  return number * *mm;
}

std::optional<double> Node::length(std::size_t i) const {
  auto result = number(i);
  if (result) result = in_mm(peek(i), *result);
  if (result && std::abs(*result) > kLargestLength)
    fail("argument " + std::to_string(i + 1) + " is longer than 1 km; lengths are in mm");
  return result;
}

double Node::needed_length(std::size_t i, std::string_view what) const {
  needed_number(i, what);
  return *length(i);
}

std::optional<Node> Node::ref(std::size_t i) const {
  if (unset(i)) return std::nullopt;
  const P21Value v = value(i);
  if (v.kind != P21Kind::kReference)
    fail("argument " + std::to_string(i + 1) + " should refer to an entity (#number); correct it");
  return resolve(v);
}

std::optional<Node> Node::sound_ref(std::size_t i) const {
  const P21Value v = value(i);
  const P21Entity* entity = v.kind == P21Kind::kReference ? file_->find(v.id) : nullptr;
  return entity == nullptr ? std::nullopt : std::optional(Node(*file_, *entity));
}

Node Node::needed_ref(std::size_t i, std::string_view what) const {
  auto result = ref(i);
  if (!result) fail("no " + std::string(what) + " (argument " + std::to_string(i + 1) + "); give one");
  return *std::move(result);
}

std::vector<P21Value> Node::list(std::size_t i) const {
  const P21Value v = value(i);
  if (v.kind == P21Kind::kUnset || v.kind == P21Kind::kDerived) return {};
  if (v.kind != P21Kind::kList) return {v};
  const auto children = file_->children(v);
  return {children.begin(), children.end()};
}

std::vector<Node> Node::refs(std::size_t i) const {
  std::vector<Node> result;
  for (const P21Value& v : list(i)) {
    if (v.kind == P21Kind::kUnset) continue;
    if (v.kind != P21Kind::kReference)
      fail("argument " + std::to_string(i + 1) + " should be a list of entities (#number); correct it");
    result.push_back(resolve(v));
  }
  return result;
}

std::vector<double> Node::numbers(std::size_t i) const {
  std::vector<double> result;
  for (const P21Value& v : list(i)) {
    const auto x = number_of(v);
    if (!x) fail("argument " + std::to_string(i + 1) + " should be a list of numbers; correct it");
    if (std::abs(*x) > kLargestLength) fail("a coordinate is farther than 1 km; lengths are in mm");
    result.push_back(*x);
  }
  return result;
}

std::vector<double> Node::lengths(std::size_t i) const {
  std::vector<double> result = numbers(i);
  for (double& one : result) one *= file_->mm_per_length;
  return result;
}

std::string Node::text(std::size_t i) const {
  const P21Value v = value(i);
  return v.kind == P21Kind::kString ? one_line(p21_decoded(v.text)) : "";
}

std::string Node::enumeration(std::size_t i) const {
  const P21Value v = value(i);
  return v.kind == P21Kind::kEnum ? upper(v.text) : "";
}

std::optional<bool> Node::flag(std::size_t i) const {
  const std::string word = enumeration(i);
  if (word == "T" || word == "TRUE") return true;
  if (word == "F" || word == "FALSE") return false;
  return std::nullopt;
}

std::vector<Node> nodes_called(const P21File& file, std::string_view keyword) {
  std::vector<Node> result;
  for (const P21Entity& entity : file.entities) {
    const std::string_view word = file.records[entity.first_record].keyword;
    if (word.size() == keyword.size() && entity.records == 1 && upper(word) == keyword)
      result.emplace_back(file, entity);
  }
  return result;
}

namespace {

struct AnglePlace {
  std::string_view keyword;
  std::size_t argument;
};
// Where files write angles; one above 2 pi shows that the file writes degrees.
constexpr AnglePlace kAngles[] = {{"PLUNGE_RAMP", 1},
                                  {"PLUNGE_ZIGZAG", 1},
                                  {"PLUNGE_HELIX", 2},
                                  {"AP_RETRACT_ANGLE", 1},
                                  {"AP_LIFT_PATH_ANGLE", 1},
                                  {"CLOSED_POCKET", 6},
                                  {"OPEN_POCKET", 6},
                                  {"BOSS", 6},
                                  {"PARTIAL_CIRCULAR_PROFILE", 2},
                                  {"PARTIAL_CIRCULAR_PATH", 2},
                                  {"CHAMFER", 5},
                                  {"TEE_PROFILE", 1},
                                  {"TEE_PROFILE", 2},
                                  {"VEE_PROFILE", 2},
                                  {"VEE_PROFILE", 3},
                                  {"SQUARE_U_PROFILE", 3},
                                  {"SQUARE_U_PROFILE", 5},
                                  {"CONICAL_HOLE_BOTTOM", 0},
                                  {"ANGLE_TAPER", 0},
                                  {"TAPERED_ENDMILL", 5},
                                  {"CIRCULAR_PATTERN", 5},
                                  {"CIRCULAR_PATTERN", 10},
                                  {"CIRCULAR_OFFSET", 0},
                                  {"MILLING_TOOL_DIMENSION", 1},
                                  {"TOOL_DIMENSION", 1}};
constexpr double kFastestSpindle = 1000;        // 1/s: 60 000 rpm
constexpr const char* kOwnWriter = "clearcut";  // in the header that write_stepnc() writes

std::optional<double> plain_number(const P21File& file, const P21Record& record, std::size_t i) {
  const auto arguments = file.arguments(record);
  if (i >= arguments.size()) return std::nullopt;
  const P21Value& v = arguments[i];
  if (v.kind != P21Kind::kReal && v.kind != P21Kind::kInteger) return std::nullopt;
  return v.number;
}

}  // namespace

Context::Context(const P21File& file_in, const Tolerances& tol_in, bool in_degrees)
    : file(file_in),
      tol(tol_in),
      degrees(in_degrees),
      standard_units(file_in.originating_system == kOwnWriter) {
  if (standard_units) return;
  for (const P21Record& record : file.records) {
    for (const AnglePlace& place : kAngles) {
      if (record.keyword != place.keyword) continue;
      const auto value = plain_number(file, record, place.argument);
      if (value && std::abs(*value) > kRoundedTurn) degrees = true;
    }
    if (record.keyword != "MILLING_TECHNOLOGY") continue;
    const auto spindle = plain_number(file, record, 3);
    if (spindle && std::abs(*spindle) >= kFastestSpindle) spindle_rpm = true;
  }
}

void Context::use_head(const Node& feature) const {
  const P21Value of = feature.peek(1);
  if (of.kind == P21Kind::kReference && workpiece == of.id) feature.use(1);
  const P21Value listed = feature.peek(2);
  if (listed.kind != P21Kind::kList) return;
  const auto all = file.children(listed);
  if (std::all_of(all.begin(), all.end(), [&](const P21Value& one) { return operations.count(one.id) > 0; }))
    feature.use(2);
}

double Context::angle(double value) const {
  return degrees ? value * kPi / 180.0 : value;
}

double Context::draft_angle(double value) const {
  const bool is_past_level = !standard_units && std::abs(value) >= kPi / 2;
  return degrees || is_past_level ? value * kPi / 180.0 : value;
}

void Context::gather(Severity severity, const std::string& what, const Node& node) {
  auto group = std::find_if(groups_.begin(), groups_.end(),
                            [&](const Group& g) { return g.severity == severity && g.what == what; });
  if (group == groups_.end()) group = groups_.insert(groups_.end(), {severity, what, {}});
  const std::string label = node.label();
  if (std::find(group->labels.begin(), group->labels.end(), label) == group->labels.end())
    group->labels.push_back(label);
}

void Context::flush() {
  constexpr std::size_t kShown = 3;
  for (const Group& group : groups_) {
    std::string labels;
    for (std::size_t i = 0; i < std::min(kShown, group.labels.size()); ++i)
      labels += (i == 0 ? "" : ", ") + group.labels[i];
    if (group.labels.size() > kShown)
      labels += " and " + std::to_string(group.labels.size() - kShown) + " more";
    if (group.severity == Severity::kNote)
      diagnostics.note(labels, group.what);
    else
      diagnostics.warn(labels, group.what);
  }
  groups_.clear();
}

void Context::spend(std::size_t amount, const Node& node) {
  spent_ += amount;
  if (spent_ > kLargestWork)
    node.fail("the geometry expands to more than 20 million points; simplify the file");
}

}  // namespace clearcut::read::stepnc
