// Asks in place, and renames or deletes a file only if no session has run its protocol.

#include "app/gui/study/protocol_file_actions.h"

#include <utility>

#include <QtGui/QKeyEvent>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPushButton>

#include "app/gui/base/open_study.h"
#include "app/gui/look/controls.h"
#include "app/study_files/study_protocols.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

constexpr int kNewNameWidth = 280;

QString file_name_of(const std::filesystem::path& file) {
  return QString::fromStdString(file.filename().string());
}

}  // namespace

ProtocolFileActions::ProtocolFileActions(OpenStudy& study, QWidget* parent)
    : QFrame(parent), study_(study) {
  setObjectName("protocol_file_question");
  more_ = make_button(tr("More"), ButtonRole::plain, parent);
  more_->setObjectName("protocol_more");
  auto* menu = new QMenu(more_);
  const auto add = [this, menu](const QString& verb, const char* name, auto action) {
    QAction* entry = menu->addAction(verb, this, action);
    entry->setObjectName(name);
    entry->setEnabled(study_.can_be_written());
  };
  add(tr("Duplicate"), "protocol_duplicate", &ProtocolFileActions::duplicate);
  add(tr("Rename…"), "protocol_rename", [this] { unless_run([this] { ask_for_name(); }); });
  add(tr("Delete…"), "protocol_delete",
      [this] { unless_run([this] { ask_whether_to_delete(); }); });
  more_->setMenu(menu);

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGrid);
  text_ = make_text({}, this);
  text_->setObjectName("protocol_file_text");
  name_ = new QLineEdit(this);
  name_->setObjectName("protocol_file_name");
  name_->setAccessibleName(tr("Name"));
  name_->setFixedWidth(kNewNameWidth);
  act_ = make_button({}, ButtonRole::plain, this);
  act_->setObjectName("protocol_file_act");
  cancel_ = make_button(tr("Cancel"), ButtonRole::link, this);
  cancel_->setObjectName("protocol_file_cancel");
  row->addWidget(text_, 1);
  row->addWidget(name_);
  row->addWidget(act_);
  row->addWidget(cancel_);
  connect(act_, &QPushButton::clicked, this, &ProtocolFileActions::act);
  connect(name_, &QLineEdit::returnPressed, this, &ProtocolFileActions::act);
  connect(cancel_, &QPushButton::clicked, this, &QWidget::hide);
  hide();
}

void ProtocolFileActions::set_file(const std::filesystem::path& file) {
  if (file == file_) return;
  file_ = file;
  hide();
}

void ProtocolFileActions::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    hide();
    return;
  }
  QFrame::keyPressEvent(event);
}

void ProtocolFileActions::unless_run(std::function<void()> then) {
  task_.run<int>(
      [file = file_, folder = study_.folder()](const std::stop_token&,
                                               const BackgroundTask::Progress&) {
        return sessions_of_protocol(Study::open(folder, Access::read_only), file);
      },
      [this, then = std::move(then)](int sessions) {
        if (sessions == 0) return then();
        emit refused(
            tr("%1 has been run (%n sessions). Sessions refer to its name and its text: it "
               "can be neither renamed nor deleted. Duplicate it to create a further protocol from "
               "it.",
               nullptr, sessions)
                .arg(file_name_of(file_)));
      },
      [this](const QString& what) { emit refused(what); });
}

void ProtocolFileActions::duplicate() {
  task_.run<std::filesystem::path>(
      [file = file_, folder = study_.folder()](const std::stop_token&,
                                               const BackgroundTask::Progress&) {
        return duplicate_protocol(Study::open(folder, Access::read_only), file);
      },
      [this](const std::filesystem::path& copy) {
        emit changed(QString::fromStdString(copy.string()));
      },
      [this](const QString& what) {
        emit refused(tr("The protocol could not be duplicated: %1").arg(what));
      });
}

void ProtocolFileActions::ask_for_name() {
  ask(tr("New name of %1 (the file is renamed too):").arg(file_name_of(file_)), tr("Rename"), true);
  name_->setText(QString::fromStdString(file_.stem().string()));
  name_->selectAll();
  name_->setFocus();
}

void ProtocolFileActions::ask_whether_to_delete() {
  ask(tr("Delete %1? It was never run. The file cannot be restored.").arg(file_name_of(file_)),
      tr("Delete"), false);
  cancel_->setFocus();  // Return deletes nothing
}

void ProtocolFileActions::ask(const QString& text, const QString& verb, bool for_name) {
  for_name_ = for_name;
  text_->setText(text);
  act_->setText(verb);
  act_->setEnabled(true);
  name_->setVisible(for_name);
  show();
}

void ProtocolFileActions::act() {
  act_->setEnabled(false);
  task_.run<std::filesystem::path>(
      [file = file_, folder = study_.folder(), for_name = for_name_,
       name = name_->text().trimmed().toStdString()](
          const std::stop_token&, const BackgroundTask::Progress&) -> std::filesystem::path {
        const Study own = Study::open(folder, Access::read_only);
        if (for_name) return rename_protocol(own, file, name);
        delete_protocol(own, file);
        return {};
      },
      [this](const std::filesystem::path& file) {
        hide();
        emit changed(QString::fromStdString(file.string()));
      },
      [this](const QString& what) {
        act_->setEnabled(true);
        emit refused(what);
      });
}

}  // namespace asperity

#include "moc_protocol_file_actions.cpp"
