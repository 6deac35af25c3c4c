#include "read/stepnc/materials.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

namespace clearcut::read::stepnc {
namespace {

/// Of materials that are known and not in the table: with them no other name counts.
constexpr const char* kNotInTable = "";

struct MaterialName {
  std::string_view name;
  const char* material;
};

/// Within words: "ALUMINUM", "Edelstahl".
constexpr MaterialName kParts[] = {{"ALUMIN", "aluminium"},    {"STAINLESS", "stainless"},
                                   {"EDELSTAHL", "stainless"}, {"STEEL", "steel"},
                                   {"BRASS", "brass"},         {"MESSING", "brass"},
                                   {"TITAN", "titanium"},      {"PLYWOOD", "plywood"},
                                   {"HARDWOOD", "hardwood"},   {"SOFTWOOD", "softwood"},
                                   {"PLASTIC", "plastic"},     {"ACETAL", "plastic"},
                                   {"DELRIN", "plastic"},      {"NYLON", "plastic"},
                                   {"ACRYLIC", "plastic"},     {"POLYCARB", "plastic"},
                                   {"POLYETHYL", "plastic"},   {"CAST IRON", "cast-iron"},
                                   {"GRAUGUSS", "cast-iron"},  {"BRONZE", kNotInTable},
                                   {"COPPER", kNotInTable},    {"ALLOY STEEL", "alloy-steel"}};

/// Whole words.
constexpr MaterialName kWords[] = {
    {"MDF", "mdf"},      {"POM", "plastic"},    {"PMMA", "plastic"},   {"HDPE", "plastic"},
    {"PEEK", "plastic"}, {"PVC", "plastic"},    {"PTFE", "plastic"},   {"ABS", "plastic"},
    {"PA6", "plastic"},  {"PA66", "plastic"},   {"INOX", "stainless"}, {"STAHL", "steel"},
    {"OAK", "hardwood"}, {"BEECH", "hardwood"}, {"PINE", "softwood"},  {"SPRUCE", "softwood"}};

/// Wrought alloys of aluminium that are named by their number alone; numbers of steels have four digits, too.
constexpr std::string_view kAluminiumNumbers[] = {"2007", "2011", "2017", "2024", "3003", "5052",
                                                  "5083", "5754", "6005", "6026", "6060", "6061",
                                                  "6063", "6082", "7020", "7022", "7050", "7075"};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool are_digits(std::string_view text, std::size_t count) {
  return text.size() == count && std::all_of(text.begin(), text.end(), is_digit);
}

bool begins(std::string_view word, std::string_view with) {
  return word.substr(0, with.size()) == with;
}

bool has(std::string_view word, std::string_view part) {
  return word.find(part) != std::string_view::npos;
}

/// `head`, then at least `digits` digits: C45E, S235JR.
bool is_code(std::string_view word, std::string_view head, std::size_t digits) {
  return begins(word, head) && word.size() >= head.size() + digits &&
         are_digits(word.substr(head.size(), digits), digits);
}

template <std::size_t N>
bool is_any_code(std::string_view word, const std::string_view (&codes)[N]) {
  return std::any_of(std::begin(codes), std::end(codes),
                     [&](std::string_view code) { return begins(word, code); });
}

/// EN 10027-2 and its older kin: "1.4301". Null where the group is none of the table's.
const char* of_material_number(std::string_view word) {
  if (word.size() < 6 || word[1] != '.' || !are_digits(word.substr(2, 4), 4)) return nullptr;
  const int group = (word[2] - '0') * 10 + (word[3] - '0');
  switch (word[0]) {
    case '0':
      return group >= 60 && group < 80 ? "cast-iron" : nullptr;
    case '1':
      if (group < 20) return "steel";
      if (group >= 40 && group < 47) return "stainless";
      return group < 40 || (group >= 50 && group < 90) ? "alloy-steel" : nullptr;
    case '2':
      return group >= 2 && group < 6 ? "brass" : nullptr;
    case '3':
      if (group >= 70 && group < 72) return "titanium";
      return group < 50 ? "aluminium" : nullptr;
    default:
      return nullptr;
  }
}

/// AISI and SAE: the number alone, without the word before it.
const char* of_american_steel(std::string_view number) {
  const bool has_letter = number.size() == 4 && !is_digit(number[3]);  // 316L
  if (are_digits(has_letter ? number.substr(0, 3) : number, 3))
    return number[0] == '3' || number[0] == '4' ? "stainless" : nullptr;
  if (!are_digits(number, 4)) return nullptr;
  if (begins(number, "10") || begins(number, "11") || begins(number, "12")) return "steel";
  return number[0] >= '4' && number[0] <= '9' ? "alloy-steel" : nullptr;
}

/// Short names by composition and use: EN 573, EN 10027-1, EN 1412, EN 1560.
const char* of_short_name(std::string_view word) {
  static constexpr std::string_view kAluminium[] = {"ALMG", "ALSI", "ALCU", "ALZN", "ALMN"};
  static constexpr std::string_view kStructural[] = {"S235", "S275", "S355", "E295", "E335", "E360"};
  static constexpr std::string_view kCastIron[] = {"GJL", "GJS", "GG20", "GG25", "GG30", "GGG40", "GGG50"};
  if (is_any_code(word, kAluminium)) return "aluminium";
  if (is_any_code(word, kStructural) || is_code(word, "ST", 2) || is_code(word, "C", 2) ||
      is_code(word, "CK", 2))
    return "steel";
  if (is_any_code(word, kCastIron)) return "cast-iron";
  if (begins(word, "CUZN") || is_code(word, "CW5", 2) || is_code(word, "CW6", 2) || is_code(word, "MS", 2))
    return "brass";
  if (begins(word, "TI6AL")) return "titanium";
  if (word[0] == 'X' && has(word, "CRNI")) return "stainless";
  const bool is_alloyed = has(word, "CR") || has(word, "MN") || has(word, "MO");
  return is_digit(word[0]) && is_alloyed ? "alloy-steel" : nullptr;
}

/// Capitals, digits and points, in words; a comma between digits is a point.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_decimal = i > 0 && i + 1 < text.size() && is_digit(text[i - 1]) && is_digit(text[i + 1]);
    const char c = text[i] == ',' && is_decimal ? '.' : text[i];
    const bool is_part = is_digit(c) || (c >= 'A' && c <= 'Z') || c == '.';
    if (is_part)
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

const char* of_word(const std::vector<std::string>& words, std::size_t at) {
  const std::string& word = words[at];
  const std::string before = at > 0 ? words[at - 1] : "";
  for (const MaterialName& row : kWords)
    if (word == row.name) return row.material;
  if (const char* material = of_material_number(word)) return material;
  if (before == "AISI" || before == "SAE") return of_american_steel(word);
  if ((before == "AW" || before == "AA" || before == "AL") && are_digits(word, 4)) return "aluminium";
  if (begins(word, "AW") && are_digits(std::string_view(word).substr(2), 4)) return "aluminium";
  if (before == "ST" && are_digits(word, 2)) return "steel";
  for (const std::string_view number : kAluminiumNumbers)
    if (word == number) return "aluminium";
  return of_short_name(word);
}

}  // namespace

std::string recognised_material(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  std::set<std::string> found;
  for (const MaterialName& row : kParts)
    if (has(capitals, row.name)) found.insert(row.material);
  const std::vector<std::string> words = words_of(capitals);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (const char* material = of_word(words, i)) found.insert(material);
  if (found.count("stainless") || found.count("alloy-steel")) found.erase("steel");
  return found.size() == 1 ? *found.begin() : "";
}

}  // namespace clearcut::read::stepnc
