#include "read/lettering/face.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>

#include <algorithm>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "base/error.h"
#include "read/common/curve_fit.h"
#include "read/common/text.h"

namespace clearcut::read {
namespace {

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using Configuration = std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)>;

std::string string_of(const Pattern& pattern, const char* object, int index = 0) {
  FcChar8* value = nullptr;
  if (FcPatternGetString(pattern.get(), object, index, &value) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(value);
}

int integer_of(const Pattern& pattern, const char* object, int otherwise) {
  int value = otherwise;
  return FcPatternGetInteger(pattern.get(), object, 0, &value) == FcResultMatch ? value : otherwise;
}

Pattern pattern_of(const FaceRequest& request) {
  Pattern pattern(FcPatternCreate(), FcPatternDestroy);
  for (const std::string& family : request.families) {
    FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
  }
  FcPatternAddInteger(pattern.get(), FC_WEIGHT, request.bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
  FcPatternAddInteger(pattern.get(), FC_SLANT, request.italic ? FC_SLANT_ITALIC : FC_SLANT_ROMAN);
  FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
  FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
  FcPatternAddBool(pattern.get(), FC_VARIABLE, FcFalse);
  return pattern;
}

/// A name in the form compared by fontconfig: without blanks, in any case.
std::string compared(const std::string& name) {
  std::string out = capitals(name);
  out.erase(std::remove(out.begin(), out.end(), ' '), out.end());
  return out;
}

bool is_generic(const std::string& family) {
  for (const char* name : {"SERIF", "SANS-SERIF", "SANS", "MONOSPACE", "CURSIVE", "FANTASY", "SYSTEM-UI"})
    if (compared(family) == name) return true;
  return false;
}

/// The first requested family equal to one of the face's names; any substitute for a generic family counts.
std::string asked_family(const Pattern& found, const std::vector<std::string>& families) {
  for (const std::string& family : families) {
    if (is_generic(family)) return family;
    for (int i = 0;; ++i) {
      const std::string name = string_of(found, FC_FAMILY, i);
      if (name.empty()) break;
      if (compared(name) == compared(family)) return family;
    }
  }
  return {};
}

/// The nearest installed face.
Pattern found_face(const FaceRequest& request) {
  const Configuration configuration(FcInitLoadConfigAndFonts(), FcConfigDestroy);
  const Pattern pattern = pattern_of(request);
  FcConfigSubstitute(configuration.get(), pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result = FcResultNoMatch;
  Pattern found(FcFontMatch(configuration.get(), pattern.get(), &result), FcPatternDestroy);
  if (!found || string_of(found, FC_FILE).empty()) {
    throw InputError("--text outlines",
                     "no font is installed; install one (fonts-dejavu-core), or turn the text into curves "
                     "in the drawing");
  }
  return found;
}

/// The pieces of one letter's outline as FreeType gives them, fitted one by one.
struct OutlinePen {
  Affine map;  ///< font units to mm
  std::vector<Path> loops;
  Vec2 start, at;

  Vec2 mapped(const FT_Vector* v) const {
    return map({static_cast<double>(v->x), static_cast<double>(v->y)});
  }
  void line_to(Vec2 to) {
    if (to != at) loops.back().push_back(Edge::line(at, to));
    at = to;
  }
  void close() {
    if (!loops.empty()) line_to(start);
  }
  void begin(Vec2 p) {
    close();
    loops.emplace_back();
    start = at = p;
  }
  void cubic_to(Vec2 b, Vec2 c, Vec2 to) {
    const Vec2 a = at;
    append_fitted(
        [=](double t) {
          const double s = 1 - t;
          return t >= 1 ? to : a * (s * s * s) + b * (3 * s * s * t) + c * (3 * s * t * t) + to * (t * t * t);
        },
        kCurveTolerance, loops.back());
    at = to;
  }
  void conic_to(Vec2 b, Vec2 to) {
    const Vec2 a = at;
    append_fitted(
        [=](double t) {
          const double s = 1 - t;
          return t >= 1 ? to : a * (s * s) + b * (2 * s * t) + to * (t * t);
        },
        kCurveTolerance, loops.back());
    at = to;
  }
};

OutlinePen& pen_of(void* user) {
  return *static_cast<OutlinePen*>(user);
}

const FT_Outline_Funcs kPenFunctions = {
    [](const FT_Vector* to, void* user) { return pen_of(user).begin(pen_of(user).mapped(to)), 0; },
    [](const FT_Vector* to, void* user) { return pen_of(user).line_to(pen_of(user).mapped(to)), 0; },
    [](const FT_Vector* b, const FT_Vector* to, void* user) {
      return pen_of(user).conic_to(pen_of(user).mapped(b), pen_of(user).mapped(to)), 0;
    },
    [](const FT_Vector* b, const FT_Vector* c, const FT_Vector* to, void* user) {
      return pen_of(user).cubic_to(pen_of(user).mapped(b), pen_of(user).mapped(c), pen_of(user).mapped(to)),
             0;
    },
    0,
    0};

}  // namespace

struct Face::Loaded {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  std::string file, name, family;
  bool bold = false, italic = false;
  double unit = 1;  ///< em per font unit

  ~Loaded() {
    if (face) FT_Done_Face(face);
    if (library) FT_Done_FreeType(library);
  }
  Loaded() = default;
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;

  bool load(char32_t letter) const {
    const FT_UInt glyph = FT_Get_Char_Index(face, letter);
    return glyph != 0 && FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) == 0;
  }
};

Face::Face(const FaceRequest& request) : loaded_(std::make_unique<Loaded>()) {
  const Pattern found = found_face(request);
  const std::string path = string_of(found, FC_FILE);
  loaded_->file = path.substr(path.find_last_of('/') + 1);
  loaded_->name = string_of(found, FC_FAMILY) + " " + string_of(found, FC_STYLE);
  loaded_->family = asked_family(found, request.families);
  loaded_->bold = integer_of(found, FC_WEIGHT, FC_WEIGHT_REGULAR) >= FC_WEIGHT_DEMIBOLD;
  loaded_->italic = integer_of(found, FC_SLANT, FC_SLANT_ROMAN) != FC_SLANT_ROMAN;
  const bool opened =
      FT_Init_FreeType(&loaded_->library) == 0 &&
      FT_New_Face(loaded_->library, path.c_str(), integer_of(found, FC_INDEX, 0), &loaded_->face) == 0 &&
      FT_IS_SCALABLE(loaded_->face) && loaded_->face->units_per_EM > 0;
  if (!opened) {
    throw InputError("--text outlines", "the font " + loaded_->file +
                                            " cannot be read; install another one, or turn the text into "
                                            "curves in the drawing");
  }
  FT_Select_Charmap(loaded_->face, FT_ENCODING_UNICODE);
  loaded_->unit = 1.0 / loaded_->face->units_per_EM;
}

Face::~Face() = default;

const std::string& Face::file_name() const {
  return loaded_->file;
}
const std::string& Face::name() const {
  return loaded_->name;
}
const std::string& Face::family() const {
  return loaded_->family;
}
bool Face::is_bold() const {
  return loaded_->bold;
}
bool Face::is_italic() const {
  return loaded_->italic;
}

bool Face::has(char32_t letter) const {
  return FT_Get_Char_Index(loaded_->face, letter) != 0;
}

double Face::advance(char32_t letter) const {
  return loaded_->load(letter)
             ? static_cast<double>(loaded_->face->glyph->metrics.horiAdvance) * loaded_->unit
             : 0;
}

double Face::kerning(char32_t left, char32_t right) const {
  FT_Vector by{};
  if (!FT_HAS_KERNING(loaded_->face)) return 0;
  FT_Get_Kerning(loaded_->face, FT_Get_Char_Index(loaded_->face, left),
                 FT_Get_Char_Index(loaded_->face, right), FT_KERNING_UNSCALED, &by);
  return static_cast<double>(by.x) * loaded_->unit;
}

double Face::top_of(char32_t letter) const {
  if (!loaded_->load(letter)) return 0;
  return static_cast<double>(loaded_->face->glyph->metrics.horiBearingY) * loaded_->unit;
}

double Face::bottom_of(char32_t letter) const {
  if (!loaded_->load(letter)) return 0;
  const FT_Glyph_Metrics& metrics = loaded_->face->glyph->metrics;
  return static_cast<double>(metrics.height - metrics.horiBearingY) * loaded_->unit;
}

double Face::cap_height() const {
  constexpr double kUsual = 0.7;
  const double height = top_of(U'H');
  return height > 0 ? height : kUsual;
}

std::vector<Path> Face::outline(char32_t letter, const Affine& map) const {
  if (!loaded_->load(letter)) return {};
  OutlinePen pen{map * Affine::scaling(loaded_->unit, loaded_->unit), {}, {}, {}};
  FT_Outline_Decompose(&loaded_->face->glyph->outline, &kPenFunctions, &pen);
  pen.close();
  pen.loops.erase(
      std::remove_if(pen.loops.begin(), pen.loops.end(), [](const Path& loop) { return loop.size() < 2; }),
      pen.loops.end());
  return std::move(pen.loops);
}

}  // namespace clearcut::read
