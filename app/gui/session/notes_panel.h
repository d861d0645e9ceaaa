// Notes of the experimenter: a field, ready-made phrases, and what was noted when.

#pragma once

#include <QtCore/QStringList>
#include <QtWidgets/QWidget>

class QGridLayout;
class QLabel;
class QLineEdit;
class QListWidget;

namespace asperity {

/// While the keyboard belongs to the participant the field is locked; the phrases can be clicked all
/// the same, and never take the focus.
class NotesPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit NotesPanel(QWidget* parent = nullptr);

  static QStringList usual_phrases();
  void set_phrases(const QStringList& phrases);
  /// Why nothing can be typed now; empty: it can.
  void lock(const QString& why);
  bool is_locked() const;
  void focus_field();

 signals:
  void noted(const QString& text);

 private:
  void note(const QString& text);

  QLabel* why_locked_ = nullptr;
  QLineEdit* field_ = nullptr;
  QGridLayout* phrases_ = nullptr;
  QListWidget* list_ = nullptr;
};

}  // namespace asperity
