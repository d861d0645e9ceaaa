// The frame in the experimenter's window that has the mirror of the participant's view.

#pragma once

#include <QtWidgets/QWidget>

class QVBoxLayout;

namespace asperity {

/// Before the participant's window is open, a sentence stands in the place of the mirror.
class MirrorFrame final : public QWidget {
  Q_OBJECT
 public:
  explicit MirrorFrame(QWidget* parent = nullptr);

  /// Replaces what is shown; the frame takes it over.
  void set_mirror(QWidget* mirror);

 private:
  QVBoxLayout* place_ = nullptr;
  QWidget* mirror_ = nullptr;
};

}  // namespace asperity
