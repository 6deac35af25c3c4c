#include "read/dxf/dxf_text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/elementary.h"
#include "base/text.h"
#include "base/units.h"
#include "read/common/text.h"
#include "read/dxf/dxf_curves.h"

namespace clearcut::read {
namespace {

/// The value of `digits`, all of them of `base`; nothing else.
std::optional<char32_t> value_of(std::u32string_view digits, char32_t base) {
  char32_t value = 0;
  for (const char32_t c : digits) {
    const char32_t digit = c >= U'0' && c <= U'9'   ? c - U'0'
                           : c >= U'A' && c <= U'F' ? c - U'A' + 10
                           : c >= U'a' && c <= U'f' ? c - U'a' + 10
                                                    : base;
    if (digit >= base) return std::nullopt;
    value = value * base + digit;
  }
  return digits.empty() ? std::nullopt : std::optional(value);
}

class CodeReader {
 public:
  CodeReader(std::string_view text, bool formatted) : text_(characters_of(text)), formatted_(formatted) {
    words_.paragraphs.emplace_back();
  }

  DxfWords read() {
    while (at_ < text_.size()) {
      const char32_t c = text_[at_];
      if (c == U'%' && rest().starts_with(U"%%") && at_ + 2 < text_.size()) {
        percent_code();
      } else if (c == U'^' && at_ + 1 < text_.size()) {
        caret_code();
      } else if (c == U'\\' && unicode_code()) {
        continue;
      } else if (formatted_ && c == U'\\' && at_ + 1 < text_.size()) {
        format_code();
      } else if (formatted_ && (c == U'{' || c == U'}')) {
        ++at_;
      } else {
        put(c);
        ++at_;
      }
    }
    return std::move(words_);
  }

 private:
  std::u32string_view rest() const { return std::u32string_view(text_).substr(at_); }

  void put(char32_t c) {
    words_.paragraphs.back() += c;
    begun_ = true;
  }

  void percent_code() {
    const char32_t c = text_[at_ + 2];
    const auto number = value_of(rest().substr(2, 3), 10);
    if (number && rest().size() >= 5) {
      put(*number);
      at_ += 5;
      return;
    }
    at_ += 3;
    if (c == U'c' || c == U'C') return put(U'\u00D8');
    if (c == U'd' || c == U'D') return put(U'\u00B0');
    if (c == U'p' || c == U'P') return put(U'\u00B1');
    if (std::u32string_view(U"uUoOkK").find(c) != std::u32string_view::npos) {
      words_.ignored.insert("%%" + utf8_of({&c, 1}));
    } else {
      put(c);
    }
  }

  void caret_code() {
    const char32_t c = text_[at_ + 1];
    at_ += 2;
    if (c == U' ') return put(U'^');
    if (c == U'I') return put(U' ');
    if (c == U'J') return words_.paragraphs.emplace_back(), void();
    if (c == U'M') return;
    put(U'^');
    --at_;
  }

  /// \U+XXXX, in every text.
  bool unicode_code() {
    if (!rest().starts_with(U"\\U+") && !rest().starts_with(U"\\u+")) return false;
    const auto letter = value_of(rest().substr(3, 4), 16);
    if (!letter || rest().size() < 7) return false;
    put(*letter);
    at_ += 7;
    return true;
  }

  void format_code() {
    constexpr std::u32string_view kWithValue = U"fFHACcWTQpS";
    const char32_t c = text_[at_ + 1];
    at_ += 2;
    if (kWithValue.find(c) != std::u32string_view::npos) {
      const std::size_t end = std::min(text_.find(U';', at_), text_.size());
      const std::u32string value = text_.substr(at_, end - at_);
      at_ = std::min(end + 1, text_.size());
      value_code(c, value);
    } else if (c == U'P' || c == U'N') {
      words_.paragraphs.emplace_back();
    } else if (c == U'~') {
      put(U'\u00A0');
    } else if (std::u32string_view(U"LOK").find(c) != std::u32string_view::npos) {
      words_.ignored.insert("\\" + utf8_of({&c, 1}));
    } else if (std::u32string_view(U"lok").find(c) == std::u32string_view::npos) {
      put(c);
    }
  }

