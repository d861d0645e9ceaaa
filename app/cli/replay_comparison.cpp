// asperity replay --compare: every recorded hand of a study through the force models of this program, or another one.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/numbers/rounded_text.h"
#include "app/cli/command.h"
#include "app/cli/output/terminal.h"
#include "app/cli/replay_options.h"
#include "app/cli/signals.h"
#include "app/plugins/plugin_files.h"
#include "app/study_files/parameter_json.h"
#include "app/study_files/program.h"
#include "app/tasks/compare_replays.h"
#include "results_schema/hashes/sha256.h"
#ifdef ASPERITY_WITH_WINDOWS
#include "app/figures/figure_files.h"
#include "app/findings/shared/figures/replay_figure.h"
#endif

namespace asperity {

namespace {

constexpr int kShownDigits = 4;

nlohmann::ordered_json json_of(const ReplayComparison& comparison,
                               const std::optional<OtherModelSettings>& other) {
  const ForceDifference& pooled = comparison.pooled;
  const ProgramIdentity& program = this_program();
  nlohmann::ordered_json json{{"format", "asperity.replay/1"},
                              {"compared_with", program.version + " (" + program.commit + ')'},
                              {"model", nullptr}};
  if (other) {
    json["model"] = other->model->declaration.id;
    json["model_version"] = other->model->declaration.version;
    json["parameters"] = nlohmann::ordered_json::parse(json_text_of(other->parameters));
    json["assets_sha256"] = nlohmann::ordered_json::object();
    for (const auto& [role, content] : other->assets) {
      json["assets_sha256"][role] = sha256_of(*content);
    }
    if (other->model->plugin) json["plugin_sha256"] = other->model->plugin->sha256;
  }
  json["band_borders_Hz"] = critical_band_borders_Hz();
  json["presentations"] = comparison.presentations.size();
  json["presentations_of_other_kind"] = comparison.of_other_kind;
  json["attempts_without_recording"] = comparison.attempts_without_recording;
  json["pooled"] = {{"ticks", pooled.samples},
                    {"duration_s", pooled.duration_s},
                    {"recorded_rms_N", pooled.rms_N(pooled.recorded)},
                    {"compared_rms_N", pooled.rms_N(pooled.compared)},
                    {"rms_difference_N", pooled.rms_N(pooled.difference)},
                    {"largest_difference_N", pooled.largest_N},
                    {"recorded_energy_N2_s", pooled.recorded.bands_N2_s},
                    {"compared_energy_N2_s", pooled.compared.bands_N2_s},
                    {"difference_energy_N2_s", pooled.difference.bands_N2_s}};
  return json;
}

/// The pooled RMS of the forces, in all and by band.
Table summary_of(const ForceDifference& pooled) {
  const auto shown = [](double force_N) { return with_digits(force_N, kShownDigits); };
  Table table{.columns = {"frequency", "recorded_rms_N", "compared_rms_N", "rms_difference_N"}};
  table.rows.push_back({"all", shown(pooled.rms_N(pooled.recorded)),
                        shown(pooled.rms_N(pooled.compared)),
                        shown(pooled.rms_N(pooled.difference))});
  for (std::size_t band = 0; band < kCriticalBands; ++band) {
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{critical_band_name(band)});
    for (const ForceEnergy* energy : {&pooled.recorded, &pooled.compared, &pooled.difference}) {
      row.emplace_back(shown(std::sqrt(energy->bands_N2_s[band] / pooled.duration_s)));
    }
  }
  return table;
}

void say_what_is_left_out(const ReplayComparison& comparison) {
  if (comparison.attempts_without_recording > 0) {
    say("attempts without a recording, which cannot be replayed: " +
        std::to_string(comparison.attempts_without_recording));
  }
  if (comparison.of_other_kind > 0) {
    say("asperity: warning: presentations that are not compared because the force model does not "
        "feel what the recorded one felt (two bodies, or a texture with a point): " +
        std::to_string(comparison.of_other_kind));
  }
  std::size_t not_finite = 0;
  for (const ComparedPresentation& each : comparison.presentations) {
    not_finite += each.ticks_not_finite;
  }
  if (not_finite > 0) {
    say("asperity: warning: ticks that are not compared because a force is not a finite number: " +
        std::to_string(not_finite));
  }
}

void require_presentations(const ReplayComparison& comparison, const std::string& study) {
  if (comparison.pooled.samples > 0) return;
  if (comparison.of_other_kind > 0) {
    throw std::runtime_error(
        "no recorded presentation of " + study +
        " can be rendered with this force model, because one of them needs "
        "two bodies and the other a texture and a point; choose another model");
  }
  throw std::runtime_error(
      "no recorded presentation of " + study +
      " can be compared; record the sessions, or simulate them with --recordings all");
}

/// Checked before minutes of work, whose result could not be written.
void require_free_files(const ReplayOptions& options, const std::filesystem::path& declaration) {
  std::vector<std::filesystem::path> files{options.out, declaration};
#ifdef ASPERITY_WITH_WINDOWS
  if (!options.plot.empty()) {
    try {
      require_figure_ending(options.plot);
    } catch (const std::invalid_argument& error) {
      throw WrongUsage(std::string("--plot: ") + error.what());
    }
    files.push_back(options.plot);
  }
#endif
  for (const std::filesystem::path& file : files) {
    if (!file.has_parent_path() || std::filesystem::is_directory(file.parent_path())) continue;
    throw std::runtime_error("there is no folder " + file.parent_path().string() + " for " +
                             file.filename().string() + "; create it first, or choose another");
  }
  refuse_existing(files, options.overwrite());
}

}  // namespace

int run_replay_comparison(const ReplayOptions& options) {
  const std::filesystem::path declaration = options.out.string() + ".json";
  require_free_files(options, declaration);
  const Study study = Study::open(options.study, Access::read_only);
  ReplayComparisonOrder order{
      .builds = models_with_builds(options.plugins),
      .jobs = options.jobs > 0
                  ? options.jobs
                  : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))};
  const std::optional<OtherModelSettings> settings = other_model(options, order.builds.models());
  std::optional<OtherModel> other{};
  if (settings) order.other = &other.emplace(*settings);
  std::optional<ReplayComparison> comparison{};
  {
    const InterruptWatch interrupt("stopping; no table is written");
    Progress progress("replaying");
    comparison = compare_replays(study, order, interrupt.token(),
                                 [&progress](double fraction) { progress.show(fraction); });
  }
  if (!comparison) {
    say("asperity: the comparison was stopped, and no table was written; repeat the command to "
        "begin it again");
    return 1;
  }
  require_presentations(*comparison, options.study);
  const std::string json = json_of(*comparison, settings).dump(2) + '\n';
  std::vector<NewFile> files{{declaration, json}};
#ifdef ASPERITY_WITH_WINDOWS
  if (!options.plot.empty()) {
    const LettersWithoutWindows letters;
    files.push_back({options.plot,
                     figure_bytes(options.plot,
                                  replay_figure(comparison->pooled, options.model.value_or("")))});
  }
#endif
  files.push_back({options.out, tsv_of(table_of(*comparison))});
  write_files_together(files, options.overwrite());
  say_what_is_left_out(*comparison);
  if (options.json) {
    std::cout << json;
    return 0;
  }
  std::cout << options.out.string() << ": "
            << counted(comparison->presentations.size(), "presentation") << ", largest difference "
            << text_of_number(with_digits(comparison->pooled.largest_N, kShownDigits)) << " N\n"
            << aligned(summary_of(comparison->pooled));
  return 0;
}

}  // namespace asperity
