// Implements the two views of a protocol: edits of the form become edits of the text.

#include "app/gui/editor/protocol_views.h"

#include <algorithm>
#include <utility>

#include <QtCore/QScopedValueRollback>
#include <QtGui/QShortcut>
#include <QtWidgets/QApplication>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QStackedWidget>
#include <QtWidgets/QVBoxLayout>

#include "app/gui/editor/find_bar.h"
#include "app/gui/editor/form/protocol_form.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/focus_order.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"

namespace asperity {

namespace {

/// What of a text becomes another: the characters between those that both have at the beginning and at the end.
struct Difference {
  TextRange range{};
  QString text{};
};
Difference difference(const QString& before, const QString& after) {
  const qsizetype shorter = std::min(before.size(), after.size());
  qsizetype begin = 0;
  while (begin < shorter && before[begin] == after[begin]) ++begin;
  qsizetype end = 0;
  while (end < shorter - begin &&
         before[before.size() - 1 - end] == after[after.size() - 1 - end]) {
    ++end;
  }
  return {{begin, before.size() - begin - end}, after.mid(begin, after.size() - begin - end)};
}

QKeySequence switch_keys() { return {Qt::CTRL | Qt::Key_T}; }

}  // namespace

ProtocolViews::ProtocolViews(std::vector<ModelDeclaration> models, QWidget* parent)
    : QWidget(parent), models_(std::move(models)), help_(models_) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  stack_ = new QStackedWidget(this);
  layout->addWidget(make_switch(), 0, Qt::AlignLeft);
  layout->addWidget(stack_, 1);
  QWidget* text_view = make_text_view();
  form_ = new ProtocolForm(models_, stack_);
  form_->setObjectName("editor_form");
  stack_->addWidget(form_);
  stack_->addWidget(text_view);
  find_ = new FindBar(*edit_, *form_, this);
  find_->setObjectName("editor_find_bar");
  layout->insertWidget(1, find_);
  place_in_focus_order(*find_);
  connect(form_, &ProtocolForm::edit_made, this, &ProtocolViews::take_edit);
  connect(form_, &ProtocolForm::edit_refused, this, &ProtocolViews::refused);
  connect(form_, &ProtocolForm::text_wanted, this, &ProtocolViews::show_in_text);
  connect(edit_, &QPlainTextEdit::textChanged, this, [this] {
    if (!is_editing_) step_.clear();
    if (view() == View::form) form_->show_text(edit_->text().toStdString());
    find_->refresh();
  });
  // What is typed in a field is one step until the field is left or the text is saved.
  connect(qApp, &QApplication::focusChanged, this, [this] { step_.clear(); });
  connect(edit_, &QPlainTextEdit::modificationChanged, this, [this](bool is_modified) {
    if (!is_modified) step_.clear();
  });
  connect(edit_, &QPlainTextEdit::cursorPositionChanged, this, &ProtocolViews::show_help);
  // Wherever the focus is in the window; fields of text have their own.
  for (const auto key : {QKeySequence::Undo, QKeySequence::Redo}) {
    auto* shortcut = new QShortcut(QKeySequence(key), this);
    shortcut->setContext(Qt::WindowShortcut);
    connect(shortcut, &QShortcut::activated, this,
            [this, key] { undo_or_redo(key == QKeySequence::Undo); });
  }
  const auto add_finding = [this](QKeyCombination keys, FindBar::Direction direction) {
    auto* shortcut = new QShortcut(keys, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, [this, direction] { find_->find(direction); });
  };
  add_finding(Qt::Key_F3, FindBar::Direction::forwards);
  add_finding(Qt::SHIFT | Qt::Key_F3, FindBar::Direction::backwards);
}

// A field with the focus, which is deleted after the members, changes the focus. The form is deleted before, while its context
// exists: a name that is typed in it is no edit when it loses the focus.
ProtocolViews::~ProtocolViews() {
  disconnect(qApp, nullptr, this, nullptr);
  delete form_;
}

/// The buttons of both views.
QWidget* ProtocolViews::make_switch() {
  auto* buttons = new QWidget(this);
  auto* layout = new QHBoxLayout(buttons);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* group = new QButtonGroup(buttons);
  const auto add = [&](const QString& name, const char* object, View view) {
    QPushButton* button = make_button(name, ButtonRole::selector, buttons);
    button->setObjectName(object);
    button->setToolTip(
        tr("Switches to the other view: %1").arg(switch_keys().toString(QKeySequence::NativeText)));
    group->addButton(button);
    layout->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, view] {
      set_view(view);
      give_focus();
    });
    return button;
  };
  to_form_ = add(tr("Form"), "editor_to_form", View::form);
  to_text_ = add(tr("Text"), "editor_to_text", View::text);
  to_form_->setChecked(true);
  auto* shortcut = new QShortcut(switch_keys(), this);
  shortcut->setContext(Qt::WidgetWithChildrenShortcut);
  connect(shortcut, &QShortcut::activated, this,
          [this] { (view() == View::form ? to_text_ : to_form_)->click(); });
  return buttons;
}

