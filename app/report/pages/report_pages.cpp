// Fills pages from top to bottom: headings stay with what follows, and rows of tables are not divided.

#include "app/report/pages/report_pages.h"

#include <algorithm>
#include <utility>

#include <QtGui/QFontDatabase>
#include <QtGui/QFontMetricsF>
#include <QtGui/QPainter>

#include "app/figures/draw_figure.h"
#include "app/report/pages/table_layout.h"

namespace asperity {

namespace {

constexpr double kUnitsPer_mm = kReportUnitsPerInch / 25.4;
constexpr double kPageWidth = 210.0 * kUnitsPer_mm;
constexpr double kPageHeight = 297.0 * kUnitsPer_mm;
constexpr double kSide = 20.0 * kUnitsPer_mm;
constexpr double kTop = 26.0 * kUnitsPer_mm;
constexpr double kBottom = 22.0 * kUnitsPer_mm;
constexpr double kHeadLine = 17.0 * kUnitsPer_mm;  // the baseline of the page's heading
constexpr double kFootLine = 284.0 * kUnitsPer_mm;
constexpr double kIndent = 240.0;  // of the items of a list
constexpr double kHair = 10.0;     // half a point
constexpr double kRule = 20.0;

constexpr int kTitlePixels = 400;  // 20 points, and so on
constexpr int kChapterPixels = 300;
constexpr int kSectionPixels = 230;
constexpr int kTextPixels = 190;
constexpr int kCaptionPixels = 170;
constexpr int kNotePixels = 150;
constexpr int kSmallPixels = 150;
constexpr double kLeadingOfText = 1.38;

constexpr double kLargestMovedTable = 0.45;  // of a page: smaller ones are kept in one piece
constexpr std::size_t kLeastRows = 3;        // of a table at the end of a page
constexpr double kLeastFigure = 0.7;  // of its width, where it then stays on the page of its answer
// of the headings of a chapter and a section, which may precede it
constexpr double kHeadingsHeight = 1600.0;

const QColor kInk(0x1a, 0x1a, 0x1a);
const QColor kGrey(0x55, 0x55, 0x55);
const QColor kAmber(0xff, 0xd4, 0x7a);
const QColor kViolet(0x5b, 0x3a, 0x8e);
const QColor kNotice(0xb3, 0x6b, 0x00);

double line_height(const QFont& font) { return kLeadingOfText * font.pixelSize(); }

double figure_width(const Figure& figure) {
  const double whole = ReportPages::text_area().width();
  switch (figure.shape) {
    case FigureShape::rows:
      return whole;
    case FigureShape::wide:
      return 0.85 * whole;
    case FigureShape::square:
      return 0.6 * whole;
  }
  return whole;
}

/// Fills pages from top to bottom, block by block.
class PageMaker final {
 public:
  PageMaker(const Report& report, std::vector<std::vector<PageMark>>& pages)
      : report_(report), pages_(pages), area_(ReportPages::text_area()) {
    family_ = QFontDatabase::systemFont(QFontDatabase::GeneralFont).family();
    look_.family = family_;
    look_.letters = 150.0;
  }

  void begin_chapter(const ReportChapter& chapter) {
    chapter_ = &chapter;
    new_page();
    if (pages_.size() == 1) {
      place_lines(QString::fromStdString(report_.title), font(kTitlePixels, true), kInk, 0.0);
      place_lines(QString::fromStdString(report_.subtitle) + '.', font(kTextPixels), kGrey, 0.0);
      y_ += 300.0;
    }
    place_lines(QString::fromStdString(chapter.heading), font(kChapterPixels, true), kInk, 0.0);
    y_ += 60.0;
  }

