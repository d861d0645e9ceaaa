// Saves the text of a protocol after a comparison with the file on disk, and asks where both have changed.

#include <utility>

#include <QtCore/QFileSystemWatcher>

#include "app/gui/editor/protocol_editor_page.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/editor/question_bar.h"
#include "app/gui/look/fitted_label.h"
#include "app/gui/look/words.h"
#include "app/study_files/study_protocols.h"
#include "app/tasks/warnings/session_warnings.h"
#include "results_schema/error_text.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

/// "1.2.3" → "1.2.4"; empty when it is no version.
QString raised(const QString& version) {
  QStringList numbers = version.split('.');
  bool is_number = false;
  const int last = numbers.back().toInt(&is_number);
  if (numbers.size() != 3 || !is_number) return {};
  numbers.back() = QString::number(last + 1);
  return numbers.join('.');
}

std::optional<std::string> content_on_disk(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  return read_file(file, kProtocolFile);
}

}  // namespace

/// What came of an attempt to save.
struct ProtocolEditorPage::Saving {
  std::string written{};
  std::filesystem::path file{};         ///< where it was written
  int revision = 0;                     ///< of the text that was written
  std::optional<std::string> theirs{};  ///< the text of another program: nothing was written
  std::optional<VersionUse> use{};  ///< the version stands for another text: nothing was written
  std::string not_looked_up{};      ///< why it is not known whether it does
};

bool ProtocolEditorPage::may_leave(std::function<void()> then) {
  views_->commit();
  if (!has_unsaved_changes()) return true;
  then_ = std::move(then);
  question_->ask(tr("%1 has unsaved changes.").arg(text(file_.filename().string())),
                 {{"editor_leave_save", tr("Save"), [this] { save(Agreed::nothing); }},
                  {"editor_leave_discard", tr("Discard the changes"),
                   [this] {
                     take_content(on_disk_);
                     edit_->document()->setModified(false);
                     leave();
                   }},
                  {"editor_leave_stay", tr("Keep editing"), [this] {
                     then_ = {};
                     views_->give_focus();
                   }}});
  return false;
}

/// What waited for the changes to be saved or discarded.
void ProtocolEditorPage::leave() {
  if (!then_) return;
  // Later: it may delete this page, whose button or task is at work just now.
  QMetaObject::invokeMethod(window(), std::exchange(then_, {}), Qt::QueuedConnection);
}

void ProtocolEditorPage::save(Agreed agreed) {
  if (file_.empty() || as_it_is_ || save_task_.is_running()) return;
  views_->commit();
  question_->hide();
  if (save_->hasFocus()) views_->return_focus();  // before it is disabled, which moves the focus on
  save_task_.run<Saving>(
      [file = file_, folder = study().folder(), written = content(), before = on_disk_, agreed,
       revision = edit_->document()->revision()](const std::stop_token&,
                                                 const BackgroundTask::Progress&) {
        Saving saving{};
        saving.written = written;
        saving.revision = revision;
        if (auto now = content_on_disk(file); now && *now != before && *now != written) {
          saving.theirs = std::move(now);
          return saving;
        }
        if (agreed == Agreed::nothing) {
          try {
            const Study own = Study::open(folder, Access::read_only);
            saving.use = other_text_of_version(own, written);
          } catch (const std::exception& error) {
            saving.not_looked_up = message_of(error);  // no reason to lose what was typed
          }
          if (saving.use) return saving;
        }
        saving.file = file_for_text(file, before, written);
        if (saving.file == file) {
          write_file(file, written, Overwrite::allow);
        } else {
          move_protocol(file, saving.file, written);
        }
        return saving;
      },
      [this](const Saving& saving) { end_saving(saving); },
      [this](const QString& what) {
        then_ = {};
        show_whether_saved();
        banner().show_news(State::stop, tr("The protocol could not be saved: %1").arg(what),
                           tr("Try again"), [this] { save(Agreed::nothing); });
      });
  show_whether_saved();
}

