// Gives columns of numbers their width, and divides the rest among columns of text.

#include "app/report/pages/table_layout.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>

#include <QtCore/QRegularExpression>
#include <QtGui/QFontMetricsF>
#include <QtGui/QTextLayout>

#include "app/findings/outcome/display_number.h"

namespace asperity {

namespace {

constexpr double kGap = 200.0;        // between columns: 10 points
constexpr double kNarrowGap = 120.0;  // where that avoids a line break
constexpr double kTolerance = 8.0;  // of a column: a line is not as wide as the sum of its letters
constexpr double kLeadingOfTable = 1.3;

struct Wish {
  double least = 0.0;  ///< the longest word or statement
  double most = 0.0;   ///< everything in one line
};

constexpr QChar kJoiner(0x2060);

/// Prevents line breaks within numbers, ranges (1–5) and units (mm/s), also after the point of
/// ".031".
QString with_numbers_whole(const QString& plain) {
  QString text = QString::fromStdString(with_numbers_unbroken(plain.toStdString()));
  text.replace(QLatin1String("/s"), QString('/') + kJoiner + 's');
  for (const QChar before : {QChar(QChar::Nbsp), QChar('['), QChar(u'−')}) {
    text.replace(QString(before) + '.', QString(before) + '.' + kJoiner);
  }
  static const QRegularExpression range(QStringLiteral(u"(?<=[0-9])–(?=[0-9.])"));
  return text.replace(range, QString(u'–') + kJoiner);
}

/// The widest part without a break. A hash or a long name may break anywhere, a statement such as
/// "W⁺ = 11.50" nowhere.
double least_width(const QString& text, const QFont& font) {
  constexpr double kLongestName = 2400.0;
  double least = 0.0;
  for (QString word : with_numbers_whole(text).split(' ')) {
    const bool is_statement = word.contains(QChar::Nbsp);
    const double width = text_width(word.remove(kJoiner), font);
    least = std::max(least, is_statement ? width : std::min(width, kLongestName));
  }
  return least;
}

Wish wish_of(const ReportTable& table, std::size_t column, const QFont& font, const QFont& bold) {
  const QString heading = QString::fromStdString(table.columns[column].heading);
  Wish wish{least_width(heading, bold), text_width(heading, bold)};
  for (const std::vector<std::string>& row : table.rows) {
    const QString text = QString::fromStdString(row[column]);
    const double all = text_width(text, font);
    // A number and its interval stay on one line.
    const double least = table.columns[column].holds_numbers ? all : least_width(text, font);
    wish.least = std::max(wish.least, least);
    wish.most = std::max(wish.most, all);
  }
  return wish;
}

/// A choice of columns with the fonts that determine their widths.
struct Part {
  std::vector<std::size_t> columns{};
  std::vector<Wish> wishes{};
  QFont font{};
  QFont bold{};

