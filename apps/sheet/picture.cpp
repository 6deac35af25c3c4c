#include "picture.h"

#include <librsvg/rsvg.h>

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

}  // namespace clearcut::sheet
