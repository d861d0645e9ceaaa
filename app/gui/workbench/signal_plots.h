// Two plots beside each other: something along a line or in time, and its spectrum.

#pragma once

#include <vector>

#include <QtCore/QString>
#include <QtCore/QVector>
#include <QtGui/QColor>
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
};

class SignalPlots final : public QWidget {
  Q_OBJECT
 public:
  SignalPlots(const PlotAxes& signal, const PlotAxes& spectrum, QWidget* parent = nullptr);

  /// Every axis fits what is shown. Without series, `empty` says what to do.
  void show_signal(const std::vector<PlotSeries>& series, const QString& empty = {});
  void show_spectrum(const std::vector<PlotSeries>& series, const QString& empty = {});
  const std::vector<PlotSeries>& signal_series() const noexcept { return signal_.series; }
  const std::vector<PlotSeries>& spectrum_series() const noexcept { return spectrum_.series; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Side {
    PlotAxes axes{};
    QLabel* heading = nullptr;
    QCustomPlot* plot = nullptr;
    std::vector<PlotSeries> series{};
    QString empty{};
  };
  QWidget* make_side(Side& side, const PlotAxes& axes);
  static void draw(Side& side);

  Side signal_{};
  Side spectrum_{};
};

}  // namespace asperity
