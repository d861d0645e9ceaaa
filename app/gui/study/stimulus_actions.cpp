// Looks for the uses of a stimulus in the background, and asks in place.

#include "app/gui/study/stimulus_actions.h"

#include <initializer_list>
#include <utility>

#include <QtGui/QKeyEvent>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "app/gui/base/command_lines.h"
#include "app/gui/base/open_study.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"

namespace asperity {

namespace {

constexpr int kNewStemWidth = 280;

QString file_name(const std::string& path) { return text(path).section('/', -1); }

QString names_of(const std::vector<std::filesystem::path>& files) {
  QStringList names{};
  for (const std::filesystem::path& file : files) names << path_text(file.filename());
  return names.join(", ");
}

QString names_of(const std::vector<std::string>& paths) {
  QStringList names{};
  for (const std::string& path : paths) names << file_name(path);
  return names.join(", ");
}

}  // namespace

template <class Found>
void StimulusActions::find(Found (*look)(const Study&, const std::string&),
                           void (StimulusActions::*then)(const Found&)) {
  hide_question();
  task_.run<Found>(
      [look, path = path_, folder = study_.folder()](const std::stop_token&,
                                                     const BackgroundTask::Progress&) {
        return look(Study::open(folder, Access::read_only), path);
      },
      [this, then, path = path_](const Found& found) {
        if (path == path_) (this->*then)(found);
      },
      [this](const QString& what) { emit refused(what); });
}

StimulusActions::StimulusActions(OpenStudy& study, QWidget* parent)
    : QFrame(parent), study_(study) {
  setObjectName("stimulus_actions");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  auto* buttons = new WrappingRow(nullptr, kGrid);
  const auto add = [this, buttons](const QString& verb, const char* name) {
    QPushButton* button = make_button(verb, ButtonRole::plain, this);
    button->setObjectName(name);
    buttons->addWidget(button);
    return button;
  };
  open_ = add(tr("Open in the workbench"), "stimulus_open");
  use_ = add(tr("Use in an experiment…"), "stimulus_use");
  rename_ = add(tr("Rename…"), "stimulus_rename");
  delete_ = add(tr("Delete…"), "stimulus_delete");
  layout->addLayout(buttons);
  reason_ = make_text({}, this, true);
  reason_->setObjectName("stimulus_reason");
  layout->addWidget(reason_);

  question_ = new QWidget(this);
  auto* rows = new QVBoxLayout(question_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(kGrid);
  text_ = make_text({}, question_);
  text_->setObjectName("stimulus_question");
  name_ = new QLineEdit(question_);
  name_->setObjectName("stimulus_name");
  name_->setAccessibleName(tr("Name"));
  name_->setFixedWidth(kNewStemWidth);
  act_ = make_button({}, ButtonRole::plain, question_);
  act_->setObjectName("stimulus_act");
  cancel_ = make_button(tr("Cancel"), ButtonRole::link, question_);
  cancel_->setObjectName("stimulus_cancel");
  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  row->addWidget(name_);
  row->addWidget(act_);
  row->addWidget(cancel_);
  row->addWidget(make_commands_button([this] { return commands(); }, question_));
  row->addStretch();
  rows->addWidget(text_);
  rows->addLayout(row);
  layout->addWidget(question_);
  hide_question();
  connect(open_, &QPushButton::clicked, this,
          [this] { emit open_wanted(path_text(study_.folder() / path_)); });
  connect(use_, &QPushButton::clicked, this,
          [this] { emit use_wanted({path_text(study_.folder() / path_)}); });
  connect(rename_, &QPushButton::clicked, this,
          [this] { find(&plan_of_renaming, &StimulusActions::ask_for_name); });
  connect(delete_, &QPushButton::clicked, this,
          [this] { find(&uses_of_stimulus, &StimulusActions::ask_whether_to_delete); });
  connect(act_, &QPushButton::clicked, this, &StimulusActions::act);
  connect(name_, &QLineEdit::returnPressed, this, &StimulusActions::act);
  connect(cancel_, &QPushButton::clicked, this, &StimulusActions::hide_question);
  set_stimulus(nullptr);
}

void StimulusActions::set_stimulus(const StimulusOverview* stimulus) {
  using Kind = StimulusOverview::Kind;
  const bool is_file = stimulus != nullptr && stimulus->kind != Kind::shape;
  const std::string path = is_file ? stimulus->path : std::string();
  if (path != path_) hide_question();
  path_ = path;
  is_rendering_ = is_file && stimulus->kind == Kind::rendering;
  const bool is_usable = is_file && stimulus->problem.empty() && stimulus->remarks.problems.empty();
  const bool is_shown = is_file && (stimulus->kind == Kind::picture ||
                                    stimulus->kind == Kind::height_field || is_rendering_);
  open_->setEnabled(is_usable && is_shown);
  use_->setVisible(is_rendering_);
  use_->setEnabled(is_usable && study_.can_be_written());
  set_writing(is_writing_);
  QString reason{};
  if (stimulus == nullptr) {
    reason = tr("Choose a stimulus to open, rename or delete it.");
  } else if (!is_file) {
    reason = tr("This body is part of a protocol: change it there.");
  } else if (!study_.can_be_written()) {
    reason = tr("This study is read-only; copy it to a folder that you may write to.");
  } else if (!is_shown) {
    reason = tr("The workbench opens pictures, height fields and renderings.");
  }
  reason_->setText(reason);
  reason_->setVisible(!reason.isEmpty());
}

void StimulusActions::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && question_->isVisible()) {
    if (!is_writing_) hide_question();
    return;
  }
  QFrame::keyPressEvent(event);
}

