#include "app/report/pages/table_layout.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <QtGui/QFontMetricsF>
#include <QtGui/QTextLayout>

#include "app/findings/reading_number.h"

namespace asperity {

namespace {

constexpr double kGap = 200.0;        // between columns: 10 points
constexpr double kNarrowGap = 120.0;  // where that avoids a line break
constexpr double kTolerance = 8.0;  // of a column: a line is not as wide as the sum of its letters
constexpr double kLeadingOfTable = 1.3;

struct Wish {
  double least = 0.0;  ///< the longest word
  double most = 0.0;   ///< everything in one line
};

double longest_word(const QString& text, const QFont& font) {
  double longest = 0.0;
  for (const QString& word : text.split(' ')) longest = std::max(longest, text_width(word, font));
  return longest;
}

std::vector<Wish> wishes_of(const ReportTable& table, const QFont& font, const QFont& bold) {
  std::vector<Wish> wishes(table.columns.size());
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const QString heading = QString::fromStdString(table.columns[i].heading);
    wishes[i] = {longest_word(heading, bold), text_width(heading, bold)};
    for (const std::vector<std::string>& row : table.rows) {
      const QString text = QString::fromStdString(row[i]);
      const double all = text_width(text, font);
      // A number and its interval stay on one line; a hash or a long name may break anywhere.
      const double least =
          table.columns[i].holds_numbers ? all : std::min(longest_word(text, font), 2400.0);
      wishes[i].least = std::max(wishes[i].least, least);
      wishes[i].most = std::max(wishes[i].most, all);
    }
  }
  return wishes;
}

/// The width of each column; empty where even the minimum widths do not fit.
std::vector<double> widths_for(const std::vector<Wish>& wishes, double room) {
  double least = 0.0;
  double most = 0.0;
  for (const Wish& wish : wishes) {
    least += wish.least;
    most += wish.most;
  }
  if (least > room) return {};
  std::vector<double> widths{};
  const double share = most > room && most > least ? (room - least) / (most - least) : 1.0;
  for (const Wish& wish : wishes) widths.push_back(wish.least + share * (wish.most - wish.least));
  return widths;
}

LaidOutRow laid_out_row(const std::vector<QString>& texts, const std::vector<double>& widths,
                        const QFont& font, double line_height, double padding) {
  LaidOutRow row{};
  qsizetype lines = 1;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    row.cells.push_back(broken_lines(texts[i], font, widths[i] + kTolerance));
    lines = std::max(lines, row.cells.back().size());
  }
  row.height = static_cast<double>(lines) * line_height + 2.0 * padding;
  return row;
}

}  // namespace

double text_width(const QString& text, const QFont& font) {
  return QFontMetricsF(font).horizontalAdvance(text);
}

namespace {

constexpr QChar kJoiner(0x2060);

/// Prevents line breaks within numbers and units (mm/s), also after the point of ".031".
QString with_numbers_whole(const QString& plain) {
  QString text = QString::fromStdString(with_numbers_unbroken(plain.toStdString()));
  text.replace(QLatin1String("/s"), QString('/') + kJoiner + 's');
  for (const QChar before : {QChar(QChar::Nbsp), QChar('['), QChar(u'−')}) {
    text.replace(QString(before) + '.', QString(before) + '.' + kJoiner);
  }
  return text;
}

}  // namespace

QStringList broken_lines(const QString& text, const QFont& font, double width) {
  QStringList lines{};
  for (QString paragraph : text.split('\n')) {
    paragraph = with_numbers_whole(paragraph);
    QTextLayout layout(paragraph, font);
    QTextOption option{};
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(width);
      lines << paragraph.mid(line.textStart(), line.textLength())
                   .remove(kJoiner)
                   .replace(QChar::Nbsp, ' ')
                   .trimmed();
    }
    layout.endLayout();
  }
  return lines;
}

LaidOutTable lay_out(const ReportTable& table, const QString& family, double width) {
  LaidOutTable made{};
  std::vector<double> widths{};
  const auto gaps = static_cast<double>(table.columns.size() - 1);
  double gap = kGap;
  // 8, 7, 6 and, as a last resort, 5 points.
  constexpr std::array<int, 4> kSizes{160, 140, 120, 100};
  for (std::size_t size = table.is_reference ? 1 : 0; size < kSizes.size(); ++size) {
    made.font.setFamily(family);
    made.font.setPixelSize(kSizes[size]);
    made.font.setHintingPreference(QFont::PreferNoHinting);
    made.bold = made.font;
    made.bold.setWeight(QFont::DemiBold);
    const std::vector<Wish> wishes = wishes_of(table, made.font, made.bold);
    const double most =
        std::accumulate(wishes.begin(), wishes.end(), 0.0,
                        [](double sum, const Wish& wish) { return sum + wish.most; });
    gap = most + gaps * kGap > width ? kNarrowGap : kGap;
    const double room = width - gaps * gap;
    widths = widths_for(wishes, room);
    if (!widths.empty()) break;
    // Nothing fits: all columns break, each with a proportion of the room.
    const double least =
        std::accumulate(wishes.begin(), wishes.end(), 0.0,
                        [](double sum, const Wish& wish) { return sum + wish.least; });
    if (size + 1 < kSizes.size()) continue;
    for (const Wish& wish : wishes) widths.push_back(wish.least * room / least);
  }
  made.line_height = kLeadingOfTable * static_cast<double>(made.font.pixelSize());
  made.padding = 0.18 * static_cast<double>(made.font.pixelSize());
  double x = 0.0;
  for (const double column : widths) {
    made.left.push_back(x);
    made.right.push_back(x + column);
    x += column + gap;
  }
  std::vector<QString> texts{};
  for (const ReportColumn& column : table.columns) {
    texts.push_back(QString::fromStdString(column.heading));
  }
  made.heading = laid_out_row(texts, widths, made.bold, made.line_height, made.padding);
  for (const std::vector<std::string>& row : table.rows) {
    texts.clear();
    for (const std::string& cell : row) texts.push_back(QString::fromStdString(cell));
    made.rows.push_back(laid_out_row(texts, widths, made.font, made.line_height, made.padding));
  }
  return made;
}

}  // namespace asperity
