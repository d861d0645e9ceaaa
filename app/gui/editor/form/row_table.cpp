// Implements the table of trials that are listed one by one.

#include "app/gui/editor/form/row_table.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <QtWidgets/QHeaderView>
#include <QtWidgets/QMenu>
#include <QtWidgets/QTableWidget>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/gui/base/typed_number.h"
#include "app/gui/editor/form/form_fields.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"
#include "protocols/design/json_pointer.h"
#include "protocols/editing/edits.h"

namespace asperity {

namespace {

constexpr int kMostRowsShown = 10;

QString shown_level(const nlohmann::json& row, const QString& factor) {
  const auto level = row.is_object() ? row.find(factor.toStdString()) : row.end();
  if (!row.is_object() || level == row.end()) return {};
  if (level->is_string()) return text(level->get<std::string>());
  return shown_decimal(level->dump());
}

}  // namespace

bool is_table(const ValueShape& shape) {
  const auto* const list = std::get_if<ListShape>(&shape);
  if (list == nullptr) return false;
  const auto* const map = std::get_if<MapShape>(list->entry);
  return map != nullptr && has_field(*map->entry, nullptr);
}

RowTable::RowTable(FormContext& context, const std::string& pointer, QWidget* parent)
    : FormPart(context, pointer, parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  table_ = new QTableWidget(this);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::AnyKeyPressed |
                          QAbstractItemView::EditKeyPressed);
  table_->setTabKeyNavigation(false);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  // The rows are lower than the padding of headers of tables leaves room for.
  table_->verticalHeader()->setStyleSheet("QHeaderView::section { padding: 0 4px; }");
  table_->setAccessibleName(tr("Trials"));
  setFocusProxy(table_);
  layout->addWidget(table_);
  auto* buttons = new WrappingRow();
  layout->addLayout(buttons);
  const auto add = [&](const QString& verb, const char* name, auto act) {
    QPushButton* button = make_button(verb, ButtonRole::link, this);
    button->setObjectName(name + text(":" + pointer));
    buttons->addWidget(button);
    connect(button, &QPushButton::clicked, this, act);
  };
  add(tr("+ Add"), "add", [this] {
    this->context().edit(
        [this](const JsonDocument& document) { return with_entry(document, this->pointer()); }, {});
  });
  add(tr("Duplicate"), "duplicate", [this] {
    act_on_rows(
        [this](const JsonDocument& document, int row) {
          return with_copy(document, pointer_to(this->pointer(), static_cast<std::size_t>(row)));
        },
        true);
  });
  add(tr("Up"), "up", [this] { move(-1); });
  add(tr("Down"), "down", [this] { move(1); });
  add(tr("Remove"), "remove_rows", [this] {
    std::vector<std::string> pointers{};
    for (const int row : selected_rows()) {
      pointers.push_back(pointer_to(this->pointer(), static_cast<std::size_t>(row)));
    }
    if (pointers.empty()) return;
    this->context().edit([&](const JsonDocument& text) { return without(text, pointers); }, {});
  });
  QPushButton* factor = make_button(tr("+ Factor"), ButtonRole::link, this);
  factor->setObjectName("factor:" + text(pointer));
  buttons->addWidget(factor);
  auto* menu = new QMenu(factor);
  factor->setMenu(menu);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    for (const QString& name : source().names_for({kFactorNames}, this->pointer())) {
      if (factors_.contains(name)) continue;
      menu->addAction(name, this, [this, name] { add_factor(name.toStdString()); });
    }
    if (menu->isEmpty()) menu->addAction(tr("All factors occur already"))->setEnabled(false);
  });
  connect(table_, &QTableWidget::cellChanged, this, &RowTable::take);
}

/// Every trial has the first level of the factor.
void RowTable::add_factor(const std::string& name) {
  const nlohmann::json* const levels = source().find("/factors/" + name + "/levels");
  const bool has_level = levels != nullptr && levels->is_array() && !levels->empty();
  const std::string level = has_level ? levels->front().dump() : "0";
  context().edit(
      [&](const JsonDocument& document) {
        FormEdit edit{std::string(document.text()), {}};
        for (std::size_t row = 0; row < value()->size(); ++row) {
          const JsonDocument present(edit.text, {});
          edit = with_value(present, pointer_to(pointer_to(pointer(), row), name), level);
        }
        return edit;
      },
      {});
}

