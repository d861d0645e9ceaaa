// Implements the entries of a list or of an object whose keys are names.

#include "app/gui/editor/form/entry_list.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <variant>

#include <QtCore/QTimer>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <nlohmann/json.hpp>

#include "app/gui/base/form_words.h"
#include "app/gui/base/parameter_words.h"
#include "app/gui/editor/form/form_fields.h"
#include "app/gui/editor/form/object_rows.h"
#include "app/gui/editor/form/text_card.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/fitted_label.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"
#include "app/study_files/parameter_json.h"
#include "protocols/design/json_pointer.h"
#include "protocols/editing/text_entries.h"
#include "protocols/form/form_entries.h"

namespace asperity {

namespace {

constexpr int kNameWidth = 144;
constexpr int kLeastNameWidth = 80;
constexpr int kNarrowCard = 400;
/// Of the head of a card, after that of the button that unfolds it.
constexpr int kTitleColumn = 1;
constexpr int kSummaryColumn = 2;
constexpr int kToolsColumn = 3;
constexpr std::string_view kParameters = "/parameters";
std::string_view first_deciding(const KeyTable& table, const nlohmann::json& object) {
  for (const std::string_view key : table.deciding) {
    if (object.contains(key)) return key;
  }
  return {};
}

}  // namespace

QKeySequence keys_of(EntryAction action) {
  constexpr auto kModifiers = Qt::AltModifier | Qt::ShiftModifier;
  switch (action) {
    case EntryAction::move_up:
      return {kModifiers | Qt::Key_Up};
    case EntryAction::move_down:
      return {kModifiers | Qt::Key_Down};
    case EntryAction::duplicate:
      return {kModifiers | Qt::Key_D};
    case EntryAction::remove:
      break;
  }
  return {kModifiers | Qt::Key_Delete};
}

EntryList::EntryList(FormContext& context, const ValueShape& shape, const std::string& pointer,
                     const PagePart* part, QWidget* parent)
    : FormPart(context, pointer, parent), shape_(shape), part_(part) {
  layout_ = new QVBoxLayout(this);
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(kGrid);
}

const ValueShape& EntryList::entry_shape() const {
  const auto* const list = std::get_if<ListShape>(&shape_);
  return list != nullptr ? *list->entry : *std::get<MapShape>(shape_).entry;
}

std::vector<EntryList::Entry> EntryList::present_entries() const {
  std::vector<Entry> entries{};
  if (value() == nullptr || !value()->is_structured()) return entries;
  const TextContainer container(source().document(), pointer());
  for (std::size_t i = 0; i < container.entries().size(); ++i) {
    const std::string& key = container.entries()[i].key;
    Entry entry{};
    if (container.is_object()) {
      if (is_comment(key)) continue;
      entry.pointer = pointer_to(pointer(), key);
      entry.name = key;
    } else {
      entry.pointer = pointer_to(pointer(), i);
      entry.name = name_of_entry(*source().find(entry.pointer));
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::string EntryList::structure(const std::vector<Entry>& entries) const {
  std::string structure = "·";
  if (pointer().ends_with(kParameters)) {  // the model decides which there are, and their units
    structure += source().characters(stimulus() + "/model");
  }
  for (const Entry& entry : entries) {
    const nlohmann::json& present = *source().find(entry.pointer);
    const bool is_field = has_field(entry_shape(), &present);
    const bool is_known = shape_of(entry_shape(), present) != nullptr;
    structure += is_field ? "f" : is_known ? "c" : "t";
    structure += (context().opened.contains(entry.pointer) ? "+" : "-") +
                 std::string(present.is_structured() ? present.type_name() : "");
    if (std::holds_alternative<MapShape>(shape_)) structure += entry.name + "/";
  }
  return structure;
}

void EntryList::refresh() {
  if (context().renamed) {
    std::set<std::string> ticked{};
    for (const std::string& one : ticked_) ticked.insert(context().renamed(one));
    ticked_ = std::move(ticked);
  }
  std::vector<Entry> present = present_entries();
  const std::string now = structure(present);
  if (now != made_) {
    made_ = now;
    make_entries(std::move(present));
  } else {
    for (std::size_t i = 0; i < present.size(); ++i) entries_[i].name = present[i].name;
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) show_entry(entries_[i], i);
}

void EntryList::show_entry(const Entry& entry, std::size_t index) const {
  const QString title = title_of(entry, index);
  for (const Tool& tool : entry.tools) {
    const qsizetype others =
        tool.action == EntryAction::remove
            ? std::ssize(entries_naming(source().document(), source().names(), {&entry.pointer, 1}))
            : 0;
    const QString sentence = others == 0 ? tool.sentence.arg(title)
                                         : tr("Remove “%1”, and with it %n entry(ies) of lists",
                                              nullptr, static_cast<int>(others))
                                               .arg(title);
    tool.button->setToolTip(tool.keys.isEmpty() ? sentence
                                                : QString("%1 (%2)").arg(sentence, tool.keys));
    tool.button->setAccessibleName(sentence);
  }
  if (entry.chosen != nullptr) {
    entry.chosen->setAccessibleName(tr("Choose “%1”").arg(title));
    entry.chosen->setChecked(ticked_.contains(entry.pointer));
  }
  if (entry.content != nullptr) entry.content->refresh();
  if (entry.key != nullptr) entry.key->refresh();
  if (entry.summary != nullptr) {
    const QString summary =
        text(summary_of(entry_shape(), *source().find(entry.pointer), entry.pointer,
                        [](std::string_view word) { return name_of_word(word).toStdString(); }));
    entry.title->show_text(title);
    entry.summary->show_text(summary.left(summary.indexOf('\n')));
    entry.summary->setVisible(!summary.isEmpty());
  }
  // A folded card states what is wrong in it.
  const bool is_folded = entry.content == nullptr;
  show_problems(
      *entry.problem,
      problems_at(context(), entry.pointer,
                  is_folded || entry.summary == nullptr ? Problems::within : Problems::of_value));
}

QString EntryList::title_of(const Entry& entry, std::size_t index) const {
  const auto* const object = std::get_if<ObjectShape>(&entry_shape());
  const nlohmann::json& present = *source().find(entry.pointer);
  if (object != nullptr && !object->table->deciding.empty() && present.is_object()) {
    const ProtocolKey* const kind = object->table->find(first_deciding(*object->table, present));
    if (kind != nullptr) return QString("%1. %2").arg(index + 1).arg(text_of_keys(kind->label));
  }
  const Parameter* const parameter = source().parameter_at(entry.pointer);
  if (parameter != nullptr) return caption_of(*parameter);
  return entry.name.empty() ? QString::number(index + 1) : text(entry.name);
}

void EntryList::make_entries(std::vector<Entry> entries) {
  context().has_new_parts = true;
  clear_layout(*layout_);
  entries_ = std::move(entries);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const nlohmann::json& present = *source().find(entries_[i].pointer);
    if (has_field(entry_shape(), &present)) {
      add_line(entries_[i], i);
    } else {
      add_card(entries_[i], i);
    }
  }
  if (!is_excerpt()) add_adding();
}

void EntryList::add_line(Entry& entry, std::size_t index) {
  auto* row = new WrappingRow();
  if (const Parameter* const parameter = source().parameter_at(entry.pointer)) {
    QLabel* label = make_field_label(caption_of(*parameter), this);
    label->setToolTip(QString("%1\n%2").arg(text(parameter->name), words_of(parameter->meaning)));
    row->addWidget(label);
  } else if (std::holds_alternative<MapShape>(shape_)) {
    entry.key = make_key_field(context(), entry.pointer, this);
    entry.key->setMinimumWidth(kLeastNameWidth);
    entry.key->setMaximumWidth(kNameWidth);
    entry.key->set_name(tr("Name"));
    row->addWidget(entry.key);
  }
  entry.content = make_field(context(), entry_shape(), {}, entry.pointer, this);
  entry.content->set_name(title_of(entry, index));
  row->addWidget(entry.content);
  row->add_layout(make_tools(entry, index), Qt::AlignRight);
  layout_->addLayout(row);
  entry.problem = make_problem_label(this);
  layout_->addWidget(entry.problem);
}

void EntryList::add_card(Entry& entry, std::size_t index) {
  auto* card = new QFrame(this);
  card->setObjectName("card:" + text(entry.pointer));
  card->setFrameShape(QFrame::StyledPanel);
  card->setAutoFillBackground(true);
  card->setBackgroundRole(QPalette::Base);
  auto* layout = new QVBoxLayout(card);
  layout->setContentsMargins(kGrid, kGrid / 2, kGrid, kGrid / 2);
  auto* head = new QGridLayout();
  head->setColumnStretch(kSummaryColumn, 1);
  head->setVerticalSpacing(0);
  layout->addLayout(head);
  const nlohmann::json& present = *source().find(entry.pointer);
  const bool is_open = context().opened.contains(entry.pointer);
  auto* fold = new QToolButton(card);
  fold->setObjectName("open:" + text(entry.pointer));
  fold->setArrowType(is_open ? Qt::DownArrow : Qt::RightArrow);
  fold->setAutoRaise(true);
  entry.tools.push_back({fold, is_open ? tr("Fold “%1”") : tr("Unfold “%1”"), {}});
  connect(fold, &QToolButton::clicked, this, [this, pointer = entry.pointer] { toggle(pointer); });
  head->addWidget(fold, 0, 0);
  entry.title = new FittedLabel(card);
  entry.title->setFont(text_font(TextSize::body, true));
  head->addWidget(entry.title, 0, kTitleColumn);
  entry.summary = new FittedLabel(card);
  entry.summary->setObjectName("summary");
  entry.summary->set_smaller_font(text_font(TextSize::small));
  entry.head = head;
  place_summary(entry);
  head->addLayout(make_tools(entry, index), 0, kToolsColumn);
  entry.problem = make_problem_label(card);
  layout->addWidget(entry.problem);
  if (is_open) {
    if (std::holds_alternative<MapShape>(shape_) && !is_excerpt()) {
      auto* row = new QHBoxLayout();
      row->setSpacing(kGrid);
      QLabel* label = make_field_label(tr("Name"), card);
      entry.key = make_key_field(context(), entry.pointer, card);
      entry.key->set_name(tr("Name"));
      row->addWidget(label);
      row->addWidget(entry.key, 1);
      layout->addLayout(row);
    }
    entry.content = make_part(context(), entry_shape(), nullptr, entry.pointer, part_, card);
    layout->addWidget(entry.content);
  } else if (shape_of(entry_shape(), present) == nullptr) {
    entry.content = new TextCard(context(), entry.pointer, card);
    layout->addWidget(entry.content);
  }
  layout_->addWidget(card);
}

/// Next to the title, or below it where few letters had room there.
void EntryList::place_summary(const Entry& entry) const {
  entry.head->removeWidget(entry.summary);
  if (is_narrow_) {
    entry.head->addWidget(entry.summary, 1, kTitleColumn, 1, kToolsColumn);
  } else {
    entry.head->addWidget(entry.summary, 0, kSummaryColumn);
  }
}

void EntryList::resizeEvent(QResizeEvent* event) {
  FormPart::resizeEvent(event);
  if ((width() < kNarrowCard) == is_narrow_) return;
  is_narrow_ = !is_narrow_;
  for (const Entry& entry : entries_) {
    if (entry.summary != nullptr) place_summary(entry);
  }
}

/// Close to each other: the summary next to them has the room.
QHBoxLayout* EntryList::make_tools(Entry& entry, std::size_t index) {
  auto* row = new QHBoxLayout();
  row->setSpacing(0);
  if (is_excerpt()) return row;
  entry.chosen = new QCheckBox(this);
  entry.chosen->setObjectName(kChoosing + text(entry.pointer));
  entry.chosen->setToolTip(tr("Ticked entries are moved, duplicated and removed together."));
  connect(entry.chosen, &QCheckBox::clicked, this, [this, pointer = entry.pointer](bool is_ticked) {
    if (is_ticked) {
      ticked_.insert(pointer);
    } else {
      ticked_.erase(pointer);
    }
  });
  row->addWidget(entry.chosen);
  using Action = EntryAction;
  const auto add = [&](const QString& sign, const QString& sentence, Action action, auto act) {
    QToolButton* tool = make_tool(sign, {}, this);
    row->addWidget(tool);
    entry.tools.push_back(
        {tool, sentence, keys_of(action).toString(QKeySequence::NativeText), action});
    connect(tool, &QToolButton::clicked, this, act);
    return tool;
  };
  add("↑", tr("Move “%1” up"), Action::move_up, [this, index] {
    move(index, -1);
  })->setEnabled(index > 0);
  add("↓", tr("Move “%1” down"), Action::move_down, [this, index] {
    move(index, 1);
  })->setEnabled(index + 1 < entries_.size());
  add("+", tr("Duplicate “%1”"), Action::duplicate, [this, index] { duplicate(index); });
  add("×", tr("Remove “%1”"), Action::remove, [this, index] {
    remove(index);
  })->setObjectName(kRemovingValue + text(entry.pointer));
  return row;
}

QStringList EntryList::keys_to_add(QStringList& labels) const {
  const auto* const object = std::get_if<ObjectShape>(&entry_shape());
  const auto* const map = std::get_if<MapShape>(&shape_);
  QStringList keys{};
  if (map == nullptr) {
    for (const std::string_view kind :
         object == nullptr ? std::span<const std::string_view>{} : object->table->deciding) {
      keys.append(text(std::string(kind)));
      labels.append(text_of_keys(object->table->find(kind)->label));
    }
    return keys;
  }
  if (pointer().ends_with(kParameters)) {
    for (const Parameter* const parameter : source().parameters_of(stimulus())) {
      if (source().find(pointer_to(pointer(), parameter->name)) != nullptr) continue;
      keys.append(text(parameter->name));
      labels.append(caption_of(*parameter));
    }
    return keys;
  }
  if (!map->key.registry.empty() && !map->key.is_declared) {
    keys = source().names_for(map->key, pointer());
  }
  keys.removeIf([this](const QString& key) {
    return source().find(pointer_to(pointer(), key.toStdString())) != nullptr;
  });
  labels = keys;
  return keys;
}

void EntryList::add_adding() {
  QPushButton* add_one = make_button(tr("+ Add"), ButtonRole::link, this);
  add_one->setObjectName("add:" + text(pointer()));
  layout_->addWidget(add_one, 0, Qt::AlignLeft);
  const auto* const object = std::get_if<ObjectShape>(&entry_shape());
  const auto* const map = std::get_if<MapShape>(&shape_);
  const bool has_kinds = object != nullptr && !object->table->deciding.empty() && map == nullptr;
  const bool has_names = map != nullptr && (pointer().ends_with(kParameters) ||
                                            (!map->key.registry.empty() && !map->key.is_declared));
  if (!has_kinds && !has_names) {
    connect(add_one, &QPushButton::clicked, this, [this] { add({}); });
    return;
  }
  auto* menu = new QMenu(add_one);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    QStringList labels{};
    const QStringList keys = keys_to_add(labels);
    for (qsizetype i = 0; i < keys.size(); ++i) {
      menu->addAction(labels[i], this, [this, key = keys[i].toStdString()] { add(key); });
    }
    if (keys.isEmpty()) menu->addAction(tr("All names occur already"))->setEnabled(false);
  });
  add_one->setMenu(menu);
}

void EntryList::toggle(const std::string& pointer) {
  if (context().opened.erase(pointer) == 0) context().opened.insert(pointer);
  context().refresh();
}

std::optional<std::size_t> EntryList::entry_with(const QWidget& widget) const {
  const auto has = [&widget](const QWidget* part) {
    return part != nullptr && (part == &widget || part->isAncestorOf(&widget));
  };
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    const bool has_tool = std::any_of(entry.tools.begin(), entry.tools.end(),
                                      [&has](const Tool& tool) { return has(tool.button); });
    if (has(entry.content) || has(entry.key) || has(entry.chosen) || has_tool) return i;
  }
  return {};
}

