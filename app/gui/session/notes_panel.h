// Notes of the experimenter: a field, ready-made phrases, and what was noted when.

#pragma once

#include <vector>

#include <QtCore/QString>
#include <QtWidgets/QWidget>

#include "analysis/words/phrase.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace asperity {

/// While the keyboard belongs to the participant the field is locked; the phrases can be clicked all
/// the same, and never take the focus.
///
/// What stands in the field can be kept as a phrase of one's own: it stays for later sessions until
/// it is forgotten by its context menu, or is the oldest of more than `kOwn`.
class NotesPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit NotesPanel(QWidget* parent = nullptr);

  static constexpr int kOwn = 3;
  /// Why nothing can be typed now; empty: it can.
  void lock(const QString& why);
  bool is_locked() const;
  void focus_field();
  /// Of a session that is resumed, in the order of noting.
  void show_earlier(const std::vector<Phrase>& notes);
  /// With two rows of phrases: where there is more room, more are shown.
  QSize minimumSizeHint() const override;

 signals:
  void noted(const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  class PhraseGrid;
  int height_beside_phrases() const;
  void note(const QString& text);
  void show_phrases();
  QPushButton* make_phrase(const QString& phrase);
  void keep_phrase();
  void forget_phrase(const QString& phrase);

  QLabel* why_locked_ = nullptr;
  QLineEdit* field_ = nullptr;
  QPushButton* keep_ = nullptr;
  PhraseGrid* phrases_ = nullptr;
  QListWidget* list_ = nullptr;
};

}  // namespace asperity
