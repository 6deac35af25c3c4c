#include "options/row.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "base/error.h"

namespace clearcut::inline options {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& option, const std::string& text) {
  try {
    value_of_text(*row_named(option), text, "--" + option);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Rows, HaveNamesOfTheirOwnAndSentences) {
  std::set<std::string> names;
  for (const Row& row : rows()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.sentence.empty()) << row.name;
    EXPECT_TRUE(row.field.set && row.field.get && row.field.clear) << row.name;
    EXPECT_NE(row.effect.inputs, 0U) << row.name;
  }
  EXPECT_GT(names.size(), 90U);
}

TEST(Rows, KeysOfAJobsTableAreUnique) {
  std::set<std::pair<JobTable, std::string>> keys;
  for (const Row& row : rows()) {
    if (row.table != JobTable::kNone) {
      EXPECT_TRUE(keys.insert({row.table, row.job_key()}).second) << row.name;
    }
  }
}

TEST(Rows, RefuseWithTheSameWordsWhateverIsWrong) {
  EXPECT_EQ(refusal("allowance", "-1"), "--allowance: must be 0 mm or more; it is -1");
  EXPECT_EQ(refusal("feed", "0"), "--feed: must be above 0 mm/min; it is 0");
  EXPECT_EQ(refusal("entry-angle", "90"), "--entry-angle: must be above 0 and at most 89 degrees; it is 90");
  EXPECT_EQ(refusal("engagement", "5"), "--engagement: must lie between 10 and 180 degrees; it is 5");
  EXPECT_EQ(refusal("finish-depths", "1.5"), "--finish-depths: must be a whole number; it is 1.5");
  EXPECT_EQ(refusal("tab-width", "1e300"), "--tab-width: is farther from zero than 1000000 mm; it is 1e+300");
  EXPECT_THAT(refusal("direction", "clim"), HasSubstr("did you mean 'climb'?"));
  EXPECT_EQ(refusal("feed", "fast"), "--feed: 'fast' is not a feed; write 800, 800mm/min or 40in/min");
  EXPECT_EQ(refusal("start", "5"), "--start: '5' is not a point; write X,Y in mm");
  EXPECT_THAT(refusal("work-offset", "G12"), HasSubstr("use one of G54"));
  EXPECT_THAT(refusal("seed", "-3"), HasSubstr("is not a seed"));
}

TEST(Rows, WhatIsSetIsReadBack) {
  for (const Row& row : rows()) {
    if (takes_several(row.kind) || row.kind == ValueKind::kFlag) continue;
    const std::string text = row.kind == ValueKind::kPoint ? "1,2" : row.shown_example();
    Asked asked;
    const Value value = value_of_text(row, text, row.name);
    row.field.set(asked, value, row.names);
    const auto back = row.field.get(asked, row.names);
    ASSERT_TRUE(back) << row.name;
    if (const double* number = std::get_if<double>(&*back)) {
      EXPECT_NEAR(*number, std::get<double>(value), 1e-9) << row.name;
    } else {
      EXPECT_EQ(*back, value) << row.name;
    }
    row.field.clear(asked);
    if (row.group != Group::kPublishedSolver) {
      EXPECT_EQ(row.field.get(asked, row.names), row.field.get(Asked{}, row.names)) << row.name;
    }
  }
}

TEST(Rows, ACheckOfTextsReadsNoFileAndOnlyOutlines) {
  int of_texts = 0;
  for (const Row& row : rows()) {
    if (!(row.checks & kCheckOfTexts)) continue;
    ++of_texts;
    EXPECT_TRUE(row.checks & kCheckOfPart) << row.name;
    EXPECT_TRUE(row.effect.inputs & kOutlineInput) << row.name;
    EXPECT_FALSE(row.kind == ValueKind::kFile || row.kind == ValueKind::kFiles) << row.name;
  }
  EXPECT_GT(of_texts, 20);
}

TEST(Rows, ValuesInTheOptionsAreCheckedToo) {
  Asked asked;
  check_values(asked, "--");
  asked.plan.allowance = -1;
  EXPECT_THROW(check_values(asked, "--"), InputError);
  asked.plan.allowance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check_values(asked, "--"), InputError);
}

}  // namespace
}  // namespace clearcut::inline options
