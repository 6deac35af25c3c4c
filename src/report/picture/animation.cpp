#include "report/picture/animation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "geometry/region.h"
#include "report/picture/job_view.h"
#include "report/picture/plan_picture.h"
#include "report/picture/svg.h"
#include "report/picture/svg_writer.h"
#include "report/words/text_table.h"

namespace clearcut::report {
namespace {

constexpr double kWidest = 920, kNarrowest = 560, kTallest = 720;  // the view
constexpr double kAnimationMargin = 20;
constexpr double kTitleHeight = 76;
constexpr double kBarHeight = 44;         // with the clock below the picture
constexpr double kShortestAnimation = 8;  // s
constexpr int kClockTexts = 60;
constexpr double kSameHeight = 1e-6;  // mm

/// Consecutive moves of one section which the cutter makes at even speed: a layer with its entry, or moves above it.
struct Stretch {
  std::size_t section = 0;
  bool cuts = false;
  double z = 0;  ///< of the layer
  double begin_s = 0, end_s = 0;
  double length = 0;  ///< in plan, mm
  std::vector<Edge> path;
};

/// Whether the move takes material away at its end's height: neither a rapid nor a retract.
bool may_cut(const Move& move) {
  return !is_rapid(move.kind) && move.z_to <= move.z_from + kSameHeight;
}

bool is_drawn(const Move& move) {
  return drawable(move.path) && std::isfinite(move.z_from) && std::isfinite(move.z_to);
}

/// Splits the program; a descending entry belongs to the layer at its end.
std::vector<Stretch> stretches_of(const Toolpath& toolpath, const std::vector<double>& times_s) {
  std::vector<Stretch> all;
  double clock_s = 0;
  std::size_t index = 0;
  for (std::size_t s = 0; s < toolpath.sections.size(); ++s) {
    double entry_z = 0;  // height of the move before, in a descending entry
    bool descends = false;
    for (const Move& move : toolpath.sections[s].moves) {
      const double time_s = index < times_s.size() ? times_s[index] : 0;
      ++index;
      if (!is_drawn(move)) continue;
      const bool cuts = may_cut(move), falls = move.z_to < move.z_from - kSameHeight;
      const bool goes_on = !all.empty() && all.back().section == s && all.back().cuts == cuts &&
                           (!cuts || std::abs(all.back().z - move.z_to) <= kSameHeight ||
                            (descends && std::abs(entry_z - move.z_from) <= kSameHeight));
      if (!goes_on) all.push_back({s, cuts, move.z_to, clock_s, clock_s, 0, {}});
      Stretch& last = all.back();
      last.z = move.z_to;
      clock_s += time_s;
      last.end_s = clock_s;
      if (!move.is_vertical()) {
        last.length += move.path.length();
        last.path.push_back(move.path);
      }
      descends = cuts && falls;
      entry_z = move.z_to;
    }
  }
  return all;
}

struct VerdictLook {
  const char* word;
  const char* color;
};
VerdictLook look_in_animation(Verdict verdict) {
  switch (verdict) {
    case Verdict::kClean:
      return {"certified clean", palette::kGood};
    case Verdict::kConditional:
      return {"conditional", palette::kWarn};
    case Verdict::kFaulty:
      break;
  }
  return {"faulty", palette::kBad};
}

/// Times and values of one animated attribute, as SVG wants them: both from the begin to the end of the animation.
class Keys {
 public:
  explicit Keys(double total_s) : total_s_(total_s) {}

  void add(double time_s, const std::string& value) {
    const std::string time = trimmed(std::clamp(time_s / total_s_, 0.0, 1.0), 6);
    if (time == last_time_ && value == last_value_) return;
    times_ += (times_.empty() ? "" : ";") + time;
    values_ += (values_.empty() ? "" : ";") + value;
    last_time_ = time;
    last_value_ = value;
  }
  const std::string& times() const { return times_; }
  const std::string& values() const { return values_; }

 private:
  double total_s_;
  std::string times_, values_, last_time_, last_value_;
};

class Animation {
 public:
  Animation(const Part& part, const Toolpath& toolpath, const Findings& findings,
            const std::vector<double>& times_s)
      : part_(part),
        toolpath_(toolpath),
        findings_(findings),
        stretches_(stretches_of(toolpath, times_s)),
        total_s_(stretches_.empty() ? 1 : std::max(stretches_.back().end_s, 1e-3)),
        played_s_(std::clamp(total_s_, kShortestAnimation, kLongestAnimation)) {
    const Job job{part, toolpath, findings};
    view_.world = world_of(job);
    view_.corner = {kAnimationMargin, kTitleHeight};
    const double aspect = view_.world.width() / std::max(view_.world.height(), 1e-9);
    view_.width = std::clamp(kTallest * aspect, kNarrowest, kWidest);
    view_.height = std::min(view_.width / std::max(aspect, 1e-9), kTallest);
  }

