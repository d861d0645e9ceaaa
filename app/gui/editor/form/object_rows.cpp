// Implements the fields of an object.

#include "app/gui/editor/form/object_rows.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <QtWidgets/QApplication>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>
#include <nlohmann/json.hpp>

#include "app/gui/base/form_words.h"
#include "app/gui/editor/form/entry_list.h"
#include "app/gui/editor/form/form_fields.h"
#include "app/gui/editor/form/row_table.h"
#include "app/gui/editor/form/text_card.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"
#include "protocols/design/json_pointer.h"
#include "protocols/keys/tables.h"

namespace asperity {

namespace {

constexpr int kStateWidth = 88;
/// Of the word "default" or the button that resets.
constexpr int kStatesWidth = 72;
/// Settings without a value that are shown: a button that unfolds them would take as much room.
constexpr int kFewSettings = 2;

/// As wide in all rows where they have room, so that fields end below each other.
class StateColumn final : public QWidget {
 public:
  using QWidget::QWidget;
  QSize sizeHint() const override { return QWidget::sizeHint().expandedTo({kStatesWidth, 0}); }
};

const nlohmann::json kNoObject = nlohmann::json::object();

}  // namespace

ObjectRows::ObjectRows(FormContext& context, const KeyTable& table, const std::string& pointer,
                       const PagePart* part, QWidget* parent)
    : FormPart(context, pointer, parent), table_(table), part_(part) {
  layout_ = new QVBoxLayout(this);
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(kGrid);
}

ObjectRows::ObjectRows(FormContext& context, const FormPage& page, QWidget* parent)
    : ObjectRows(context, kProtocolTable, {}, nullptr, parent) {
  page_ = &page;
}

const PagePart* ObjectRows::part_of(std::string_view key) const {
  if (page_ == nullptr) return nullptr;
  const auto found = std::find_if(page_->parts.begin(), page_->parts.end(),
                                  [key](const PagePart& part) { return part.key == key; });
  return found == page_->parts.end() ? nullptr : &*found;
}

std::vector<FormEntry> ObjectRows::entries() const {
  const nlohmann::json* const object = value();
  std::vector<FormEntry> entries =
      entries_of(table_, object == nullptr || !object->is_object() ? kNoObject : *object, pointer(),
                 source().document().root());
  std::erase_if(entries, [this](const FormEntry& entry) {
    if (page_ != nullptr) return part_of(entry.key->name) == nullptr;
    return part_ != nullptr && !has_key(*part_, entry.key->name);
  });
  if (page_ != nullptr) {
    std::stable_sort(entries.begin(), entries.end(),
                     [this](const FormEntry& one, const FormEntry& other) {
                       return part_of(one.key->name) < part_of(other.key->name);
                     });
  }
  return entries;
}

/// Never what the page is named after. A row that has the focus stays: its value was emptied just now.
bool ObjectRows::can_be_folded(const FormEntry& entry) const {
  if (entry.is_present || entry.key->is_required) return false;
  if (const PagePart* const part = part_of(entry.key->name); part != nullptr && part->is_in_title) {
    return false;
  }
  const QWidget* const focused = QApplication::focusWidget();
  return std::none_of(rows_.begin(), rows_.end(), [&](const Row& row) {
    return row.entry.pointer == entry.pointer && row.content != nullptr && focused != nullptr &&
           row.content->isAncestorOf(focused);
  });
}

std::size_t ObjectRows::foldable(const std::vector<FormEntry>& entries) const {
  const auto unset = static_cast<std::size_t>(std::ranges::count_if(
      entries, [this](const FormEntry& entry) { return can_be_folded(entry); }));
  return unset <= kFewSettings || unset == entries.size() ? 0 : unset;
}

bool ObjectRows::is_unfolded(const std::vector<FormEntry>& entries) const {
  return context().opened.contains(pointer() + "/") || foldable(entries) == 0;
}

std::string ObjectRows::structure(const std::vector<FormEntry>& entries) const {
  const bool is_open = is_unfolded(entries);
  std::string structure = is_open ? "+" : "-";
  for (const FormEntry& entry : entries) {
    const nlohmann::json* const present = source().find(entry.pointer);
    const bool is_field = has_field(entry.key->shape, present);
    const bool is_shown = !can_be_folded(entry) || is_open;
    structure += std::string(entry.key->name) + (is_shown ? "+" : "-") + (is_field ? "f" : "s");
    if (!is_field) structure += present == nullptr ? "0" : present->type_name();
  }
  if (const nlohmann::json* const object = value(); object != nullptr && object->is_object()) {
    for (const std::string& key : unknown_keys(table_, *object)) structure += "?" + key;
  }
  return structure;
}

void ObjectRows::refresh() {
  const std::vector<FormEntry> present = entries();
  const std::string now = structure(present);
  if (now != made_) {
    made_ = now;
    make_rows(present);
  }
  for (Row& row : rows_) {
    row.entry.is_present = source().find(row.entry.pointer) != nullptr;
    if (row.content != nullptr) row.content->refresh();
    show_state(row);
  }
}

void ObjectRows::make_rows(const std::vector<FormEntry>& entries) {
  context().has_new_parts = true;
  clear_layout(*layout_);
  rows_.clear();
  labels_.clear();
  const bool is_open = is_unfolded(entries);
  for (const FormEntry& entry : entries) {
    if (can_be_folded(entry) && !is_open) continue;
    if (has_field(entry.key->shape, source().find(entry.pointer))) {
      add_field(entry);
    } else if (entry.is_present) {
      add_section(entry);
    } else {
      add_key_button(entry);
    }
  }
  align_field_labels(labels_);
  if (const std::size_t count = foldable(entries); count > 0) add_fold(count, is_open);
  add_unknown_keys();
}

void ObjectRows::add_field(const FormEntry& entry) {
  QLabel* label = make_field_label(text_of_keys(entry.key->label), this);
  FormPart* field = make_field(context(), entry.key->shape, {entry.key}, entry.pointer, this);
  const QString meaning = meaning_of_key(*entry.key);
  field->set_meaning(meaning);
  label->setToolTip(meaning);
  label->setBuddy(field);
  labels_.push_back(label);
  field->set_name(text_of_keys(entry.key->label));
  auto* states = new StateColumn(this);
  QLabel* state = make_text({}, states, true);
  state->setMaximumWidth(kStateWidth);
  QToolButton* reset = make_tool(QString(QChar(0x21BA)), tr("Remove: the default applies"), states);
  auto* of_states = new QHBoxLayout(states);
  of_states->setContentsMargins(0, 0, 0, 0);
  of_states->addStretch();
  of_states->addWidget(state);
  of_states->addWidget(reset);
  // The field is below its label where both have no room next to each other.
  auto* row = new WrappingRow(nullptr, kGrid);
  row->addWidget(label);
  row->addWidget(field);
  row->addWidget(states);
  row->setAlignment(label, Qt::AlignTop);
  row->setAlignment(states, Qt::AlignTop | Qt::AlignRight);
  layout_->addLayout(row);
  reset->setObjectName(kRemovingValue + text(entry.pointer));
  connect(reset, &QToolButton::clicked, this, [this, pointer = entry.pointer] { remove(pointer); });
  QLabel* problem = make_problem_label(this);
  layout_->addWidget(problem);
  rows_.push_back({entry, field, state, reset, problem});
}

void ObjectRows::add_section(const FormEntry& entry) {
  auto* head = new QHBoxLayout();
  QLabel* label = page_ != nullptr ? make_heading(text_of_keys(entry.key->label), this)
                                   : make_text(text_of_keys(entry.key->label), this);
  const QString meaning = meaning_of_key(*entry.key);
  label->setToolTip(meaning);
  head->addWidget(label);
  head->addStretch();
  QToolButton* reset = nullptr;
  if (!entry.key->is_required) {
    reset = make_tool(QString(QChar(0xD7)), tr("Remove “%1”").arg(text_of_keys(entry.key->label)),
                      this);
    reset->setObjectName(kRemovingValue + text(entry.pointer));
    head->addWidget(reset);
    connect(reset, &QToolButton::clicked, this,
            [this, pointer = entry.pointer] { remove(pointer); });
  }
  FormPart* content = make_part(context(), entry.key->shape, entry.key, entry.pointer,
                                part_of(entry.key->name), this);
  content->set_meaning(meaning);
  content->setContentsMargins(page_ != nullptr ? 0 : kMargin, 0, 0, kGrid);
  layout_->addLayout(head);
  QLabel* problem = make_problem_label(this);
  layout_->addWidget(problem);
  layout_->addWidget(content);
  rows_.push_back({entry, content, nullptr, nullptr, problem});
}

void ObjectRows::add_key_button(const FormEntry& entry) {
  QPushButton* add =
      make_button(tr("+ %1").arg(text_of_keys(entry.key->label)), ButtonRole::link, this);
  add->setObjectName("add:" + text(entry.pointer));
  add->setToolTip(meaning_of_key(*entry.key));
  layout_->addWidget(add, 0, Qt::AlignLeft);
  QLabel* problem = make_problem_label(this);
  layout_->addWidget(problem);
  rows_.push_back({entry, nullptr, nullptr, nullptr, problem});
  connect(add, &QPushButton::clicked, this, [this, entry] {
    context().opened.insert(entry.pointer);
    context().edit(
        [&](const JsonDocument& text) { return with_new_value(text, entry.pointer, *entry.key); },
        {});
  });
}

void ObjectRows::add_fold(std::size_t count, bool is_open) {
  QPushButton* fold =
      make_button(is_open ? tr("Hide unset settings") : tr("Further settings (%1)").arg(count),
                  ButtonRole::link, this);
  fold->setObjectName("fold:" + text(pointer()));
  layout_->addWidget(fold, 0, Qt::AlignLeft);
  connect(fold, &QPushButton::clicked, this, [this, is_open] {
    if (is_open) {
      context().opened.erase(pointer() + "/");
    } else {
      context().opened.insert(pointer() + "/");
    }
    context().refresh();
  });
}

void ObjectRows::add_unknown_keys() {
  const nlohmann::json* const object = value();
  if (object == nullptr || !object->is_object() || page_ != nullptr) return;
  for (const std::string& key : unknown_keys(table_, *object)) {
    auto* card = new TextCard(context(), pointer_to(pointer(), key), this);
    layout_->addWidget(card);
    rows_.push_back({{card->pointer(), nullptr, true}, card, nullptr, nullptr, nullptr});
  }
}

void ObjectRows::show_state(const Row& row) const {
  if (row.problem != nullptr) {
    // What a field contains has no row of its own.
    const bool is_field = row.state != nullptr;
    show_problems(*row.problem, problems_at(context(), row.entry.pointer,
                                            is_field ? Problems::within : Problems::of_value));
  }
  if (row.state == nullptr) return;
  const bool is_default = !row.entry.is_present && !row.entry.key->is_required;
  const std::string_view computed = row.entry.key->computed_default;
  row.state->setVisible(is_default);
  row.state->setText(computed.empty() ? tr("default") : text_of_keys(computed));
  row.reset->setVisible(row.entry.is_present && !row.entry.key->is_required);
}

FormPart* make_part(FormContext& context, const ValueShape& shape, const ProtocolKey* key,
                    const std::string& pointer, const PagePart* part, QWidget* parent) {
  const nlohmann::json* const value = context.source->find(pointer);
  const ValueShape* const found = value == nullptr ? &shape : shape_of(shape, *value);
  if (found == nullptr) return new TextCard(context, pointer, parent);
  if (has_field(shape, value)) return make_field(context, shape, {key}, pointer, parent);
  if (is_table(*found)) return new RowTable(context, pointer, parent);
  if (const auto* const object = std::get_if<ObjectShape>(found)) {
    if (object->table->keys.empty()) return new TextCard(context, pointer, parent);
    return new ObjectRows(context, *object->table, pointer, part, parent);
  }
  return new EntryList(context, *found, pointer, part, parent);
}

}  // namespace asperity

#include "moc_object_rows.cpp"
