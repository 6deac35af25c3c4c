// What the control and the tool may not be asked to do while a move cuts; what a control may do within its tolerance.
#include "verify/faults/state_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "model/results/findings.h"
#include "verify/test_program.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using namespace clearcut::testing;

const std::vector<double> kRings{2.5, 6, 7};

Part pocket() {
  Part part = pocket_part(rectangle(-10, -10, 10, 10), 6, -2);
  part.stock = Stock{{{-20, -20}, {20, 20}}, -5, 0};
  return part;
}

Toolpath pocketing(double z = -2) {
  Writer writer;
  cut_square_rings(writer, {0, 0}, kRings, 0, z);
  return writer.done();
}

/// One state from the first move on.
ControlTable table(const std::function<void(ControlState&)>& change = {}) {
  ControlState state;
  state.tool = 1;
  state.spindle = SpindleState::kClockwise;
  state.spindle_rpm = 10000;
  state.path.mode = PathMode::kExactPath;
  if (change) change(state);
  ControlTable control;
  control.spans.push_back({0, 1, state});
  return control;
}

Findings checked(const Part& part, const Toolpath& toolpath, const ControlTable& control,
                 VerifyOptions options = {}) {
  options.control = &control;
  return verify_program(part, toolpath, options);
}

bool has(const Findings& findings, FaultKind kind) {
  for (const Fault& fault : findings.faults) {
    if (fault.kind == kind) return true;
  }
  return false;
}

std::string names_of(const Findings& findings) {
  std::string names;
  for (const Condition& one : findings.conditions) names += (names.empty() ? "" : " ") + one.name;
  return names;
}

std::string first(const Findings& findings) {
  return findings.faults.empty() ? "" : findings.faults.front().text;
}

TEST(StateFaults, ARightProgramHasNone) {
  const Findings findings = checked(pocket(), pocketing(), table());
  EXPECT_TRUE(findings.faults.empty()) << first(findings);
}

TEST(StateFaults, SpindleOffWithoutSpeedOrTheWrongWay) {
  const auto with = [](const std::function<void(ControlState&)>& change) {
    return checked(pocket(), pocketing(), table(change));
  };
  EXPECT_TRUE(has(with([](ControlState& s) { s.spindle = SpindleState::kOff; }), FaultKind::kSpindleOff));
  EXPECT_TRUE(has(with([](ControlState& s) { s.spindle_rpm = 0; }), FaultKind::kSpindleOff));
  const auto left = [](ControlState& s) { s.spindle = SpindleState::kCounterClockwise; };
  EXPECT_TRUE(has(with(left), FaultKind::kSpindleDirection));
  Part part = pocket();
  part.workplan[0].operation.cutting.spindle_clockwise = false;
  EXPECT_FALSE(has(checked(part, pocketing(), table(left)), FaultKind::kSpindleDirection));
}

TEST(StateFaults, ChamferMillsWhoseTipRunsInTheOpenAreChecked) {
  Part part = pocket();
  Tool chamfer;
  chamfer.number = 2;
  chamfer.kind = ToolKind::kChamferMill;
  chamfer.diameter = 8;
  chamfer.tip_diameter = 0.4;
  chamfer.tip_angle = Radians::of(kPi / 2);
  part.tools.push_back(chamfer);
  Writer writer;
  cut_square_rings(writer, {0, 0}, kRings, 0, -2);
  writer.leave().tool_change(2).rapid({9, 0}, 10).feed({9, 0}, -1.5).feed({9, 5}).leave();
  const Toolpath toolpath = writer.done();
  const std::size_t before = toolpath.sections[0].moves.size();
  const auto with = [&](const std::function<void(ControlState&)>& change) {
    ControlTable control = table();
    ControlState state = control.spans[0].state;
    state.tool = 2;
    change(state);
    control.spans.push_back({before, 1, state});
    return checked(part, toolpath, control);
  };
  EXPECT_FALSE(has(with([](ControlState&) {}), FaultKind::kSpindleOff));
  EXPECT_TRUE(has(with([](ControlState& s) { s.spindle = SpindleState::kOff; }), FaultKind::kSpindleOff));
  EXPECT_TRUE(has(with([](ControlState& s) {
                    s.length = {LengthKind::kNumbered, 1, 0};
                  }),
                  FaultKind::kToolLength));
}

