// Joins the views of a protocol, live check and plan preview.

#include "app/gui/editor/protocol_editor_page.h"

#include <utility>

#include <QtCore/QDir>
#include <QtCore/QFileSystemWatcher>
#include <QtGui/QShortcut>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QSplitter>
#include <QtWidgets/QStackedWidget>
#include <nlohmann/json.hpp>

#include "analysis/numbers/look_alikes.h"
#include "app/gui/base/documents.h"
#include "app/gui/base/form_words.h"
#include "app/gui/base/study_table.h"
#include "app/gui/editor/editor_sides.h"
#include "app/gui/editor/live_examination.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/editor/question_bar.h"
#include "app/gui/look/fitted_label.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"
#include "app/gui/participant/screen_preview.h"
#include "app/gui/precision/precision_view.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/study_protocols.h"
#include "app/tasks/warnings/session_warnings.h"
#include "app/words/phrase_of_error.h"
#include "protocols/file/protocol_problems.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

constexpr int kLineColumn = 0;  // of the list of problems
/// Of the name of the file, which the buttons next to it leave in a small window.
constexpr int kKeptNameWidth = 280;

QString how_many_problems(std::size_t count) {
  return count == 1 ? ProtocolEditorPage::tr("1 problem")
                    : ProtocolEditorPage::tr("%1 problems").arg(count);
}

/// The files that protocols name: reliefs, pictures, meshes and recordings, without their sidecars.
QStringList stimuli_of(const std::filesystem::path& study) {
  const std::string stimuli = "stimuli";
  QStringList files{};
  for (const QString& name : QDir(study / stimuli).entryList(QDir::Files, QDir::Name)) {
    if (!name.endsWith(".json")) files.append(text(stimuli) + '/' + name);
  }
  return files;
}

}  // namespace

ProtocolEditorPage::ProtocolEditorPage(OpenStudy& study, QWidget* parent)
    : StudyPage(study, tr("Protocol"), parent) {
  setObjectName("editor_page");
  make_head();
  views_ = new ProtocolViews(declarations_of(study.models()), this);
  views_->offer_files([folder = study.folder()] { return stimuli_of(folder); });
  edit_ = &views_->text();
  // One after the other: the focus takes the order in which widgets are made.
  QWidget* const edit_side = make_edit_side();
  QWidget* const plan_side = make_plan_side();
  body().addWidget(new EditorSides(edit_side, plan_side, this), 1);
  // Below what is edited, which stays in its place when a question or news appears.
  question_ = new QuestionBar(this);
  body().addWidget(question_);
  layout()->addWidget(&banner());
  auto* empty = new EmptyState(tr("No protocol open"),
                               tr("Choose one of the study's protocols and press “Edit”."), this);
  empty->add_action(tr("Show the protocols"), ButtonRole::primary, [this] { emit back_wanted(); });
  set_empty_state(empty);
  show_empty(true);

  watcher_ = new QFileSystemWatcher(this);
  connect(watcher_, &QFileSystemWatcher::fileChanged, this, &ProtocolEditorPage::look_at_disk);
  connect(watcher_, &QFileSystemWatcher::directoryChanged, this, &ProtocolEditorPage::look_at_disk);
  check_ = new LiveCheck(
      [this] { return as_it_is_ ? on_disk_ : content(); },
      [&models = study.models(), folder = study.folder(),
       kept = std::make_shared<KeptHeightFields>()](const std::string& written) {
        ProtocolCheck check =
            check_protocol_text(written, {}, models, folder, std::nullopt, kept.get());
        if (!check.protocol) return check;
        if (check.is_valid()) kept->forget_unused();  // all files that it names have been looked up
        append(check.warnings, warnings_about_sessions({*check.protocol, {}}, folder, models));
        sort_by_line(check.warnings);
        return check;
      },
      this);
  examination_ = new LiveExamination(study.examiner(), this);
  connect(check_, &LiveCheck::checked, this, &ProtocolEditorPage::take_checked);
  connect(examination_, &LiveExamination::changed, this, &ProtocolEditorPage::show_checked);
  connect(check_, &LiveCheck::failed, this, &ProtocolEditorPage::show_not_known);
  connect(edit_, &QPlainTextEdit::textChanged, this, [this] {
    if (!until_edit_.isEmpty() && banner().text() == until_edit_) banner().hide();
    until_edit_.clear();
    saved_news_.reset();
    examination_->abandon();
    precision_->hold_for_new_text();
    check_->want();
    show_checking();
  });
  const auto follow_hold = [this] {
    check_->set_held(this->study().examiner().is_held());
    if (!check_->is_settled()) show_checking();
  };
  connect(&study.examiner(), &StimulusExaminer::held_changed, this, follow_hold);
  follow_hold();
  connect(views_, &ProtocolViews::refused, this, [this](const QString& why) {
    banner().show_news(State::look, why);
    until_edit_ = banner().text();
  });
  connect(edit_, &QPlainTextEdit::modificationChanged, this,
          &ProtocolEditorPage::show_whether_saved);
  const auto add_key = [this](QKeySequence::StandardKey key, auto act) {
    auto* shortcut = new QShortcut(QKeySequence(key), this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, act);
  };
  add_key(QKeySequence::Save, [this] { save_->click(); });
  add_key(QKeySequence::Find, [this] { views_->find(); });
}

