// Whether what was found of a program still holds where its control compensates for wear.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/options/post_options.h"
#include "model/options/shop_options.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::pipeline {

/// The part with the cutters of `numbers` larger all round by `wear`, mm.
Part worn(Part part, const std::vector<int>& numbers, double wear);

/// mm that D words may be off 0.
double wear_range_of(const ShopOptions& shop);

/// What is asked of a program whose control compensates for wear.
struct WearQuestion {
  double range = 0;        ///< mm that D words may be off 0 either way
  double uncut = 0;        ///< mm, what may be left with a new tool
  std::vector<int> tools;  ///< T words whose paths are compensated
  /// Whose paths are compensated; empty: nobody knows, so that all count.
  std::set<std::string> features;
};

/// Adds what is wrong at either end of the range alone, where cutters are off their size by as much as D words hold, and says for
/// which range the findings hold. Swaths of a smaller cutter are narrower by twice the range: what stays between them of passes that
/// are not compensated, and in corners, is no fault up to that. `found_at`: what is found of the program with these D words; an
/// InputError of it is told with the end.
void check_wear(Findings& findings, const WearQuestion& question,
                const std::function<Findings(double)>& found_at);

/// Names of the features whose passes are compensated.
std::set<std::string> compensated_features(const Part& part, const WearCompensation& wear);

}  // namespace clearcut::pipeline