TEST(StateFaults, ATappingCycleWithAnotherToolThanATap) {
  const auto turned_back_before = [](std::size_t move) {
    ControlTable control = table();
    control.events.push_back({ControlEventKind::kTapTurnsBack, move, 1});
    return checked(pocket(), pocketing(), control);
  };
  const std::size_t moves = pocketing().sections[0].moves.size();
  for (std::size_t move = 1; move <= moves; ++move)
    EXPECT_TRUE(has(turned_back_before(move), FaultKind::kTapping)) << move;
  EXPECT_FALSE(has(checked(pocket(), pocketing(), table()), FaultKind::kTapping));
}

TEST(StateFaults, SpindleBeyondTheMachineAndTooShortAWait) {
  VerifyOptions options;
  options.machine.max_spindle_rpm = 8000;
  EXPECT_TRUE(has(checked(pocket(), pocketing(), table(), options), FaultKind::kSpindleSpeed));
  options.machine.max_spindle_rpm = 10000;
  Part limited = pocket();
  limited.tools[0].max_spindle_rpm = 8000;
  EXPECT_TRUE(has(checked(limited, pocketing(), table(), options), FaultKind::kSpindleSpeed));
  limited.tools[0].max_spindle_rpm = 10000;
  EXPECT_FALSE(has(checked(limited, pocketing(), table(), options), FaultKind::kSpindleSpeed));
  options.machine.min_spindle_rpm = 10000;
  EXPECT_FALSE(has(checked(pocket(), pocketing(), table(), options), FaultKind::kSpindleSpeed));
  options.machine.max_spindle_rpm = 24000;
  options.machine.min_spindle_rpm = 12000;
  EXPECT_TRUE(has(checked(pocket(), pocketing(), table(), options), FaultKind::kSpindleSpeed));
  options.machine.min_spindle_rpm.reset();
  options.machine.spindle_wait_s = 3;
  ControlTable control = table();
  control.events.push_back({ControlEventKind::kSpindleStart, 0, 1, 0, 1});
  EXPECT_TRUE(has(checked(pocket(), pocketing(), control, options), FaultKind::kSpindleOff));
  control.events.push_back({ControlEventKind::kDwell, 0, 2, 3, 1});
  const Findings waited = checked(pocket(), pocketing(), control, options);
  EXPECT_TRUE(waited.faults.empty()) << first(waited);
  EXPECT_EQ(waited.all.waits_s, 3);
}

TEST(StateFaults, LengthOfAnotherToolAndNone) {
  const ControlTable other = table([](ControlState& s) { s.length = {LengthKind::kNumbered, 5, 0}; });
  EXPECT_TRUE(has(checked(pocket(), pocketing(), other), FaultKind::kToolLength));
  VerifyOptions accepting;
  accepting.accepted = {"tool-length-h5"};
  EXPECT_FALSE(has(checked(pocket(), pocketing(), other, accepting), FaultKind::kToolLength));
  ControlTable none = table();
  none.events.push_back({ControlEventKind::kToolChange, 0, 1, 0, 1});
  VerifyOptions needing;
  needing.needs_tool_length = true;
  const Findings touched = checked(pocket(), pocketing(), none, needing);
  EXPECT_FALSE(has(touched, FaultKind::kToolLength))
      << "no length anywhere: touched off with the tool in the spindle";
  EXPECT_EQ(names_of(touched), "tool-length-off");
  EXPECT_FALSE(has(checked(pocket(), pocketing(), none), FaultKind::kToolLength)) << "one tool, touched off";
  ControlState with_length = none.spans[0].state;
  with_length.length = {LengthKind::kNumbered, 1, 0};
  none.spans.push_back({pocketing().sections[0].moves.size() - 1, 9, with_length});
  EXPECT_TRUE(has(checked(pocket(), pocketing(), none, needing), FaultKind::kToolLength))
      << "a program that uses lengths, but not here";
}

TEST(StateFaults, WhatNoWordSaysIsLeftToHands) {
  ControlTable control = table([](ControlState& s) {
    s.spindle = SpindleState::kOff;
    s.spindle_rpm = 0;
  });
  EXPECT_TRUE(has(checked(pocket(), pocketing(), control), FaultKind::kSpindleOff));
  control.spindle_said = control.speed_said = false;
  const Findings by_hand = checked(pocket(), pocketing(), control);
  EXPECT_TRUE(by_hand.faults.empty()) << first(by_hand);
  EXPECT_EQ(names_of(by_hand), "spindle-by-hand");
  ControlTable no_speed = table([](ControlState& s) { s.spindle_rpm = 0; });
  no_speed.speed_said = false;
  VerifyOptions limited;
  limited.machine.min_spindle_rpm = 100;
  const Findings by_dial = checked(pocket(), pocketing(), no_speed, limited);
  EXPECT_TRUE(by_dial.faults.empty()) << first(by_dial);
  EXPECT_EQ(names_of(by_dial), "speed-by-hand");
}