void ProtocolEditorPage::make_head() {
  name_ = new FittedLabel(this);
  name_->setObjectName("editor_name");
  name_->setFont(text_font(TextSize::title, true));
  name_->set_smaller_font(text_font(TextSize::body, true));
  name_->set_elide(Qt::ElideMiddle);
  name_->keep_width(kKeptNameWidth);
  title().hide();
  note_ = new FittedLabel(this);
  note_->setObjectName("editor_note");
  note_->setForegroundRole(QPalette::PlaceholderText);
  QPushButton* methods = make_button(tr("Methods"), ButtonRole::plain, this);
  methods->setObjectName("editor_methods");
  methods->setToolTip(tr("Which method answers which question, and its library protocol"));
  QPushButton* find = make_button(tr("Find"), ButtonRole::plain, this);
  find->setObjectName("editor_find");
  save_ = make_button(tr("Save"), ButtonRole::primary, this);
  save_->setObjectName("editor_save");
  QPushButton* back = make_button(tr("← All protocols"), ButtonRole::link, this);
  back->setObjectName("editor_back");
  head().insertWidget(0, name_, 1);
  // In two lines where the name needs the room.
  auto* buttons = new WrappingRow(nullptr, kGrid);
  for (QWidget* const widget : std::initializer_list<QWidget*>{note_, methods, find, save_, back}) {
    buttons->addWidget(widget);
  }
  head().addLayout(buttons);
  connect(find, &QPushButton::clicked, this, [this] { views_->find(); });
  connect(methods, &QPushButton::clicked, this,
          [this] { (new DocumentDialog("methods.md", this))->show(); });
  connect(save_, &QPushButton::clicked, this, [this] { save(Agreed::nothing); });
  connect(back, &QPushButton::clicked, this, [this] {
    if (may_leave([this] { emit back_wanted(); })) emit back_wanted();
  });
}

QWidget* ProtocolEditorPage::make_edit_side() {
  QSplitter* side = make_splitter(Qt::Vertical, this);
  side->addWidget(views_);
  auto* below = new QWidget(side);
  auto* layout = new QVBoxLayout(below);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  state_ = new StateLabel(below);
  state_->setObjectName("editor_state");
  problems_ = new StudyTable({{tr("Line"), 72, StudyTable::Align::number},
                              {tr("Problem"), 0, StudyTable::Align::text},
                              {tr("Place"), 160, StudyTable::Align::text}},
                             below);
  problems_->setObjectName("editor_problems");
  problems_->setAccessibleName(tr("Problems"));
  problems_->setFont(text_font(TextSize::small));
  problems_->horizontalHeader()->setFont(text_font(TextSize::small));
  problems_->wrap_texts();
  problems_->horizontalHeader()->setSortIndicatorShown(false);
  layout->addWidget(state_);
  layout->addWidget(problems_, 1);
  side->addWidget(below);
  side->setStretchFactor(0, 3);
  side->setStretchFactor(1, 1);
  side->setSizes({480, 168});
  connect(problems_, &QTableView::clicked, this,
          [this] { go_to_problem(problems_->selected_key()); });
  connect(problems_, &StudyTable::row_opened, this, &ProtocolEditorPage::go_to_problem);
  connect(views_, &ProtocolViews::view_changed, this, &ProtocolEditorPage::list_problems);
  return side;
}

