#include "report/viewer/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/elementary.h"
#include "base/text.h"
#include "kinematics/kinematics.h"
#include "model/cutter_profile.h"
#include "model/results/findings.h"
#include "report/certificate/certificate_json.h"
#include "report/picture/job_view.h"
#include "report/picture/plan_picture.h"
#include "report/picture/svg_writer.h"
#include "report/table.h"
#include "report/viewer/html_page.h"

namespace clearcut::report {

namespace {

std::string colors() {
  return fmt::format(
      ":root {{ --ink: {}; --faint: {}; --rule: {}; --good: {}; --bad: {}; --cut: {}; --link: {}; --entry: "
      "{}; "
      "--rapid: {}; }}",
      report::palette::kInk, report::palette::kFaint, report::palette::kRule, report::palette::kGood,
      report::palette::kBad, report::palette::kCut, report::palette::kLink, report::palette::kEntry,
      report::palette::kRapid);
}

}  // namespace

std::string html(const Part& part, const Toolpath& toolpath, const Findings& findings,
                 const HtmlOptions& options) {
  const std::string title = xml_escaped(part.name.empty() ? "part" : part.name);
  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n";
  page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n";
  page += "<title>" + title + "</title>\n<style>\n" + colors() + kHtmlStyle + "</style>\n</head>\n<body>\n";
  page += kHtmlBody;
  page += "<script type=\"application/json\" id=\"job\">" + html_data(part, toolpath, findings, options) +
          "</script>\n";
  page += std::string("<script>\n//<![CDATA[") + kHtmlScript + "//]]>\n</script>\n</body>\n</html>\n";
  return page;
}

namespace {

using Json = nlohmann::ordered_json;

constexpr double kMicrometres = 1000;  // micrometres per mm
constexpr double kTicks = 10000;       // ticks per second
constexpr int kDecimals = 6;

Json number(double value, int decimals = kDecimals) {
  if (!std::isfinite(value) || std::abs(value) > 1e12) return nullptr;
  const double scale = base::pow(10.0, decimals);
  return std::round(value * scale) / scale + 0.0;
}

Json corners(const Box& box) {
  return {number(box.min.x), number(box.min.y), number(box.max.x), number(box.max.y)};
}

bool drawable_move(const Move& move) {
  return drawable(move.path) && std::abs(move.z_from) < 1e7 && std::abs(move.z_to) < 1e7;
}

/// A position in whole micrometres, to sum differences without drift.
struct Position {
  long long x = 0, y = 0, z = 0;
  friend bool operator==(const Position&, const Position&) = default;
};

Position rounded(Vec2 p, double z) {
  return {std::llround(p.x * kMicrometres), std::llround(p.y * kMicrometres), std::llround(z * kMicrometres)};
}

/// Moves as columns of differences.
class MoveColumns {
 public:
  void add(const Move& move, double seconds) {
    const Position from = rounded(move.path.from, move.z_from), to = rounded(move.path.to, move.z_to);
    if (count_ == 0 || from != at_) starts_.push_back({count_, from.x, from.y, from.z});
    if (move.path.is_arc()) {
      const Position center = rounded(move.path.center, 0);
      arcs_.push_back({count_, center.x - from.x, center.y - from.y, static_cast<int>(move.path.turn)});
    }
    const double feed =
        is_rapid(move.kind) || !std::isfinite(move.feed.mm_per_min()) ? 0 : move.feed.mm_per_min();
    if (count_ == 0 || feed != feed_) feeds_.push_back({count_, number(feed, 3)});
    kinds_ += static_cast<char>('0' + static_cast<int>(move.kind));
    x_.push_back(to.x - from.x);
    y_.push_back(to.y - from.y);
    z_.push_back(to.z - from.z);
    line_.push_back(move.line - last_line_);
    add_time(seconds);
    at_ = to;
    feed_ = feed;
    last_line_ = move.line;
    ++count_;
  }
  int count() const { return count_; }
  void write(Json& json) const {
    json["kinds"] = kinds_;
    json["x"] = x_;
    json["y"] = y_;
    json["z"] = z_;
    json["t"] = t_;
    json["line"] = line_;
    json["starts"] = starts_;
    json["arcs"] = arcs_;
    json["feeds"] = feeds_;
  }

