// Compares declared spacings, sizes and directions with the provenance of each height field.

#include "app/tasks/warnings/texture_warnings.h"

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "analysis/numbers/number_text.h"
#include "app/study_files/height_field_files.h"
#include "app/words/text_parts.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "stimuli/heights/synthetic_surface.h"

namespace asperity {

namespace {

constexpr double kSameSpacing = 0.01;

/// The use of a texture in a stimulus.
struct TextureUse {
  std::string height_field{};
  std::set<std::string> stimuli{};
  glm::dvec2 widest_m{0.0};  ///< the part of it that one surface shows
};

/// The size of the part of a field that a body shows along x and y; infinite around a cylinder or a
/// sphere.
glm::dvec2 shown_m(const Shape& shape) {
  constexpr double kWithoutEnd_m = 1e3;
  if (const auto* const plate = std::get_if<PlateShape>(&shape)) return glm::dvec2(plate->size_m);
  if (const auto* const box = std::get_if<BoxShape>(&shape)) return glm::dvec2(box->size_m);
  if (const auto* const cylinder = std::get_if<CylinderShape>(&shape)) {
    return {kWithoutEnd_m, cylinder->length_m};
  }
  return {kWithoutEnd_m, kWithoutEnd_m};
}

std::map<std::string, TextureUse> uses_of(const CheckedProtocol& checked) {
  std::map<std::string, TextureUse> uses{};
  const auto use = [&uses](const std::string& texture, const std::optional<std::string>& field,
                           const StimulusDescription& stimulus, const glm::dvec2& widest_m) {
    if (texture.empty() || !field) return;
    TextureUse& of = uses[texture];
    of.height_field = *field;
    of.stimuli.insert(stimulus.name);
    of.widest_m = glm::max(of.widest_m, widest_m);
  };
  for (const auto& [trial, planned] : checked.presentations()) {
    const StimulusDescription& stimulus = planned.stimulus;
    if (!stimulus.surface || !stimulus.tool) {
      const bool is_repeated = stimulus.patch.tiling == Tiling::repeat;
      use(stimulus.texture, stimulus.height_field, stimulus,
          is_repeated ? stimulus.patch.motion_scale * stimulus.patch.extent_m : glm::dvec2(0.0));
    }
    for (const auto* const body : {&stimulus.surface, &stimulus.tool}) {
      if (!*body || !(*body)->shape) continue;
      const std::string texture = (*body)->texture.value_or(stimulus.texture);
      use(texture, (*body)->height_field, stimulus, shown_m(*(*body)->shape));
    }
  }
  return uses;
}

std::string each_in_quotes(const std::set<std::string>& names) {
  std::vector<std::string> quoted{};
  for (const std::string& name : names) quoted.push_back('"' + name + '"');
  return comma_separated(quoted);
}

std::optional<double> spacing_among(const HeightFieldProvenance& made) {
  const auto found = made.parameters.find("spacing_m");
  if (found == made.parameters.end()) return {};
  const double* const number = std::get_if<double>(&found->second);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

bool is_at_an_angle(const HeightFieldProvenance& made) {
  const auto angle = made.parameters.find("angle_rad");
  return angle != made.parameters.end() && angle->second != ParameterValue(0.0);
}

}  // namespace

std::vector<Diagnostic> warnings_about_textures(const CheckedProtocol& checked,
                                                const std::filesystem::path& study) {
  const Protocol& protocol = checked.protocol;
  const JsonDocument document(protocol.source, checked.file_name);
  std::vector<Diagnostic> warnings{};
  const double motion_scale = protocol.patch.motion_scale;  // the same for all textures
  for (const auto& [name, use] : uses_of(checked)) {
    const std::filesystem::path file = study / use.height_field;
    const HeightFieldProvenance made = provenance_of(file);
    const std::string place = pointer_to("/textures", name);
    const auto warn = [&, &name = name, &use = use](const std::string& at, const Phrase& problem) {
      warnings.push_back(document.at(
          at, phrase("Protocols", "the texture %1 (%2), used in %3: %4")
                  .with(in_quotes(name), use.height_field, each_in_quotes(use.stimuli), problem)));
    };
    const auto texture = protocol.textures.find(name);
    const std::optional<double> spacing_m = spacing_among(made);
    if (texture != protocol.textures.end() && texture->second.spacing_m && spacing_m &&
        !is_at_an_angle(made)) {
      const double said_m = *texture->second.spacing_m;
      const double felt_m = *spacing_m / motion_scale;
      if (std::abs(said_m - felt_m) > kSameSpacing * felt_m) {
        const Phrase sentence =
            motion_scale == 1.0
                ? phrase("Protocols",
                         "the protocol states a spacing of %1 m, but according to its sidecar the "
                         "file was made with %2 m; use a %3 of %4 or another file")
                : phrase("Protocols",
                         "the protocol states a spacing of %1 m, but according to its sidecar the "
                         "file was made with %2 m (%4 m at a motion scale of %5); use a %3 of %4 "
                         "or another file");
        warn(place + "/spacing_m",
             sentence.with(number_text(said_m), number_text(*spacing_m), key_name("spacing_m"),
                           number_text(felt_m), number_text(motion_scale)));
      }
    }
    const HeightField::Grid grid = load_height_field(file).field->grid();
    const SurfaceCanvas canvas{.width_m = static_cast<double>(grid.columns) * grid.pitch_m,
                               .pixels = grid.columns};
    const double once_m = canvas.width_m * (1.0 + kSameSpacing);
    const bool is_repeated = use.widest_m.x > once_m || use.widest_m.y > once_m;
    const auto seam = seam_of(made.kind, made.parameters, canvas);
    if (seam && is_repeated) warn(place, text_of(*seam));
    const auto coarse = coarse_samples_of(made.kind, made.parameters, canvas);
    if (coarse) warn(place, text_of(*coarse));
  }
  return warnings;
}

}  // namespace asperity
