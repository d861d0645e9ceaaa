// Shows the pages of a form, and passes on the edits of its fields.

#include "app/gui/editor/form/protocol_form.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include <QtCore/QCoreApplication>
#include <QtCore/QTimer>
#include <QtCore/QtMath>
#include <QtGui/QShortcut>
#include <QtWidgets/QApplication>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QStyle>
#include <nlohmann/json.hpp>

#include "app/gui/base/form_words.h"
#include "app/gui/editor/form/form_fields.h"
#include "app/gui/editor/form/form_search.h"
#include "app/gui/editor/form/object_rows.h"
#include "app/gui/editor/form/texts_list.h"
#include "app/gui/editor/form/used_control.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/look/words.h"
#include "app/words/phrase_of_error.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

namespace {

constexpr int kPagesWidth = 208;
constexpr int kLeastPagesWidth = 160;
/// Around the name of a page, with a scroll bar next to it.
constexpr int kAroundPageName = 40;
/// Of a form that has room for the names of the pages in a line each.
constexpr int kRoomyWidth = 680;
constexpr int kLinesOfHelp = 3;

/// The controls in a layout, in its order.
void collect_controls(QLayout& layout, std::vector<QWidget*>& controls) {
  for (int i = 0; i < layout.count(); ++i) {
    QLayoutItem& item = *layout.itemAt(i);
    if (item.layout() != nullptr) collect_controls(*item.layout(), controls);
    QWidget* const widget = item.widget();
    if (widget == nullptr) continue;
    if ((widget->focusPolicy() & Qt::TabFocus) != 0) controls.push_back(widget);
    if (widget->layout() != nullptr) collect_controls(*widget->layout(), controls);
  }
}

/// The name of a page with the number of its problems and the mark of the worst.
QString counted(const QString& label, State worst, std::size_t remarks) {
  return QString("%1  %2\u00A0%3").arg(label, shape_of(worst)).arg(remarks);
}

/// Never a button that removes something, which may belong to another value now.
bool takes_focus(const QWidget& widget) {
  return widget.isVisible() && (widget.focusPolicy() & Qt::TabFocus) != 0 &&
         !widget.objectName().startsWith(kRemoving);
}

/// The field of the part, or the first control in it.
QWidget* control_of(const FormPart& part) {
  if (part.focusProxy() != nullptr) return part.focusProxy();
  for (QWidget* next = part.nextInFocusChain(); next != &part; next = next->nextInFocusChain()) {
    if (part.isAncestorOf(next) && takes_focus(*next)) return next;
  }
  return nullptr;
}

/// Selects the first of these words in a field of text; without words, or where the text has none of them, nothing.
void select_words(QWidget& control, const QString& words) {
  const auto place_in = [&words](const QString& text) {
    return words.isEmpty() ? -1 : static_cast<int>(text.indexOf(words, 0, Qt::CaseInsensitive));
  };
  const auto length = static_cast<int>(words.size());
  if (auto* const line = qobject_cast<QLineEdit*>(&control)) {
    const int place = place_in(line->text());
    if (place < 0) return line->deselect();
    line->setSelection(place, length);
  } else if (auto* const box = qobject_cast<QPlainTextEdit*>(&control)) {
    const int place = place_in(box->toPlainText());
    QTextCursor cursor = box->textCursor();
    cursor.clearSelection();
    if (place >= 0) {
      cursor.setPosition(place);
      cursor.setPosition(place + length, QTextCursor::KeepAnchor);
    }
    box->setTextCursor(cursor);
  }
}

}  // namespace

