// Pages of A4 in a PDF, with text, lines and pictures at places of theirs, pictures being SVG drawn as vectors.
// Points (1/72 inch), y down.
#pragma once

#include <cairo.h>
#include <pango/pango.h>

#include <cstdint>
#include <memory>
#include <string>

namespace clearcut::sheet {

class Picture {
 public:
  /// Throws std::runtime_error for anything other than SVG.
  explicit Picture(const std::string& svg);
  ~Picture();
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  /// Width by height.
  double aspect() const;
  /// Fills the rectangle as far as the aspect ratio allows.
  void draw(cairo_t* cairo, double x, double y, double width, double height) const;

 private:
  struct Loaded;
  std::unique_ptr<Loaded> loaded_;
};

inline constexpr double kPaperWidth = 210 / 25.4 * 72, kPaperHeight = 297 / 25.4 * 72;

struct Style {
  double size = 0;
  std::uint32_t colour = 0x1c2733;  ///< red, green, blue
  bool is_bold = false;
  PangoAlignment side = PANGO_ALIGN_LEFT;
};

/// Column for text: width, and greatest number of lines.
struct Column {
  double x = 0, width = 0;
  int most_lines = 60;  ///< of a page; longer text ends in dots
};

class Paper {
 public:
  /// `title`: title of the document. A trial measures and draws nothing.
  explicit Paper(const std::string& title, bool is_trial = false);
  ~Paper();
  Paper(const Paper&) = delete;
  Paper& operator=(const Paper&) = delete;

  /// Width of one line of text.
  double width(const std::string& text, const Style& style);
  /// Width of the widest piece without a possible line end.
  double widest_word(const std::string& text, const Style& style);
  double height(const std::string& text, double width, const Style& style);

  /// Draws text wrapped to the column's width with its top at `y`; returns its height.
  double text(const std::string& text, const Column& column, double y, const Style& style);
  void line(double x, double to_x, double y, double thickness, std::uint32_t colour);
  void picture(const Picture& picture, double x, double y, double width, double height);
  void end_page();

  /// The document; nothing can be drawn any more.
  std::string finish();

 private:
  void set(const std::string& text, const Style& style, double width, int most_lines = 60);
  void set_colour(std::uint32_t colour);

  bool is_trial_;
  std::string bytes_;
  cairo_surface_t* surface_;
  cairo_t* cairo_;
  PangoLayout* layout_;
};

/// Whether any font is installed.
bool has_fonts();

}  // namespace clearcut::sheet
