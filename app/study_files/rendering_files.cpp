// Reads and writes renderings by the table of their keys.

#include "app/study_files/rendering_files.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "app/study_files/parameter_json.h"
#include "protocols/file/form_check.h"
#include "protocols/file/json_document.h"
#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/keys/form_sentences.h"
#include "protocols/keys/reading.h"
#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/files/folder_entries.h"

namespace asperity {

namespace {

constexpr const char* kRenderingFormat = "asperity.rendering/1";
constexpr FileKind kRenderingFile{"a rendering", std::uint64_t{4} << 20};

void ignore(const nlohmann::json&, Rendering&) {}

constexpr std::array<KeyWord, 1> kFormats{{{kRenderingFormat, 0, "this format"}}};
constexpr ValueShape kNumber = NumberShape{};
constexpr ValueShape kWord = TextShape{};
constexpr std::array kValueForms{kNumber, kWord};
constexpr ValueShape kValue = FormsShape{kValueForms};

constexpr auto kTextureKeys = keys_of(
    required_key(member_key<&Rendering::Texture::height_field>(
        "height_field", "Height field", "A PNG with its sidecar, relative to the study.", kFile)),
    required_key(member_key<&Rendering::Texture::sha256>(
        "sha256", "SHA-256", "SHA-256 of the sidecar when the rendering was saved.",
        TextShape{.pattern = "^[0-9a-f]{64}$"})));

constexpr auto kRenderingKeys = keys_of(
    required_key(custom_key<&ignore>("format", "Format", "The version of this format.",
                                     WordShape{kFormats})),
    required_key(member_key<&Rendering::model>("model", "Force model", "A force model.",
                                               TextShape{.pattern = kNamePattern})),
    required_key(member_key<&Rendering::version>(
        "version", "Version", "Version of the force model when the rendering was saved.",
        TextShape{.longest = 40})),
    required_key(member_key<&Rendering::texture>("texture", "Texture", kRenderingTextureTable)),
    required_key(member_key<&Rendering::parameters>(
        "parameters", "Parameters",
        "All parameters of the force model by name (see `asperity models`).",
        MapShape{.entry = &kValue, .meaning = "A number or a word.", .has_names = false})),
    required_key(member_key<&Rendering::material>("material", "Material", kMaterialTable,
                                                  "Stiffness and friction of the surface.")));

}  // namespace

constexpr KeyTableOf<Rendering::Texture> kRenderingTextureTable =
    table_of("The relief that was felt.", kTextureKeys);

constexpr KeyTableOf<Rendering> kRenderingTable =
    table_of("A force model with its values on a texture.", kRenderingKeys, "rendering");

std::string text_of(const Rendering& rendering) {
  nlohmann::ordered_json json{};
  json["format"] = kRenderingFormat;
  json["model"] = rendering.model;
  json["version"] = rendering.version;
  json["texture"] = {{"height_field", rendering.texture.height_field},
                     {"sha256", rendering.texture.sha256}};
  json["parameters"] = nlohmann::ordered_json::parse(json_text_of(rendering.parameters));
  json["material"] = {{"stiffness_N_per_m", rendering.material.stiffness_N_per_m},
                      {"friction", rendering.material.friction}};
  return json.dump(2) + '\n';
}

Rendering rendering_in(const std::string& text, const std::string& file) {
  const JsonDocument document(text, file);
  const nlohmann::json& root = document.root();
  const nlohmann::json format =
      root.is_object() ? root.value("format", nlohmann::json{}) : nlohmann::json{};
  if (!format.is_string() || !format.get<std::string>().starts_with("asperity.rendering/")) {
    throw ProtocolError({document.at(
        "/format", phrase("Protocols",
                          "this is not a rendering; a rendering is an object {…} that begins "
                          "with \"format\": \"asperity.rendering/1\""))});
  }
  if (format != kRenderingFormat) {
    throw ProtocolError({document.at(
        "/format",
        phrase("Protocols",
               "this version reads %1, not %2; use the version of Asperity that wrote the file, or "
               "save the rendering again in the workbench of this one")
            .with(kRenderingFormat, format.get<std::string>()))});
  }
  if (std::vector<Diagnostic> problems = check_form(document, kRenderingTable); !problems.empty()) {
    throw ProtocolError(std::move(problems));
  }
  Rendering rendering{};
  read_keys(kRenderingTable, root, "", rendering);
  if (const auto complaint = complaint_about_path(rendering.texture.height_field)) {
    throw ProtocolError({document.at("/texture/height_field", *complaint)});
  }
  return rendering;
}

bool is_rendering(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.size() > std::string_view(kRenderingEnding).size() &&
         name.ends_with(kRenderingEnding);
}

std::string rendering_name(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.size() - std::string_view(kRenderingEnding).size());
}

std::filesystem::path rendering_file(const std::filesystem::path& study, const std::string& name) {
  return study / "stimuli" / (name + kRenderingEnding);
}

std::vector<std::filesystem::path> rendering_files(const std::filesystem::path& study) {
  std::vector<std::filesystem::path> files{};
  for (const auto& entry : entries_in(study / "stimuli")) {
    if (is_rendering(entry.path())) files.push_back(entry.path());
  }
  return files;
}

Rendering load_rendering(const std::filesystem::path& file) {
  return rendering_in(read_file(file, kRenderingFile), file.string());
}

void save_rendering(const std::filesystem::path& study, const std::string& name,
                    const Rendering& rendering) {
  write_file(rendering_file(study, name), text_of(rendering), Overwrite::refuse);
}

}  // namespace asperity
