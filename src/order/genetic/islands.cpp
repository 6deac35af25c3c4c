#include "order/genetic/islands.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "order/genetic/pool.h"

namespace clearcut::order {
namespace {

/// The first island has the run's own seed; the others draw theirs.
std::uint64_t seed_of_island(std::uint64_t seed, int island) {
  std::uint64_t drawn = seed;
  Random random(seed);
  for (int i = 0; i < island; ++i) drawn = random.next();
  return drawn;
}

bool has_genes(const Pool& pool, const Tour& genes) {
  for (int i = 0; i < pool.size(); ++i)
    if (pool.at(i).genome.genes() == genes) return true;
  return false;
}

/// The samples present in all islands: after an early stop, some islands have fewer.
std::vector<GenerationSample> samples_of_all(const std::vector<GeneticResult>& results) {
  std::vector<GenerationSample> all = results.front().samples;
  for (const GeneticResult& one : results) all.resize(std::min(all.size(), one.samples.size()));
  const auto count = static_cast<double>(results.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].mean = 0;
    for (const GeneticResult& one : results) {
      const GenerationSample& sample = one.samples[i];
      all[i].best = std::min(all[i].best, sample.best);
      all[i].mean += sample.mean / count;
      all[i].worst = std::max(all[i].worst, sample.worst);
    }
  }
  return all;
}

}  // namespace

void check_islands(const IslandOptions& islands, const GeneticOptions& options) {
  if (islands.islands < 1) throw InputError("islands", "needs at least 1");
  if (islands.migrate_every < 1) throw InputError("migrate-every", "needs at least 1 generation");
  if (islands.migrants < 0 || islands.migrants >= options.population)
    throw InputError("migrants", "lies between 0 and one less than the individuals of an island");
}

long long epoch_count(const IslandOptions& islands, const GeneticOptions& options) {
  const long long rounds = std::max(1LL, options.stop.rounds);
  return islands.islands == 1 ? 1 : (rounds - 1) / islands.migrate_every + 1;
}

int island_before(int island, const IslandOptions& islands) {
  return (island + islands.islands - 1) % islands.islands;
}

GeneticState run_epoch(const Problem& problem, const Objective& objective, const GeneticOptions& options,
                       const IslandOptions& islands, const Epoch& epoch, const GeneticState* own,
                       const GeneticState* before) {
  GeneticOptions settings = options;
  settings.patience = std::numeric_limits<long long>::max();
  settings.seed = seed_of_island(options.seed, epoch.island);
  if (epoch.number < epoch_count(islands, options))
    settings.stop.rounds = epoch.number * islands.migrate_every;
  GeneticState state = own == nullptr ? begin_genetic(problem, objective, settings) : *own;
  if (own != nullptr && before != nullptr) migrate(*before, state, islands.migrants);
  return continue_genetic(problem, objective, settings, std::move(state));
}

void migrate(const GeneticState& from, GeneticState& into, int migrants) {
  const Pool senders(from.individuals, false);
  Pool pool(std::move(into.individuals), false);
  for (int rank = 0; rank < migrants; ++rank) {
    Individual migrant = senders.at(senders.at_rank(rank));
    if (migrant.value < pool.worst().value && !has_genes(pool, migrant.genome.genes()))
      pool.replace(pool.at_rank(pool.size() - 1), migrant);
  }
  into.individuals = pool.take_individuals();
}

GeneticResult end_islands(std::vector<GeneticState> states) {
  std::vector<GeneticResult> results;
  for (GeneticState& state : states) results.push_back(end_genetic(std::move(state)));
  const auto best = std::min_element(results.begin(), results.end(),
                                     [](const auto& a, const auto& b) { return a.value < b.value; });
  GeneticResult all = *best;
  all.children = all.improved = all.records = 0;
  all.seconds = 0;
  for (const GeneticResult& one : results) {
    all.children += one.children;
    all.improved += one.improved;
    all.records += one.records;
    all.seconds += one.seconds;
  }
  all.samples = samples_of_all(results);
  return all;
}

