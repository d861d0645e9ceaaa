// Buttons in as many rows as their width requires.

#pragma once

#include <QtCore/QList>
#include <QtWidgets/QWidget>

class QPushButton;

namespace asperity {

/// Buttons next to each other, each in its full width; those that do not fit are in further rows. Hidden buttons take no
/// room.
class WrappedButtons final : public QWidget {
 public:
  explicit WrappedButtons(QWidget* parent = nullptr);

  /// Replaces and deletes the buttons before. `buttons` are children of this widget and are shown.
  void set_buttons(const QList<QPushButton*>& buttons);

  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place(int width);
  int place_within(int width, void (*put)(QPushButton&, const QRect&)) const;

  QList<QPushButton*> buttons_{};
};

}  // namespace asperity
