// Random parts by every strategy, each plan in a process of its own: how many are certified clean, and the most time and memory
// that one took.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "base/error.h"
#include "pipeline/run.h"
#include "support/random/lattice_parts.h"
#include "support/random/random_parts.h"
#include "support/random/wide_parts.h"

namespace {

using namespace clearcut;

constexpr double kDiameter = 10;  // mm

struct Family {
  const char* name;
  Part (*part)(Random&, double diameter);
};

constexpr Family kFamilies[] = {{"exact", test_support::exact_fit_pocket},
                                {"arms", test_support::block_with_arms},
                                {"tips", test_support::room_with_tip},
                                {"wide", test_support::wide_part},
                                {"blobs", test_support::random_part}};
constexpr const char* kStrategies[] = {"auto", "contour", "zigzag", "spiral", "adaptive", "tour"};

enum Verdict { kClean, kLeftOut, kFaulty, kRefused, kDied };

/// What one plan came to, and what it took.
struct Run {
  Verdict verdict = kDied;
  double cpu_s = 0;
  double peak_mb = 0;
};

/// In the process that plans.
Verdict plan(const Part& part, const char* strategy, const std::string& name) {
  PlanOptions options;
  options.strategy = strategy;
  options.threads = 1;
  try {
    const auto result = pipeline::plan_part(part, options);
    if (result.findings.faults.empty()) return kClean;
    fmt::print("{}: {}\n", name, result.findings.faults.front().text);
    return kFaulty;
  } catch (const InputError& error) {
    const bool by_name = std::strstr(error.what(), "use another --strategy") != nullptr;
    fmt::print("{}: {}\n", name, error.what());
    return by_name ? kLeftOut : kRefused;
  }
}

Run run(const Family& family, const char* strategy, std::uint64_t seed) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    Random random(seed);
    const auto verdict =
        plan(family.part(random, kDiameter), strategy, fmt::format("{} {} {}", family.name, seed, strategy));
    std::fflush(stdout);
    _exit(verdict);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) * 1e-6;
  };
  return {WIFEXITED(status) ? static_cast<Verdict>(WEXITSTATUS(status)) : kDied,
          seconds(usage.ru_utime) + seconds(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1024};
}

/// One row of the table. Returns how many plans were neither clean nor left out by name.
int run_all(const Family& family, const char* strategy, std::uint64_t first, int count) {
  int verdicts[kDied + 1] = {};
  Run worst;
  double all_s = 0;
  std::uint64_t slowest = first, largest = first;
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
    const Run one = run(family, strategy, seed);
    ++verdicts[one.verdict];
    all_s += one.cpu_s;
    if (one.cpu_s > worst.cpu_s) slowest = seed;
    if (one.peak_mb > worst.peak_mb) largest = seed;
    worst.cpu_s = std::max(worst.cpu_s, one.cpu_s);
    worst.peak_mb = std::max(worst.peak_mb, one.peak_mb);
  }
  const int wrong = verdicts[kFaulty] + verdicts[kRefused] + verdicts[kDied];
  fmt::print("| {} | {} | {} | {} | {} | {:.2f} | {:.2f} (seed {}) | {:.0f} (seed {}) |\n", family.name,
             strategy, verdicts[kClean], verdicts[kLeftOut], wrong, all_s / count, worst.cpu_s, slowest,
             worst.peak_mb, largest);
  return wrong;
}

}  // namespace

/// random_parts_benchmark [FAMILY|all [STRATEGY|all [COUNT [FIRST_SEED]]]]
int main(int argc, char** argv) {
  const std::string family = argc > 1 ? argv[1] : "all", strategy = argc > 2 ? argv[2] : "all";
  const int count = argc > 3 ? std::atoi(argv[3]) : 1000;
  const auto first = static_cast<std::uint64_t>(argc > 4 ? std::atoll(argv[4]) : 1);
  if (count < 1) {
    fmt::print(stderr, "random_parts_benchmark [FAMILY|all [STRATEGY|all [COUNT [FIRST_SEED]]]]\n");
    return 2;
  }
  fmt::print(
      "| parts | strategy | clean | left out | wrong | mean CPU s | most CPU s | most MB "
      "|\n|---|---|---|---|---|---|---|---|\n");
  int wrong = 0;
  for (const Family& one : kFamilies) {
    for (const char* name : kStrategies) {
      if (family != "all" && family != one.name) continue;
      if (strategy != "all" && strategy != name) continue;
      wrong += run_all(one, name, first, count);
    }
  }
  return wrong == 0 ? 0 : 1;
}