 private:
  /// Rounds the running sum, not the parts.
  void add_time(double seconds) {
    seconds_ += std::isfinite(seconds) ? std::clamp(seconds, 0.0, 1e6) : 0;
    const long long ticks = std::llround(seconds_ * kTicks);
    t_.push_back(ticks - ticks_);
    ticks_ = ticks;
  }
  int count_ = 0, last_line_ = 0;
  double feed_ = 0, seconds_ = 0;
  long long ticks_ = 0;
  Position at_;
  std::string kinds_;
  std::vector<long long> x_, y_, z_, t_;
  std::vector<int> line_;
  Json starts_ = Json::array(), arcs_ = Json::array(), feeds_ = Json::array();
};

std::size_t moves_in(const Toolpath& toolpath) {
  std::size_t count = 0;
  for (const Section& section : toolpath.sections) count += section.moves.size();
  return count;
}

/// Head data of a section; `first`: the column of its first move.
Json section_head(const Part& part, const Section& section, int first) {
  const Tool* tool = tool_of(part, section);
  Json json;
  json["label"] = section.label;
  json["feature"] = feature_of(part, section);
  json["tool"] = tool == nullptr ? -1 : static_cast<int>(tool - part.tools.data());
  json["first"] = first;
  return json;
}

/// All earlier cuts.
Json earlier_json(const Part& part, const Toolpath* earlier) {
  if (earlier == nullptr) return nullptr;
  MoveColumns columns;
  Json json;
  json["sections"] = Json::array();
  for (const Section& section : earlier->sections) {
    if (tool_of(part, section) == nullptr) continue;
    Json head = section_head(part, section, columns.count());
    const bool is_open = section.counts_below(part.top_z());
    head["below"] = is_open ? Json(nullptr) : number(*section.carried_below);
    json["sections"].push_back(std::move(head));
    for (const Move& move : section.moves)
      if (drawable_move(move) && !is_rapid(move.kind)) columns.add(move, 0);
  }
  columns.write(json);
  return json;
}

/// Times of all moves, section after section.
std::vector<double> times_of(const Toolpath& toolpath, const HtmlOptions& options) {
  if (options.move_times_s.size() == moves_in(toolpath)) return options.move_times_s;
  std::vector<double> times;
  for (const Section& section : toolpath.sections) {
    std::vector<Move> drawable;
    std::copy_if(section.moves.begin(), section.moves.end(), std::back_inserter(drawable), drawable_move);
    const std::vector<Seconds> known = kinematics::move_times(drawable, options.machine);
    auto next = known.begin();
    for (const Move& move : section.moves) times.push_back(drawable_move(move) ? (next++)->seconds() : 0);
  }
  return times;
}

void write_moves(const Job& job, const HtmlOptions& options, Json& json) {
  MoveColumns columns;
  const std::vector<double> times = times_of(job.toolpath, options);
  const std::vector<float>& engagement = job.findings.move_engagement_deg;
  const bool measured = !engagement.empty() && engagement.size() == moves_in(job.toolpath);
  const std::vector<float>& forces = job.findings.move_force_n;
  const bool loaded = !forces.empty() && forces.size() == moves_in(job.toolpath);
  Json degrees = Json::array(), newtons = Json::array();
  std::size_t index = 0;
  json["sections"] = Json::array();
  for (const Section& section : job.toolpath.sections) {
    json["sections"].push_back(section_head(job.part, section, columns.count()));
    for (const Move& move : section.moves) {
      const std::size_t i = index++;
      if (!drawable_move(move)) continue;
      columns.add(move, times[i]);
      if (measured) degrees.push_back(std::lround(engagement[i]));
      if (loaded) newtons.push_back(number(static_cast<double>(forces[i]), 1));
    }
  }
  columns.write(json);
  json["engagement"] = measured ? std::move(degrees) : Json(nullptr);
  json["force"] = loaded ? std::move(newtons) : Json(nullptr);
}

double lowest_z(const Job& job) {
  double z = job.part.top_z();
  for (const Feature& feature : job.part.features) z = std::min(z, feature.floor_z);
  for (const Section& section : job.toolpath.sections) {
    for (const Move& move : section.moves) {
      if (drawable_move(move)) z = std::min(z, std::min(move.z_from, move.z_to));
    }
  }
  return z;
}

Json tool_json(const Tool& tool) {
  const CutterProfile profile = outer_profile(tool);
  const bool has_cone = profile.slope > 0;
  Json json;
  json["n"] = tool.number;
  json["d"] = number(2 * widest_radius(tool));
  json["r"] = number(tool.kind == ToolKind::kBallEndMill ? tool.radius() : tool.corner_radius);
  json["f"] = tool.flute_length ? number(*tool.flute_length) : Json(nullptr);
  json["a"] = has_cone ? number(profile.slope) : Json(nullptr);
  json["t"] = number(has_cone ? 2 * profile.flat : tool.tip_diameter);
  json["k"] = number(tool.shank_diameter);
  json["s"] = tool.stickout ? number(*tool.stickout) : Json(nullptr);
  json["h"] = number(tool.holder_diameter);
  json["w"] = description_of(tool);
  return json;
}

Json keep_outs_json(const Part& part) {
  Json blocks = Json::array();
  for (const KeepOut& one : part.keep_outs) {
    Json block = corners(one.plan);
    block.push_back(number(one.bottom_z));
    block.push_back(number(one.top_z));
    blocks.push_back(block);
  }
  return blocks;
}

/// The legal area of the cutter's centre at the floor, and the cutter's width: for colouring uncut material within
/// reach.
void write_reach(const Job& job, int feature, Json& json) {
  const Reach reach = reach_of(job, feature);
  PathData centers, lines;
  centers.add(reach.centers);
  for (const Path& line : reach.fit_lines) {
    for (const Edge& edge : line) lines.add(edge);
  }
  for (const Vec2 point : reach.fit_points) lines.add(point);
  json["reach"] = {{"centers", centers.text()}, {"lines", lines.text()}, {"d", number(reach.diameter)}};
}

Json feature_json(const Job& job, int feature) {
  const Feature& f = job.part.features[static_cast<std::size_t>(feature)];
  PathData path;
  path.add(f.target);
  double time = 0, left = 0, gouge = 0;
  bool clean = true;
  const auto findings = findings_of(job.part, job.findings, feature);
  for (const FeatureFindings* one : findings) {
    time += one->figures.time_s;
    left = std::max(left, one->figures.uncut_thickness_mm);
    gouge = std::max(gouge, one->figures.gouge_mm);
    clean = clean && one->figures.clean;
  }
  Json json;
  json["name"] = f.name;
  json["floor"] = number(f.floor_z);
  json["top"] = number(f.top_z);
  json["path"] = path.text();
  json["time"] = number(time);
  json["left"] = number(left);
  json["gouge"] = number(gouge);
  json["clean"] = findings.empty() ? Json(nullptr) : Json(clean);
  if (!clean) write_reach(job, feature, json);
  return json;
}

Json fault_json(const Fault& fault) {
  Json json;
  json["kind"] = name_of(fault.kind);
  json["feature"] = fault.feature;
  json["x"] = number(fault.at.point.x);
  json["y"] = number(fault.at.point.y);
  json["z"] = number(fault.at.z);
  json["head"] = headline_of(fault);
  json["line"] = fault.at.line;
  json["text"] = fault.text;
  return json;
}

Json figures_json(const Findings& findings) {
  const Figures& f = findings.all;
  const BoundedFeed feed = bounded_feed(findings);
  Json json;
  json["time_s"] = number(f.time_s);
  json["feed_mm"] = number(f.feed_mm);
  json["percent_above_bound"] = feed.bound_mm > 0 ? number(feed.percent_above()) : Json(nullptr);
  json["rapid_mm"] = number(f.rapid_mm);
  json["retracts"] = f.retracts;
  json["uncut_thickness_mm"] = number(f.uncut_thickness_mm);
  json["gouge_mm"] = number(f.gouge_mm);
  json["rapid_in_material"] = f.rapid_in_material;
  json["max_deg"] = number(f.engagement.max_deg);
  return json;
}

Json lines_of(const std::string& program) {
  Json lines = Json::array();
  for (std::size_t begin = 0; begin < program.size();) {
    const std::size_t end = std::min(program.find('\n', begin), program.size());
    lines.push_back(program.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// Box of the stock or targets, with cuts beside them up to a tenth of their size.
Box stage_of(const Job& job) {
  const Box world = world_of(job), most = world.grown(0.1 * std::max(world.width(), world.height()));
  Box box = world;
  for (const Section& section : job.toolpath.sections) {
    const Tool* tool = tool_of(job.part, section);
    const double radius = tool != nullptr && std::isfinite(tool->diameter) ? tool->radius() : 0;
    for (const Move& move : section.moves) {
      if (drawable_move(move) && !is_rapid(move.kind)) box.add(move.path.box().grown(radius));
    }
  }
  return {{std::max(box.min.x, most.min.x), std::max(box.min.y, most.min.y)},
          {std::min(box.max.x, most.max.x), std::min(box.max.y, most.max.y)}};
}

/// Colours of 256 heights from `bottom` to `top`.
Json shades(const Part& part, double bottom, const std::string& material) {
  Json json = Json::array();
  for (int i = 0; i < 256; ++i) {
    const double fraction = part.is_shape_stated
                                ? depth_fraction(part, bottom + (part.top_z() - bottom) * i / 255)
                                : 1 - i / 255.0;
    json.push_back(report::palette::material_color(material, fraction));
  }
  return json;
}

}  // namespace

std::string html_data(const Part& part, const Toolpath& toolpath, const Findings& findings,
                      const HtmlOptions& options) {
  const Job job{part, toolpath, findings};
  Json json;
  json["name"] = part.name.empty() ? "part" : part.name;
  json["clean"] = verdict_of(findings) == Verdict::kClean;
  json["verdict"] = verdict_words(findings);
  json["asked"] = !findings.without_part;
  json["bad"] = report::palette::kBad;
  json["top"] = number(part.top_z());
  const double bottom = lowest_z(job);
  json["bottom"] = number(bottom);
  json["shades"] = shades(part, bottom, options.material);
  json["stock"] = part.stock ? corners(part.stock->plan) : Json(nullptr);
  json["stock_z"] = part.stock ? number(part.stock->z_bottom) : Json(nullptr);
  json["world"] = corners(stage_of(job));
  json["keep_outs"] = keep_outs_json(part);
  json["tools"] = Json::array();
  for (const Tool& tool : part.tools) json["tools"].push_back(tool_json(tool));
  json["features"] = Json::array();
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    json["features"].push_back(feature_json(job, static_cast<int>(i)));
  }
  json["faults"] = Json::array();
  for (const Fault& fault : told_faults(findings)) json["faults"].push_back(fault_json(fault));
  json["conditions"] = Json::array();
  for (const Condition& one : findings.conditions) json["conditions"].push_back(condition_json(one));
  json["figures"] = figures_json(findings);
  write_moves(job, options, json);
  json["earlier"] = earlier_json(part, options.earlier);
  json["program"] = lines_of(options.program);

  std::string text;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else if (c == '>') {
      text += "\\u003e";
    } else if (c == '&') {
      text += "\\u0026";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace clearcut::report
