// Replays attempts on several threads, and accumulates differences and energies in bands by surface.

#include "app/tasks/compare_replays.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "analysis/signals/force_features.h"
#include "app/plugins/stored_plugins.h"
#include "app/records/builders_of_attempts.h"
#include "app/records/recorded_attempt.h"
#include "renderers/force/rendered_tick.h"
#include "results_schema/error_text.h"

namespace asperity {

namespace {

struct WaitingAttempt {
  const SessionRow* session = nullptr;
  AttemptRow row{};
  Trial trial{};
};

/// The components of a force over a stretch of ticks.
struct Stretch {
  std::array<std::vector<double>, 3> recorded_N{};
  std::array<std::vector<double>, 3> compared_N{};

  void add(const glm::dvec3& recorded, const glm::dvec3& compared) {
    for (int axis = 0; axis < 3; ++axis) {
      recorded_N[static_cast<std::size_t>(axis)].push_back(recorded[axis]);
      compared_N[static_cast<std::size_t>(axis)].push_back(compared[axis]);
    }
  }

  /// Adds the stretch to the presentation, and empties it.
  void end(double rate_Hz, ForceDifference& forces) {
    const auto samples = [](const std::array<std::vector<double>, 3>& force_N) {
      return ForceSamples{.x_N = force_N[0], .y_N = force_N[1], .z_N = force_N[2]};
    };
    forces.add(force_difference(samples(recorded_N), samples(compared_N), rate_Hz));
    for (auto* force_N : {&recorded_N, &compared_N}) {
      for (std::vector<double>& axis_N : *force_N) axis_N.clear();
    }
  }
};

void compare_ticks(const ReplayedSurface& replayed, double rate_Hz, ComparedPresentation& result) {
  constexpr auto kLift_ns = static_cast<std::int64_t>(1e9 * kLift_s);
  Stretch stretch{};
  std::int64_t last_ns = 0;
  for (std::size_t i = 0; i < replayed.records.size(); ++i) {
    const TickRecord& record = replayed.records[i];
    const RenderedTick& tick = replayed.ticks[i];
    const bool is_compared = record.has(TickFlag::presenting);
    const bool is_finite =
        is_finite_as_stored(record.rendered.force_N) && is_finite_as_stored(tick.wrench.force_N);
    if (!is_compared || !is_finite || record.probe.time_ns - last_ns > kLift_ns) {
      stretch.end(rate_Hz, result.forces);
    }
    last_ns = record.probe.time_ns;
    if (!is_compared) continue;
    if (!is_finite) {
      ++result.ticks_not_finite;
      continue;
    }
    stretch.add(record.rendered.force_N, rounded_for_recording(tick.wrench.force_N));
  }
  stretch.end(rate_Hz, result.forces);
}

/// The attempts of a study that are compared, and what each gives.
class ReplayWork final {
 public:
  ReplayWork(const Study& study, const ReplayComparisonOrder& order, const std::stop_token& stop,
             const std::function<void(double)>& progress)
      : order_(order),
        recorded_builds_(with_stored_builds(order.builds, study)),
        builders_(recorded_builds_, study.folder()),
        folder_(study.folder()),
        stop_(stop),
        progress_(progress) {
    sessions_ = study.sessions();
    std::erase_if(sessions_, [](const SessionRow& session) { return session.withdrawn; });
    PlansOfSessions plans(study, order.builds.models());
    for (const SessionRow& session : sessions_) {
      if (stop_.stop_requested()) return;
      Plan plan = plans.of(session);
      for (AttemptRow& attempt : study.attempts(session.id)) {
        if (!attempt.recording) {
          ++without_recording_;
          continue;
        }
        Trial trial = plan.trials.at(static_cast<std::size_t>(attempt.trial - 1));
        waiting_.push_back({&session, std::move(attempt), std::move(trial)});
      }
    }
    results_.resize(waiting_.size());
  }

  std::optional<ReplayComparison> done(int jobs) {
    {
      std::vector<std::jthread> workers{};
      for (int job = 1; job < jobs; ++job) workers.emplace_back([this] { work(); });
      work();
    }
    for (const Result& result : results_) {
      if (result.failure) std::rethrow_exception(result.failure);
    }
    if (stop_.stop_requested()) return {};
    ReplayComparison comparison{.attempts_without_recording = without_recording_};
    for (Result& result : results_) {
      comparison.of_other_kind += result.of_other_kind;
      for (ComparedPresentation& presentation : result.presentations) {
        comparison.pooled.add(presentation.forces);
        comparison.presentations.push_back(std::move(presentation));
      }
    }
    return comparison;
  }

 private:
  struct Result {
    std::vector<ComparedPresentation> presentations{};
    std::size_t of_other_kind = 0;
    std::exception_ptr failure{};
  };

  // Attempts are begun in their order, so that those before the first failure are complete.
  void work() {
    while (!stop_.stop_requested() && !failed_) {
      const std::size_t at = next_++;
      if (at >= waiting_.size()) return;
      try {
        compare(waiting_[at], results_[at]);
      } catch (...) {
        results_[at].failure = std::current_exception();
        failed_ = true;
      }
      const std::size_t done = ++done_;
      if (progress_) {
        progress_(static_cast<double>(done) / static_cast<double>(waiting_.size()));
      }
    }
  }

