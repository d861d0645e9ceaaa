// Processes events until a condition holds or the time is over, and finds cells that are cut.

#include "tests/gui/support/widgets.h"

#include <QtTest/QTest>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QTableView>

namespace asperity {

bool eventually(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, kPatience_ms);
}

void require(const std::function<bool()>& condition, const std::string& what) {
  if (!eventually(condition)) throw std::runtime_error("no " + what);
}

QStringList cut_cells(const QTableView& table) {
  constexpr int kPadding = 16;
  constexpr int kPaddingOfName = 22;
  const QAbstractItemModel& model = *table.model();
  QStringList cut{};
  for (int column = 0; column < model.columnCount(); ++column) {
    if (table.isColumnHidden(column)) continue;
    const int width = table.columnWidth(column) - kPadding;
    const QString name = model.headerData(column, Qt::Horizontal).toString();
    if (table.horizontalHeader()->fontMetrics().horizontalAdvance(name) >
        table.columnWidth(column) - kPaddingOfName) {
      cut.append(name);
    }
    for (int row = 0; row < model.rowCount(); ++row) {
      const QString text = model.index(row, column).data().toString();
      const QRect needed = table.fontMetrics().boundingRect(QRect(0, 0, width, 10'000),
                                                            Qt::TextWordWrap | Qt::AlignLeft, text);
      if (needed.width() > width || needed.height() > table.rowHeight(row)) cut.append(text);
    }
  }
  return cut;
}

}  // namespace asperity
