// Plates with pockets and holes, drawn as eight CADs write them: what was meant comes out, or the question is asked.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "read/drawing/layer_rules.h"
#include "read/job/read_part.h"
#include "support/cad/writers.h"
#include "support/random/random_parts.h"

namespace clearcut {
namespace {

using test_support::CadDrawing;
using test_support::CadPart;
using test_support::CadShape;
using test_support::CadShapeKind;

/// What one outline was read as.
struct Work {
  std::string kind;
  double area = 0;
  Box box;
};

Loop outline_of(const Feature& feature) {
  return feature.profile ? Loop(feature.profile->line) : feature.target.front().outer();
}

/// Where pages put the part does not count: places are from the lower left corner of the plate.
std::vector<Work> from_corner(std::vector<Work> works) {
  if (works.empty()) return works;
  const auto largest = std::max_element(works.begin(), works.end(),
                                        [](const Work& a, const Work& b) { return a.area < b.area; });
  const Vec2 origin = largest->box.min;
  for (Work& work : works) work.box = {work.box.min - origin, work.box.max - origin};
  return works;
}

std::string text_of(const Work& work) {
  return fmt::format("{} {:.3f} mm2 at {:.3f} {:.3f}", work.kind, work.area, work.box.min.x, work.box.min.y);
}

std::string text_of(const std::vector<Work>& works) {
  std::string text;
  for (const Work& work : works) text += text_of(work) + "\n";
  return text;
}

std::vector<Work> read_works(const Part& part) {
  std::vector<Work> works;
  for (const Feature& feature : part.features) {
    const Loop outline = outline_of(feature);
    const char* side = !feature.profile                                 ? "cleared"
                       : feature.profile->side == ProfileSide::kOutside ? "outside"
                                                                        : "inside";
    works.push_back({side, std::abs(signed_area(outline)), box(outline)});
  }
  return from_corner(std::move(works));
}

std::vector<Work> meant_works(const CadPart& part, const CadDrawing& drawing) {
  std::vector<Work> works;
  for (const CadShape& shape : part.shapes) {
    const char* kind = shape.kind == CadShapeKind::kPlate ? "outside"
                       : drawing.holes_are_cut            ? "inside"
                                                          : "cleared";
    works.push_back({kind, std::abs(signed_area(shape.outline)), box(shape.outline)});
  }
  return from_corner(std::move(works));
}

/// Polygons for circles lose up to 0.3 % of their area and 0.2 % of their radius.
void expect_same(const std::vector<Work>& read, const std::vector<Work>& meant, bool round) {
  const double slack = round ? 0.005 : 0.08, share = round ? 1e-3 : 4e-3;
  EXPECT_EQ(read.size(), meant.size());
  for (const Work& work : meant) {
    const auto same = [&](const Work& other) {
      return other.kind == work.kind && std::abs(other.area - work.area) <= share * work.area &&
             distance(other.box.min, work.box.min) < slack && distance(other.box.max, work.box.max) < slack;
    };
    EXPECT_EQ(std::count_if(read.begin(), read.end(), same), 1) << text_of(work) << " in\n" << text_of(read);
  }
}

/// Read as a user of the command does who says the depth, and what the outermost outline is when asked.
Part read_and_answer(const CadDrawing& drawing, bool& asked) {
  ReadOptions options;
  options.depth = 3;
  options.ask_if_unclear = true;
  try {
    return read::read_part_text(drawing.text, drawing.file, options);
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--op profile:outer"), std::string::npos) << error.what();
  }
  asked = true;
  options.layer_rules.push_back(read::rule_of_option("profile:outer", "--op"));
  return read::read_part_text(drawing.text, drawing.file, options);
}

struct Writer {
  const char* name;
  CadDrawing (*write)(const CadPart&, Random&);
};
class CadDrawings : public testing::TestWithParam<Writer> {};

INSTANTIATE_TEST_SUITE_P(All, CadDrawings,
                         testing::Values(Writer{"Inkscape", test_support::inkscape_drawing},
                                         Writer{"Illustrator", test_support::illustrator_drawing},
                                         Writer{"Fusion", test_support::fusion_drawing},
                                         Writer{"SolidWorks", test_support::solidworks_drawing},
                                         Writer{"LibreCAD", test_support::librecad_drawing},
                                         Writer{"FreeCAD", test_support::freecad_drawing},
                                         Writer{"KiCad", test_support::kicad_drawing},
                                         Writer{"OpenSCAD", test_support::openscad_drawing}),
                         [](const auto& writer) { return writer.param.name; });

TEST_P(CadDrawings, GiveWhatWasMeantOrTheQuestion) {
  for (int seed = 1; seed <= test_support::random_count(25); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<std::uint64_t>(seed));
    const CadPart part = test_support::random_cad_part(random);
    const CadDrawing drawing = GetParam().write(part, random);
    bool asked = false;
    try {
      const Part read = read_and_answer(drawing, asked);
      EXPECT_EQ(asked, !drawing.says_roles);
      expect_same(read_works(read), meant_works(part, drawing), drawing.round);
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

}  // namespace
}  // namespace clearcut