void ProtocolEditorPage::end_saving(const Saving& saving) {
  if (saving.theirs || saving.use) {
    show_whether_saved();
    if (saving.theirs) {
      ask_about_theirs(*saving.theirs, Then::save);
    } else {
      ask_about_version(*saving.use);
    }
    return;
  }
  on_disk_ = saving.written;
  byte_order_mark_ = false;
  if (edit_->document()->revision() == saving.revision) edit_->document()->setModified(false);
  show_whether_saved();
  banner().hide();
  saved_news_.emplace();
  if (saving.file != file_) {
    file_ = saving.file;
    name_->show_text(text(file_.filename().string()));
    banner().show_news(State::fine, tr("Saved as %1: the file is named after the protocol.")
                                        .arg(text(file_.filename().string())));
  }
  if (!saving.not_looked_up.empty()) {
    banner().show_news(State::look,
                       tr("Saved. If sessions were run with another text of this version, raise "
                          "the version; whether they were could not be determined: %1")
                           .arg(text(saving.not_looked_up)));
  }
  if (!banner().isHidden()) saved_news_ = banner().text();
  if (edit_->document()->revision() != saving.revision) saved_news_.reset();  // edited meanwhile
  show_problems_of_saved();
  watch_file();
  study().announce_change();
  emit saved(text(file_.string()));
  if (!has_unsaved_changes()) leave();
}

void ProtocolEditorPage::ask_about_theirs(const std::string& theirs, Then then) {
  question_->ask(tr("%1 has been changed outside the editor since it was opened here.")
                     .arg(text(file_.filename().string())),
                 {{"editor_take_theirs", tr("Use the other version"),
                   [this, theirs] {
                     take_content(theirs);
                     banner().show_news(
                         State::look,
                         tr("The text of the other program is shown. Undo restores yours."));
                     leave();
                   }},
                  {"editor_keep_mine",
                   then == Then::save ? tr("Keep my version and save") : tr("Keep my version"),
                   [this, theirs, then] {
                     on_disk_ = theirs;  // known now: no reason to ask again
                     views_->give_focus();
                     if (then == Then::save) save(Agreed::nothing);
                   }}});
}

void ProtocolEditorPage::ask_about_version(const VersionUse& use) {
  const QString version = text(use.version);
  const QString next = raised(version);
  std::vector<QuestionBar::Answer> answers{};
  if (!next.isEmpty()) {
    answers.push_back({"editor_raise_version", tr("Raise to %1 and save").arg(next), [this] {
                         raise_version();
                         save(Agreed::nothing);
                       }});
  }
  answers.push_back(
      {"editor_save_anyway", tr("Save under the same version"), [this] { save(Agreed::version); }});
  answers.push_back({"editor_do_not_save", tr("Do not save yet"), [this] {
                       then_ = {};
                       views_->give_focus();
                     }});
  if (use.of_people == 0) {
    question_->ask(
        tr("Sessions simulated with another text of version %1: %2. They would be analysed "
           "together with new ones; raise the version to keep the data apart.")
            .arg(version)
            .arg(use.sessions),
        answers);
    return;
  }
  question_->ask(use.of_people == 1 ? tr("One session was run with another text of version %1; "
                                         "raise the version to keep the data apart.")
                                          .arg(version)
                                    : tr("%1 sessions were run with another text of version %2; "
                                         "raise the version to keep the data apart.")
                                          .arg(use.of_people)
                                          .arg(version),
                 answers);
}

void ProtocolEditorPage::raise_version() {
  const QString written = edit_->text();
  const auto range = string_of_key(written, u"version");
  if (!range) return;
  const QString version = written.mid(range->start + 1, range->length - 2);
  edit_->replace(*range, '"' + raised(version) + '"');
}

// A new file in the place of the old one ends the watch on it.
void ProtocolEditorPage::watch_file() {
  const QStringList watched = watcher_->files() + watcher_->directories();
  if (!watched.isEmpty()) watcher_->removePaths(watched);
  watcher_->addPath(text(file_.parent_path().string()));
  if (std::filesystem::exists(file_)) watcher_->addPath(text(file_.string()));
}

void ProtocolEditorPage::look_at_disk() {
  if (file_.empty() || save_task_.is_running()) return;
  std::optional<std::string> now{};
  try {
    now = content_on_disk(file_);
  } catch (const std::exception&) {
    return;  // being written, or no protocol: there will be more news; and saving looks again
  }
  if (!now || *now == on_disk_) return;
  watch_file();
  if (*now == content()) {
    on_disk_ = *now;
    edit_->document()->setModified(false);
  } else if (has_unsaved_changes()) {
    ask_about_theirs(*now, Then::nothing);
  } else {
    take_content(*now);
    banner().show_news(State::look,
                       tr("The file has been changed outside the editor and its new text "
                          "is shown. Undo restores the previous text."));
  }
}

}  // namespace asperity