  void value_code(char32_t c, const std::u32string& value) {
    if (c == U'S') {
      for (const char32_t one : value) put(one == U'^' || one == U'#' ? U'/' : one);
    } else if ((c == U'f' || c == U'F') && !begun_) {
      return font(utf8_of(value));
    } else if (c == U'H' && !begun_) {
      return height(utf8_of(value));
    } else if (c == U'A' || c == U'C' || c == U'c') {
      return;  // colours, and the alignment of stacked fractions
    }
    words_.ignored.insert("\\" + utf8_of({&c, 1}));
  }

  /// "Arial|b1|i0|c0|p34"; "txt,bigfont".
  void font(const std::string& value) {
    const std::vector<std::string> parts = split(value, '|');
    words_.font = split(parts.front(), ',').front();
    for (const std::string& part : parts) {
      if (part == "b1") words_.bold = true;
      if (part == "i1") words_.italic = true;
    }
  }

  void height(std::string value) {
    const bool relative = !value.empty() && (value.back() == 'x' || value.back() == 'X');
    if (relative) value.pop_back();
    const auto number = plain_number(value);
    if (number && *number > 0) (relative ? words_.height_factor : words_.height) = *number;
  }

  std::u32string text_;
  bool formatted_;
  std::size_t at_ = 0;
  bool begun_ = false;
  DxfWords words_;
};

}  // namespace

DxfWords words_of_text(std::string_view text) {
  return CodeReader(text, false).read();
}

DxfWords words_of_mtext(std::string_view text) {
  return CodeReader(text, true).read();
}

namespace {

/// Families by the beginning of their file names in Windows, followed by "", "b" or "bd", "i", "bi" or "z".
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kFiles{{{"ARIAL", "Arial"},
                                                                                {"TIMES", "Times New Roman"},
                                                                                {"COUR", "Courier New"},
                                                                                {"CALIBRI", "Calibri"},
                                                                                {"VERDANA", "Verdana"},
                                                                                {"TAHOMA", "Tahoma"},
                                                                                {"SEGOEUI", "Segoe UI"},
                                                                                {"GEORGIA", "Georgia"},
                                                                                {"TREBUC", "Trebuchet MS"},
                                                                                {"COMIC", "Comic Sans MS"},
                                                                                {"CONSOLA", "Consolas"},
                                                                                {"IMPACT", "Impact"}}};

/// The family of a font file of Windows.
std::optional<FaceRequest> face_of_file(std::string_view stem) {
  for (const auto& [start, family] : kFiles) {
    if (!stem.starts_with(start)) continue;
    const std::string_view rest = stem.substr(start.size());
    const bool both = rest == "BI" || rest == "Z";
    const bool bold = both || rest == "B" || rest == "BD", italic = both || rest == "I";
    if (rest.empty() || bold || italic) return FaceRequest{{std::string(family)}, bold, italic};
  }
  return std::nullopt;
}

/// AutoCAD's data of fonts other than SHX: the family, and whether it is bold or italic.
std::optional<FaceRequest> told_face(const DxfDocument& document, const DxfEntity& style) {
  constexpr int kItalic = 1 << 24, kBold = 1 << 25;
  bool ours = false;
  FaceRequest face;
  for (const DxfGroup& group : style.groups) {
    if (group.code == 1001) ours = capitals(group.value) == "ACAD";
    if (ours && group.code == 1000 && face.families.empty() && !group.value.empty())
      face.families.push_back(utf8_of(characters_of(group.value)));
    if (ours && group.code == 1071) {
      const auto flags = static_cast<int>(document.number(group));
      face.bold = flags & kBold, face.italic = flags & kItalic;
    }
  }
  return face.families.empty() ? std::nullopt : std::optional(face);
}

}  // namespace

FaceRequest face_of_font(std::string name) {
  name = utf8_of(characters_of(stripped(name)));
  if (const std::size_t slash = name.find_last_of("/\\"); slash != std::string::npos)
    name.erase(0, slash + 1);
  const std::string large = capitals(name);
  if (!large.ends_with(".TTF") && !large.ends_with(".OTF") && !large.ends_with(".TTC"))
    return name.empty() ? FaceRequest{} : FaceRequest{{name}};
  if (auto face = face_of_file(std::string_view(large).substr(0, large.size() - 4))) return *face;
  // "LiberationSans-BoldItalic": fontconfig compares families without blanks.
  const std::size_t dash = std::min(name.find('-'), name.size() - 4);
  const std::string_view rest = std::string_view(large).substr(dash);
  return {{name.substr(0, dash)},
          rest.find("BOLD") != std::string_view::npos,
          rest.find("ITALIC") != std::string_view::npos || rest.find("OBLIQUE") != std::string_view::npos};
}

DxfTextStyle style_of(const DxfDocument& document, const DxfEntity& entity) {
  const auto found = document.styles.find(capitals(entity.text(7, "STANDARD")));
  if (found == document.styles.end()) return {};
  const DxfEntity& style = found->second;
  DxfTextStyle out;
  out.face = told_face(document, style).value_or(face_of_font(std::string(style.text(3))));
  if (const double factor = document.number(style, 41, 1); factor > 0) out.width_factor = factor;
  out.oblique = Radians::of_degrees(document.number(style, 50, 0)).radians();
  return out;
}

namespace {

/// Radians; the file has degrees.
double angle_at(const DxfDocument& document, const DxfEntity& entity, int code) {
  return Radians::of_degrees(document.number(entity, code, 0)).radians();
}

Affine sheared(double angle) {
  return {1, 0, base::tan(angle), 1, 0, 0};
}

/// The groups before "Embedded Object", after which the codes are repeated with other meanings.
DxfEntity own_groups(DxfEntity entity) {
  const auto end = std::find_if(entity.groups.begin(), entity.groups.end(),
                                [](const DxfGroup& group) { return group.code == 101; });
  entity.groups.erase(end, entity.groups.end());
  return entity;
}

/// Justification of TEXT.
enum Across { kLeft, kCentre, kRight, kAligned, kMiddle, kFit };
enum Along { kBaseline, kBottom, kHalf, kTop };

/// The place in the line at the point of alignment, em.
Vec2 held(const Face& face, double width, int across, int along) {
  const double cap = face.cap_height(), below = std::max(face.bottom_of(U'p'), 0.0);
  Vec2 at;
  if (across == kCentre || across == kMiddle) at.x = width / 2;
  if (across == kRight) at.x = width;
  if (along == kBottom) at.y = -below;
  if (along == kHalf) at.y = cap / 2;
  if (along == kTop) at.y = cap;
  if (across == kMiddle) at.y = (cap - below) / 2;
  return at;
}

/// From the text's own axes to the drawing's. The point and direction of an MTEXT are of the drawing, not of its own
/// coordinates.
Affine mtext_axes(const DxfDocument& document, const DxfEntity& entity, bool from_below) {
  Vec2 along = direction_of(angle_at(document, entity, 50));
  if (from_below) along.x = -along.x;
  if (entity.find(11)) along = {document.number(entity, 11, 1), document.number(entity, 21, 0)};
  if (!(norm(along) > 0)) document.fail(entity.line, "a text without direction; correct the file");
  along = along / norm(along);
  const Vec2 up = from_below ? -left_of(along) : left_of(along), at = document.point(entity, 10);
  return {along.x, along.y, up.x, up.y, at.x, at.y};
}

/// Reflection of text written backwards or upside down.
Affine flip_of(const DxfDocument& document, const DxfEntity& entity) {
  constexpr int kBackward = 2, kUpsideDown = 4;
  const int mirrored = document.integer(entity, 71, 0);
  return Affine::scaling(mirrored & kBackward ? -1 : 1, mirrored & kUpsideDown ? -1 : 1);
}

/// The style with the first font named in the text itself.
DxfTextStyle mtext_style(const DxfDocument& document, const DxfEntity& entity, const DxfWords& words) {
  DxfTextStyle style = style_of(document, entity);
  if (!words.font) return style;
  style.face = face_of_font(*words.font);
  style.face.bold = style.face.bold || words.bold;
  style.face.italic = style.face.italic || words.italic;
  return style;
}

}  // namespace

bool is_text(std::string_view dxf_type) {
  return dxf_type == "TEXT" || dxf_type == "ATTRIB" || dxf_type == "MTEXT";
}

double DxfLettering::height_of(const DxfEntity& entity) const {
  const double height = document_.required(entity, 40);
  if (!(height > 0)) document_.fail(entity.line, "a text without height; correct the file");
  return height;
}

std::optional<std::vector<RawCurve>> DxfLettering::letters_of(const DxfEntity& entity, const Affine& map,
                                                              Compound compound) {
  const auto own = entity_map(document_, entity);
  if (!own) return std::nullopt;
  TextLoops loops =
      entity.type == "MTEXT" ? mtext(own_groups(entity), map, own->mirrors()) : text(entity, map * *own);
  return loops.take(std::string(entity.type) + " at line " + std::to_string(entity.line), compound);
}

TextLoops DxfLettering::text(const DxfEntity& entity, const Affine& map) {
  const DxfWords words = words_of_text(entity.text(1));
  for (const std::string& code : words.ignored) ++ignored_[code];
  const Face& face = lettering_.face(style_of(document_, entity).face);
  const SetLine line = lettering_.set_line(face, words.paragraphs.front());
  const int across = document_.integer(entity, 72, 0),
            along = document_.integer(entity, entity.type == "ATTRIB" ? 74 : 73, 0);
  const bool between = across == kAligned || across == kFit;
  const bool has_second = entity.find(11) && entity.find(21);
  Vec2 at = document_.point(entity, (across != 0 || along != 0) && has_second && !between ? 11 : 10);
  double turn = angle_at(document_, entity, 50);
  double size = height_of(entity) / face.cap_height();  // size of an em
  double stretch = document_.number(entity, 41, 1);
  if (!(stretch > 0)) stretch = 1;
  if (between && has_second && line.width > 0) {
    const Vec2 way = document_.point(entity, 11) - at;
    if (norm(way) > 0) {
      turn = angle_of(way);
      (across == kAligned ? size : stretch) =
          norm(way) / (line.width * (across == kAligned ? stretch : size));
    }
  }
  TextLoops loops;
  loops.add(face, line,
            map * Affine::translation(at) * Affine::rotation(turn) * flip_of(document_, entity) *
                sheared(angle_at(document_, entity, 51)) * Affine::scaling(size * stretch, size) *
                Affine::translation(-held(face, line.width, across, along)));
  return loops;
}

std::vector<SetLine> DxfLettering::wrapped(const Face& face, const DxfWords& words, double width) {
  std::vector<SetLine> lines;
  for (const std::u32string& paragraph : words.paragraphs) {
    std::u32string line;
    double so_far = 0;
    for (std::size_t at = 0; at <= paragraph.size();) {
      const std::size_t end = std::min(paragraph.find(U' ', at), paragraph.size());
      const std::u32string word = paragraph.substr(at, end - at);
      const double more = lettering_.set_line(face, word).width, blank = at == 0 ? 0 : face.advance(U' ');
      if (width > 0 && at > 0 && so_far + blank + more > width) {
        lines.push_back(lettering_.set_line(face, line));
        line = word;
        so_far = more;
      } else {
        line += (at == 0 ? U"" : U" ") + word;
        so_far += blank + more;
      }
      at = end + 1;
    }
    lines.push_back(lettering_.set_line(face, line));
  }
  return lines;
}

TextLoops DxfLettering::mtext(const DxfEntity& entity, const Affine& map, bool from_below) {
  std::string whole;
  for (const int code : {3, 1})
    for (const DxfGroup& group : entity.groups)
      if (group.code == code) whole += group.value;
  const DxfWords words = words_of_mtext(whole);
  for (const std::string& code : words.ignored) ++ignored_[code];
  const DxfTextStyle style = mtext_style(document_, entity, words);
  const Face& face = lettering_.face(style.face);
  const double height = words.height.value_or(height_of(entity) * words.height_factor.value_or(1));
  const double size = height / face.cap_height();
  const double em = size * style.width_factor;  // along the line
  const std::vector<SetLine> lines = wrapped(face, words, document_.number(entity, 41, 0) / em);

  const Affine axes = map * mtext_axes(document_, entity, from_below);
  constexpr double kSpacing = 5.0 / 3;
  const double factor = document_.number(entity, 44, 1);
  const double step = height * kSpacing * (factor > 0 ? factor : 1);
  const double total = height + step * static_cast<double>(lines.size() - 1);
  const int attached = std::clamp(document_.integer(entity, 71, 1), 1, 9) - 1;
  const int row = attached / 3;
  double y = total * row / 2 - height;
  TextLoops loops;
  for (const SetLine& line : lines) {
    const double x = -line.width * em * (attached % 3) / 2;
    loops.add(face, line,
              axes * Affine::translation({x, y}) * sheared(style.oblique) * Affine::scaling(em, size));
    y -= step;
  }
  return loops;
}

void DxfLettering::report(Diagnostics& diagnostics) const {
  lettering_.report(diagnostics, document_.file);
  report_left_out(diagnostics, document_.file, ignored_,
                  "codes within texts that are not followed (the letters are drawn without):");
}

}  // namespace clearcut::read
