// Measures labels and legends first; the rest of the area is that of the numbers.

#include "app/figures/figure_layout.h"

#include <algorithm>
#include <cmath>

#include <QtGui/QFontDatabase>
#include <QtGui/QFontInfo>
#include <QtGui/QFontMetricsF>
#include <QtGui/QTextLayout>

#include "app/findings/outcome/display_number.h"

namespace asperity {

namespace {

// In units of the font size.
constexpr double kMarginOfFigure = 0.5;
constexpr double kGap = 0.5;            // between a tick and its label, between labels and a name
constexpr double kTick = 0.35;          // its length
constexpr double kRow = 1.9;            // minimum height of a row
constexpr double kMark = 0.75;          // between marks in one row
constexpr double kRowPadding = 0.6;     // around a label of several lines
constexpr double kGreatestCell = 6.0;   // larger ones give no further information
constexpr double kGreatestSquare = 32;  // larger ones give no further information
constexpr double kLowestPlot = 13;
constexpr double kHighestPlot = 28;
constexpr double kHeightOfWidth = 0.6;
constexpr double kKeySample = 2.6;  // its length
constexpr double kShades = 9.0;     // length of the scale of shades
// In proportion to the width of the figure.
constexpr double kWidestRowLabel = 0.4;
constexpr double kWidestCellLabel = 0.28;
constexpr double kWidestLabelAtBothEnds = 0.25;

QFont font_of(const FigureLook& look) {
  QFont font = look.family.isEmpty() ? QFontDatabase::systemFont(QFontDatabase::GeneralFont)
                                     : QFont(look.family);
  // The resolved name of the family, which is written to files.
  font.setFamily(QFontInfo(font).family());
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(look.letters))));
  font.setWeight(QFont::Normal);
  font.setItalic(false);
  font.setHintingPreference(QFont::PreferNoHinting);  // the same width at every resolution
  return font;
}

/// Prevents line breaks within short words in brackets: "(9 of 19)".
QString with_brackets_whole(QString text) {
  constexpr qsizetype kShort = 18;
  for (qsizetype open = text.indexOf('('); open >= 0; open = text.indexOf('(', open + 1)) {
    const qsizetype close = text.indexOf(')', open);
    if (close < 0 || close - open > kShort) continue;
    for (qsizetype i = open; i < close; ++i) {
      if (text[i] == ' ') text[i] = QChar::Nbsp;
    }
  }
  return text;
}

double widest_word(const QString& text, const QFontMetricsF& metrics) {
  double widest = 0.0;
  for (const QString& word : text.split(' ')) {
    widest = std::max(widest, metrics.horizontalAdvance(word));
  }
  return widest;
}

double widest_of(const std::vector<LaidTick>& ticks) {
  double widest = 0.0;
  for (const LaidTick& tick : ticks) widest = std::max(widest, tick.label.width);
  return widest;
}

double highest_of(const std::vector<LaidTick>& ticks) {
  double highest = 0.0;
  for (const LaidTick& tick : ticks) highest = std::max(highest, tick.label.height);
  return highest;
}

double share_of(const FigureAxis& axis, double value) {
  if (axis.scale == AxisScale::log10) {
    return std::log10(value / axis.low) / std::log10(axis.high / axis.low);
  }
  return (value - axis.low) / (axis.high - axis.low);
}

/// Of a plot with the same units on both axes.
double height_of_width(const Figure& figure) {
  return (figure.y.high - figure.y.low) / (figure.x.high - figure.x.low);
}

Phrase name_of(const FigureAxis& axis) {
  if (axis.unit.empty()) return axis.name;
  return phrase("Figures", "%1 (%2)").with(axis.name, axis.unit);
}

}  // namespace

FigureLayout::FigureLayout(const Figure& figure, double width, const FigureLook& look)
    : figure_(figure), look_(look), width_(width), letters_(look.letters), font_(font_of(look)) {
  const double margin = kMarginOfFigure * letters_;
  if (!figure.is_drawn()) {
    sentence_ = broken(words(figure.instead), width - 2.0 * margin);
    height_ = sentence_.height + 2.0 * margin;
    return;
  }
  lay_key();
  lay_labels();
  lay_names();
  place_ticks();
}

QString FigureLayout::words(const Phrase& phrase) const {
  return QString::fromStdString(look_.look_up ? phrase.translated(look_.look_up)
                                              : phrase.english());
}