  double least() const {
    return std::accumulate(wishes.begin(), wishes.end(), 0.0,
                           [](double sum, const Wish& wish) { return sum + wish.least; });
  }
  double most() const {
    return std::accumulate(wishes.begin(), wishes.end(), 0.0,
                           [](double sum, const Wish& wish) { return sum + wish.most; });
  }
  double gaps(double gap) const { return gap * static_cast<double>(columns.size() - 1); }
  bool fits(double width) const { return least() + gaps(kNarrowGap) <= width; }
  void add(std::size_t column, const Wish& wish) {
    columns.push_back(column);
    wishes.push_back(wish);
  }
};

/// All columns in letters of this size.
Part whole_part(const ReportTable& table, const QString& family, int pixels) {
  Part part{};
  part.font.setFamily(family);
  part.font.setPixelSize(pixels);
  part.font.setHintingPreference(QFont::PreferNoHinting);
  part.bold = part.font;
  part.bold.setWeight(QFont::DemiBold);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    part.add(i, wish_of(table, i, part.font, part.bold));
  }
  return part;
}

/// The number of leading columns without which rows could not be told apart: the first columns in
/// which no two rows agree, and further columns of words that follow them directly; the first
/// column where no columns distinguish all rows.
std::size_t columns_of_names(const ReportTable& table) {
  std::size_t names = 1;
  for (std::size_t count = 1; count < table.columns.size(); ++count) {
    std::set<std::vector<std::string>> seen{};
    for (const std::vector<std::string>& row : table.rows) {
      seen.emplace(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(count));
    }
    if (seen.size() < table.rows.size()) continue;
    names = count;
    while (names < table.columns.size() && !table.columns[names].holds_numbers) ++names;
    break;
  }
  return names;
}

/// An interval is not separated from its estimate.
bool belongs_to_previous(const ReportColumn& column) {
  return column.heading.find(" CI") != std::string::npos;
}

/// The columns in parts of at most `width`; a part of a single column may be wider.
std::vector<Part> parts_within(const ReportTable& table, const Part& whole, std::size_t names,
                               double width) {
  Part first{.font = whole.font, .bold = whole.bold};
  for (std::size_t i = 0; i < names; ++i) first.add(i, whole.wishes[i]);
  std::vector<Part> parts{first};
  for (std::size_t i = names; i < whole.columns.size();) {
    Part longer = parts.back();
    std::size_t end = i;
    do {
      longer.add(end, whole.wishes[end]);
      ++end;
    } while (end < whole.columns.size() && belongs_to_previous(table.columns[end]));
    if (longer.fits(width) || parts.back().columns.size() == names) {
      parts.back() = longer;
      i = end;
    } else {
      parts.push_back(first);
    }
  }
  return parts;
}

/// As few parts as possible, of similar widths.
std::vector<Part> parts_of(const ReportTable& table, const Part& whole, double width) {
  constexpr double kWidestNames = 0.5;  // of the page; otherwise the first column alone
  std::size_t names = columns_of_names(table);
  Part alone{.font = whole.font, .bold = whole.bold};
  for (std::size_t i = 0; i < names; ++i) alone.add(i, whole.wishes[i]);
  if (names >= table.columns.size() || !alone.fits(kWidestNames * width)) names = 1;
  std::vector<Part> parts = parts_within(table, whole, names, width);
  for (double narrower = 0.95; narrower > kWidestNames; narrower -= 0.05) {
    std::vector<Part> similar = parts_within(table, whole, names, narrower * width);
    if (similar.size() > parts.size()) break;
    parts = std::move(similar);
  }
  return parts;
}

/// The width of each column; where even the minimum widths do not fit, a proportion of the room.
std::vector<double> widths_for(const Part& part, double room) {
  const double least = part.least();
  const double most = part.most();
  std::vector<double> widths{};
  const double share = least > room                  ? 0.0
                       : most > room && most > least ? (room - least) / (most - least)
                                                     : 1.0;
  for (const Wish& wish : part.wishes) {
    widths.push_back(least > room ? wish.least * room / least
                                  : wish.least + share * (wish.most - wish.least));
  }
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

namespace {

LaidOutTable laid_out(const ReportTable& table, const Part& part, double width) {
  LaidOutTable made{.columns = part.columns, .font = part.font, .bold = part.bold};
  const double gap = part.most() + part.gaps(kGap) > width ? kNarrowGap : kGap;
  const double room = width - part.gaps(gap);
  made.line_height = kLeadingOfTable * static_cast<double>(made.font.pixelSize());
  made.padding = 0.18 * static_cast<double>(made.font.pixelSize());
  const std::vector<double> widths = widths_for(part, room);
  double x = 0.0;
  for (const double column : widths) {
    made.left.push_back(x);
    made.right.push_back(x + column);
    x += column + gap;
  }
  std::vector<QString> texts{};
  for (const std::size_t column : part.columns) {
    texts.push_back(QString::fromStdString(table.columns[column].heading));
  }
  made.heading = laid_out_row(texts, widths, made.bold, made.line_height, made.padding);
  for (const std::vector<std::string>& row : table.rows) {
    texts.clear();
    for (const std::size_t column : part.columns) {
      texts.push_back(QString::fromStdString(row[column]));
    }
    made.rows.push_back(laid_out_row(texts, widths, made.font, made.line_height, made.padding));
  }
  return made;
}

}  // namespace

std::vector<LaidOutTable> lay_out(const ReportTable& table, const QString& family, double width) {
  constexpr int kLarge = 160;  // 8 points
  constexpr int kSmall = 140;  // 7 points
  Part whole = whole_part(table, family, table.is_reference ? kSmall : kLarge);
  if (!whole.fits(width)) whole = whole_part(table, family, kSmall);
  if (whole.fits(width)) return {laid_out(table, whole, width)};
  std::vector<LaidOutTable> made{};
  for (const Part& part : parts_of(table, whole, width)) {
    made.push_back(laid_out(table, part, width));
  }
  return made;
}

}  // namespace asperity
