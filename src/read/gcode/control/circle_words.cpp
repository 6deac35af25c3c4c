// I radius of the circle, or of the first of several; K radius of the last and Q the step between them; D number of what is taken off all radii;
// Z depth, L how often all of it is done, in G91 one depth below the other. (Haas, mill operator's manual, G12 and G13.)
#include "read/gcode/control/circle_words.h"

#include <cmath>
#include <string>
#include <vector>

#include "base/text.h"
#include "read/gcode/control/compensation_words.h"

namespace clearcut::read::gcode {
namespace {

constexpr double kMostCircles = 10000, kMostDepths = 1000;

class Circles {
 public:
  Circles(Control& control, const Block& block)
      : control_(control),
        block_(block),
        word_(has_g(block, 120) ? "G12" : "G13"),
        turn_(has_g(block, 120) ? Turn::kClockwise : Turn::kCounterClockwise) {}

  void mill() {
    refuse_what_is_not_read();
    const std::vector<double> all = radii();
    const int depths = number_of_depths();
    control_.moved = true;
    control_.before_feed();
    center_ = {known(0), known(1)};
    if (all.size() > 1)
      control_.builder.note(control_.line,
                            "how the control goes from one circle of " + word_ +
                                " to the next is not published; taken as straight outwards, within "
                                "the next one");
    for (int n = 0; n < depths; ++n) {
      go_down();
      mill_all(all);
    }
  }

 private:
  void refuse_what_is_not_read() const {
    if ((control_.rules.g.sets & kHaasWords) == 0) refuse("is not read; post the program without it");
    if (block_.has('X') || block_.has('Y'))
      refuse("with X or Y is not read; move to the centre in a block before");
    if (control_.modes.plane != Plane::kXY || control_.plan_map.is_on)
      refuse("outside the XY plane, under G68, G51 or G51.1 is not read");
    CompensationWords(control_).refuse_while_on(word_);
  }

  /// mm, of the tool's centre: I, then Q by Q up to K.
  std::vector<double> radii() const {
    if (!block_.has('I') || block_.value('I') <= 0)
      refuse("without its I word; add the radius of the circle");
    const double tool = radius_of_tool(), first = control_.mm(block_.value('I')) - tool;
    if (first <= 0)
      refuse("with a circle that is not larger than the tool, whose radius is " + trimmed(tool, 4) +
             " mm; the control stops");
    std::vector<double> all{first};
    if (block_.has('K') != block_.has('Q')) refuse("has one of K and Q, which go together; give both");
    if (!block_.has('K')) return all;
    const double last = control_.mm(block_.value('K')) - tool, step = control_.mm(block_.value('Q'));
    if (last < first) refuse("ends with a circle K that is smaller than its first one I; correct it");
    if (!(step > 0) || (last - first) / step > kMostCircles)
      refuse("needs a step Q of a sensible size; correct it");
    for (int n = 1; first + n * step < last; ++n) all.push_back(first + n * step);
    if (last > all.back()) all.push_back(last);
    return all;
  }

  /// mm; what the D word takes off the circles.
  double radius_of_tool() const {
    const int number = control_.radius_number;
    if (number <= 0) return 0;
    return compensation_of(control_.options.compensation, control_.builder, number,
                           control_.builder.drive.tool, "D" + std::to_string(number), control_.line);
  }

  int number_of_depths() const {
    const double count = block_.has('L') ? block_.value('L') : 1;
    if (!(count >= 1 && count <= kMostDepths) || count != std::floor(count))
      refuse("has an impossible number of depths L; correct it");
    return static_cast<int>(count);
  }

  void go_down() {
    if (!block_.has('Z')) return;
    Target down;
    down[2] = control_.target(block_)[2];
    control_.builder.feed(down, control_.feed_for(0, block_), control_.line);
  }

  /// Along half a circle out to the first, and along half a circle back from the last.
  void mill_all(const std::vector<double>& all) {
    const Vec2 first = at(all.front()), last = at(all.back());
    along(Edge::arc(center_, first, at(all.front() / 2), turn_));
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (k > 0) along(Edge::line(at(all[k - 1]), at(all[k])));
      along(Edge::arc(at(all[k]), at(-all[k]), center_, turn_));
      along(Edge::arc(at(-all[k]), at(all[k]), center_, turn_));
    }
    along(Edge::arc(last, center_, at(all.back() / 2), turn_));
  }

  void along(const Edge& edge) {
    const MmPerMin feed = control_.feed_for(edge.length(), block_);
    if (edge.is_arc())
      control_.builder.arc(edge, known(2), feed, control_.line);
    else
      control_.builder.feed({edge.to.x, edge.to.y, std::nullopt}, feed, control_.line);
  }

  /// On the line through the centre along X.
  Vec2 at(double x) const { return center_ + Vec2{x, 0}; }
  double known(std::size_t axis) const { return control_.builder.known(axis, control_.line); }
  [[noreturn]] void refuse(const std::string& what) const { control_.refuse(word_ + " " + what); }

  Control& control_;
  const Block& block_;
  std::string word_;
  Turn turn_;
  Vec2 center_;
};

}  // namespace

bool mill_circle(Control& control, const Block& block) {
  if (!has_g(block, 120) && !has_g(block, 130)) return false;
  Circles(control, block).mill();
  return true;
}

}  // namespace clearcut::read::gcode
