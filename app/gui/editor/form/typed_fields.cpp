// Implements the fields of a form in which something is typed.

#include "app/gui/editor/form/typed_fields.h"

#include <algorithm>
#include <array>

#include <QtCore/QPointer>
#include <QtCore/QSignalBlocker>
#include <QtCore/QStringListModel>
#include <QtGui/QKeyEvent>
#include <QtWidgets/QCompleter>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPlainTextEdit>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/gui/base/typed_number.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"
#include "protocols/editing/edits.h"
#include "protocols/form/form_entries.h"

namespace asperity {

namespace {

constexpr int kNumberWidth = 128;
constexpr int kLeastNumberWidth = 64;
constexpr int kFewestLines = 2;
constexpr int kMostLines = 12;

/// A field without an undo of its own: the keys reach the form, whose edits are steps of one list.
template <class Field>
class WithoutUndo final : public Field {
 public:
  using Field::Field;

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride) {
      const auto& key = static_cast<const QKeyEvent&>(*event);
      if (key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo)) {
        event->ignore();
        return false;
      }
    }
    return Field::event(event);
  }
};

/// Offers a line names: those that contain what is typed, and all with the down arrow key.
class OfferedNames final : public QObject {
 public:
  /// `names` are asked for when something is about to be typed. `shown` is called when the line shows one that the list
  /// highlights, which stays when the list is left, `taken` when one is chosen.
  OfferedNames(QLineEdit& line, std::function<QStringList()> names, std::function<void()> shown,
               std::function<void()> taken)
      : QObject(&line), names_(std::move(names)) {
    completer_ = new QCompleter(&list_, this);
    completer_->setFilterMode(Qt::MatchContains);
    completer_->setCaseSensitivity(Qt::CaseInsensitive);
    line.setCompleter(completer_);
    line.installEventFilter(this);
    // Queued: the line writes the name into itself in slots of its own, which are later.
    connect(
        completer_, qOverload<const QString&>(&QCompleter::highlighted), this,
        [shown = std::move(shown)](const QString&) { shown(); }, Qt::QueuedConnection);
    connect(
        completer_, qOverload<const QString&>(&QCompleter::activated), this,
        [taken = std::move(taken)](const QString&) { taken(); }, Qt::QueuedConnection);
  }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::FocusIn) list_.setStringList(names_());
    const bool is_key = event->type() == QEvent::KeyPress;
    if (is_key && static_cast<const QKeyEvent&>(*event).key() == Qt::Key_Down) {
      completer_->setCompletionPrefix({});
      completer_->complete();
      return true;
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  std::function<QStringList()> names_{};
  QStringListModel list_{};
  QCompleter* completer_ = nullptr;
};

/// A level that is written as a number is one; where the present one is a text of digits, the new one is a text as well.
std::optional<std::string> level_typed(const QString& typed, const nlohmann::json* present) {
  const bool is_text = present != nullptr && present->is_string() &&
                       shifted_decimal(present->get<std::string>(), 0).has_value();
  return is_text ? std::nullopt : shifted_decimal(decimal_of(typed), 0);
}

}  // namespace

LineField::LineField(FormContext& context, const FieldOf& of, const std::string& pointer,
                     QWidget* parent)
    : FormPart(context, pointer, parent), of_(of) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid / 2);
  line_ = new WithoutUndo<QLineEdit>(this);
  unit_ = make_text({}, this, true);
  unit_->setWordWrap(false);
  unit_->hide();
  layout->addWidget(line_, 0, 0);
  layout->addWidget(unit_, 0, 1);
  setFocusProxy(line_);
  connect(line_, &QLineEdit::textEdited, this, &LineField::take);
}

void LineField::set_unit(const QString& unit) {
  unit_->setText(unit);
  unit_->setVisible(!unit.isEmpty());
}

void LineField::take(const QString& typed) {
  taken_ = source().characters(pointer());
  if (typed.isEmpty() && of_.may_be_absent()) {
    remove(pointer(), pointer());
  } else {
    write_typed(json_of(typed));
  }
  taken_ = source().characters(pointer());
}

