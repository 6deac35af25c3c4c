#include "read/lettering/lettering.h"

#include "read/common/text.h"

namespace clearcut::read {
namespace {

bool is_blank(char32_t letter) {
  return letter == U' ' || letter == U'\t' || letter == 0xA0 || (letter >= 0x2000 && letter <= 0x200F) ||
         letter == 0x202F || letter == 0x3000 || letter == 0xFEFF;
}

std::string asked_of(const FaceRequest& request) {
  std::string text;
  for (const std::string& family : request.families)
    text += (text.empty() ? "'" : ", '") + printable(family) + "'";
  if (text.empty()) text = "no family";
  return text + (request.bold ? " bold" : "") + (request.italic ? " italic" : "");
}

std::string list_of(const std::set<char32_t>& letters) {
  std::u32string text;
  for (const char32_t letter : letters) {
    constexpr std::size_t kMost = 40;
    if (text.size() >= kMost) return utf8_of(text) + " ...";
    if (!text.empty()) text += U' ';
    text += letter < 0x20 ? char32_t{0xFFFD} : letter;
  }
  return utf8_of(text);
}

}  // namespace

const Face& Lettering::face(const FaceRequest& request) {
  std::unique_ptr<Face>& face = faces_[request];
  if (!face) face = std::make_unique<Face>(request);
  return *face;
}

double Lettering::advance(const Face& face, char32_t letter) {
  if (needs_shaping(letter)) unshaped_.insert(letter);
  if (is_blank(letter) && !face.has(letter)) return face.advance(U' ');
  if (!face.has(letter)) missing_[face.file_name()].insert(letter);
  return face.advance(letter);
}

SetLine Lettering::set_line(const Face& face, std::u32string_view text) {
  SetLine line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i > 0) line.width += face.kerning(text[i - 1], text[i]);
    line.letters.push_back({text[i], line.width});
    line.width += advance(face, text[i]);
  }
  return line;
}

void Lettering::report(Diagnostics& diagnostics, const std::string& file) const {
  for (const auto& [request, face] : faces_) {
    const bool exact = (request.families.empty() || !face->family().empty()) &&
                       (!request.bold || face->is_bold()) && (!request.italic || face->is_italic());
    const std::string what =
        "text that asks for " + asked_of(request) + " is drawn with " + face->file_name();
    if (exact) {
      diagnostics.note(file, what);
    } else {
      diagnostics.warn(
          file, what + " (" + face->name() +
                    "), the nearest face installed here; install the one asked for, or turn the text into "
                    "curves in the drawing, where its looks matter");
    }
  }
  for (const auto& [face, letters] : missing_)
    diagnostics.skip(file, "letters that " + face + " has not are left out: " + list_of(letters));
  if (!unshaped_.empty()) {
    diagnostics.warn(file,
                     "letters that change with their neighbours are set one by one from left to right; turn "
                     "the text into curves in the drawing: " +
                         list_of(unshaped_));
  }
}

void TextLoops::add(const Face& face, char32_t letter, const Affine& map) {
  std::vector<Path> loops = face.outline(letter, map);
  double sum = 0;
  for (const Path& loop : loops) sum += signed_area(loop);
  for (Path& loop : loops) loops_.push_back(sum < 0 ? reversed(loop) : std::move(loop));
}

void TextLoops::add(const Face& face, const SetLine& line, const Affine& map) {
  for (const SetLetter& one : line.letters) add(face, one.letter, map * Affine::translation({one.x, 0}));
}

std::vector<RawCurve> TextLoops::take(const std::string& source, std::optional<Compound> compound) {
  std::vector<RawCurve> curves;
  for (Path& loop : loops_) curves.push_back({std::move(loop), true, source, compound});
  loops_.clear();
  return curves;
}

}  // namespace clearcut::read