QWidget* ProtocolEditorPage::make_plan_side() {
  QVBoxLayout* layout = nullptr;
  QFrame* card = make_card(this, layout);
  auto* tabs = new QHBoxLayout();
  tabs->setSpacing(0);
  sides_ = new QButtonGroup(card);
  const auto add_tab = [&](const QString& name, const char* object) {
    QPushButton* tab = make_button(name, ButtonRole::selector, card);
    tab->setObjectName(object);
    sides_->addButton(tab, static_cast<int>(sides_->buttons().size()));
    tabs->addWidget(tab);
    return tab;
  };
  QPushButton* plan = add_tab(tr("Plan"), "editor_show_plan");
  QPushButton* screen = add_tab(tr("Screen"), "editor_show_screen");
  QPushButton* precision = add_tab(tr("Precision"), "editor_show_precision");
  plan->setChecked(true);
  tabs->addStretch();
  layout->addLayout(tabs);
  plan_side_ = new QStackedWidget(card);
  plan_side_->setObjectName("editor_plan_side");
  plan_ = new PlanPreview(PlanPreview::Shape::tall, plan_side_);
  screen_ = new ScreenPreview(study().folder(), plan_side_);
  screen_->add_group_choice(plan_->make_group_choice(screen_));
  precision_ = new PrecisionView(study(), plan_side_);
  why_no_plan_ = make_text({}, plan_side_, true);
  why_no_plan_->setObjectName("editor_why_no_plan");
  why_no_plan_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  for (QWidget* const side :
       std::initializer_list<QWidget*>{plan_, screen_, precision_, why_no_plan_}) {
    plan_side_->addWidget(side);
  }
  chosen_side_ = plan_;
  plan_side_->setCurrentWidget(why_no_plan_);
  layout->addWidget(plan_side_, 1);
  connect(plan, &QPushButton::clicked, this, [this] { choose_side(plan_); });
  connect(screen, &QPushButton::clicked, this, [this] { choose_side(screen_); });
  connect(precision, &QPushButton::clicked, this, [this] { choose_side(precision_); });
  connect(plan_, &PlanPreview::step_shown, this,
          [this](const std::shared_ptr<const Protocol>& protocol,
                 const std::shared_ptr<const Plan>& made,
                 int step) { screen_->show_step(protocol, made, static_cast<std::size_t>(step)); });
  connect(screen_, &ScreenPreview::step_wanted, plan_, &PlanPreview::select_step);
  return card;
}

void ProtocolEditorPage::choose_side(QWidget* side) {
  chosen_side_ = side;
  if (plan_side_->currentWidget() != why_no_plan_) plan_side_->setCurrentWidget(side);
}

void ProtocolEditorPage::open(const std::filesystem::path& protocol) {
  if (protocol == file_) {
    look_at_disk();
    views_->give_focus();
    return;
  }
  if (!may_leave([this, protocol] { open(protocol); })) return;
  std::string bytes{};
  try {
    bytes = read_file(protocol, kProtocolFile);
  } catch (const std::exception& error) {
    banner().show_news(State::stop,
                       tr("The protocol could not be read: %1").arg(words_of(phrase_of(error))));
    return;
  }
  banner().hide();
  question_->hide();
  show_name(protocol);
  result_.reset();  // the problems and the plan are those of another file
  found_problems_.clear();
  found_warnings_.clear();
  views_->show_problems({}, {});
  list_problems();
  plan_->forget();
  screen_->forget();
  show_content(bytes);
  views_->show_form_if_possible();
  watch_file();
  views_->give_focus();
}

void ProtocolEditorPage::show_name(const std::filesystem::path& file) {
  file_ = file;
  name_->show_text(text(file.filename().string()));
  show_empty(false);
  plan_side_->setCurrentWidget(why_no_plan_);  // of this file it is not known yet
}

void ProtocolEditorPage::open_changed(const std::filesystem::path& protocol,
                                      const std::string& before, const std::string& after,
                                      const QString& news) {
  if (protocol != file_ && !may_leave([this, protocol, before, after, news] {
        open_changed(protocol, before, after, news);
      })) {
    return;
  }
  open(protocol);
  if (protocol != file_) return;  // the banner states why
  views_->commit();
  if (as_it_is_) {
    show_why_read_only();
    return;
  }
  if (content() != before) {
    banner().show_news(State::look, tr("The protocol has changed meanwhile and was left as it is. "
                                       "Choose the rendering again."));
    return;
  }
  QString shown = text(after);
  if (dos_lines_) shown.replace("\r\n", "\n");
  edit_->replace_text(shown);
  banner().show_news(State::fine, news);
}

