#include "read/job/job_setups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "read/common/moved_part.h"
#include "read/job/read_part.h"
#include "read/step_solid/step_solid.h"

namespace clearcut::read {
namespace {

/// A number as typed: the shortest text that reads back equal.
std::string typed(double number) {
  return fmt::format("{}", number);
}

/// "1,2,3" of [1, 2, 3], "0.4" of 0.4; nothing for other values.
std::optional<std::string> text_of(const DataValue& value) {
  if (value.is_string()) return value.text;
  if (value.is_number()) return typed(value.number);
  if (!value.is_array() || value.items.empty()) return std::nullopt;
  std::string text;
  for (const DataValue& item : value.items) {
    if (!item.is_number()) return std::nullopt;
    text += (text.empty() ? "" : ",") + typed(item.number);
  }
  return text;
}

std::optional<std::vector<std::string>> texts_of(const DataValue& value) {
  std::vector<std::string> texts;
  if (!value.is_array()) return std::nullopt;
  for (const DataValue& item : value.items) {
    const auto text = text_of(item);
    if (!text) return std::nullopt;
    texts.push_back(*text);
  }
  return texts;
}

const char* expected(ValueKind kind) {
  if (kind == ValueKind::kFlag) return "must be true or false";
  if (takes_several(kind)) return "must be a list, as [\"one\", \"two\"]; of points [[x, y], ...]";
  if (kind == ValueKind::kPoint) return "must be a point, [x, y]";
  return is_number(kind) ? "must be a number" : "must be a text in quotes";
}

Value value_of(const Row& row, const DataValue& value, const std::string& place) {
  if (row.kind == ValueKind::kFlag) {
    if (value.kind == DataValue::Kind::kBoolean) return value.boolean != row.key_is_opposite;
  } else if (!row.flag_names.empty() && value.kind == DataValue::Kind::kBoolean) {
    return row.flag_names[value.boolean ? 1 : 0];
  } else if (takes_several(row.kind)) {
    if (const auto texts = texts_of(value)) return value_of_texts(row, *texts, place);
  } else if (is_number(row.kind) && value.is_number()) {
    check_value(row, value.number, place);
    return value.number;
  } else if (row.kind == ValueKind::kFeed || row.kind == ValueKind::kLength || !is_number(row.kind)) {
    if (const auto text = text_of(value)) return value_of_text(row, *text, place);
  }
  throw InputError(place, expected(row.kind));
}

}  // namespace

void take_options(DataSection& section, JobTable table, OptionsOf which, Asked& asked) {
  for (const Row& row : rows()) {
    if (row.table != table || row.is_of_operations != (which == OptionsOf::kOperations)) continue;
    const std::string key = row.job_key();
    const DataValue* value = section.value(key);
    if (value) row.field.set(asked, value_of(row, *value, section.place_of(key)), row.names);
  }
}

namespace {

/// mm. Blocks whose sides differ by less are the same.
constexpr double kSameSize = 0.01;

const std::vector<std::string> kOfPart{"file",  "unit",     "depth",        "top",       "layers",
                                       "scale", "join_gap", "open_curves",  "find_arcs", "up",
                                       "turn",  "body",     "breakthrough", "origin"};
const std::vector<std::string> kOfOutput{"work_offset", "end_position"};
/// Tables whose keys go before the common ones.
const std::vector<std::string> kTables{"stock", "plan"};
const std::vector<std::string> kLists{"operation", "keep_out", "predrilled"};

DataValue& member(DataValue& table, const std::string& key, DataValue::Kind kind, int line) {
  for (DataMember& one : table.members) {
    if (one.key == key) return one.value;
  }
  DataValue value;
  value.kind = kind;
  value.line = line;
  table.members.push_back({key, std::move(value)});
  return table.members.back().value;
}

void set(DataValue& table, const std::string& key, const DataValue& value) {
  member(table, key, value.kind, value.line) = value;
}

/// Moves the keys of `from` listed in `keys` into `table` of the job.
void put_keys(const DataValue& from, const std::vector<std::string>& keys, const char* table,
              DataValue& job) {
  for (const std::string& key : keys) {
    const DataValue* value = from.find(key);
    if (value) set(member(job, table, DataValue::Kind::kObject, from.line), key, *value);
  }
}

void put_tables(const DataValue& from, DataValue& job) {
  for (const std::string& key : kTables) {
    const DataValue* table = from.find(key);
    if (!table) continue;
    DataValue& common = member(job, key, DataValue::Kind::kObject, table->line);
    common.line = table->line;
    for (const DataMember& one : table->members) set(common, one.key, one.value);
  }
}

/// Lists of the set-up: its layers go before the common ones, because the first matching rule counts.
void put_lists(const DataValue& from, DataValue& job) {
  for (const std::string& key : kLists) {
    const DataValue* list = from.find(key);
    if (!list) continue;
    DataValue& common = member(job, key, DataValue::Kind::kArray, list->line);
    common.items.insert(common.items.end(), list->items.begin(), list->items.end());
  }
  if (const DataValue* layers = from.find("layer")) {
    DataValue& common = member(job, "layer", DataValue::Kind::kArray, layers->line);
    common.items.insert(common.items.begin(), layers->items.begin(), layers->items.end());
  }
}

/// Uses every known key, so that the remaining ones are unknown.
void refuse_unknown_keys(const DataValue& setup, const std::string& file_name) {
  DataSection section(setup, file_name, "[[setup]]");
  section.text("name");
  for (const auto* keys : {&kOfPart, &kOfOutput, &kTables, &kLists}) {
    for (const std::string& key : *keys) section.has(key);
  }
  section.has("layer");
  section.refuse_unknown();
}

std::string size_of(const Stock& stock) {
  return trimmed(stock.plan.width(), 3) + " x " + trimmed(stock.plan.height(), 3) + " x " +
         trimmed(stock.z_top - stock.z_bottom, 3) + " mm";
}

bool same_size(const Stock& a, const Stock& b) {
  return std::abs(a.plan.width() - b.plan.width()) < kSameSize &&
         std::abs(a.plan.height() - b.plan.height()) < kSameSize &&
         std::abs((a.z_top - a.z_bottom) - (b.z_top - b.z_bottom)) < kSameSize;
}

JobStock stated(const Stock& stock) {
  JobStock out;
  out.x = {stock.plan.min.x, stock.plan.max.x};
  out.y = {stock.plan.min.y, stock.plan.max.y};
  out.z = {stock.z_bottom, stock.z_top};
  return out;
}

[[noreturn]] void refuse(const JobFile& setup, const std::string& what) {
  throw InputError(setup.file, "set-up " + std::to_string(setup.setup_number) + ": " + what);
}

SetupPlace own_turn(const JobFile& setup) {
  const auto place = place_with_up(setup.read.solid.up, setup.read.solid.turn_deg);
  if (!place)
    refuse(setup, "up = \"" + setup.read.solid.up + "\"; among set-ups name +Z, -Z, +X, -X, +Y or -Y");
  return *place;
}

/// Reads set-ups one after the other of one block.
class SetupReader {
 public:
  SetupReader(const JobFile& job, const ReadOptions& over) : job_(job), over_(over) {
    over_.solid.has_other_setups = job.setups.size() > 1;
  }

