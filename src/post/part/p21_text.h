// Values and numbered entities as ISO 10303-21 text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::post {

/// Represents an attribute without a value.
inline const std::string kUnset = "$";

/// Shortest text that reads back to the same double, with the decimal point required for reals: "5.0", "1.5E-7".
/// Throws InputError for non-finite numbers.
std::string p21_real(double value);
/// UTF-8 to a quoted string: apostrophes doubled, everything outside printable ASCII as \X2\ or \X4\.
std::string p21_string(std::string_view utf8);

/// A growing list of numbered entities.
class P21Writer {
 public:
  /// A number for an entity to be written later by put().
  int reserve();
  void put(int id, const std::string& keyword, const std::vector<std::string>& arguments);
  /// The new entity as a reference: "#12".
  std::string add(const std::string& keyword, const std::vector<std::string>& arguments);
  /// All entities, one a line, by number.
  std::string text() const;

 private:
  std::vector<std::string> lines_;
};

std::string p21_reference(int id);
/// "(a,b,c)".
std::string p21_list(const std::vector<std::string>& items);

}  // namespace clearcut::post