bool ProtocolEditorPage::commit() { return views_->commit(); }

ProtocolEditorPage::Shown ProtocolEditorPage::hand_over() {
  Shown shown{.file = std::exchange(file_, {}),
              .on_disk = on_disk_,
              .dos_lines = dos_lines_,
              .byte_order_mark = byte_order_mark_,
              .as_it_is = as_it_is_,
              .views = views_->shown(),
              .side = sides_->checkedId(),
              .plan = plan_->choice()};
  shown.text = edit_->take_document();
  return shown;
}

void ProtocolEditorPage::resume(Shown shown) {
  on_disk_ = std::move(shown.on_disk);
  dos_lines_ = shown.dos_lines;
  byte_order_mark_ = shown.byte_order_mark;
  as_it_is_ = shown.as_it_is;
  show_name(shown.file);
  edit_->set_document(std::move(shown.text));
  views_->set_read_only(as_it_is_);
  if (as_it_is_) show_why_read_only();
  show_whether_saved();
  plan_->resume(shown.plan);
  sides_->button(shown.side)->click();
  views_->resume(shown.views);
  watch_file();
  look_at_disk();
}

bool ProtocolEditorPage::has_unsaved_changes() const {
  return !file_.empty() && edit_->document()->isModified();
}

std::string ProtocolEditorPage::content() const {
  QString written = edit_->text();
  if (dos_lines_) written.replace('\n', "\r\n");
  return written.toStdString();
}

bool ProtocolEditorPage::gives_back(const std::string& bytes) const {
  return (byte_order_mark_ ? std::string(kByteOrderMark) : std::string()) + content() == bytes;
}

/// What the field is to hold for these bytes; remembers how to get back from it.
QString ProtocolEditorPage::decoded(const std::string& bytes) {
  byte_order_mark_ = bytes.starts_with(kByteOrderMark);
  QString shown = QString::fromUtf8(bytes.data(), static_cast<qsizetype>(bytes.size()));
  dos_lines_ = shown.contains("\r\n") && shown.count('\n') == shown.count("\r\n");
  if (dos_lines_) shown.replace("\r\n", "\n");
  return shown;
}

void ProtocolEditorPage::show_content(const std::string& bytes) {
  as_it_is_ = false;
  views_->forget();
  edit_->setPlainText(decoded(bytes));  // forgets the undo of another file
  on_disk_ = bytes;
  as_it_is_ = !gives_back(bytes);
  views_->set_read_only(as_it_is_);
  // Saving is of use then: it leaves the mark out, which no protocol may have.
  edit_->document()->setModified(byte_order_mark_ && !as_it_is_);
  if (as_it_is_) {
    show_why_read_only();
  }
  show_whether_saved();
  check_->want();
}

void ProtocolEditorPage::show_why_read_only() {
  banner().show_news(
      State::look,
      tr("This file cannot be edited here without loss: it is not UTF-8, or its line endings are "
         "mixed. Save it as UTF-8 with uniform line endings in another program."));
}

/// The same in place of what is in the field, which stays a step of the undo.
void ProtocolEditorPage::take_content(const std::string& bytes) {
  const QString shown = decoded(bytes);
  views_->set_read_only(false);
  edit_->replace_text(shown);
  if (!gives_back(bytes)) {
    show_content(bytes);
    return;
  }
  on_disk_ = bytes;
  as_it_is_ = false;
  edit_->document()->setModified(byte_order_mark_);
  show_whether_saved();
  check_->want();
}

void ProtocolEditorPage::show_whether_saved() {
  const bool changed = has_unsaved_changes();
  const bool saving = save_task_.is_running();
  const bool can_write = study().can_be_written();
  setProperty("keep", saving ? tr("The protocol is being saved.") : QString());
  save_->setEnabled(changed && !saving && !as_it_is_ && can_write);
  note_->show_text(!can_write  ? tr("This study is read-only")
                   : as_it_is_ ? tr("Cannot be edited here")
                   : saving    ? tr("Saving…")
                   : changed   ? tr("● Unsaved changes")
                               : tr("No unsaved changes"));
}

// What the text is checked against may have changed meanwhile: the files and the sessions of the study.
void ProtocolEditorPage::showEvent(QShowEvent* event) {
  StudyPage::showEvent(event);
  if (!file_.empty()) check_->want();
}

