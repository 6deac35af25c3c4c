#include "read/step_solid/model_bytes.h"

#include <cstring>
#include <type_traits>

#include "base/error.h"

namespace clearcut::read {
namespace {

class Writer {
 public:
  template <typename Value>
  void put(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof(Value));
    std::memcpy(bytes.data() + at, &value, sizeof(Value));
  }
  std::string bytes;
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}
  template <typename Value>
  void get(Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    CLEARCUT_ASSERT(bytes_.size() - at_ >= sizeof(Value));
    std::memcpy(&value, bytes_.data() + at_, sizeof(Value));
    at_ += sizeof(Value);
  }
  std::size_t count() {
    std::size_t n = 0;
    get(n);
    CLEARCUT_ASSERT(n <= bytes_.size());
    return n;
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

/// Every value of a face of fixed size, in order.
template <typename Face, typename Each>
void each_value(Face& face, Each each) {
  each(face.number);
  each(face.facing);
  each(face.level);
  each(face.z_low);
  each(face.z_high);
  each(face.plan);
  each(face.front);
}

void put(Writer& out, const SolidFace& face) {
  each_value(face, [&](const auto& value) { out.put(value); });
  out.put(face.surface.size());
  for (const char c : face.surface) out.put(c);
  out.put(face.outline.size());
  for (const Path& path : face.outline) {
    out.put(path.size());
    for (const Edge& edge : path) out.put(edge);
  }
}

void get(Reader& in, SolidFace& face) {
  each_value(face, [&](auto& value) { in.get(value); });
  face.surface.resize(in.count());
  for (char& c : face.surface) in.get(c);
  face.outline.resize(in.count());
  for (Path& path : face.outline) {
    path.resize(in.count());
    for (Edge& edge : path) in.get(edge);
  }
}

}  // namespace

std::string bytes_of(const SolidModel& solid) {
  Writer out;
  out.put(solid.plan);
  out.put(solid.z_bottom);
  out.put(solid.z_top);
  out.put(solid.bodies);
  out.put(solid.faces.size());
  for (const SolidFace& face : solid.faces) put(out, face);
  return std::move(out.bytes);
}

SolidModel model_from_bytes(const std::string& bytes) {
  Reader in(bytes);
  SolidModel solid;
  in.get(solid.plan);
  in.get(solid.z_bottom);
  in.get(solid.z_top);
  in.get(solid.bodies);
  solid.faces.resize(in.count());
  for (SolidFace& face : solid.faces) get(in, face);
  return solid;
}

}  // namespace clearcut::read
