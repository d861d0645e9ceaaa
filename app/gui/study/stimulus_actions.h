// Declares what can be done with a stimulus of a study from a window: opened, used, renamed, deleted.

#pragma once

#include <string>
#include <vector>

#include <QtWidgets/QFrame>

#include "app/gui/base/commands_button.h"
#include "app/gui/look/background_task.h"
#include "app/tasks/stimulus_files.h"
#include "app/tasks/study_overview.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace asperity {

class OpenStudy;

/// Buttons, and the question that a renaming or a deletion asks in place, with its consequences. What is used is not
/// deleted, and what sessions refer to is neither renamed nor deleted: the reason is shown before any question.
class StimulusActions final : public QFrame {
  Q_OBJECT
 public:
  StimulusActions(OpenStudy& study, QWidget* parent);

  /// What the actions act on; null: nothing. A question about another one is withdrawn.
  void set_stimulus(const StimulusOverview* stimulus);

 signals:
  void open_wanted(const QString& file);
  void use_wanted(const QStringList& renderings);
  /// A question is shown: what was refused before is over.
  void asked();
  /// The files of the study have changed. `path`: of the renamed stimulus; empty after a deletion.
  void changed(const QString& path);
  /// Nothing was done. `why` is a sentence.
  void refused(const QString& why);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// Reads in the background; `then` gets the result unless another stimulus is chosen meanwhile.
  template <class Found>
  void find(Found (*look)(const Study&, const std::string&),
            void (StimulusActions::*then)(const Found&));
  void ask_for_name(const RenamePlan& plan);
  void ask_whether_to_delete(const StimulusUses& uses);
  void ask(const QString& text, const QString& verb, bool for_name);
  void hide_question();
  void act();
  std::vector<ShownCommand> commands() const;  ///< of the question
  /// Renames or deletes now: nothing else is begun.
  void set_writing(bool is_writing);

  OpenStudy& study_;
  std::string path_{};  ///< relative to the study; empty: nothing, or no file
  bool is_rendering_ = false;
  bool for_name_ = false;
  bool is_writing_ = false;
  QPushButton* open_ = nullptr;
  QPushButton* use_ = nullptr;
  QPushButton* rename_ = nullptr;
  QPushButton* delete_ = nullptr;
  QLabel* reason_ = nullptr;
  QWidget* question_ = nullptr;
  QLabel* text_ = nullptr;
  QLineEdit* name_ = nullptr;
  QPushButton* act_ = nullptr;
  QPushButton* cancel_ = nullptr;
  BackgroundTask task_{};
};

}  // namespace asperity