void ProtocolEditorPage::hideEvent(QHideEvent* event) {
  examination_->abandon();
  StudyPage::hideEvent(event);
}

void ProtocolEditorPage::take_checked(const LiveCheck::Result& result) {
  result_ = result;
  examination_->abandon();
  if (result->is_valid()) {
    const std::shared_ptr<const Protocol> protocol{result, &*result->protocol};
    plan_->show_protocol(*protocol);
    precision_->show_protocol(file_, protocol);
    if (isVisible()) examination_->want(protocol);
  }
  show_checked();
}

void ProtocolEditorPage::show_checking() {
  show_not_known(study().examiner().is_held()
                     ? tr("The text is checked when the device is free again.")
                     : tr("checking…"));
}

void ProtocolEditorPage::show_not_known(const QString& why) {
  state_->set_state(State::unknown, why);
  if (result_ == nullptr) why_no_plan_->setText(why);
}

void ProtocolEditorPage::show_checked() {
  ProtocolCheck shown = *result_;
  if (examination_->result() != nullptr) add_examination(shown, *examination_->result());
  found_problems_ = shown.diagnostics;
  // Of a text with problems, what it may not mean is not known.
  found_warnings_ = found_problems_.empty() ? shown.warnings : std::vector<Diagnostic>{};
  views_->show_problems(found_problems_, found_warnings_);
  const std::size_t warnings = found_warnings_.size();
  if (found_problems_.empty()) {
    QString words = warnings == 0   ? tr("valid")
                    : warnings == 1 ? tr("valid, 1 warning")
                                    : tr("valid, %1 warnings").arg(warnings);
    if (examination_->is_under_way()) {
      words = (study().examiner().is_held()
                   ? tr("%1 (the stimuli are examined when the device is free again)")
                   : tr("%1 (the stimuli are being examined…)"))
                  .arg(words);
    }
    state_->set_state(warnings == 0 ? State::fine : State::look, words);
  } else {
    state_->set_state(State::stop, how_many_problems(found_problems_.size()));
  }
  list_problems();
  plan_side_->setCurrentWidget(shown.is_valid() ? chosen_side_ : why_no_plan_);
  show_problems_of_saved();
}

/// Saving accepts every text: without this, a file with problems would be taken for one that can be used.
void ProtocolEditorPage::show_problems_of_saved() {
  if (!saved_news_ || !check_->is_settled() || result_ == nullptr) return;
  if (found_problems_.empty()) {
    if (!examination_->is_under_way()) saved_news_.reset();
    return;
  }
  banner().show_news(State::look,
                     (*saved_news_ + ' ' +
                      tr("The file is saved, but no session can be run with it: it has %1.")
                          .arg(how_many_problems(found_problems_.size())))
                         .trimmed());
  until_edit_ = banner().text();
  saved_news_.reset();
}

/// In the words of the view: the form has no lines.
void ProtocolEditorPage::list_problems() {
  const bool is_form = views_->view() == ProtocolViews::View::form;
  problems_->setColumnHidden(kLineColumn, is_form);
  std::vector<StudyTable::Row> rows{};
  const auto protocol = nlohmann::json::parse(edit_->text().toStdString(), nullptr, false);
  const auto add = [&](const Diagnostic& remark, const QString& form) {
    rows.push_back({QString::number(rows.size()),
                    {number_cell(remark.line), text_cell(form.arg(views_->sentence_of(remark))),
                     text_cell(place_in_form(protocol, remark.pointer))}});
  };
  for (const Diagnostic& problem : found_problems_) add(problem, "%1");
  for (const Diagnostic& warning : found_warnings_) add(warning, tr("Warning: %1"));
  problems_->fill(rows);
  if (found_problems_.empty()) return;
  const Diagnostic& first = found_problems_.front();
  const QString place = place_in_form(protocol, first.pointer);
  const QString number = how_many_problems(found_problems_.size());
  why_no_plan_->setText(
      is_form && !place.isEmpty()
          ? tr("The plan appears here once the protocol is valid. At present it has %1; the first "
               "is at %2.")
                .arg(number, place)
          : tr("The plan appears here once the text is valid. At present it has %1; the first is "
               "on line %2.")
                .arg(number)
                .arg(first.line));
}

void ProtocolEditorPage::go_to_problem(const QString& key) {
  if (!key.isEmpty()) views_->go_to_problem(key.toUInt());
}

}  // namespace asperity

#include "moc_protocol_editor_page.cpp"
