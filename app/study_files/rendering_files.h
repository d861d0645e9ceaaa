// Declares renderings: a force model with its values on a texture, as files of a study (docs/formats/rendering.md).

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "protocols/shapes/key.h"
#include "stimuli/properties/material.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// A surface as it was felt in the workbench.
struct Rendering {
  struct Texture {
    std::string height_field{};  ///< relative to the study
    std::string sha256{};        ///< of its sidecar (LoadedHeightField)
  };
  std::string model{};
  std::string version{};  ///< of the model
  Texture texture{};
  ParameterValues parameters{};  ///< of all parameters of the model
  Material material{};
};

/// The keys of a file: its form, its schema and the rows of its page follow from them.
extern const KeyTableOf<Rendering> kRenderingTable;
extern const KeyTableOf<Rendering::Texture> kRenderingTextureTable;

/// The text of a file.
std::string text_of(const Rendering& rendering);

/// `file` names the text in errors. Errors: ProtocolError with all problems; of another version of the format with this one.
Rendering rendering_in(const std::string& text, const std::string& file);

inline constexpr const char* kRenderingEnding = ".rendering.json";
/// Whether the file is a rendering, by its name.
bool is_rendering(const std::filesystem::path& file);
/// "brick" of `stimuli/brick.rendering.json`.
std::string rendering_name(const std::filesystem::path& file);
/// The file of the rendering with this name.
std::filesystem::path rendering_file(const std::filesystem::path& study, const std::string& name);
/// Those of a study, by name. Errors: ResultsError for a folder that cannot be read.
std::vector<std::filesystem::path> rendering_files(const std::filesystem::path& study);

/// Errors: as `rendering_in`, and ResultsError for a file that cannot be read.
Rendering load_rendering(const std::filesystem::path& file);

/// Errors: ResultsError for a file that exists or cannot be written.
void save_rendering(const std::filesystem::path& study, const std::string& name,
                    const Rendering& rendering);

}  // namespace asperity