  Part read(int number, SetupPlace& place, StepSources& sources, StepChoices& published) {
    const JobFile& first = job_.setups.front();
    place = own_turn(first);
    Part part = part_of_job(first, over_, sources, published);
    if (number == 1) return finished(std::move(part), first, place);
    if (!part.stock)
      refuse(first,
             "nothing says what block it is made of, which later set-ups need; add [stock] with x, y and z, "
             "or a layer STOCK_D12");
    sources.clear();
    published.clear();
    return read_later(job_.setups[static_cast<std::size_t>(number - 1)], *part.stock, place, sources,
                      published);
  }

 private:
  /// `block` and `place`: those of the first set-up; afterwards `place` belongs to `setup`.
  Part read_later(JobFile setup, const Stock& block, SetupPlace& place, StepSources& sources,
                  StepChoices& published) {
    const SetupPlace first = place;
    place = own_turn(setup);
    const SetupPlace from_first = between(first, place);
    if (!keeps_boxes(from_first))
      refuse(setup,
             "the block would stand aslant; turn it by 90 degrees, 180 or 270 against the first set-up");
    const Stock expected = moved(block, from_first);
    const bool is_solid = is_step_solid(read_file(setup.part_file.string(), kLargestPart));
    Part part = is_solid ? of_solid(setup, expected, sources, published)
                         : of_drawing(setup, expected, block, sources, published);
    if (!is_solid) {
      if (!same_size(*part.stock, expected))
        refuse(setup, "its block is " + size_of(*part.stock) +
                          ", and that of the first set-up, turned like this, is " + size_of(expected) +
                          "; correct the stock, up or turn");
      place.shift = {part.stock->plan.min.x - expected.plan.min.x,
                     part.stock->plan.min.y - expected.plan.min.y, part.stock->z_bottom - expected.z_bottom};
    }
    return finished(std::move(part), setup, place);
  }

