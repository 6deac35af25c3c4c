// `--mpi` under mpirun, shares under GNU parallel, and the job script under Slurm give the bytes of one process. Skipped, with the package to
// install, where a program is absent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "support/command.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::CommandResult;
using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::HasSubstr;

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool is_installed(const std::string& program) {
  return std::system(("PATH=$PATH:/usr/sbin command -v '" + program + "' > /dev/null 2>&1").c_str()) == 0;
}

/// The command's plug-in, where the build found MPI.
bool has_mpi() {
  return is_installed("mpirun") && fs::exists(fs::path(CLEARCUT_COMMAND).parent_path() / "clearcut-mpi.so");
}

class ManyMachines : public ::testing::Test {
 protected:
  /// In the scratch folder, by a shell; `clearcut` is the built one. Ends after two minutes.
  int shell(const std::string& script) const {
    const std::string file = folder_.file(
        "script.sh", "cd '" + folder_.path("") +
                         "'\nexport PATH=$(dirname '" CLEARCUT_COMMAND
                         "'):/usr/sbin:$PATH OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1\n" +
                         script + "\n");
    return WEXITSTATUS(std::system(
        ("timeout 120 bash '" + file + "' > '" + folder_.path("said") + "' 2>&1 < /dev/null").c_str()));
  }
  std::string said() const { return text_of(folder_.path("said")); }
  std::string text(const std::string& name) const { return text_of(folder_.path(name)); }

  void write_parts() const {
    for (const int side : {20, 25, 30, 35, 40}) {
      const std::string s = std::to_string(side);
      fs::create_directories(folder_.path("parts"));
      folder_.file("parts/" + s + ".json",
                   R"({"name": "square", "units": "mm", "top": 0, "depth": 1, "outer": [[0, 0], [)" + s +
                       ", 0], [" + s + ", " + s + "], [0, " + s + "]]}");
    }
    folder_.file("parts/bad.json", "{\"outer\": 3}");
  }
  /// Programs, certificates and tables, by name.
  std::map<std::string, std::string> results(const std::string& folder) const {
    std::map<std::string, std::string> texts;
    for (const auto& entry : fs::directory_iterator(folder_.path(folder))) {
      const std::string name = entry.path().filename().string();
      if (!name.ends_with(".log") && entry.is_regular_file()) texts[name] = text_of(entry.path().string());
    }
    return texts;
  }
  void expect_the_same_batch() const {
    const auto one = results("one"),
               many = results("out");  // each was `out` when it was written: certificates name files
    ASSERT_GE(one.size(), 3 * 5U);
    EXPECT_EQ(one, many) << said();
  }

  ScratchFolder folder_;
};

constexpr const char* kBatch = "clearcut batch parts --tool endmill:6 --strategy zigzag ";
constexpr const char* kStudy = "clearcut study selection --side 5 --generations 50 --quiet ";

std::string batch(const std::string& options) {
  return kBatch + options;
}
std::string study(const std::string& options) {
  return kStudy + options;
}

TEST_F(ManyMachines, StudyUnderMpirunGivesTheBytesOfOneProcess) {
  if (!has_mpi()) GTEST_SKIP() << "needs libopenmpi-dev and openmpi-bin";
  shell(study("--runs 40 -o serial.csv"));
  ASSERT_GT(text("serial.csv").size(), 10000U) << said();
  for (const char* ranks : {"1", "3"}) {
    EXPECT_EQ(shell(std::string("mpirun --oversubscribe -n ") + ranks + " " +
                    study("--runs 40 -o many.csv --mpi --threads 2")),
              0)
        << said();
    EXPECT_EQ(text("many.csv"), text("serial.csv"));
    fs::remove(folder_.path("many.csv"));
  }
  EXPECT_EQ(shell(study("--runs 40 -o alone.csv --mpi")), 0) << said();  // without mpirun
  EXPECT_EQ(text("alone.csv"), text("serial.csv"));
}

/// Kills one rank when some runs are done.
std::string killed(const std::string& mpirun, int rank) {
  return mpirun + " -n 2 --oversubscribe bash -c 'echo $$ > pid.$OMPI_COMM_WORLD_RANK; exec " +
         study("--runs 150 -o many.csv --mpi") + "' & job=$!\n" +
         "until [ $(grep -c ,50, many.csv) -gt 100 ] || ! kill -0 $job; do sleep 0.1; done 2> /dev/null\n" +
         "kill -9 $(cat pid." + std::to_string(rank) + ")\nwait $job";
}