  void place_section(const ReportSection& section) {
    const QFont heading = font(kSectionPixels, true);
    const double before = y_ > area_.top() ? 220.0 : 0.0;
    const double wanted = before + line_height(heading) + 60.0 +
                          (section.parts.empty() ? 0.0 : height_together(section, 0));
    if (y_ + wanted > area_.bottom()) {
      new_page();
    } else {
      y_ += before;
    }
    place_lines(QString::fromStdString(section.heading), heading, kInk, 0.0);
    y_ += 60.0;
    for (std::size_t i = 0; i < section.parts.size(); ++i) {
      need(height_together(section, i));
      std::visit([this](const auto& part) { place(part); }, section.parts[i]);
    }
  }

  /// Called once the number of pages is known.
  void number_pages() {
    const QFont small = font(kSmallPixels);
    for (std::size_t i = 0; i < pages_.size(); ++i) {
      const QString number = QString("Page %1 of %2").arg(i + 1).arg(pages_.size());
      add_text(pages_[i], {area_.right() - text_width(number, small), kFootLine}, number, small,
               kGrey);
      add_text(pages_[i], {area_.left(), kFootLine}, QString::fromStdString(report_.program), small,
               kGrey);
    }
  }

 private:
  QFont font(int pixels, bool bold = false) const {
    QFont made(family_);
    made.setPixelSize(pixels);
    made.setHintingPreference(QFont::PreferNoHinting);
    if (bold) made.setWeight(QFont::DemiBold);
    return made;
  }

  static void add_text(std::vector<PageMark>& page, QPointF baseline, const QString& text,
                       const QFont& font, const QColor& color) {
    page.emplace_back(PageText{baseline, text, font, color, text_width(text, font)});
  }
  void add_box(const QRectF& place, const QColor& color) {
    pages_.back().emplace_back(PageBox{place, color});
  }

  void new_page() {
    pages_.emplace_back();
    y_ = area_.top();
    std::vector<PageMark>& page = pages_.back();
    const QFont small = font(kSmallPixels);
    double room = area_.width();
    if (!chapter_->mark.empty()) {
      const QFont bold = font(kSmallPixels, true);
      const QString mark = QString::fromStdString(chapter_->mark);
      const double width = text_width(mark, bold) + 200.0;
      const bool is_pilot = chapter_->group == AnswerGroup::pilot;
      add_box({area_.right() - width, kHeadLine - 190.0, width, 270.0},
              is_pilot ? kAmber : kViolet);
      add_text(page, {area_.right() - width + 100.0, kHeadLine}, mark, bold,
               is_pilot ? kInk : QColor(Qt::white));
      room -= width + 200.0;
    }
    const QString heading = QString::fromStdString(report_.title + " · " + chapter_->heading);
    add_text(page, {area_.left(), kHeadLine},
             QFontMetricsF(small).elidedText(heading, Qt::ElideRight, room), small, kGrey);
    add_box({area_.left(), kHeadLine + 110.0, area_.width(), kHair}, kGrey);
  }

  /// Begins a new page where this height does not fit.
  void need(double height) {
    if (y_ + height > area_.bottom() && y_ > area_.top()) new_page();
  }

  /// Places one line at the current height, `indent` from the left.
  void place_line(const QString& line, const QFont& font, const QColor& color, double indent) {
    const double height = line_height(font);
    const double baseline = y_ + 0.5 * height + 0.36 * font.pixelSize();
    add_text(pages_.back(), {area_.left() + indent, baseline}, line, font, color);
    y_ += height;
  }

  /// Places all lines of a text; if it does not fit, at least two on each page. Before the lines of
  /// a page, `before_lines` receives their number.
  void place_lines(const QString& text, const QFont& font, const QColor& color, double indent,
                   const std::function<void(double height)>& before_lines = {}) {
    const QStringList lines = broken_lines(text, font, area_.width() - indent);
    const double height = line_height(font);
    qsizetype next = 0;
    while (next < lines.size()) {
      const qsizetype left = lines.size() - next;
      qsizetype fitting = static_cast<qsizetype>((area_.bottom() - y_ + 1.0) / height);
      if (fitting < left) {
        if (left - fitting == 1) --fitting;
        if (fitting < 2 && y_ > area_.top()) {
          new_page();
          continue;
        }
        fitting = std::max<qsizetype>(fitting, 1);
      }
      const qsizetype now = std::min(fitting, left);
      if (before_lines) before_lines(static_cast<double>(now) * height);
      for (qsizetype i = 0; i < now; ++i) place_line(lines[next + i], font, color, indent);
      next += now;
      if (next < lines.size()) new_page();
    }
  }

