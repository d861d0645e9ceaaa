// asperity render: a force model along a given path.

#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/numbers/number_text.h"
#include "app/cli/command.h"
#include "app/cli/options/asset_option.h"
#include "app/cli/options/body_option.h"
#include "app/cli/options/compute_option.h"
#include "app/cli/options/model_option.h"
#include "app/cli/options/parameter_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/terminal.h"
#include "app/plugins/plugin_files.h"
#include "app/records/path_table.h"
#include "app/study_files/height_field_files.h"
#include "app/words/text_parts.h"
#ifdef ASPERITY_WITH_WINDOWS
#include "app/figures/figure_files.h"
#include "app/findings/shared/figures/column_figure.h"
#endif
#include "renderers/built_in_models.h"
#include "renderers/compute/compute_device.h"
#include "renderers/force/force_model.h"
#include "renderers/offline/along_path.h"
#include "renderers/proxy/body_surface.h"

namespace asperity {

namespace {

// Nobody holds the device: a row may take as long as a driver without a GPU needs.
constexpr std::chrono::minutes kPatience{10};

/// What the hand holds and what it touches, of a model that needs both.
void add_bodies(RendererInputs& inputs, const std::string& model, const BodyOption& surface,
                const std::optional<std::string>& tool) {
  if (!tool) {
    throw std::runtime_error(
        "the force model " + model +
        " needs a tool; give one with --tool FILE, sphere:D_m, disc:D_m or cylinder:D_m,L_m");
  }
  inputs.surface = load_body(surface);
  inputs.tool = load_body(body_option("--tool", *tool));
}

void add_height_field(RendererInputs& inputs, const ForceModel& model,
                      const std::filesystem::path& file) {
  inputs.height_field = load_height_field(file).field;
  if (!model.suggested_by) return;
  ParameterValues suggested = model.suggested_by(*inputs.height_field, inputs.material);
  for (const auto& [name, value] : inputs.parameters) suggested[name] = value;
  inputs.parameters = std::move(suggested);
}

/// What a point touches: the plane of a height field, or a body with or without a height field on it.
void add_surface_of_point(RendererInputs& inputs, const ForceModel& model,
                          const std::optional<BodyOption>& surface,
                          const std::optional<std::filesystem::path>& height_field) {
  const bool is_body = surface && !surface->is_plain_height_field();
  if (height_field && !is_body) {
    throw std::runtime_error(
        "--height-field is the texture of a body; give the body with --stimulus, or the height "
        "field as --stimulus FILE.png");
  }
  if (surface && !is_body) add_height_field(inputs, model, *surface->file);
  if (!is_body) return;
  if (model.declaration.needs_height_field && !height_field) {
    throw std::runtime_error("the force model " + model.declaration.id +
                             " needs a height field on the body " + surface->text +
                             "; give one with --height-field FILE.png");
  }
  inputs.body = std::make_shared<const BodySurface>(*load_body(*surface));
  if (height_field) add_height_field(inputs, model, *height_field);
}

void require_material(const Material& material) {
  if (!(material.stiffness_N_per_m > 0.0)) {
    throw WrongUsage("--stiffness-n-per-m is " + number_text(material.stiffness_N_per_m) +
                     "; it must be above 0 N/m");
  }
  if (!(material.friction >= 0.0)) {
    throw WrongUsage("--friction is " + number_text(material.friction) + "; it must be at least 0");
  }
}

#ifdef ASPERITY_WITH_WINDOWS
/// `--plot FILE`, with the columns of `--tool-out` that it shows.
struct RenderPlot {
  std::filesystem::path file{};
  std::string x = "time_s";
  std::string y = "fx_N,fy_N,fz_N";

