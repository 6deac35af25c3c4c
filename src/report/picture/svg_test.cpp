#include "report/picture/svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <pugixml.hpp>
#include <regex>
#include <set>

#include "geometry/region.h"
#include "report/picture/svg_writer.h"
#include "report/sample_job.h"

namespace clearcut::report {
namespace {

using testing::HasSubstr;
using testing::Not;

pugi::xml_document parsed(const std::string& text) {
  pugi::xml_document document;
  const auto result = document.load_string(text.c_str(), pugi::parse_full);
  EXPECT_TRUE(result) << result.description() << " at "
                      << text.substr(static_cast<std::size_t>(result.offset), 80);
  return document;
}

std::string picture(const Part& part, const Toolpath& toolpath, const Findings& findings) {
  return svg(part, toolpath, findings, {});
}

std::string sample_picture() {
  return picture(sample::part(), sample::toolpath(), sample::findings());
}

/// Every `attribute` of an element called `name`.
std::vector<std::string> attributes(const pugi::xml_document& document, const char* name,
                                    const char* attribute) {
  std::vector<std::string> values;
  for (const auto& found :
       document.select_nodes((std::string("//") + name + "[@" + attribute + "]").c_str())) {
    values.push_back(found.node().attribute(attribute).value());
  }
  return values;
}

std::string all_words(const std::string& text) {
  const auto document = parsed(text);
  std::string words;
  for (const auto& found : document.select_nodes("//text|//title"))
    words += std::string(found.node().child_value()) + "\n";
  return words;
}

TEST(Svg, IsWellFormedAndSaysWhatWasFound) {
  const std::string words = all_words(sample_picture());
  EXPECT_THAT(words, HasSubstr("sample <part> & \"name\""));
  EXPECT_THAT(words, HasSubstr("SLOT <2>"));
  EXPECT_THAT(words, HasSubstr("stock 120 x 80 x 30 mm"));
  EXPECT_THAT(words, HasSubstr("T1 end mill 10 mm"));
  EXPECT_THAT(words, HasSubstr("faulty: 1 fault"));
  EXPECT_THAT(words, HasSubstr("2000 mm")) << "feed of the whole";
  EXPECT_THAT(words, HasSubstr("3:00")) << "time of the whole";
  EXPECT_THAT(words, HasSubstr("0.2500 mm")) << "thickest rest";
  EXPECT_THAT(words, HasSubstr("uncut 0.250 mm, POCKET1"));
}

TEST(Svg, NamesOpenConditionsAndNotThoseThatAreMet) {
  Findings findings = sample::findings();
  findings.conditions = {
      {"left-out", "face 12 <cone> is neither flat and level nor upright: its material stays"},
      {"blending", "met"}};
  findings.conditions.back().met_by = "accepted";
  const std::string words = all_words(picture(sample::part(), sample::toolpath(), findings));
  EXPECT_THAT(words, HasSubstr("Conditions"));
  EXPECT_THAT(words, HasSubstr("left-out: face 12 <cone> is neither"));
  EXPECT_THAT(words, HasSubstr("stays"));
  EXPECT_THAT(words, Not(HasSubstr("blending")));
}

TEST(Svg, ACleanPartIsCalledClean) {
  Findings findings = sample::findings();
  findings.faults.clear();
  findings.all.clean = true;
  EXPECT_THAT(all_words(picture(sample::part(), sample::toolpath(), findings)), HasSubstr("certified clean"));
}

TEST(Svg, ArcsAreArcsInMillimetres) {
  const std::string text = sample_picture();
  // The clockwise half circles of radius 13 about (40, 35); in the part's frame, y up.
  EXPECT_THAT(text,
              HasSubstr("M27 35A13 13 0 0 0 40 48A13 13 0 0 0 53 35A13 13 0 0 0 40 22A13 13 0 0 0 27 35"));
  // The island, clockwise by convention.
  EXPECT_THAT(text, HasSubstr("A8 8 0 0 0 "));
}

TEST(Svg, ShowsTheLastLayerUnlessAskedForAll) {
  Toolpath toolpath = sample::toolpath();
  for (Move& move : toolpath.sections[0].moves) {
    if (move.z_to == -2 && move.kind == MoveKind::kCut) move.path = Edge::line({33.125, 12}, {34.625, 12});
  }
  SvgOptions all;
  all.all_layers = true;
  EXPECT_THAT(picture(sample::part(), toolpath, sample::findings()), Not(HasSubstr("M33.125 12L34.625 12")));
  EXPECT_THAT(svg(sample::part(), toolpath, sample::findings(), all), HasSubstr("M33.125 12L34.625 12"));
}

TEST(Svg, EveryReferenceHasItsTargetAndNoIdIsUsedTwice) {
  const auto document = parsed(sample_picture());
  std::set<std::string> ids;
  for (const std::string& id : attributes(document, "clipPath", "id"))
    EXPECT_TRUE(ids.insert(id).second) << id;
  const auto references = attributes(document, "g", "clip-path");
  ASSERT_FALSE(references.empty());
  for (const std::string& reference : references) {
    EXPECT_TRUE(ids.count(reference.substr(5, reference.size() - 6))) << reference;
  }
}

TEST(Svg, SweptStripsHaveTheWidthOfTheCutter) {
  const auto document = parsed(sample_picture());
  const std::string floor = std::string("//path[@stroke='") + report::palette::kFloor + "']";
  const auto strips = document.select_nodes(floor.c_str());
  ASSERT_FALSE(strips.empty());
  for (const auto& strip : strips) EXPECT_STREQ(strip.node().attribute("stroke-width").value(), "10");
}

TEST(Svg, WhatIsWithinReachIsRedAndTheRestOfTheTargetAmberUnderWhatWasSwept) {
  const auto document = parsed(sample_picture());
  const std::string amber = std::string("//path[@fill='") + report::palette::kUnreachable + "']";
  const auto floors = document.select_nodes(amber.c_str());
  ASSERT_EQ(floors.size(), 2u);
  for (const auto& floor : floors) {
    const auto reach = floor.node().next_sibling(), swept = reach.next_sibling();
    EXPECT_STREQ(reach.attribute("stroke").value(), report::palette::kUncut);
    EXPECT_NEAR(reach.attribute("stroke-width").as_double(), 10, 0.3) << "a hair less than the cutter";
    EXPECT_STREQ(swept.attribute("stroke").value(), report::palette::kFloor);
  }
}

/// Two pockets side by side, the moves of the first going over into the second.
std::string picture_of_meeting_pockets(bool gouged) {
  Part part = sample::part();
  part.features.resize(1);
  part.features[0].target =
      part.features[0].allowed = {Region::from_valid_loops(clearcut::rectangle(Box{{0, 0}, {20, 20}}), {})};
  part.features.push_back(part.features[0]);
  part.features[1].name = "beside";
  part.features[1].target =
      part.features[1].allowed = {Region::from_valid_loops(clearcut::rectangle(Box{{20, 0}, {40, 20}}), {})};
  Findings findings = sample::findings();
  findings.faults.clear();
  if (gouged)
    findings.faults.push_back({FaultKind::kGouge, part.features[0].name, {{1, 2}, -3, 40}, 0.25, ""});
  return picture(part, sample::toolpath(), findings);
}

TEST(Svg, PaintsNoGougesThatWereNotFound) {
  const auto strokes = [](const std::string& text) {
    const std::vector<std::string> colors = attributes(parsed(text), "path", "stroke");
    return std::count(colors.begin(), colors.end(), std::string(palette::kGouge));
  };
  EXPECT_EQ(strokes(picture_of_meeting_pockets(false)), 0);
  EXPECT_GT(strokes(picture_of_meeting_pockets(true)), 0);
}

TEST(Svg, WhatIsSweptInTheNextPocketIsNoGouge) {
  const auto document = parsed(picture_of_meeting_pockets(true));
  PathData beside;
  beside.add(clearcut::rectangle(Box{{20, 0}, {40, 20}}));
  int drawn = 0;
  for (const auto& found : document.select_nodes("//path")) {
    if (found.node().attribute("stroke").value() != std::string(palette::kGouge)) continue;
    ++drawn;
    bool clipped = false;
    for (auto above = found.node().parent(); above; above = above.parent()) {
      std::string clip = above.attribute("clip-path").value();
      if (clip.size() < 6) continue;
      clip = clip.substr(5, clip.size() - 6);
      const auto shape = document.select_node(("//clipPath[@id='" + clip + "']/path").c_str());
      clipped |= std::string(shape.node().attribute("d").value()).find(beside.text()) != std::string::npos;
    }
    EXPECT_TRUE(clipped);
  }
  EXPECT_GT(drawn, 0);
}

TEST(Svg, AFeatureThatNothingWorksOnIsAllRed) {
  Part part = sample::part();
  part.workplan.clear();
  const auto document = parsed(picture(part, {}, {}));
  const std::string red = std::string("//path[@fill='") + report::palette::kUncut + "']";
  EXPECT_EQ(document.select_nodes(red.c_str()).size(), 2u);
}

TEST(Svg, ADrilledHoleIsSweptWhereTheDrillWent) {
  Part part = sample::part();
  part.features = {sample::pocket("HOLE", sample::circle({90, 40}, 5), {}, 0, -9)};
  part.workplan.resize(1);
  sample::Moves m({90, 40}, 2);
  m.to(MoveKind::kPlunge, {90, 40}, -9).to(MoveKind::kRetract, {90, 40}, 2);
  const std::string text = picture(part, {{Section{"HOLE", 0, 1, 0, true, Coolant::kOff, m.moves}}}, {});
  const std::string strip = std::string("//path[@stroke='") + report::palette::kFloor + "']";
  EXPECT_THAT(parsed(text).select_node(strip.c_str()).node().attribute("d").value(), HasSubstr("M90 40h0"));
}

TEST(Svg, OfVeryManyFeaturesTheFaultyOnesHaveTheirPanels) {
  Part part = sample::part();
  Findings findings = sample::findings();
  findings.features.clear();
  for (int i = 2; i < 60; ++i) {
    part.features.push_back(part.features[1]);
    part.features.back().name = "SLOT" + std::to_string(i);
    FeatureFindings found;
    found.name = part.features.back().name;
    found.figures.clean = i < 50;
    findings.features.push_back(found);
  }
  const std::string words = all_words(picture(part, {}, findings));
  EXPECT_THAT(words, HasSubstr("60  SLOT59"));
  EXPECT_THAT(words, HasSubstr("51  SLOT50"));
  EXPECT_THAT(words, Not(HasSubstr("50  SLOT49")));
}

TEST(Svg, HostileNamesStayText) {
  Part part = sample::part();
  part.name = "</title><script>alert(1)</script>\x01\xff";
  part.features[0].name = "\"'><x y=\"";
  part.tools[0].name = "&lt;";
  Findings findings = sample::findings();
  findings.faults[0].text = "]]> <!-- ";
  findings.faults[0].feature = part.features[0].name;
  findings.features[0].name = part.features[0].name;
  const std::string text = picture(part, sample::toolpath(), findings);
  const auto document = parsed(text);
  EXPECT_TRUE(document.select_nodes("//script").empty());
  EXPECT_THAT(all_words(text), HasSubstr("</title><script>alert(1)</script>??"));
}

TEST(Svg, NeverPrintsANumberThatIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  Toolpath toolpath = sample::toolpath();
  toolpath.sections[0].moves[3].path.to = {nan, 1};
  toolpath.sections[0].moves[5].path.from = {infinity, 1};
  toolpath.sections[0].moves[7].z_to = nan;
  Findings findings = sample::findings();
  findings.all.feed_mm = nan;
  findings.all.time_s = infinity;
  findings.faults[0].at.point = {nan, nan};
  findings.features[0].figures.uncut_at->point = {infinity, 0};
  const std::string text = picture(sample::part(), toolpath, findings);
  parsed(text);
  EXPECT_FALSE(std::regex_search(text, std::regex("[^a-z](nan|inf)[^a-z]", std::regex::icase)));
}

TEST(Svg, IsTheSameTextEachTime) {
  EXPECT_EQ(sample_picture(), sample_picture());
}

TEST(Svg, AnEmptyJobGivesAPage) {
  parsed(picture({}, {}, {}));
  Part part = sample::part();
  parsed(picture(part, {}, {}));
  part.features.clear();
  part.workplan.clear();
  parsed(picture(part, sample::toolpath(), sample::findings()));
}

TEST(Svg, ProgramsWithoutSectionNamesAreDrawnOnTheOnlyFeature) {
  Part part = sample::part();
  part.features.pop_back();
  part.workplan.pop_back();
  Toolpath toolpath{{sample::pocket_section()}};
  toolpath.sections[0].workingstep = -1;
  toolpath.sections[0].label.clear();
  EXPECT_THAT(picture(part, toolpath, sample::findings()), HasSubstr("A13 13 0 0 0 40 48"));
}

TEST(SvgWriter, SplitsLongArcsAndFlattensFlatOnes) {
  PathData almost_full;
  almost_full.add(Edge::arc({1, 0}, {std::cos(0.0001), -std::sin(0.0001)}, {0, 0}, Turn::kCounterClockwise));
  EXPECT_EQ(std::count(almost_full.text().begin(), almost_full.text().end(), 'A'), 4);
  PathData flat;
  flat.add(Edge::arc({0, 0}, {1, 0}, {0.5, 5000}, Turn::kCounterClockwise));
  EXPECT_EQ(flat.text(), "M0 0L1 0");
}

TEST(SvgWriter, JoinsWhatMeets) {
  PathData data;
  data.add(Edge::line({0, 0}, {1, 0}));
  data.add(Edge::line({1, 0}, {1, 1}));
  data.add(Edge::line({2, 2}, {3, 3}));
  EXPECT_EQ(data.text(), "M0 0L1 0L1 1M2 2L3 3");
}

TEST(SvgWriter, PrintedArcsKeepTheirCentreAndSweep) {
  // The path is read back: the centre that follows from printed ends, radius and side must be the arc's own.
  for (const double sweep : {0.3, 1.0, 2.0, 3.0, kPi, 3.3, 4.5, 6.2, -0.3, -2.0, -kPi, -3.5, -6.2}) {
    const Vec2 center{10, 4};
    const Edge arc = Edge::arc({13, 4}, center + rotated({3, 0}, sweep), center,
                               sweep > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
    PathData data;
    data.add(arc);
    const std::regex command("A([0-9.]+) ([0-9.]+) 0 0 ([01]) (-?[0-9.]+) (-?[0-9.]+)");
    Vec2 from = arc.from;
    double total = 0;
    for (std::sregex_iterator it(data.text().begin(), data.text().end(), command), end; it != end; ++it) {
      const Vec2 to{std::stod((*it)[4]), std::stod((*it)[5])};
      const double radius = std::stod((*it)[1]), half = distance(from, to) / 2,
                   side = (*it)[3] == "1" ? 1 : -1;
      ASSERT_LE(half, radius);
      const Vec2 found =
          lerp(from, to, 0.5) + left_of(unit(to - from)) * (side * std::sqrt(radius * radius - half * half));
      EXPECT_NEAR(distance(found, center), 0, 0.003) << data.text();
      total += side * 2 * std::asin(half / radius);
      from = to;
    }
    EXPECT_NEAR(total, sweep, 0.003) << data.text();
    EXPECT_NEAR(distance(from, arc.to), 0, 0.001);
  }
}

}  // namespace
}  // namespace clearcut::report
