#include "pipeline/program_feeds.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "link/sections/load_feeds.h"
#include "pipeline/steps/section_order.h"
#include "read/gcode/gcode.h"
#include "read/gcode/macros/macro_line.h"
#include "read/gcode/sinumerik/words.h"
#include "read/gcode/words/lines.h"
#include "resolve/resolve.h"
#include "verify/program/verify_options.h"

namespace clearcut::pipeline {
namespace {

read::gcode::CompensationValues compensation_values(std::vector<Tool> tools, const ShopOptions& shop) {
  resolve::number_tools(tools);
  read::gcode::CompensationValues values;
  for (const Tool& tool : tools) values.radii.try_emplace(tool.number, tool.radius());
  if (tools.size() == 1) values.only_radius = tools.front().radius();
  values.is_stated = shop.compensation.has_value();
  if (resolve::writes_wear(shop)) values.wear = 0;
  return values;
}

}  // namespace

read::gcode::ReadControllerOptions reading_of(const PlanOptions& options, const std::vector<Tool>& tools,
                                              const std::string& file) {
  read::gcode::ReadControllerOptions reading;
  reading.home_z = home_z(options.machine);
  reading.places = options.machine.places;
  reading.subprograms = read::gcode::files_beside(file);
  reading.compensation = compensation_values(tools, options.shop);
  return reading;
}

namespace {

/// Greatest relative difference of two feeds that are the same rounded word.
constexpr double kSameFeed = 1e-6;

bool is_level_cut(const Move& move) {
  return !is_rapid(move.kind) && !move.is_vertical() && move.z_from == move.z_to;
}

/// The feed of the greatest part of each tool's level cutting length, by tool number.
std::map<int, MmPerMin> usual_feeds(const Toolpath& toolpath) {
  std::map<int, std::map<double, double>> ways;
  for (const Section& section : toolpath.sections)
    for (const Move& move : section.moves)
      if (is_level_cut(move) && move.feed.mm_per_min() > 0)
        ways[section.tool_number][move.feed.mm_per_min()] += move.length();
  std::map<int, MmPerMin> usual;
  for (const auto& [tool, lengths] : ways) {
    const auto most = std::max_element(lengths.begin(), lengths.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    usual[tool] = MmPerMin::of(most->first);
  }
  return usual;
}

CheckResult checked(const ProgramQuestion& question, const std::string& program, const std::string& name,
                    const PlanOptions& options, const std::map<int, MmPerMin>& reference_feeds) {
  return question.part
             ? check_program(*question.part, program, name, options, question.dialect, reference_feeds)
             : check_program_alone(question.stock, program, name, options, question.dialect, question.top,
                                   reference_feeds);
}

/// The moves of `toolpath` with the feeds allowed by the rule; their lengths are unchanged.
Toolpath with_feeds_by_load(Toolpath toolpath, const Part& part, const PlanOptions& options,
                            const ProgramFeeds& feeds, const std::map<int, MmPerMin>& usual) {
  std::vector<double> radii;
  for (const Tool& tool : part.tools) radii.push_back(tool.radius());
  stock::Material material = material_at_start(part, feeds.before.earlier, radii);
  verify::LoadReference reference{*resolve::resolve_without_part(options).feed_rule};
  reference.feed_of_tool = feeds.reference_feeds;
  for (Section& section : toolpath.sections) {
    const int number = section.tool_number;
    const Tool* const tool = tool_numbered(part.tools, number);
    if (!tool) continue;
    const auto cutting = usual.find(number);
    if (!mills_upright(*tool) || cutting == usual.end()) {
      take_away(material, section, *tool);
      continue;
    }
    MmPerMin cap = MmPerMin::of(reference.cap(-1, number));
    if (options.machine.max_feed && *options.machine.max_feed < cap) cap = *options.machine.max_feed;
    link::set_load_feeds(section, *tool,
                         {reference.rule, MmPerMin::of(reference.feed(-1, number)), cap, cutting->second,
                          options.machine.acceleration, false},
                         material);
  }
  return toolpath;
}

/// Feed of a program line before and after, mm/min.
struct LineFeed {
  double before = 0, after = 0;
};

/// Adds feeds by line number; for lines with several moves the least feed.
void add_feeds_by_line(std::map<int, LineFeed>& lines, const Toolpath& before, const Toolpath& after) {
  for (std::size_t i = 0; i < before.sections.size(); ++i) {
    for (std::size_t k = 0; k < before.sections[i].moves.size(); ++k) {
      const Move& was = before.sections[i].moves[k];
      const Move& is = after.sections[i].moves[k];
      if (is_rapid(was.kind) || was.feed.mm_per_min() <= 0) continue;
      const auto [line, is_new] =
          lines.try_emplace(was.line, LineFeed{was.feed.mm_per_min(), is.feed.mm_per_min()});
      if (!is_new) line->second.after = std::min(line->second.after, is.feed.mm_per_min());
    }
  }
}

/// Writes the lines of a program anew with other feeds, and counts its F words.
class FeedWriter {
 public:
  FeedWriter(const std::string& program, const std::string& name, const std::map<int, LineFeed>& feeds)
      : program_(program), name_(name), feeds_(feeds) {}

  std::string text() {
    read::gcode::Lines lines(program_);
    std::string out;
    const char* from = program_.data();
    std::string_view line;
    while (lines.next(line)) {
      out.append(from, line.data());
      out += rewritten(line, lines.number());
      from = line.data() + line.size();
    }
    return out.append(from, program_.data() + program_.size());
  }

  int words_before() const { return words_before_; }
  int words_after() const { return words_after_; }

 private:
  /// The value in force is followed in the old text and in the new one: a word is written if they must differ.
  std::string rewritten(std::string_view line, int number) {
    const auto word = read::gcode::feed_word_in(line);
    if (word) {
      was_ = word->value;
      ++words_before_;
    }
    const auto wanted = feeds_.find(number);
    if (wanted == feeds_.end()) {
      if (word) {
        is_ = word->value;
        ++words_after_;
      }
      return std::string(line);
    }
    const double value = was_ * (wanted->second.after / wanted->second.before);
    const bool is_same = word && std::abs(value - word->value) <= kSameFeed * value;
    if (is_same || (!word && std::abs(value - is_) <= kSameFeed * value)) {
      if (word) {
        is_ = word->value;
        ++words_after_;
      }
      return std::string(line);
    }
    ++words_after_;
    std::string text = read::gcode::with_feed_word(line, value, name_ + ":" + std::to_string(number));
    is_ = read::gcode::feed_word_in(text)->value;
    return text;
  }

  const std::string& program_;
  const std::string& name_;
  const std::map<int, LineFeed>& feeds_;
  double was_ = 0, is_ = 0;  ///< F value in force, in the old text and in the new one
  int words_before_ = 0, words_after_ = 0;
};

/// Whether two readings are the same moves of the same tools, but for the feeds.
bool moves_alike(const Toolpath& a, const Toolpath& b) {
  const auto same_move = [](const Move& m, const Move& n) {
    return m.path == n.path && m.z_from == n.z_from && m.z_to == n.z_to &&
           is_rapid(m.kind) == is_rapid(n.kind) && m.line == n.line;
  };
  return std::equal(a.sections.begin(), a.sections.end(), b.sections.begin(), b.sections.end(),
                    [&](const Section& s, const Section& t) {
                      return s.tool_number == t.tool_number &&
                             std::equal(s.moves.begin(), s.moves.end(), t.moves.begin(), t.moves.end(),
                                        same_move);
                    });
}

/// The line of the first move with a feed above the planned one; 0 if there is none.
int line_above(const Toolpath& planned, const Toolpath& read) {
  for (std::size_t i = 0; i < planned.sections.size(); ++i)
    for (std::size_t k = 0; k < planned.sections[i].moves.size(); ++k) {
      const double most = planned.sections[i].moves[k].feed.mm_per_min();
      const Move& move = read.sections[i].moves[k];
      if (!is_rapid(move.kind) && move.feed.mm_per_min() > most * (1 + 1e-3)) return move.line;
    }
  return 0;
}

}  // namespace

ProgramFeeds feeds_of_program(const ProgramQuestion& question, const std::string& program,
                              const std::string& program_name, const PlanOptions& options) {
  if (!options.shop.feed_by)
    throw InputError("--feed-by", "say what the feeds follow: --feed-by chip or --feed-by removal");
  ProgramFeeds feeds;
  PlanOptions plain = options;
  plain.shop.feed_by.reset();
  plain.shop.reference_engagement_deg.reset();
  plain.shop.reference_feed.reset();
  plain.shop.feed_cap.reset();
  feeds.before = checked(question, program, program_name, plain, {});
  if (feeds.before.dialect == Dialect::kHeidenhain)
    throw InputError(program_name, "feeds of Klartext are not rewritten; give a program in G-code");
  const bool is_siemens = feeds.before.dialect == Dialect::kSiemens;
  const int line_of_call = feeds.before.control.calls.empty() ? 0 : 1;
  if (const int line = is_siemens ? std::max(read::gcode::first_language_line(program), line_of_call)
                                  : read::gcode::first_macro_line(program))
    throw InputError(
        program_name + ":" + std::to_string(line),
        "feeds of a program that computes or calls are not rewritten; post it with plain blocks");
  const auto usual = usual_feeds(feeds.before.toolpath);
  feeds.reference_feeds = usual;
  if (options.shop.reference_feed)
    for (auto& [tool, feed] : feeds.reference_feeds) feed = *options.shop.reference_feed;
  const Toolpath planned =
      with_feeds_by_load(feeds.before.toolpath, feeds.before.part, options, feeds, usual);
  std::map<int, LineFeed> lines;
  add_feeds_by_line(lines, feeds.before.toolpath, planned);
  for (const WornCuts& worn : feeds.before.worn)
    add_feeds_by_line(lines, worn.toolpath,
                      with_feeds_by_load(worn.toolpath, worn.part, options, feeds, usual));
  FeedWriter writer(program, program_name, lines);
  feeds.program = writer.text();
  feeds.words_before = writer.words_before();
  feeds.words_after = writer.words_after();
  feeds.after = checked(question, feeds.program, program_name, options, feeds.reference_feeds);
  if (!moves_alike(feeds.before.toolpath, feeds.after.toolpath))
    throw InputError(program_name,
                     "does not move as before with other F words; post it with one unit and G94");
  if (const int line = line_above(planned, feeds.after.toolpath))
    throw InputError(program_name + ":" + std::to_string(line),
                     "the feed does not follow the F words; post the program with one unit and G94");
  return feeds;
}

}  // namespace clearcut::pipeline
