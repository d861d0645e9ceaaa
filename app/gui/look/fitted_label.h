// A line of text that takes the room it is given.

#pragma once

#include <optional>

#include <QtGui/QFont>
#include <QtWidgets/QLabel>

#include "app/gui/look/controls.h"

namespace asperity {

/// One line, which widens no window: what does not fit is written in smaller letters, if there are any,
/// then cut where it is drawn, and the tool tip has the whole. `text()` is always the whole. Plain text.
class FittedLabel final : public QLabel {
  Q_OBJECT
 public:
  explicit FittedLabel(QWidget* parent = nullptr);

  /// Does nothing where it says so already.
  void show_text(const QString& text);
  /// With the shape of the state in its colour before the words; without words nothing.
  void show_state(State state, const QString& text);
  /// In these where the usual ones are too large.
  void set_smaller_font(const QFont& font);
  /// Where it is cut: at the end, unless another place is set.
  void set_elide(Qt::TextElideMode mode) { elide_ = mode; }
  /// It keeps the width that its text needs in the smaller letters, up to this; otherwise it can be narrowed to nothing.
  void keep_width(int most) { kept_ = most; }
  /// Whether something of it is cut now.
  bool is_cut() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QFont shown_font() const;
  int needed(const QFont& font) const;
  void write_tool_tip();

  std::optional<State> state_{};
  std::optional<QFont> smaller_{};
  Qt::TextElideMode elide_ = Qt::ElideRight;
  int kept_ = 0;
};

}  // namespace asperity
