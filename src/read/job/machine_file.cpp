#include "read/job/machine_file.h"

#include <algorithm>

#include "base/files/file.h"

namespace clearcut::read {
namespace {

constexpr std::size_t kLargestMachineFile = std::size_t{1} << 20;

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

std::optional<std::array<double, 3>> place_of(DataSection& section, const std::string& key) {
  const std::vector<double> numbers = section.numbers(key);
  if (numbers.empty()) return std::nullopt;
  if (numbers.size() != 3) section.fail_at(key, "must be three numbers: [x, y, z]");
  return std::array<double, 3>{numbers[0], numbers[1], numbers[2]};
}

/// In the machine's own coordinates. Without all of them nothing is answered, so each is asked for.
MachinePlaces places_of(DataSection section) {
  const auto needed = [&](const std::string& key) {
    const auto place = place_of(section, key);
    if (!place) section.fail(key + " is missing; add " + key + " = [x, y, z]");
    return *place;
  };
  MachinePlaces places;
  places.start = needed("start");
  places.reference = needed("g28");
  places.second_reference = needed("g30");
  const char* const systems[] = {"g54", "g55", "g56", "g57", "g58", "g59", "g59.1", "g59.2", "g59.3"};
  constexpr std::size_t kNeeded = 6;
  std::size_t stated = kNeeded;
  for (std::size_t i = 0; i < places.origins.size(); ++i) {
    const auto place = i < kNeeded ? needed(systems[i]) : place_of(section, systems[i]);
    if (place && stated < i) needed(systems[stated]);  // they are stated in order, so that a count says which
    if (place && i >= kNeeded) stated = i + 1;
    places.origins[i] = place.value_or(places.origins[0]);
  }
  places.stated_origins = static_cast<int>(stated);
  section.refuse_unknown();
  return places;
}

}  // namespace

void fill_machine_kind(Machine& machine, const std::string& kind) {
  const bool router = kind == "router";
  if (!machine.min_spindle_rpm) machine.min_spindle_rpm = router ? 8000 : 60;
  if (!machine.max_spindle_rpm) machine.max_spindle_rpm = router ? 24000 : 6000;
  if (!machine.spindle_power_w && !machine.spindle_torque_nm) machine.spindle_power_w = router ? 800 : 1500;
}

Machine machine_of_section(DataSection section, Machine base) {
  if (const auto name = section.text("name")) base.name = *name;
  if (const auto rapid = section.positive("rapid")) base.rapid = MmPerMin::of(*rapid);
  if (const auto acceleration = section.positive("acceleration")) base.acceleration = *acceleration;
  if (const auto deviation = section.positive("junction_deviation")) base.junction_deviation = *deviation;
  if (const auto rpm = section.positive("max_spindle")) base.max_spindle_rpm = rpm;
  if (const auto rpm = section.positive("min_spindle")) base.min_spindle_rpm = rpm;
  if (const auto power = section.positive("spindle_power")) base.spindle_power_w = power;
  if (const auto torque = section.positive("spindle_torque")) base.spindle_torque_nm = torque;
  if (const auto kind = section.choice("kind", machine_kinds()))
    fill_machine_kind(base, machine_kinds()[*kind]);
  if (base.max_spindle_rpm && base.min_spindle_rpm && *base.min_spindle_rpm > *base.max_spindle_rpm)
    section.fail("min_spindle is above max_spindle; correct one of them");
  if (const auto feed = section.positive("max_feed")) base.max_feed = MmPerMin::of(*feed);
  if (const auto wait = section.not_negative("spindle_wait")) base.spindle_wait_s = *wait;
  if (const auto change = section.not_negative("tool_change")) base.tool_change_s = *change;
  if (const auto tolerance = section.not_negative("path_tolerance")) base.path_tolerance = tolerance;
  if (const auto places = section.section("places")) base.places = places_of(*places);
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
  if (const Source* kind = out.find("kind")) {
    const Source of_kind = *kind;
    for (const char* limit : {"min-spindle", "max-spindle", "spindle-power"})
      if (!out.find(limit)) out.set(limit, of_kind);
  }
  return out;
}

Sources machine_sources(const std::filesystem::path& file) {
  const std::string text = read_file(file.string(), kLargestMachineFile);
  return machine_sources_of(parse_toml(text, file.string()), file.string(), Origin::kMachineFile);
}

Machine read_machine_text(std::string_view text, const std::string& file_name) {
  const DataValue root = parse_toml(text, file_name);
  return machine_of_section(DataSection(root, file_name, ""), Machine{});
}

Machine read_machine(const std::filesystem::path& file) {
  return read_machine_text(read_file(file.string(), kLargestMachineFile), file.string());
}

}  // namespace clearcut::read