/// Of a program that ran before: what it cut counts only where its own state was right.
TEST(StateFaults, OfAProgramBefore) {
  Writer before;
  before.enter({0, 0}, 0, -2).feed({3, 0}, -2);
  const Toolpath earlier = before.done();
  const ControlTable off = table([](ControlState& s) { s.spindle = SpindleState::kOff; });
  VerifyOptions options;
  options.earlier = &earlier;
  EXPECT_FALSE(has(checked(pocket(), pocketing(), table(), options), FaultKind::kSpindleOff));
  options.earlier_control = &off;
  const Findings found = checked(pocket(), pocketing(), table(), options);
  EXPECT_TRUE(has(found, FaultKind::kSpindleOff));
  EXPECT_NE(first(found).find("in the program before"), std::string::npos) << first(found);
}

TEST(Causes, OneMistakeIsToldOnce) {
  Writer writer;
  for (const double x : {-6.0, 0.0, 6.0}) writer.enter({x, 0}, 0, -1).leave();
  const Findings wrong_length = checked(pocket(), writer.done(), table([](ControlState& s) {
                                          s.length = {LengthKind::kNumbered, 5, 0};
                                        }));
  const auto lengths = std::count_if(wrong_length.faults.begin(), wrong_length.faults.end(),
                                     [](const Fault& fault) { return fault.kind == FaultKind::kToolLength; });
  EXPECT_EQ(lengths, 1);
}

/// Nothing is known of what a tool cuts that is not among the part's: that it leaves the pocket uncut is no second fault.
TEST(Causes, OfAToolThatIsNotKnown) {
  Writer writer(7);
  cut_square_rings(writer, {0, 0}, kRings, 0, -2);
  Part part = pocket();
  part.tools[0].number = 1;
  part.tools.push_back(part.tools[0]);
  part.tools[1].number = 2;
  const Findings findings = checked(part, writer.done(), table());
  ASSERT_EQ(told_faults(findings).size(), 1U) << first(findings);
  EXPECT_EQ(findings.faults.front().kind, FaultKind::kWrongTool);
  EXPECT_GT(findings.faults.size(), 1U) << "those that follow are kept";
  EXPECT_EQ(findings.faults.back().cause, "wrong tool");
}

TEST(Causes, AProgramOfTheOtherUnit) {
  for (const double scale : {25.4, 1 / 25.4}) {
    Toolpath toolpath = pocketing();
    for (Move& move : toolpath.sections[0].moves) {
      move.path = Edge::line(move.path.from * scale, move.path.to * scale);
      move.z_from *= scale;
      move.z_to *= scale;
    }
    const Findings findings = checked(pocket(), toolpath, table());
    ASSERT_FALSE(findings.faults.empty());
    EXPECT_EQ(findings.faults.front().kind, FaultKind::kUnits) << scale;
    EXPECT_EQ(told_faults(findings).size(), 1U) << scale;
  }
  Toolpath wide = pocketing();
  for (Move& move : wide.sections[0].moves)
    move.path = Edge::line(move.path.from + Vec2{30, 0}, move.path.to + Vec2{30, 0});
  EXPECT_FALSE(has(checked(pocket(), wide, table()), FaultKind::kUnits)) << "elsewhere, of the right size";
}

/// A program for a stock of x and y -20 to 20, z -5 to 0: it begins in the open on the left, and at two places from above.
Toolpath begun_at_four_places() {
  Writer writer;
  for (const double y : {-8, 8}) writer.rapid({-24, y}, 10).rapid({-24, y}, -2).feed({15, y}).leave();
  for (const double y : {0, 16}) writer.enter({-15, y}, 0, -4).feed({15, y}).leave();
  return writer.done();
}

Findings begun_in(const Stock& stock, const Toolpath& toolpath = begun_at_four_places()) {
  Part part = pocket();
  part.is_shape_stated = false;
  part.stock = stock;
  return checked(part, toolpath, table());
}

