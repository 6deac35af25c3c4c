// Work on several ranks: each task's result once, whoever dies. The ranks are threads here, the messages queues.
#include "ranks/distribute.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <mutex>
#include <thread>

#include "base/error.h"

namespace clearcut::ranks {
namespace {

using ::testing::HasSubstr;

/// What is under way between the ranks, what is done already, and who is dead.
struct Job {
  explicit Job(int ranks)
      : queues(static_cast<std::size_t>(ranks)), is_dead(static_cast<std::size_t>(ranks)) {}

  std::mutex mutex;
  std::vector<std::deque<Message>> queues;
  std::vector<std::atomic<bool>> is_dead;
  std::map<std::string, std::string> file;  ///< results, as they would be appended to a file
  int repeated = 0;                         ///< results told more than once
  std::string said;
};

struct Died {};

class ThreadRank : public Ranks {
 public:
  ThreadRank(Job& job, int number) : job_(job), number_(number) {}
  int number() const override { return number_; }
  int count() const override { return static_cast<int>(job_.queues.size()); }
  int here() const override { return count(); }
  void send(int to, const std::string& text) override {
    die_where_told();
    const std::lock_guard lock(job_.mutex);
    job_.queues[static_cast<std::size_t>(to)].push_back({number_, text});
  }
  std::optional<Message> receive() override {
    die_where_told();
    const std::lock_guard lock(job_.mutex);
    auto& queue = job_.queues[static_cast<std::size_t>(number_)];
    if (queue.empty()) return std::nullopt;
    Message message = std::move(queue.front());
    queue.pop_front();
    return message;
  }
  void leave(double /*seconds*/, int /*exit_code*/) override {}

