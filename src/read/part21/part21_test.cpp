// The syntax of ISO 10303-21, clause by clause.
#include "read/part21/part21.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace clearcut::read {
namespace {

std::string file_with(const std::string& data) {
  return "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('TEST'));\nENDSEC;\nDATA;\n" + data +
         "ENDSEC;\nEND-ISO-10303-21;\n";
}

P21File parsed(const std::string& text) {
  return parse_part21(text, "t.p21");
}

std::string message_of(const std::string& text) {
  try {
    parsed(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<P21Value> arguments_of(const P21File& file, std::uint64_t id) {
  const P21Entity* entity = file.find(id);
  EXPECT_NE(entity, nullptr);
  const auto arguments = file.arguments(file.records_of(*entity)[0]);
  return {arguments.begin(), arguments.end()};
}

TEST(Part21, ReadsEveryKindOfParameter) {
  const P21File file =
      parsed(file_with("#1=E($,*,12,-3.5E2,'text',.CW.,#2,\"0A1F\",(1,2),LENGTH(7.));\n#2=F();\n"));
  const auto a = arguments_of(file, 1);
  ASSERT_EQ(a.size(), 10U);
  EXPECT_EQ(a[0].kind, P21Kind::kUnset);
  EXPECT_EQ(a[1].kind, P21Kind::kDerived);
  EXPECT_EQ(a[2].kind, P21Kind::kInteger);
  EXPECT_EQ(a[2].number, 12);
  EXPECT_EQ(a[3].kind, P21Kind::kReal);
  EXPECT_EQ(a[3].number, -350);
  EXPECT_EQ(a[4].kind, P21Kind::kString);
  EXPECT_EQ(a[4].text, "text");
  EXPECT_EQ(a[5].kind, P21Kind::kEnum);
  EXPECT_EQ(a[5].text, "CW");
  EXPECT_EQ(a[6].kind, P21Kind::kReference);
  EXPECT_EQ(a[6].id, 2U);
  EXPECT_EQ(a[7].kind, P21Kind::kBinary);
  EXPECT_EQ(a[7].text, "0A1F");
  ASSERT_EQ(a[8].kind, P21Kind::kList);
  EXPECT_EQ(file.children(a[8])[1].number, 2);
  ASSERT_EQ(a[9].kind, P21Kind::kTyped);
  EXPECT_EQ(a[9].text, "LENGTH");
  EXPECT_EQ(file.children(a[9])[0].number, 7);
}

TEST(Part21, NumbersWithAndWithoutDigitsAfterThePoint) {
  const P21File file = parsed(file_with("#1=E(5.,+5.0,5,.5,1.E-3,1E3);\n"));
  const auto a = arguments_of(file, 1);
  const double expected[] = {5, 5, 5, 0.5, 0.001, 1000};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(a[i].number, expected[i]) << i;
}

TEST(Part21, CommentsMayStandAnywhereEvenBeforeTheFirstLine) {
  const P21File file = parsed(
      "/* a\n comment with ' and #1=A(); */\nISO-10303-21;HEADER/**/;ENDSEC;DATA;/* x "
      "*/#1/*y*/=/*z*/A(/**/1/**/)/**/;ENDSEC;END-ISO-10303-21;");
  ASSERT_EQ(file.entities.size(), 1U);
  EXPECT_EQ(file.entities[0].line, 3);
}

TEST(Part21, LinesAreCountedThroughCommentsAndStrings) {
  const P21File file = parsed(file_with("/*\n\n*/#1=A('one\ntwo');\n#2=B();\n"));
  EXPECT_EQ(file.find(1)->line, 8);
  EXPECT_EQ(file.find(2)->line, 10);
}

TEST(Part21, IdsInAnyOrderWithGapsAndUpTo64Bits) {
  const P21File file = parsed(file_with("#18446744073709551615=A(#3);\n#3=B(#1);\n#1=C();\n"));
  EXPECT_NE(file.find(18446744073709551615ULL), nullptr);
  EXPECT_NE(file.find(3), nullptr);
  EXPECT_NE(file.find(1), nullptr);
  EXPECT_EQ(file.find(2), nullptr);
}

TEST(Part21, ComplexInstancesHoldSeveralRecords) {
  const P21File file = parsed(file_with("#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"));
  const auto records = file.records_of(*file.find(1));
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(records[2].keyword, "SI_UNIT");
  EXPECT_EQ(file.arguments(records[2])[0].text, "MILLI");
}

TEST(Part21, SeveralDataSectionsAndSectionsOfLaterEditions) {
  const P21File file = parsed(
      "ISO-10303-21;HEADER;FILE_SCHEMA(('a','B'));ENDSEC;ANCHOR;<x>=#1;ENDSEC;REFERENCE;#9=<http://"
      "y#z>;ENDSEC;"
      "DATA('first',('A'));#1=A();ENDSEC;DATA;#2=B();ENDSEC;END-ISO-10303-21;SIGNATURE;any thing ENDSEC;");
  EXPECT_EQ(file.entities.size(), 2U);
  EXPECT_EQ(file.schemas, (std::vector<std::string>{"A", "B"}));
}

TEST(Part21, StringsAreDecodedToUtf8) {
  EXPECT_EQ(p21_decoded("it''s"), "it's");
  EXPECT_EQ(p21_decoded("a\\\\b"), "a\\b");
  EXPECT_EQ(p21_decoded("\\X\\E9t\\X\\E9"), "\u00e9t\u00e9");
  EXPECT_EQ(p21_decoded("\\X2\\03C04E2D\\X0\\!"), "\u03c0\u4e2d!");
  EXPECT_EQ(p21_decoded("\\X2\\D83DDE00\\X0\\"), "\U0001F600");
  EXPECT_EQ(p21_decoded("\\X4\\0001F600\\X0\\"), "\U0001F600");
  EXPECT_EQ(p21_decoded("Fr\\S\\dse"), "Fr\u00e4se");
  EXPECT_EQ(p21_decoded("\\PE\\\\S\\0"), "\u0410");
  EXPECT_EQ(p21_decoded("Fr\xE4se"), "Fr\u00e4se") << "bytes that are not UTF-8 are ISO 8859-1";
  EXPECT_EQ(p21_decoded("Fr\u00e4se"), "Fr\u00e4se");
  EXPECT_EQ(p21_decoded("one\r\ntwo"), "onetwo") << "line ends are no part of a string";
}

TEST(Part21, BrokenEscapesStayAsWritten) {
  for (const char* text : {"\\X\\G1", "\\X2\\12\\X0\\", "\\X2\\0041", "\\", "\\S\\", "\\Q"})
    EXPECT_EQ(p21_decoded(text), text);
}

struct BadFile {
  const char* text;
  const char* message;
};

TEST(Part21, ErrorsSayWhereAndWhat) {
  const BadFile cases[] = {
      {"", "t.p21:1: a Part 21 file begins with ISO-10303-21;"},
      {"\n\nsolid cube", "t.p21:3: a Part 21 file begins with ISO-10303-21; but here is 'solid'"},
      {"ISO-10303-21;\nDATA;", "t.p21:2: the HEADER section comes first,"},
      {"ISO-10303-21;HEADER;ENDSEC;END-ISO-10303-21;", "t.p21:1: no DATA section"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A();\n", "t.p21:4: a section ends with ENDSEC;"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A();ENDSEC;\n",
       "t.p21:4: the file ends without END-ISO-10303-21; it was cut short"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A(1,,2);", "t.p21:3: expected a value, found ','"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A(1,);", "t.p21:3: expected a value, found ')'"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A(1 2);", "t.p21:3: expected ',' or ')', found '2'"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A(1)\n#2=B();",
       "t.p21:4: expected ';' after entity #1, found #2"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1 A();", "t.p21:3: expected '=' after #1"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A('x);", "t.p21:3: a string begins here and is never closed"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n/* #1=A();",
       "t.p21:3: a comment begins here and is never closed"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A(.T);",
       "t.p21:3: an enumeration begins here and is never closed"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A(\"0G\");",
       "t.p21:3: a binary value begins here and is never closed"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A(1.E999);", "t.p21:3: the number '1.E999' is out of range"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#99999999999999999999=A();",
       "t.p21:3: instance name #99999999999999999999 is too large"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=A(%);", "t.p21:3: a character (code 37) that has no meaning"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#1=();", "t.p21:3: complex instance #1 is empty"},
      {"ISO-10303-21;HEADER;ENDSEC;\nDATA;\n#7=A();\n\n#7=B();\nENDSEC;END-ISO-10303-21;",
       "t.p21:5: #7 was already defined on line 3"},
  };
  for (const BadFile& bad : cases)
    EXPECT_THAT(message_of(bad.text), testing::StartsWith(bad.message)) << bad.text;
}

TEST(Part21, EveryPrefixOfAFileIsRefusedInOneLine) {
  const std::string text =
      file_with("#1=E($,*,12,-3.5E2,'t''x',.CW.,#2,\"0A\",(1,(2)),L(7.));\n#2=(F()G(1));\n");
  const std::size_t whole = text.rfind(';');
  for (std::size_t length = 0; length < whole - 16; ++length) {
    const std::string message = message_of(text.substr(0, length));
    EXPECT_THAT(message, testing::StartsWith("t.p21:")) << length;
    EXPECT_EQ(message.find('\n'), std::string::npos) << length;
  }
}

TEST(Part21, DeepNestingCostsNoStack) {
  constexpr std::size_t kDepth = 1'000'000;
  const std::string deep = "#1=A(" + std::string(kDepth, '(') + std::string(kDepth, ')') + ");\n";
  const P21File file = parsed(file_with(deep));
  EXPECT_GE(file.values.size(), kDepth);
  EXPECT_THAT(message_of(file_with("#1=A(" + std::string(kDepth, '('))),
              testing::StartsWith("t.p21:6: expected '(' after ENDSEC"));
}

TEST(Part21, VeryManyEntitiesAreRead) {
  std::string data;
  for (int i = 400000; i > 0; --i) data += "#" + std::to_string(i) + "=CARTESIAN_POINT('',(1.5,2.5,3.5));\n";
  EXPECT_EQ(parsed(file_with(data)).entities.size(), 400000u);
}

}  // namespace
}  // namespace clearcut::read
