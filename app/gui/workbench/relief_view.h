// The relief under the mouse: it turns, its light follows, it is stroked.

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QtCore/QTimer>
#include <QtGui/QImage>
#include <QtWidgets/QWidget>
#include <glm/vec2.hpp>

#include "app/gui/look/newest_work.h"
#include "app/gui/workbench/relief_picture.h"

namespace asperity {

enum class MouseMeans { turning, stroking };

/// A drag with the left button turns the relief or strokes it, one with the right button moves the
/// light, the wheel zooms. Arrow keys turn; with Shift they move the light; + and − zoom; Home
/// brings everything back.
///
/// Drawn by a worker: coarse while something moves, fine when it rests.
class ReliefView final : public QWidget {
  Q_OBJECT
 public:
  explicit ReliefView(QWidget* parent = nullptr);

  /// `coarse` is drawn while something moves. Keeps the look.
  void show_relief(std::shared_ptr<const ReliefMesh> fine,
                   std::shared_ptr<const ReliefMesh> coarse);
  void set_mouse(MouseMeans means);
  /// A line across the relief, and a point on it.
  void set_line(std::optional<double> y_m);
  void set_trail(std::vector<glm::dvec2> trail_m);
  /// The relief is drawn with the dent until the next call.
  void set_dent(std::optional<SurfaceDent> dent);

  const ReliefLook& look() const noexcept { return look_; }
  void set_look(const ReliefLook& look);
  bool is_settled() const noexcept { return !work_.is_busy() && !rest_.isActive(); }
  const QImage& picture() const noexcept { return picture_; }
  /// Where a point of the surface's plane is in this widget.
  QPointF position_of(const glm::dvec2& point_m) const;

  QSize sizeHint() const override { return {800, 500}; }
  QSize minimumSizeHint() const override { return {240, 120}; }

 signals:
  void pointed(double x_m, double y_m);  ///< the mouse is over this place
  void strokeBegan(double x_m, double y_m);
  void strokeMoved(double x_m, double y_m);
  void strokeEnded();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Quality { moving, resting };
  void draw(Quality quality);
  void move();  // something changed: coarse now, fine after a rest
  void turn(QPointF by);
  void move_light(QPointF by);
  ReliefProjection projection() const;
  double height_at(const glm::dvec2& point_m) const;

  std::shared_ptr<const ReliefMesh> fine_{};
  std::shared_ptr<const ReliefMesh> coarse_{};
  ReliefLook look_{};
  ReliefLook drawn_look_{};  // of picture_
  QImage picture_{};
  MouseMeans mouse_ = MouseMeans::turning;
  bool stroking_ = false;
  bool focused_by_key_ = false;  // only then is the focus worth a frame
  QPointF last_position_{};
  std::optional<double> line_y_m_{};
  std::vector<glm::dvec2> trail_m_{};
  std::optional<SurfaceDent> dent_{};
  QTimer rest_{};
  NewestWork work_{};
};

}  // namespace asperity
