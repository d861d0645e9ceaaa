// asperity synth: known surfaces from formulas, and their "photographs".

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "analysis/numbers/number_text.h"
#include "app/cli/command.h"
#include "app/cli/options/parameter_option.h"
#include "app/cli/options/png_name.h"
#include "app/cli/output/height_field_line.h"
#include "app/cli/output/terminal.h"
#include "app/findings/outcome/display_number.h"
#include "app/study_files/height_field_files.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/synthetic_photograph.h"

namespace asperity {

namespace {

PhotographCase photograph_case(const std::string& word) {
  if (word == "bright_height") return PhotographCase::bright_height;
  if (word == "lambert") return PhotographCase::lambert;
  if (word == "albedo") return PhotographCase::albedo;
  throw WrongUsage("--photo takes bright_height, lambert or albedo, not \"" + word + '"');
}

}  // namespace

void add_synth(CLI::App& program, Job& job) {
  struct Options {
    std::string kind{};
    std::filesystem::path out{};
    std::vector<std::string> parameters{};
    SurfaceCanvas canvas{};
    std::vector<std::string> photograph{};
    bool force = false;
  };
  auto options = std::make_shared<Options>();
  std::string kinds{};
  std::string footer{};
  for (const SurfaceDeclaration& surface : synthetic_surfaces()) {
    kinds += (kinds.empty() ? "" : " ") + surface.kind;
    footer +=
        surface.kind + ": " + surface.summary.english() + '\n' + described(surface.parameters);
  }
  CLI::App* command = program.add_subcommand("synth", "Generate a surface with known heights.");
  command->footer("Kinds and their parameters\n" + footer);
  command->add_option("KIND", options->kind, "One of: " + kinds)->required();
  command
      ->add_option("--out", options->out,
                   "The height field, FILE.png (its sidecar is FILE.png.json)")
      ->required();
  command->add_option("--param", options->parameters, "Parameter of the kind, NAME=VALUE");
  const std::vector<Parameter> canvas = canvas_parameters();
  command->add_option("--width-m", options->canvas.width_m, canvas[0].meaning.english())
      ->capture_default_str();
  command->add_option("--pixels", options->canvas.pixels, canvas[1].meaning.english())
      ->capture_default_str();
  command->add_option("--seed", options->canvas.seed, canvas[2].meaning.english())
      ->capture_default_str();
  command
      ->add_option("--photo", options->photograph,
                   "Also write a synthetic photograph of the surface: bright_height, lambert or "
                   "albedo, and FILE.png")
      ->expected(2);
  command->add_flag("--force", options->force, "Replace existing files");
  command->callback([options, &job] {
    job = [options] {
      const std::vector<SurfaceDeclaration> surfaces = synthetic_surfaces();
      const auto surface = std::find_if(
          surfaces.begin(), surfaces.end(),
          [&](const SurfaceDeclaration& candidate) { return candidate.kind == options->kind; });
      if (surface == surfaces.end()) {
        std::string sentence =
            "there is no kind of surface \"" + options->kind + "\"; choose one of:";
        for (const SurfaceDeclaration& candidate : surfaces) sentence += ' ' + candidate.kind;
        throw std::runtime_error(sentence);
      }
      const ParameterValues values =
          parameters_from(options->parameters, surface->parameters, surface->kind);
      const Overwrite overwrite = options->force ? Overwrite::allow : Overwrite::refuse;
      std::optional<PhotographSettings> photograph{};
      if (!options->photograph.empty()) {
        photograph.emplace();
        photograph->photograph_case = photograph_case(options->photograph[0]);
        photograph->seed = options->canvas.seed;
        require_png(options->photograph[1]);
      }
      require_png(options->out);
      // Before the work; the files that go with it are looked at when they are written.
      refuse_existing({options->out}, overwrite);
      const HeightField field = make_surface(surface->kind, values, options->canvas);
      std::vector<PictureFile> pictures{};
      if (photograph) {
        pictures.push_back(
            picture_file(options->photograph[1], synthetic_photograph(field, *photograph)));
      }
      save_height_field(options->out, field,
                        {surface->kind, values, options->canvas.seed, "", "", ""}, overwrite,
                        pictures);
      std::cout << height_field_line(options->out, field);
      const auto warn = [&](const auto& warning, const char* option) {
        if (!warning) return;
        say("asperity: warning: " + options->out.string() + ": " + text_of(*warning).english() +
            " (" + option + ')');
      };
      warn(seam_of(surface->kind, values, options->canvas), "--width-m");
      warn(coarse_samples_of(surface->kind, values, options->canvas), "--pixels");
      return 0;
    };
    job = with_lasting_effect(job);
  });
}

}  // namespace asperity
