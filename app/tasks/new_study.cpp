#include "app/tasks/new_study.h"

#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/height_field_files.h"
#include "protocols/library_protocols.h"
#include "results_schema/study.h"
#include "stimuli/synthetic_photograph.h"
#include "stimuli/synthetic_surface.h"
#include "stimuli/texture_from_photograph.h"

namespace asperity {

namespace {

/// A texture of the demonstration. What is seen only, as a distractor, has no rendered counterpart.
struct DemoTexture {
  std::string_view name{};
  std::string_view kind{};
  bool is_rendered = true;
  std::uint64_t seed = 0;
  ParameterValues parameters{};
};

/// Pebbles are made as grains are, close together, but of 4 mm: a stroke along any line meets them.
std::vector<DemoTexture> demo_textures() {
  return {
      {"metal", "metal", true, 11, {}},
      {"stone", "stone", true, 12, {}},
      {"wood", "wood", true, 13, {}},
      {"brick", "brick", true, 14, {}},
      {"sandpaper", "sandpaper", false, 15, {}},
      {"pebbles", "sandpaper", false, 16, {{"grain_spacing_m", 0.004}, {"grain_height_m", 6e-4}}}};
}

constexpr double kWidth_m = 0.10;
constexpr std::size_t kPixels = 1024;

void make_texture(const DemoTexture& texture, const std::filesystem::path& folder) {
  const std::string name(texture.name);
  const HeightField surface = make_surface(texture.kind, texture.parameters,
                                           SurfaceCanvas{kWidth_m, kPixels, texture.seed});
  HeightFieldProvenance made{};
  made.kind = texture.kind;
  made.parameters = texture.parameters;
  made.seed = texture.seed;
  save_height_field(folder / (name + "_true.png"), surface, made, Overwrite::refuse);

  PhotographSettings settings{};
  settings.seed = texture.seed;
  settings.noise_rms = 0.01;
  const std::filesystem::path photograph_file = folder / (name + "_photo.png");
  save_picture(photograph_file, synthetic_photograph(surface, settings), Overwrite::refuse);
  if (!texture.is_rendered) return;

  // From here on only the picture is known, but for its width and the amplitude of the relief,
  // which no photograph can tell.
  const LoadedPhotograph loaded = load_photograph(photograph_file);
  TextureRecipe recipe{};
  recipe.width_m = kWidth_m;
  recipe.rms_m = without_long_wavelengths(surface, recipe.gaussian_wavelength_m).rms_m();
  const PhotographTexture recovered =
      texture_from_photograph(loaded.photograph.grey, recipe, photograph_file.filename().string());
  HeightFieldProvenance provenance{};
  provenance.kind = "photograph";
  provenance.parameters = parameter_values(recipe);
  provenance.source_name = photograph_file.filename().string();
  provenance.source_sha256 = loaded.sha256;
  save_height_field(folder / (name + ".png"), recovered.field, provenance, Overwrite::refuse);
}

}  // namespace

void new_study(const std::filesystem::path& folder) {
  Study::create(folder, folder.filename().string());
}

void new_demo_study(const std::filesystem::path& folder,
                    const std::function<void(double)>& progress) {
  new_study(folder);
  for (const LibraryProtocol& protocol : library_protocols()) {
    // What the demo data come from, and a session that shows what goes without sight.
    if (!protocol.name.starts_with("chapter_") && protocol.name != "improved_selection_blindfold") {
      continue;
    }
    write_file(folder / "protocols" / (std::string(protocol.name) + ".json"), protocol.text,
               Overwrite::refuse);
  }
  const std::vector<DemoTexture> textures = demo_textures();
  for (std::size_t i = 0; i < textures.size(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(textures.size()));
    make_texture(textures[i], folder / "stimuli");
  }
  progress(1.0);
}

bool holds_demo_study(const std::filesystem::path& folder) {
  std::error_code ignored{};
  if (!std::filesystem::is_regular_file(folder / "study.sqlite", ignored)) return false;
  for (const LibraryProtocol& protocol : library_protocols()) {
    if (!protocol.name.starts_with("chapter_")) continue;
    if (!std::filesystem::is_regular_file(
            folder / "protocols" / (std::string(protocol.name) + ".json"), ignored)) {
      return false;
    }
  }
  for (const DemoTexture& texture : demo_textures()) {
    const std::string last = std::string(texture.name) + (texture.is_rendered ? "" : "_photo");
    if (!std::filesystem::is_regular_file(folder / "stimuli" / (last + ".png"), ignored)) {
      return false;
    }
  }
  return true;
}

}  // namespace asperity