 private:
  void die_where_told() const {
    if (job_.is_dead[static_cast<std::size_t>(number_)]) throw Died();
  }
  Job& job_;
  int number_;
};

std::vector<std::string> numbers(int count) {
  std::vector<std::string> all;
  for (int i = 0; i < count; ++i) all.push_back(std::to_string(i));
  return all;
}

constexpr Timing kShort{.pause = 0.0005, .beat = 0.02, .silence = 1.5, .first = 3};

/// The numbers below `count`, each with "!" for its result; `perform` may do more.
Work work_of(Job& job, int count, int rank, const std::function<void(int rank, int task)>& perform) {
  Work work;
  work.tasks = [&job, count] {
    const std::lock_guard lock(job.mutex);
    auto left = numbers(count);
    std::erase_if(left, [&job](const std::string& task) { return job.file.contains(task); });
    return left;
  };
  work.perform = [rank, perform](const std::string& task, const std::string&, const std::atomic<bool>&) {
    perform(rank, std::stoi(task));
    return task + "!";
  };
  work.finished = [&job](const std::string& task, const std::string& result) {
    const std::lock_guard lock(job.mutex);
    if (!job.file.emplace(task, result).second) ++job.repeated;
  };
  work.say = [&job](const std::string& text) {
    const std::lock_guard lock(job.mutex);
    job.said += text + "\n";
  };
  return work;
}

/// Runs all ranks; gives the number of the rank that handed out at the end, and the tasks thrown for, if any.
int lead_of(Job& job, int count, const std::function<void(int rank, int task)>& perform,
            std::vector<std::string>* errors = nullptr) {
  std::atomic<int> lead = -1;
  std::mutex mutex;
  {
    std::vector<std::jthread> threads;
    for (int rank = 0; rank < static_cast<int>(job.queues.size()); ++rank) {
      threads.emplace_back([&, rank] {
        ThreadRank self(job, rank);
        try {
          if (distribute(self, work_of(job, count, rank, perform), kShort).leads) lead = rank;
        } catch (const Died&) {
        } catch (const InputError& error) {
          const std::lock_guard lock(mutex);
          if (errors != nullptr) errors->push_back(error.what());
        }
      });
    }
  }
  return lead;
}

void expect_all_done(const Job& job, int count) {
  ASSERT_EQ(job.file.size(), static_cast<std::size_t>(count));
  for (const auto& [task, result] : job.file) EXPECT_EQ(result, task + "!");
  EXPECT_EQ(job.repeated, 0);
}

TEST(Distribute, EveryTaskIsDoneOnceOnAnyNumberOfRanks) {
  for (const int ranks : {1, 2, 5}) {
    Job job(ranks);
    EXPECT_EQ(lead_of(job, 300, [](int, int) {}), 0);
    expect_all_done(job, 300);
    EXPECT_EQ(job.said, "");
  }
}

TEST(Distribute, NothingToDoIsDoneAtOnce) {
  Job job(3);
  EXPECT_EQ(lead_of(job, 0, [](int, int) {}), 0);
}

TEST(Distribute, AllRanksWork) {
  Job job(3);
  std::array<std::atomic<int>, 3> done{};
  lead_of(job, 60, [&](int rank, int) {
    ++done[static_cast<std::size_t>(rank)];
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  });
  for (const auto& count : done) EXPECT_GT(count, 0);
}

TEST(Distribute, OthersDoTheWorkOfOneThatDies) {
  Job job(3);
  EXPECT_EQ(lead_of(job, 100,
                    [&](int rank, int) {
                      if (rank == 2) job.is_dead[2] = true;  // with this task in hand
                      std::this_thread::sleep_for(std::chrono::milliseconds(1));
                    }),
            0);
  expect_all_done(job, 100);
  EXPECT_THAT(job.said, HasSubstr("rank 2 has not been heard of for 1.5 s; others do its work"));
}

TEST(Distribute, TheNextTakesThePlaceOfRankZero) {
  Job job(3);
  EXPECT_EQ(lead_of(job, 100,
                    [&](int rank, int task) {
                      if (rank == 0 && task > 30) job.is_dead[0] = true;
                      std::this_thread::sleep_for(std::chrono::milliseconds(2));
                    }),
            1);
  expect_all_done(job, 100);
  EXPECT_THAT(job.said, HasSubstr("rank 1 takes its place"));
}

TEST(Distribute, TheLastOneFinishesAlone) {
  Job job(4);
  EXPECT_EQ(lead_of(job, 120,
                    [&](int rank, int task) {
                      if (rank < 3 && task > 20 * (rank + 1))
                        job.is_dead[static_cast<std::size_t>(rank)] = true;
                      std::this_thread::sleep_for(std::chrono::milliseconds(2));
                    }),
            3);
  expect_all_done(job, 120);
}

TEST(Distribute, WhatATaskThrowsEndsAll) {
  for (const int at : {0, 1}) {
    Job job(2);
    std::vector<std::string> errors;
    EXPECT_EQ(lead_of(
                  job, 1000,
                  [&](int rank, int task) {
                    if (rank == at && task > 10) throw InputError("part.dxf", "is odd");
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                  },
                  &errors),
              -1);
    EXPECT_THAT(errors, ::testing::ElementsAre("part.dxf: is odd"));
    EXPECT_LT(job.file.size(), 1000U);
  }
}

/// Chains of tasks: each but the first of a chain can be done only when the one before is, and rests on its result.
Work chains(Job& job, int rank, int count, int length,
            const std::function<void(int rank, int task)>& perform) {
  constexpr int kStep = 1000;  // task kStep * i + chain is the i-th of its chain
  Work work = work_of(job, 0, rank, perform);
  const auto is_done = [&job](int task) { return job.file.contains(std::to_string(task)); };
  work.tasks = [&job, count, length, is_done] {
    const std::lock_guard lock(job.mutex);
    std::vector<std::string> tasks;
    for (int chain = 0; chain < count; ++chain) {
      int link = 0;
      while (link < length && is_done(kStep * link + chain)) ++link;
      if (link < length) tasks.push_back(std::to_string(kStep * link + chain));
    }
    return tasks;
  };
  work.input = [&job](const std::string& task) {
    const std::lock_guard lock(job.mutex);
    const int number = std::stoi(task);
    return number < kStep ? "" : job.file.at(std::to_string(number - kStep));
  };
  work.perform = [rank, perform](const std::string& task, const std::string& input,
                                 const std::atomic<bool>&) {
    perform(rank, std::stoi(task));
    return input + task + " ";
  };
  work.next = [length](const std::string& task) {
    const int number = std::stoi(task) + kStep;
    return number < kStep * length ? std::vector<std::string>{std::to_string(number)}
                                   : std::vector<std::string>{};
  };
  return work;
}

void run_chains(Job& job, int count, int length, const std::function<void(int rank, int task)>& perform) {
  std::vector<std::jthread> threads;
  for (int rank = 0; rank < static_cast<int>(job.queues.size()); ++rank) {
    threads.emplace_back([&job, &perform, rank, count, length] {
      ThreadRank self(job, rank);
      try {
        distribute(self, chains(job, rank, count, length, perform), kShort);
      } catch (const Died&) {
      }
    });
  }
}

void expect_whole_chains(const Job& job, int count, int length) {
  ASSERT_EQ(job.file.size(), static_cast<std::size_t>(count * length));
  EXPECT_EQ(job.file.at("2001"), "1 1001 2001 ");
  EXPECT_EQ(job.repeated, 0);
}

TEST(Distribute, WhatCanBeDoneOnlyLaterIsDoneThen) {
  for (const int ranks : {1, 2, 5}) {
    Job job(ranks);
    run_chains(job, 3, 40, [](int, int) {});
    expect_whole_chains(job, 3, 40);
    EXPECT_EQ(job.said, "");
  }
}

/// Fewer tasks than ranks at any time: one that has nothing to do is not left without until it asks again.
TEST(Distribute, ARankIsGivenWhatComesUp) {
  Job job(3);
  std::array<std::atomic<int>, 3> done{};
  const auto began = std::chrono::steady_clock::now();
  run_chains(job, 2, 50, [&](int rank, int) {
    ++done[static_cast<std::size_t>(rank)];
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  });
  expect_whole_chains(job, 2, 50);
  EXPECT_GT(done[1] + done[2], 20);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(2));
}

TEST(Distribute, ChainsGoOnWhoeverDies) {
  for (const int dies : {0, 2}) {
    Job job(3);
    run_chains(job, 4, 30, [&](int rank, int task) {
      if (rank == dies && task > 10000) job.is_dead[static_cast<std::size_t>(dies)] = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    });
    expect_whole_chains(job, 4, 30);
  }
}

TEST(Distribute, TextsTravelWhole) {
  const std::vector<std::string> texts{"", "a", "12:b", std::string("\0\n\xff", 3)};
  EXPECT_EQ(unpack(pack(texts)), texts);
  EXPECT_EQ(unpack(pack({})), std::vector<std::string>{});
  for (const char* wrong : {"x", "3:ab", ":", "-1:a", "99999999999999999999:a"})
    EXPECT_THROW(unpack(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace clearcut::ranks