  double height_of(const ReportText& part) const {
    const double indent = part.tone == ReportText::Tone::notice ? kIndent : 0.0;
    const QFont used = font(kTextPixels, part.tone == ReportText::Tone::lead);
    const QStringList lines =
        broken_lines(QString::fromStdString(part.text), used, area_.width() - indent);
    return static_cast<double>(lines.size()) * line_height(used) + 90.0;
  }

  /// The minimum height of the part `from` together with what belongs to it on the same page: an
  /// answer with its method and its figure, a line that introduces a list or a table with the
  /// beginning of that.
  double height_together(const ReportSection& section, std::size_t from) {
    const double alone = least_height(section.parts[from]);
    const auto* text = std::get_if<ReportText>(&section.parts[from]);
    if (text == nullptr) return alone;
    double height = height_of(*text);
    if (text->text.ends_with(':') && from + 1 < section.parts.size()) {
      return height + least_height(section.parts[from + 1]);
    }
    if (text->tone != ReportText::Tone::lead) return alone;
    for (std::size_t i = from + 1; i < section.parts.size(); ++i) {
      if (const auto* figure = std::get_if<ReportFigure>(&section.parts[i])) {
        height += least_height_of(*figure);
        return height <= area_.height() - kHeadingsHeight ? height : alone;
      }
      const auto* further = std::get_if<ReportText>(&section.parts[i]);
      if (further == nullptr || further->tone == ReportText::Tone::lead) break;
      height += height_of(*further);
    }
    return alone;
  }

  double least_height(const ReportPart& part) {
    if (const auto* table = std::get_if<ReportTable>(&part)) return least_height_of(*table);
    if (const auto* figure = std::get_if<ReportFigure>(&part)) return least_height_of(*figure);
    return 2.0 * line_height(font(kTextPixels));
  }

  void place(const ReportText& part) {
    const QString text = QString::fromStdString(part.text);
    switch (part.tone) {
      case ReportText::Tone::plain:
        place_lines(text, font(kTextPixels), kInk, 0.0);
        break;
      case ReportText::Tone::lead:
        place_lines(text, font(kTextPixels, true), kInk, 0.0);
        break;
      case ReportText::Tone::notice:
        place_lines(text, font(kTextPixels), kInk, kIndent, [this](double height) {
          add_box({area_.left(), y_ + 20.0, 50.0, height - 40.0}, kNotice);
        });
        break;
    }
    y_ += 90.0;
  }

  void place(const ReportList& part) {
    for (const std::string& item : part.items) {
      const QFont text = font(kTextPixels);
      bool first = true;
      place_lines(QString::fromStdString(item), text, kInk, kIndent, [&](double) {
        if (!std::exchange(first, false)) return;
        const double baseline = y_ + 0.5 * line_height(text) + 0.36 * text.pixelSize();
        add_text(pages_.back(), {area_.left() + 60.0, baseline}, "•", text, kInk);
      });
      y_ += 40.0;
    }
    y_ += 50.0;
  }

  double title_height(const QString& title) {
    const QFont bold = font(kCaptionPixels, true);
    return static_cast<double>(broken_lines(title, bold, area_.width()).size()) *
               line_height(bold) +
           40.0;
  }

  static QString title_of(const ReportTable& table) {
    return QString("Table %1. ").arg(table.number) + QString::fromStdString(table.title);
  }

  static double whole_height(const LaidOutTable& made) {
    double height = made.heading.height + 60.0;
    for (const LaidOutRow& row : made.rows) height += row.height;
    return height;
  }