ProtocolForm::ProtocolForm(const std::vector<ModelDeclaration>& models, QWidget* parent)
    : QWidget(parent), models_(models), page_(&form_pages().front()) {
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(kMargin);
  pages_ = new QListWidget(this);
  pages_->setObjectName("form_pages");
  pages_->setAccessibleName(tr("Pages of the form"));
  pages_->setFixedWidth(kPagesWidth);
  pages_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  pages_->setWordWrap(true);
  pages_->setTextElideMode(Qt::ElideNone);
  for (const FormPage& page : form_pages()) {
    auto* item = new QListWidgetItem(text_of_keys(page.label), pages_);
    item->setToolTip(text_of_keys(page.meaning));
  }
  pages_->setCurrentRow(0);
  columns->addWidget(pages_);
  auto* right = new QVBoxLayout();
  right->setSpacing(kGrid);
  columns->addLayout(right, 1);
  state_ = make_problem_label(this);
  state_->setObjectName("form_state");
  right->addWidget(state_);
  area_ = new QScrollArea(this);
  area_->setObjectName("form_area");
  area_->setWidgetResizable(true);
  area_->setFrameShape(QFrame::NoFrame);
  area_->setAccessibleName(tr("Fields"));
  right->addWidget(area_, 1);
  used_ = std::make_unique<UsedControl>(*area_);
  help_area_ = new QScrollArea(this);  // always as high: the fields above stay where they are
  help_area_->setWidgetResizable(true);
  help_area_->setFrameShape(QFrame::NoFrame);
  help_area_->setFocusPolicy(Qt::NoFocus);
  help_ = make_text({}, help_area_, true);
  help_->setObjectName("form_help");
  help_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  help_->setFont(text_font(TextSize::small));
  help_area_->setWidget(help_);
  help_area_->setFixedHeight(kLinesOfHelp * QFontMetrics(help_->font()).lineSpacing());
  right->addWidget(help_area_);
  context_.edit = [this](const FormContext::Edit& change, const std::string& step) {
    return edit(change, step);
  };
  context_.refresh = [this] { refresh(); };
  context_.go_to = [this](const std::string& pointer) { go_to(pointer); };
  context_.show_in_text = [this](const std::string& pointer) { emit text_wanted(pointer); };
  // One shortcut for all lists: a list can be in an entry of another.
  for (const EntryAction action : {EntryAction::move_up, EntryAction::move_down,
                                   EntryAction::duplicate, EntryAction::remove}) {
    auto* shortcut = new QShortcut(keys_of(action), this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, [this, action] { act_on_entry(action); });
  }
  setFocusProxy(pages_);
  connect(pages_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row < 0) return;
    commit();
    scrolled_[page_->id] = area_->verticalScrollBar()->value();
    help_->clear();
    page_ = &form_pages()[static_cast<std::size_t>(row)];
    make_page();
    scroll_to(scrolled_[page_->id]);
  });
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (content_ == nullptr || now == nullptr || !content_->isAncestorOf(now)) return;
    mark(nullptr);
    if (now != found_) select_found(nullptr, {});
    show_help(now);
  });
}

/// The fields use the context until they are gone; that they lose the focus is no edit.
ProtocolForm::~ProtocolForm() {
  disconnect(qApp, nullptr, this, nullptr);
  context_.is_refreshing = true;
  delete area_;
}

void ProtocolForm::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  double longest = 0.0;  // word of a name
  for (const FormPage& page : form_pages()) {
    longest = std::max(
        longest, width_of_longest_word(text_of_keys(page.label), QFontMetricsF(pages_->font())));
  }
  const int needed = std::max(qCeil(longest) + kAroundPageName, kLeastPagesWidth);
  pages_->setFixedWidth(width() < kRoomyWidth ? needed : kPagesWidth);
  fit_pages();
  used_->keep(content_);
}

/// The list itself wraps a name only some time after its width has changed. A name has the height that it has with a number of
/// problems, so that no other moves away under the pointer when the number comes or goes.
void ProtocolForm::fit_pages() {
  const QFontMetrics letters(pages_->font());
  const QRect room(0, 0, pages_->width() - kAroundPageName, QWIDGETSIZE_MAX);
  for (int row = 0; row < pages_->count(); ++row) {
    QListWidgetItem& item = *pages_->item(row);
    const QString label = text_of_keys(form_pages()[static_cast<std::size_t>(row)].label);
    const auto height_of = [&](const QString& name) {
      return letters.boundingRect(room, Qt::TextWordWrap, name).height();
    };
    const int height = std::max(height_of(item.text()), height_of(counted(label, State::look, 9)));
    item.setSizeHint({room.width(), height + kGrid});
  }
}

/// After the layout has shown what was made.
void ProtocolForm::scroll_to(int value) {
  if (content_ == nullptr) return;
  QTimer::singleShot(0, content_, [this, value] {
    send_layouts();
    area_->verticalScrollBar()->setValue(value);
  });
}

void ProtocolForm::act_on_entry(EntryAction action) {
  const QWidget* const focus = QApplication::focusWidget();
  if (focus == nullptr || !can_be_edited_ || read_only_) return;
  commit();
  for (QWidget* widget = focus->parentWidget(); widget != nullptr && widget != this;
       widget = widget->parentWidget()) {
    auto* const list = qobject_cast<EntryList*>(widget);
    if (list != nullptr && list->act(*focus, action)) return;
  }
}

bool ProtocolForm::commit() {
  was_refused_ = false;
  if (const auto write = std::exchange(context_.write_pending, {})) write();
  return !was_refused_;
}