  ColumnChoice columns() const { return {.x = x, .y = parts_of(y, ',')}; }
};

void require_plot(const RenderPlot& plot) {
  if (plot.file.empty()) return;
  try {
    require_figure_ending(plot.file);
    require_columns(tool_table({}, {}).columns, plot.columns());
  } catch (const std::invalid_argument& error) {
    throw WrongUsage(std::string("--plot: ") + error.what());
  }
}

void add_plot_options(CLI::App& command, RenderPlot& plot) {
  auto* file = command.add_option(
      "--plot", plot.file, "Also write a figure of columns of --tool-out, .svg, .png or .pdf");
  command.add_option("--plot-x", plot.x, "Column on the horizontal axis of the figure")
      ->capture_default_str()
      ->needs(file);
  command
      .add_option("--plot-y", plot.y,
                  "Columns on the vertical axis of the figure, C,C,…, with the same unit")
      ->capture_default_str()
      ->needs(file);
}
#endif

/// In how many of the ticks something was so that the force model does not promise anything for.
void tell_limits(const ForceModel& model, const ForceRenderer& renderer, std::size_t ticks) {
  for (const NamedCount& limit : renderer.limits()) {
    if (limit.ticks == 0 || limit.name == "contact") continue;
    std::cerr << limit.name << ", number of ticks: " << limit.ticks << " of " << ticks
              << "; see \"Counted conditions\" in docs/models/" << model.declaration.id << ".md\n";
    if (limit.name == "wholly_inside") {
      std::cerr << "In these ticks the tool is completely inside the surface, where it has no "
                   "force; begin the path outside the surface\n";
    }
  }
}

}  // namespace

void add_render(CLI::App& program, Job& job) {
  struct Options {
    std::string model{};
    std::vector<std::string> parameters{};
    std::vector<std::string> assets{};
    std::optional<std::string> stimulus{};
    std::optional<std::filesystem::path> height_field{};
    std::optional<std::string> tool{};
    std::optional<std::string> coupling{};
    std::optional<bool> on_gpu{};
    Material material{};
    std::uint64_t seed = 0;
    std::filesystem::path path{};
    std::filesystem::path out{};
    std::optional<std::filesystem::path> tool_out{};
#ifdef ASPERITY_WITH_WINDOWS
    RenderPlot plot{};
#endif
    bool force = false;
    std::vector<std::filesystem::path> plugins{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("render", "Evaluate a force model along a path, without a device.");
  command->add_option("--model", options->model, "A force model; see: asperity models")->required();
  command->add_option("--param", options->parameters, "Parameter of the model, NAME=VALUE");
  command->add_option("--asset", options->assets,
                      "File that the model needs, ROLE=FILE; see: asperity models");
  command->add_option("--stimulus", options->stimulus,
                      "A height field on a plane, which repeats endlessly: FILE.png or "
                      "plane:FILE.png. Or a body: a "
                      "textured mesh, or box:[FILE.png,]X_m,Y_m,Z_m, cylinder:[FILE.png,]D_m,L_m, "
                      "sphere:[FILE.png,]D_m, plane:[FILE.png,]X_m,Y_m");
  command->add_option("--height-field", options->height_field,
                      "Height field that a point model renders on the body of --stimulus");
  command->add_option(
      "--tool", options->tool,
      "Tool in the hand, for a model with two bodies: a textured mesh, sphere:D_m, disc:D_m, "
      "cylinder:D_m,L_m, or another shape of --stimulus. The path is that of the origin of the "
      "tool's frame: the centre of a shape, whereas in a protocol it is the tool's lowest point");
  command
      ->add_option("--coupling", options->coupling,
                   "For a model with two bodies. none (the default): the path is that of the tool; "
                   "virtual: that of the device, to which the tool is coupled")
      ->option_text("none|virtual")
      ->check(word_among({"none", "virtual"}));
  add_compute_option(*command, options->on_gpu,
                     "For a model with two bodies: where contacts are evaluated. cpu (the "
                     "default): on the processor; gpu: on the first OpenCL device, sampled again "
                     "in every row and in double precision");
  command
      ->add_option("--stiffness-n-per-m", options->material.stiffness_N_per_m,
                   "Stiffness of the surface, N/m")
      ->capture_default_str();
  command
      ->add_option("--friction", options->material.friction,
                   "Coulomb friction coefficient of the surface")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed for a model that draws random numbers")
      ->capture_default_str();
  command->add_option("--path", options->path, "Table of the probe's path (TSV)")->required();
  command->add_option("--out", options->out, "Table of the forces (TSV)")->required();
  command->add_option(
      "--tool-out", options->tool_out,
      "Also write a table of the tool's pose with its force and torque (TSV): with the virtual "
      "coupling the pose of the simulated tool, otherwise that of the path");
#ifdef ASPERITY_WITH_WINDOWS
  add_plot_options(*command, options->plot);
#endif
  command->add_flag("--force", options->force, "Replace existing files");
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    const auto run = [options] {
      const Overwrite overwrite = options->force ? Overwrite::allow : Overwrite::refuse;
      // Before the work; the files that go with it are looked at when they are written.
      refuse_existing({options->out}, overwrite);
#ifdef ASPERITY_WITH_WINDOWS
      require_plot(options->plot);
#endif
      require_material(options->material);
      ModelRegistry models = models_with(options->plugins);
      if (options->on_gpu.value_or(false)) {
        models = computed_on(first_compute(kPatience), std::move(models));
      }
      const ForceModel& model = model_named(models, options->model);
      RendererInputs inputs{};
      inputs.parameters =
          parameters_from(options->parameters, model.declaration.parameters, options->model);
      inputs.material = options->material;
      // A plane without end: the path is given, so no hand can leave it.
      inputs.patch.extent_m = {1e3, 1e3};
      inputs.patch.edge_width_m = 1e-3;
      inputs.seed = options->seed;
      const bool needs_bodies = model.declaration.needs_bodies;
      if (!needs_bodies && (options->tool || options->coupling)) {
        const std::string option = options->tool ? "--tool" : "--coupling";
        throw std::runtime_error("the force model " + options->model +
                                 " computes the contact at a point, and " + option +
                                 " needs a model with two bodies; leave out " + option +
                                 ", or choose another model");
      }
      if (!needs_bodies && options->on_gpu.value_or(false)) {
        throw std::runtime_error(
            "the force model " + options->model +
            " computes the contact at a point, and --compute gpu needs a model "
            "with two bodies; leave out --compute, or choose another model");
      }
      if (needs_bodies && !options->stimulus) {
        throw std::runtime_error("the force model " + options->model +
                                 " needs a surface; give one with --stimulus FILE or a shape");
      }
      if (needs_bodies && options->height_field) {
        throw std::runtime_error("the force model " + options->model +
                                 " takes the height field of a surface from --stimulus; leave out "
                                 "--height-field");
      }
      std::optional<BodyOption> surface{};
      if (options->stimulus) surface = body_option("--stimulus", *options->stimulus);
      if (needs_bodies) {
        add_bodies(inputs, options->model, *surface, options->tool);
        if (options->coupling && inputs.parameters.contains("coupling")) {
          throw std::runtime_error(
              "--coupling and --param coupling set the same parameter; give one of them");
        }
        inputs.parameters.try_emplace("coupling", options->coupling.value_or("none"));
      } else {
        add_surface_of_point(inputs, model, surface, options->height_field);
      }
      for (const std::string& text : options->assets) {
        add_asset(inputs, model.declaration, text);
      }
      const std::vector<ProbeState> path =
          path_in(read_file(options->path, kTableFile), options->path.string());
      if (const std::string warning = position_warning(path); !warning.empty()) {
        say("asperity: warning: " + options->path.string() + ": " + warning);
      }
      const auto renderer = make_renderer(model, inputs);
      const ToolAlongPath along = tool_along_path(*renderer, path, rate_Hz_of(path));
      if (!renderer->error().empty()) {
        throw std::runtime_error("the force model " + options->model + " failed on this path: " +
                                 std::string(renderer->error()) + "; correct its plug-in");
      }
      if (model.compute) {
        std::cerr << "Computed by " << described(model.compute->device.name()) << ".\n";
      }
      std::vector<NewFile> files{};
      const auto with_tool = [&] { return tool_table(path, along); };
      if (options->tool_out) files.push_back({*options->tool_out, tsv_of(with_tool())});
#ifdef ASPERITY_WITH_WINDOWS
      if (const RenderPlot& plot = options->plot; !plot.file.empty()) {
        const LettersWithoutWindows letters;
        const Figure figure = column_figure(with_tool(), plot.columns());
        files.push_back({plot.file, figure_bytes(plot.file, figure)});
      }
#endif
      files.push_back({options->out, forces_tsv(path, along.ticks)});
      write_files_or_refuse(files, overwrite);
      std::cout << options->out.string() << ": " << counted(along.ticks.size(), "row") << '\n';
      if (options->tool_out) {
        std::cout << options->tool_out->string() << ": " << counted(along.tools.size(), "row")
                  << '\n';
      }
      tell_limits(model, *renderer, along.ticks.size());
      return 0;
    };
    job = watched_with(options->plugins, with_lasting_effect(run));
  });
}

}  // namespace asperity
