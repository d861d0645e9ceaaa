// A session as a row of bars: its blocks and breaks, as wide as they take time.

#pragma once

#include <span>
#include <vector>

#include <QtWidgets/QWidget>

#include "protocols/plan/plan_parts.h"

class QLabel;

namespace asperity {

/// "48 trials", "at most 60 trials" where the responses determine their number.
QString text_of_trials(std::span<const PlannedRun> runs);

/// Blocks have the colours of a legend below, with their trials and minutes; breaks are gaps between them, and what is read
/// is a thin line. The legend and the accessible description state the same in words; each bar has its words as a tooltip.
class PlanBars final : public QWidget {
  Q_OBJECT
 public:
  explicit PlanBars(QWidget* parent = nullptr);

  /// Of one plan.
  void show_parts(std::span<const PlanPart> parts, std::span<const PlannedRun> runs);

 signals:
  /// A bar was pressed: its first step.
  void step_wanted(int step);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Bar {
    PlanPart::What what = PlanPart::What::reading;
    int color = 0;       ///< of the series; of trials
    double share = 0.0;  ///< of the whole duration
    int first_step = 0;
    QString words{};
  };
  /// One line of the legend, for all runs of a block.
  struct Entry {
    QString block{};
    int runs = 0;
    QString trials{};
    double duration_s = 0.0;
  };

  void add_entries(std::span<const PlannedRun> runs);
  void write_legend();
  QRectF rect_of(std::size_t bar) const;
  const Bar* bar_at(QPointF place) const;

  std::vector<Bar> bars_{};
  std::vector<Entry> entries_{};
  QLabel* legend_ = nullptr;
};

}  // namespace asperity
