// Counts the stored trials, for the message about a simulation that is not complete.

#include "app/gui/window/batch_simulation.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <utility>

#include <QtWidgets/QApplication>

#include "app/gui/base/open_study.h"
#include "app/gui/data/analysis_page.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/task_line.h"
#include "app/gui/window/study_window.h"
#include "app/tasks/protocol_files.h"

namespace asperity {

namespace {

struct Simulated {
  SimulationResult result{};
  std::string protocol{};  ///< the name of the first one
};

}  // namespace

BatchSimulation::BatchSimulation(StudyWindow& window, QObject* parent)
    : QObject(parent), window_(window) {
  connect(&task_, &BackgroundTask::started, this, [this] {
    window_.set_busy(
        tr("The sessions of virtual participants are being simulated. Cancel the "
           "simulation first."));
    emit running(true);
  });
  connect(&task_, &BackgroundTask::finished, this, [this] {
    window_.set_busy({});
    emit running(false);
  });
}

BatchSimulation::~BatchSimulation() {
  delete line_;  // which shows the task
}

void BatchSimulation::show_line(int participants) {
  if (line_ == nullptr) {  // the window makes its lines anew for another theme or language
    line_ = new TaskLine(task_);
    line_->setObjectName("simulating");
    line_->setContentsMargins(kMargin, kGrid, kMargin, kGrid);
    connect(line_, &TaskLine::cancelWanted, this, [this] {
      cancelled_ = true;
      task_.cancel();
    });
    window_.add_line(line_);
  }
  line_->set_words(tr("Simulating %n virtual participants …", nullptr, participants));
}

void BatchSimulation::run(SimulationInputs inputs) {
  OpenStudy& study = *window_.study();
  inputs.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency() / 2));
  cancelled_ = false;
  show_line(inputs.participants);
  window_.banner().hide();
  const auto trials = std::make_shared<std::atomic<int>>(0);
  task_.run<Simulated>(
      [inputs, trials, models = study.models()](const std::stop_token& stop,
                                                const BackgroundTask::Progress& progress) {
        Simulated simulated{.result = simulate(inputs, models, stop, progress,
                                               [trials](const AttemptDone&) { ++*trials; })};
        simulated.protocol = load_protocol(inputs.protocols.front(), models, inputs.study).name;
        return simulated;
      },
      [this, page = window_.shown_page()](const Simulated& simulated) {
        window_.study()->announce_change();
        const QString what = tr("%n sessions were simulated.", nullptr, simulated.result.sessions) +
                             ' ' + tr("Trials of all blocks: %1.").arg(simulated.result.attempts);
        // Another page was chosen meanwhile, or a dialog asks about this one.
        if (window_.shown_page() == page && QApplication::activeModalWidget() == nullptr) {
          show_results(simulated.protocol);
          window_.banner().show_news(State::fine, what, tr("Show the sessions"),
                                     [this] { window_.show_page("sessions"); });
        } else {
          window_.banner().show_news(
              State::fine, what, tr("Show the results"),
              [this, protocol = simulated.protocol] { show_results(protocol); });
        }
      },
      [this, inputs, trials](const QString& what) { report_incomplete(what, inputs, *trials); });
}

void BatchSimulation::show_results(const std::string& protocol) {
  qobject_cast<AnalysisPage*>(window_.page("analysis"))->choose(protocol, SessionMode::simulate);
  window_.show_page("analysis");
}

void BatchSimulation::report_incomplete(const QString& what, const SimulationInputs& inputs,
                                        int trials) {
  window_.study()->announce_change();
  const QString stopped = cancelled_ ? tr("The simulation was cancelled.") : what;
  const State state = cancelled_ ? State::look : State::stop;
  if (trials == 0) {
    window_.banner().show_news(state, stopped + ' ' + tr("No trial was completed."));
    return;
  }
  SimulationInputs resumed = inputs;
  resumed.resume = true;
  window_.banner().show_news(
      state,
      stopped + ' ' +
          tr("Trials completed and stored: %1. Resume the simulation to complete it.").arg(trials),
      tr("Resume the simulation"), [this, resumed] { emit wanted(resumed); });
}

}  // namespace asperity

#include "moc_batch_simulation.cpp"