void LineField::refresh() {
  const nlohmann::json standard = of_.standard();
  line_->setPlaceholderText(standard.is_null() ? QString() : shown(standard.dump()));
  const std::string_view characters = source().characters(pointer());
  // What is being typed stays: another notation of the value, or what is none yet.
  if (line_->hasFocus() && line_->isModified() && characters == taken_) return;
  const nlohmann::json* const present = value();
  if (present != nullptr && line_->hasFocus() &&
      nlohmann::json::parse(json_of(line_->text())) == *present) {
    return;
  }
  const QString text = present == nullptr ? QString() : shown(characters);
  if (line_->text() != text) line_->setText(text);
  // Not where the search has selected words.
  if (!line_->hasFocus() && !line_->hasSelectedText()) line_->setCursorPosition(0);
}

NumbersField::NumbersField(FormContext& context, const NumberShape& shape, Count count,
                           const FieldOf& of, const std::string& pointer, QWidget* parent)
    : LineField(context, of, pointer, parent), shape_(shape), count_(count) {
  if (count == Count::one) {
    line().setMinimumWidth(kLeastNumberWidth);
    line().setMaximumWidth(kNumberWidth);
    static_cast<QGridLayout*>(layout())->setColumnStretch(2, 1);  // empty
    line().setAlignment(Qt::AlignRight);
  }
  set_unit(shown_unit(shape));
}

QString NumbersField::shown(std::string_view characters) const {
  const auto present = nlohmann::json::parse(characters);
  if (present.is_string()) return text(present.get<std::string>());
  if (count_ == Count::one) return shown_in_unit(shape_, characters);
  QStringList numbers{};
  for (const nlohmann::json& number : present) {
    numbers.append(number.is_string() ? text(number.get<std::string>())
                                      : shown_in_unit(shape_, number.dump()));
  }
  return numbers.join("; ");
}

/// What cannot be read is text in the file, so that it stays, is checked and can be undone as any other value.
std::string NumbersField::json_of(const QString& typed) const {
  const auto number_or_text = [this](const QString& one) {
    return number_typed(shape_, one).value_or(json_string(one.toStdString()));
  };
  if (count_ == Count::one) return number_or_text(typed);
  std::string list{};
  for (const QString& part : typed.split(';', Qt::SkipEmptyParts)) {
    const QString number = part.trimmed();
    if (!number.isEmpty()) list += (list.empty() ? "" : ", ") + number_or_text(number);
  }
  return "[" + list + "]";
}

TextField::TextField(FormContext& context, const NameShape& offered, Values values,
                     const FieldOf& of, const std::string& pointer, QWidget* parent)
    : LineField(context, of, pointer, parent), values_(values) {
  const NameShape shape =
      offered.registry.empty() && values == Values::levels ? NameShape{kLevelNames} : offered;
  if (shape.registry.empty()) return;
  offer([this, shape] { return source().names_for(shape, this->pointer()); });
}

void TextField::offer(std::function<QStringList()> texts) {
  const auto take_shown = [this] { emit line().textEdited(line().text()); };
  new OfferedNames(line(), std::move(texts), take_shown, take_shown);
}

QString TextField::shown(std::string_view characters) const {
  const auto value = nlohmann::json::parse(characters);
  if (value.is_string()) return text(value.get<std::string>());
  return shown_decimal(characters);
}

std::string TextField::json_of(const QString& typed) const {
  if (values_ == Values::levels) {
    if (const auto level = level_typed(typed, value())) return *level;
  }
  return json_string(typed.toStdString());
}

ParagraphField::ParagraphField(FormContext& context, const FieldOf& of, const std::string& pointer,
                               QWidget* parent)
    : FormPart(context, pointer, parent), of_(of) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  box_ = new WithoutUndo<QPlainTextEdit>(this);
  box_->setTabChangesFocus(true);
  box_->setUndoRedoEnabled(false);
  layout->addWidget(box_);
  setFocusProxy(box_);
  connect(box_, &QPlainTextEdit::textChanged, this, &ParagraphField::take);
}

void ParagraphField::take() {
  const std::string typed = text_of(*box_->document()).toStdString();
  if (typed.empty() && of_.may_be_absent()) {
    remove(pointer());
  } else {
    write_typed(json_string(typed));
  }
  fit();
}