struct WrongStock {
  const char* what;
  Stock stock;
  FaultKind kind;
  const char* says;
};

TEST(Causes, AWrongStockIsOneFault) {
  EXPECT_TRUE(told_faults(begun_in({{{-20, -20}, {20, 20}}, -5, 0})).empty());
  for (const WrongStock& wrong : std::vector<WrongStock>{
           {"too high",
            {{{-20, -20}, {20, 20}}, -5, 8},
            FaultKind::kRapidInMaterial,
            "z -5 to 1 in place of"},
           {"lifted", {{{-20, -20}, {20, 20}}, 3, 8}, FaultKind::kRapidInMaterial, "z -4 to 1 in place of"},
           {"too wide", {{{-40, -20}, {20, 20}}, -5, 0}, FaultKind::kRapidInMaterial, "x -21 to 20"},
           {"both",
            {{{-40, -20}, {20, 20}}, -5, 8},
            FaultKind::kRapidInMaterial,
            "x -21 to 20, y -20 to 20, z -5 to 1"},
           {"too thin", {{{-20, -20}, {20, 20}}, -1, 0}, FaultKind::kBeyondStock, "Likewise"}}) {
    const Findings findings = begun_in(wrong.stock);
    ASSERT_EQ(told_faults(findings).size(), 1U) << wrong.what;
    EXPECT_EQ(findings.faults.front().kind, wrong.kind) << wrong.what;
    EXPECT_NE(first(findings).find(wrong.says), std::string::npos) << wrong.what << ": " << first(findings);
  }
}

TEST(Causes, RapidsThroughTheMidstOfTheStockAreEachListed) {
  Writer writer;
  for (const double y : {-8, 0, 8})
    writer.enter({-15, y}, 0, -2).feed({-5, y}).rapid({5, y}, -2).feed({15, y}).leave();
  const Findings findings = begun_in({{{-20, -20}, {20, 20}}, -5, 0}, writer.done());
  EXPECT_EQ(told_faults(findings).size(), 3U);
}

/// In the machine's coordinates, where these say where the work lies.
TEST(Travel, CountsFromWhereTheWorkLies) {
  VerifyOptions options;
  options.machine.travel = {{{0, 17}, {-50, 50}, {-50, 50}}};
  EXPECT_TRUE(has(checked(pocket(), pocketing(), table(), options), FaultKind::kOutsideTravel));
  options.machine.places = MachinePlaces{};
  options.machine.places->origins[0] = {8, 0, 0};
  EXPECT_FALSE(has(checked(pocket(), pocketing(), table(), options), FaultKind::kOutsideTravel));
  options.machine.travel = {{{-8, 9}, {-50, 50}, {-50, 50}}};
  EXPECT_TRUE(has(checked(pocket(), pocketing(), table(), options), FaultKind::kOutsideTravel));
}

TEST(StateFaults, PlungeFeedFlutesAndStock) {
  Part part = pocket();
  part.workplan[0].operation.cutting.plunge_feed = MmPerMin::of(250);
  EXPECT_TRUE(has(checked(part, pocketing(), table()), FaultKind::kPlungeTooFast));
  part.workplan[0].operation.cutting.plunge_feed = MmPerMin::of(300);
  EXPECT_FALSE(has(checked(part, pocketing(), table()), FaultKind::kPlungeTooFast));
  part.tools[0].flute_length = 1.5;
  EXPECT_TRUE(has(checked(part, pocketing(), table()), FaultKind::kBeyondFlutes));
  part.tools[0].flute_length = 2;
  EXPECT_FALSE(has(checked(part, pocketing(), table()), FaultKind::kBeyondFlutes));
  EXPECT_FALSE(has(checked(part, pocketing(), table()), FaultKind::kBeyondStock));
  part.stock->z_bottom = -1;
  EXPECT_TRUE(has(checked(part, pocketing(), table()), FaultKind::kBeyondStock));
}

