#include "report/picture/svg_path.h"

#include "report/picture/svg_writer.h"

namespace clearcut::report {

std::string svg_path(const Loop& loop) {
  PathData data;
  data.add(loop);
  return data.text();
}

}  // namespace clearcut::report