QString ProtocolForm::edit(const FormContext::Edit& change, const std::string& step) {
  if (!can_be_edited_ || read_only_ || context_.is_refreshing) return {};
  commit();
  used_->rest_pointer();
  FormEdit edited{};
  try {
    edited = change(context_.source->document());
  } catch (const ProtocolError& error) {
    const nlohmann::json& protocol = context_.source->document().root();
    was_refused_ = true;
    const Diagnostic& refusal = error.diagnostics().front();
    emit edit_refused(remark_in_form(protocol, refusal));
    return sentence_in_form(protocol, refusal);
  } catch (const std::exception& error) {
    was_refused_ = true;
    emit edit_refused(words_of(phrase_of(error)));
    return words_of(phrase_of(error));
  }
  emit edit_made(edited.text, step);
  return {};
}

void ProtocolForm::show_text(const std::string& written) {
  used_->rest_pointer();
  try {
    auto source = std::make_shared<const FormSource>(written, models_);
    if (source->document().root().is_object()) {
      const auto before = std::exchange(context_.source, std::move(source));
      can_be_edited_ = true;
      if (before != nullptr) follow_names(before);
      state_->hide();
    } else {
      show_unreadable(tr("the text is not an object {…}"));
    }
  } catch (const std::exception& error) {
    show_unreadable(words_of(phrase_of(error)));
  }
  if (content_ == nullptr) {
    make_page();
  } else {
    refresh();
  }
  context_.renamed = {};
}

/// What is unfolded stays so under another name, also when that is undone.
void ProtocolForm::follow_names(const std::shared_ptr<const FormSource>& before) {
  context_.renamed = [before, after = context_.source](const std::string& pointer) {
    return renamed_pointer(before->document(), after->document(), pointer);
  };
  std::set<std::string> opened{};
  for (const std::string& one : context_.opened) {
    const bool is_of_settings = one.ends_with('/');
    const std::string value = is_of_settings ? one.substr(0, one.size() - 1) : one;
    opened.insert(context_.renamed(value) + (is_of_settings ? "/" : ""));
  }
  context_.opened = std::move(opened);
}

void ProtocolForm::show_unreadable(const QString& why) {
  can_be_edited_ = false;
  show_problem(*state_,
               tr("The text is not valid JSON. The form shows the last valid text and cannot "
                  "be edited. Correct it in the text: %1")
                   .arg(why));
}

void ProtocolForm::forget() {
  context_.source = nullptr;
  context_.opened.clear();
  context_.write_pending = {};
  scrolled_.clear();
  help_->clear();
  can_be_edited_ = false;
  parts_.clear();
  content_ = nullptr;
  delete area_->takeWidget();
}

void ProtocolForm::set_read_only(bool read_only) {
  read_only_ = read_only;
  refresh();
}

void ProtocolForm::make_page() {
  parts_.clear();
  if (context_.source == nullptr) return;
  // Hidden until its fields are made: each that is shown alone would lay out all others again.
  content_ = new QWidget(area_->viewport());
  content_->resize(area_->viewport()->size());
  auto* layout = new QVBoxLayout(content_);
  layout->setContentsMargins(0, 0, kMargin, 0);
  layout->setSpacing(kMargin);
  layout->addWidget(make_text(text_of_keys(page_->meaning), content_, true));
  auto* rows = new ObjectRows(context_, *page_, content_);
  layout->addWidget(rows);
  parts_.push_back(rows);
  if (page_->lists_texts) {
    auto* texts = new TextsList(context_, content_);
    layout->addWidget(texts);
    parts_.push_back(texts);
  }
  layout->addStretch();
  refresh();
  area_->setWidget(content_);  // deletes the page before
}

void ProtocolForm::refresh() {
  if (content_ == nullptr || context_.source == nullptr) return;
  // A part that is made again loses the focus to nothing: its field gets it back.
  QWidget* const focused = QApplication::focusWidget();
  const bool was_here = focused != nullptr && content_->isAncestorOf(focused);
  const Focus focus = was_here ? focus_of(*focused) : Focus{};
  const int scrolled = area_->verticalScrollBar()->value();
  if (context_.is_refreshing) return;
  context_.is_refreshing = true;
  for (FormPart* const part : parts_) part->refresh();
  context_.is_refreshing = false;
  if (std::exchange(context_.has_new_parts, false)) order_for_keyboard();
  content_->setEnabled(can_be_edited_ && !read_only_);
  // A stop of the keyboard only where it has no other in the page, so that the page can be scrolled.
  area_->setFocusPolicy(content_->isEnabled() ? Qt::ClickFocus : Qt::StrongFocus);
  if (!was_here || QApplication::focusWidget() == focused) return;
  // Qt gave the focus to any other control, which may be a button that removes something.
  area_->setFocus();
  // After the layout has shown what was made.
  QTimer::singleShot(0, content_, [this, focus, scrolled] {
    if (QApplication::focusWidget() == area_) give_focus_back(focus);
    area_->verticalScrollBar()->setValue(scrolled);
  });
}

