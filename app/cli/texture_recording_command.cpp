// asperity texture-recording: the forces of strokes over a texture, from a relief, WAV files or a study.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/numbers/number_text.h"
#include "app/cli/command.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/recording_warnings.h"
#include "app/cli/output/terminal.h"
#include "app/plugins/plugin_files.h"
#include "app/records/recorded_attempt.h"
#include "app/records/recorded_strokes.h"
#include "app/study_files/height_field_files.h"
#include "renderers/models/auto_regressive.h"
#include "renderers/recordings/recorded_spectra.h"
#include "renderers/recordings/relief_recording.h"
#include "renderers/recordings/texture_recording.h"
#include "renderers/recordings/wav_samples.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

struct TextureRecordingOptions {
  std::optional<std::string> relief{};
  std::vector<std::string> wavs{};
  std::optional<std::string> study{};
  std::optional<std::string> table{};
  std::optional<std::string> attempt{};
  int surface = 1;
  std::string component = "motion";
  std::vector<double> speeds_m_per_s{};
  double normal_N = 1.0;
  double rate_Hz = 1000.0;
  std::optional<double> full_scale_N{};
  std::filesystem::path out{};
  bool force = false;
  std::vector<std::filesystem::path> plugins{};
};

TextureRecording recording_of_wavs(const TextureRecordingOptions& options) {
  if (options.speeds_m_per_s.size() != options.wavs.size()) {
    throw WrongUsage("--wav names " + counted(options.wavs.size(), "file") +
                     ", and --speed-m-per-s gives " +
                     counted(options.speeds_m_per_s.size(), "speed") +
                     "; give --speed-m-per-s once for each --wav, in the same order");
  }
  if (!options.full_scale_N) {
    throw WrongUsage("--wav needs the force at the full scale of the samples; add --full-scale-n");
  }
  TextureRecording recording{};
  for (std::size_t i = 0; i < options.wavs.size(); ++i) {
    const WavSamples wav = wav_samples_in(read_file(options.wavs[i]), options.wavs[i]);
    RecordedStroke stroke{};
    for (std::size_t j = 0; j < wav.samples.size(); ++j) {
      const double time_s = static_cast<double>(j) / wav.rate_Hz;
      stroke.time_s.push_back(time_s);
      stroke.path_m.push_back(time_s * options.speeds_m_per_s[i]);
      stroke.normal_N.push_back(options.normal_N);
      stroke.force_N.push_back(*options.full_scale_N * wav.samples[j]);
    }
    recording.strokes.push_back(std::move(stroke));
  }
  return recording;
}

TextureRecording recording_of_study(const TextureRecordingOptions& options) {
  if (!options.attempt) {
    throw WrongUsage("--study needs an attempt; add --attempt");
  }
  const Study study = Study::open(*options.study, Access::read_only);
  const ModelRegistry models = models_with(options.plugins);
  const AttemptRow attempt = find_attempt(study, *options.attempt);
  StimulusBuilder builder(models, study.folder());
  const RecordedAttempt recorded = recorded_attempt(study, attempt, builder);
  TextureRecording recording =
      strokes_of_hand({.records = recorded.records,
                       .presentation = static_cast<std::uint64_t>(options.surface),
                       .rate_Hz = recorded.rate_Hz,
                       .component = options.component == "normal" ? TextureComponent::normal
                                                                  : TextureComponent::motion});
  if (recording.strokes.empty()) {
    throw std::runtime_error("attempt " + *options.attempt +
                             " has no stroke of 0.25 s at 20 mm/s or " + "faster on surface " +
                             std::to_string(options.surface) +
                             "; choose another attempt or --surface");
  }
  return recording;
}

TextureRecording recording_asked_for(const TextureRecordingOptions& options) {
  const int sources = (options.relief ? 1 : 0) + (options.wavs.empty() ? 0 : 1) +
                      (options.study ? 1 : 0) + (options.table ? 1 : 0);
  if (sources != 1) {
    throw WrongUsage(
        "a recording is made from exactly one source; give one of --relief, --wav, --study and "
        "--table");
  }
  if (!options.plugins.empty() && !options.study) {
    throw WrongUsage(
        "--plugin loads the force models of a study; add --study, or leave out --plugin");
  }
  if (!options.wavs.empty()) return recording_of_wavs(options);
  if (options.study) return recording_of_study(options);
  if (options.table) {
    return texture_recording_in(read_file(*options.table, kTableFile), *options.table);
  }
  ReliefStrokes strokes{.normal_N = options.normal_N, .rate_Hz = options.rate_Hz};
  if (!options.speeds_m_per_s.empty()) strokes.speeds_m_per_s = options.speeds_m_per_s;
  return recording_of_relief(*load_height_field(*options.relief).field, strokes);
}