/// A pocket of 20 mm, 2 mm deep, with one of 10 mm in its floor: in it nothing higher stands beside the cutter.
TEST(StateFaults, FlutesReachAsHighAsMaterialStandsBesideTheCutter) {
  const auto below_a_wider_pocket = [](double flutes, double shank = 0) {
    Part part = pocket();
    part.tools[0].flute_length = flutes;
    part.tools[0].shank_diameter = shank;
    Feature deeper = part.features[0];
    deeper.name = "DEEPER";
    deeper.target = deeper.allowed = rectangle(-5, -5, 5, 5);
    deeper.top_z = -2;
    deeper.floor_z = -4;
    part.features.push_back(deeper);
    Workingstep step = part.workplan[0];
    step.feature = 1;
    part.workplan.push_back(step);
    Writer writer;
    cut_square_rings(writer, {0, 0}, kRings, 0, -2);
    cut_square_rings(writer, {0, 0}, {2}, -2, -4);
    return checked(part, writer.done(), table());
  };
  EXPECT_FALSE(has(below_a_wider_pocket(2.2), FaultKind::kBeyondFlutes));
  EXPECT_TRUE(has(below_a_wider_pocket(1.8), FaultKind::kBeyondFlutes));
  EXPECT_FALSE(has(below_a_wider_pocket(2.2, 12), FaultKind::kHolder)) << "the wider shank has room";
  EXPECT_TRUE(has(below_a_wider_pocket(2.2, 17), FaultKind::kHolder));
}

/// Layers of 1 mm along walls 2 mm high: only the lowest 1.5 mm of the cutter has flutes.
TEST(StateFaults, WallsOfEarlierLayersStandBesideTheShank) {
  const auto in_two_layers = [](const std::vector<double>& rings, double shank = 0) {
    Part part = pocket();
    part.tools[0].flute_length = 1.5;
    part.tools[0].shank_diameter = shank;
    Writer writer;
    cut_square_rings(writer, {0, 0}, kRings, 0, -1);
    cut_square_rings(writer, {0, 0}, rings, -1, -2);
    return checked(part, writer.done(), table());
  };
  EXPECT_TRUE(has(in_two_layers(kRings), FaultKind::kBeyondFlutes));
  EXPECT_FALSE(has(in_two_layers({2.5, 6}), FaultKind::kBeyondFlutes)) << "1 mm off the walls";
  EXPECT_FALSE(has(in_two_layers(kRings, 5), FaultKind::kBeyondFlutes)) << "a neck has room";
}

/// Beside the block, too: there is the table that it lies on.
TEST(StateFaults, BelowTheStockWhereNothingStands) {
  const auto beside = [](double z) {
    Writer writer;
    cut_square_rings(writer, {0, 0}, kRings, 0, -2);
    writer.rapid({0, 0}, 10).rapid({100, 0}, 10).feed({100, 0}, z, 300);
    return checked(pocket(), writer.done(), table());
  };
  EXPECT_FALSE(has(beside(-5.9), FaultKind::kBeyondStock)) << "as far as a way through needs";
  EXPECT_TRUE(has(beside(-6.1), FaultKind::kBeyondStock));
}

/// The digits of inches put the end of a gentle ramp 2.5 um lower within 2.5 um; ways down in many such pieces are steep all the same.
TEST(StateFaults, ShortPiecesOfRampsAreJudgedWithTheMoveBefore) {
  Part part = pocket();
  part.workplan[0].operation.cutting.plunge_feed = MmPerMin::of(300);
  const auto ramped = [&](double advance, double down, int count) {
    Writer writer;
    writer.rapid({0, 0}, 10).rapid({0, 0}, 1).feed({0, 0}, 0, 200).feed({5, 0}, -0.5, 500);
    for (int i = 1; i <= count; ++i) writer.feed({5 + i * advance, 0}, -0.5 - i * down, 500);
    return checked(part, writer.done(), table());
  };
  EXPECT_FALSE(has(ramped(0.00254, 0.00254, 1), FaultKind::kPlungeTooFast));
  EXPECT_TRUE(has(ramped(0.00254, 0.00254, 3), FaultKind::kPlungeTooFast));
  EXPECT_TRUE(has(ramped(0.5, 0.5, 1), FaultKind::kPlungeTooFast));
}

/// Down by 2 mm within 1 um of advance.
TEST(StateFaults, ASteepEntryIsAPlunge) {
  Part part = pocket();
  part.tools[0].center_cutting = false;
  const auto entered = [&](double advance) {
    Writer writer;
    writer.rapid({0, 0}, 10).rapid({0, 0}, 1).feed({advance, 0}, -2, 300);
    return checked(part, writer.done(), table());
  };
  EXPECT_TRUE(has(entered(0.001), FaultKind::kPlungeTooFast));
  EXPECT_TRUE(has(entered(6), FaultKind::kPlungeTooFast)) << "26 degrees";
  EXPECT_FALSE(has(entered(20), FaultKind::kPlungeTooFast)) << "9 degrees";
}

