// `judge DESCRIPTION PLAN [PROGRAM...]`: a line for the plan and one for each program, with what the field of heights is certain to be
// wrong about it; empty where that is nothing.
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "support/independent/field_judge.h"

namespace {

/// mm. Width of the field's cells.
constexpr double kCell = 0.25;

std::string text_of(const char* file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void print(const std::vector<std::string>& wrongs) {
  for (std::size_t i = 0; i < wrongs.size(); ++i) std::cout << (i > 0 ? "; " : "") << wrongs[i];
  std::cout << "\n";
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return 2;
  const clearcut::test_support::FieldJudge judge(clearcut::test_support::made_part(text_of(arguments[1])),
                                                 text_of(arguments[2]), kCell);
  print(judge.wrongs_of_plan());
  for (int i = 3; i < count; ++i) print(judge.wrongs_of(text_of(arguments[i])));
  return 0;
}
