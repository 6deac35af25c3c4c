// The functions that a C++ file defines, with their lengths.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clearcut::test_support {

struct FunctionLength {
  std::string name;
  int line = 1;   ///< of its first word, from 1
  int lines = 0;  ///< from there to its last brace, both counted
};

/// Functions with a body outside of other functions, members and tests among them, in order; lambdas count with what they stand
/// in. `name` is the word before the parameters. Cost O(length).
std::vector<FunctionLength> functions_of(std::string_view text);

struct ClassSize {
  std::string name;
  int line = 1;
  int methods = 0;  ///< declared in the class, constructors and operators among them
};

/// Classes and structs outside of functions.
std::vector<ClassSize> classes_of(std::string_view text);

}  // namespace clearcut::test_support
