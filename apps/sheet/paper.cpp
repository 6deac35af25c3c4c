#include "paper.h"

#include <cairo-pdf.h>
#include <librsvg/rsvg.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace clearcut::sheet {
namespace {

[[noreturn]] void fail(GError* error) {
  const std::string what = error == nullptr ? "unknown" : error->message;
  g_clear_error(&error);
  throw std::runtime_error("the picture of the part cannot be drawn: " + what);
}

RsvgHandle* handle_of(const std::string& svg) {
  GError* error = nullptr;
  GInputStream* bytes =
      g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr);
  // Paths of large parts exceed the limits for untrusted input.
  RsvgHandle* handle =
      rsvg_handle_new_from_stream_sync(bytes, nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error);
  g_object_unref(bytes);
  if (handle == nullptr) fail(error);
  return handle;
}

}  // namespace

struct Picture::Loaded {
  explicit Loaded(RsvgHandle* loaded) : handle(loaded) {}
  Loaded(const Loaded&) = delete;
  Loaded& operator=(const Loaded&) = delete;
  ~Loaded() { g_object_unref(handle); }
  RsvgHandle* handle;
};

Picture::Picture(const std::string& svg) : loaded_(new Loaded{handle_of(svg)}) {
  // As on the HTML page, with the same letters.
  constexpr std::string_view kStyle = "svg { font-family: sans-serif; }";
  GError* error = nullptr;
  if (rsvg_handle_set_stylesheet(loaded_->handle, reinterpret_cast<const guint8*>(kStyle.data()),
                                 kStyle.size(), &error) == FALSE)
    fail(error);
}

Picture::~Picture() = default;

double Picture::aspect() const {
  gboolean has_width = FALSE, has_height = FALSE, has_box = FALSE;
  RsvgLength width, height;
  RsvgRectangle box{0, 0, 1, 1};
  rsvg_handle_get_intrinsic_dimensions(loaded_->handle, &has_width, &width, &has_height, &height, &has_box,
                                       &box);
  return has_box != FALSE && box.width > 0 && box.height > 0 ? box.width / box.height : 1;
}

void Picture::draw(cairo_t* cairo, double x, double y, double width, double height) const {
  GError* error = nullptr;
  const RsvgRectangle place{x, y, width, height};
  if (rsvg_handle_render_document(loaded_->handle, cairo, &place, &error) == FALSE) fail(error);
}

namespace {

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int count) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), count);
  return CAIRO_STATUS_SUCCESS;
}

/// Letters are placed for paper, not on the pixels of a screen.
PangoLayout* layout_for(cairo_t* cairo) {
  PangoLayout* layout = pango_cairo_create_layout(cairo);
  PangoContext* context = pango_layout_get_context(layout);
  pango_cairo_context_set_resolution(context, 72);
  pango_context_set_round_glyph_positions(context, FALSE);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options(context, options);
  cairo_font_options_destroy(options);
  // Figures have equal width in every font with this feature; divided file names get no hyphen.
  PangoAttrList* attributes = pango_attr_list_new();
  pango_attr_list_insert(attributes, pango_attr_insert_hyphens_new(FALSE));
  pango_attr_list_insert(attributes, pango_attr_font_features_new("tnum=1"));
  pango_layout_set_attributes(layout, attributes);
  pango_attr_list_unref(attributes);
  pango_layout_context_changed(layout);
  return layout;
}

/// Line ends as spaces, as in HTML.
std::string in_one_paragraph(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char letter) { return letter < ' '; }, ' ');
  return text;
}

double points(int units) {
  return static_cast<double>(units) / PANGO_SCALE;
}

}  // namespace

bool has_fonts() {
  PangoFontMap* map = pango_cairo_font_map_get_default();
  PangoContext* context = pango_font_map_create_context(map);
  PangoFontDescription* wanted = pango_font_description_from_string("sans 10");
  PangoFont* font = pango_font_map_load_font(map, context, wanted);
  pango_font_description_free(wanted);
  g_object_unref(context);
  if (font == nullptr) return false;
  g_object_unref(font);
  return true;
}