QWidget* ProtocolViews::make_text_view() {
  auto* view = new QWidget(stack_);
  auto* layout = new QVBoxLayout(view);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  edit_ = new ProtocolTextEdit(view);
  edit_->setObjectName("editor_text");
  edit_->setAccessibleName(tr("Text of the protocol"));
  key_help_ = make_text({}, view);
  key_help_->setObjectName("editor_help");
  key_help_->setFont(text_font(TextSize::small));
  key_help_->setTextFormat(Qt::RichText);
  key_help_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  key_help_->setFixedHeight(3 * QFontMetrics(key_help_->font()).lineSpacing());
  layout->addWidget(edit_, 1);
  layout->addWidget(key_help_);
  return view;
}

void ProtocolViews::offer_files(std::function<QStringList()> files) {
  form_->offer_files(std::move(files));
}

ProtocolViews::View ProtocolViews::view() const {
  return stack_->currentIndex() == 0 ? View::form : View::text;
}

void ProtocolViews::set_view(View view) {
  commit();
  // While it is visible, the form follows the text.
  if (view == View::form && this->view() == View::text) {
    form_->show_text(edit_->text().toStdString());
  }
  stack_->setCurrentIndex(view == View::form ? 0 : 1);
  to_form_->setChecked(view == View::form);
  to_text_->setChecked(view == View::text);
  find_->refresh();
  emit view_changed();
}

void ProtocolViews::show_form_if_possible() {
  set_view(View::form);
  if (!form_->can_be_edited()) set_view(View::text);
}

void ProtocolViews::set_read_only(bool read_only) {
  edit_->setReadOnly(read_only);
  form_->set_read_only(read_only);
}

void ProtocolViews::forget() { form_->forget(); }

bool ProtocolViews::commit() { return view() != View::form || form_->commit(); }

void ProtocolViews::take_edit(const std::string& after, const std::string& step) {
  const Difference change = difference(edit_->text(), QString::fromStdString(after));
  if (change.range.length == 0 && change.text.isEmpty()) return;
  const QScopedValueRollback editing(is_editing_, true);
  const bool is_same_step = !step.empty() && step == step_;
  edit_->replace(change.range, change.text,
                 is_same_step ? ProtocolTextEdit::Step::same : ProtocolTextEdit::Step::another);
  step_ = step;
}

void ProtocolViews::undo_or_redo(bool is_undo) {
  if (is_undo) {
    edit_->undo();
  } else {
    edit_->redo();
  }
}

void ProtocolViews::show_problems(const std::vector<Diagnostic>& problems,
                                  const std::vector<Diagnostic>& warnings) {
  places_ = problems;
  places_.insert(places_.end(), warnings.begin(), warnings.end());
  edit_->show_problems(problems, warnings);
  form_->show_problems(problems, warnings);
}

QString ProtocolViews::sentence_of(const Diagnostic& remark) const {
  return view() == View::form ? form_->sentence_of(remark)
                              : asperity::text(remark.message.translated(language_of_windows()));
}

void ProtocolViews::go_to_problem(std::size_t index) {
  const auto& underlined = edit_->underlined();
  if (index >= places_.size() || static_cast<qsizetype>(index) >= underlined.size()) return;
  if (view() == View::form && form_->can_be_edited()) {
    form_->go_to(places_[index].pointer);
    return;
  }
  set_view(View::text);
  edit_->go_to(underlined[static_cast<qsizetype>(index)].cursor.selectionStart());
}

void ProtocolViews::show_in_text(const std::string& pointer) {
  const std::string written = edit_->text().toStdString();
  try {
    const Diagnostic place = JsonDocument(written, {}).at_key(pointer, Phrase());
    set_view(View::text);
    edit_->go_to(static_cast<int>(position_of(edit_->text(), place.line, place.column)));
  } catch (const ProtocolError&) {
    set_view(View::text);  // no JSON any more
  }
}

void ProtocolViews::find() { find_->begin(); }

void ProtocolViews::give_focus() {
  if (view() == View::form) {
    form_->setFocus();
  } else {
    edit_->setFocus();
  }
}

void ProtocolViews::return_focus() {
  QWidget* const used = view() == View::form ? form_->focusWidget() : edit_;
  if (used != nullptr) {
    used->setFocus();
  } else {
    give_focus();
  }
}

ProtocolViews::Shown ProtocolViews::shown() const {
  return {view(), form_->shown(), edit_->textCursor().position()};
}

void ProtocolViews::resume(const Shown& shown) {
  edit_->go_to(shown.cursor);
  set_view(shown.view);
  give_focus();
  form_->resume(shown.form);
}

void ProtocolViews::show_help() {
  const auto help = help_.of(json_place(edit_->text(), edit_->textCursor().position()));
  if (!help) {
    key_help_->setText(QString("<span style='color:%1'>%2</span>")
                           .arg(theme().muted.name(), tr("Help for the key at the cursor.")));
    return;
  }
  key_help_->setText(QString("<b>%1</b>&nbsp; %2<br><span style='color:%3'>%4</span>")
                         .arg(help->key.toHtmlEscaped(), help->meaning.toHtmlEscaped(),
                              theme().muted.name(), help->form.toHtmlEscaped()));
}

}  // namespace asperity

#include "moc_protocol_views.cpp"
