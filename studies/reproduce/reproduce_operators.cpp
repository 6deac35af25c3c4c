#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "order/genetic/operators.h"
#include "studies/reproduce/reproduce_parts.h"

namespace clearcut::studies {
namespace {

/// The text's parents, and the stretch that is mapped: its fourth to sixth gene.
const order::Tour kFirstParent{0, 3, 7, 5, 4, 1, 8, 2, 6}, kSecondParent{0, 5, 8, 2, 6, 3, 1, 4, 7};
constexpr int kStretchBegin = 3, kStretchEnd = 5;

/// Table 3.1, by gene.
constexpr std::array<const char*, 9> kPrintedEdges{"3, 5, 6, 7", "3, 4, 8",    "6, 8",
                                                   "0, 1, 6, 7", "1, 5, 7",    "0, 4, 7, 8",
                                                   "0, 2, 3",    "0, 3, 4, 5", "1, 2, 5"};

Cell equal_words(const std::string& ours, const std::string& printed) {
  const bool same = ours == printed;
  return beside(ours, printed, same ? Agreement::kAgrees : Agreement::kDiffers,
                same ? "" : "the operator gives something else");
}

std::string offspring(const order::Tour& of, const order::Tour& with) {
  order::Genome child;
  order::map_stretch(order::Genome(of), order::Genome(with), kStretchBegin, kStretchEnd, child);
  return fmt::format("{}", fmt::join(child.genes(), " "));
}

}  // namespace

Reproduction operators_table() {
  Reproduction result;
  result.table.title = "Tour 3.6.2: the worked example of partially mapped crossover, and table 3.1";
  result.table.columns = {{"what", Align::kLeft}, {"printed", Align::kLeft}, {"ours", Align::kLeft}};
  const auto add = [&](const std::string& what, const std::string& printed, const std::string& ours) {
    result.add({what, printed, equal_words(ours, printed)});
  };
  add("offspring 1", "0 1 7 2 6 3 8 5 4", offspring(kFirstParent, kSecondParent));
  add("offspring 2", "0 2 8 5 4 1 3 6 7", offspring(kSecondParent, kFirstParent));
  result.add_rule();
  for (int gene = 0; gene < static_cast<int>(kPrintedEdges.size()); ++gene)
    add(fmt::format("edges of gene {}", gene), kPrintedEdges[static_cast<std::size_t>(gene)],
        fmt::format("{}", fmt::join(order::genetic_edges(order::Genome(kFirstParent),
                                                         order::Genome(kSecondParent), gene),
                                    ", ")));
  result.table.notes.push_back(
      "offspring by the function that the operator pmx calls, edges as erx draws from them; the stretch is 5 "
      "4 "
      "1 of parent 1, 2 6 3 of parent 2");
  return result;
}

}  // namespace clearcut::studies