bool EntryList::act(const QWidget& focus, EntryAction action) {
  const auto index = entry_with(focus);
  if (!index || is_excerpt()) return false;
  std::size_t after = *index;
  switch (action) {
    case EntryAction::move_up:
      after = move(*index, -1);
      break;
    case EntryAction::move_down:
      after = move(*index, 1);
      break;
    case EntryAction::duplicate:
      after = duplicate(*index);
      break;
    case EntryAction::remove:
      after = remove(*index);
      break;
  }
  // After the layout has shown what was made.
  QTimer::singleShot(0, this, [this, after] {
    if (!entries_.empty()) entries_[std::min(after, entries_.size() - 1)].chosen->setFocus();
  });
  return true;
}

std::vector<std::size_t> EntryList::together(std::size_t index) const {
  std::vector<std::size_t> ticked{};
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (ticked_.contains(entries_[i].pointer)) ticked.push_back(i);
  }
  return ticked_.contains(entries_[index].pointer) ? ticked : std::vector{index};
}

void EntryList::rearrange(const FormContext::Edit& edit,
                          const std::function<std::optional<std::size_t>(std::size_t)>& position) {
  if (std::holds_alternative<ListShape>(shape_)) {
    const auto moved = [&](const std::set<std::string>& pointers) {
      std::set<std::string> there{};
      for (const std::string& one : pointers) {
        const std::size_t begin = pointer().size() + 1;
        if (!one.starts_with(pointer() + "/")) {
          there.insert(one);
          continue;
        }
        const std::size_t end = std::min(one.find('/', begin), one.size());
        const auto at = position(std::stoul(one.substr(begin, end - begin)));
        if (at) there.insert(pointer_to(pointer(), *at) + one.substr(end));
      }
      return there;
    };
    ticked_ = moved(ticked_);
    context().opened.erase(pointer() + "/");
    context().opened = moved(context().opened);
  }
  context().edit(edit, {});
}

