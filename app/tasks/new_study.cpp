#include "app/tasks/new_study.h"

#include <array>
#include <string>
#include <string_view>

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
};

constexpr std::array kDemoTextures{DemoTexture{"metal", "metal", true, 11},
                                   DemoTexture{"stone", "stone", true, 12},
                                   DemoTexture{"wood", "wood", true, 13},
                                   DemoTexture{"brick", "brick", true, 14},
                                   DemoTexture{"sandpaper", "sandpaper", false, 15},
                                   DemoTexture{"pebbles", "cones", false, 16}};

constexpr double kWidth_m = 0.10;
constexpr std::size_t kPixels = 1024;

void make_texture(const DemoTexture& texture, const std::filesystem::path& folder) {
  const std::string name(texture.name);
  const HeightField surface =
      make_surface(texture.kind, {}, SurfaceCanvas{kWidth_m, kPixels, texture.seed});
  HeightFieldProvenance made{};
  made.kind = texture.kind;
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
    if (!protocol.name.starts_with("chapter_")) continue;
    write_file(folder / "protocols" / (std::string(protocol.name) + ".json"), protocol.text,
               Overwrite::refuse);
  }
  for (std::size_t i = 0; i < kDemoTextures.size(); ++i) {
    progress(static_cast<double>(i) / kDemoTextures.size());
    make_texture(kDemoTextures[i], folder / "stimuli");
  }
  progress(1.0);
}

}  // namespace asperity
