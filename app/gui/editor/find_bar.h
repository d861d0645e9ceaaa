// Finding words in the text above.

#pragma once

#include <QtWidgets/QWidget>

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace asperity {

/// Hidden until `begin`; Escape hides it and gives the focus back to the text.
class FindBar final : public QWidget {
  Q_OBJECT
 public:
  explicit FindBar(QPlainTextEdit& text, QWidget* parent = nullptr);
  /// With what is selected in the text, if that is in one line.
  void begin();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Direction { forwards, backwards };
  void find(Direction direction);
  void find_from(int position, Direction direction);
  void say_how_many();

  QPlainTextEdit& text_;
  QLineEdit* words_ = nullptr;
  QLabel* count_ = nullptr;
};

}  // namespace asperity
