// Finding words in the view of a protocol below.

#pragma once

#include <string>

#include <QtCore/QPointer>
#include <QtWidgets/QWidget>

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace asperity {

class ProtocolForm;

/// Searches the text or the form, whichever is shown. Hidden until `begin`; Escape hides it and gives the focus to the field
/// that was found in the form, otherwise back.
class FindBar final : public QWidget {
  Q_OBJECT
 public:
  FindBar(QPlainTextEdit& text, ProtocolForm& form, QWidget* parent = nullptr);
  /// With what is selected in the text, if that is in one line.
  void begin();
  enum class Direction { forwards, backwards };
  /// Leads to the next match. A focus in the bar stays there; in the form the field gets that of another.
  void find(Direction direction);
  /// The view has changed, or what it shows.
  void refresh();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool is_in_form() const;
  void leave();
  void find_in_form(Direction direction);
  void find_from(int position, Direction direction);

  QPlainTextEdit& text_;
  ProtocolForm& form_;
  QLineEdit* words_ = nullptr;
  QLabel* count_ = nullptr;
  std::string found_{};            ///< the pointer of the last match in the form
  QPointer<QWidget> was_focus_{};  ///< before the search began
};

}  // namespace asperity
