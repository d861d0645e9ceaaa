// Work in the background as a line of a page: what is done, how far it is, and a button against it.

#pragma once

#include <QtCore/QString>
#include <QtCore/QTimer>
#include <QtWidgets/QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace asperity {

class BackgroundTask;

/// Seen once the task has run for a moment, until it has ended. The bar moves with what the task
/// tells, and to and fro while it tells nothing. Tab visits its button after what stands above it.
///
/// The names of its parts: "task_words", "task_progress", "task_cancel".
class TaskLine final : public QWidget {
  Q_OBJECT
 public:
  /// `task` outlives the line.
  explicit TaskLine(BackgroundTask& task, QWidget* parent = nullptr);

  /// What is being done, for the next time it is seen.
  void set_words(const QString& words);

 signals:
  /// Once for every run: what the task is to do about it is its owner's business.
  void cancelWanted();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void begin();

  BackgroundTask& task_;
  QLabel* words_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QTimer moment_{};
};

}  // namespace asperity
