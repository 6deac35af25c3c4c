#include "order/tsplib.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "order/test_support.h"

namespace clearcut::order {
namespace {

TEST(Tsplib, ReadsTheSpellingsInUse) {
  const std::string text =
      "NAME: small\r\nTYPE : TSP\nCOMMENT : a : b\nDIMENSION: 3\nEDGE_WEIGHT_TYPE : EUC_2D\n"
      "NODE_COORD_SECTION\n  2   2.00000e+02  +4\n 1 1 1.5\n3 -7.25 0\n\nEOF\n";
  const Problem problem = read_tsplib(text, "small.tsp");
  EXPECT_EQ(problem.name, "small");
  ASSERT_EQ(problem.size(), 3);
  EXPECT_EQ(problem.points[0], (Vec2{1, 1.5}));
  EXPECT_EQ(problem.points[1], (Vec2{200, 4}));
  EXPECT_EQ(problem.points[2], (Vec2{-7.25, 0}));
  EXPECT_EQ(problem.metric, Metric::kRoundedEuc2d);
  EXPECT_TRUE(problem.closed());
}

struct BadFile {
  const char* text;
  const char* message;
};

TEST(Tsplib, FaultsNameTheirLine) {
  const BadFile rows[] = {
      {"", "x.tsp:0: no NODE_COORD_SECTION; only instances given by coordinates are read"},
      {"DIMENSION : 2\nNODE_COORD_SECTION\n1 0 0\n",
       "x.tsp:3: the file ends after 1 of 2 points; correct DIMENSION or add the points"},
      {"DIMENSION : 2\nNODE_COORD_SECTION\n1 0 0\n1 1 1\n", "x.tsp:4: node 1 comes twice; remove one"},
      {"DIMENSION : 2\nNODE_COORD_SECTION\n1 0 0\n3 1 1\n", "x.tsp:4: node 3 is outside 1..2; correct it"},
      {"DIMENSION : 1\nNODE_COORD_SECTION\n1 0 zero\n", "x.tsp:3: 'zero' is not a coordinate; correct it"},
      {"NODE_COORD_SECTION\n1 0 0\n", "x.tsp:1: DIMENSION must come before NODE_COORD_SECTION; add it"},
      {"DIMENSION : 999999999\nNODE_COORD_SECTION\n1 0 0\n",
       "x.tsp:1: DIMENSION does not fit the file; correct it"},
      {"EDGE_WEIGHT_TYPE : GEO\n", "x.tsp:1: EDGE_WEIGHT_TYPE is GEO; only EUC_2D is read"},
      {"TYPE : ATSP\n", "x.tsp:1: TYPE is ATSP; only TSP is read"},
      {"hello\n", "x.tsp:1: 'hello' is no TSPLIB keyword with a value; remove the line"},
  };
  for (const BadFile& row : rows) {
    try {
      read_tsplib(row.text, "x.tsp");
      ADD_FAILURE() << "accepted: " << row.text;
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), row.message);
    }
  }
}

TEST(Tsplib, ToursSurviveWritingAndReading) {
  const Tour tour{4, 2, 0, 1, 3};
  EXPECT_EQ(read_tsplib_tour(write_tsplib_tour(tour, "t"), "t", 5), tour);
  EXPECT_EQ(read_tsplib_tour("TOUR_SECTION\n5 3 1 2 4 -1", "t", 5), tour);
  EXPECT_THROW(read_tsplib_tour("TOUR_SECTION\n1\n2\n-1\n", "t", 3), InputError);
  EXPECT_THROW(read_tsplib_tour("TOUR_SECTION\n1\n2\n2\n-1\n", "t", 3), InputError);
  EXPECT_THROW(read_tsplib_tour("TOUR_SECTION\n1\n2\n4\n-1\n", "t", 3), InputError);
  EXPECT_THROW(read_tsplib_tour("1\n2\n3\n", "t", 3), InputError);
}

struct Reference {
  const char* file;
  int points;
};

TEST(Tsplib, ReadsTheReferenceInstances) {
  for (const KnownInstance& known : known_instances()) {
    const Problem problem = read_tsplib(known.text, known.name);
    EXPECT_EQ(problem.name, known.name);
    EXPECT_EQ(problem.size(), static_cast<int>(known.tour.size()));
  }
  const Reference rows[] = {{"berlin52.tsp", 52}, {"qa194.tsp", 194},    {"a280.tsp", 280},
                            {"pcb442.tsp", 442},  {"xit1083.tsp", 1083}, {"pr2392.tsp", 2392},
                            {"rl5915.tsp", 5915}, {"fi10639.tsp", 10639}};
  for (const Reference& row : rows) {
    const auto text = reference_text(row.file);
    if (!text) continue;  // published files only add to the instances above
    EXPECT_EQ(read_tsplib(*text, row.file).size(), row.points) << row.file;
  }
}

TEST(Tsplib, OptimalToursHaveTheirKnownLength) {
  const KnownInstance lattice = known_lattice(14, 14);
  const Problem read = read_tsplib(lattice.text, lattice.name);
  const std::string written = write_tsplib_tour(lattice.tour, lattice.name);
  EXPECT_EQ(tour_length(read, read_tsplib_tour(written, lattice.name, read.size())), 1960);
  for (const auto& [name, length] : {std::pair{"berlin52", 7542.0}, {"a280", 2579.0}}) {
    const auto text = reference_text(std::string(name) + ".tsp");
    const auto tour = reference_text(std::string(name) + ".opt.tour");
    if (!text || !tour) continue;
    const Problem problem = read_tsplib(*text, name);
    EXPECT_EQ(tour_length(problem, read_tsplib_tour(*tour, name, problem.size())), length);
  }
}

}  // namespace
}  // namespace clearcut::order
