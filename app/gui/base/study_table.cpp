// Builds the table on a sorting and filtering proxy model; a row shown contains every typed word.

#include "app/gui/base/study_table.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <QtCore/QSortFilterProxyModel>
#include <QtGui/QFontMetrics>
#include <QtGui/QKeyEvent>
#include <QtGui/QStandardItemModel>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QStyledItemDelegate>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

constexpr int kValue = Qt::UserRole;
constexpr int kRowKey = Qt::UserRole + 1;

/// A row is shown when its cells hold every word, each in any of them.
class WordFilter final : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;

  void set_words(const QStringList& words) {
    words_ = words;
    invalidateFilter();
  }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    return std::all_of(words_.begin(), words_.end(), [&](const QString& word) {
      for (int column = 0; column < sourceModel()->columnCount(parent); ++column) {
        const QModelIndex cell = sourceModel()->index(row, column, parent);
        if (cell.data().toString().contains(word, Qt::CaseInsensitive)) return true;
      }
      return false;
    });
  }

 private:
  QStringList words_{};
};

/// Finds how high a text is at the width that is left of its cell: Qt takes that of the whole cell, without the
/// padding that the style sheet adds.
class WrapDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    // Both sides; Qt itself takes the margins of a focused cell into account. With more, a text that
    // just fits into a line would make its row as high as two.
    constexpr int kPadding = 16;
    QStyleOptionViewItem inside = option;
    if (option.rect.width() > 2 * kPadding) inside.rect.setWidth(option.rect.width() - kPadding);
    return QStyledItemDelegate::sizeHint(inside, index);
  }
};

}  // namespace

QStandardItem* text_cell(const QString& text) { return text_cell(text, text); }

QStandardItem* text_cell(const QString& text, const QVariant& value) {
  auto* cell = new QStandardItem(text);
  cell->setData(value, kValue);
  cell->setToolTip(text);
  return cell;
}

QStandardItem* number_cell(const QString& text, double value) {
  auto* cell = new QStandardItem(text);
  cell->setData(value, kValue);
  cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return cell;
}

QStandardItem* number_cell(int value) { return number_cell(QString::number(value), value); }

QStandardItem* empty_number_cell() {
  return number_cell("–", -std::numeric_limits<double>::infinity());
}

void strike_through(const QList<QStandardItem*>& cells) {
  for (QStandardItem* cell : cells) {
    QFont font = text_font(TextSize::body);
    font.setStrikeOut(true);
    cell->setFont(font);
    cell->setForeground(theme().muted);
  }
}

StudyTable::StudyTable(const std::vector<Column>& columns, QWidget* parent)
    : QTableView(parent), rows_(new QStandardItemModel(0, static_cast<int>(columns.size()), this)) {
  auto* filter = new WordFilter(this);
  filter->setSourceModel(rows_);
  filter->setSortRole(kValue);
  filter->setSortCaseSensitivity(Qt::CaseInsensitive);
  filter->setSortLocaleAware(true);
  shown_ = filter;
  setModel(filter);
  style_table(*this);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setTextElideMode(Qt::ElideMiddle);  // names of one study tend to begin alike
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  horizontalHeader()->setStretchLastSection(false);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const int column = static_cast<int>(i);
    rows_->setHeaderData(column, Qt::Horizontal, columns[i].name);
    const Qt::Alignment side = columns[i].align == Align::number ? Qt::AlignRight : Qt::AlignLeft;
    rows_->setHeaderData(column, Qt::Horizontal, QVariant(side | Qt::AlignVCenter),
                         Qt::TextAlignmentRole);
    if (columns[i].width == 0) {
      horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
    } else {
      setColumnWidth(column, columns[i].width);
    }
    widths_.push_back(columns[i].width);
  }
  sortByColumn(0, Qt::AscendingOrder);
  widen_columns();  // their names, until there are rows
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (!filling_) emit row_selected(selected_key());
  });
  connect(this, &QTableView::doubleClicked, this,
          [this](const QModelIndex& cell) { emit row_opened(key_at(cell)); });
}

void StudyTable::fill(const std::vector<Row>& rows) {
  const QString selected = selected_key();
  filling_ = true;
  rows_->removeRows(0, rows_->rowCount());
  for (const Row& row : rows) {
    row.cells.front()->setData(row.key, kRowKey);
    rows_->appendRow(row.cells);
  }
  if (!selected.isEmpty()) select(selected);
  widen_columns();
  if (grows_) grow();
  filling_ = false;
  emit row_selected(selected_key());
}

void StudyTable::replace_cell(const QString& key, int column, QStandardItem* cell) {
  for (int row = 0; row < rows_->rowCount(); ++row) {
    if (rows_->item(row)->data(kRowKey).toString() != key) continue;
    rows_->setItem(row, column, cell);
    widen_columns();
    return;
  }
  delete cell;  // of a row that is no longer there
}