Paper::Paper(const std::string& title, bool is_trial)
    : is_trial_(is_trial),
      surface_(cairo_pdf_surface_create_for_stream(append, &bytes_, kPaperWidth, kPaperHeight)),
      cairo_(cairo_create(surface_)),
      layout_(layout_for(cairo_)) {
  cairo_pdf_surface_set_metadata(surface_, CAIRO_PDF_METADATA_TITLE, in_one_paragraph(title).c_str());
  // Date of creation: without one equal sheets give equal bytes.
  cairo_pdf_surface_set_metadata(surface_, CAIRO_PDF_METADATA_CREATE_DATE, "");
}

Paper::~Paper() {
  g_object_unref(layout_);
  cairo_destroy(cairo_);
  cairo_surface_destroy(surface_);
}

void Paper::set(const std::string& text, const Style& style, double width, int most_lines) {
  PangoFontDescription* font = pango_font_description_new();
  pango_font_description_set_family(font, "sans");
  pango_font_description_set_size(font, static_cast<int>(style.size * PANGO_SCALE));
  pango_font_description_set_weight(font, style.is_bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
  pango_layout_set_font_description(layout_, font);
  pango_font_description_free(font);
  pango_layout_set_alignment(layout_, style.side);
  pango_layout_set_wrap(layout_, width > 0 ? PANGO_WRAP_WORD_CHAR : PANGO_WRAP_WORD);
  pango_layout_set_width(layout_, width < 0 ? -1 : static_cast<int>(width * PANGO_SCALE));
  pango_layout_set_height(layout_, -most_lines);
  pango_layout_set_ellipsize(layout_, width > 0 ? PANGO_ELLIPSIZE_END : PANGO_ELLIPSIZE_NONE);
  pango_layout_set_text(layout_, in_one_paragraph(text).c_str(), -1);
}

void Paper::set_colour(std::uint32_t colour) {
  const auto part = [&](unsigned shift) { return ((colour >> shift) & 0xffU) / 255.0; };
  cairo_set_source_rgb(cairo_, part(16), part(8), part(0));
}

double Paper::width(const std::string& text, const Style& style) {
  set(text, style, -1);
  int width = 0;
  pango_layout_get_size(layout_, &width, nullptr);
  return points(width);
}

double Paper::widest_word(const std::string& text, const Style& style) {
  set(text, style, 0);
  int width = 0;
  pango_layout_get_size(layout_, &width, nullptr);
  return points(width);
}

double Paper::height(const std::string& text, double width, const Style& style) {
  set(text, style, width);
  int height = 0;
  pango_layout_get_size(layout_, nullptr, &height);
  return points(height);
}

double Paper::text(const std::string& text, const Column& column, double y, const Style& style) {
  set(text, style, column.width, column.most_lines);
  int height = 0;
  pango_layout_get_size(layout_, nullptr, &height);
  if (!is_trial_) {
    set_colour(style.colour);
    cairo_move_to(cairo_, column.x, y);
    pango_cairo_show_layout(cairo_, layout_);
  }
  return points(height);
}

void Paper::line(double x, double to_x, double y, double thickness, std::uint32_t colour) {
  if (is_trial_) return;
  set_colour(colour);
  cairo_set_line_width(cairo_, thickness);
  cairo_move_to(cairo_, x, y);
  cairo_line_to(cairo_, to_x, y);
  cairo_stroke(cairo_);
}

void Paper::picture(const Picture& picture, double x, double y, double width, double height) {
  if (!is_trial_) picture.draw(cairo_, x, y, width, height);
}

void Paper::end_page() {
  if (!is_trial_) cairo_show_page(cairo_);
}

std::string Paper::finish() {
  cairo_surface_finish(surface_);
  const cairo_status_t status = cairo_surface_status(surface_);
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("its pages cannot be drawn: ") + cairo_status_to_string(status));
  return bytes_;
}

}  // namespace clearcut::sheet
