// Judges whole programs for made up parts by a field of heights with the true profiles of all cutters. It errs on one side only: what it
// calls wrong is wrong beyond any doubt of its cells. Shares no code with the product.
#pragma once

#include <string>
#include <vector>

#include "support/independent/made_part.h"
#include "support/independent/plain_gcode.h"
#include "support/independent/profile_field.h"
#include "support/independent/thread_rays.h"

namespace clearcut::test_support {

class FieldJudge {
 public:
  FieldJudge(MadePart part, const std::string& plan, double cell);

  /// What is certainly wrong with the program that was planned for the part, each begun by one word for its kind.
  std::vector<std::string> wrongs_of_plan() const;

  /// The same of another program. What the plan has cut of the part others have to cut as well.
  std::vector<std::string> wrongs_of(const std::string& program) const;

 private:
  /// A program carried out, or the first ways of one.
  struct Run {
    ProfileField field;
    std::vector<ThreadRays> threads;
    std::vector<MadeVisit> missed;  ///< visits that no tool has made
    std::vector<std::string> wrongs;
    std::size_t done = 0;  ///< number of its ways
  };

  /// The centre of a cell, and what is known of the part there.
  struct Place {
    double x = 0, y = 0;
    double low = 0;               ///< cutters may come down to
    double asked = 0, drawn = 0;  ///< have to come down to where a cutter certainly reaches, and anywhere
    std::vector<ProfileField::Gap> undercuts, undercuts_asked;
  };
  Place place_at(double x, double y) const;
  std::vector<Place> all_places() const;
  Run untouched() const;
  void go(Run& run, const TipWay& tip) const;
  /// The ways of a program in the coordinates of the part.
  std::vector<TipWay> ways_about_part(const std::string& program) const;
  void run_plan(const std::string& plan);
  Run run(const std::string& program) const;
  const Run& last_before(std::size_t ways) const;
  void compare(const Run& run, const Run* plan, std::vector<std::string>& wrongs) const;
  static void compare_threads(const Run& run, std::vector<std::string>& wrongs);

  MadePart part_;
  double cell_;
  std::vector<Place> places_;
  Run plan_;
  std::vector<TipWay> plan_ways_;
  std::vector<Run>
      begun_;  ///< the plan at some of its ways, from none on: what begins alike goes on from there
};

}  // namespace clearcut::test_support
