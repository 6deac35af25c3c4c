#include "read/job/machine_file.h"

#include <algorithm>

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

Sources key_sources(const DataValue& table, const std::string& file_name, Origin origin) {
  Sources out;
  for (const DataMember& member : table.members) {
    std::string name = member.key;
    std::replace(name.begin(), name.end(), '_', '-');
    out.set(name, {origin, file_name + ":" + std::to_string(member.value.line)});
  }
  return out;
}

Sources machine_sources_of(const DataValue& table, const std::string& file_name, Origin origin) {
  Sources out = key_sources(table, file_name, origin);
  if (const Source* name = out.find("name")) out.set("machine", Source(*name));
  return out;
}

Sources machine_sources(const std::filesystem::path& file) {
  const std::string text = read_file(file.string(), kLargestFile);
  return machine_sources_of(parse_toml(text, file.string()), file.string(), Origin::kMachineFile);
}

Machine read_machine_text(std::string_view text, const std::string& file_name) {
  const DataValue root = parse_toml(text, file_name);
  return machine_of_section(DataSection(root, file_name, ""), Machine{});
}

Machine read_machine(const std::filesystem::path& file) {
  return read_machine_text(read_file(file.string(), kLargestFile), file.string());
}

}  // namespace clearcut::read
