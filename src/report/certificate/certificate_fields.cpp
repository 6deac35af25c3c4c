#include "report/certificate/certificate_fields.h"

namespace clearcut::report {

using nlohmann::ordered_json;

const ordered_json& field_at(const ordered_json& json, std::string_view path) {
  static const ordered_json kNone;
  const std::size_t end = path.find('/');
  const std::string name(path.substr(0, end));
  if (!json.is_object() || !json.contains(name)) return kNone;
  const ordered_json& inner = json.at(name);
  return end == std::string_view::npos ? inner : field_at(inner, path.substr(end + 1));
}

double number_at(const ordered_json& json, std::string_view path, double otherwise) {
  const ordered_json& value = field_at(json, path);
  return value.is_number() ? value.get<double>() : otherwise;
}

std::string text_at(const ordered_json& json, std::string_view path) {
  const ordered_json& value = field_at(json, path);
  return value.is_string() ? value.get<std::string>() : std::string();
}

bool is_without_part(const ordered_json& certificate) {
  return !field_at(certificate, "not_asked").is_null();
}

}  // namespace clearcut::report
