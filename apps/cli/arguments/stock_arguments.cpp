#include "arguments/stock_arguments.h"

#include <clearcut/error.h>

#include <filesystem>
#include <utility>

namespace clearcut::cli {

bool StockArguments::has_solid() const {
  if (!from) return false;
  const std::string extension = std::filesystem::path(*from).extension().string();
  return extension == ".step" || extension == ".stp" || extension == ".STEP" || extension == ".STP";
}

const Part& StockArguments::solid(const SolidOptions& lies) const {
  if (solid_) return *solid_;
  ReadOptions options;
  options.solid.up = lies.up;
  options.solid.turn_deg = lies.turn_deg;
  options.solid.breakthrough = 0;
  options.solid.is_stock = true;
  solid_ = read_part(*from, options);
  if (!solid_->is_solid)
    throw InputError(*from,
                     "is a STEP-NC program and no solid; give a solid, or a program that has run before");
  return *solid_;
}

void StockArguments::lay_out(Part& part) const {
  block_ = part.stock;
  tools_ = part.tools;
  part.diagnostics.note(
      *from, "what the stock lacks of its block counts as cut, as far as the narrowest mill reaches into it");
}

const Toolpath& StockArguments::missing(std::vector<Tool> tools) const {
  if (missing_) return *missing_;
  if (tools.empty()) tools = tools_;
  number_tools(tools);
  missing_ = missing_of(*solid_, *block_, tools);
  return *missing_;
}

std::optional<std::string> StockArguments::program(const std::optional<JobFile>& job) const {
  const bool is_program = from && !has_solid();
  if (after && is_program)
    throw InputError("--stock-from",
                     "--after names the program that has run before, too; leave one of them out");
  if (after) return after;
  if (is_program) return from;
  if (job && job->after) return job->after->string();
  return std::nullopt;
}

}  // namespace clearcut::cli