TEST(StateFaults, EngagementAboveTheLimitAndUnderAWave) {
  VerifyOptions options;
  options.engagement_limit_deg = 90;
  EXPECT_TRUE(has(checked(pocket(), pocketing(), table(), options), FaultKind::kOverEngagement));
  // A slot that falls and rises by half a micrometre is a slot.
  Writer writer;
  writer.rapid({-8, 0}, 10).rapid({-8, 0}, 1).feed({-8, 0}, -2, 300);
  for (int i = 1; i <= 16; ++i) writer.feed({-8.0 + i, 0}, i % 2 != 0 ? -2.0005 : -2);
  const Findings wave =
      checked(pocket_part(rectangle(-20, -10, 20, 10), 6, -2), writer.done(), table(), options);
  EXPECT_GT(wave.all.engagement.max_deg, 170);
  EXPECT_TRUE(has(wave, FaultKind::kOverEngagement));
}

/// Slots side by side with ways through the air between them: one mistake in five places.
TEST(StateFaults, EngagementAboveTheLimitIsToldOnce) {
  VerifyOptions options;
  options.engagement_limit_deg = 90;
  Writer writer;
  for (const double y : {-20.0, -10.0, 0.0, 10.0, 20.0}) writer.enter({-16, y}, 0, -2).feed({16, y}).leave();
  const Findings found =
      checked(pocket_part(rectangle(-20, -24, 20, 24), 6, -2), writer.done(), table(), options);
  EXPECT_EQ(std::count_if(found.faults.begin(), found.faults.end(),
                          [](const Fault& one) { return one.kind == FaultKind::kOverEngagement; }),
            1);
  const auto first = std::find_if(found.faults.begin(), found.faults.end(),
                                  [](const Fault& one) { return one.kind == FaultKind::kOverEngagement; });
  EXPECT_NE(first->text.find("Likewise in 4 more places"), std::string::npos) << first->text;
}

/// Corners rounded by the control leave material in the corners of the pocket, and cut the corner of an island.
TEST(Blending, EntersWhatIsLeftAndGouges) {
  const auto within = [](double tolerance) {
    return table([&](ControlState& s) { s.path = {PathMode::kTolerance, tolerance, {}}; });
  };
  const Findings fine = checked(pocket(), pocketing(), within(0.002));
  EXPECT_TRUE(fine.faults.empty()) << first(fine);
  EXPECT_EQ(fine.all.path_tolerance_mm, 0.002);
  EXPECT_TRUE(has(checked(pocket(), pocketing(), within(0.5)), FaultKind::kUncut));
  // Round a sharp corner of the part, outside of it: what is cut off the corner is cut off the part.
  Part part = pocket_part(rectangle(0, 0, 40, 40), 6, -2);
  part.features[0].target = part.features[0].allowed = {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{0, 0}, {40, 0}, {40, 20}, {20, 20}, {20, 40}, {0, 40}}), {})};
  Writer writer;
  writer.enter({37, 16.9}, 0, -2).feed({16.9, 16.9}).feed({16.9, 37});
  EXPECT_FALSE(has(checked(part, writer.done(), within(0)), FaultKind::kGouge));
  const Findings round = checked(part, writer.done(), within(2));
  EXPECT_TRUE(has(round, FaultKind::kGouge));
  EXPECT_GT(round.all.gouge_mm, 0.1);
}

TEST(ArcsOfTwoRadii, AreCheckedOnTheWorstReading) {
  const Part part = pocket_part({Region::from_valid_loops(circle_loop({0, 0}, 10), {})}, 6, -2);
  Writer writer;
  writer.enter({7, 0}, 0, -2)
      .arc({-7, 0}, {0, 0}, Turn::kCounterClockwise)
      .arc({7, 0}, {0, 0}, Turn::kCounterClockwise);
  const Toolpath toolpath = writer.done();
  ControlTable control = table();
  EXPECT_FALSE(has(checked(part, toolpath, control), FaultKind::kGouge));
  std::size_t arc = 0;
  while (!toolpath.sections[0].moves[arc].path.is_arc()) ++arc;
  control.arcs.push_back({arc, 0.0023});
  EXPECT_TRUE(has(checked(part, toolpath, control), FaultKind::kGouge));
}

}  // namespace
}  // namespace clearcut::verify
