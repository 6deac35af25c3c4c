// Elements typed on the command line mean what the same elements of a job file mean.
#include "read/outline/read_elements.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace clearcut::read {
namespace {

ElementDefaults with_tools() {
  ElementDefaults defaults;
  Tool tool;
  tool.number = 0;
  tool.diameter = 4;
  defaults.tools = {tool, tool};
  defaults.depth = 2;
  return defaults;
}

const char* const kJob = R"(
[stock]
x = [0, 60]
y = [0, 60]
z = [-5, 0]
[[tool]]
diameter = 4
[[tool]]
diameter = 4
[[element]]
kind = "line"
from = [5, 6]
to = [40, 6.5]
depth = 2
[[element]]
id = "bow"
kind = "arc"
from = [10, 20]
to = [30, 20]
radius = 12
direction = "cw"
depth = 1
stepdown = 0.5
[[element]]
kind = "rectangle"
base = [50, 50]
corner = "upper-right"
length = 20
width = 10
depth = 2
tool = 2
[[element]]
kind = "hole"
center = [12, 45]
diameter = 9
depth = 2
feed = 300
[[element]]
kind = "slot"
from = [5, 32]
to = [25, 34]
width = 7
depth = 2
)";

void expect_same(const DesignElement& a, const DesignElement& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.from, b.from);
  if (a.kind != ElementKind::kRectangle) {
    EXPECT_EQ(a.to, b.to);
  }
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_EQ(a.length, b.length);
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.base, b.base);
  EXPECT_EQ(a.tool, b.tool);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.stepdown, b.stepdown);
  EXPECT_EQ(a.cutting.feed.has_value(), b.cutting.feed.has_value());
}

TEST(ElementOptions, EqualTheJobFile) {
  const ElementJob file = read_elements_text(kJob, "job.toml");
  ElementDefaults defaults = with_tools();
  defaults.stock = "0,60,0,60,-5,0";
  const ElementJob typed = elements_of_options({{"line", "5,6,40,6.5"},
                                                {"arc", "10,20,30,20,12,cw:id=bow:depth=1:stepdown=0.5"},
                                                {"pocket", "50,50,20,10:corner=upper-right:T2"},
                                                {"hole", "12,45,9:feed=300"},
                                                {"slot", "5,32,25,34,7"}},
                                               defaults);
  EXPECT_EQ(typed.stock.plan.min, file.stock.plan.min);
  EXPECT_EQ(typed.stock.plan.max, file.stock.plan.max);
  EXPECT_DOUBLE_EQ(typed.stock.z_bottom, file.stock.z_bottom);
  ASSERT_EQ(typed.elements.size(), file.elements.size());
  for (std::size_t i = 0; i < file.elements.size(); ++i) {
    expect_same(typed.elements[i], file.elements[i]);
  }
  EXPECT_EQ(typed.tools[1].number, 2);
}

TEST(ElementOptions, StockOfTheirOwnHoldsThemOnWholeSquares) {
  ElementDefaults defaults = with_tools();
  defaults.resolution = 0.5;
  const ElementJob job = elements_of_options(
      {{"pocket", "10.2,10,20,8:corner=lower-right"}, {"hole", "40,5,6:depth=3"}}, defaults);
  EXPECT_DOUBLE_EQ(job.stock.plan.min.x, -14);  // -9.8 - 4
  EXPECT_DOUBLE_EQ(job.stock.plan.min.y, -2);
  EXPECT_DOUBLE_EQ(job.stock.plan.max.x, 47);
  EXPECT_DOUBLE_EQ(job.stock.plan.max.y, 22);
  EXPECT_DOUBLE_EQ(job.stock.z_bottom, -3);
  EXPECT_DOUBLE_EQ(job.stock.z_top, 0);
}

TEST(ElementOptions, StockOfTheirOwnHoldsRectanglesFromAnyCorner) {
  const std::pair<const char*, Vec2> corners[] = {{"5,5,20,10", {5, 5}},
                                                  {"25,5,20,10:corner=lower-right", {5, 5}},
                                                  {"5,15,20,10:corner=upper-left", {5, 5}},
                                                  {"25,15,20,10:corner=upper-right", {5, 5}}};
  for (const auto& [text, low] : corners) {
    const Box stock = elements_of_options({{"pocket", text}}, with_tools()).stock.plan;
    EXPECT_LE(stock.min.x, low.x) << text;
    EXPECT_LE(stock.min.y, low.y) << text;
    EXPECT_GE(stock.max.x, low.x + 20) << text;
    EXPECT_GE(stock.max.y, low.y + 10) << text;
  }
}

TEST(ElementOptions, BadOnesAreNamed) {
  const std::vector<ElementOption> bad{{"line", "1,2,3"},
                                       {"line", "1,2,3,x"},
                                       {"line", "1,2,3,nan"},
                                       {"arc", "0,0,5,0,5"},
                                       {"arc", "0,0,5,0,5,left"},
                                       {"hole", "1,2,3:corner=lower-left"},
                                       {"hole", "1,2,3:T0"},
                                       {"hole", "1,2,3:T1.5"},
                                       {"hole", "1,2,3:deep=3"},
                                       {"hole", "1,2,3:stepdown=0"},
                                       {"pocket", "1,2,3,4:corner=middle"},
                                       {"slot", ""},
                                       {"hole", "1,2,3:id="},
                                       {"hole", "1,2,3:"}};
  for (const auto& option : bad) {
    try {
      elements_of_options({option}, with_tools());
      ADD_FAILURE() << option.text;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find("--" + option.kind + " " + option.text + ": "), 0u)
          << error.what();
    }
  }
  ElementDefaults defaults = with_tools();
  defaults.depth.reset();
  EXPECT_THROW(elements_of_options({{"hole", "1,2,3"}}, defaults), InputError);
  for (const char* stock : {"1,2,3", "0,0,0,5,-1,0", "a,b,c,d,e,f"}) {
    defaults = with_tools();
    defaults.stock = stock;
    EXPECT_THROW(elements_of_options({{"hole", "1,2,3"}}, defaults), InputError) << stock;
  }
}

}  // namespace
}  // namespace clearcut::read