std::size_t EntryList::move(std::size_t index, int by) {
  std::vector<std::size_t> moved = together(index);
  if (by > 0) std::reverse(moved.begin(), moved.end());
  if (moved.front() == (by > 0 ? entries_.size() - 1 : 0)) return index;
  std::vector<std::size_t> order(entries_.size());  // the entries before, by their position
  std::iota(order.begin(), order.end(), 0);
  // An entry, and the one whose place it takes: positions in the text also count comments.
  std::vector<std::pair<std::string, std::string>> steps{};
  for (const std::size_t i : moved) {
    const std::size_t other = by > 0 ? i + 1 : i - 1;
    steps.emplace_back(entries_[i].pointer, entries_[other].pointer);
    std::swap(order[i], order[other]);
  }
  const auto position = [&order](std::size_t before) {
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), before) - order.begin());
  };
  rearrange(
      [&](const JsonDocument& document) {
        FormEdit edit{std::string(document.text()), {}};
        for (const auto& [one, other] : steps) {
          const JsonDocument present(edit.text, {});
          edit = with_moved(present, one, entry_at(present, other).index);
        }
        return edit;
      },
      position);
  return position(index);
}

std::size_t EntryList::duplicate(std::size_t index) {
  std::vector<std::size_t> copied = together(index);
  const auto position = [&copied](std::size_t before) {
    const auto before_it = std::lower_bound(copied.begin(), copied.end(), before);
    return before + static_cast<std::size_t>(before_it - copied.begin());
  };
  rearrange(
      [&](const JsonDocument& document) {
        FormEdit edit{std::string(document.text()), {}};
        for (auto i = copied.rbegin(); i != copied.rend(); ++i) {  // pointers before a copy stay
          edit = with_copy(JsonDocument(edit.text, {}), entries_[*i].pointer);
        }
        return edit;
      },
      position);
  return position(index) + 1;
}

