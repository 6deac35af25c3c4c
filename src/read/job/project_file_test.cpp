#include "read/job/project_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "read/job/job_file.h"

namespace clearcut::read {
namespace {

const char* const kSquare =
    R"({\"name\": \"square\", \"units\": \"mm\", \"outer\": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], \"islands\": [], \"top\": 0, \"depth\": 2})";

/// A project file with a part, a job on it and a tool library, and what is asked.
struct Project : testing::Test {
  ~Project() override { std::filesystem::remove(path); }
  void write(const std::string& plan) const {
    std::ofstream(path)
        << R"({"clearcut": "project", "version": 1, "files": [{"name": "square.json", "text": ")" << kSquare
        << R"("}, {"name": "square.toml", "text": "[part]\nfile = \"square.json\"\n"},
      {"name": "tools.toml", "text": ""}], "plan": )"
        << plan << "}";
  }
  std::string refusal() const {
    try {
      read_project(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  /// One for each process: tests run beside each other.
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("project_test_" + std::to_string(::getpid()) + ".clearcut.json"))
                               .string();
};

TEST_F(Project, SaysThePartAndItsOptions) {
  write(
      R"({"input": "square.json", "options": {"tool": ["endmill:6"], "rest": [], "tools": ["tools.toml"], "after": ["/else.ngc"]}})");
  const ProjectFile project = read_project(path);
  EXPECT_EQ(project.input, path + "/square.json");
  EXPECT_EQ(project.options.at("tool"), std::vector<std::string>{"endmill:6"});
  EXPECT_TRUE(project.options.at("rest").empty());
  EXPECT_EQ(project.options.at("tools"), std::vector<std::string>{path + "/tools.toml"});
  EXPECT_EQ(project.options.at("after"), std::vector<std::string>{"/else.ngc"});
}

TEST_F(Project, JobsInItFindTheirPart) {
  write(R"({"input": "square.toml"})");
  const Part part = part_of_job(read_job(read_project(path).input), {});
  ASSERT_EQ(part.features.size(), 1u);
  EXPECT_EQ(part.features[0].floor_z, -2);
}

TEST_F(Project, WhatMeansNothingIsRefused) {
  write(R"({"input": "other.json"})");
  EXPECT_NE(refusal().find("does not hold its part 'other.json'"), std::string::npos);
  write(R"({"input": "square.json", "options": {"no-such": ["1"]}})");
  EXPECT_NE(refusal().find("option 'no-such': is none"), std::string::npos) << refusal();
  write(R"({"input": "square.json", "options": {"rest": ["1"]}})");
  EXPECT_NE(refusal().find("takes no value"), std::string::npos) << refusal();
  write(R"({"input": "square.json", "options": {"stepdown": 3}})");
  EXPECT_NE(refusal().find("must be a list of texts"), std::string::npos) << refusal();
  write(R"({})");
  EXPECT_NE(refusal().find("names no part"), std::string::npos) << refusal();
  std::ofstream(path) << "{}";
  EXPECT_NE(refusal().find("is no project file"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace clearcut::read
