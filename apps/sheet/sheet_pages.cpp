#include "sheet_pages.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "paper.h"

namespace clearcut::sheet {
namespace {

/// Points: margins beside and above the contents of a cell.
constexpr double kBeside = 3.5, kAbove = 1.4;
/// Points. Longer words, for example file names, are divided.
constexpr double kLongWord = 130;
constexpr std::uint32_t kHeadRule = 0x66727f, kRowRule = 0xd5dbe1;

}  // namespace

Table::Table(Paper& paper, const SheetTable& table, double x, double width, double size)
    : paper_(paper), table_(table), x_(x), size_(size) {
  for (const SheetColumn& column : table.columns) names_.push_back(column.name);
  share(width);
}

Style Table::style(std::size_t column, bool is_head) const {
  Style style;
  style.size = size_;
  style.is_bold = is_head;
  style.side = table_.columns[column].is_number ? PANGO_ALIGN_RIGHT : PANGO_ALIGN_LEFT;
  return style;
}

Table::Needs Table::needs_of(std::size_t column) {
  const Style head = style(column, true), body = style(column, false);
  const auto word = [&](const std::string& text, const Style& letters) {
    return std::min(paper_.widest_word(text, letters), kLongWord) + 2 * kBeside;
  };
  Needs needs;
  needs.least = word(names_[column], head);
  needs.body = head_in_two_lines(column) + 2 * kBeside;
  for (const auto& row : table_.rows) {
    const double whole = paper_.width(row[column], body) + 2 * kBeside;
    needs.body = std::max(needs.body, whole);
    needs.least = std::max(needs.least, table_.columns[column].is_number ? whole : word(row[column], body));
  }
  needs.natural = std::max(needs.body, paper_.width(names_[column], head) + 2 * kBeside);
  return needs;
}

double Table::head_in_two_lines(std::size_t column) {
  const std::string& name = names_[column];
  const Style head = style(column, true);
  double width = paper_.width(name, head);
  for (std::size_t at = name.find(' '); at != std::string::npos; at = name.find(' ', at + 1))
    width = std::min(
        width, std::max(paper_.width(name.substr(0, at), head), paper_.width(name.substr(at + 1), head)));
  return width;
}

/// Heads are divided before the cells below, words last; remaining width is spread evenly.
void Table::share(double width) {
  std::vector<Needs> needs;
  Needs all;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    needs.push_back(needs_of(i));
    all.least += needs.back().least;
    all.body += needs.back().body;
    all.natural += needs.back().natural;
  }
  for (const Needs& one : needs) {
    if (all.natural <= width) {
      widths_.push_back(one.natural * width / all.natural);
    } else if (all.body <= width) {
      widths_.push_back(one.body * width / all.body);
    } else if (all.least <= width) {
      const double part = (width - all.least) / (all.body - all.least);
      widths_.push_back(one.least + (one.body - one.least) * part);
    } else {
      widths_.push_back(one.least * width / all.least);
    }
  }
}

double Table::inner_width(std::size_t column) const {
  // Slightly more, so that rounding of the measured width causes no division.
  return widths_[column] - 2 * kBeside + 0.01;
}

double Table::height(const std::vector<std::string>& cells, bool is_head) {
  double height = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    height = std::max(height, paper_.height(cells[i], inner_width(i), style(i, is_head)));
  return height + 2 * kAbove;
}

void Table::draw(const std::vector<std::string>& cells, bool is_head, double y) {
  const double tall = height(cells, is_head);
  double x = x_;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Style letters = style(i, is_head);
    const double below = is_head ? tall - kAbove - paper_.height(cells[i], inner_width(i), letters) : kAbove;
    paper_.text(cells[i], {x + kBeside, inner_width(i)}, y + below, letters);
    x += widths_[i];
  }
  paper_.line(x_, x, y + tall, is_head ? 1 : 0.5, is_head ? kHeadRule : kRowRule);
}

void Table::draw_head(double y) {
  draw(names_, true, y);
}

void Table::draw_row(std::size_t row, double y) {
  draw(table_.rows[row], false, y);
}

namespace {

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

  void table(const SheetTable& content) {
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

std::string pages_of(const std::vector<SetupSheet>& sheets) {
  if (!has_fonts()) throw std::runtime_error("no font is installed for its text; install fonts-dejavu-core");
  Paper paper("Set-up: " + sheets.at(0).part);
  for (const SetupSheet& sheet : sheets) draw_sheet(paper, sheet);
  return paper.finish();
}

}  // namespace clearcut::sheet
