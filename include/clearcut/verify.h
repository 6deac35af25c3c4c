// Checking programs, whoever wrote them: read_program() gives the moves, check_program() what they do to a part.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clearcut/plan.h"
#include "model/program.h"
#include "model/runs/check_result.h"
#include "options/program_question.h"

namespace clearcut {

/// `dialect`: the control that will run the program; absent: recognised. `reference_feeds`: feeds at the reference by
/// tool number, used if feeds follow the load and no option states one.
CheckResult check_program(const Part& part, const std::string& program, const std::string& program_name,
                          const PlanOptions& options, std::optional<Dialect> dialect = {},
                          const std::map<int, MmPerMin>& reference_feeds = {});

/// Checks any program text as far as possible without a part: rapids, plunges, depths and engagement in `stock`,
/// feeds, spindle and tools, limits and travel, arcs. Uncut material and gouges are not examined
/// (Findings::without_part). Without a stock the box of all cuts below `top`, mm, is assumed, with the condition
/// "stock"; if `top` is absent, too, below Z 0, provided no cut is above. Throws InputError for text that no control
/// accepts, and if nothing moves, no tool is given, no cut is below `top` without a stated stock, or some cut is
/// above Z 0 without a stated top.
CheckResult check_program_alone(const std::optional<Stock>& stock, const std::string& program,
                                const std::string& program_name, const PlanOptions& options,
                                std::optional<Dialect> dialect = {}, std::optional<double> top = {},
                                const std::map<int, MmPerMin>& reference_feeds = {});

/// Checks `program` as `question` asks: alone, or against a part given as outlines. The question is a JSON object with what verify takes
/// as arguments, without any file; docs/verify-module.md describes its keys.
std::string check_text(std::string_view program, std::string_view question);

/// Level moves at the tool's usual feed (the feed of the greatest part of its cutting length) are raised to the feed
/// allowed by the rule of `options.shop.feed_by` over their whole block, at most to the cap; every feed above the
/// allowed one is lowered. If no reference feed is stated the usual feed of each tool is the feed at the reference.
ProgramFeeds feeds_of_program(const ProgramQuestion& question, const std::string& program,
                              const std::string& program_name, const PlanOptions& options);

/// Figures of all moves, section after section; `part`, `toolpath` and `control` are those of a PlanResult or
/// CheckResult. Throws Cancelled. Cost as the engagement of the certificate: O(feed length / step).
std::vector<MoveFigures> figures_of_moves(const Part& part, const Toolpath& toolpath,
                                          const ControlTable& control, const PlanOptions& options);

/// One sentence for people: "margin: holds for 0.0034 mm of machine error; ...".
std::string margin_line(const Margin& margin);

/// Names of the rows of the table of options that a question may state.
std::vector<std::string> question_options();

/// `program` from `stop` on, its text unchanged.
ResumedProgram resume_program(const ProgramQuestion& question, const Stop& stop, const std::string& program,
                              const std::string& program_name, const PlanOptions& options);

/// The times of all moves, section after section, s. Cost O(moves).
std::vector<double> times_of_moves(const Part& part, const Toolpath& toolpath, const ControlTable& control,
                                   const PlanOptions& options);

/// The moves of G-code or Klartext, line by line. `file_name` stands in messages; `home_z`, mm, is the height of places that
/// a program names without stating them, see home_z(Machine). Throws InputError "file:line: ..." for what cannot be understood.
Program read_program(std::string_view text, const std::string& file_name, double home_z = kUsualHomeZ);

}  // namespace clearcut
