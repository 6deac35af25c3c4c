#include "read/job/machine_file.h"

#include "base/file.h"

namespace clearcut::read {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 20;

std::array<std::array<double, 2>, 3> travel_of(DataSection section) {
  std::array<std::array<double, 2>, 3> travel{};
  const char* const axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto range = section.range(axes[i]);
    if (!range) section.fail(std::string(axes[i]) + " is missing; add " + axes[i] + " = [low, high]");
    travel[i] = *range;
  }
  section.refuse_unknown();
  return travel;
}

}  // namespace

Machine machine_of_section(DataSection section, Machine base) {
  if (const auto name = section.text("name")) base.name = *name;
  if (const auto rapid = section.positive("rapid")) base.rapid = MmPerMin::of(*rapid);
  if (const auto acceleration = section.positive("acceleration")) base.acceleration = *acceleration;
  if (const auto deviation = section.positive("junction_deviation")) base.junction_deviation = *deviation;
  if (const auto rpm = section.positive("max_spindle")) base.max_spindle_rpm = rpm;
  if (const auto feed = section.positive("max_feed")) base.max_feed = MmPerMin::of(*feed);
  if (const auto travel = section.section("travel")) base.travel = travel_of(*travel);
  section.refuse_unknown();
  return base;
}

Machine read_machine_text(std::string_view text, const std::string& file_name) {
  const DataValue root = parse_toml(text, file_name);
  return machine_of_section(DataSection(root, file_name, ""), Machine{});
}

Machine read_machine(const std::filesystem::path& file) {
  return read_machine_text(read_file(file.string(), kLargestFile), file.string());
}

}  // namespace clearcut::read
