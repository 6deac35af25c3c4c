#include "terminal/progress_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace clearcut::cli {

std::optional<double> time_left(std::size_t done, std::size_t of, double spent_s) {
  if (done == 0 || of <= done) return std::nullopt;
  const double share = static_cast<double>(done) / static_cast<double>(of);
  return spent_s * (1 - share) / share;
}

std::string described(const Progress& at, double spent_s) {
  const auto left = time_left(at.done, at.most, spent_s);
  if (at.stage == Stage::kCertifying) {
    const std::string text = "certifying the program";
    return left ? text + fmt::format(": {} % done, about {:.0f} s left", 100 * at.done / at.most, *left)
                : text;
  }
  const std::string text = fmt::format("planning: {} of at most {} candidates", at.done, at.most);
  return left ? text + fmt::format(", at most {:.0f} s left", *left) : text;
}

std::string json_of(const Progress& at, double spent_s) {
  std::string text =
      fmt::format(R"({{"progress":{{"stage":"{}","done":{},"most":{})",
                  at.stage == Stage::kCertifying ? "certifying" : "planning", at.done, at.most);
  if (const auto left = time_left(at.done, at.most, spent_s))
    text += fmt::format(R"(,"left_s":{:.0f})", *left);
  return text + "}}";
}

std::string described(const SearchProgress& at, double spent_s) {
  return fmt::format("searching: best {:.10g} found after {:.1f} s, at most {:.0f} s left", at.best,
                     at.found_s, std::max(0.0, at.most_s - spent_s));
}

std::string json_of(const SearchProgress& at, double spent_s) {
  return fmt::format(
      R"({{"progress":{{"stage":"searching","best":{:.10g},"found_s":{:.3f},"left_s":{:.0f}}}}})", at.best,
      at.found_s, std::max(0.0, at.most_s - spent_s));
}

std::optional<double> time_left(const CountProgress& at, double spent_s, double since_s) {
  constexpr std::size_t kTelling = 6;
  const std::size_t done = at.done - at.before, of = at.of - at.before;
  if (done * kTelling < of) return std::nullopt;
  const auto left = time_left(done, of, spent_s - since_s);
  if (!left || *left < since_s) return std::nullopt;
  return *left - since_s;
}

std::string described(const CountProgress& at, std::optional<double> left_s) {
  const std::string text = fmt::format("{} of {} {} done", at.done, at.of, at.things);
  return left_s ? text + fmt::format(", about {:.0f} s left", *left_s) : text;
}

std::string json_of(const CountProgress& at, std::optional<double> left_s) {
  std::string text = fmt::format(R"({{"progress":{{"stage":"counting","things":"{}","done":{},"most":{})",
                                 at.things, at.done, at.of);
  if (left_s) text += fmt::format(R"(,"left_s":{:.0f})", *left_s);
  return text + "}}";
}

}  // namespace clearcut::cli