  std::string text() {
    const std::string w = svg_number(page_width()),
                      h = svg_number(view_.corner.y + view_.height + kBarHeight);
    svg_.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                      {"width", w},
                      {"height", h},
                      {"viewBox", "0 0 " + w + " " + h},
                      {"font-family", "sans-serif"}});
    svg_.words("title", part_.name.empty() ? "part" : part_.name);
    svg_.leaf("rect", {{"width", w}, {"height", h}, {"fill", "#ffffff"}});
    draw_words();
    const Vec2 origin = view_.page({0, 0});
    svg_.open("g", {{"transform", fmt::format("translate({:.3f} {:.3f}) scale({:.6f} {:.6f})", origin.x,
                                              origin.y, view_.scale(), -view_.scale())}});
    draw_stock();
    draw_layers();
    draw_walls();
    draw_cutter();
    svg_.close();
    draw_clock();
    svg_.close();
    return svg_.str();
  }

 private:
  const Section& section_of(const Stretch& stretch) const { return toolpath_.sections[stretch.section]; }

  double diameter_of(const Stretch& stretch) const {
    const Tool* tool = tool_of(part_, section_of(stretch));
    return tool == nullptr ? 1 : tool->diameter;
  }

  double page_width() const { return view_.width + 2 * kAnimationMargin; }

  /// An element within the open one that changes its `attribute` with the keys, at once or evenly.
  void animate(const char* attribute, const Keys& keys, const char* mode) {
    svg_.leaf("animate", {{"attributeName", attribute},
                          {"dur", played()},
                          {"repeatCount", "indefinite"},
                          {"calcMode", mode},
                          {"keyTimes", keys.times()},
                          {"values", keys.values()}});
  }

  std::string played() const { return svg_number(played_s_) + "s"; }

  void draw_words() {
    svg_.text({kAnimationMargin, 32}, part_.name.empty() ? "part" : shortened(part_.name, 50),
              text_style(22, palette::kInk, "bold"));
    const VerdictLook look = look_in_animation(verdict_of(findings_));
    svg_.text({page_width() - kAnimationMargin, 32},
              fmt::format("{}, {} of machining", look.word, clock_time(total_s_)),
              text_style(18, look.color, "bold", "end"));
    // The tool and the operation that are at work.
    for (std::size_t i = 0; i < stretches_.size();) {
      std::size_t end = i;
      while (end < stretches_.size() && stretches_[end].section == stretches_[i].section) ++end;
      draw_label(stretches_[i], stretches_[i].begin_s,
                 end < stretches_.size() ? stretches_[end].begin_s : total_s_);
      i = end;
    }
  }

  void draw_label(const Stretch& first, double begin_s, double end_s) {
    const Tool* tool = tool_of(part_, section_of(first));
    const std::string label = section_of(first).label;
    svg_.open("g", {{"opacity", "0"}});
    Keys keys(total_s_);
    if (begin_s > 0) keys.add(0, "0");
    keys.add(begin_s, "1");
    if (end_s < total_s_) keys.add(end_s, "0");
    animate("opacity", keys, "discrete");
    svg_.text(
        {kAnimationMargin, 58},
        (tool == nullptr ? "" : description_of(*tool)) + (label.empty() ? "" : ": " + shortened(label, 50)),
        text_style(15, palette::kFaint));
    svg_.close();
  }

  /// The outline of the block, or of all that is seen where none is stated.
  std::string stock_path() const {
    PathData data;
    data.add(rectangle(part_.stock ? part_.stock->plan : view_.world));
    return data.text();
  }

  void draw_stock() {
    svg_.leaf("path", {{"d", stock_path()},
                       {"fill", palette::kMaterial},
                       {"stroke", palette::kInk},
                       {"stroke-width", svg_number(view_.mm(1))}});
  }

  void draw_walls() {
    PathData data;
    for (const Feature& feature : part_.features) data.add(feature.target);
    if (!data.empty())
      svg_.leaf("path", {{"d", data.text()},
                         {"fill", "none"},
                         {"stroke", palette::kInk},
                         {"stroke-width", svg_number(view_.mm(1))},
                         {"stroke-linejoin", "round"}});
  }

  /// Deeper layers over shallower ones, whenever they are cut. Beside the block there is nothing to cut.
  void draw_layers() {
    std::vector<const Stretch*> layers;
    for (const Stretch& stretch : stretches_)
      if (stretch.cuts && !stretch.path.empty()) layers.push_back(&stretch);
    std::stable_sort(layers.begin(), layers.end(),
                     [](const Stretch* a, const Stretch* b) { return a->z > b->z; });
    svg_.open("clipPath", {{"id", "block"}});
    svg_.leaf("path", {{"d", stock_path()}});
    svg_.close();
    svg_.open("g", {{"fill", "none"},
                    {"stroke-linecap", "round"},
                    {"stroke-linejoin", "round"},
                    {"clip-path", "url(#block)"}});
    for (const Stretch* layer : layers) draw_layer(*layer);
    svg_.close();
  }

