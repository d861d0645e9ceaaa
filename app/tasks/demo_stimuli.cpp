// Generates the textures and reliefs of the demo study.

#include "app/tasks/demo_stimuli.h"

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

#include "app/study_files/height_field_files.h"
#include "app/study_files/stimulus_names.h"
#include "renderers/recordings/relief_recording.h"
#include "results_schema/files/atomic_file.h"
#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/synthetic_photograph.h"
#include "stimuli/photographs/texture_from_photograph.h"

namespace asperity {

namespace {

/// A texture of the demonstration. A distractor, which is only seen, has no rendered counterpart.
struct DemoTexture {
  std::string_view name{};
  std::string_view kind{};
  bool is_rendered = true;
  std::uint64_t seed = 0;
  ParameterValues parameters{};
  bool has_recording = false;  ///< of the strokes over it, for the force model `recorded`
};

/// Pebbles are made like grains, close together, but 4 mm in size: a stroke along any line meets
/// them.
std::vector<DemoTexture> demo_textures() {
  return {
      {"metal", "metal", true, 11, {}},
      {"stone", "stone", true, 12, {}, true},
      {"wood", "wood", true, 13, {}},
      {"brick", "brick", true, 14, {}},
      {"sandpaper", "sandpaper", false, 15, {}},
      {"pebbles", "sandpaper", false, 16, {{"grain_spacing_m", 0.004}, {"grain_height_m", 6e-4}}}};
}

/// A relief of `tools_matching` or of the roughness protocols: felt unchanged, on a tool or the
/// plate, and seen where it has a picture.
struct BodyRelief {
  std::string_view name{};
  std::string_view kind{};
  bool has_picture = true;
  std::size_t pixels = 256;
  ParameterValues parameters{};
  double width_m = 0.024;
};

/// Of `tools_matching`: all 24 mm wide, which is a whole number of ridges of each and fits once
/// around a tool.
std::vector<BodyRelief> body_reliefs() {
  const auto ridges = [](double spacing_m) {
    return ParameterValues{{"spacing_m", spacing_m},
                           {"height_m", 2e-4},
                           {"ridge_width_m", 0.3 * spacing_m},
                           {"flank_width_m", 0.2 * spacing_m}};
  };
  return {{"file_fine", "grating", true, 256, ridges(0.0010)},
          {"file_medium", "grating", true, 256, ridges(0.0016)},
          {"file_coarse", "grating", true, 256, ridges(0.0024)},
          {"file_plate",
           "cones",
           false,
           128,  // for coarse features on a large plate
           {{"spacing_m", 0.003},
            {"height_m", 2e-4},
            {"top_diameter_m", 6e-4},
            {"base_diameter_m", 0.0018}}}};
}

/// Of the roughness protocols. The rows are turned by arctan(3/4), so that a stroke along x passes
/// over one row after the other: along the rows, most lines between them would meet no cone.
/// 70 mm is a whole multiple of five times each distance, as these rows require. The base of a cone is seven pixels
/// wide. A higher resolution would only be slower: a body has four texels per pixel.
std::vector<BodyRelief> cone_fields() {
  const auto cones = [](std::string_view name, double spacing_m) {
    return BodyRelief{name,
                      "cones",
                      false,
                      1120,
                      {{"spacing_m", spacing_m},
                       {"height_m", 2e-4},
                       {"top_diameter_m", 1e-4},
                       {"base_diameter_m", 4.5e-4},
                       {"jitter", 0.15},
                       {"angle_rad", 0.643501}},
                      0.07};
  };
  return {cones("cones_05", 0.0005), cones("cones_07", 0.0007), cones("cones_10", 0.0010),
          cones("cones_14", 0.0014), cones("cones_20", 0.0020), cones("cones_28", 0.0028),
          cones("cones_35", 0.0035)};
}

constexpr double kWidth_m = 0.10;
constexpr std::size_t kPixels = 1024;

void make_body_relief(const BodyRelief& relief, const std::filesystem::path& folder) {
  const SurfaceCanvas canvas{relief.width_m, relief.pixels, 17};
  const std::string name(relief.name);
  const HeightField surface = make_surface(relief.kind, relief.parameters, canvas);
  HeightFieldProvenance made{};
  made.kind = relief.kind;
  made.parameters = relief.parameters;
  made.seed = canvas.seed;
  const std::filesystem::path file = folder / (name + ".png");
  save_height_field(file, surface, made, Overwrite::refuse);
  if (!relief.has_picture) return;
  save_picture(photograph_of(file), synthetic_photograph(surface, {}), Overwrite::refuse);
}

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
  const std::filesystem::path file = folder / (name + ".png");
  const std::filesystem::path photograph_file = photograph_of(file);
  save_picture(photograph_file, synthetic_photograph(surface, settings), Overwrite::refuse);
  if (!texture.is_rendered) return;