TEST_F(ManyMachines, ARankThatDiesLosesNoFinishedRun) {
  if (!has_mpi()) GTEST_SKIP() << "needs libopenmpi-dev and openmpi-bin";
  shell(study("--runs 150 -o serial.csv"));
  for (const int rank : {0, 1}) {
    shell(killed("mpirun --enable-recovery", rank));
    EXPECT_THAT(said(), HasSubstr("rank " + std::to_string(rank) + " has not been heard of"));
    EXPECT_EQ(text("many.csv"), text("serial.csv")) << rank;
    fs::remove(folder_.path("many.csv"));
  }
}

/// Without --enable-recovery mpirun ends all; what was finished is in the file, and the same command goes on.
TEST_F(ManyMachines, AStudyThatWasKilledGoesOn) {
  if (!has_mpi()) GTEST_SKIP() << "needs libopenmpi-dev and openmpi-bin";
  shell(study("--runs 150 -o serial.csv"));
  EXPECT_NE(shell(killed("mpirun", 1)), 0);
  const std::string before = text("many.csv");
  EXPECT_GT(before.size(), 10000U);
  EXPECT_LT(before.size(), text("serial.csv").size());
  EXPECT_EQ(shell("mpirun --oversubscribe -n 2 " + study("--runs 150 -o many.csv --mpi")), 0) << said();
  EXPECT_EQ(text("many.csv"), text("serial.csv"));
}

/// Four populations in each run, whose best move now and then.
std::string islands(const std::string& options) {
  return "clearcut study selection --islands 4 --side 15 --runs 2 --quiet " + options;
}

TEST_F(ManyMachines, IslandsUnderMpirunGiveTheBytesOfOneProcess) {
  if (!has_mpi()) GTEST_SKIP() << "needs libopenmpi-dev and openmpi-bin";
  shell(islands("--generations 100 --migrate-every 30 -o serial.csv"));
  ASSERT_GT(text("serial.csv").size(), 10000U) << said();
  for (const char* ranks : {"1", "3"}) {
    EXPECT_EQ(shell(std::string("mpirun --oversubscribe -n ") + ranks + " " +
                    islands("--generations 100 --migrate-every 30 -o many.csv --mpi --threads 2")),
              0)
        << said();
    EXPECT_EQ(text("many.csv"), text("serial.csv"));
    EXPECT_FALSE(fs::exists(folder_.path("many.csv.islands")));
    fs::remove(folder_.path("many.csv"));
  }
}

/// Kills one rank in the middle of a run: some of its islands' states are there.
std::string killed_between_islands(const std::string& mpirun, int rank) {
  return mpirun + " -n 2 --oversubscribe bash -c 'echo $$ > pid.$OMPI_COMM_WORLD_RANK; exec " +
         islands("--generations 1500 -o many.csv --mpi") + "' & job=$!\n" +
         "until ls many.csv.islands/*.[5-9] || ! kill -0 $job; do sleep 0.02; done > /dev/null 2>&1\n" +
         "kill -9 $(cat pid." + std::to_string(rank) + ")\nwait $job";
}

TEST_F(ManyMachines, ARankThatDiesLosesNoFinishedEpoch) {
  if (!has_mpi()) GTEST_SKIP() << "needs libopenmpi-dev and openmpi-bin";
  shell(islands("--generations 1500 -o serial.csv"));
  for (const int rank : {0, 1}) {
    shell(killed_between_islands("mpirun --enable-recovery", rank));
    EXPECT_THAT(said(), HasSubstr("rank " + std::to_string(rank) + " has not been heard of"));
    EXPECT_EQ(text("many.csv"), text("serial.csv")) << rank;
    fs::remove(folder_.path("many.csv"));
  }
}

TEST_F(ManyMachines, IslandsThatWereKilledGoOn) {
  if (!has_mpi()) GTEST_SKIP() << "needs libopenmpi-dev and openmpi-bin";
  shell(islands("--generations 1500 -o serial.csv"));
  EXPECT_NE(shell(killed_between_islands("mpirun", 1)), 0);
  EXPECT_TRUE(fs::exists(folder_.path("many.csv.islands"))) << said();
  shell("touch many.csv.islands/0.0.0.9.1.tmp");  // as of a process that is killed while it writes
  EXPECT_EQ(shell("mpirun --oversubscribe -n 2 " + islands("--generations 500 -o many.csv --mpi")), 2);
  EXPECT_THAT(said(), HasSubstr("from another study or other settings"));
  EXPECT_EQ(shell("mpirun --oversubscribe -n 2 " + islands("--generations 1500 -o many.csv --mpi")), 0)
      << said();
  EXPECT_EQ(text("many.csv"), text("serial.csv"));
  EXPECT_FALSE(fs::exists(folder_.path("many.csv.islands")));
}

