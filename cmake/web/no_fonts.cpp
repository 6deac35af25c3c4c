// Stands in for src/read/lettering/face.cpp where fontconfig or FreeType are absent: a page, Windows, a build without them.
#include "base/error.h"
#include "read/lettering/face.h"

namespace clearcut::read {

struct Face::Loaded {
  std::string text;
};

Face::Face(const FaceRequest& /*request*/) {
  throw InputError(
      "--text outlines",
      "no fonts can be read here, in a page, on Windows or in a build without libfontconfig-dev and "
      "libfreetype-dev; turn the text into curves in the drawing, or plan with a clearcut that has them");
}
Face::~Face() = default;

const std::string& Face::file_name() const {
  return loaded_->text;
}
const std::string& Face::name() const {
  return loaded_->text;
}
const std::string& Face::family() const {
  return loaded_->text;
}
bool Face::is_bold() const {
  return false;
}
bool Face::is_italic() const {
  return false;
}
bool Face::has(char32_t /*letter*/) const {
  return false;
}
double Face::advance(char32_t /*letter*/) const {
  return 0;
}
double Face::kerning(char32_t /*left*/, char32_t /*right*/) const {
  return 0;
}
double Face::top_of(char32_t /*letter*/) const {
  return 0;
}
double Face::bottom_of(char32_t /*letter*/) const {
  return 0;
}
double Face::cap_height() const {
  return 0;
}
std::vector<Path> Face::outline(char32_t /*letter*/, const Affine& /*map*/) const {
  return {};
}

}  // namespace clearcut::read