TextLines FigureLayout::broken(const QString& whole, double width) const {
  TextLines laid{};
  if (whole.isEmpty()) return laid;
  const QString text =
      with_brackets_whole(QString::fromStdString(with_numbers_unbroken(whole.toStdString())));
  const QFontMetricsF metrics(font_);
  QTextLayout layout(text, font_);
  QTextOption option{};
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  layout.setTextOption(option);
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(std::max(width, letters_));
    laid.lines << text.mid(line.textStart(), line.textLength()).trimmed();
    laid.width = std::max(laid.width, metrics.horizontalAdvance(laid.lines.back()));
  }
  layout.endLayout();
  laid.height = metrics.height() * static_cast<double>(laid.lines.size());
  return laid;
}

void FigureLayout::lay_key() {
  QStringList names{};
  for (const FigureSeries& one : figure_.series) {
    const QString name = words(one.name);
    if (!name.isEmpty() && !names.contains(name)) names << name;
  }
  if (names.size() < 2) return;
  const QFontMetricsF metrics(font_);
  const double line = metrics.height() * 1.2;
  const double left = kMarginOfFigure * letters_;
  QPointF at(left, left + line / 2.0);
  for (std::size_t i = 0; i < figure_.series.size(); ++i) {
    const QString name = words(figure_.series[i].name);
    if (!names.contains(name)) continue;
    names.removeAll(name);
    const double length =
        (kKeySample + kGap) * letters_ + metrics.horizontalAdvance(name) + 2.0 * letters_;
    if (at.x() > left && at.x() + length - 2.0 * letters_ > width_ - left) {
      at = {left, at.y() + line};
    }
    key_.push_back({.series = i, .at = at, .name = name});
    at.rx() += length;
  }
  key_height_ = at.y() + line / 2.0 + kGap * letters_ - kMarginOfFigure * letters_;
}

void FigureLayout::lay_labels() {
  const bool cells = !figure_.cells.empty();
  const QFontMetricsF metrics(font_);
  const double widest = figure_.y.places.empty()       ? width_
                        : cells                        ? kWidestCellLabel * width_
                        : figure_.y.far_places.empty() ? kWidestRowLabel * width_
                                                       : kWidestLabelAtBothEnds * width_;
  constexpr int kVerticalLabels = 5;
  const bool has_same_units = figure_.shape == FigureShape::square && !cells;
  FigureAxis vertical = figure_.y;
  // In the same units the steps are the same, which follow from the length of the range.
  if (has_same_units) vertical.high = vertical.low + (figure_.x.high - figure_.x.low);
  for (const AxisTick& tick : ticks_of(vertical, kVerticalLabels)) {
    if (has_same_units && tick.value > figure_.y.high) continue;
    y_ticks_.push_back({.at = tick.value, .label = broken(words(tick.label), widest)});
  }
  for (const Phrase& place : figure_.y.far_places) {
    far_ticks_.push_back(
        {.at = static_cast<double>(far_ticks_.size()), .label = broken(words(place), widest)});
  }
  // The rotated name next to the labels is as wide as a line is high, if there is a name.
  const double name_breadth = figure_.y.name.empty() ? 0.0 : metrics.height() + kGap * letters_;
  const double left = kMarginOfFigure * letters_ + name_breadth + widest_of(y_ticks_) +
                      (y_ticks_.empty() ? 0.0 : kGap * letters_) + kTick * letters_;
  const double right =
      kMarginOfFigure * letters_ +
      (far_ticks_.empty() ? letters_ : widest_of(far_ticks_) + (kGap + kTick) * letters_);
  double breadth = width_ - left - right;
  if (has_same_units) {
    breadth = std::min(breadth, kGreatestSquare * letters_);
  }
  if (cells) {
    const auto columns = static_cast<double>(figure_.x.places.size());
    breadth = columns * std::min(breadth / columns, kGreatestCell * letters_);
  }
  // The name of a vertical line is above the rows.
  const bool named_line = !figure_.y.places.empty() && !figure_.references.empty();
  const double top =
      kMarginOfFigure * letters_ + key_height_ + (named_line ? metrics.height() : 0.0);
  plot_ = QRectF(left, top, std::max(breadth, letters_), 0.0);

  if (!figure_.x.places.empty()) {
    const double column = plot_.width() / static_cast<double>(figure_.x.places.size());
    const double room = column - 0.4 * letters_;
    for (const Phrase& place : figure_.x.places) {
      upright_x_labels_ = upright_x_labels_ || widest_word(words(place), metrics) > room;
    }
    constexpr double kLongestUpright = 10.0;
    for (const AxisTick& tick : ticks_of(figure_.x, 0)) {
      x_ticks_.push_back({.at = tick.value,
                          .label = broken(words(tick.label),
                                          upright_x_labels_ ? kLongestUpright * letters_ : room)});
    }
    return;
  }
  // Both axes of one scale have the same ticks.
  const int most = figure_.shape == FigureShape::square ? kVerticalLabels : 7;
  for (int labels = most; labels > 1; --labels) {
    x_ticks_.clear();
    double taken = 0.0;
    for (const AxisTick& tick : ticks_of(figure_.x, labels)) {
      x_ticks_.push_back({.at = tick.value, .label = broken(words(tick.label), width_)});
      if (!tick.label.empty()) taken += x_ticks_.back().label.width + 1.2 * letters_;
    }
    if (taken <= plot_.width() + 1.2 * letters_) break;
  }
}

