// asperity texture: a photograph becomes a height field.

#include <iostream>
#include <map>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "analysis/number_text.h"
#include "app/cli/command.h"
#include "app/cli/png_name.h"
#include "app/cli/terminal.h"
#include "app/cli/word_option.h"
#include "app/findings/reading_number.h"
#include "app/study_files/height_field_files.h"
#include "stimuli/photographs/photograph_advice.h"
#include "stimuli/photographs/preview.h"
#include "stimuli/photographs/texture_from_photograph.h"

namespace asperity {

void add_texture(CLI::App& program, Job& job) {
  struct Options {
    std::filesystem::path photograph{};
    std::filesystem::path out{};
    std::optional<std::filesystem::path> preview{};
    TextureRecipe recipe{};
    int sign = 1;
    bool force = false;
  };
  constexpr std::size_t kPreviewRows = 320;
  auto options = std::make_shared<Options>();
  TextureRecipe& recipe = options->recipe;
  CLI::App* command =
      program.add_subcommand("texture",
                             "Compute a height field from a photograph: conversion to greyscale, "
                             "homomorphic filter, subtraction of the low-pass (f − g).");
  command->add_option("PHOTO", options->photograph, "PNG, JPEG, TIFF, BMP or WebP")->required();
  command
      ->add_option("--out", options->out,
                   "The height field, FILE.png (its sidecar is FILE.png.json)")
      ->required();
  command
      ->add_option("--width-m", recipe.width_m,
                   "Width of the surface in the photograph, from its left to its right edge")
      ->required();
  command
      ->add_option("--gaussian-wavelength-m", recipe.gaussian_wavelength_m,
                   "Cut-off wavelength of the Gaussian low-pass whose result g is subtracted; "
                   "longer wavelengths are removed")
      ->capture_default_str();
  command
      ->add_option("--homomorphic-wavelength-m", recipe.homomorphic_wavelength_m,
                   "Cut-off wavelength of the homomorphic filter")
      ->capture_default_str();
  command
      ->add_option("--gamma-low", recipe.gamma_low,
                   "Gain of the homomorphic filter for long wavelengths")
      ->capture_default_str();
  command
      ->add_option("--gamma-high", recipe.gamma_high,
                   "Gain of the homomorphic filter for short wavelengths")
      ->capture_default_str();
  command
      ->add_option("--spectral-tilt", recipe.spectral_tilt,
                   "Exponent p, 0 to 1: amplitudes of wavelengths shorter than the cut-off of the "
                   "low-pass are multiplied by (wavelength/cut-off)^p; 0 is the published method")
      ->capture_default_str();
  command->add_option("--rms-m", recipe.rms_m, "RMS of the heights")->capture_default_str();
  command->add_option("--sign", options->sign, "1 (the default): bright is high; -1: dark is high")
      ->check(word_among({"1", "-1"}))
      ->option_text("1|-1");
  const std::map<std::string, HistogramTransformation> histograms{
      {"none", HistogramTransformation::none}, {"equalize", HistogramTransformation::equalize}};
  command->add_option("--histogram", recipe.histogram, "none (the default) or equalize")
      ->transform(word_of(histograms))
      ->option_text("none|equalize");
  command->add_option("--preview", options->preview, "PNG of the processing steps, for inspection");
  command->add_flag("--force", options->force, "Replace existing files");
  command->callback([options, &job] {
    job = [options] {
      TextureRecipe& chosen = options->recipe;
      chosen.sign = options->sign == 1 ? HeightSign::bright_is_high : HeightSign::dark_is_high;
      const Overwrite overwrite = options->force ? Overwrite::allow : Overwrite::refuse;
      require_png(options->out);
      if (options->preview) require_png(*options->preview);
      // Before the work; the files that go with it are looked at when they are written.
      refuse_existing({options->out}, overwrite);
      const std::string name = options->photograph.string();
      const LoadedPhotograph loaded = load_photograph(options->photograph);
      const PhotographTexture texture =
          texture_from_photograph(loaded.photograph.grey, chosen, name);
      std::vector<PictureFile> pictures{};
      if (options->preview) {
        pictures.push_back(picture_file(*options->preview, texture_steps(texture, kPreviewRows)));
      }
      save_height_field(options->out, texture.field,
                        {"photograph",
                         parameter_values(chosen),
                         {},
                         options->photograph.filename().string(),
                         loaded.sha256,
                         ""},
                        overwrite, pictures);
      const HeightField& field = texture.field;
      std::cout << options->out.string() << ": " << field.grid().columns << " × "
                << field.grid().rows << " samples, pitch " << fixed(field.grid().pitch_m * 1e6, 1)
                << " µm, height " << reading_signed(field.minimum_m() * 1e6, 1) << " to "
                << reading_signed(field.maximum_m() * 1e6, 1) << " µm, RMS "
                << fixed(field.rms_m() * 1e6, 1) << " µm\n"
                << advice(examine_photograph(loaded.photograph.grey, chosen, name)) << '\n';
      return 0;
    };
  });
}

}  // namespace asperity