ProtocolForm::Focus ProtocolForm::focus_of(const QWidget& focused) const {
  const auto now = [this](const std::string& pointer) {
    return context_.renamed ? context_.renamed(pointer) : pointer;
  };
  // "open:/factors/speed", or a pointer alone.
  const auto name_now = [&now](const QString& name) {
    const qsizetype begin = name.indexOf('/');
    if (begin < 0) return name;
    return name.left(begin) + text(now(name.mid(begin).toStdString()));
  };
  Focus focus{.name = name_now(focused.objectName())};
  for (const QWidget* at = &focused; at != nullptr && at != content_; at = at->parentWidget()) {
    if (const auto* const part = qobject_cast<const FormPart*>(at)) {
      focus.part = name_now(part->objectName());
      focus.pointer = now(part->pointer());
      break;
    }
  }
  if (const auto* const line = qobject_cast<const QLineEdit*>(&focused)) {
    focus.cursor = line->cursorPosition();
  }
  return focus;
}

void ProtocolForm::give_focus_back(const Focus& focus) {
  QString name = focus.name;
  if (name.startsWith(kRemovingValue)) name.replace(0, kRemovingValue.size(), kChoosing);
  QWidget* control = nullptr;
  for (QWidget* const same : content_->findChildren<QWidget*>(name)) {  // the button that unfolds
    if (!name.isEmpty() && takes_focus(*same)) control = same;
  }
  for (FormPart* const part : content_->findChildren<FormPart*>(focus.part)) {
    if (focus.part.isEmpty()) break;  // which would find every part
    if (control == nullptr && part->isVisible()) control = part->focusProxy();
  }
  FormPart* const part = part_at(focus.pointer);
  if (control == nullptr && part != nullptr) control = control_of(*part);
  if (control == nullptr) return;
  control->setFocus();
  if (auto* const line = qobject_cast<QLineEdit*>(control); line != nullptr && focus.cursor >= 0) {
    line->setCursorPosition(focus.cursor);
  }
}

void ProtocolForm::order_for_keyboard() {
  std::vector<QWidget*> controls{};
  collect_controls(*content_->layout(), controls);
  QWidget* before = area_;
  for (QWidget* const control : controls) {
    QWidget::setTabOrder(before, control);
    before = control;
  }
}

QString ProtocolForm::sentence_of(const Diagnostic& remark) const {
  if (context_.source == nullptr) return words_of(remark.message);
  const Parameter* const parameter = context_.source->parameter_at(remark.pointer);
  const bool is_number = parameter != nullptr && parameter->kind != ParameterKind::choice;
  return sentence_in_form(context_.source->document().root(), remark,
                          is_number ? std::optional(number_shape(*parameter)) : std::nullopt);
}

void ProtocolForm::show_problems(const std::vector<Diagnostic>& problems,
                                 const std::vector<Diagnostic>& warnings) {
  context_.problems.clear();
  const auto add = [this](State state, const std::vector<Diagnostic>& remarks) {
    for (const Diagnostic& remark : remarks) {
      if (context_.source == nullptr) break;
      context_.problems[remark.pointer].push_back({state, sentence_of(remark)});
    }
  };
  add(State::stop, problems);
  add(State::look, warnings);
  count_problems();
  used_->keep(content_);
  refresh();
  used_->put_back();
}

/// The number of problems and warnings of a page is next to its name, with the mark of the worst.
void ProtocolForm::count_problems() {
  struct Count {
    std::size_t remarks = 0;
    State worst = State::look;
  };
  std::vector<Count> counts(form_pages().size());
  for (const auto& [pointer, remarks] : context_.problems) {
    const FormPage& page = form_page_of(pointer);
    Count& count = counts[static_cast<std::size_t>(&page - form_pages().data())];
    count.remarks += remarks.size();
    for (const Remark& remark : remarks) {
      if (remark.state == State::stop) count.worst = State::stop;
    }
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const QString label = text_of_keys(form_pages()[i].label);
    pages_->item(static_cast<int>(i))
        ->setText(counts[i].remarks == 0 ? label
                                         : counted(label, counts[i].worst, counts[i].remarks));
  }
  fit_pages();
}

