// Puts a window where it belongs on the screen, with its frame.

#pragma once

#include <QtCore/QMargins>
#include <QtCore/QObject>
#include <QtCore/QRect>
#include <QtCore/QTimer>

class QWidget;

namespace asperity {

/// What draws a window's frame says how wide it is only some time after the window is shown. Until
/// then the window stands as if it had none; once it is known, the window is put right, and from then
/// on it is its user's.
class WindowPlace final : public QObject {
  Q_OBJECT
 public:
  /// Belongs to the window.
  explicit WindowPlace(QWidget& window);

  /// Its frame covers all of `place`, as far as the window's smallest size allows.
  void fill(const QRect& place);
  /// It stays as and where it is, as far as its frame finds room in `place`.
  void keep_within(const QRect& place);

 private:
  enum class Wish { fill, keep_within };
  void begin(const QRect& place, Wish wish);
  QMargins frame() const;
  void put();
  void look_again();

  QWidget& window_;
  QRect place_{};
  Wish wish_ = Wish::fill;
  QMargins known_{};
  int looks_left_ = 0;
  QTimer timer_{};
};

}  // namespace asperity