  double least_height_of(const ReportTable& table) {
    return least_height_of(table, lay_out(table, family_, area_.width()).front());
  }

  double least_height_of(const ReportTable& table, const LaidOutTable& made) {
    const double title = title_height(title_of(table)) + 100.0;
    const double whole = title + whole_height(made);
    if (whole <= kLargestMovedTable * area_.height()) return whole;
    double least = title + made.heading.height + 60.0;
    for (std::size_t i = 0; i < std::min(kLeastRows, made.rows.size()); ++i) {
      least += made.rows[i].height;
    }
    return least;
  }

  void place_row(const ReportTable& table, const LaidOutTable& made, const LaidOutRow& row,
                 const QFont& font) {
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      double baseline = y_ + made.padding + 0.5 * made.line_height + 0.36 * font.pixelSize();
      for (const QString& line : row.cells[i]) {
        const double x = table.columns[made.columns[i]].holds_numbers
                             ? made.right[i] - text_width(line, font)
                             : made.left[i];
        add_text(pages_.back(), {area_.left() + x, baseline}, line, font, kInk);
        baseline += made.line_height;
      }
    }
    y_ += row.height;
  }

  /// The number of rows from `next` that fit on this page.
  std::size_t rows_that_fit(const LaidOutTable& made, std::size_t next) const {
    double room = area_.bottom() - y_ - made.heading.height - 60.0;
    std::size_t fitting = 0;
    while (next + fitting < made.rows.size() && made.rows[next + fitting].height <= room) {
      room -= made.rows[next + fitting].height;
      ++fitting;
    }
    // The last page has at least two rows.
    const std::size_t left = made.rows.size() - next;
    if (left - fitting == 1 && fitting > kLeastRows) --fitting;
    return std::max<std::size_t>(fitting, 1);
  }

  /// The columns of a table that stand side by side, on as many pages as they need.
  void place_columns(const ReportTable& table, const LaidOutTable& made, QString title) {
    const QFont bold = font(kCaptionPixels, true);
    need(least_height_of(table, made));
    if (y_ > area_.top()) y_ += 100.0;
    const double width = made.right.empty() ? 0.0 : made.right.back();
    std::size_t next = 0;
    do {
      place_lines(title, bold, kInk, 0.0);
      title = QString("Table %1, continued").arg(table.number);
      y_ += 40.0;
      const std::size_t now = made.rows.empty() ? 0 : rows_that_fit(made, next);
      add_box({area_.left(), y_, width, kRule}, kInk);
      y_ += kRule;
      place_row(table, made, made.heading, made.bold);
      add_box({area_.left(), y_, width, kHair}, kInk);
      y_ += kHair;
      for (std::size_t i = 0; i < now; ++i) place_row(table, made, made.rows[next + i], made.font);
      add_box({area_.left(), y_, width, kRule}, kInk);
      y_ += kRule;
      next += now;
      if (next < made.rows.size()) new_page();
    } while (next < made.rows.size());
  }

  void place(const ReportTable& table) {
    QString title = title_of(table);
    for (const LaidOutTable& made : lay_out(table, family_, area_.width())) {
      place_columns(table, made, title);
      title = QString("Table %1, further columns").arg(table.number);
    }
    if (!table.note.empty()) {
      y_ += 40.0;
      place_lines(QString::fromStdString(table.note), font(kNotePixels), kGrey, 0.0);
    }
    y_ += 140.0;
  }

  static QString caption_of(const ReportFigure& part) {
    const Figure& figure = part.figure;
    const QString title = QString::fromStdString(figure.title.english());
    if (!figure.is_drawn()) {
      return title + ". " + QString::fromStdString(figure.instead.as_sentence().english());
    }
    return QString("Figure %1. ").arg(part.number) + title + ". " +
           QString::fromStdString(figure.note.english());
  }

