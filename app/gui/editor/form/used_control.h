// Declares what keeps the control in use in its place while sentences of a form appear and disappear.

#pragma once

#include <QtCore/QObject>
#include <QtCore/QPoint>
#include <QtCore/QPointer>
#include <QtWidgets/QWidget>

class QScrollArea;

namespace asperity {

/// What the user points to, or else the control with the focus. It stays in its place, and in sight, when sentences appear or
/// disappear above it, or news below the form takes of its height.
class UsedControl final : public QObject {
 public:
  /// `area` outlives it.
  explicit UsedControl(QScrollArea& area) : area_(area) {}

  /// A pointer that has not moved since then points to nothing: it is where the last click was.
  void rest_pointer();
  /// Notes the control and its place, until the layout has settled. `content`: that of the area, with the controls; null: none.
  void keep(const QWidget* content);
  /// Scrolls so that it is there again, unless the user has gone to another one.
  void put_back();

 private:
  QWidget* pointed(const QWidget& content) const;
  /// In the part of the page that is in sight, from its top.
  int place_of(const QWidget& control) const;

  QScrollArea& area_;
  QPoint resting_{};  ///< on the screen
  QPointer<QWidget> kept_{};
  QPointer<QWidget> focused_{};  ///< when it was kept
  int place_ = 0;
  bool is_in_sight_ = false;
};

/// Boxes that have got their width change their height, several times where cards are unfolded within cards.
void send_layouts();

}  // namespace asperity