void FigureLayout::lay_rows() {
  const bool cells = !figure_.cells.empty();
  const auto columns = static_cast<double>(std::max<std::size_t>(figure_.x.places.size(), 1));
  double bottom = plot_.top();
  const auto marks = static_cast<double>(figure_.marks_per_row);
  const double lowest =
      std::max(kRow, figure_.marks_per_row > 1 ? kMark * (marks + kRoomBetweenRows) : 0.0);
  for (std::size_t i = 0; i < y_ticks_.size(); ++i) {
    const double label = std::max(y_ticks_[i].label.height,
                                  i < far_ticks_.size() ? far_ticks_[i].label.height : 0.0);
    // Cells are squares as far as their names fit, and all of one size.
    const double height = cells ? std::max(plot_.width() / columns, highest_of(y_ticks_))
                                : std::max(lowest * letters_, label + kRowPadding * letters_);
    row_middles_.push_back(bottom + height / 2.0);
    bottom += height;
    row_bottoms_.push_back(bottom);
  }
  plot_.setBottom(bottom);
}

void FigureLayout::lay_names() {
  const bool cells = !figure_.cells.empty();
  if (!figure_.y.places.empty()) {
    lay_rows();
  } else if (figure_.shape == FigureShape::square) {
    plot_.setHeight(plot_.width() * height_of_width(figure_));
  } else {
    plot_.setHeight(std::clamp(kHeightOfWidth * plot_.width(), kLowestPlot * letters_,
                               kHighestPlot * letters_));
  }
  x_name_ = broken(words(name_of(figure_.x)), plot_.width());
  y_name_ = broken(words(name_of(figure_.y)), std::max(plot_.height(), kLowestPlot * letters_));
  // A name of several lines reduces the height of the plot.
  const QFontMetricsF metrics(font_);
  if (y_name_.lines.size() > 1) plot_.setLeft(plot_.left() + y_name_.height - metrics.height());

  double bottom = plot_.bottom() + kTick * letters_;
  if (!x_ticks_.empty()) {
    bottom +=
        kGap * letters_ * 0.5 + (upright_x_labels_ ? widest_of(x_ticks_) : highest_of(x_ticks_));
  }
  if (!x_name_.lines.isEmpty()) bottom += kGap * letters_ + x_name_.height;
  if (cells && !figure_.shade_name.empty()) {
    shades_ =
        QRectF(plot_.left(), bottom + letters_ + metrics.height(),
               std::min(kShades * letters_, width_ - plot_.left() - letters_), 0.7 * letters_);
    bottom = shades_.bottom() + kGap * letters_ * 0.5 + metrics.height();
  }
  height_ = bottom + kMarginOfFigure * letters_;
}

void FigureLayout::place_ticks() {
  for (LaidTick& tick : x_ticks_) tick.at = x_of(tick.at);
  for (LaidTick& tick : y_ticks_) tick.at = y_of(tick.at);
  for (LaidTick& tick : far_ticks_) tick.at = y_of(tick.at);
}

double FigureLayout::x_of(double value) const {
  if (!figure_.x.places.empty()) {
    const auto places = static_cast<double>(figure_.x.places.size());
    return plot_.left() + (value + 0.5) / places * plot_.width();
  }
  return plot_.left() + share_of(figure_.x, value) * plot_.width();
}

double FigureLayout::y_of(double value) const {
  if (!figure_.y.places.empty()) {
    if (row_middles_.size() == 1) return row_middles_.front() + value * plot_.height();
    // Beyond the outermost rows at the distance of adjacent rows.
    const auto last = static_cast<double>(row_middles_.size() - 2);
    const auto row = static_cast<std::size_t>(std::clamp(value, 0.0, last));
    const double between = value - static_cast<double>(row);
    return row_middles_[row] + between * (row_middles_[row + 1] - row_middles_[row]);
  }
  return plot_.bottom() - share_of(figure_.y, value) * plot_.height();
}

}  // namespace asperity
