// The layout of a figure: the positions of its parts and of its numbers.

#pragma once

#include <vector>

#include <QtCore/QRectF>
#include <QtCore/QStringList>
#include <QtGui/QFont>

#include "app/figures/axis_ticks.h"
#include "app/figures/figure_look.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// Text broken into lines, and the size of these.
struct TextLines {
  QStringList lines{};
  double width = 0.0;
  double height = 0.0;
};

struct LaidTick {
  double at = 0.0;  ///< along its axis, in units of the painter
  TextLines label{};
};

/// A sample of a style with its name.
struct KeyItem {
  std::size_t series = 0;  ///< of the figure, the first with that name
  QPointF at{};            ///< the left end of the sample, at half its height
  QString name{};
};

/// Lays a figure out for a width, with the origin at the top left. All lengths are in units of the painter
/// and proportional to the font size: on a wider sheet a figure has more space, not larger letters.
class FigureLayout final {
 public:
  FigureLayout(const Figure& figure, double width, const FigureLook& look);

  double height() const noexcept { return height_; }
  /// The rectangle between the axes.
  const QRectF& plot() const noexcept { return plot_; }
  double x_of(double value) const;
  /// Numbers increase upwards, places downwards.
  double y_of(double value) const;
  /// Of a place of the vertical axis.
  double bottom_of_row(std::size_t row) const { return row_bottoms_[row]; }

  const std::vector<LaidTick>& x_ticks() const noexcept { return x_ticks_; }
  const std::vector<LaidTick>& y_ticks() const noexcept { return y_ticks_; }
  /// Of the far places of the vertical axis, to the right of the plot.
  const std::vector<LaidTick>& far_ticks() const noexcept { return far_ticks_; }
  const TextLines& x_name() const noexcept { return x_name_; }
  const TextLines& y_name() const noexcept { return y_name_; }
  bool has_upright_x_labels() const noexcept { return upright_x_labels_; }
  const std::vector<KeyItem>& key() const noexcept { return key_; }
  /// The scale of shades; empty without cells.
  const QRectF& shades() const noexcept { return shades_; }
  const TextLines& sentence() const noexcept { return sentence_; }

  double letters() const noexcept { return letters_; }
  const QFont& font() const noexcept { return font_; }
  QString words(const Phrase& phrase) const;

 private:
  TextLines broken(const QString& whole, double width) const;
  void lay_key();
  void lay_labels();
  void lay_rows();
  void lay_names();
  void place_ticks();

  const Figure& figure_;
  const FigureLook& look_;
  double width_ = 0.0;
  double letters_ = 0.0;
  QFont font_{};
  double height_ = 0.0;
  double key_height_ = 0.0;
  QRectF plot_{};
  QRectF shades_{};
  bool upright_x_labels_ = false;
  std::vector<double> row_middles_{};  ///< of the places of the vertical axis
  std::vector<double> row_bottoms_{};
  std::vector<LaidTick> x_ticks_{};
  std::vector<LaidTick> y_ticks_{};
  std::vector<LaidTick> far_ticks_{};
  TextLines x_name_{};
  TextLines y_name_{};
  TextLines sentence_{};
  std::vector<KeyItem> key_{};
};

}  // namespace asperity
