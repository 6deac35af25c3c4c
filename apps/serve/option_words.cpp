#include "serve/option_words.h"

#include <clearcut/error.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>

namespace clearcut::serve {
namespace {

constexpr std::size_t kMostWords = 500;
constexpr std::size_t kLongestLine = 2000;

const KnownOption& option_named(const std::string& name, const std::vector<KnownOption>& options) {
  for (const KnownOption& option : options) {
    if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return option;
  }
  throw InputError("options", "'" + name + "' is no option; GET /options lists those there are");
}

/// Without a number of parts behind a colon.
std::string file_in(const std::string& value) {
  const auto colon = value.rfind(':');
  const bool has_number = colon != std::string::npos && colon + 1 < value.size() &&
                          value.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  return has_number ? value.substr(0, colon) : value;
}

void check_file(const std::string& option, const std::string& value, const std::set<std::string>& files) {
  if (!files.contains(value) && !files.contains(file_in(value)))
    throw InputError(option, "'" + value + "' was not sent; send that file with the request");
}

/// Takes the words of one option from `at` on, and moves `at` behind them.
void take_option(const std::vector<std::string>& words, std::size_t& at,
                 const std::vector<KnownOption>& options, const std::set<std::string>& files,
                 std::vector<std::string>& out) {
  const std::string& word = words[at++];
  const auto equals = word.find('=');
  const std::string name = word.substr(0, equals);
  const KnownOption& option = option_named(name, options);
  if (option.is_refused) throw InputError(name, "is not for the server, which gives every result");
  std::vector<std::string> values;
  if (equals != std::string::npos) values.push_back(word.substr(equals + 1));
  const auto more = [&] { return at < words.size() && !words[at].starts_with("--"); };
  if (option.takes_value && values.empty() && more()) values.push_back(words[at++]);
  while (option.takes_many && more()) values.push_back(words[at++]);
  if (option.takes_value == values.empty())
    throw InputError(name, option.takes_value ? "needs a value" : "takes no value");
  if (!option.takes_value) out.push_back(name);
  for (const std::string& value : values) {
    if (option.is_file) check_file(name, value, files);
    out.push_back(name + "=" + value);
  }
}

}  // namespace

std::vector<KnownOption> known_options(std::string_view text, const std::string& command) {
  std::vector<KnownOption> out;
  try {
    const auto json = nlohmann::json::parse(text);
    for (const auto& one : json.at(command)) {
      KnownOption option;
      one.at("names").get_to(option.names);
      option.takes_value = !one.at("value").get<std::string>().empty();
      option.takes_many = one.at("many").get<bool>();
      option.is_file = one.at("file").get<bool>();
      const auto group = one.at("group").get<std::string>();
      option.is_refused = group == "Output" || group == "Help" || one.at("positional").get<bool>() ||
                          option.names.front() == "--part";
      out.push_back(option);
    }
  } catch (const nlohmann::json::exception&) {
    throw InputError("clearcut", "does not say its options; install clearcut and clearcut-serve together");
  }
  return out;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  std::optional<std::string> word;
  char quote = 0;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (quote != 0 && c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
      word = word.value_or("");
    } else if (quote == 0 && blank) {
      if (word) words.push_back(*word);
      word.reset();
    } else {
      word = word.value_or("") + c;
    }
  }
  if (quote != 0) throw InputError("options", "a quote stays open");
  if (word) words.push_back(*word);
  if (words.size() > kMostWords) throw InputError("options", "are more than a person types");
  return words;
}

std::vector<std::string> checked_words(const std::vector<std::string>& words,
                                       const std::vector<KnownOption>& options,
                                       const std::set<std::string>& files) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < words.size();) {
    if (!words[at].starts_with("--"))
      throw InputError("options", "'" + words[at] + "' is no option; options begin with --");
    take_option(words, at, options, files, out);
  }
  return out;
}

void check_job(const std::string& text, const std::string& name) {
  static const std::regex plain_string("\"[^\"#/\\\\]*\"|'[^'#/\\\\]*'");
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find("\"\"\"") != std::string::npos || line.find("'''") != std::string::npos)
      throw InputError(name + ":" + std::to_string(number),
                       "a job that is sent has no texts of several lines");
    if (line.find_first_of("/\\") == std::string::npos) continue;
    if (line.size() > kLongestLine) throw InputError(name, "a line is longer than a person writes");
    const std::string rest = std::regex_replace(line, plain_string, "");
    const std::string before = rest.substr(0, rest.find('#'));
    // A # within quotes begins no comment.
    const bool is_comment = before.find_first_of("\"'/\\") == std::string::npos;
    if (!is_comment)
      throw InputError(
          name + ":" + std::to_string(number),
          "a job that is sent names files by their plain names, without / and \\; send them with it");
  }
}

}  // namespace clearcut::serve
