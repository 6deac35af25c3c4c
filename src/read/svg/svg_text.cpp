#include "read/svg/svg_text.h"

#include <cmath>
#include <optional>
#include <pugixml.hpp>

#include "base/units.h"
#include "read/common/text.h"
#include "read/svg/svg_elements.h"

namespace clearcut::read {
namespace {

/// A letter with the placement given by its enclosing elements.
struct PlacedLetter {
  char32_t letter = 0;
  std::size_t run = 0;
  std::optional<double> x, y, dx, dy, rotate;
};

bool is_white(char32_t c) {
  return c == U' ' || c == U'\t' || c == U'\n' || c == U'\r';
}

class TextReader {
 public:
  TextReader(const SvgStyleSheet& sheet, const SvgViewSize& view, const Affine& map, Lettering& lettering)
      : sheet_(sheet), view_(view), map_(map), lettering_(lettering) {}

  SvgText read(const pugi::xml_node& text, const SvgStyle& style) {
    gather(text, style);
    if (collapsed_end_ && !letters_.empty()) letters_.pop_back();
    if (out_.problem.empty()) place();
    return std::move(out_);
  }

 private:
  void gather(const pugi::xml_node& node, const SvgStyle& style) {
    for (const std::string& property : style.font.not_applied) ++out_.not_applied[property];
    if (out_.problem.empty()) out_.problem = style.font.problem;
    if (style.font.vertical) {
      ++out_.left_out["text that runs downwards"];
      return;
    }
    const std::size_t begin = letters_.size();
    bool is_new = true;
    for (const pugi::xml_node& child : node) {
      if (child.type() == pugi::node_element) {
        is_new = true;
        gather_element(child, style);
      } else if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
        if (is_new) out_.runs.push_back({style, {}});
        is_new = false;
        append(characters_of(child.value()), style.font.keeps_space);
      }
    }
    put_lists(node, style, begin);
  }

  void gather_element(const pugi::xml_node& node, const SvgStyle& outer) {
    const std::string_view name = local_name(node);
    SvgStyle style = outer;
    apply_svg_style(node, sheet_, style);
    if (!style.shown || is_svg_definition(name)) return;
    if (name == "tspan" || name == "a") {
      gather(node, style);
    } else {
      ++out_.left_out[std::string(name)];
    }
  }

  void append(std::u32string_view text, bool keeps_space) {
    for (const char32_t c : text) {
      const bool space = is_white(c);
      if (space && !keeps_space && (collapsed_end_ || letters_.empty())) continue;
      letters_.push_back({space ? U' ' : c, out_.runs.size() - 1, {}, {}, {}, {}, {}});
      collapsed_end_ = space && !keeps_space;
    }
  }

  /// Values of an element count unless an inner element states its own.
  void put_lists(const pugi::xml_node& node, const SvgStyle& style, std::size_t begin) {
    const auto put = [&](const char* name, double whole, std::optional<double> PlacedLetter::*member) {
      const std::vector<double> values = svg_lengths(svg_text_of(node, name), whole, style.font.size);
      for (std::size_t i = 0; i < values.size() && begin + i < letters_.size(); ++i) {
        auto& value = letters_[begin + i].*member;
        if (!value) value = values[i];
      }
      return values;
    };
    put("x", view_.width, &PlacedLetter::x);
    put("y", view_.height, &PlacedLetter::y);
    put("dx", view_.width, &PlacedLetter::dx);
    put("dy", view_.height, &PlacedLetter::dy);
    const std::vector<double> turns = put("rotate", 0, &PlacedLetter::rotate);
    for (std::size_t i = begin + turns.size(); !turns.empty() && i < letters_.size(); ++i)
      letters_[i].rotate = letters_[i].rotate.value_or(turns.back());
  }

  /// Chunks begin at stated places; each is anchored as a whole.
  void place() {
    Vec2 at;
    for (std::size_t begin = 0; begin < letters_.size();) {
      std::size_t end = begin + 1;
      while (end < letters_.size() && !letters_[end].x && !letters_[end].y) ++end;
      at = {letters_[begin].x.value_or(at.x), letters_[begin].y.value_or(at.y)};
      at = place_chunk(begin, end, at);
      begin = end;
    }
  }

  Vec2 place_chunk(std::size_t begin, std::size_t end, Vec2 start) {
    std::vector<Vec2> places;
    Vec2 at = start;
    for (std::size_t i = begin; i < end; ++i) {
      const PlacedLetter& one = letters_[i];
      const SvgFont& font = out_.runs[one.run].style.font;
      const Face& face = face_of(font);
      if (i > begin && letters_[i - 1].run == one.run)
        at.x += face.kerning(letters_[i - 1].letter, one.letter) * font.size;
      at = at + Vec2{one.dx.value_or(0), one.dy.value_or(0)};
      places.push_back(at);
      const std::vector<double> spacing = svg_lengths(font.spacing, view_.width, font.size);
      at.x += lettering_.advance(face, one.letter) * font.size + (spacing.empty() ? 0 : spacing[0]);
    }
    const std::string& anchor = out_.runs[letters_[begin].run].style.font.anchor;
    const double share = anchor == "middle" ? 0.5 : anchor == "end" ? 1 : 0;
    const Vec2 shift{-(at.x - start.x) * share, 0};
    for (std::size_t i = begin; i < end; ++i) draw(letters_[i], places[i - begin] + shift);
    return at + shift;
  }

  const Face& face_of(const SvgFont& font) {
    return lettering_.face({font.families, font.bold, font.italic});
  }

  void draw(const PlacedLetter& one, Vec2 at) {
    SvgTextRun& run = out_.runs[one.run];
    const double size = run.style.font.size;
    run.loops.add(face_of(run.style.font), one.letter,
                  map_ * Affine::translation(at) * Affine::rotation(one.rotate.value_or(0) * kPi / 180) *
                      Affine::scaling(size, -size));
  }

  const SvgStyleSheet& sheet_;
  const SvgViewSize& view_;
  const Affine& map_;
  Lettering& lettering_;
  SvgText out_;
  std::vector<PlacedLetter> letters_;
  bool collapsed_end_ = false;  ///< the last letter is a blank that absorbs further blanks
};

}  // namespace

SvgText read_svg_text(const pugi::xml_node& text, const SvgStyle& style, const SvgStyleSheet& sheet,
                      const SvgViewSize& view, const Affine& map, Lettering& lettering) {
  return TextReader(sheet, view, map, lettering).read(text, style);
}

}  // namespace clearcut::read
