// Functions of include/clearcut/elements.h, by calls of the stages.
#include "pipeline/elements.h"

#include <clearcut/elements.h>

#include <utility>

#include "read/outline/read_elements.h"
#include "report/picture/grid_picture.h"

namespace clearcut {

TextTable element_table(const ElementsResult& result) {
  return pipeline::element_table(result);
}

ElementsResult plan_elements(const ElementJob& job, const PlanOptions& options) {
  return pipeline::plan_elements(job, options);
}

std::vector<SquareSearch> search_squares(const ElementJob& job, const PointTable& points,
                                         const PlanOptions& options) {
  return pipeline::search_squares(job, points, options);
}

TextTable square_table(const std::vector<SquareSearch>& searches) {
  return pipeline::square_table(searches);
}

ElementJob elements_of_options(const std::vector<ElementOption>& options, const ElementDefaults& defaults) {
  return read::elements_of_options(options, defaults);
}

ElementJob read_elements(const std::filesystem::path& file) {
  return read::read_elements(file);
}

ElementJob read_elements_text(std::string_view text, const std::string& file_name) {
  return read::read_elements_text(text, file_name);
}

std::string grid_page(const ElementJob& job, const PointTable& table, const Toolpath& toolpath,
                      const std::vector<VisitSearch>& searches) {
  return report::grid_page(job, table, toolpath, searches);
}

std::string grid_picture(const ElementJob& job, const PointTable& table, const Toolpath& toolpath) {
  return report::grid_picture(job, table, toolpath);
}

std::string points_csv(const ElementJob& job, const PointTable& table) {
  return report::points_csv(job, table);
}

TextTable points_table(const ElementJob& job, const PointTable& table) {
  return report::points_table(job, table);
}

}  // namespace clearcut
