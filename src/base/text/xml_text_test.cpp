#include "base/text/xml_text.h"

#include <gtest/gtest.h>

namespace clearcut::inline base {
namespace {

TEST(XmlText, KeepsGoodUtf8AndReplacesTheRest) {
  EXPECT_EQ(xml_escaped("<a b=\"c\" & 'd'>"), "&lt;a b=&quot;c&quot; &amp; &#39;d&#39;&gt;");
  EXPECT_EQ(xml_escaped("gr\xc3\xbc\xc3\x9f \xe2\x82\xac \xf0\x9f\x94\xa7"),
            "gr\xc3\xbc\xc3\x9f \xe2\x82\xac \xf0\x9f\x94\xa7");
  EXPECT_EQ(xml_escaped(std::string_view("\x01\x00", 2)), "??");
  EXPECT_EQ(xml_escaped("\xff\xc3"), "??");
  EXPECT_EQ(xml_escaped("\xed\xa0\x80"), "???") << "a surrogate is no character";
  EXPECT_EQ(xml_escaped("\xc0\xaf"), "??") << "overlong";
}

}  // namespace
}  // namespace clearcut::inline base
