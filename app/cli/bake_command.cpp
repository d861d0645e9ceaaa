// asperity bake: a mesh becomes a simple one with a haptic texture.

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/cli/command.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/terminal.h"
#include "app/tasks/bake_mesh.h"

namespace asperity {

namespace {

void print_json(const BakeOutcome& outcome, double wall_s) {
  const BakeReport& report = outcome.report;
  const nlohmann::ordered_json json{{"format", "asperity.bake/1"},
                                    {"triangles_in", outcome.triangles_in},
                                    {"triangles_out", outcome.triangles_out},
                                    {"error_rms_m", report.plain.rms_m},
                                    {"error_max_m", report.plain.max_m},
                                    {"textured_error_rms_m", report.textured.rms_m},
                                    {"textured_error_max_m", report.textured.max_m},
                                    {"wall_s", wall_s},
                                    {"diagonal_m", outcome.diagonal_m},
                                    {"atlas_rows", outcome.atlas_rows},
                                    {"atlas_columns", outcome.atlas_columns},
                                    {"displacement_step_m", outcome.step_m},
                                    {"finest_pitch_m", report.finest_pitch_m},
                                    {"coarsest_pitch_m", report.coarsest_pitch_m},
                                    {"samples_per_wavelength", report.samples_per_wavelength},
                                    {"samples", report.samples},
                                    {"samples_missed", report.missed},
                                    {"folded_faces", report.folded_faces},
                                    {"findings", outcome.findings}};
  std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void print_text(const BakeOutcome& outcome, const std::string& out) {
  const BakeReport& report = outcome.report;
  const auto micrometres = [](double length_m) { return fixed(length_m * 1e6, 1) + " µm"; };
  for (const std::string& finding : outcome.findings) std::cout << finding << '\n';
  std::cout
      << out << ": " << outcome.triangles_in << " → " << outcome.triangles_out
      << " triangles, bounding-box diagonal " << fixed(outcome.diagonal_m * 1e3, 1) << " mm\n"
      << "Distance from the original without texture: RMS " << micrometres(report.plain.rms_m)
      << ", at most " << micrometres(report.plain.max_m) << '\n'
      << "Distance from the original with texture: RMS " << micrometres(report.textured.rms_m)
      << ", at most " << micrometres(report.textured.max_m) << '\n'
      << "Texture: " << outcome.atlas_columns << " × " << outcome.atlas_rows << " texels, pitch "
      << micrometres(report.finest_pitch_m) << " to " << micrometres(report.coarsest_pitch_m)
      << ", " << fixed(report.samples_per_wavelength, 1)
      << " or more samples per shortest wavelength of the original, displacements in steps of "
      << fixed(outcome.step_m * 1e9, 1) << " nm\n";
  if (report.missed > 0) {
    std::cout << "Samples whose ray hit no surface, filled in from their neighbours: "
              << report.missed << " of " << report.samples << '\n';
  }
  if (report.folded_faces > 0) {
    std::cout << "Faces folded so sharply that their texture is unreliable: " << report.folded_faces
              << "; increase --triangles\n";
  }
}

}  // namespace

void add_bake(CLI::App& program, Job& job) {
  struct Options {
    BakeOrder order{};
    bool force = false;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  BakeOrder& order = options->order;
  order.jobs = std::clamp(std::thread::hardware_concurrency(), 1U, 256U);
  CLI::App* command = program.add_subcommand(
      "bake", "Convert a detailed mesh to a simplified mesh with a haptic texture.");
  command->add_option("MESH", order.mesh, "OBJ, PLY, STL or OFF")->required();
  command
      ->add_option(
          "--triangles", order.triangles,
          "Maximum number of triangles of the simplified mesh; 500 to 750 suit rendering with "
          "six degrees of freedom")
      ->required()
      ->check(number_within(4, 1'000'000));
  command->add_option("--out", order.out, "The textured mesh")->required();
  command->add_option("--unit-m", order.reading.unit_m, "Length of one unit of MESH, in metres")
      ->capture_default_str();
  command->add_option(
      "--fill-holes-m", order.widest_hole_m,
      "Widest hole that is closed (default: a tenth of the diagonal of the bounding box)");
  const std::map<std::string, BodyRole> kRoles{{"surface", BodyRole::surface},
                                               {"tool", BodyRole::tool}};
  command
      ->add_option("--for", order.role,
                   "Move the mesh to where a surface or a tool is expected: its centre over the "
                   "origin, the highest point of a surface or the lowest point of a tool in the "
                   "plane z = 0 (default: the mesh is not moved)")
      ->transform(word_of(kRoles))
      ->option_text("surface|tool");
  command->add_option("--jobs", order.jobs, "Number of threads; does not affect the result")
      ->check(number_within(1, 256));
  command->add_flag("--json", options->json, "Print the numbers as JSON");
  command->add_flag("--force", options->force, "Replace an existing file");
  command->callback([options, &job] {
    job = [options] {
      BakeOrder& chosen = options->order;
      chosen.overwrite = options->force ? Overwrite::allow : Overwrite::refuse;
      const auto start = std::chrono::steady_clock::now();
      BakeOutcome outcome{};
      {
        Progress progress("baking");
        outcome = bake_mesh(chosen, [&progress](double fraction) { progress.show(fraction); });
      }
      const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
      if (options->json) {
        print_json(outcome, wall.count());
      } else {
        print_text(outcome, chosen.out.string());
      }
      return 0;
    };
    job = with_lasting_effect(job);
  });
}

}  // namespace asperity
