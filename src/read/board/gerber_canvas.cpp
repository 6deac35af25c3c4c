#include "read/board/gerber_canvas.h"

#include <algorithm>

#include "base/error.h"
#include "base/units.h"
#include "read/board/drawn.h"
#include "read/drawing/stroke.h"

namespace clearcut::read {
namespace {

/// Edges drawn: beyond this blocks within blocks are a trap.
constexpr std::size_t kMostEdges = 2'000'000;
constexpr std::size_t kDeepestBlocks = 50;

}  // namespace

Affine ApertureTransform::at(Vec2 place) const {
  const Affine turned = turn_deg == 0 ? Affine{} : Affine::rotation(turn_deg * kPi / 180);
  return Affine::translation(place) * turned *
         Affine::scaling(mirror_x ? -scale : scale, mirror_y ? -scale : scale);
}

void GerberCanvas::fail(const std::string& what) const {
  throw InputError(place_, what);
}

std::vector<Drawn> GerberCanvas::take() {
  finish_line();
  end_repeat();
  if (blocks_.size() != 1 || in_region_) fail("the file ends within a block; it is damaged, export it again");
  return std::move(blocks_.front().drawn);
}

void GerberCanvas::select(int number) {
  finish_line();
  const auto found = apertures_.find(number);
  if (found == apertures_.end())
    fail("aperture D" + std::to_string(number) + " is not defined; the file is damaged, export it again");
  aperture_ = &found->second;
  number_ = number;
}

const Aperture& GerberCanvas::aperture() const {
  if (!aperture_)
    fail("something is drawn before an aperture is chosen; the file is damaged, export it again");
  return *aperture_;
}

void GerberCanvas::set_dark(bool dark) {
  finish_line();
  dark_ = dark;
}

ApertureTransform& GerberCanvas::transform() {
  finish_line();
  return transform_;
}

void GerberCanvas::begin_region() {
  finish_line();
  in_region_ = true;
}

void GerberCanvas::end_region() {
  finish_contour();
  in_region_ = false;
}

void GerberCanvas::draw_to(Vec2 at, const Path& edges) {
  if (in_region_) {
    contour_.insert(contour_.end(), edges.begin(), edges.end());
    return;
  }
  aperture();
  if (edges.empty() && stroke_.empty()) dots_.push_back(at);
  stroke_.insert(stroke_.end(), edges.begin(), edges.end());
}

void GerberCanvas::lift() {
  in_region_ ? finish_contour() : finish_line();
}

void GerberCanvas::flash(Vec2 at) {
  finish_line();
  draw_again(aperture().shape, transform_.at(at), dark_);
}

void GerberCanvas::finish_contour() {
  if (contour_.empty()) return;
  const Vec2 end = contour_.back().to, begin = contour_.front().from;
  if (end != begin) contour_.push_back(Edge::line(end, begin));
  if (signed_area(contour_) < 0) contour_ = reversed(contour_);
  draw({dark_, {std::move(contour_)}, {}});
  contour_.clear();
}

/// All edges since the aperture was put down form one line.
void GerberCanvas::finish_line() {
  for (const Vec2 dot : dots_) draw_again(aperture().shape, transform_.at(dot), dark_);
  dots_.clear();
  if (stroke_.empty()) return;
  const Path line = std::move(stroke_);
  stroke_.clear();
  draw({dark_, swept(line), line});
}

std::vector<Path> GerberCanvas::swept(const Path& line) const {
  const Aperture& pen = aperture();
  if (pen.diameter && *pen.diameter == 0) return {};
  if (pen.diameter)
    return stroke_pieces({{line, false}},
                         {*pen.diameter * transform_.scale, StrokeCap::kRound, StrokeJoin::kRound});
  const bool straight =
      std::none_of(line.begin(), line.end(), [](const Edge& edge) { return edge.is_arc(); });
  if (!pen.size || !straight) {
    fail("a line is drawn with aperture D" + std::to_string(number_) + ", which is no circle" +
         (straight ? " or rectangle" : "") + "; export the layer again as RS-274X or X2");
  }
  std::vector<Path> pieces;
  const Affine map = transform_.at({});
  for (const Edge& edge : line) pieces.push_back(swept_rectangle(edge, *pen.size, map));
  return pieces;
}

void GerberCanvas::begin_repeat(const StepAndRepeat& repeat) {
  end_repeat();
  blocks_.push_back({{}, 0, repeat});
}

void GerberCanvas::end_repeat() {
  finish_line();
  if (blocks_.size() < 2 || blocks_.back().aperture != 0) return;
  const Block block = std::move(blocks_.back());
  blocks_.pop_back();
  const auto& [columns, rows, step] = block.repeat;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      draw_again(block.drawn, Affine::translation({column * step.x, row * step.y}), true);
}

void GerberCanvas::begin_aperture(int number) {
  finish_line();
  if (blocks_.size() > kDeepestBlocks) fail("blocks within blocks deeper than 50; simplify the layer");
  blocks_.push_back({{}, number, {}});
}

void GerberCanvas::end_aperture() {
  finish_line();
  if (blocks_.size() < 2 || blocks_.back().aperture == 0)
    fail("a block ends that has not begun; the file is damaged, export it again");
  apertures_[blocks_.back().aperture].shape = std::move(blocks_.back().drawn);
  blocks_.pop_back();
}

/// Drawn clear, a block's dark and clear change places.
void GerberCanvas::draw_again(const std::vector<Drawn>& all, const Affine& map, bool dark) {
  for (const Drawn& one : all) {
    Drawn copy = mapped(one, map);
    copy.dark = copy.dark == dark;
    draw(std::move(copy));
  }
}

void GerberCanvas::draw(Drawn drawn) {
  for (const Path& piece : drawn.pieces) edges_ += piece.size();
  edges_ += drawn.line.size();
  if (edges_ > kMostEdges)
    fail("more than 2 million edges are drawn, repeated blocks counted each time; simplify the layer");
  blocks_.back().drawn.push_back(std::move(drawn));
}

}  // namespace clearcut::read
