#include "sheet_pages.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "paper.h"
#include "picture.h"
#include "table.h"

namespace clearcut::sheet {
namespace {

using report::SetupSheet;

/// Points.
constexpr double kMargin = 34, kLeft = kMargin, kTop = kMargin;
constexpr double kWidth = kPaperWidth - 2 * kMargin, kBottom = kPaperHeight - kMargin;
constexpr std::uint32_t kMuted = 0x55606b, kInk = 0x1c2733;
constexpr double kHighestPicture = 275;
/// Room to write in by hand.
constexpr double kHandRoom = 22, kHandGap = 12;
constexpr double kFooterGap = 6;

/// Sizes of the drawing, points.
struct Look {
  double size = 0;     ///< size of letters
  double picture = 0;  ///< height
};
/// Tried one after the other until all fits on one page.
constexpr std::array<Look, 5> kLooks{{{9.5, 180}, {9, 180}, {8.5, 170}, {8, 150}, {7.5, 130}}};
/// If no look fits on one page.
constexpr Look kManyPages{8.5, 220};

std::uint32_t colour_of(const std::string& verdict) {
  if (verdict == "CLEAN") return 0x11703d;
  return verdict == "FAULTY" ? 0xb3131f : 0x8a5300;
}

/// One sheet, from the top of a page on.
class Layout {
 public:
  /// `pages`: number of pages found by a trial; printed on each page if there are several.
  Layout(Paper& paper, const SetupSheet& sheet, const Picture& picture, const Look& look, int pages)
      : paper_(paper), sheet_(sheet), picture_(picture), look_(look), pages_(pages) {}

  void draw() {
    title();
    facts();
    picture();
    table(sheet_.tools);
    table(sheet_.operations);
    notes();
    lines_by_hand();
    end_page();
  }
  int pages() const { return page_ - 1; }
  /// Remaining height on the last page.
  double spare() const { return spare_; }

 private:
  Style plain() const { return {look_.size}; }
  Style muted() const { return {look_.size, kMuted}; }

  void end_page() {
    if (pages_ > 1) {
      const Style style{7.5, kMuted, false, PANGO_ALIGN_RIGHT};
      const std::string number = "page " + std::to_string(page_) + " of " + std::to_string(pages_);
      const double wide = paper_.width(number, style);
      paper_.text(sheet_.part, {kLeft, kWidth - wide - kFooterGap, 1}, kBottom + kFooterGap, style);
      paper_.text(number, {kLeft, kWidth, 1}, kBottom + kFooterGap, style);
    }
    paper_.end_page();
    ++page_;
    y_ = kTop;
  }
  void make_room(double height) {
    if (y_ + height > kBottom && y_ > kTop) end_page();
  }

  void title() {
    y_ += paper_.text(sheet_.part, {kLeft, kWidth, 3}, y_, {look_.size * 1.7, kInk, true}) + 1;
    const Style verdict{look_.size + 0.5, colour_of(sheet_.verdict), true};
    const double wide = paper_.width(sheet_.verdict, verdict);
    paper_.text(sheet_.verdict, {kLeft, wide + 1}, y_, verdict);
    const double x = kLeft + wide + look_.size * 0.5;
    y_ += paper_.text(sheet_.headline, {x, kLeft + kWidth - x}, y_, {look_.size + 0.5}) + look_.size * 0.6;
  }

  void facts() {
    double wide = 0;
    for (const auto& fact : sheet_.facts) wide = std::max(wide, paper_.width(fact.name, muted()));
    const double x = kLeft + wide + look_.size;
    for (const auto& fact : sheet_.facts) {
      paper_.text(fact.name, {kLeft, wide + 1, 1}, y_, muted());
      y_ += paper_.text(fact.value, {x, kLeft + kWidth - x}, y_, plain()) + 0.8;
    }
  }

  void picture() {
    const double high = std::min(look_.picture, kWidth / picture_.aspect());
    const double wide = high * picture_.aspect();
    make_room(high);
    y_ += look_.size * 0.6;
    paper_.picture(picture_, kLeft + (kWidth - wide) / 2, y_, wide, high);
    y_ += high;
  }

  double height_of_heading() const { return look_.size * 2.2; }
  void heading(const std::string& text) {
    y_ += look_.size * 0.8;
    paper_.text(text, {kLeft, kWidth, 1}, y_, {look_.size * 1.1, kInk, true});
    y_ += look_.size * 1.4;
  }

  void table(const report::SheetTable& content) {
    Table table(paper_, content, kLeft, kWidth, look_.size);
    const double head = table.height_of_head();
    make_room(height_of_heading() + head + (content.rows.empty() ? 0 : table.height_of_row(0)));
    heading(content.title);
    const auto draw_head = [&] {
      table.draw_head(y_);
      y_ += head;
    };
    draw_head();
    for (std::size_t row = 0; row < content.rows.size(); ++row) {
      const double high = table.height_of_row(row);
      const int page = page_;
      make_room(high);
      if (page != page_) draw_head();
      table.draw_row(row, y_);
      y_ += high;
    }
  }

  void notes() {
    if (sheet_.notes.empty()) return;
    const double indent = look_.size;
    const auto height_of = [&](const std::string& note) {
      return paper_.height(note, kWidth - indent, plain()) + 1;
    };
    make_room(height_of_heading() + height_of(sheet_.notes.front()));
    heading("Notes");
    for (const std::string& note : sheet_.notes) {
      make_room(height_of(note));
      paper_.text("\u2022", {kLeft, indent, 1}, y_, plain());
      y_ += paper_.text(note, {kLeft + indent, kWidth - indent}, y_, plain()) + 1;
    }
  }

  /// At the foot of the last page.
  void lines_by_hand() {
    const double high = look_.size * 2.4 + kHandRoom;
    make_room(high);
    spare_ = kBottom - high - y_;
    y_ = kBottom - kHandRoom - look_.size * 1.4;
    const auto count = static_cast<double>(sheet_.by_hand.size());
    const double wide = (kWidth - kHandGap * (count - 1)) / count;
    double x = kLeft;
    for (const std::string& name : sheet_.by_hand) {
      paper_.text(name, {x, wide, 1}, y_, muted());
      paper_.line(x, x + wide, kBottom, 0.75, kInk);
      x += wide + kHandGap;
    }
  }

  Paper& paper_;
  const SetupSheet& sheet_;
  const Picture& picture_;
  Look look_;
  int pages_;
  double y_ = kTop, spare_ = 0;
  int page_ = 1;
};

/// Uses the largest letters for one page, and then the largest picture.
void draw_sheet(Paper& paper, const SetupSheet& sheet) {
  Paper trial_paper("", true);
  const Picture picture(sheet.picture);
  const auto tried = [&](const Look& look) {
    Layout layout(trial_paper, sheet, picture, look, 1);
    layout.draw();
    return layout;
  };
  for (Look look : kLooks) {
    const Layout trial = tried(look);
    if (trial.pages() > 1) continue;
    look.picture = std::min(kHighestPicture, look.picture + trial.spare());
    return Layout(paper, sheet, picture, look, 1).draw();
  }
  Layout(paper, sheet, picture, kManyPages, tried(kManyPages).pages()).draw();
}

}  // namespace

std::string pages_of(const std::vector<report::SetupSheet>& sheets) {
  if (!has_fonts()) throw std::runtime_error("no font is installed for its text; install fonts-dejavu-core");
  Paper paper("Set-up: " + sheets.at(0).part);
  for (const SetupSheet& sheet : sheets) draw_sheet(paper, sheet);
  return paper.finish();
}

}  // namespace clearcut::sheet
