#include "app/gui/study/study_table.h"

#include <algorithm>
#include <limits>

#include <QtCore/QSortFilterProxyModel>
#include <QtGui/QFontMetrics>
#include <QtGui/QKeyEvent>
#include <QtGui/QStandardItemModel>
#include <QtWidgets/QHeaderView>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

constexpr int kValue = Qt::UserRole;
constexpr int kKey = Qt::UserRole + 1;

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
    : QTableView(parent),
      rows_(new QStandardItemModel(0, static_cast<int>(columns.size()), this)),
      columns_(columns) {
  auto* filter = new WordFilter(this);
  filter->setSourceModel(rows_);
  filter->setSortRole(kValue);
  filter->setSortCaseSensitivity(Qt::CaseInsensitive);
  filter->setSortLocaleAware(true);
  shown_ = filter;
  setModel(filter);
  style_table(*this);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setTabKeyNavigation(false);
  setTextElideMode(Qt::ElideRight);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setStretchLastSection(false);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const int column = static_cast<int>(i);
    rows_->setHeaderData(column, Qt::Horizontal, columns[i].name);
    const Qt::Alignment side = columns[i].align == Align::number ? Qt::AlignRight : Qt::AlignLeft;
    rows_->setHeaderData(column, Qt::Horizontal, QVariant(side | Qt::AlignVCenter),
                         Qt::TextAlignmentRole);
    if (columns[i].width == 0) {
      horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
    }
  }
  fit_columns();
  sortByColumn(0, Qt::AscendingOrder);
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
    row.cells.front()->setData(row.key, kKey);
    rows_->appendRow(row.cells);
  }
  fit_columns();
  if (!selected.isEmpty()) select(selected);
  filling_ = false;
  emit row_selected(selected_key());
}

// The widths are made for English words; other languages have longer ones.
void StudyTable::fit_columns() {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const int width = columns_[i].width;
    if (width == 0) continue;
    const int column = static_cast<int>(i);
    const int name = horizontalHeader()->fontMetrics().horizontalAdvance(columns_[i].name);
    const int cells = std::min(sizeHintForColumn(column) + kGrid, width + width / 3);
    setColumnWidth(column, std::max({width, name + 2 * kGrid, cells}));
  }
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
  return shown.sibling(shown.row(), 0).data(kKey).toString();
}

}  // namespace asperity
