// A table of things of a study: sorted by what they are worth, filtered by what is typed.

#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QtCore/QTimer>
#include <QtGui/QStandardItem>
#include <QtWidgets/QTableView>

class QSortFilterProxyModel;

namespace asperity {

/// Cells sort by their value, not by their text.
QStandardItem* text_cell(const QString& text);
QStandardItem* text_cell(const QString& text, const QVariant& value);
/// At the right.
QStandardItem* number_cell(const QString& text, double value);
QStandardItem* number_cell(int value);
/// "–": nothing there; below every number.
QStandardItem* empty_number_cell();
/// For what is there and does not count.
void strike_through(const QList<QStandardItem*>& cells);

class StudyTable final : public QTableView {
  Q_OBJECT
 public:
  struct Row {
    QString key{};  ///< who it is, for as long as the table lives
    QList<QStandardItem*> cells{};
  };
  enum class Align { text, number };
  struct Column {
    QString name{};
    int width = 0;  ///< 0: what is left over; more where the name or the cells need some more
    Align align = Align::text;
  };

  StudyTable(const std::vector<Column>& columns, QWidget* parent = nullptr);

  /// Shows these rows; what was selected stays so where it is still there.
  void fill(const std::vector<Row>& rows);
  /// Shows another cell in a row that stays where it is. Not the first, which holds the key.
  void replace_cell(const QString& key, int column, QStandardItem* cell);
  /// Only rows that hold every word.
  void set_filter(const QString& words);
  void select(const QString& key);
  QString selected_key() const;  ///< empty when nothing is selected
  /// Texts longer than their column are continued in the next line.
  void wrap_texts();
  /// As high as its rows, without a scroll bar: for a page that scrolls. An empty one has room for one row.
  void grow_with_rows();
  /// The height that shows as many of its first rows as `most` has room for, and no part of one; one
  /// row at least.
  int height_of_rows_within(int most) const;
  /// The column is left out while the table is narrower than this.
  void hide_when_narrower(int column, int width);
  /// These are left out, the first one first, while the column that takes what is left over has no
  /// room for its texts; of texts that are wrapped, for half of the longest.
  void leave_out_when_tight(std::vector<int> columns);
  int shown_rows() const;
  QString text_at(int row, int column) const;  ///< as shown

 signals:
  void row_selected(const QString& key);  ///< empty when nothing is any more
  void row_opened(const QString& key);
  void rows_fitted();  ///< wrapped texts have the height that they need

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QString key_at(const QModelIndex& shown) const;
  void widen_columns();
  void choose_columns();
  int wanted_width(int column) const;
  void grow();
  int height_without_rows() const;

  QStandardItemModel* rows_ = nullptr;
  QSortFilterProxyModel* shown_ = nullptr;
  bool filling_ = false;
  std::vector<int> widths_{};       ///< as declared
  std::map<int, int> narrowest_{};  ///< by column, the table's width from which on it is shown
  std::vector<int> first_to_go_{};
  QTimer rewrap_{};
  bool grows_ = false;
};

}  // namespace asperity