TEST_F(ManyMachines, BatchUnderMpirun) {
  if (!has_mpi()) GTEST_SKIP() << "needs libopenmpi-dev and openmpi-bin";
  write_parts();
  shell(batch("--output out") + "\nmv out one");
  EXPECT_EQ(shell("mpirun --oversubscribe -n 3 " + batch("--output out --mpi")), 1);  // one part is unusable
  EXPECT_THAT(said(), HasSubstr("5 of 6 CLEAN, 1 UNUSABLE\n"));
  expect_the_same_batch();
  shell("mpirun --oversubscribe -n 2 " + batch("--output out --mpi"));
  EXPECT_THAT(said(), HasSubstr("(6 as they were)"));
  expect_the_same_batch();
}

TEST_F(ManyMachines, WhatMpiCannotDoIsRefused) {
  const CommandResult no_file = run_clearcut({"study", "spread", "--mpi"});
  EXPECT_EQ(no_file.exit_code, 2);
  EXPECT_THAT(no_file.err, HasSubstr("add --output FILE"));
  write_parts();
  const CommandResult twice = run_clearcut(
      {"batch", folder_.path("parts"), "--output", folder_.path("out"), "--mpi", "--share", "1/2"});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_THAT(twice.err, HasSubstr("give one of them"));
  // The command with the program that it becomes, as where the plug-in is not installed.
  const fs::path built(CLEARCUT_COMMAND);
  for (const char* name : {"clearcut", "clearcut-studies"})
    fs::copy_file(built.parent_path() / name, folder_.path(name));
  EXPECT_EQ(shell("./clearcut study spread --mpi -o rows.csv"), 2);
  EXPECT_THAT(said(), HasSubstr("this installation has no MPI; install the package clearcut-mpi"));
  EXPECT_FALSE(fs::exists(folder_.path("rows.csv")));
}

TEST_F(ManyMachines, SharesUnderGnuParallel) {
  if (!is_installed("parallel")) GTEST_SKIP() << "needs parallel";
  write_parts();
  shell(batch("--output out") + "\nmv out one");
  shell("parallel -j 2 " + batch("--output out --jobs 1 --share {}/4") + " ::: 1 2 3 4\n" +
        batch("--output out"));
  EXPECT_THAT(said(), HasSubstr("5 of 6 CLEAN, 1 UNUSABLE (6 as they were)"));
  expect_the_same_batch();
}

/// Slurm's own programs on this machine alone, in a folder of their own.
TEST_F(ManyMachines, JobScriptsUnderSlurm) {
  for (const char* program : {"slurmctld", "slurmd", "sbatch", "munged"}) {
    if (!is_installed(program)) GTEST_SKIP() << "needs slurmctld, slurmd, slurm-client and munge";
  }
  write_parts();
  shell(batch("--output out") + "\nmv out one");
  const std::string scripts = CLEARCUT_SOURCE_DIR "/scripts/";
  folder_.file("jobs.sh",
               "sbatch --wait --cpus-per-task=1 --array=1-3 " + scripts +
                   "batch_array.sbatch parts out --tool endmill:6 " +
                   "--strategy zigzag || true  # one part is unusable\n" + batch("--output out || true\n") +
                   (has_mpi() ? study("--runs 20 -o serial.csv\n") + "srun -n 2 --mpi=pmix " +
                                    study("--runs 20 -o srun.csv --mpi\n") + "salloc -Q -n 2 mpirun " +
                                    study("--runs 20 -o salloc.csv --mpi\n") +
                                    "cmp serial.csv srun.csv; cmp serial.csv salloc.csv\n"
                              : ""));
  const int code = shell("CLEARCUT=" CLEARCUT_COMMAND " " + scripts + "one_node_slurm.sh '" +
                         folder_.path("slurm") + "' bash -e jobs.sh");
  if (code == 77) GTEST_SKIP() << said();
  EXPECT_EQ(code, 0) << said();
  EXPECT_THAT(said(), HasSubstr("5 of 6 CLEAN, 1 UNUSABLE (6 as they were)"));
  expect_the_same_batch();
}

}  // namespace
}  // namespace clearcut
