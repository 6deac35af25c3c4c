// The one-definition rule across all files: what two of them define under one name in one namespace, the linker may join,
// and where the two differ the program breaks far from both, or only in some builds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "base/file.h"
#include "support/sources/definitions.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::shared_definitions;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(OneDefinition, TypesAreFoundWithTheirNamespaces) {
  EXPECT_THAT(
      shared_definitions("namespace a::inline b { struct S { int x; }; class T final : public S {}; }"),
      ElementsAre("a::b::S", "a::b::T"));
  EXPECT_THAT(
      shared_definitions("namespace a { template <typename X> struct S {}; enum class E : int { k }; }"),
      ElementsAre("a::S", "a::E"));
  EXPECT_THAT(shared_definitions("namespace a { template <> struct S<int> {}; union U {}; }"),
              ElementsAre("a::S<int>", "a::U"));
  EXPECT_THAT(
      shared_definitions("namespace a { using S = int; template <class T> using V = X<T>; using b::c; }"),
      ElementsAre("a::S =", "a::V ="));
  EXPECT_THAT(shared_definitions("namespace a { namespace { using S = int; } struct T { using U = int; }; }"),
              ElementsAre("a::T"));
}

TEST(OneDefinition, FunctionsAreFoundWithTheirParameters) {
  EXPECT_THAT(shared_definitions("namespace a { inline int f(int x) { return x; } void T::g() const {} }"),
              ElementsAre("a::f(int x)", "a::T::g()"));
  EXPECT_THAT(shared_definitions("namespace a { void f(S s = {}); auto v = g(1); }"), IsEmpty());
  EXPECT_THAT(shared_definitions("namespace a { bool operator==(const S& s, const S& t) { return true; } }"),
              ElementsAre("a::operator==(const S & s , const S & t)"));
}

TEST(OneDefinition, WhatBelongsToOneFileIsLeftOut) {
  EXPECT_THAT(shared_definitions("namespace a { namespace { struct S {}; int f() { return 1; } } }"),
              IsEmpty());
  EXPECT_THAT(shared_definitions("namespace a { static int f() { struct L {}; return 1; } }"), IsEmpty());
  EXPECT_THAT(shared_definitions("namespace a { struct S; void f(int); struct S g(); TEST(A, B) {} }"),
              IsEmpty());
  EXPECT_THAT(shared_definitions("namespace a { class S { struct In {}; void f() {} }; }"),
              ElementsAre("a::S"));
}

TEST(OneDefinition, WhatLooksLikeADefinitionInTextIsNone) {
  EXPECT_THAT(
      shared_definitions("// struct A {};\n/* struct B {}; */\n#define C \\\n struct D {};\n"
                         "const char* k = \"struct E {\"; const auto m = R\"x(struct F {)x\"; char c = '{';"
                         "int n = 1'000; struct G {};"),
      ElementsAre("G"));
}

bool is_source(const fs::path& file) {
  return file.extension() == ".h" || file.extension() == ".cpp";
}

/// Calls `visit` with everything that can come together in one program. Files of tests have programs of their own, and of NAME.cpp
/// and NAME_windows.cpp a program has one.
void for_sources(const fs::path& root, const std::function<void(const fs::path&)>& visit) {
  for (const char* folder : {"src", "studies", "include"}) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const fs::path& file = entry.path();
      const std::string stem = file.stem().string();
      if (!is_source(file) || stem.ends_with("_test") || stem.ends_with("_windows")) continue;
      visit(file);
    }
  }
}

std::map<std::string, std::set<std::string>> files_by_definition(const fs::path& root) {
  std::map<std::string, std::set<std::string>> files;
  for_sources(root, [&](const fs::path& file) {
    for (const auto& name : shared_definitions(read_file(file.string())))
      files[name].insert(fs::relative(file, root).string());
  });
  return files;
}

// The builds for pages and Windows compile several sources as one: an alias beyond its own file meets others of its name there.
TEST(OneDefinition, AliasesOfSourcesStandInNamespacesWithoutName) {
  for_sources(CLEARCUT_SOURCE_DIR, [](const fs::path& file) {
    if (file.extension() != ".cpp") return;
    for (const auto& name : shared_definitions(read_file(file.string())))
      EXPECT_FALSE(name.ends_with(" =")) << name << " in " << file;
  });
}

TEST(OneDefinition, NoNameIsDefinedInTwoFiles) {
  const auto files = files_by_definition(CLEARCUT_SOURCE_DIR);
  EXPECT_GT(files.size(), 1000U);
  for (const auto& [name, places] : files)
    EXPECT_EQ(places.size(), 1U) << name << " is defined in " << testing::PrintToString(places);
}

}  // namespace
}  // namespace clearcut
