// Converts a planned presentation into the inputs of a renderer.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/study_files/height_field_files.h"
#include "app/study_files/textured_mesh_files.h"
#include "protocols/plan/plan.h"
#include "renderers/force/force_model.h"
#include "results_schema/rows.h"

namespace asperity {

class Study;

/// A prepared stimulus: files read, parameters complete, forces matched.
struct PreparedStimulus {
  const ForceModel* model = nullptr;
  RendererInputs inputs{};         ///< parameters complete; seed still 0
  std::vector<AssetRow> assets{};  ///< what the inputs were made from
  std::optional<double> matched_texture_force_N{};
};

/// The content of a file whose role a force model declares, and its hash.
struct LoadedAsset {
  std::shared_ptr<const std::string> content{};
  std::string sha256{};
};

/// The mesh of a body, and the hash of its content.
struct LoadedBody {
  std::shared_ptr<const TexturedMesh> mesh{};
  /// Of the file of a mesh; of a shape, of the inputs from which it is made
  /// (docs/formats/study.md).
  std::string sha256{};
};

/// Reads the study's height fields, textured meshes and other assets (once each), makes bodies of shapes (once for
/// everything that they are made from), takes parameters from samples where a model does
/// so, and solves requests for equal texture force.
///
/// Equal force refers to the reference model as it would be rendered with this texture where nothing
/// else is declared: parameters from the sample, defaults for the rest. A solution depends on both models
/// and their versions, the parameters, the material, the patch, the content of the height field and of
/// declared assets, the target and the prescribed path; it is kept under all of these in the study, so that every
/// session renders the same stimulus. The path lies on a plane; a body under a point model has no influence. A model that
/// draws random numbers is solved with one seed and felt with another: its texture force scatters about the solution by
/// some 2 %.
///
/// Errors: std::runtime_error naming the stimulus and the file or parameter.
///
/// Threads: any; sessions that are simulated in parallel share one.
class StimulusBuilder final {
 public:
  /// An empty folder: without a study (`can_make`). `kept` (null: none) has height fields of earlier builders, and outlives
  /// this one.
  StimulusBuilder(const ModelRegistry& models, std::filesystem::path study_folder,
                  KeptHeightFields* kept = nullptr);

  /// From now on the contacts of two textured bodies are evaluated on this device. To be called before the first stimulus
  /// is prepared for a session.
  void compute_on(std::shared_ptr<const Compute> compute);

  /// From now on a model that measures the path of the hand (path_clock.h) has this position step of the device, unless the
  /// protocol states one. To be called before the first stimulus is prepared for a session.
  void assume_position_step(double position_step_m) noexcept { position_step_m_ = position_step_m; }

  /// Whether the files of a stimulus are available: without a study only a stimulus that names none.
  bool can_make(const StimulusDescription& description) const;

  /// `study` stores the solutions; it belongs to the calling thread. Without one they last as long as the builder.
  PreparedStimulus prepare(const PlannedPresentation& presentation, Study* study = nullptr);
  /// The same stimulus with its force unchanged.
  PreparedStimulus unmatched(const StimulusDescription& description);
  /// The same without its parameters: what the description's files and bodies give, each once.
  PreparedStimulus without_parameters(const StimulusDescription& description);

  LoadedHeightField height_field(const std::string& study_path);
  /// The height field as a photograph would give it (without_long_wavelengths), filtered once.
  std::shared_ptr<const HeightField> height_field_without_long_wavelengths(
      const std::string& study_path, double gaussian_wavelength_m);
  LoadedBody body(const BodyDescription& description, BodyRole role);
  /// Checks that `body` can provide it, without making the texels of a shape. Errors: as `body`.
  void require_body(const BodyDescription& description);
  /// A file of a role that force models declare. Errors: ResultsError naming the file.
  LoadedAsset asset(const std::string& study_path);
  const ModelRegistry& models() const noexcept { return computed_ ? *computed_ : models_; }

 private:
  /// The parameters suggested by the sample, those given, the position step of the device, and the model's defaults for the
  /// rest.
  ParameterValues parameters_for(const ForceModel& model, const PreparedStimulus& stimulus,
                                 const ParameterValues& given);
  LoadedTexturedMesh mesh(const std::string& study_path);
  /// The surface of a body for point models, prepared once.
  std::shared_ptr<const BodySurface> surface_of(const LoadedBody& body);
  /// Without the relative amplitude.
  PreparedStimulus of_own_amplitude(const StimulusDescription& description);
  /// Gives `inputs` the assets that the model declares. Returns their rows.
  std::vector<AssetRow> take_assets(const ModelDeclaration& model,
                                    const StimulusDescription& description, RendererInputs& inputs);
  void match(PreparedStimulus& prepared, const PlannedPresentation& presentation, Study* study);

  const ModelRegistry& models_;
  std::optional<ModelRegistry> computed_{};  ///< the same, on a compute device
  std::filesystem::path study_folder_{};
  KeptHeightFields* kept_ = nullptr;
  double position_step_m_ = 0.0;  ///< of the device; 0: unknown, or none
  std::mutex fields_mutex_{};
  std::mutex suggestions_mutex_{};
  std::map<std::string, ParameterValues> suggestions_{};
  std::mutex matching_mutex_{};
  std::mutex assets_mutex_{};
  std::map<std::string, LoadedAsset> assets_{};  ///< by path in the study
  std::map<std::string, LoadedHeightField> fields_{};
  std::map<std::pair<std::string, double>, std::shared_ptr<const HeightField>> filtered_{};
  std::mutex bodies_mutex_{};
  std::map<std::string, LoadedTexturedMesh> meshes_{};                   ///< by path in the study
  std::map<std::string, std::shared_ptr<const TexturedMesh>> bodies_{};  ///< of shapes, by SHA-256
  /// Of point models, by SHA-256 of the body.
  std::map<std::string, std::shared_ptr<const BodySurface>> surfaces_{};
  std::map<std::string, std::string> solutions_{};  ///< as stored in the study, by key
};

}  // namespace asperity
