#include "report/certificate/certificate_fields.h"

namespace clearcut::report {

using Json = nlohmann::ordered_json;

const Json& field_at(const Json& json, std::string_view path) {
  static const Json kNone;
  const std::size_t end = path.find('/');
  const std::string name(path.substr(0, end));
  if (!json.is_object() || !json.contains(name)) return kNone;
  const Json& inner = json.at(name);
  return end == std::string_view::npos ? inner : field_at(inner, path.substr(end + 1));
}

double number_at(const Json& json, std::string_view path, double otherwise) {
  const Json& value = field_at(json, path);
  return value.is_number() ? value.get<double>() : otherwise;
}

std::string text_at(const Json& json, std::string_view path) {
  const Json& value = field_at(json, path);
  return value.is_string() ? value.get<std::string>() : std::string();
}

bool is_without_part(const Json& certificate) {
  return !field_at(certificate, "not_asked").is_null();
}

}  // namespace clearcut::report
