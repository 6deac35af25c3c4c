#include <cstring>
#include <type_traits>

#include "base/error.h"
#include "read/step_solid/solid_model.h"

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
  each(face.lean);
  each(face.fillet);
}

void put(Writer& out, const std::string& text) {
  out.put(text.size());
  for (const char c : text) out.put(c);
}

void get(Reader& in, std::string& text) {
  text.resize(in.count());
  for (char& c : text) in.get(c);
}

void put(Writer& out, const SolidBody& body) {
  put(out, body.name);
  out.put(body.width);
  out.put(body.depth);
  out.put(body.height);
}

void get(Reader& in, SolidBody& body) {
  get(in, body.name);
  in.get(body.width);
  in.get(body.depth);
  in.get(body.height);
}

void put(Writer& out, const FlatSide& side) {
  put(out, side.up);
  out.put(side.area);
  out.put(side.heights);
  out.put(side.lean);
  out.put(side.thickness);
}

void get(Reader& in, FlatSide& side) {
  get(in, side.up);
  in.get(side.area);
  in.get(side.heights);
  in.get(side.lean);
  in.get(side.thickness);
}

void put(Writer& out, const std::vector<Path>& paths) {
  out.put(paths.size());
  for (const Path& path : paths) {
    out.put(path.size());
    for (const Edge& edge : path) out.put(edge);
  }
}

void get(Reader& in, std::vector<Path>& paths) {
  paths.resize(in.count());
  for (Path& path : paths) {
    path.resize(in.count());
    for (Edge& edge : path) in.get(edge);
  }
}

void put(Writer& out, const SolidFace& face) {
  each_value(face, [&](const auto& value) { out.put(value); });
  put(out, face.surface);
  put(out, face.outline);
  put(out, face.foot);
}

void get(Reader& in, SolidFace& face) {
  each_value(face, [&](auto& value) { in.get(value); });
  get(in, face.surface);
  get(in, face.outline);
  get(in, face.foot);
}

template <typename Value>
void put_all(Writer& out, const std::vector<Value>& values) {
  out.put(values.size());
  for (const Value& value : values) put(out, value);
}

template <typename Value>
void get_all(Reader& in, std::vector<Value>& values) {
  values.resize(in.count());
  for (Value& value : values) get(in, value);
}

}  // namespace

std::string bytes_of(const SolidModel& solid) {
  Writer out;
  out.put(solid.plan);
  out.put(solid.z_bottom);
  out.put(solid.z_top);
  put_all(out, solid.bodies);
  put_all(out, solid.sides);
  put_all(out, solid.faces);
  return std::move(out.bytes);
}

SolidModel model_from_bytes(const std::string& bytes) {
  Reader in(bytes);
  SolidModel solid;
  in.get(solid.plan);
  in.get(solid.z_bottom);
  in.get(solid.z_top);
  get_all(in, solid.bodies);
  get_all(in, solid.sides);
  get_all(in, solid.faces);
  return solid;
}

}  // namespace clearcut::read