  QSizeF size_of(const Figure& figure) const {
    double width = figure_width(figure);
    double height = figure_height(figure, width, look_);
    const double most = 0.75 * area_.height();
    if (height > most && figure.shape != FigureShape::rows) {
      width *= most / height;
      height = figure_height(figure, width, look_);
    }
    return {width, std::min(height, 0.85 * area_.height())};
  }

  /// The largest size that is no higher than `room`; the minimum size where none is. A figure with
  /// rows has the height of its rows.
  QSizeF size_within(const Figure& figure, double room) const {
    const QSizeF whole = size_of(figure);
    if (figure.shape == FigureShape::rows) return whole;
    constexpr int kSteps = 12;
    QSizeF size = whole;
    for (int step = 1; step <= kSteps && size.height() > room; ++step) {
      const double share = 1.0 - (1.0 - kLeastFigure) * step / kSteps;
      const double width = share * whole.width();
      size = {width, std::min(figure_height(figure, width, look_), 0.85 * area_.height())};
    }
    return size;
  }

  double caption_height(const ReportFigure& part) const {
    const double lines = static_cast<double>(
        broken_lines(caption_of(part), font(kCaptionPixels), area_.width()).size());
    return lines * line_height(font(kCaptionPixels)) + 60.0;
  }

  /// At its minimum size.
  double least_height_of(const ReportFigure& part) {
    const double caption = caption_height(part);
    return part.figure.is_drawn() ? 100.0 + size_within(part.figure, 0.0).height() + caption
                                  : caption;
  }

  void place(const ReportFigure& part) {
    need(least_height_of(part));
    if (part.figure.is_drawn()) {
      y_ += 100.0;
      const double room = area_.bottom() - y_ - caption_height(part);
      const QRectF into({area_.left(), y_}, size_within(part.figure, room));
      pages_.back().emplace_back(PageFigure{into, &part.figure});
      y_ += into.height() + 60.0;
    }
    place_lines(caption_of(part), font(kCaptionPixels), kInk, 0.0);
    y_ += 140.0;
  }

  const Report& report_;
  std::vector<std::vector<PageMark>>& pages_;
  QRectF area_{};
  QString family_{};
  FigureLook look_{};
  const ReportChapter* chapter_ = nullptr;
  double y_ = 0.0;
};

}  // namespace

QSizeF ReportPages::size() { return {kPageWidth, kPageHeight}; }

QRectF ReportPages::text_area() {
  return {kSide, kTop, kPageWidth - 2.0 * kSide, kPageHeight - kTop - kBottom};
}

ReportPages::ReportPages(const Report& report, const std::stop_token& stop,
                         const std::function<void(double)>& progress) {
  PageMaker maker(report, pages_);
  std::size_t sections = 0;
  for (const ReportChapter& chapter : report.chapters) sections += chapter.sections.size();
  std::size_t done = 0;
  for (const ReportChapter& chapter : report.chapters) {
    maker.begin_chapter(chapter);
    for (const ReportSection& section : chapter.sections) {
      if (stop.stop_requested()) return;
      maker.place_section(section);
      if (progress) progress(static_cast<double>(++done) / static_cast<double>(sections));
    }
  }
  maker.number_pages();
}

void ReportPages::draw(std::size_t page, QPainter& painter) const {
  painter.save();
  for (const PageMark& mark : marks(page)) {
    if (const auto* box = std::get_if<PageBox>(&mark)) {
      painter.fillRect(box->place, box->color);
    } else if (const auto* text = std::get_if<PageText>(&mark)) {
      painter.setFont(text->font);
      painter.setPen(text->color);
      painter.drawText(text->baseline, text->text);
    } else if (const auto* figure = std::get_if<PageFigure>(&mark)) {
      FigureLook look{};
      look.family = QFontDatabase::systemFont(QFontDatabase::GeneralFont).family();
      look.letters = 150.0;
      draw_figure(*figure->figure, painter, figure->place, look);
    }
  }
  painter.restore();
}

}  // namespace asperity