FormPart* ProtocolForm::part_at(const std::string& pointer) const {
  if (content_ == nullptr) return nullptr;
  FormPart* nearest = nullptr;
  for (FormPart* const part : content_->findChildren<FormPart*>()) {
    if (!part->isVisibleTo(content_) || part->objectName() != text(part->pointer())) continue;
    if (part->pointer() == pointer) return part;
    const bool contains = pointer.starts_with(part->pointer() + "/");
    const bool is_nearer = nearest == nullptr || part->pointer().size() > nearest->pointer().size();
    if (contains && is_nearer) nearest = part;
  }
  return nearest;
}

/// The field of the value, that of its name or the button that adds it; otherwise a control of the part, the nearest one.
QWidget* ProtocolForm::control_at(const FormPart& part, const std::string& pointer) const {
  if (part.pointer() == pointer && part.focusProxy() != nullptr) return part.focusProxy();
  const bool is_present = context_.source->find(pointer) != nullptr;
  for (QWidget* const widget :
       content_->findChildren<QWidget*>((is_present ? "name:" : "add:") + text(pointer))) {
    if (widget->isVisible()) return widget;
  }
  return control_of(part);
}

std::vector<std::string> ProtocolForm::places_with(const QString& words) const {
  return context_.source == nullptr ? std::vector<std::string>{}
                                    : asperity::places_with(*context_.source, words);
}

void ProtocolForm::show_page(std::string_view id) {
  for (std::size_t i = 0; i < form_pages().size(); ++i) {
    if (form_pages()[i].id == id) pages_->setCurrentRow(static_cast<int>(i));
  }
}

ProtocolForm::Shown ProtocolForm::shown() const {
  Shown shown{page_->id, context_.opened, {}};
  const QWidget* const focused = focusWidget();
  if (content_ != nullptr && focused != nullptr && content_->isAncestorOf(focused)) {
    shown.pointer = focus_of(*focused).pointer;
  }
  return shown;
}

void ProtocolForm::resume(const Shown& shown) {
  context_.opened = shown.opened;
  show_page(shown.page);
  refresh();
  const bool is_here = !shown.pointer.empty() && form_page_of(shown.pointer).id == shown.page;
  if (is_here) go_to(shown.pointer);
}

void ProtocolForm::go_to(const std::string& pointer, Lead lead, const QString& words) {
  if (context_.source == nullptr) return;
  for (nlohmann::json::json_pointer path(pointer); !path.empty(); path.pop_back()) {
    context_.opened.insert(path.to_string());
    // Of an object whose key has no value, the folded settings.
    if (context_.source->find(path.to_string()) == nullptr) {
      context_.opened.insert(path.parent_pointer().to_string() + "/");
    }
  }
  show_page(form_page_of(pointer).id);
  refresh();
  QTimer::singleShot(0, content_, [this, pointer, lead, words] {
    FormPart* const part = part_at(pointer);
    if (part == nullptr) return;
    part->point_to(pointer);
    QWidget* const control = control_at(*part, pointer);
    if (lead == Lead::focus && control != nullptr) {
      control->setFocus();
    } else if (lead == Lead::mark) {
      mark(control);
      show_help(part);
    }
    select_found(control, words);
    send_layouts();
    area_->ensureWidgetVisible(part);
    if (control != nullptr) area_->ensureWidgetVisible(control);
  });
}

bool ProtocolForm::enter_marked() {
  if (marked_ == nullptr || !marked_->isVisible()) return false;
  QWidget* const control = marked_;
  control->setFocus();
  return control->hasFocus();
}

void ProtocolForm::mark(QWidget* control) {
  for (QWidget* const widget : {marked_.data(), control}) {
    if (widget == nullptr) continue;
    widget->setProperty("marked", widget == control);
    // As the theme draws it: its rules are chosen when a widget is polished.
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
  }
  marked_ = control;
}

/// In one field at a time.
void ProtocolForm::select_found(QWidget* control, const QString& words) {
  if (found_ != nullptr) select_words(*found_, {});
  const bool is_name = control != nullptr && control->focusProxy() != nullptr;  // of an entry
  found_ = words.isEmpty() ? nullptr : is_name ? control->focusProxy() : control;
  if (found_ != nullptr) select_words(*found_, words);
}

void ProtocolForm::show_help(const QWidget* control) {
  for (const QWidget* at = control; at != nullptr && at != content_; at = at->parentWidget()) {
    const auto* const part = qobject_cast<const FormPart*>(at);
    if (part == nullptr || part->meaning().isEmpty()) continue;
    help_->setText(part->meaning());
    help_area_->verticalScrollBar()->setValue(0);
    disconnect(helped_);
    helped_ = connect(part, &QObject::destroyed, help_, &QLabel::clear);
    return;
  }
  help_->clear();
}

}  // namespace asperity

#include "moc_protocol_form.cpp"
