// Implements the fields of a form in which something is chosen.

#include "app/gui/editor/form/choice_fields.h"

#include <algorithm>
#include <utility>

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QPushButton>
#include <nlohmann/json.hpp>

#include "app/gui/base/question_form.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"
#include "app/study_files/parameter_json.h"
#include "protocols/editing/edits.h"
#include "protocols/form/new_values.h"

namespace asperity {

namespace {

constexpr int kChoiceWidth = 440;
/// The longest names of authors are cut.
constexpr int kMostNeededWidth = 320;
constexpr int kLettersOfChoice = 6;
constexpr int kLeastChoiceWidth = 112;

ChoiceBox* make_box(QWidget* parent) {
  auto* box = new ChoiceBox(parent);
  box->setMinimumWidth(kLeastChoiceWidth);
  box->setMaximumWidth(kChoiceWidth);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(kLettersOfChoice);
  box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  ignore_wheel(*box);
  return box;
}

/// The text, with the word in the file where another one is shown.
QString help_on(const ChoiceField::Choice& choice) {
  const bool has_other_name =
      !choice.shown_value.isEmpty() && choice.shown_value != text(choice.value);
  if (!has_other_name) return choice.text;
  return ChoiceField::tr("%1\nIn the file: %2").arg(choice.text, text(choice.value));
}

/// Replaces the items unless they are the same: the list can be open.
void set_items(ChoiceBox& box, const std::vector<ChoiceField::Choice>& choices, int current) {
  const QSignalBlocker quiet(&box);
  bool is_same = box.count() == static_cast<int>(choices.size());
  for (int i = 0; is_same && i < box.count(); ++i) {
    const ChoiceField::Choice& choice = choices[static_cast<std::size_t>(i)];
    is_same = box.itemText(i) == choice.text && box.itemData(i).toString() == text(choice.value);
  }
  if (!is_same) {
    box.clear();
    for (const ChoiceField::Choice& choice : choices) {
      box.addItem(choice.text, text(choice.value));
      box.setItemData(box.count() - 1, choice.shown_value, ChoiceBox::kValueRole);
      box.setItemData(box.count() - 1, help_on(choice), Qt::ToolTipRole);
    }
  }
  if (box.currentIndex() != current) box.setCurrentIndex(current);
  const QString value = box.currentData(ChoiceBox::kValueRole).toString();
  const int needed = box.width_for(value.isEmpty() ? box.currentText() : value);
  box.setMinimumWidth(std::clamp(needed, kLeastChoiceWidth, kMostNeededWidth));
  box.setToolTip(box.currentData(Qt::ToolTipRole).toString());
}

QHBoxLayout* make_row(QWidget* of) {
  auto* row = new QHBoxLayout(of);
  row->setContentsMargins(0, 0, 0, 0);
  return row;
}

}  // namespace

TruthField::TruthField(FormContext& context, const FieldOf& of, const std::string& pointer,
                       QWidget* parent)
    : FormPart(context, pointer, parent), of_(of) {
  box_ = new QCheckBox(this);
  make_row(this)->addWidget(box_);
  setFocusProxy(box_);
  connect(box_, &QCheckBox::clicked, this,
          [this](bool checked) { write(checked ? "true" : "false"); });
}

void TruthField::refresh() {
  const nlohmann::json* const present = value();
  const nlohmann::json shown = present == nullptr ? of_.standard() : *present;
  box_->setChecked(shown.is_boolean() && shown.get<bool>());
}

ChoiceField::ChoiceField(FormContext& context, Choices choices, const FieldOf& of,
                         const std::string& pointer, QWidget* parent)
    : FormPart(context, pointer, parent), choices_(std::move(choices)), of_(of) {
  box_ = make_box(this);
  QHBoxLayout* row = make_row(this);
  row->addWidget(box_, 1);
  setFocusProxy(box_);
  connect(box_, &QComboBox::activated, this, &ChoiceField::take);
}

void ChoiceField::refresh() {
  const nlohmann::json* const present = value();
  const nlohmann::json shown = present == nullptr ? of_.standard() : *present;
  std::vector<Choice> choices = choices_();
  if (shown.is_null() || shown == "") choices.insert(choices.begin(), {{}, tr("– not stated –")});
  const auto is_shown = [&shown](const Choice& choice) { return shown == choice.value; };
  auto current = std::find_if(choices.begin(), choices.end(), is_shown);
  if (current == choices.end() && shown.is_string()) {  // a name that does not exist
    const auto name = shown.get<std::string>();
    current = choices.insert(choices.end(), {name, text(name)});
  }
  const auto index = current == choices.end() ? 0 : current - choices.begin();
  set_items(*box_, choices, static_cast<int>(index));
}

void ChoiceField::offer(const QString& text, std::function<void()> make) {
  QPushButton* button = make_button(text, ButtonRole::link, this);
  layout()->addWidget(button);
  // Queued: what is made can be on another page, which deletes this field.
  connect(button, &QPushButton::clicked, window(), std::move(make), Qt::QueuedConnection);
}

void ChoiceField::take(int index) {
  const std::string chosen = box_->itemData(index).toString().toStdString();
  if (chosen.empty()) {
    remove(pointer());
  } else {
    write(json_string(chosen));
  }
}

BoundField::BoundField(FormContext& context, const ValueShape& shape, const FieldOf& of,
                       const std::string& pointer, QWidget* parent)
    : FormPart(context, pointer, parent), shape_(shape), of_(of) {
  source_ = make_box(this);
  fixed_ = make_field(context, shape, of, pointer, this);
  auto* row = new WrappingRow(this);
  row->addWidget(source_);
  row->addWidget(fixed_);
  connect(source_, &QComboBox::activated, this, &BoundField::take);
}

void BoundField::refresh() {
  const nlohmann::json* const present = value();
  const bool is_bound = present != nullptr && present->is_object();
  const auto factor = is_bound ? present->find("factor") : nlohmann::json::const_iterator{};
  const QString name = is_bound && factor != present->end() && factor->is_string()
                           ? text(factor->get<std::string>())
                           : QString();
  QStringList factors = source().names_for({kFactorNames}, pointer());
  if (is_bound && !factors.contains(name)) factors.append(name);
  std::vector<ChoiceField::Choice> choices{{{}, tr("Same in all trials")}};
  for (const QString& one : factors)
    choices.push_back({one.toStdString(), tr("Level of %1").arg(one)});
  set_items(*source_, choices, is_bound ? 1 + static_cast<int>(factors.indexOf(name)) : 0);
  setFocusProxy(is_bound ? source_ : fixed_->focusProxy());
  fixed_->setVisible(!is_bound);
  if (!is_bound) fixed_->refresh();
}

void BoundField::set_name(const QString& name) {
  source_->setAccessibleName(tr("%1: same in all trials, or the level of a factor").arg(name));
  fixed_->set_name(name);
}

void BoundField::take(int index) {
  const QString factor = source_->itemData(index).toString();
  if (!factor.isEmpty()) {
    write(R"({"factor": )" + json_string(factor.toStdString()) + "}");
    return;
  }
  const nlohmann::json* const present = value();
  if (present == nullptr || !present->is_object()) return;
  if (const Parameter* const parameter = source().parameter_at(pointer())) {
    write(json_text_of(parameter->default_value));
    return;
  }
  const auto* const name = std::get_if<NameShape>(&shape_);
  const QStringList names = name == nullptr ? QStringList() : source().names_for(*name, pointer());
  write(names.isEmpty() ? new_value(shape_, source().names()).dump()
                        : json_string(names.front().toStdString()));
}

}  // namespace asperity

#include "moc_choice_fields.cpp"
