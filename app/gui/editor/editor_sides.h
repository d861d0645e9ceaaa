// The two sides of the editor: the protocol, and the plan with the participant's screen and the precision.

#pragma once

#include <QtWidgets/QWidget>

class QPushButton;
class QSplitter;

namespace asperity {

/// Next to each other where both have room, otherwise one of them at a time, chosen by a tab.
class EditorSides final : public QWidget {
  Q_OBJECT
 public:
  EditorSides(QWidget* protocol, QWidget* plan, QWidget* parent = nullptr);

  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();

  QSplitter* splitter_ = nullptr;
  QWidget* tabs_ = nullptr;
  QPushButton* to_protocol_ = nullptr;
  QPushButton* to_plan_ = nullptr;
};

}  // namespace asperity
