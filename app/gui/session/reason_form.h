// Asks why: ready-made reasons for the mouse, and a field.

#pragma once

#include <functional>
#include <vector>

#include <QtWidgets/QFrame>

#include "analysis/words/phrase.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace asperity {

class WrappingRow;

/// A question in place with a reason for an answer. Nothing is done before there is one.
///
/// The ready-made reasons can be clicked while the keyboard belongs to the participant.
class ReasonForm final : public QFrame {
  Q_OBJECT
 public:
  explicit ReasonForm(QWidget* parent = nullptr);
  /// Shows itself. `verb` is what its button says; `on_reason` gets what was chosen or typed.
  void ask(const QString& question, const std::vector<Phrase>& ready_made, const QString& verb,
           std::function<void(Phrase)> on_reason);
  /// Why nothing can be typed now; empty: it can.
  void lock(const QString& why);
  void cancel();

 signals:
  void cancelled();

 private:
  void finish();

  QLabel* question_ = nullptr;
  WrappingRow* ready_made_ = nullptr;
  QLineEdit* field_ = nullptr;
  QLabel* why_locked_ = nullptr;
  QPushButton* act_ = nullptr;
  std::vector<Phrase> offered_{};
  std::function<void(Phrase)> on_reason_{};
};

}  // namespace asperity
