#include "base/elementary.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/units.h"

namespace clearcut {
namespace {

constexpr int kValues = 20000;

/// One number from the bits of all results (FNV-1a).
class Bits {
 public:
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int shift = 0; shift < 64; shift += 8) hash_ = (hash_ ^ (bits >> shift & 0xff)) * 0x100000001b3;
  }
  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

struct Function {
  const char* name;
  double (*ours)(double);
  double (*library)(double);
  double low, high;
  std::uint64_t hash;  ///< of kValues results, with musl 1.2
};

const std::vector<Function> kFunctions{{"sin", base::sin, std::sin, -20, 20, 0x71235809e8a70c14},
                                       {"cos", base::cos, std::cos, -20, 20, 0xc4a0fcb3eea8286c},
                                       {"tan", base::tan, std::tan, -20, 20, 0xf5e7e124c88e7724},
                                       {"asin", base::asin, std::asin, -1, 1, 0xd68be6aeee0a4f9d},
                                       {"acos", base::acos, std::acos, -1, 1, 0xb4481e4af4c17585},
                                       {"atan", base::atan, std::atan, -50, 50, 0x624b194bccea33c4},
                                       {"exp", base::exp, std::exp, -20, 20, 0x2871baa6aa364154},
                                       {"exp2", base::exp2, std::exp2, -20, 20, 0x0740bb4fd9ebab2f},
                                       {"expm1", base::expm1, std::expm1, -5, 5, 0x05b5bac5f7f958cd},
                                       {"log", base::log, std::log, 1e-3, 1e4, 0x2ed77bf89fb3af49},
                                       {"log2", base::log2, std::log2, 1e-3, 1e4, 0xb73026ba5e6ef23b},
                                       {"log10", base::log10, std::log10, 1e-3, 1e4, 0xebed6694f71612df}};

/// Distance of two numbers in steps of the second's last bit.
double ulps(double a, double b) {
  return std::abs(a - b) /
         (std::nextafter(std::abs(b), std::numeric_limits<double>::infinity()) - std::abs(b));
}

/// The same bits wherever this test runs. A musl whose results differ changes last digits of programs: then these
/// numbers and the golden programs change together.
TEST(Elementary, TheSameBitsEverywhere) {
  for (const Function& function : kFunctions) {
    Random random(7);
    Bits bits;
    for (int i = 0; i < kValues; ++i) {
      const double x = random.between(function.low, function.high), y = function.ours(x);
      bits.add(y);
      ASSERT_LE(ulps(y, function.library(x)), 2) << function.name << " of " << x;
    }
    EXPECT_EQ(bits.hash(), function.hash) << function.name;
  }
}

TEST(Elementary, TheSameBitsEverywhereOfTwo) {
  Random random(8);
  Bits angles, powers;
  for (int i = 0; i < kValues; ++i) {
    const double y = random.between(-100, 100), x = random.between(-100, 100);
    angles.add(base::atan2(y, x));
    ASSERT_LE(ulps(base::atan2(y, x), std::atan2(y, x)), 2) << y << ", " << x;
    powers.add(base::pow(x + 101, y / 50));
    ASSERT_LE(ulps(base::pow(x + 101, y / 50), std::pow(x + 101, y / 50)), 2) << x + 101 << ", " << y / 50;
  }
  EXPECT_EQ(angles.hash(), 0x0b2c8fbc24e53082U);
  EXPECT_EQ(powers.hash(), 0x1cdb902e6132a755U);
}

/// What outlines along the axes and at 30, 45 and 60 degrees rely on.
TEST(Elementary, ExactWhereTheLibraryIs) {
  EXPECT_EQ(base::sin(0), 0);
  EXPECT_EQ(base::cos(0), 1);
  EXPECT_EQ(base::tan(0), 0);
  EXPECT_EQ(base::exp(0), 1);
  EXPECT_EQ(base::log(1), 0);
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const double angle = quarter * (kPi / 2);
    EXPECT_EQ(base::sin(angle), std::sin(angle)) << quarter;
    EXPECT_EQ(base::cos(angle), std::cos(angle)) << quarter;
  }
  for (int twelfth = -24; twelfth <= 24; ++twelfth) {
    const double angle = twelfth * kPi / 12;
    EXPECT_LE(ulps(base::sin(angle), std::sin(angle)), 1) << twelfth;
    EXPECT_LE(ulps(base::tan(angle), std::tan(angle)), 1) << twelfth;
  }
  for (const double sine : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    EXPECT_EQ(base::asin(sine), std::asin(sine)) << sine;
    EXPECT_EQ(base::acos(sine), std::acos(sine)) << sine;
    EXPECT_EQ(base::atan(2 * sine), std::atan(2 * sine)) << sine;
  }
}

TEST(Elementary, AnglesOfAxesAndDiagonalsAreExact) {
  for (const double y : {-3.0, -0.0, 0.0, 3.0}) {
    for (const double x : {-3.0, -0.0, 0.0, 3.0}) {
      EXPECT_EQ(base::atan2(y, x), std::atan2(y, x)) << y << ", " << x;
      EXPECT_EQ(std::signbit(base::atan2(y, x)), std::signbit(std::atan2(y, x))) << y << ", " << x;
    }
  }
}

TEST(Elementary, PowersOfTenAreExact) {
  for (int power = 0; power <= 22; ++power) {
    EXPECT_EQ(base::pow(10, power), std::pow(10, power)) << power;
    EXPECT_EQ(base::log10(std::pow(10, power)), power);
  }
}

TEST(Elementary, OutOfRangeAsTheLibrary) {
  EXPECT_TRUE(std::isnan(base::acos(1.5)));
  EXPECT_TRUE(std::isnan(base::asin(-1.5)));
  EXPECT_TRUE(std::isnan(base::log(-1)));
  EXPECT_EQ(base::log(0), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(base::exp(1000), std::numeric_limits<double>::infinity());
  EXPECT_EQ(base::exp(-1000), 0);
}

TEST(Elementary, LengthsAreExactAlongAnAxis) {
  Random random(9);
  for (int i = 0; i < kValues; ++i) {
    const double x = random.between(-1e4, 1e4), y = random.between(-1e4, 1e4);
    EXPECT_EQ(base::hypot(x, 0), std::abs(x));
    EXPECT_EQ(base::hypot(0, x), std::abs(x));
    EXPECT_LE(ulps(base::hypot(x, y), std::hypot(x, y)), 1);
  }
  EXPECT_EQ(base::hypot(3, 4), 5);
}

}  // namespace
}  // namespace clearcut
