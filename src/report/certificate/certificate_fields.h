// Fields of a certificate that was read back as text, and what is said of those that contradict each other.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace clearcut::report {

/// Half the unit of the last digit, on both sides of a comparison: the numbers of a certificate are rounded to it.
inline constexpr double kLastDigit = 1e-6;

/// Sentences about fields, each beginning with the path of its field.
using Sentences = std::vector<std::string>;

/// The field at a path such as "engagement/max_deg"; null if there is none.
const nlohmann::ordered_json& field_at(const nlohmann::ordered_json& json, std::string_view path);

/// The number at the path; `otherwise` if there is none.
double number_at(const nlohmann::ordered_json& json, std::string_view path, double otherwise = 0);

/// The text at the path; "" if there is none.
std::string text_at(const nlohmann::ordered_json& json, std::string_view path);

/// Whether the program was checked without a part: nothing is known of uncut material and gouges.
bool is_without_part(const nlohmann::ordered_json& certificate);

}  // namespace clearcut::report
