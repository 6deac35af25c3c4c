// A picture in SVG, drawn as vectors.
#pragma once

#include <cairo.h>

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

}  // namespace clearcut::sheet
