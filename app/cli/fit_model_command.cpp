// asperity fit-model: the files of a force model from recorded textures, or from a texture of another toolkit.

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/line_spectrum.h"
#include "app/cli/command.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/recording_warnings.h"
#include "app/cli/output/terminal.h"
#include "app/study_files/height_field_files.h"
#include "renderers/recordings/texture_recording.h"
#include "renderers/vibrations/haptic_texture_toolkit.h"
#include "renderers/vibrations/vibration_fit.h"
#include "renderers/vibrations/vibration_models.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

struct FitModelOptions {
  std::vector<std::string> recordings{};
  std::optional<std::string> import{};
  std::string model = "data_driven";
  std::optional<int> order{};
  double effective_mass_kg = kEffectiveMass_kg;
  std::filesystem::path out{};
  bool force = false;
};

/// What the models depend on, by their speeds and normal forces.
void warn_of_missing_places(const VibrationModels& set, const std::string& name) {
  const Eigen::Vector2d per_range = place_scale(set).per_range;
  const bool speeds = per_range.x() > 0.0;
  const bool forces = per_range.y() > 0.0;
  if (!speeds) {
    say("asperity: warning: " + name +
        ": there is one speed, so that the vibration does not depend on the speed; record further "
        "speeds that differ by at least 10 %");
  }
  if (!forces) {
    say("asperity: warning: " + name +
        ": there is one normal force, so that the vibration does not depend on it; record further "
        "normal forces that differ by at least 25 %");
  }
}

VibrationModels fitted_models(const FitModelOptions& options) {
  TextureRecording recording{};
  for (const std::string& file : options.recordings) {
    TextureRecording read = texture_recording_in(read_file(file, kTableFile), file);
    warn_of_uneven_strokes(read, file);
    recording.strokes.insert(recording.strokes.end(), read.strokes.begin(), read.strokes.end());
  }
  const std::string name = options.recordings.size() == 1
                               ? options.recordings.front()
                               : options.recordings.front() + " and the others";
  VibrationFitSettings settings{.effective_mass_kg = options.effective_mass_kg};
  if (options.order) settings.order = static_cast<std::size_t>(*options.order);
  const VibrationFit fit = fitted_vibrations(recording, name, settings);
  Table table{};
  table.columns = {"speed_mm_per_s", "normal_force_N", "strokes",
                   "duration_s",     "rms_m_per_s2",   "sigma_m_per_s2"};
  for (std::size_t i = 0; i < fit.strokes.size(); ++i) {
    const VibrationModel& model = fit.set.models[i];
    const FittedStrokes& strokes = fit.strokes[i];
    table.rows.push_back({fixed(1e3 * model.speed_m_per_s, 1), fixed(model.normal_N, 2),
                          std::to_string(strokes.strokes),
                          fixed(static_cast<double>(strokes.samples) / kVibrationRate_Hz, 2),
                          fixed(strokes.rms_m_per_s2, 4),
                          fixed(std::sqrt(model.variance_m2_per_s4), 4)});
  }
  std::cout << options.out.string() << ": " << counted(recording.strokes.size(), "stroke") << ", "
            << counted(fit.set.models.size(), "model") << " of order " << fit.order
            << (options.order ? " (as given)" : " (by BIC)") << ", effective mass "
            << number_text(options.effective_mass_kg) << " kg\n"
            << aligned(table);
  warn_of_missing_places(fit.set, options.out.string());
  return fit.set;
}

VibrationModels imported_models(const FitModelOptions& options) {
  const ToolkitTexture texture = toolkit_texture_in(read_file(*options.import), *options.import);
  std::cout << options.out.string() << ": " << counted(texture.set.models.size(), "model")
            << " of order " << texture.set.models.front().lines_rad.size();
  if (texture.silent > 0) {
    std::cout << ", of which " << texture.silent << " silent: set variance to linear";
  }
  std::cout << '\n';
  if (texture.has_moving_average) {
    std::cout << "moving averages replaced: within " << fixed(texture.largest_difference_dB, 2)
              << " dB in third octaves from 20 to 400 Hz\n";
  }
  if (texture.friction) {
    std::cout << "friction of the file, for the material: " << number_text(*texture.friction)
              << '\n';
  }
  return texture.set;
}

}  // namespace

void add_fit_model(CLI::App& program, Job& job) {
  auto options = std::make_shared<FitModelOptions>();
  CLI::App* command = program.add_subcommand(
      "fit-model",
      "Write the vibration models of a texture, for the force model data_driven: fitted to "
      "recorded "
      "textures, or imported from a texture of the Penn Haptic Texture Toolkit.");
  command->add_option("RECORDING", options->recordings,
                      "Tables of strokes (TSV), which asperity texture-recording writes");
  command->add_option("--import", options->import,
                      "Instead: your copy of a texture of the toolkit, Models_NAME.xml");
  command
      ->add_option("--model", options->model,
                   "The force model whose file is written; data_driven is the only one so far")
      ->check(word_among({"data_driven"}))
      ->option_text("data_driven");
  command
      ->add_option("--order", options->order,
                   "Order of the autoregressive models; without it, the one from 1 to 20 with the "
                   "least BIC")
      ->check(number_within(1, static_cast<int>(kMostSpectralLines)));
  command
      ->add_option("--effective-mass-kg", options->effective_mass_kg,
                   "Mass by which the recorded force is divided; the force model multiplies by its "
                   "parameter of this name")
      ->capture_default_str()
      ->check(number_within(1e-3, 10.0));
  command->add_option("--out", options->out, "The vibration models (TSV)")->required();
  command->add_flag("--force", options->force, "Replace an existing file");
  command->callback([options, &job] {
    job = [options] {
      if (options->recordings.empty() == !options->import) {
        throw WrongUsage(
            "give the tables of strokes that the models are fitted to, or --import FILE.xml");
      }
      const Overwrite overwrite = options->force ? Overwrite::allow : Overwrite::refuse;
      refuse_existing({options->out}, overwrite);
      const VibrationModels set =
          options->import ? imported_models(*options) : fitted_models(*options);
      write_file(options->out, tsv_of(set), overwrite);
      return 0;
    };
    job = with_lasting_effect(job);
  });
}

}  // namespace asperity
