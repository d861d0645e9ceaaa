// Declares the table of trials that are listed one by one.

#pragma once

#include <QtCore/QStringList>

#include "app/gui/editor/form/form_part.h"

class QTableWidget;

namespace asperity {

/// Whether the values of a shape are shown in a table: a list of objects whose values are levels.
bool is_table(const ValueShape& shape);

/// A list of objects with levels: a row for each, a column for each factor. Selected rows are moved, duplicated and removed
/// together.
class RowTable final : public FormPart {
  Q_OBJECT
 public:
  RowTable(FormContext& context, const std::string& pointer, QWidget* parent);
  void refresh() override;
  void point_to(const std::string& pointer) override;

 private:
  std::string cell(int row, int column) const;
  std::vector<int> selected_rows() const;
  void take(int row, int column);
  void add_factor(const std::string& name);
  void act_on_rows(const std::function<FormEdit(const JsonDocument&, int row)>& act, bool from_end);
  void move(int by);

  QStringList factors_{};
  QTableWidget* table_ = nullptr;
  bool filling_ = false;
};

}  // namespace asperity
