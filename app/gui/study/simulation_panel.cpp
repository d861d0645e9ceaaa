#include "app/gui/study/simulation_panel.h"

#include <algorithm>
#include <thread>

#include <QtWidgets/QProgressBar>
#include <QtWidgets/QSpinBox>

#include "app/gui/look/controls.h"
#include "app/gui/study/shown_text.h"

namespace asperity {

namespace {

/// One core is left to the window.
int jobs_here() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1); }

}  // namespace

SimulationPanel::SimulationPanel(OpenStudy& study, QWidget* parent)
    : QWidget(parent), study_(study) {
  setObjectName("simulation_panel");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kMargin);
  words_ = make_text({}, this);
  layout->addWidget(words_);
  layout->addWidget(make_text(
      tr("A virtual hand feels every surface and arithmetic answers: the sessions run as fast as "
         "this machine can, and are marked as simulated for ever."),
      this, true));
  participants_ = new QSpinBox(this);
  participants_->setObjectName("simulation_participants");
  participants_->setRange(1, 9999);
  participants_->setValue(4);
  participants_->setFixedWidth(120);
  seed_ = new QSpinBox(this);
  seed_->setObjectName("simulation_seed");
  seed_->setRange(1, 999'999'999);
  seed_->setFixedWidth(120);
  auto* settings = new QHBoxLayout();
  settings->setSpacing(kGrid);
  settings->addWidget(new QLabel(tr("Virtual participants to add"), this));
  settings->addWidget(participants_);
  settings->addSpacing(kMargin);
  settings->addWidget(new QLabel(tr("Seed (the same seed gives the same answers)"), this));
  settings->addWidget(seed_);
  settings->addStretch(1);
  layout->addLayout(settings);

  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  begin_ = make_button({}, ButtonRole::plain, this);
  begin_->setObjectName("simulation_begin");
  go_on_ = make_button(tr("Go on"), ButtonRole::plain, this);
  go_on_->setObjectName("simulation_go_on");
  cancel_ = make_button(tr("Cancel"), ButtonRole::plain, this);
  cancel_->setObjectName("simulation_cancel");
  show_ = make_button(tr("Show the sessions"), ButtonRole::link, this);
  show_->setObjectName("simulation_show");
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setMaximumWidth(400);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{begin_, go_on_, cancel_, progress_, show_}) {
    row->addWidget(widget);
  }
  row->addStretch(1);
  layout->addLayout(row);
  outcome_ = make_text({}, this);
  outcome_->setObjectName("simulation_outcome");
  layout->addWidget(outcome_);
  layout->addStretch(1);

  connect(participants_, &QSpinBox::valueChanged, this, &SimulationPanel::show_state);
  connect(begin_, &QPushButton::clicked, this, [this] { begin(false); });
  connect(go_on_, &QPushButton::clicked, this, [this] { begin(true); });
  connect(cancel_, &QPushButton::clicked, this, [this] {
    was_cancelled_ = true;
    cancel_->setEnabled(false);
    outcome_->setText(tr("Stopping after the trials under way…"));
    task_.cancel();
  });
  connect(show_, &QPushButton::clicked, this, [this] { emit sessions_wanted(simulated_name_); });
  connect(&task_, &BackgroundTask::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(1000.0 * fraction)); });
  show_->hide();
  show_state();
}

void SimulationPanel::set_protocol(const std::filesystem::path& file, const QString& name) {
  file_ = file;
  name_ = name;
  words_->setText(tr("Simulate %1").arg(name));
}

void SimulationPanel::begin(bool go_on) {
  if (!go_on) {
    inputs_ = {};
    inputs_.protocols = {file_};
    inputs_.study = study_.folder();
    inputs_.participants = participants_->value();
    inputs_.seed = static_cast<std::uint64_t>(seed_->value());
    inputs_.jobs = jobs_here();
    simulated_name_ = name_;
  }
  inputs_.resume = go_on;
  was_cancelled_ = false;
  progress_->setValue(0);
  outcome_->setText(tr("Simulating %1…").arg(simulated_name_));
  show_->hide();
  const auto finished = [this](State state, const QString& text) {
    outcome_->setText(shape_of(state) + ' ' + text);
    show_->setVisible(state != State::stop);
    // The next one is of other participants: it should not be a copy of this one.
    if (state == State::fine) seed_->setValue(seed_->value() + 1);
    show_state();
    study_.announce_change();
  };
  task_.run<SimulationResult>(
      [inputs = inputs_](const std::stop_token& stop, const BackgroundTask::Progress& progress) {
        const ModelRegistry models = built_in_models();
        return simulate(inputs, models, stop, progress, {});
      },
      [this, finished](const SimulationResult& result) {
        const QString counts = tr("%1 sessions with %2 attempts, in %3")
                                   .arg(result.sessions)
                                   .arg(result.attempts)
                                   .arg(text_of_duration(result.wall_s));
        if (was_cancelled_) {
          finished(State::look, tr("Cancelled after %1. What is finished is stored.").arg(counts));
        } else {
          finished(State::fine, tr("Simulated: %1.").arg(counts));
        }
      },
      [finished](const QString& what) {
        finished(State::stop, tr("The simulation ended: %1").arg(what));
      });
  show_state();
}

void SimulationPanel::show_state() {
  const bool running = task_.is_running();
  begin_->setText(participants_->value() == 1
                      ? tr("Simulate 1 participant")
                      : tr("Simulate %1 participants").arg(participants_->value()));
  begin_->setVisible(!running);
  participants_->setEnabled(!running);
  seed_->setEnabled(!running);
  go_on_->setVisible(!running && was_cancelled_);
  cancel_->setVisible(running);
  cancel_->setEnabled(true);
  progress_->setVisible(running);
}

}  // namespace asperity
