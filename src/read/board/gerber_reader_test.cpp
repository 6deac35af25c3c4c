// Gerber layers by areas that are known by formula, and beside the winding of what was drawn.
#include "read/board/gerber_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/random.h"
#include "base/text.h"
#include "base/units.h"
#include "geometry/region.h"
#include "read/drawing/layer_rules.h"
#include "read/job/read_part.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;

const std::string kHead = "%FSLAX33Y33*%\n%MOMM*%\n";
const std::string kEnd = "M02*\n";

ReadOptions milled() {
  ReadOptions options;
  options.depth = 0.1;
  return options;
}

/// What a layer of unknown purpose has milled: all that is dark.
Regions dark_of(const std::string& body, const std::string& head = kHead) {
  Regions all;
  for (const Feature& feature : read_gerber(head + body + kEnd, "x.gbr", milled()).features)
    all.insert(all.end(), feature.target.begin(), feature.target.end());
  return all;
}

double dark_area_of(const std::string& body, const std::string& head = kHead) {
  return area(dark_of(body, head));
}

std::string refusal(const std::string& text, const std::string& name = "x.gbr") {
  try {
    read_gerber(text, name, milled());
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "not refused";
}

/// Rows of pads with a track through each row, drawn in segments that end on the pads: beyond their discs the tracks show.
TEST(Gerber, ABoardOfThousandsOfPadsAndTracksIsRead) {
  constexpr int kRows = 48, kPads = 48;
  constexpr double kPitch = 2.5, kRadius = 0.8, kWidth = 0.3;  // mm
  std::string body = "%ADD10C,1.6*%%ADD11C,0.3*%D10*\n", tracks = "D11*\n";
  for (int row = 0; row < kRows; ++row) {
    for (int pad = 0; pad < kPads; ++pad) {
      const std::string x = "X" + std::to_string(pad * 2500), y = "Y" + std::to_string(row * 2500);
      body += x + y + "D03*\n";
      if (pad + 1 < kPads) tracks += x + y + "D02*X" + std::to_string((pad + 1) * 2500) + "D01*\n";
    }
  }
  const double half = kWidth / 2;
  const double in_disc =
      half * std::sqrt(kRadius * kRadius - half * half) + kRadius * kRadius * std::asin(half / kRadius);
  const double row = kPads * kPi * kRadius * kRadius + (kPads - 1) * (kWidth * kPitch - 2 * in_disc);
  const Regions dark = dark_of(body + tracks);
  EXPECT_EQ(dark.size(), static_cast<std::size_t>(kRows));
  EXPECT_NEAR(area(dark), kRows * row, 0.05);
}

/// A square whose contour cuts in to every hole, up each column and back: as exporters without clear polarity draw a ground plane.
TEST(Gerber, AContourMayCutInToThousandsOfHoles) {
  constexpr int kColumns = 45, kRows = 45;
  const auto point = [](int x, int y) {
    return "X" + std::to_string(x) + "Y" + std::to_string(y) + "D01*\n";
  };
  std::string body = "G36*X0Y0D02*\n";
  for (int column = 0; column < kColumns; ++column) {
    const int x = 1000 * column + 500;
    body += point(x, 0);
    for (int row = 0; row < kRows; ++row) {
      const int y = 1000 * row + 500;
      body += point(x, y - 200) + point(x - 200, y - 200) + point(x - 200, y + 200) + point(x, y + 200);
    }
    for (int row = kRows - 1; row >= 0; --row) {
      const int y = 1000 * row + 500;
      body += point(x, y + 200) + point(x + 200, y + 200) + point(x + 200, y - 200) + point(x, y - 200);
    }
    body += point(x, 0);
  }
  body += point(1000 * kColumns, 0) + point(1000 * kColumns, 1000 * kRows) + point(0, 1000 * kRows) + "G37*";
  const Regions dark = dark_of(body);
  ASSERT_EQ(dark.size(), 1U);
  EXPECT_EQ(dark[0].islands().size(), static_cast<std::size_t>(kColumns * kRows));
  EXPECT_NEAR(area(dark), kColumns * kRows * (1 - 0.16), 1e-3);
}

TEST(Gerber, StandardAperturesHaveTheirAreas) {
  const double disc = kPi;  // of 2 mm
  EXPECT_NEAR(dark_area_of("%ADD10C,2*%D10*X0Y0D03*"), disc, 1e-9);
  EXPECT_NEAR(dark_area_of("%ADD10C,2X1*%D10*X0Y0D03*"), disc * 3 / 4, 1e-9);
  EXPECT_NEAR(dark_area_of("%ADD10R,3X2*%D10*X5000Y0D03*"), 6, 1e-9);
  EXPECT_NEAR(dark_area_of("%ADD10R,3X2X2*%D10*X5000Y0D03*"), 6 - disc, 1e-6);
  EXPECT_NEAR(dark_area_of("%ADD10O,3X2*%D10*X5000Y0D03*"), 2 + disc, 1e-9);
  EXPECT_NEAR(dark_area_of("%ADD10O,2X3*%D10*X5000Y0D03*"), 2 + disc, 1e-9);
  EXPECT_NEAR(dark_area_of("%ADD10P,2X6*%D10*X0Y0D03*"), 1.5 * std::sqrt(3), 1e-9);
  EXPECT_NEAR(dark_area_of("%ADD10P,2X4X45X1*%D10*X0Y0D03*"), 2 - kPi / 4, 1e-9);
}

/// Two rings and a cross 2 mm wide and 14 mm long: primitive 6.
TEST(Gerber, MoiresAreRingsAndACross) {
  const double rings = kPi * (25 - 16) + kPi * (9 - 4);
  const auto cross_in_disc = [](double r) {
    return 4 * (std::sqrt(r * r - 1) + r * r * std::asin(1 / r)) - 4;
  };
  const double in_rings = cross_in_disc(5) - cross_in_disc(4) + cross_in_disc(3) - cross_in_disc(2);
  const auto moire = [](const std::string& rest) {
    return dark_area_of("%AMM*6,0,0,10,1,1," + rest + "*%%ADD10M*%D10*X0Y0D03*");
  };
  EXPECT_NEAR(moire("2,0,0,0"), rings, 1e-6);
  EXPECT_NEAR(moire("9,0,0,0"), rings + kPi, 1e-6);
  EXPECT_NEAR(moire("2,2,14,0"), rings + 2 * 2 * 14 - 4 - in_rings, 1e-5);
  EXPECT_NEAR(moire("2,2,14,30"), rings + 2 * 2 * 14 - 4 - in_rings, 1e-5);
}

TEST(Gerber, LinesAndArcsAreAsWideAsTheirAperture) {
  EXPECT_NEAR(dark_area_of("%ADD10C,2*%D10*X0Y0D02*X10000D01*"), 20 + kPi, 1e-6);
  // Modal: the coordinates alone go on with D01.
  EXPECT_NEAR(dark_area_of("%ADD10C,2*%D10*X0Y0D02*X5000D01*X10000*"), 20 + kPi, 1e-6);
  EXPECT_NEAR(dark_area_of("%ADD10R,2X2*%D10*X0Y0D02*X10000Y10000D01*"), 4 + 40, 1e-6);
  EXPECT_NEAR(dark_area_of("%ADD10C,1*%D10*G75*X5000Y0D02*G03*X0Y5000I-5000J0D01*"), kPi / 2 * 5 + kPi / 4,
              1e-6);
  EXPECT_NEAR(dark_area_of("%ADD10C,1*%D10*G74*X5000Y0D02*G03*X0Y5000I5000J0D01*"), kPi / 2 * 5 + kPi / 4,
              1e-6);
  EXPECT_NEAR(dark_area_of("%ADD10C,1*%D10*G75*X5000Y0D02*G02*X5000Y0I-5000J0D01*"), kPi * 10, 1e-6);
  // A dot.
  EXPECT_NEAR(dark_area_of("%ADD10C,2*%D10*X1000Y0D02*X1000Y0D01*"), kPi, 1e-9);
}

TEST(Gerber, NumbersComeInAllTheirWays) {
  const std::string square = "%ADD10R,1X1*%D10*X2000Y1000D03*";
  const auto corner = [](const Regions& regions) { return box(regions).min; };
  EXPECT_NEAR(corner(dark_of(square)).x, 1.5, 1e-9);
  // Zeros at the end left out: 2 is 200 mm.
  EXPECT_NEAR(corner(dark_of("%ADD10R,1X1*%D10*X2Y1D03*", "%FSTAX33Y33*%\n%MOMM*%\n")).x, 199.5, 1e-9);
  // Inches, six decimals.
  EXPECT_NEAR(corner(dark_of("%ADD10R,1X1*%D10*X1000000Y0D03*", "%FSLAX26Y26*%\n%MOIN*%\n")).x, 12.7, 1e-9);
  EXPECT_NEAR(corner(dark_of("%ADD10R,1X1*%D10*X2000Y0D02*X-1000Y1000D03*", "%FSLIX33Y33*%\n%MOMM*%\n")).x,
              0.5, 1e-9);
  // Old files say the unit by G70, and that they are in ASCII.
  EXPECT_NEAR(corner(dark_of("%ADD10R,1X1*%G54D10*X10000Y0D03*", "%ICAS*%\n%FSLAX24Y24*%\nG70*\n")).x, 12.7,
              1e-9);
}

TEST(Gerber, WhatIsClearTakesAwayWhatWasDrawnBefore) {
  EXPECT_NEAR(
      dark_area_of("%ADD10R,4X4*%%ADD11C,2*%%ADD12C,1*%D10*X0Y0D03*%LPC*%D11*X0Y0D03*%LPD*%D12*X0Y0D03*"),
      16 - kPi + kPi / 4, 1e-6);
  // Clear before anything is drawn clears nothing.
  EXPECT_NEAR(dark_area_of("%ADD10R,4X4*%%LPC*%D10*X0Y0D03*%LPD*%X1000Y0D03*"), 16, 1e-9);
}

TEST(Gerber, RegionsMayCutInToTheirHoles) {
  EXPECT_NEAR(dark_area_of("G36*X0Y0D02*G01*X10000D01*Y10000D01*X0D01*Y0D01*G37*"), 100, 1e-9);
  // The outline left open, and clockwise.
  EXPECT_NEAR(dark_area_of("G36*X0Y0D02*G01*Y10000D01*X10000D01*Y0D01*G37*"), 100, 1e-9);
  // A hole that is reached by a cut along one line.
  EXPECT_NEAR(
      dark_area_of("G36*X0Y0D02*G01*X10000D01*Y10000D01*X0D01*Y5000D01*X3000D01*Y7000D01*X7000D01*Y3000D01*"
                   "X3000D01*Y5000D01*X0D01*Y0D01*G37*"),
      100 - 16, 1e-6);
  // Two outlines that overlap.
  EXPECT_NEAR(
      dark_area_of(
          "G36*X0Y0D02*G01*X10000D01*Y10000D01*X0D01*Y0D01*X5000Y5000D02*Y15000D01*X15000D01*Y5000D01*"
          "X5000D01*G37*"),
      175, 1e-9);
  EXPECT_NEAR(dark_area_of("G36*X0Y0D02*G01*X10000D01*G75*G03*X0Y0I-5000J0D01*G37*"), kPi * 25 / 2, 1e-9);
}

TEST(Gerber, MacrosAreEvaluated) {
  const std::string rounded =
      "%AMRR*0 a pad with round "
      "corners*4,1,4,$2,$3,$4,$5,$6,$7,$8,$9,$2,$3,0*1,1,$1+$1,$2,$3*1,1,$1+$1,$4,$5*"
      "1,1,$1+$1,$6,$7*1,1,$1x2,$8,$9*20,1,$1+$1,$2,$3,$4,$5,0*20,1,$1+$1,$4,$5,$6,$7,0*20,1,$1+$1,$6,$7,$8,$"
      "9,0*"
      "20,1,$1+$1,$8,$9,$2,$3,0*%%ADD10RR,0.5X-1X-1X1X-1X1X1X-1X1*%D10*X0Y0D03*";
  EXPECT_NEAR(dark_area_of(rounded), 4 + 4 * 2 * 0.5 + kPi / 4, 1e-6);
  EXPECT_NEAR(dark_area_of("%AMB*21,1,$1,$2-(1/2),1,0,90*%%ADD10B,3X1.5*%D10*X0Y0D03*"), 3, 1e-9);
  EXPECT_NEAR(dark_area_of("%AMV*$3=$1x$2*1,1,$3,0,0*1,0,$3/2,0,0*%%ADD10V,2X2*%D10*X0Y0D03*"), kPi * 3,
              1e-6);
  EXPECT_NEAR(dark_area_of("%AMH*5,1,6,0,0,2,0*%%ADD10H*%D10*X0Y0D03*", kHead), 1.5 * std::sqrt(3), 1e-9);
  // A ring of 4 and 2 mm with four gaps of 0.5 mm.
  const double strip = [] {
    double sum = 0;  // of the ring under a strip, by narrow slices
    constexpr int kSlices = 100000;
    for (int i = 0; i < kSlices; ++i) {
      const double y = -0.25 + 0.5 * (i + 0.5) / kSlices;
      sum += 2 * (std::sqrt(4 - y * y) - std::sqrt(1 - y * y)) * 0.5 / kSlices;
    }
    return sum;
  }();
  EXPECT_NEAR(dark_area_of("%AMT*7,0,0,4,2,0.5,30*%%ADD10T*%D10*X0Y0D03*"), 3 * kPi - 2 * strip, 1e-4);
}

TEST(Gerber, BlocksAreRepeatedMirroredTurnedAndScaled) {
  EXPECT_NEAR(dark_area_of("%ADD10R,1X1*%%SRX3Y2I2J3*%D10*X0Y0D03*%SR*%"), 6, 1e-9);
  EXPECT_NEAR(dark_area_of("%ADD10R,1X1*%%ABD12*%D10*X0Y0D03*X3000D03*%AB*%D12*X0Y0D03*Y5000D03*"), 4, 1e-9);
  const std::string pad = "%AMQ*21,1,4,1,2,0,0*%%ADD10Q*%";  // from the origin to the right
  EXPECT_NEAR(box(dark_of(pad + "%LMX*%D10*X0Y0D03*")).min.x, -4, 1e-9);
  EXPECT_NEAR(box(dark_of(pad + "%LR90*%D10*X0Y0D03*")).max.y, 4, 1e-9);
  EXPECT_NEAR(dark_area_of(pad + "%LS1.5*%D10*X0Y0D03*"), 4 * 2.25, 1e-9);
}

TEST(Gerber, CopperStaysAndIsParted) {
  const std::string copper =
      "%TF.FileFunction,Copper,L1,Top*%" + kHead + "%ADD10C,2*%D10*X0Y0D03*X5000D03*" + kEnd;
  const Part part = read_gerber(copper, "a.gbr", milled());
  ASSERT_EQ(part.features.size(), 1U);
  const Feature& feature = part.features.front();
  EXPECT_EQ(feature.kind, FeatureKind::kIsolation);
  EXPECT_NEAR(area(feature.target), 2 * kPi * (1.3 * 1.3 - 1), 1e-6);
  EXPECT_FALSE(contains(feature.allowed, Vec2{0.5, 0}));
  EXPECT_TRUE(contains(feature.allowed, Vec2{2.5, 0}));
  ReadOptions wide = milled();
  wide.layer_rules = {rule_of_option("isolate_w0.5_d0.2:*", "--op")};
  wide.depth.reset();
  EXPECT_NEAR(area(read_gerber(copper, "a.gbr", wide).features.front().target), 2 * kPi * (1.5 * 1.5 - 1),
              1e-6);
}

TEST(Gerber, TheFileOrItsNameSaysWhatTheLayerIs) {
  const std::string outline = "%ADD10C,0.1*%D10*X0Y0D02*X10000D01*Y10000D01*X0D01*Y0D01*";
  const auto kind = [&](const std::string& function, const std::string& name) {
    const std::string text =
        (function.empty() ? "" : "%TF.FileFunction," + function + "*%") + kHead + outline + kEnd;
    return read_gerber(text, name, milled()).features.front().kind;
  };
  EXPECT_EQ(kind("Profile,NP", "x.gbr"), FeatureKind::kOutsideProfile);
  EXPECT_EQ(kind("", "board-Edge_Cuts.gbr"), FeatureKind::kOutsideProfile);
  EXPECT_EQ(kind("", "board.GKO"), FeatureKind::kOutsideProfile);
  EXPECT_EQ(kind("", "board.gtl"), FeatureKind::kIsolation);
  EXPECT_EQ(kind("Copper,L1,Top", "board.gko"), FeatureKind::kIsolation);
  EXPECT_EQ(kind("Soldermask,Top", "x.gbr"), FeatureKind::kClosedPocket);
  const std::string old = "G04 #@! TF.FileFunction,Profile,NP*\n" + kHead + outline + kEnd;
  const Part part = read_gerber(old, "x.gbr", milled());
  // The outline itself, not the stroke that it is drawn with.
  EXPECT_NEAR(std::abs(signed_area(part.features.front().profile->line)), 100, 1e-9);
  ReadOptions asking = milled();
  asking.ask_if_unclear = true;
  EXPECT_THROW(read_gerber(kHead + outline + kEnd, "x.gbr", asking), InputError);
}

TEST(Gerber, IsMirroredForTheOtherSide) {
  ReadOptions options = milled();
  options.mirror = true;
  const Part part = read_gerber(kHead + "%ADD10R,1X2*%D10*X5000Y0D03*" + kEnd, "x.gbr", options);
  EXPECT_NEAR(box(part.features.front().target).min.x, -5.5, 1e-9);
  const Part bottom = read_gerber(
      "%TF.FileFunction,Copper,L2,Bot*%" + kHead + "%ADD10C,1*%D10*X0Y0D03*" + kEnd, "x.gbr", milled());
  std::string said;
  for (const Diagnostic& item : bottom.diagnostics.items()) said += item.what;
  EXPECT_THAT(said, HasSubstr("--mirror"));
}

TEST(Gerber, DamageIsRefusedWithItsPlace) {
  EXPECT_THAT(refusal(kHead + "%ADD10C,1*%D10*X0Y0D03*"), HasSubstr("cut short"));
  EXPECT_THAT(refusal(kHead + "%ADD10C,1*\nD10*X0Y0D03*" + kEnd), HasSubstr("x.gbr:3: "));
  EXPECT_THAT(refusal(kHead + "D11*X0Y0D03*" + kEnd), HasSubstr("D11 is not defined"));
  EXPECT_THAT(refusal("%MOMM*%%ADD10C,1*%D10*X0Y0D03*" + kEnd), HasSubstr("how its numbers are written"));
  EXPECT_THAT(refusal("%FSLAX33Y33*%%ADD10C,1*%D10*X0Y0D03*" + kEnd), HasSubstr("unit"));
  EXPECT_THAT(refusal(kHead + "%ADD10O,1X2*%D10*X0Y0D02*X100D01*" + kEnd), HasSubstr("no circle"));
  EXPECT_THAT(refusal(kHead + "%ADD10C,1*%D10*G75*X0Y0D02*G02*X100Y0I0J9000000D01*X0Y0I1J1D01*" + kEnd),
              HasSubstr("arc"));
  EXPECT_THAT(refusal(kHead + "%AMX*1,1,$1+*%%ADD10X,1*%" + kEnd), HasSubstr("macro"));
  EXPECT_THAT(refusal(kHead + "%ADD10Q,1*%" + kEnd), HasSubstr("aperture"));
  EXPECT_THAT(refusal(kHead + "%SFA2B2*%" + kEnd), HasSubstr("no longer in use"));
  EXPECT_THAT(refusal(kHead + "%ADD10R,1X1*%%SRX9999Y9999I1J1*%D10*X0Y0D03*%SR*%" + kEnd),
              HasSubstr("2 million"));
}

/// Random flashes and strokes, dark and clear, beside what each drew last over sampled points.
TEST(Gerber, RandomDrawingsAreDarkWhereTheLastThingDrawnIs) {
  Random random(7);
  for (int round = 0; round < 200; ++round) {
    struct Thing {
      bool dark;
      Vec2 from, to;
      double radius;
    };
    std::vector<Thing> things;
    std::string body = "%ADD10C,1*%%ADD11C,2.5*%%ADD12C,4*%";
    const auto place = [&] {
      return Vec2{static_cast<double>(random.below(20)), static_cast<double>(random.below(20))};
    };
    const auto words = [](Vec2 p) { return "X" + trimmed(p.x * 1000, 0) + "Y" + trimmed(p.y * 1000, 0); };
    for (std::uint64_t count = 2 + random.below(8); count > 0; --count) {
      const auto size = random.below(3);
      Thing thing{things.empty() || random.unit() < 0.7, place(), place(),
                  size == 0   ? 0.5
                  : size == 1 ? 1.25
                              : 2};
      if (random.unit() < 0.5) thing.to = thing.from;
      body += (thing.dark ? "%LPD*%D1" : "%LPC*%D1") + std::to_string(size) + "*" + words(thing.from) +
              "D02*" + words(thing.to) + "D01*\n";
      things.push_back(thing);
    }
    const Regions dark = dark_of(body);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p{random.between(-3, 23), random.between(-3, 23)};
      bool expected = false, is_near = false;
      for (const Thing& thing : things) {
        const Vec2 along = thing.to - thing.from;
        const double size = dot(along, along);
        const double t = size == 0 ? 0 : std::clamp(dot(p - thing.from, along) / size, 0.0, 1.0);
        const double away = distance(p, thing.from + along * t) - thing.radius;
        is_near = is_near || std::abs(away) < 0.01;
        if (away < 0) expected = thing.dark;
      }
      EXPECT_TRUE(is_near || contains(dark, p) == expected) << round << "\n" << body;
    }
  }
}

}  // namespace
}  // namespace clearcut::read
