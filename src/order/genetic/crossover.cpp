#include "order/genetic/crossover.h"

#include "order/genetic/names.h"

namespace clearcut::order {

namespace {

const NamedMakers<std::unique_ptr<Crossover> (*)(const Ground&)>& crossover_makers() {
  static const NamedMakers<std::unique_ptr<Crossover> (*)(const Ground&)> all{
      "crossover", {{"pmx", pmx}, {"ox", ox}, {"erx", erx}, {"cx", cx}, {"eax", eax}}};
  return all;
}

}  // namespace

const std::vector<std::string>& crossover_names() {
  static const std::vector<std::string> names = crossover_makers().names();
  return names;
}

std::unique_ptr<Crossover> crossover_named(const std::string& name, const Ground& ground) {
  return crossover_makers().at(name)(ground);
}

}  // namespace clearcut::order
