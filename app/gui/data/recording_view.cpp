// Connects the choice of a surface, the zoom and the plots, or shows the reason why there is no recording.

#include "app/gui/data/recording_view.h"

#include <algorithm>
#include <utility>

#include <QtCore/QSignalBlocker>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QStackedWidget>

#include "app/gui/data/path_plots.h"
#include "app/gui/look/controls.h"

namespace asperity {

namespace {

constexpr double kZoomStep = 2.0;

}  // namespace

RecordingView::RecordingView(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, kGrid, 0, 0);
  stack_ = new QStackedWidget(this);
  layout->addWidget(stack_);
  auto* without = new QWidget(stack_);
  auto* rows = new QVBoxLayout(without);
  rows->setContentsMargins(0, kMargin, 0, 0);
  reason_ = new StateLabel(without);
  reason_->setObjectName("recording_reason");
  rows->addWidget(reason_);
  rows->addStretch(1);
  stack_->addWidget(without);

  auto* with = new QWidget(stack_);
  auto* plots = new QVBoxLayout(with);
  plots->setContentsMargins(0, 0, 0, 0);
  plots->setSpacing(kGrid);
  auto* tools = new QHBoxLayout();
  tools->setSpacing(kGrid);
  choice_ = new ChoiceBox(with);
  choice_->setObjectName("recording_choice");
  choice_->setAccessibleName(tr("Visible part of the recording"));
  choice_->setMinimumWidth(280);
  QPushButton* nearer = make_button(tr("Zoom in"), ButtonRole::plain, with);
  nearer->setObjectName("recording_zoom_in");
  QPushButton* farther = make_button(tr("Zoom out"), ButtonRole::plain, with);
  farther->setObjectName("recording_zoom_out");
  QPushButton* save = make_button(tr("Export this recording as a table…"), ButtonRole::plain, with);
  save->setObjectName("recording_export");
  tools->addWidget(choice_);
  tools->addWidget(nearer);
  tools->addWidget(farther);
  tools->addStretch(1);
  tools->addWidget(save);
  plots->addLayout(tools);
  auto* both = new QHBoxLayout();
  both->setSpacing(kMargin);
  time_ = new TimePlots(with);
  path_ = new PathPlots(with);
  both->addWidget(time_, 5);
  both->addWidget(path_, 3);
  plots->addLayout(both, 1);
  stack_->addWidget(with);
  connect(choice_, &QComboBox::currentIndexChanged, this, &RecordingView::show_chosen);
  connect(nearer, &QPushButton::clicked, time_, [this] { time_->zoom(1.0 / kZoomStep); });
  connect(farther, &QPushButton::clicked, time_, [this] { time_->zoom(kZoomStep); });
  connect(save, &QPushButton::clicked, this, &RecordingView::export_wanted);
}

void RecordingView::show_reason(State state, const QString& why_none) {
  curves_.reset();
  reason_->set_state(state, why_none);
  stack_->setCurrentIndex(0);
}

void RecordingView::show_recording(std::shared_ptr<const RecordingCurves> curves,
                                   const std::vector<Surface>& surfaces, const AskedBands& bands) {
  curves_ = std::move(curves);
  {
    const QSignalBlocker quiet(choice_);
    choice_->clear();
    choice_->addItem(tr("Whole attempt"), 0);
    for (const Surface& surface : surfaces) choice_->addItem(surface.name, surface.position);
  }
  stack_->setCurrentIndex(1);
  time_->show_curves(curves_, bands);
  show_chosen();
}

void RecordingView::show_chosen() {
  if (curves_ == nullptr) return;
  const int position = choice_->currentData().toInt();
  if (position == 0) {
    time_->see(curves_->whole());
    path_->show_surfaces(*curves_, {});
    return;
  }
  path_->show_surfaces(*curves_, position);
  const auto surface =
      std::find_if(curves_->surfaces.begin(), curves_->surfaces.end(),
                   [position](const SurfaceCurves& candidate) {
                     return candidate.position == position && !candidate.visits.empty();
                   });
  if (surface == curves_->surfaces.end()) return;
  time_->see({surface->visits.front().begin_s, surface->visits.back().end_s});
}

}  // namespace asperity

#include "moc_recording_view.cpp"
