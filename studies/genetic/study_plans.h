// The studies of the published genetic algorithm: what the text ran, and what ours runs by default.
#pragma once

#include <string>
#include <vector>

#include "studies/genetic/genetic_study.h"
#include "studies/genetic/study_claims.h"

namespace clearcut::studies {

struct StudySize {
  int side = 20;  ///< of the square lattice, points
  int runs = 20;
  long long generations = 2000;
};

struct StudyPlan {
  std::string name, figure, factor;
  StudyMetric metric = StudyMetric::kFitness;
  StudySize ours, middle, published;  ///< seconds, minutes, days
  std::vector<std::string> levels;    ///< sizes, names, or sides
  std::vector<StudyClaim> claims{};   ///< of the text; empty where it prints no finding
};

const std::vector<StudyPlan>& study_plans();
/// Throws InputError listing the names for one that is unknown.
const StudyPlan& study_plan(const std::string& name);

}  // namespace clearcut::studies