void ParagraphField::refresh() {
  const nlohmann::json* const present = value();
  const QString shown =
      present != nullptr && present->is_string() ? text(present->get<std::string>()) : QString();
  if (text_of(*box_->document()) != shown) {
    const QSignalBlocker quiet(box_);
    const int cursor = box_->textCursor().position();
    box_->setPlainText(shown);
    QTextCursor there = box_->textCursor();
    there.setPosition(std::min(cursor, static_cast<int>(shown.size())));
    box_->setTextCursor(there);
  }
  fit();
}

void ParagraphField::resizeEvent(QResizeEvent* event) {
  FormPart::resizeEvent(event);
  fit();
}

void ParagraphField::fit() {
  const int lines =
      std::clamp(static_cast<int>(box_->document()->size().height()), kFewestLines, kMostLines);
  const int frame =
      2 * box_->frameWidth() + 2 * static_cast<int>(box_->document()->documentMargin());
  box_->setFixedHeight(lines * QFontMetrics(box_->font()).lineSpacing() + frame + kGrid);
}

DeclaredNameField::DeclaredNameField(FormContext& context, Named named, TextField::Values values,
                                     const FieldOf& of, const std::string& pointer, QWidget* parent)
    : FormPart(context, pointer, parent), named_(named), values_(values), of_(of) {
  // The value of a member has the pointer as its object name.
  if (named == Named::by_key) setObjectName("name:" + text(pointer));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  line_ = new WithoutUndo<QLineEdit>(this);
  layout->addWidget(line_);
  refusal_ = make_problem_label(this);
  layout->addWidget(refusal_);
  setFocusProxy(line_);
  if (values == TextField::Values::levels) {
    new OfferedNames(
        *line_, [this] { return source().names_for({kLevelNames}, this->pointer()); },
        [this] { wait_for_the_rest(); },
        [this] {
          wait_for_the_rest();
          take();
        });
  }
  connect(line_, &QLineEdit::textEdited, this, &DeclaredNameField::wait_for_the_rest);
  connect(line_, &QLineEdit::editingFinished, this, &DeclaredNameField::take);
}

DeclaredNameField::~DeclaredNameField() {
  if (is_typed_) context().write_pending = {};
}

QString DeclaredNameField::name() const {
  if (named_ == Named::by_key) return text(nlohmann::json::json_pointer(pointer()).back());
  const nlohmann::json* const present = value();
  if (present == nullptr) return {};
  if (present->is_number()) return shown_decimal(source().characters(pointer()));
  return present->is_string() ? text(present->get<std::string>()) : QString();
}

FormEdit DeclaredNameField::renamed(const JsonDocument& document, const QString& typed) const {
  // References are names: a level that has some stays one.
  if (values_ == TextField::Values::levels && source().references_to(pointer()) == 0) {
    if (const auto level = level_typed(typed, value())) {
      return with_value(document, pointer(), *level);
    }
  }
  return with_name(document, pointer(), named_, typed.toStdString());
}

void DeclaredNameField::wait_for_the_rest() {
  refusal_->hide();
  is_typed_ = true;
  context().write_pending = [this] { take(); };
}

void DeclaredNameField::take() {
  if (!is_typed_ || context().is_refreshing) return;
  const QString typed = line_->text().trimmed();
  is_typed_ = false;
  context().write_pending = {};
  if (typed == name()) return;
  const bool is_removed = typed.isEmpty() && of_.may_be_absent();
  // The edit makes this field again where it is the key of a card.
  const QPointer<DeclaredNameField> still_there(this);
  const QString refusal = context().edit(
      [&](const JsonDocument& document) {
        return is_removed ? without(document, std::array{pointer()}) : renamed(document, typed);
      },
      {});
  if (!still_there) return;
  refused_in_ = refusal.isEmpty() ? nullptr : context().source;
  refresh();  // a name that is refused is not in the text
  show_problem(*refusal_, refusal);
}

void DeclaredNameField::refresh() {
  if (refused_in_ != context().source) refusal_->hide();
  if (is_typed_) return;
  if (line_->text() != name()) line_->setText(name());
}

}  // namespace asperity

#include "moc_typed_fields.cpp"
