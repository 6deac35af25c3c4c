#include "post/laying_writer.h"

#include <fmt/format.h>

#include "base/text.h"
#include "post/words/comment.h"

namespace clearcut::post {
namespace {

constexpr int kPlaceDigits = 4;
constexpr int kFilamentDigits = 5;

std::string place_words(Vec2 at) {
  return "X" + trimmed(at.x, kPlaceDigits) + " Y" + trimmed(at.y, kPlaceDigits);
}

}  // namespace

std::string write_laying(const std::vector<std::vector<Vec2>>& lines, const std::string& name,
                         const LayingWords& words) {
  const bool extrudes = words.word == LayingWord::kExtruded;
  const std::string travel = "F" + trimmed(words.travel.mm_per_min(), 1);
  const std::string feed = "F" + trimmed(words.feed.mm_per_min(), 1);
  const std::string power = " S" + trimmed(words.rate, 3);
  std::string text = "; " + plain_comment(name) + "\nG21\nG90\n" + (extrudes ? "M83\n" : "M4 S0\n");
  text += "G0 Z" + trimmed(words.z, kPlaceDigits) + " " + travel + "\n";
  for (const std::vector<Vec2>& line : lines) {
    text += "G0 " + place_words(line.front()) + (extrudes ? "" : " S0") + " " + travel + "\n";
    for (std::size_t i = 1; i < line.size(); ++i) {
      text += "G1 " + place_words(line[i]);
      text += extrudes ? " E" + trimmed(words.rate * distance(line[i - 1], line[i]), kFilamentDigits) : power;
      text += (i == 1 ? " " + feed : "") + "\n";
    }
  }
  return text + (extrudes ? "" : "M5\n") + "M2\n";
}

}  // namespace clearcut::post
