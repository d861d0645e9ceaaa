// A table of an analysis that fits into the width of its page where it can.

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <QtWidgets/QTableView>

#include "app/findings/outcome/result_table.h"

namespace asperity {

/// Where the columns do not fit, their margins become narrower and their headings have two or three lines; then long names are
/// elided, which their tool tips state in full. Numbers are never elided: a table that needs more has a scroll bar.
class ResultTableView final : public QTableView {
 public:
  explicit ResultTableView(const ResultTable& table, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  static constexpr std::size_t kMostLines = 3;
  struct Column {
    int cells = 0;  ///< the width that the widest cell needs
    /// The smallest widths at which the heading has at most one line, two and so on.
    std::array<int, kMostLines> headings{};
    bool holds_words = false;
  };
  int heading_width(int column, int lines) const;
  std::vector<int> widths_within(int room) const;
  void measure();
  void fit();

  std::vector<Column> columns_{};
  int fitted_ = -1;  ///< the room for which the columns were fitted
};

}  // namespace asperity
