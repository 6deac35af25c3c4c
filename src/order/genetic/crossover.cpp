#include "order/genetic/crossover.h"

#include "order/genetic/names.h"

namespace clearcut::order {

namespace {

const NamedMakers<std::unique_ptr<Crossover> (*)(const OperatorContext&)>& crossover_makers() {
  static const NamedMakers<std::unique_ptr<Crossover> (*)(const OperatorContext&)> all{"crossover",
                                                                                       {{"pmx", pmx},
                                                                                        {"ox", ox},
                                                                                        {"erx", erx},
                                                                                        {"cx", cx},
                                                                                        {"eax", eax},
                                                                                        {"ox1", ox1},
                                                                                        {"ox2", ox2},
                                                                                        {"pos", pos},
                                                                                        {"hx", hx},
                                                                                        {"smx", smx},
                                                                                        {"mpx", mpx},
                                                                                        {"vr", vr},
                                                                                        {"ap", ap},
                                                                                        {"aer", aer},
                                                                                        {"scx", scx},
                                                                                        {"upmx", upmx}}};
  return all;
}

}  // namespace

const std::vector<std::string>& crossover_names() {
  static const std::vector<std::string> names = crossover_makers().names();
  return names;
}

std::unique_ptr<Crossover> crossover_named(const std::string& name, const OperatorContext& context) {
  return crossover_makers().at(name)(context);
}

}  // namespace clearcut::order