// Other languages have longer words than the widths were chosen for. Never narrower: somebody may have
// drawn a column wider.
void StudyTable::widen_columns() {
  for (const int column : first_to_go_) setColumnHidden(column, false);
  for (int column = 0; column < shown_->columnCount(); ++column) {
    const int declared = widths_[static_cast<std::size_t>(column)];
    if (declared == 0 || isColumnHidden(column)) continue;
    constexpr int kPadding = 22;  // of a header, as the style sheet says
    const QString name = shown_->headerData(column, Qt::Horizontal).toString();
    const int wanted =
        std::max(sizeHintForColumn(column),
                 horizontalHeader()->fontMetrics().horizontalAdvance(name) + kPadding);
    // Of a text that is longer still the tool tip says the rest.
    const int given = std::min(wanted, declared * 3 / 2);
    if (given > columnWidth(column)) setColumnWidth(column, given);
  }
  choose_columns();
}

void StudyTable::set_filter(const QString& words) {
  static_cast<WordFilter*>(shown_)->set_words(words.split(' ', Qt::SkipEmptyParts));
}

void StudyTable::select(const QString& key) {
  for (int row = 0; row < shown_->rowCount(); ++row) {
    if (key_at(shown_->index(row, 0)) != key) continue;
    selectRow(row);
    scrollTo(shown_->index(row, 0));
    return;
  }
}

QString StudyTable::selected_key() const {
  const QModelIndexList rows = selectionModel()->selectedRows();
  return rows.isEmpty() ? QString{} : key_at(rows.front());
}

void StudyTable::wrap_texts() {
  setWordWrap(true);
  setTextElideMode(Qt::ElideRight);  // of a word that is longer than a line
  setItemDelegate(new WrapDelegate(this));
  verticalHeader()->setMinimumSectionSize(kControlHeight);
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  // Rows are as high as their texts at the width that the columns had when they were filled in.
  rewrap_.setSingleShot(true);
  rewrap_.setInterval(0);
  connect(&rewrap_, &QTimer::timeout, this, [this] {
    resizeRowsToContents();
    emit rows_fitted();
  });
  connect(horizontalHeader(), &QHeaderView::sectionResized, this, [this] { rewrap_.start(); });
  connect(shown_, &QAbstractItemModel::rowsInserted, this, [this] { rewrap_.start(); });
  choose_columns();
}

void StudyTable::grow_with_rows() {
  grows_ = true;
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &StudyTable::rows_fitted, this, &StudyTable::grow);
  grow();
}

void StudyTable::grow() {
  setFixedHeight(height_without_rows() + std::max(kControlHeight, verticalHeader()->length()));
}

int StudyTable::height_without_rows() const {
  return horizontalHeader()->sizeHint().height() + 2 * frameWidth() + 2;
}

int StudyTable::height_of_rows_within(int most) const {
  int height = height_without_rows();
  for (int row = 0; row < shown_->rowCount(); ++row) {
    const int with_it = height + rowHeight(row);
    if (row > 0 && with_it > most) break;
    height = with_it;
  }
  return height;
}

void StudyTable::hide_when_narrower(int column, int width) {
  narrowest_[column] = width;
  setColumnHidden(column, this->width() < width);
}

void StudyTable::leave_out_when_tight(std::vector<int> columns) {
  first_to_go_ = std::move(columns);
  choose_columns();
}

void StudyTable::choose_columns() {
  for (const auto& [column, narrowest] : narrowest_) setColumnHidden(column, width() < narrowest);
  if (first_to_go_.empty()) return;
  for (const int column : first_to_go_) setColumnHidden(column, false);
  int room = viewport()->width();
  int wanted = 0;
  for (int column = 0; column < shown_->columnCount(); ++column) {
    if (widths_[static_cast<std::size_t>(column)] == 0) {
      wanted += wanted_width(column);
    } else {
      room -= columnWidth(column);
    }
  }
  for (const int column : first_to_go_) {
    if (room >= wanted) break;
    room += columnWidth(column);
    setColumnHidden(column, true);
  }
}

int StudyTable::wanted_width(int column) const {
  if (!wordWrap()) return sizeHintForColumn(column);
  constexpr int kCellPadding = 24;
  int longest = 0;
  for (int row = 0; row < shown_->rowCount(); ++row) {
    longest = std::max(longest, fontMetrics().horizontalAdvance(text_at(row, column)));
  }
  return longest / 2 + longest / 8 + kCellPadding;  // lines break between words
}

void StudyTable::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  choose_columns();
}

int StudyTable::shown_rows() const { return shown_->rowCount(); }

QString StudyTable::text_at(int row, int column) const {
  return shown_->index(row, column).data().toString();
}

void StudyTable::keyPressEvent(QKeyEvent* event) {
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) &&
      !selected_key().isEmpty()) {
    emit row_opened(selected_key());
    return;
  }
  QTableView::keyPressEvent(event);
}

QString StudyTable::key_at(const QModelIndex& shown) const {
  return shown.sibling(shown.row(), 0).data(kRowKey).toString();
}

}  // namespace asperity

#include "moc_study_table.cpp"
