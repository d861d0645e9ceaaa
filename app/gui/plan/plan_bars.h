// A session as a row of bars: its blocks and breaks, as wide as they take time.

#pragma once

#include <vector>

#include <QtWidgets/QWidget>

#include "protocols/plan/plan_parts.h"

class QLabel;

namespace asperity {

/// Blocks have the colours of a legend below, with their trials and minutes; breaks are gaps between them, and what is read
/// is a thin line. The legend and the accessible description state the same in words; each bar has its words as a tooltip.
class PlanBars final : public QWidget {
  Q_OBJECT
 public:
  explicit PlanBars(QWidget* parent = nullptr);

  void show_plan(const Protocol& protocol, const Plan& plan);

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
    int trials = 0;
    int most_trials = 0;
    bool is_variable = false;  ///< the responses determine how many trials there are
    double duration_s = 0.0;
  };

  void add_entries(const Protocol& protocol, const Plan& plan);
  void write_legend();
  QRectF rect_of(std::size_t bar) const;
  const Bar* bar_at(QPointF place) const;

  std::vector<Bar> bars_{};
  std::vector<Entry> entries_{};
  QLabel* legend_ = nullptr;
};

}  // namespace asperity
