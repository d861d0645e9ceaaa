// Edits the text of a protocol so that a surface has the values of a rendering.

#include "app/tasks/rendering_use.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/study_files/height_field_files.h"
#include "app/study_files/parameter_json.h"
#include "app/tasks/template_overviews.h"
#include "app/words/phrase_of_error.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/editing/edits.h"
#include "protocols/file/json_document.h"
#include "protocols/form/form_edits.h"
#include "protocols/form/form_entries.h"
#include "protocols/form/new_values.h"
#include "protocols/keys/names_in.h"
#include "protocols/shapes/key.h"
#include "protocols/warnings/text_warnings.h"

namespace asperity {

namespace {

using nlohmann::json;

constexpr const char* kProtocol = "the protocol";
constexpr const char* kNote = "x-rendering";
/// Keys of a surface with which its values would not be those of the rendering.
constexpr std::array<const char*, 3> kInTheWay{"equal_force", "surface", "tool"};

std::string with(const std::string& text, const std::string& pointer, const std::string& value) {
  return with_value(JsonDocument(text, kProtocol), pointer, value).text;
}

/// The texture of the protocol with this height field; nullopt if there is none.
std::optional<std::string> texture_with(const json& root, const std::string& height_field) {
  const json textures = root.value("textures", json::object());
  for (const auto& [name, texture] : textures.items()) {
    if (texture.is_object() && texture.value("height_field", json{}) == height_field) return name;
  }
  return {};
}

std::string texture_of(std::string& text, const Rendering& rendering, const std::string& picture) {
  const JsonDocument protocol(text, kProtocol);
  const std::string& height_field = rendering.texture.height_field;
  if (const auto found = texture_with(protocol.root(), height_field)) {
    const std::string pointer = pointer_to("/textures", *found);
    if (!picture.empty() && !protocol.root().at(json::json_pointer(pointer)).contains("picture")) {
      text = with(text, pointer_to(pointer, "picture"), json_string(picture));
    }
    return *found;
  }
  const std::vector<std::string> taken = declared_names(names_in(protocol.root()), "textures");
  const std::string name =
      free_name(taken, name_in_protocol(std::filesystem::path(height_field).stem().string()));
  nlohmann::ordered_json texture{{"height_field", height_field}};
  if (!picture.empty()) texture["picture"] = picture;
  text = with(text, pointer_to("/textures", name), texture.dump());
  return name;
}

/// The values of the surface that the text does not have yet.
std::string new_surface(const Rendering& rendering, const std::string& name,
                        const std::string& texture) {
  nlohmann::ordered_json surface{};
  surface["model"] = rendering.model;
  surface["texture"] = texture;
  surface["parameters"] = nlohmann::ordered_json::parse(json_text_of(rendering.parameters));
  surface["material"] = {{"stiffness_N_per_m", rendering.material.stiffness_N_per_m},
                         {"friction", rendering.material.friction}};
  surface[kNote] = name;
  return surface.dump();
}

/// Values of parameters that stay the same are not written again.
std::string with_parameters(std::string text, const std::string& parameters,
                            const ParameterValues& values) {
  const json::json_pointer path(parameters);
  const json root = JsonDocument(text, kProtocol).root();
  if (!root.contains(path) || !root.at(path).is_object()) {
    return with(text, parameters, json_text_of(values));
  }
  std::vector<std::string> gone{};
  for (const auto& [name, value] : root.at(path).items()) {
    if (!is_comment(name) && !values.contains(name)) gone.push_back(pointer_to(parameters, name));
  }
  if (!gone.empty()) text = without(JsonDocument(text, kProtocol), gone).text;
  for (const auto& [name, value] : values) {
    text = with(text, pointer_to(parameters, name), json_text_of(value));
  }
  return text;
}

std::string displayed(const json& value, const std::string& pointer) {
  const bool is_summarised = value.is_string() || value.is_number();
  return is_summarised ? summary_of(NumberShape{}, value, pointer) : value.dump();
}

/// Null stands for a value that does not exist.
void add_changes(const json& before, const json& after, const std::string& pointer,
                 std::vector<ChangedValue>& changes) {
  if (before == after) return;
  const bool are_objects =
      (before.is_object() || before.is_null()) && (after.is_object() || after.is_null());
  if (!are_objects) {
    changes.push_back({pointer, before.is_null() ? "" : displayed(before, pointer),
                       after.is_null() ? "" : displayed(after, pointer)});
    return;
  }
  std::set<std::string> keys{};
  for (const json* const one : {&before, &after}) {
    for (const auto& [key, value] : one->items()) keys.insert(key);
  }
  for (const std::string& key : keys) {
    const auto value_in = [&key](const json& object) {
      return object.is_object() ? object.value(key, json{}) : json{};
    };
    add_changes(value_in(before), value_in(after), pointer_to(pointer, key), changes);
  }
}

/// The renderings that the surfaces note, with the pointers of the notes; none of a text that is not JSON.
std::vector<std::pair<std::string, std::string>> notes_in(const std::string& protocol) {
  std::vector<std::pair<std::string, std::string>> notes{};
  const json root = json::parse(protocol, nullptr, false);
  if (!root.is_object()) return notes;
  const json stimuli = root.value("stimuli", json::object());
  for (const auto& [name, surface] : stimuli.items()) {
    if (!surface.is_object()) continue;
    const json note = surface.value(kNote, json{});
    if (!note.is_string()) continue;
    notes.emplace_back(pointer_to(pointer_to("/stimuli", name), kNote), note.get<std::string>());
  }
  return notes;
}

}  // namespace

RenderingRemarks remarks_about(const Rendering& rendering, const ModelRegistry& models,
                               const std::filesystem::path& study) {
  RenderingRemarks remarks{};
  const ForceModel* const model = models.find(rendering.model);
  if (model == nullptr) {
    remarks.problems.push_back(
        phrase("Renderings",
               "This version has no force model “%1”. Load the plug-in that contains it, or choose "
               "another model in the workbench.")
            .with(rendering.model));
  } else if (model->declaration.version != rendering.version) {
    remarks.warnings.push_back(
        phrase("Renderings",
               "The force model “%1” had version %2 when the rendering was saved, and has version "
               "%3 now: its forces differ. Compare them in the workbench, and save the rendering "
               "again.")
            .with(rendering.model, rendering.version, model->declaration.version));
  }
  const std::string& texture = rendering.texture.height_field;
  try {
    const std::string& sha256 = rendering.texture.sha256;
    // A texture that has changed is decoded, because it may be unreadable.
    if (!has_hash(study / texture, sha256) && load_height_field(study / texture).sha256 != sha256) {
      remarks.warnings.push_back(
          phrase("Renderings",
                 "%1 has changed since the rendering was saved (another SHA-256). Restore the "
                 "file, or choose the values again in the workbench and save a new rendering.")
              .with(texture));
    }
  } catch (const std::exception& error) {
    remarks.problems.push_back(
        phrase("Renderings",
               "The texture %1 cannot be read: %2. Restore the file, or save "
               "the rendering of another texture.")
            .with(texture, phrase_of(error)));
  }
  return remarks;
}

std::vector<UsableSurface> usable_surfaces(const std::string& protocol) {
  std::vector<UsableSurface> surfaces{};
  try {
    const JsonDocument document(protocol, kProtocol);
    if (!document.root().is_object()) return {};
    const json stimuli = document.root().value("stimuli", json::object());
    for (const auto& [name, surface] : stimuli.items()) {
      if (is_comment(name) || !surface.is_object()) continue;
      UsableSurface usable{.name = name};
      usable.has_texture = surface.contains("texture");
      const json texture = surface.value("texture", json{});
      if (texture.is_object() && texture.value("factor", json{}).is_string()) {
        usable.texture_factor = texture.at("factor").get<std::string>();
      }
      surfaces.push_back(std::move(usable));
    }
  } catch (const ProtocolError&) {
    return {};
  }
  return surfaces;
}

std::vector<std::string> renderings_in(const std::string& protocol) {
  std::vector<std::string> names{};
  for (const auto& [pointer, rendering] : notes_in(protocol)) names.push_back(rendering);
  return names;
}

std::vector<std::string> notes_of(const std::string& protocol, const std::string& rendering) {
  std::vector<std::string> pointers{};
  for (const auto& [pointer, noted] : notes_in(protocol)) {
    if (noted == rendering) pointers.push_back(pointer);
  }
  return pointers;
}

std::optional<Phrase> complaint_about_picture(const Protocol& protocol, const Rendering& rendering,
                                              const std::string& picture) {
  if (!picture.empty() || !has_pictures(protocol)) return {};
  const std::string& height_field = rendering.texture.height_field;
  const auto found =
      std::find_if(protocol.textures.begin(), protocol.textures.end(),
                   [&](const auto& named) { return named.second.height_field == height_field; });
  if (found != protocol.textures.end() && found->second.picture) return {};
  return phrase("Renderings",
                "This protocol shows pictures, and %1 has no photograph. Save the photograph as "
                "stimuli/%2_photo.png, or replace a surface and keep its texture.")
      .with(height_field, std::filesystem::path(height_field).stem().string());
}

std::string with_rendering(const std::string& protocol, const Rendering& rendering,
                           const std::string& name, const RenderingPlace& place,
                           const std::string& picture) {
  std::string text = protocol;
  const std::string texture =
      place.keeps_texture ? std::string() : texture_of(text, rendering, picture);
  if (!place.replaced) {
    const std::vector<std::string> taken =
        declared_names(names_in(JsonDocument(text, kProtocol).root()), "stimuli");
    const std::string surface = free_name(taken, name_in_protocol(name));
    return with(text, pointer_to("/stimuli", surface), new_surface(rendering, name, texture));
  }
  const std::string surface = pointer_to("/stimuli", *place.replaced);
  const JsonDocument document(text, kProtocol);
  const json::json_pointer path(surface);
  if (!document.root().contains(path)) {
    throw ProtocolError({document.at(
        surface, phrase("Protocols", "there is no surface %1").with(in_quotes(*place.replaced)))});
  }
  std::vector<std::string> gone{};
  for (const char* const key : kInTheWay) {
    if (document.root().at(path).contains(key)) gone.push_back(pointer_to(surface, key));
  }
  if (!gone.empty()) text = without(document, gone).text;
  text = with(text, pointer_to(surface, "model"), json_string(rendering.model));
  if (!place.keeps_texture) text = with(text, pointer_to(surface, "texture"), json_string(texture));
  text = with_parameters(text, pointer_to(surface, "parameters"), rendering.parameters);
  const std::string material = pointer_to(surface, "material");
  text = with(text, pointer_to(material, "stiffness_N_per_m"),
              json_text_of(rendering.material.stiffness_N_per_m));
  text = with(text, pointer_to(material, "friction"), json_text_of(rendering.material.friction));
  return with(text, pointer_to(surface, kNote), json_string(name));
}

std::vector<ChangedValue> changed_values(const std::string& before, const std::string& after) {
  std::vector<ChangedValue> changes{};
  add_changes(JsonDocument(before, kProtocol).root(), JsonDocument(after, kProtocol).root(), "",
              changes);
  return changes;
}

}  // namespace asperity