std::size_t EntryList::remove(std::size_t index) {
  const std::vector<std::size_t> gone = together(index);
  std::vector<std::string> pointers{};
  for (const std::size_t i : gone) {
    pointers.push_back(entries_[i].pointer);
    ticked_.erase(entries_[i].pointer);
  }
  rearrange([&](const JsonDocument& text) { return with_removed(text, pointers); },
            [&](std::size_t before) -> std::optional<std::size_t> {
              const auto after = std::lower_bound(gone.begin(), gone.end(), before);
              if (after != gone.end() && *after == before) return {};
              return before - static_cast<std::size_t>(after - gone.begin());
            });
  const auto gone_before = std::lower_bound(gone.begin(), gone.end(), index) - gone.begin();
  return index - static_cast<std::size_t>(gone_before);
}

void EntryList::add(const std::string& key) {
  context().edit(
      [&](const JsonDocument& text) {
        const Parameter* const parameter = source().parameter_at(pointer_to(pointer(), key));
        FormEdit edit = parameter == nullptr ? with_entry(text, pointer(), key)
                                             : with_value(text, pointer_to(pointer(), key),
                                                          json_text_of(parameter->default_value));
        context().opened.insert(edit.pointer);
        return edit;
      },
      {});
}

}  // namespace asperity

#include "moc_entry_list.cpp"
