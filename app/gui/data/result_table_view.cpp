// Chooses the widths of columns from the widths of their cells, their headings in one to three lines, and the room.

#include "app/gui/data/result_table_view.h"

#include <algorithm>
#include <initializer_list>
#include <numeric>

#include <QtCore/QEvent>
#include <QtGui/QFontMetrics>
#include <QtGui/QStandardItemModel>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QScrollBar>

#include "app/findings/outcome/displayed_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

constexpr int kPaddingOfHeading = 22;  // as the style sheet says, with the margin of the style
constexpr int kHeightOfPadding = 16;
/// Widths of elided names.
constexpr int kNarrowestName = 84;
constexpr int kNameThatScrolls = 160;

int sum_of(const std::vector<int>& widths) {
  return std::accumulate(widths.begin(), widths.end(), 0);
}

}  // namespace

ResultTableView::ResultTableView(const ResultTable& table, QWidget* parent) : QTableView(parent) {
  const DisplayedTable shown = displayed(table, Reader::window);
  setObjectName(QString::fromStdString("table_" + table.name));
  auto* model = new QStandardItemModel(this);
  QStringList headings{};
  for (const DisplayedColumn& column : shown.columns) {
    headings << words_as_published(column.heading);
    columns_.push_back({.holds_words = column.holds_words});
  }
  model->setHorizontalHeaderLabels(headings);
  const auto alignment_of = [&shown](std::size_t column) {
    return (shown.columns[column].holds_words ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
  };
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    auto* heading = model->horizontalHeaderItem(static_cast<int>(i));
    heading->setData(static_cast<int>(alignment_of(i)) | Qt::TextWordWrap, Qt::TextAlignmentRole);
    heading->setToolTip(headings[static_cast<qsizetype>(i)]);
  }
  for (const std::vector<Phrase>& row : shown.rows) {
    QList<QStandardItem*> items{};
    for (std::size_t i = 0; i < row.size(); ++i) {
      auto* item = new QStandardItem(row[i].empty() ? "–" : words_as_published(row[i]));
      item->setTextAlignment(alignment_of(i));
      if (columns_[i].holds_words) item->setToolTip(item->text());
      items << item;
    }
    model->appendRow(items);
  }
  style_table(*this);
  for (QWidget* const widget : std::initializer_list<QWidget*>{this, horizontalHeader()}) {
    widget->setFont(text_font(TextSize::small));
  }
  setSortingEnabled(false);  // rows belong together: parts, then totals
  setTextElideMode(Qt::ElideMiddle);
  setModel(model);
  horizontalHeader()->setStretchLastSection(false);
  horizontalHeader()->setMinimumSectionSize(kGrid);
  // The page scrolls, not the table.
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  measure();
}

void ResultTableView::measure() {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const int column = static_cast<int>(i);
    columns_[i].cells = sizeHintForColumn(column);
    for (std::size_t lines = 1; lines <= kMostLines; ++lines) {
      columns_[i].headings[lines - 1] = heading_width(column, static_cast<int>(lines));
    }
  }
  fitted_ = -1;
  // As wide as it would be with any room.
  setMaximumWidth(sum_of(widths_within(QWIDGETSIZE_MAX)) + 2 * frameWidth() + 2);
  fit();
}

int ResultTableView::heading_width(int column, int lines) const {
  const QFontMetrics letters = horizontalHeader()->fontMetrics();
  const QString heading = model()->headerData(column, Qt::Horizontal).toString();
  int narrowest = 0;
  for (const QString& word : heading.split(' ')) {
    narrowest = std::max(narrowest, letters.horizontalAdvance(word));
  }
  const auto has_room = [&](int width) {
    return letters.boundingRect(0, 0, width, QWIDGETSIZE_MAX, Qt::TextWordWrap, heading).height() <=
           lines * letters.lineSpacing();
  };
  int widest = letters.horizontalAdvance(heading);
  while (narrowest < widest) {
    const int middle = (narrowest + widest) / 2;
    if (has_room(middle)) {
      widest = middle;
    } else {
      narrowest = middle + 1;
    }
  }
  return widest + kPaddingOfHeading;
}

std::vector<int> ResultTableView::widths_within(int room) const {
  std::vector<int> widths(columns_.size());
  const auto set_widths = [&](std::size_t lines, int margin) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      widths[i] = std::max(columns_[i].cells, columns_[i].headings[lines - 1]) + margin;
    }
  };
  set_widths(1, kMargin);
  for (std::size_t lines = 1; lines <= kMostLines && sum_of(widths) > room; ++lines)
    set_widths(lines, 0);
  // The widest names become narrower, step by step; in a table that scrolls they need not be as narrow.
  const std::vector<int> whole = widths;
  for (const int narrowest : {kNarrowestName, kNameThatScrolls}) {
    widths = whole;
    while (sum_of(widths) > room) {
      std::size_t widest = widths.size();
      int least_of_widest = 0;
      for (std::size_t i = 0; i < widths.size(); ++i) {
        const int least = std::max(narrowest, columns_[i].headings.back());
        if (!columns_[i].holds_words || widths[i] <= least) continue;
        if (widest != widths.size() && widths[i] <= widths[widest]) continue;
        widest = i;
        least_of_widest = least;
      }
      if (widest == widths.size()) break;
      widths[widest] = std::max(least_of_widest, widths[widest] - kGrid);
    }
    if (sum_of(widths) <= room) break;
  }
  return widths;
}

void ResultTableView::fit() {
  const int room = viewport()->width();
  if (room == fitted_ || columns_.empty()) return;
  fitted_ = room;
  const std::vector<int> widths = widths_within(room);
  const QFontMetrics letters = horizontalHeader()->fontMetrics();
  int height = 0;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    const int column = static_cast<int>(i);
    setColumnWidth(column, widths[i]);
    height =
        std::max(height, letters
                             .boundingRect(0, 0, widths[i] - kPaddingOfHeading, QWIDGETSIZE_MAX,
                                           Qt::TextWordWrap,
                                           model()->headerData(column, Qt::Horizontal).toString())
                             .height());
  }
  horizontalHeader()->setFixedHeight(height + kHeightOfPadding);
  const bool scrolls = sum_of(widths) > room;
  setHorizontalScrollBarPolicy(scrolls ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
  setFixedHeight(horizontalHeader()->height() + kControlHeight * model()->rowCount() +
                 2 * frameWidth() + 2 + (scrolls ? horizontalScrollBar()->sizeHint().height() : 0));
}

void ResultTableView::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  fit();
}

void ResultTableView::changeEvent(QEvent* event) {
  QTableView::changeEvent(event);
  const bool may_differ =
      event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange;
  if (may_differ && model() != nullptr) measure();
}

}  // namespace asperity
