// What can be done with a protocol's file from a window: duplicated, renamed, deleted.

#pragma once

#include <filesystem>
#include <functional>

#include <QtWidgets/QFrame>

#include "app/gui/look/background_task.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace asperity {

class OpenStudy;

/// The question that a renaming or a deletion asks, in place; hidden while there is none. A protocol that was
/// run is neither renamed nor deleted: the reason is shown before any question.
class ProtocolFileActions final : public QFrame {
  Q_OBJECT
 public:
  ProtocolFileActions(OpenStudy& study, QWidget* parent);

  /// "More", with a menu of the actions, to stand next to the other buttons of the protocol.
  QPushButton* button() noexcept { return more_; }
  /// What the actions act on. A question about another one is withdrawn.
  void set_file(const std::filesystem::path& file);

 signals:
  /// The files of the study are others now. `file`: to be selected; empty where there is none.
  void changed(const QString& file);
  /// It was not done, a sentence.
  void refused(const QString& why);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// Calls `then` where the protocol was never run, and shows the reason otherwise.
  void unless_run(std::function<void()> then);
  void duplicate();
  void ask_for_name();
  void ask_whether_to_delete();
  void ask(const QString& text, const QString& verb, bool for_name);
  void act();

  OpenStudy& study_;
  std::filesystem::path file_{};
  bool for_name_ = false;
  QPushButton* more_ = nullptr;
  QLabel* text_ = nullptr;
  QLineEdit* name_ = nullptr;
  QPushButton* act_ = nullptr;
  QPushButton* cancel_ = nullptr;
  BackgroundTask task_{};
};

}  // namespace asperity
