// Writes the command lines that do the same as actions of the windows.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/exports/export_options.h"
#include "app/tasks/rendering_use.h"
#include "app/tasks/run_session.h"
#include "app/tasks/simulation/simulation.h"
#include "stimuli/heights/surface_declaration.h"
#include "stimuli/photographs/texture_recipe.h"

namespace asperity {

// Each line is made from the values that the action uses, and gives the same result in a shell, in any folder: paths are
// words of a shell. `plugins`: the files that the study was opened with.

std::string check_line(const std::filesystem::path& protocol, const std::filesystem::path& study,
                       const std::vector<std::filesystem::path>& plugins);
/// The number of sessions that run in parallel, which does not affect the results, is left out.
std::string simulate_line(const SimulationInputs& inputs,
                          const std::vector<std::filesystem::path>& plugins);
/// At a terminal, which asks for the consent and the questions about a new participant.
std::string run_line(const RunInputs& inputs, const std::vector<std::filesystem::path>& plugins);
/// `protocol`: its name; without one, of all protocols.
std::string analyze_line(const std::filesystem::path& study,
                         const std::optional<std::string>& protocol);
/// `out`: the PNG. Values of the canvas and of the kind are left out where they are the defaults.
std::string synth_line(const std::string& kind, const ParameterValues& given,
                       const SurfaceCanvas& canvas, const std::filesystem::path& out);
/// `out`: the PNG. Values that are the defaults are left out.
std::string texture_line(const std::filesystem::path& photograph, const TextureRecipe& recipe,
                         const std::filesystem::path& out);
/// `stimulus`, `stimuli`: files. `name`: without its ending.
std::string rename_stimulus_line(const std::filesystem::path& stimulus, const std::string& name);
std::string delete_stimulus_line(const std::filesystem::path& stimulus);
std::string copy_stimuli_line(const std::vector<std::filesystem::path>& stimuli,
                              const std::filesystem::path& study);
/// Replaces the protocol's file, without the changes that are not saved.
std::string use_rendering_line(const std::filesystem::path& rendering,
                               const std::filesystem::path& protocol, const RenderingPlace& place,
                               const std::vector<std::filesystem::path>& plugins);
/// What `power_line` states.
struct PowerLine {
  std::filesystem::path protocol{};
  int participants = 20;
  std::uint64_t seed = 1;
  std::int64_t runs = 1000;
  std::vector<std::pair<std::string, double>> effects{};  ///< by name
  std::vector<std::pair<std::string, double>> assumed{};
};
std::string power_line(const PowerLine& power, const std::vector<std::filesystem::path>& plugins);
std::string report_line(const std::filesystem::path& study, const std::filesystem::path& out);
std::string export_line(const std::filesystem::path& study, const std::filesystem::path& out,
                        const ExportOptions& options);

}  // namespace asperity