/// The parameters of the model auto_regressive with the statistics of the recording, as a protocol states them.
std::string parameters_of_friction(const TextureRecording& recording) {
  std::string text{};
  for (const auto& [name, value] : autoregression_of_recording(recording)) {
    text +=
        (text.empty() ? "" : ", ") + ('"' + name + "\": ") + number_text(std::get<double>(value));
  }
  return "auto_regressive: \"parameters\": {" + text + "}";
}

/// The mean over the strokes of the median of force over normal force: the friction, of a force along the motion.
double friction_of(const TextureRecording& recording) {
  double sum = 0.0;
  for (const RecordedStroke& stroke : recording.strokes) {
    std::vector<double> ratios{};
    for (std::size_t i = 0; i < stroke.force_N.size(); ++i) {
      if (stroke.normal_N[i] > 0.0) ratios.push_back(stroke.force_N[i] / stroke.normal_N[i]);
    }
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    sum += *middle;
  }
  return sum / static_cast<double>(recording.strokes.size());
}

}  // namespace

void add_texture_recording(CLI::App& program, Job& job) {
  auto options = std::make_shared<TextureRecordingOptions>();
  CLI::App* command = program.add_subcommand(
      "texture-recording",
      "Write the forces of strokes over a texture, for the force model recorded: from a relief, "
      "from WAV files or from a study. Prints the parameters of the force model auto_regressive "
      "with "
      "the same statistics.");
  command->add_option("--relief", options->relief,
                      "A height field, FILE.png: the forces of a point that slides over it without "
                      "friction");
  command->add_option("--wav", options->wavs,
                      "A recorded force at one speed: WAV with one channel, PCM of 16, 24 or 32 "
                      "bits or 32-bit floating point. Repeat it for each speed");
  command->add_option("--study", options->study,
                      "A study: the recorded strokes on one of its surfaces are used");
  command->add_option("--table", options->table,
                      "A table of strokes (TSV), which is checked and written again");
  command->add_option("--attempt", options->attempt,
                      "With --study: row number in the exported attempts.tsv, or "
                      "PARTICIPANT/SESSION/TRIAL/ATTEMPT");
  command
      ->add_option("--surface", options->surface,
                   "With --study: number of the surface in the trial")
      ->capture_default_str();
  command
      ->add_option("--component", options->component,
                   "With --study: the force against the motion, or along the normal")
      ->option_text("motion|normal")
      ->check(word_among({"motion", "normal"}));
  command
      ->add_option("--speed-m-per-s", options->speeds_m_per_s,
                   "Speed of each --wav; with --relief the speeds, 0.03,0.06,0.12 by default")
      ->delimiter(',')
      ->check(number_within(1e-4, 10.0));
  command
      ->add_option("--normal-force-n", options->normal_N,
                   "With --relief and --wav: the normal force during the strokes, N")
      ->capture_default_str()
      ->check(number_within(1e-3, 100.0));
  command->add_option("--rate-hz", options->rate_Hz, "With --relief: samples per second")
      ->capture_default_str()
      ->check(number_within(10.0, 1e5));
  command
      ->add_option("--full-scale-n", options->full_scale_N,
                   "With --wav: the force at the full scale of the samples, N")
      ->check(number_within(1e-9, 1e6));
  command->add_option("--out", options->out, "The table of strokes (TSV)")->required();
  command->add_flag("--force", options->force, "Replace an existing file");
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    job = watched_with(options->plugins, [options] {
      const Overwrite overwrite = options->force ? Overwrite::allow : Overwrite::refuse;
      refuse_existing({options->out}, overwrite);
      const TextureRecording recording = recording_asked_for(*options);
      require_strokes(recording, options->out.string());
      write_file(options->out, tsv_of(recording), overwrite);
      const RecordedSpectra spectra(recording, SpectrumAxis::spatial, 1.0);
      const std::vector<double>& speeds = spectra.speeds_m_per_s();
      std::cout << options->out.string() << ": " << counted(recording.strokes.size(), "stroke")
                << " at " << counted(speeds.size(), "speed") << ", "
                << fixed(speeds.front() * 1e3, 1) << " to " << fixed(speeds.back() * 1e3, 1)
                << " mm/s, median force over normal force " << fixed(friction_of(recording), 3)
                << '\n';
      if (options->component == "motion") std::cout << parameters_of_friction(recording) << '\n';
      warn_of_uneven_strokes(recording, options->out.string());
      if (speeds.size() < 2) {
        say("asperity: warning: " + options->out.string() +
            ": all strokes have nearly the same speed, and the force model recorded needs at least "
            "two speeds; add strokes at another speed, or set single_speed to accepted");
      }
      return 0;
    });
    job = with_lasting_effect(job);
  });
}

}  // namespace asperity