void RowTable::refresh() {
  const nlohmann::json* const rows = value();
  if (rows == nullptr || !rows->is_array()) return;
  QStringList factors{};
  for (const nlohmann::json& row : *rows) {
    if (!row.is_object()) continue;
    for (const auto& [key, level] : row.items()) {
      if (!is_comment(key) && !factors.contains(text(key))) factors.append(text(key));
    }
  }
  filling_ = true;
  factors_ = factors;
  table_->setColumnCount(static_cast<int>(factors.size()));
  table_->setHorizontalHeaderLabels(factors);
  table_->setRowCount(static_cast<int>(rows->size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    for (int column = 0; column < table_->columnCount(); ++column) {
      const QString level = shown_level((*rows)[static_cast<std::size_t>(row)], factors[column]);
      QTableWidgetItem* const item = table_->item(row, column);
      if (item == nullptr) {
        table_->setItem(row, column, new QTableWidgetItem(level));
      } else if (item->text() != level) {
        item->setText(level);
      }
    }
  }
  filling_ = false;
  const int shown = std::min(table_->rowCount(), kMostRowsShown) + 1;
  table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                         shown * table_->verticalHeader()->defaultSectionSize());
}

std::string RowTable::cell(int row, int column) const {
  return pointer_to(pointer_to(pointer(), static_cast<std::size_t>(row)),
                    factors_[column].toStdString());
}

void RowTable::point_to(const std::string& pointer) {
  for (int row = 0; row < table_->rowCount(); ++row) {
    for (int column = 0; column < table_->columnCount(); ++column) {
      if (cell(row, column) == pointer) table_->setCurrentCell(row, column);
    }
  }
}

void RowTable::take(int row, int column) {
  if (filling_) return;
  const QString typed = table_->item(row, column)->text().trimmed();
  const std::string place = cell(row, column);
  const nlohmann::json* const present = source().find(place);
  if (typed.isEmpty()) {
    remove(place);
    return;
  }
  // Levels of a factor are all numbers or all names: the new one is of the type of the one before.
  const auto number = shifted_decimal(decimal_of(typed), 0);
  const bool is_name = present != nullptr && present->is_string();
  const std::string json = number && !is_name ? *number : json_string(typed.toStdString());
  context().edit([&](const JsonDocument& text) { return with_value(text, place, json); }, {});
  refresh();  // a level that is refused is not in the text
}

std::vector<int> RowTable::selected_rows() const {
  std::vector<int> rows{};
  for (const QModelIndex& index : table_->selectionModel()->selectedRows()) {
    rows.push_back(index.row());
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

void RowTable::act_on_rows(const std::function<FormEdit(const JsonDocument&, int row)>& act,
                           bool from_end) {
  std::vector<int> rows = selected_rows();
  if (rows.empty()) return;
  if (from_end) std::reverse(rows.begin(), rows.end());
  context().edit(
      [&](const JsonDocument& document) {
        FormEdit edit{std::string(document.text()), {}};
        for (const int row : rows) edit = act(JsonDocument(edit.text, {}), row);
        return edit;
      },
      {});
}

void RowTable::move(int by) {
  const std::vector<int> rows = selected_rows();
  if (rows.empty() || (by < 0 ? rows.front() == 0 : rows.back() + 1 == table_->rowCount())) return;
  const std::string before(source().document().text());
  act_on_rows(
      [this, by](const JsonDocument& document, int row) {
        return with_moved(document, pointer_to(pointer(), static_cast<std::size_t>(row)),
                          static_cast<std::size_t>(row + by));
      },
      by > 0);
  if (source().document().text() == before) return;  // refused
  table_->clearSelection();
  for (const int row : rows) {
    for (int column = 0; column < table_->columnCount(); ++column) {
      table_->item(row + by, column)->setSelected(true);
    }
  }
}

}  // namespace asperity

#include "moc_row_table.cpp"
