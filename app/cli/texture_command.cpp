// asperity texture: a photograph or a measured surface becomes a height field.

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/numbers/number_text.h"
#include "app/cli/command.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/png_name.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/height_field_line.h"
#include "app/cli/output/terminal.h"
#include "app/findings/outcome/display_number.h"
#include "app/study_files/height_field_files.h"
#include "app/words/text_parts.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "stimuli/measured/measured_surface.h"
#include "stimuli/measured/normal_map.h"
#include "stimuli/measured/surface_relief.h"
#include "stimuli/photographs/photograph_advice.h"
#include "stimuli/photographs/preview.h"
#include "stimuli/photographs/texture_from_photograph.h"
#include "stimuli/photographs/texture_method.h"

namespace asperity {

namespace {

constexpr std::size_t kPreviewRows = 320;

struct TextureOptions {
  std::filesystem::path file{};
  std::filesystem::path out{};
  std::optional<double> width_m{};
  bool force = false;
  // of a photograph
  std::optional<std::filesystem::path> preview{};
  TextureRecipe recipe{};
  int sign = 1;
  std::optional<double> light_azimuth_deg{};
  std::vector<const CLI::Option*> for_light{};
  // of a measured surface
  SurfaceReading reading{};
  SurfaceForm form = SurfaceForm::plane;
  // of a material scan
  std::optional<std::filesystem::path> normals{};
  std::optional<NormalConvention> convention{};
  std::optional<double> height_range_m{};
  ScanRecipe scan{};
  // those that the other kinds of file do not have
  std::vector<const CLI::Option*> for_photographs{};
  std::vector<const CLI::Option*> for_surfaces{};
  std::vector<const CLI::Option*> for_scans{};

