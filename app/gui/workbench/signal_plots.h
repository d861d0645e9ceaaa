// Something along a line or in time as curves; and two of these beside each other, a signal and its
// spectrum.

#pragma once

#include <vector>

#include <QtCore/QString>
#include <QtCore/QVector>
#include <QtGui/QColor>
#include <QtWidgets/QFrame>
#include <QtWidgets/QWidget>

class QCustomPlot;
class QLabel;

namespace asperity {

struct PlotSeries {
  QString name{};  ///< stands over the plot in the colour of the line; empty: none
  QColor color{};
  QVector<double> x{};
  QVector<double> y{};
};

enum class PlotScale { linear, logarithmic };

struct PlotAxes {
  QString heading{};
  QString x{};  ///< with its unit
  QString y{};
  PlotScale x_scale = PlotScale::linear;
  PlotScale y_scale = PlotScale::linear;
  /// Names in a line of their own and in large letters: where they are numbers.
  bool names_are_large = false;
};

class SignalPlot final : public QFrame {
  Q_OBJECT
 public:
  explicit SignalPlot(const PlotAxes& axes, QWidget* parent = nullptr);

  /// Every axis fits what is shown. Without series, `empty` says what to do.
  void show_series(const std::vector<PlotSeries>& series, const QString& empty = {});
  const std::vector<PlotSeries>& series() const noexcept { return series_; }

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void draw();
  void write_names();
  void choose_ticks();

  PlotAxes axes_{};
  QLabel* heading_ = nullptr;
  QLabel* large_names_ = nullptr;  // null unless names are large
  QCustomPlot* plot_ = nullptr;
  std::vector<PlotSeries> series_{};
  QString empty_{};
};

class SignalPlots final : public QWidget {
  Q_OBJECT
 public:
  SignalPlots(const PlotAxes& signal, const PlotAxes& spectrum, QWidget* parent = nullptr);

  /// As SignalPlot::show_series.
  void show_signal(const std::vector<PlotSeries>& series, const QString& empty = {});
  void show_spectrum(const std::vector<PlotSeries>& series, const QString& empty = {});
  const std::vector<PlotSeries>& signal_series() const noexcept { return signal_->series(); }
  const std::vector<PlotSeries>& spectrum_series() const noexcept { return spectrum_->series(); }

 private:
  SignalPlot* signal_ = nullptr;
  SignalPlot* spectrum_ = nullptr;
};

}  // namespace asperity
