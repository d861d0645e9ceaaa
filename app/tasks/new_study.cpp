// Generates the textures, reliefs and protocols of the demonstration, so that an unfinished study is known.

#include "app/tasks/new_study.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/study_files/height_field_files.h"
#include "app/study_files/program.h"
#include "app/tasks/protocol_templates.h"
#include "protocols/file/library_protocols.h"
#include "renderers/recordings/relief_recording.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/files/part_folder.h"
#include "results_schema/study.h"
#include "results_schema/study_sharing.h"
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
  save_height_field(folder / (name + ".png"), surface, made, Overwrite::refuse);
  if (!relief.has_picture) return;
  save_picture(folder / (name + "_photo.png"), synthetic_photograph(surface, {}),
               Overwrite::refuse);
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
  const std::filesystem::path photograph_file = folder / (name + "_photo.png");
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
  save_height_field(folder / (name + ".png"), recovered.field, provenance, Overwrite::refuse);
  if (!texture.has_recording) return;
  write_file(folder / (name + "_recording.tsv"), tsv_of(recording_of_relief(recovered.field)),
             Overwrite::refuse);
}

void fill_demo_study(const std::filesystem::path& folder,
                     const std::function<void(double)>& progress) {
  for (const LibraryProtocol& protocol : library_protocols()) {
    // The protocols of the demo data: one session without sight, one with tools in six degrees of
    // freedom, those of numbers and ratings, and one of a threshold, which needs no files.
    if (!protocol.name.starts_with("chapter_") && protocol.name != "improved_selection_blindfold" &&
        protocol.name != "tools_matching" && protocol.name != "amplitude_jnd" &&
        protocol.name != "models_in_pairs" && protocol.name != "map_of_renderings" &&
        protocol.name != "semantic_differential" && !protocol.name.starts_with("roughness_")) {
      continue;
    }
    write_library_protocol(folder, protocol, std::string(protocol.name));
  }
  // First: the last files made indicate whether the study is complete.
  for (const BodyRelief& relief : body_reliefs()) make_body_relief(relief, folder / "stimuli");
  for (const BodyRelief& relief : cone_fields()) make_body_relief(relief, folder / "stimuli");
  const std::vector<DemoTexture> textures = demo_textures();
  for (std::size_t i = 0; i < textures.size(); ++i) {
    progress(static_cast<double>(i) / static_cast<double>(textures.size()));
    make_texture(textures[i], folder / "stimuli");
  }
  progress(1.0);
}

/// The name of the folder: "s" for "s/" and for "." in the folder s.
std::string name_of(const std::filesystem::path& folder) {
  std::string name{};
  if (!folder.empty()) {
    const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
    name = (path.has_filename() ? path : path.parent_path()).filename().string();
  }
  if (name.empty()) {
    throw std::invalid_argument("the name of a study must not be empty; give a name");
  }
  return name;
}

/// Whether the folder has a study as it was made with these settings, without anything that was added later.
bool holds_unused_study(const std::filesystem::path& folder, const NewStudySettings& settings) {
  if (!Study::exists(folder)) return false;
  try {
    const Study study = Study::open(folder, Access::read_only);
    return study.name() == name_of(folder) && study.metadata() == settings.metadata &&
           study.participants().empty() && study.protocols().empty() && study.outputs().empty() &&
           study.withdrawals().empty();
  } catch (const ResultsError&) {
    return false;
  }
}

bool is_of_store(const std::filesystem::path& path) {
  return path.filename().string().starts_with("study.sqlite");
}

/// Whether the folders of a study are empty but for locks, and nothing else is next to its store.
bool holds_no_files(const std::filesystem::path& folder) {
  for (const auto& entry : entries_in(folder)) {
    const bool is_known = is_of_store(entry.path()) || entry.path().filename() == "locks";
    const bool is_empty = entry.is_directory() && std::filesystem::is_empty(entry.path());
    if (!is_known && !is_empty) return false;
  }
  return true;
}

using FillFolder = std::function<void(const std::filesystem::path&)>;

void remove_study(const std::filesystem::path& folder) noexcept {
  try {
    for (const auto& entry : entries_in(folder)) {
      const std::string name = entry.path().filename().string();
      const bool is_ours = is_of_store(entry.path()) || name == "protocols" || name == "stimuli" ||
                           name == "recordings" || name == "locks";
      std::error_code ignored{};
      if (is_ours) std::filesystem::remove_all(entry.path(), ignored);
    }
  } catch (const std::exception&) {  // what stopped the making of the study is reported
  }
}

/// Makes the study in a new or empty folder.
void make_study(const std::filesystem::path& folder, const NewStudySettings& settings,
                const FillFolder& fill) {
  const std::string name = name_of(folder);
  const auto make_in = [&](const std::filesystem::path& content) {
    {
      Study study = Study::create(content, name);
      if (settings.metadata != StudyMetadata{}) study.set_metadata(settings.metadata);
    }
    fill(content);
    if (settings.group) share_study(content, *settings.group);
  };
  if (!std::filesystem::exists(folder)) {
    make_folder_at_once(folder, kOwnersFolder, make_in);
    return;
  }
  const bool was_empty = std::filesystem::is_directory(folder) && std::filesystem::is_empty(folder);
  try {
    make_in(folder);
  } catch (...) {
    if (was_empty) remove_study(folder);
    throw;
  }
}

NewStudy make_or_find(const std::filesystem::path& folder, const NewStudySettings& settings,
                      bool (*is_filled)(const std::filesystem::path&), const FillFolder& fill) {
  if (!holds_unused_study(folder, settings) || !is_filled(folder)) {
    make_study(folder, settings, fill);
    return NewStudy::made;
  }
  PartFolder::remove_leftover(folder);
  if (settings.group) share_study(folder, *settings.group);
  return NewStudy::found;
}

}  // namespace

NewStudy new_study(const std::filesystem::path& folder, const NewStudySettings& settings) {
  return make_or_find(folder, settings, holds_no_files, [](const std::filesystem::path&) {});
}

NewStudy new_demo_study(const std::filesystem::path& folder,
                        const std::function<void(double)>& progress,
                        const NewStudySettings& settings) {
  return make_or_find(
      folder, settings, holds_demo_study,
      [&progress](const std::filesystem::path& content) { fill_demo_study(content, progress); });
}

Phrase one_version_per_study() {
  return phrase("NewStudy",
                "This is version %1. Before 1.0.0, finish a study with the version that began it; "
                "the package of each version stays available.")
      .with(program_version());
}

bool is_of_demonstration(const std::string& study_path) {
  const auto is_of = [&study_path](std::string_view name) {
    const std::string stem = "stimuli/" + std::string(name);
    for (const char* end :
         {".png", ".png.json", "_photo.png", "_true.png", "_true.png.json", "_recording.tsv"}) {
      if (study_path == stem + end) return true;
    }
    return false;
  };
  const auto is_any = [&is_of](const auto& all) {
    return std::any_of(all.begin(), all.end(), [&](const auto& one) { return is_of(one.name); });
  };
  return is_any(body_reliefs()) || is_any(cone_fields()) || is_any(demo_textures());
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
  // Of another schema it cannot be opened.
  try {
    Study::open(folder, Access::read_only);
  } catch (const ResultsError&) {
    return false;
  }
  return true;
}

}  // namespace asperity