void StimulusActions::ask_for_name(const RenamePlan& plan) {
  if (plan.complaint) {
    emit refused(words_of(*plan.complaint));
    return;
  }
  QStringList sentences{tr("New name of %1 (without its ending).").arg(file_name(path_))};
  std::vector<std::string> others = plan.files;
  std::erase(others, path_);
  if (!others.empty()) sentences << tr("Renamed with it: %1.").arg(names_of(others));
  sentences << (plan.changed.empty()
                    ? tr("No reference is changed.")
                    : tr("The references are changed in: %1.").arg(names_of(plan.changed)));
  if (!plan.unchanged.empty()) {
    sentences
        << tr("Protocols with sessions keep the present name: %1.").arg(names_of(plan.unchanged));
  }
  if (!plan.reliefs.empty()) {
    sentences << tr("It is the photograph of %1, which has none under another name.")
                     .arg(names_of(plan.reliefs));
  }
  ask(sentences.join(' '), tr("Rename"), true);
  name_->setText(is_rendering_ ? text(rendering_name(path_))
                               : path_text(std::filesystem::path(path_).stem()));
  name_->selectAll();
  name_->setFocus();
}

void StimulusActions::ask_whether_to_delete(const StimulusUses& uses) {
  if (const auto complaint = complaint_about_deletion(uses, path_)) {
    emit refused(words_of(*complaint));
    return;
  }
  const QString files = names_of(files_of_stimulus(study_.folder(), path_));
  QString question = tr("Delete %1? Nothing refers to it. The files cannot be restored.");
  if (is_rendering_) {
    question = tr("Delete %1? Protocols with its values keep them. The file cannot be restored.");
  } else if (!uses.reliefs.empty()) {
    question = tr("Delete %1? It is the photograph of %2. The file cannot be restored.");
  }
  question = question.arg(files);
  ask(uses.reliefs.empty() ? question : question.arg(names_of(uses.reliefs)), tr("Delete"), false);
  cancel_->setFocus();  // Return deletes nothing
}

void StimulusActions::ask(const QString& text, const QString& verb, bool for_name) {
  for_name_ = for_name;
  text_->setText(text);
  act_->setText(verb);
  name_->setVisible(for_name);
  question_->show();
  emit asked();
}

void StimulusActions::hide_question() { question_->hide(); }

void StimulusActions::set_writing(bool is_writing) {
  is_writing_ = is_writing;
  for (QPushButton* const button : {rename_, delete_}) {
    button->setEnabled(!path_.empty() && study_.can_be_written() && !is_writing);
  }
  for (QWidget* const part : std::initializer_list<QWidget*>{name_, act_, cancel_}) {
    part->setEnabled(!is_writing);
  }
}

std::vector<ShownCommand> StimulusActions::commands() const {
  const std::filesystem::path file = study_.folder() / path_;
  return {{.action = act_->text(),
           .line = for_name_ ? rename_stimulus_line(file, name_->text().trimmed().toStdString())
                             : delete_stimulus_line(file)}};
}

void StimulusActions::act() {
  if (is_writing_) return;
  set_writing(true);
  task_.run<std::string>(
      [path = path_, folder = study_.folder(), for_name = for_name_,
       name = name_->text().trimmed().toStdString()](
          const std::stop_token&, const BackgroundTask::Progress&) -> std::string {
        const Study own = Study::open(folder, Access::read_only);
        if (for_name) return rename_stimulus(own, path, name);
        delete_stimulus(own, path);
        return {};
      },
      [this](const std::string& path) {
        set_writing(false);
        hide_question();
        emit changed(text(path));
      },
      [this](const QString& what) {
        set_writing(false);
        if (question_->isVisible() && for_name_) name_->setFocus();
        emit refused(what);
      });
}

}  // namespace asperity

#include "moc_stimulus_actions.cpp"