  Overwrite overwrite() const { return force ? Overwrite::allow : Overwrite::refuse; }
};

/// Errors: WrongUsage for an option of the other kind of file.
void refuse_given(const std::vector<const CLI::Option*>& options, const std::string& reason) {
  for (const CLI::Option* option : options) {
    if (option->count() > 0) throw WrongUsage(option->get_name() + ": " + reason);
  }
}

void warn_of_pages(bool has_further_pages, const std::string& name) {
  if (!has_further_pages) return;
  say("asperity: warning: " + name +
      ": the file has further pages, and only the first is read; save the page that is meant "
      "alone");
}

void warn_of_missing_points(const std::optional<float>& no_data, const std::string& name) {
  if (!no_data) return;
  say("asperity: warning: " + name + ": the file states " + number_text(*no_data) +
      " as the value of missing points, and a photograph has none: they are read as brightness");
}

/// Warns where the maps of a scan do not agree around the crossover, with the probable reason.
void warn_of_disagreement(const FusedRelief& relief, const TextureOptions& options) {
  const std::string maps = options.file.string() + " and " + options.normals->string();
  constexpr double kUnrelated = 0.3;
  if (std::max(relief.agreement, relief.agreement_of_other_convention) < kUnrelated) {
    say("asperity: warning: " + maps +
        ": the maps do not agree (correlation around the crossover " + fixed(relief.agreement, 2) +
        "); check that both show the same surface in the same orientation");
  } else if (relief.agreement_of_other_convention > relief.agreement) {
    const NormalConvention other = *options.convention == NormalConvention::opengl
                                       ? NormalConvention::directx
                                       : NormalConvention::opengl;
    say("asperity: warning: " + maps + ": the maps agree better with --normals-convention " +
        name_of(other) + " (correlation around the crossover " +
        fixed(relief.agreement_of_other_convention, 2) + " in place of " +
        fixed(relief.agreement, 2) + "); check the source of the normal map");
  }
  constexpr double kUnequal = 2.0;
  if (relief.amplitude_ratio > kUnequal || relief.amplitude_ratio < 1.0 / kUnequal) {
    say("asperity: warning: " + maps + ": around the crossover, the heights from the normals are " +
        fixed(relief.amplitude_ratio, 2) +
        " times those of the displacement map; check --width-m and --height-range-m");
  }
}

void texture_of_scan(TextureOptions& options, std::span<const std::byte> bytes,
                     const std::string& sha256) {
  const std::string name = options.file.string();
  const std::string reason =
      "--normals is given, with which " + name + " is a displacement map; leave out this option";
  refuse_given(options.for_photographs, reason);
  refuse_given(options.for_surfaces, reason);
  if (!options.width_m) {
    throw WrongUsage("--width-m is missing: give the width of the surface in " + name);
  }
  if (!options.height_range_m) {
    throw WrongUsage("--height-range-m is missing: give the height from black to white in " + name);
  }
  if (!options.convention) {
    throw WrongUsage(
        "--normals-convention is missing: write opengl if green increases upwards in " +
        options.normals->string() + ", directx if it increases downwards");
  }
  ScanRecipe& recipe = options.scan;
  recipe.width_m = *options.width_m;
  recipe.height_range_m = *options.height_range_m;
  recipe.convention = *options.convention;
  const std::string normals = read_file(*options.normals, kPictureFile);
  const std::string normals_name = options.normals->string();
  const FusedRelief relief =
      fused_relief(decode_photograph(bytes, name).grey,
                   decode_color_picture(std::as_bytes(std::span(normals)), normals_name), recipe,
                   name, normals_name);
  ParameterValues parameters = parameter_values(recipe);
  parameters["normals_name"] = options.normals->filename().string();
  parameters["normals_sha256"] = sha256_of(normals);
  save_height_field(options.out, relief.field,
                    {"material_scan", parameters, {}, options.file.filename().string(), sha256, ""},
                    options.overwrite());
  std::cout << height_field_line(options.out, relief.field) << "Around the crossover of "
            << number_text(recipe.crossover_wavelength_m * 1e3)
            << " mm: correlation of the two maps " << fixed(relief.agreement, 2)
            << ", amplitude ratio " << fixed(relief.amplitude_ratio, 2) << '\n';
  warn_of_disagreement(relief, options);
}

/// Errors: WrongUsage where the method needs the direction of the light, or does not use it.
void take_light(TextureOptions& options) {
  const bool uses_light = texture_method(options.recipe.method).uses_light;
  if (!uses_light) {
    refuse_given(options.for_light, "the method " + options.recipe.method +
                                        " does not use the light; leave out this option, or "
                                        "choose the method pentland or tsai_shah");
    return;
  }
  if (!options.light_azimuth_deg) {
    throw WrongUsage("--light-azimuth-deg is missing: the method " + options.recipe.method +
                     " needs the direction of the light source, in degrees counterclockwise from "
                     "the right of the picture");
  }
  options.recipe.light_azimuth_deg = *options.light_azimuth_deg;
}

void texture_of_photograph(TextureOptions& options, std::span<const std::byte> bytes,
                           const std::string& sha256) {
  const std::string name = options.file.string();
  // Before advice about options of a file that cannot be read in any way.
  const PictureFacts facts = inspect_picture(bytes, name);
  warn_of_pages(facts.has_further_pages, name);
  warn_of_missing_points(facts.no_data, name);
  refuse_given(options.for_surfaces, name + " is not a measured surface; leave out this option");
  refuse_given(options.for_scans,
               "--normals is missing; give the normal map, or leave out this "
               "option");
  if (!options.width_m) {
    throw WrongUsage("--width-m is missing: give the width of the surface in the photograph " +
                     name + ", from its left to its right edge");
  }
  TextureRecipe& recipe = options.recipe;
  recipe.width_m = *options.width_m;
  recipe.sign = options.sign == 1 ? HeightSign::bright_is_high : HeightSign::dark_is_high;
  take_light(options);
  const GreyImage grey = decode_photograph(bytes, name).grey;
  const PhotographTexture texture = texture_from_photograph(grey, recipe, name);
  std::vector<PictureFile> pictures{};
  if (options.preview) {
    pictures.push_back(picture_file(*options.preview, texture_steps(texture, kPreviewRows)));
  }
  save_height_field(
      options.out, texture.field,
      {"photograph", parameter_values(recipe), {}, options.file.filename().string(), sha256, ""},
      options.overwrite(), pictures);
  const PhotographEvidence evidence = examine_photograph(grey, recipe, name);
  std::cout << height_field_line(options.out, texture.field);
  // The advice is about brightness as height, and a method that uses the light answers the question about it.
  if (!texture_method(recipe.method).uses_light) {
    for (const std::string& text :
         {advice(evidence).english(), recommendation_text(evidence, recipe)}) {
      std::cout << wrapped_text(text, kTerminalColumns) << '\n';
    }
  }
  if (const auto contradiction = contradiction_of_sign(evidence, recipe)) {
    say("asperity: warning: " + name + ": " + contradiction_text(*contradiction, evidence));
  }
}

void texture_of_surface(const TextureOptions& options, std::span<const std::byte> bytes,
                        const std::string& sha256) {
  const std::string name = options.file.string();
  refuse_given(options.for_photographs, name + " is a measured surface; leave out this option");
  refuse_given(options.for_scans, name + " is a measured surface; leave out this option");
  SurfaceReading reading = options.reading;
  reading.width_m = options.width_m;
  const MeasuredSurface surface = decode_surface(bytes, reading, name);
  warn_of_pages(surface.has_further_pages, name);
  const SurfaceRelief relief = surface_relief(surface, options.form, name);
  save_height_field(options.out, relief.field,
                    {"measured_surface",
                     parameter_values(surface, options.form, relief),
                     {},
                     options.file.filename().string(),
                     sha256,
                     ""},
                    options.overwrite());
  std::ostringstream facts{};
  facts << name_of(surface.format);
  if (!surface.channel.empty()) facts << ", channel " << surface.channel;
  facts << ": " << relief.missing << " of " << relief.points << " points missing and filled ("
        << fixed(100.0 * static_cast<double>(relief.missing) / static_cast<double>(relief.points),
                 2)
        << " %); ";
  if (options.form == SurfaceForm::plane) {
    facts << "plane subtracted, slope " << display_signed(relief.slope_x * 1e3, 2)
          << " µm/mm along x and " << display_signed(relief.slope_y * 1e3, 2) << " µm/mm along y";
  } else {
    facts << "mean subtracted";
  }
  if (relief.is_resampled) {
    facts << "; resampled from distances of " << fixed(surface.pitch_x_m * 1e6, 3)
          << " µm along x and " << fixed(surface.pitch_y_m * 1e6, 3) << " µm along y";
  }
  std::cout << height_field_line(options.out, relief.field)
            << wrapped_text(facts.str(), kTerminalColumns) << '\n';
}

}  // namespace

void add_texture(CLI::App& program, Job& job) {
  auto options = std::make_shared<TextureOptions>();
  TextureRecipe& recipe = options->recipe;
  CLI::App* command = program.add_subcommand(
      "texture",
      "Compute a height field from a photograph (conversion to greyscale, homomorphic filter, "
      "subtraction of the low-pass, f − g), or from a measured surface (subtraction of the plane, "
      "filling of missing points).");
  command
      ->add_option("FILE", options->file,
                   "A photograph (PNG, JPEG, TIFF, BMP or WebP), or a measured surface (X3P, SUR, "
                   "GWY, or TIFF of 32-bit floating-point numbers); recognised by its content")
      ->required();
  command
      ->add_option("--out", options->out,
                   "The height field, FILE.png (its sidecar is FILE.png.json)")
      ->required();
  command->add_option("--width-m", options->width_m,
                      "Width of the surface in a photograph or a TIFF, from its left to its right "
                      "edge; required for both");
  const auto photographs = [&](CLI::Option* option) {
    options->for_photographs.push_back(option->group("Photographs"));
    return option;
  };
  const auto surfaces = [&](CLI::Option* option) {
    options->for_surfaces.push_back(option->group("Measured surfaces"));
    return option;
  };
  const auto scans = [&](CLI::Option* option) {
    options->for_scans.push_back(option->group("Material scans"));
    return option;
  };
  std::vector<std::string> methods{};
  std::string summaries{};
  std::string words{};
  for (const TextureMethod& method : texture_methods()) {
    methods.push_back(method.id);
    summaries += (summaries.empty() ? "" : "; ") + method.id + ": " + method.summary.english();
    words += (words.empty() ? "" : "|") + method.id;
  }
  photographs(command
                  ->add_option("--method", recipe.method,
                               "How brightness becomes a relief; wu is the default. " + summaries)
                  ->check(word_among(methods))
                  ->option_text(words));
  options->for_light.push_back(photographs(command->add_option(
      "--light-azimuth-deg", options->light_azimuth_deg,
      "For pentland and tsai_shah, required: direction of the light source, counterclockwise; 0 "
      "is the right of the picture, 90 the top")));
  options->for_light.push_back(
      photographs(command
                      ->add_option("--light-elevation-deg", recipe.light_elevation_deg,
                                   "For pentland and tsai_shah: height of the light source above "
                                   "the surface, 10 to 70")
                      ->capture_default_str()));
  photographs(
      command
          ->add_option("--gaussian-wavelength-m", recipe.gaussian_wavelength_m,
                       "Cut-off wavelength of the Gaussian low-pass whose result g is subtracted; "
                       "longer wavelengths are removed")
          ->capture_default_str());
  photographs(command
                  ->add_option("--homomorphic-wavelength-m", recipe.homomorphic_wavelength_m,
                               "Cut-off wavelength of the homomorphic filter")
                  ->capture_default_str());
  photographs(command
                  ->add_option("--gamma-low", recipe.gamma_low,
                               "Gain of the homomorphic filter for long wavelengths")
                  ->capture_default_str());
  photographs(command
                  ->add_option("--gamma-high", recipe.gamma_high,
                               "Gain of the homomorphic filter for short wavelengths")
                  ->capture_default_str());
  photographs(
      command
          ->add_option("--spectral-tilt", recipe.spectral_tilt,
                       "Exponent p, 0 to 1: amplitudes of wavelengths shorter than the cut-off of "
                       "the low-pass are multiplied by (wavelength/cut-off)^p; 0 is the published "
                       "method")
          ->capture_default_str());
  photographs(
      command->add_option("--rms-m", recipe.rms_m, "RMS of the heights")->capture_default_str());
  photographs(
      command
          ->add_option("--sign", options->sign, "1 (the default): bright is high; -1: dark is high")
          ->check(word_among({"1", "-1"}))
          ->option_text("1|-1"));
  const std::map<std::string, HistogramTransformation> histograms{
      {"none", HistogramTransformation::none}, {"equalize", HistogramTransformation::equalize}};
  photographs(command->add_option("--histogram", recipe.histogram, "none (the default) or equalize")
                  ->transform(word_of(histograms))
                  ->option_text("none|equalize"));
  photographs(command->add_option("--preview", options->preview,
                                  "PNG of the processing steps, for inspection"));
  surfaces(command->add_option("--height-unit-m", options->reading.height_unit_m,
                               "Height of the stored number 1 of a TIFF, such as 1e-6 for heights "
                               "in µm; required for it"));
  const std::map<std::string, SurfaceForm> forms{{"plane", SurfaceForm::plane},
                                                 {"mean", SurfaceForm::mean}};
  surfaces(command
               ->add_option("--form", options->form,
                            "What is subtracted from the heights: plane (the default), the "
                            "least-squares plane of the measured points, or mean")
               ->transform(word_of(forms))
               ->option_text("plane|mean"));
  surfaces(command
               ->add_option("--channel", options->reading.channel,
                            "Number of the channel of a GWY file; without it, the first channel "
                            "with heights in metres")
               ->check(number_within(0, 9999)));
  scans(command->add_option("--normals", options->normals,
                            "Normal map of the same surface; FILE is then a displacement map, "
                            "which gives the long waves, and the normals give the short ones"));
  const std::map<std::string, NormalConvention> conventions{{"opengl", NormalConvention::opengl},
                                                            {"directx", NormalConvention::directx}};
  scans(command
            ->add_option("--normals-convention", options->convention,
                         "Direction in which green increases in the normal map: opengl, upwards; "
                         "directx, downwards; required for it")
            ->transform(word_of(conventions))
            ->option_text("opengl|directx"));
  scans(command->add_option("--height-range-m", options->height_range_m,
                            "Height from black to white in the displacement map; required for it"));
  scans(command
            ->add_option("--crossover-wavelength-m", options->scan.crossover_wavelength_m,
                         "Longer waves are those of the displacement map, shorter ones those of "
                         "the normals")
            ->capture_default_str());
  command->add_flag("--force", options->force, "Replace existing files");
  command->callback([options, &job] {
    job = [options] {
      require_png(options->out);
      if (options->preview) require_png(*options->preview);
      // Before the work; the files that go with it are looked at when they are written.
      refuse_existing({options->out}, options->overwrite());
      const std::string content = read_file(options->file, kPictureFile);
      const std::span<const std::byte> bytes = std::as_bytes(std::span(content));
      if (options->normals) {
        texture_of_scan(*options, bytes, sha256_of(content));
      } else if (surface_format_of(bytes, options->file.string())) {
        texture_of_surface(*options, bytes, sha256_of(content));
      } else {
        texture_of_photograph(*options, bytes, sha256_of(content));
      }
      return 0;
    };
    job = with_lasting_effect(job);
  });
}

}  // namespace asperity