  // From here on only the picture is used, except for its width and the amplitude of the relief,
  // which cannot be determined from a photograph.
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
  save_height_field(file, recovered.field, provenance, Overwrite::refuse);
  if (!texture.has_recording) return;
  write_file(folder / (name + "_recording.tsv"), tsv_of(recording_of_relief(recovered.field)),
             Overwrite::refuse);
}

std::vector<BodyRelief> reliefs() {
  std::vector<BodyRelief> all = body_reliefs();
  for (BodyRelief& relief : cone_fields()) all.push_back(std::move(relief));
  return all;
}

template <class Stimulus>
const Stimulus* find_in(const std::vector<Stimulus>& all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [name](const Stimulus& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

// The textures are last: their files indicate whether the demo study is complete.
std::vector<std::string> demo_stimuli() {
  std::vector<std::string> names{};
  for (const BodyRelief& relief : reliefs()) names.emplace_back(relief.name);
  for (const DemoTexture& texture : demo_textures()) names.emplace_back(texture.name);
  return names;
}

std::vector<std::string> files_of_demo_stimulus(std::string_view name) {
  const std::string stem(name);
  const std::string relief_file = stem + ".png";
  const auto with_sidecar = [](const std::string& png) {
    return std::vector<std::string>{png, png + ".json"};
  };
  const std::vector<BodyRelief> all = reliefs();
  if (const BodyRelief* const relief = find_in(all, name)) {
    std::vector<std::string> files = with_sidecar(relief_file);
    if (relief->has_picture) files.push_back(photograph_of(relief_file).string());
    return files;
  }
  const std::vector<DemoTexture> textures = demo_textures();
  const DemoTexture* const texture = find_in(textures, name);
  if (texture == nullptr) return {};
  std::vector<std::string> files = with_sidecar(stem + "_true.png");
  files.push_back(photograph_of(relief_file).string());
  if (texture->is_rendered) {
    for (std::string& file : with_sidecar(relief_file)) files.push_back(std::move(file));
  }
  if (texture->has_recording) files.push_back(stem + "_recording.tsv");
  return files;
}

void make_demo_stimulus(std::string_view name, const std::filesystem::path& folder) {
  const std::vector<BodyRelief> all = reliefs();
  const std::vector<DemoTexture> textures = demo_textures();
  if (const BodyRelief* const relief = find_in(all, name)) {
    make_body_relief(*relief, folder);
  } else if (const DemoTexture* const texture = find_in(textures, name)) {
    make_texture(*texture, folder);
  } else {
    throw std::invalid_argument("the demo study has no texture \"" + std::string(name) + "\"");
  }
}

std::string demo_stimulus_of(std::string_view study_path) {
  static const auto kStimuli = [] {
    std::map<std::string, std::string, std::less<>> by_file{};
    for (const std::string& name : demo_stimuli()) {
      for (const std::string& file : files_of_demo_stimulus(name)) {
        by_file["stimuli/" + file] = name;
      }
    }
    return by_file;
  }();
  const auto found = kStimuli.find(study_path);
  return found == kStimuli.end() ? std::string() : found->second;
}

}  // namespace asperity
