#include "read/dxf/dxf_text.h"

#include <algorithm>

#include "base/elementary.h"
#include "base/units.h"
#include "read/dxf/dxf_curves.h"
#include "read/dxf/dxf_style.h"

namespace clearcut::read {
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