  /// A stroke as wide as the cutter, of which ever more is shown. Its gap is longer than the stroke, so that no round end
  /// shows before its time.
  void draw_layer(const Stretch& layer) {
    PathData data;
    for (const Edge& edge : layer.path) data.add(edge);
    svg_.open("path", {{"d", data.text()},
                       {"stroke", palette::depth_color(depth_fraction(part_, layer.z))},
                       {"stroke-width", svg_number(diameter_of(layer))},
                       {"pathLength", "1"},
                       {"stroke-dasharray", "1 3"},
                       {"stroke-dashoffset", "2"}});
    Keys shown(total_s_);
    if (layer.begin_s > 0) {
      shown.add(0, "2");
      shown.add(layer.begin_s, "2");
    }
    shown.add(layer.begin_s, "1");
    shown.add(layer.end_s, "0");
    shown.add(total_s_, "0");
    animate("stroke-dashoffset", shown, "linear");
    svg_.close();
  }

  void draw_cutter() {
    if (stretches_.empty()) return;
    PathData data;
    double length = 0, done = 0;
    for (const Stretch& stretch : stretches_) {
      for (const Edge& edge : stretch.path) data.add(edge);
      length += stretch.length;
    }
    if (data.empty() || length <= 0) return;
    Keys place(total_s_), width(total_s_), fill(total_s_);
    place.add(0, "0");
    for (const Stretch& stretch : stretches_) {
      place.add(stretch.begin_s, trimmed(done / length, 6));
      done += stretch.length;
      place.add(stretch.end_s, trimmed(std::min(done / length, 1.0), 6));
      width.add(stretch.begin_s, svg_number(diameter_of(stretch) / 2));
      fill.add(stretch.begin_s, stretch.cuts ? palette::kEntry : palette::kRapid);
    }
    place.add(total_s_, "1");
    svg_.open("circle", {{"r", svg_number(diameter_of(stretches_.front()) / 2)},
                         {"fill", palette::kEntry},
                         {"fill-opacity", "0.55"},
                         {"stroke", palette::kInk},
                         {"stroke-width", svg_number(view_.mm(1))}});
    animate("r", width, "discrete");
    animate("fill", fill, "discrete");
    svg_.leaf("animateMotion", {{"dur", played()},
                                {"repeatCount", "indefinite"},
                                {"calcMode", "linear"},
                                {"keyTimes", place.times()},
                                {"keyPoints", place.values()},
                                {"path", data.text()}});
    svg_.close();
  }

  /// A bar that fills, and the time of the machine.
  void draw_clock() {
    const double y = view_.corner.y + view_.height + 12;
    const std::string width = svg_number(view_.width);
    svg_.leaf("rect", {{"x", svg_number(kAnimationMargin)},
                       {"y", svg_number(y)},
                       {"width", width},
                       {"height", "5"},
                       {"fill", palette::kRule}});
    svg_.open("rect", {{"x", svg_number(kAnimationMargin)},
                       {"y", svg_number(y)},
                       {"width", "0"},
                       {"height", "5"},
                       {"fill", palette::kCut}});
    Keys filled(total_s_);
    filled.add(0, "0");
    filled.add(total_s_, width);
    animate("width", filled, "linear");
    svg_.close();
    for (int i = 0; i < kClockTexts; ++i) {
      const double begin_s = total_s_ * i / kClockTexts, end_s = total_s_ * (i + 1) / kClockTexts;
      svg_.open("g", {{"opacity", "0"}});
      Keys keys(total_s_);
      if (i > 0) keys.add(0, "0");
      keys.add(begin_s, "1");
      if (i + 1 < kClockTexts) keys.add(end_s, "0");
      animate("opacity", keys, "discrete");
      svg_.text({kAnimationMargin, y + 24}, clock_time(begin_s), text_style(14, palette::kFaint));
      svg_.close();
    }
    const double faster = total_s_ / played_s_;
    if (faster > 1.05)
      svg_.text({page_width() - kAnimationMargin, y + 24}, fmt::format("{} times as fast", fixed(faster, 1)),
                text_style(14, palette::kFaint, "normal", "end"));
  }

  const Part& part_;
  const Toolpath& toolpath_;
  const Findings& findings_;
  std::vector<Stretch> stretches_;
  double total_s_;
  double played_s_;
  PlanView view_;
  SvgWriter svg_;
};

}  // namespace

std::string animated_svg(const Part& part, const Toolpath& toolpath, const Findings& findings,
                         const std::vector<double>& move_times_s) {
  return Animation(part, toolpath, findings, move_times_s).text();
}

}  // namespace clearcut::report