  /// All set-ups of a solid have the coordinates of its file.
  Part of_solid(JobFile& setup, const Stock& expected, StepSources& sources, StepChoices& published) {
    setup.stock = stated(expected);
    return part_of_job(setup, over_, sources, published);
  }

  /// A separate drawing: the place of the block is stated by its layer of stock or by the set-up; else its lower left
  /// corner and its top are those of the first set-up.
  Part of_drawing(JobFile& setup, const Stock& expected, const Stock& block, StepSources& sources,
                  StepChoices& published) {
    if (!setup.has_own_stock) setup.stock.reset();
    Part part = part_of_job(setup, over_, sources, published);
    if (part.stock) return part;
    Stock lies = expected;
    const Vec2 by = block.plan.min - expected.plan.min;
    lies.plan = {expected.plan.min + by, expected.plan.max + by};
    lies.z_bottom += block.z_top - expected.z_top;
    lies.z_top = block.z_top;
    setup.stock = stated(lies);
    sources.clear();
    published.clear();
    return part_of_job(setup, over_, sources, published);
  }

  Part finished(Part part, const JobFile& setup, SetupPlace& place) const {
    part.name +=
        ", set-up " + std::to_string(setup.setup_number) + " of " + std::to_string(job_.setups.size());
    if (!setup.setup_name.empty()) part.name += " " + setup.setup_name;
    if (!setup.zero) return part;
    const auto zero = zero_of(part, *setup.zero);
    for (std::size_t i = 0; i < 3; ++i) place.shift[i] -= zero[i];
    return with_zero_at(std::move(part), zero);
  }

  const JobFile& job_;
  ReadOptions over_;
};

}  // namespace

std::vector<DataValue> jobs_of_setups(const DataValue& root, const std::string& file_name) {
  const DataValue* setups = root.find("setup");
  if (root.find("operation"))
    throw InputError(
        file_name + ":" + std::to_string(root.find("operation")->line),
        "[[operation]] stands outside the set-ups; write [[setup.operation]] in the one that it is for");
  DataValue common = root;
  std::erase_if(common.members, [](const DataMember& one) { return one.key == "setup"; });
  std::vector<DataValue> jobs;
  for (const DataValue& setup : setups->items) {
    refuse_unknown_keys(setup, file_name);
    DataValue job = common;
    put_keys(setup, kOfPart, "part", job);
    put_keys(setup, kOfOutput, "output", job);
    put_tables(setup, job);
    put_lists(setup, job);
    jobs.push_back(std::move(job));
  }
  return jobs;
}

Part part_of_setup(const JobFile& job, int number, const ReadOptions& over, SetupPlace& place,
                   StepSources& sources, StepChoices& published) {
  return SetupReader(job, over).read(number, place, sources, published);
}

}  // namespace clearcut::read