namespace {

constexpr const char* kBegin = "state";
constexpr const char* kEnd = "end";  // missing in a truncated text

/// Replaces std::bit_cast, missing in some standard libraries.
template <class To, class From>
To same_bits(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

class Writer {
 public:
  void word(std::string_view text) { fmt::format_to(std::back_inserter(text_), "{} ", text); }
  void whole(long long value) { fmt::format_to(std::back_inserter(text_), "{} ", value); }
  void bits(std::uint64_t value) { fmt::format_to(std::back_inserter(text_), "{:x} ", value); }
  void real(double value) { bits(same_bits<std::uint64_t>(value)); }
  std::string text() && {
    text_.pop_back();
    return std::move(text_);
  }

 private:
  std::string text_;
};

/// Reads words one after the other. A missing or invalid word gives 0, and `is_good` is then false at the end.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  bool is_good() const { return good_; }
  bool is_empty() const { return rest_.empty(); }
  void expect(std::string_view text) { good_ = good_ && next() == text; }
  long long whole(long long least, long long most) {
    const auto value = number<long long>(10);
    good_ = good_ && value >= least && value <= most;
    return good_ ? value : 0;
  }
  std::uint64_t bits() { return number<std::uint64_t>(16); }
  double real() {
    const auto value = same_bits<double>(bits());
    good_ = good_ && std::isfinite(value);
    return good_ ? value : 0;
  }

 private:
  std::string_view next() {
    const auto end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }
  template <class Number>
  Number number(int base) {
    const std::string_view word = next();
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, base);
    good_ = good_ && error == std::errc() && end == word.data() + word.size();
    return good_ ? value : Number{};
  }

  std::string_view rest_;
  bool good_ = true;
};

constexpr long long kMost = std::numeric_limits<long long>::max();

void write_reached(const GeneticResult& reached, Writer& writer) {
  for (const long long count : {reached.generations, reached.children, reached.improved, reached.records})
    writer.whole(count);
  writer.real(reached.seconds);
  writer.whole(static_cast<long long>(reached.samples.size()));
  for (const GenerationSample& sample : reached.samples) {
    writer.whole(sample.generation);
    for (const double value : {sample.best, sample.mean, sample.worst}) writer.real(value);
  }
}

GeneticResult read_reached(Words& words) {
  GeneticResult reached;
  for (long long* count : {&reached.generations, &reached.children, &reached.improved, &reached.records})
    *count = words.whole(0, kMost);
  reached.seconds = words.real();
  const long long samples = words.whole(1, 1000);  // nine for each power of ten
  for (long long i = 0; i < samples && words.is_good(); ++i) {
    GenerationSample sample{.generation = words.whole(0, reached.generations)};
    for (double* value : {&sample.best, &sample.mean, &sample.worst}) *value = words.real();
    reached.samples.push_back(sample);
  }
  return reached;
}

std::optional<Individual> read_individual(Words& words, int points) {
  Individual individual;
  individual.local = words.real();
  individual.value = words.real();
  Tour genes;
  std::vector<bool> is_there(static_cast<std::size_t>(points));
  for (int i = 0; i < points && words.is_good(); ++i) {
    genes.push_back(static_cast<int>(words.whole(0, points - 1)));
    is_there[static_cast<std::size_t>(genes.back())] = true;
  }
  if (!words.is_good() || std::find(is_there.begin(), is_there.end(), false) != is_there.end()) return {};
  individual.genome.assign(std::move(genes));
  return individual;
}

}  // namespace

std::string text_of_state(const GeneticState& state) {
  Writer writer;
  writer.word(kBegin);
  for (const std::uint64_t word : state.random.state()) writer.bits(word);
  writer.whole(state.idle);
  write_reached(state.reached, writer);
  for (const Individual& individual : state.individuals) {
    writer.real(individual.local);
    writer.real(individual.value);
    for (const int gene : individual.genome.genes()) writer.whole(gene);
  }
  writer.word(kEnd);
  return std::move(writer).text();
}

std::optional<GeneticState> state_of_text(const std::string& text, int individuals, int points) {
  Words words(text);
  GeneticState state;
  words.expect(kBegin);
  Random::State random{};
  for (std::uint64_t& word : random) word = words.bits();
  state.random = Random(random);
  state.idle = words.whole(0, kMost);
  state.reached = read_reached(words);
  for (int i = 0; i < individuals; ++i) {
    auto individual = read_individual(words, points);
    if (!individual) return {};
    state.individuals.push_back(std::move(*individual));
  }
  words.expect(kEnd);
  if (!words.is_good() || !words.is_empty() || state.individuals.empty()) return {};
  const auto best = std::min_element(state.individuals.begin(), state.individuals.end(),
                                     [](const auto& a, const auto& b) { return a.value < b.value; });
  state.reached.tour = best->genome.genes();
  state.reached.value = best->value;
  return state;
}

}  // namespace clearcut::order