  void compare(const WaitingAttempt& waiting, Result& result) {
    const std::string name = "attempt " + natural_key(*waiting.session, waiting.row);
    try {
      compare_surfaces(waiting, result);
    } catch (const std::exception& error) {
      const std::string what = message_of(error);
      if (what.find(name) != std::string::npos) throw;
      throw std::runtime_error(name + ": " + what);
    }
  }

  void compare_surfaces(const WaitingAttempt& waiting, Result& result) {
    StimulusBuilder* const builder = builders_.builder_for(waiting.row, false);
    if (builder == nullptr) {
      throw std::runtime_error(
          "the study does not contain the description of the plug-in that rendered it; load it "
          "with --plugin FILE");
    }
    const RecordedAttempt recorded =
        recorded_attempt(folder_, *waiting.session, waiting.trial, waiting.row, *builder);
    for (const RecordedSurface& surface : recorded.surfaces) {
      const int position = surface.row.position;
      const ForceModel& felt = *surface.stimulus.model;
      if (order_.other != nullptr && !feel_alike(order_.other->model(), felt)) {
        ++result.of_other_kind;
        continue;
      }
      const ForceModel& model = order_.other != nullptr ? order_.other->model() : loaded(felt);
      const RendererInputs inputs = order_.other != nullptr
                                        ? order_.other->inputs_for(recorded, position, *builder)
                                        : surface.stimulus.inputs;
      ComparedPresentation& presentation = result.presentations.emplace_back(ComparedPresentation{
          .participant = waiting.session->participant,
          .session = waiting.session->session,
          .trial = waiting.row.trial,
          .attempt = waiting.row.attempt,
          .surface = position,
          .item = surface.row.item,
          .recorded_with =
              waiting.session->program_version + " (" + waiting.session->program_commit + ')',
          .recorded_model = surface.row.model,
          .recorded_model_version = surface.row.model_version,
          .compared_model = model.declaration.id,
          .compared_model_version = model.declaration.version});
      compare_ticks(replay_surface(recorded, position, model, inputs), recorded.rate_Hz,
                    presentation);
    }
  }

  const ForceModel& loaded(const ForceModel& felt) const {
    if (const ForceModel* model = order_.builds.models().find(felt.declaration.id)) return *model;
    throw std::runtime_error("its force model " + felt.declaration.id +
                             " is in a plug-in that is not loaded; load it with --plugin FILE");
  }

  const ReplayComparisonOrder& order_;
  ModelBuilds recorded_builds_;
  BuildersOfAttempts builders_;
  std::filesystem::path folder_{};
  std::stop_token stop_;
  const std::function<void(double)>& progress_;
  std::vector<SessionRow> sessions_{};
  std::vector<WaitingAttempt> waiting_{};
  std::vector<Result> results_{};
  std::size_t without_recording_ = 0;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> done_{0};
  std::atomic<bool> failed_{false};
};

void add_energy_columns(const std::string& of, Table& table) {
  for (std::size_t band = 0; band < kCriticalBands; ++band) {
    std::string name = of + '_' + critical_band_name(band) + "_N2_s";
    std::replace(name.begin(), name.end(), ' ', '_');
    table.columns.push_back(std::move(name));
  }
}

}  // namespace

std::string critical_band_name(std::size_t band) {
  const std::span<const double> borders_Hz = critical_band_borders_Hz();
  return text_of_number(borders_Hz[band]) + " to " + text_of_number(borders_Hz[band + 1]) + " Hz";
}

std::optional<ReplayComparison> compare_replays(const Study& study,
                                                const ReplayComparisonOrder& order,
                                                const std::stop_token& stop,
                                                const std::function<void(double)>& progress) {
  return ReplayWork(study, order, stop, progress).done(order.jobs);
}

Table table_of(const ReplayComparison& comparison) {
  Table table{.columns = {"participant", "session", "trial", "attempt", "surface", "item",
                          "recorded_with", "recorded_model", "recorded_model_version",
                          "compared_model", "compared_model_version", "ticks", "duration_s",
                          "recorded_rms_N", "compared_rms_N", "rms_difference_N",
                          "largest_difference_N"}};
  add_energy_columns("recorded_energy", table);
  add_energy_columns("compared_energy", table);
  add_energy_columns("difference_energy", table);
  table.columns.emplace_back("ticks_not_finite");
  const auto whole = [](auto number) { return static_cast<std::int64_t>(number); };
  for (const ComparedPresentation& each : comparison.presentations) {
    const ForceDifference& forces = each.forces;
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{
        each.participant, whole(each.session), whole(each.trial), whole(each.attempt),
        whole(each.surface), each.item, each.recorded_with, each.recorded_model,
        each.recorded_model_version, each.compared_model, each.compared_model_version,
        whole(forces.samples), forces.duration_s, forces.rms_N(forces.recorded),
        forces.rms_N(forces.compared), forces.rms_N(forces.difference), forces.largest_N});
    for (const ForceEnergy* energy : {&forces.recorded, &forces.compared, &forces.difference}) {
      row.insert(row.end(), energy->bands_N2_s.begin(), energy->bands_N2_s.end());
    }
    row.emplace_back(whole(each.ticks_not_finite));
  }
  return table;
}

}  // namespace asperity
