// Implements the checks that bodies can be made and that stimuli have the bodies that their models need.

#include <algorithm>
#include <array>
#include <string_view>

#include "protocols/file/meaning/meaning_checks.h"

namespace asperity {

namespace {

struct ShapeKeys {
  std::string_view shape{};
  std::vector<std::string_view> needed{};
  bool has_axis = false;
};

const std::array<ShapeKeys, 5>& shape_keys() {
  static const std::array<ShapeKeys, 5> kKeys{{{"plate", {"size_m"}, false},
                                               {"box", {"size_m"}, false},
                                               {"cylinder", {"diameter_m", "length_m"}, true},
                                               {"disc", {"diameter_m"}, true},
                                               {"sphere", {"diameter_m"}, true}}};
  return kKeys;
}

constexpr std::array<std::string_view, 3> kSizes{"size_m", "diameter_m", "length_m"};

void check_body_keys(CheckedDocument& checked, const std::string& name,
                     const std::string& pointer) {
  const auto& object = checked.document.root().at("bodies").at(name);
  const bool is_mesh = object.contains("mesh");
  const auto shape = object.find("shape");
  if (is_mesh == (shape != object.end())) {
    checked.report(
        pointer, (is_mesh ? phrase("Protocols",
                                   "a body is either a %1, a file of the study, or a %2, not "
                                   "both; remove one")
                          : phrase("Protocols",
                                   "a body is either a %1, a file of the study, or a %2; add one"))
                     .with(key_name("mesh"), key_name("shape")));
    return;
  }
  const auto refuse_key = [&](std::string_view key, const Phrase& why) {
    if (object.contains(std::string(key)))
      checked.report_key(pointer + '/' + std::string(key), why);
  };
  if (is_mesh) {
    for (const std::string_view key : kSizes) {
      refuse_key(key,
                 phrase("Protocols", "the file of a mesh determines its size; remove this key"));
    }
    refuse_key("axis", phrase("Protocols",
                              "the file of a mesh determines its orientation; remove this key"));
    refuse_key("texture",
               phrase("Protocols", "the file of a mesh contains its texture; remove this key"));
    return;
  }
  const auto said = shape->get<std::string>();
  const auto keys = std::find_if(shape_keys().begin(), shape_keys().end(),
                                 [&said](const ShapeKeys& each) { return each.shape == said; });
  for (const std::string_view key : kSizes) {
    const bool is_needed =
        std::find(keys->needed.begin(), keys->needed.end(), key) != keys->needed.end();
    if (!is_needed) {
      refuse_key(
          key,
          phrase("Protocols", "a %1 does not have this key; use %2 instead")
              .with(said, joined_by_or(key_names({keys->needed.begin(), keys->needed.end()}))));
    } else if (!object.contains(std::string(key))) {
      checked.report(
          pointer,
          phrase("Protocols", "a %1 needs %2, in metres; add it").with(said, key_name(key)));
    }
  }
  if (!keys->has_axis)
    refuse_key("axis", phrase("Protocols", "a %1 has no axis; remove this key").with(said));
}

}  // namespace

void check_bodies(CheckedDocument& checked) {
  for (const auto& [name, body] : checked.protocol.bodies) {
    const std::string pointer = pointer_to("/bodies", name);
    check_path(checked, body.mesh, pointer + "/mesh");
    check_body_keys(checked, name, pointer);
    if (!body.texture) continue;
    const auto texture = checked.protocol.textures.find(*body.texture);
    if (texture == checked.protocol.textures.end()) {
      checked.report(pointer + "/texture",
                     unknown_name("texture", *body.texture, checked.protocol.textures));
    } else if (!texture->second.height_field) {
      checked.report(pointer + "/texture",
                     phrase("Protocols",
                            "the texture %1 cannot be applied to a body: it has no %2; give it one")
                         .with(in_quotes(*body.texture), key_name("height_field")));
    }
  }
}

void check_bodies_of(CheckedDocument& checked, const StimulusTemplate& stimulus,
                     const std::vector<const ModelDeclaration*>& models,
                     const std::string& pointer) {
  const auto needs = std::find_if(models.begin(), models.end(),
                                  [](const ModelDeclaration* each) { return each->needs_bodies; });
  const auto check = [&](const Binding<std::string>& binding, const char* key,
                         const Phrase& if_missing) {
    const bool is_given = binding.value || !binding.factor.empty();
    const std::string place = pointer + '/' + key;
    if (!is_given && needs != models.end()) {
      checked.report(pointer, if_missing.with(in_quotes((*needs)->id), key_name(key)));
    }
    const auto named = texts_of(checked, binding, place);
    for (const auto& [name, at] : named) {
      if (!checked.protocol.bodies.contains(name))
        checked.report(
            at, unknown_name("body", name, names_not_in(names_of(named), checked.protocol.bodies)));
    }
  };
  if (needs != models.end() && checked.protocol.patch.motion_scale != 1.0) {
    checked.report(
        "/surface/motion_scale",
        phrase("Protocols", "the model %1 moves a tool exactly as the hand moves: set %2 to 1")
            .with(in_quotes((*needs)->id), key_name("motion_scale")));
  }
  check(stimulus.surface, "surface",
        phrase("Protocols",
               "the model %1 needs two bodies: give the stimulus the object that is touched, one "
               "of the bodies, as %2"));
  check(stimulus.tool, "tool",
        phrase("Protocols",
               "the model %1 needs two bodies: give the stimulus the object that the hand holds, "
               "one of the bodies, as %2"));
  if (needs != models.end() || models.empty()) return;
  if (stimulus.tool.value || !stimulus.tool.factor.empty()) {
    checked.report_key(
        pointer + "/tool",
        phrase("Protocols", "the model %1 touches a surface with a point; remove this key")
            .with(in_quotes(models.front()->id)));
  } else if (is_point_on_body(stimulus) && checked.protocol.scene == VisualTexture::on) {
    checked.report("/environment/scene",
                   phrase("Protocols",
                          "the scene cannot show the texture that the model %1 renders on a body; "
                          "set %2 to %3 or %4")
                       .with(in_quotes(models.front()->id), key_name("visual_texture"),
                             word_name("off"), word_name("neutral")));
  }
}

bool is_point_on_body(const StimulusTemplate& stimulus) {
  return (stimulus.surface.value || !stimulus.surface.factor.empty()) && !stimulus.tool.value &&
         stimulus.tool.factor.empty();
}

bool brings_its_relief(CheckedDocument& checked, const StimulusTemplate& stimulus,
                       const std::string& pointer) {
  const auto surfaces = texts_of(checked, stimulus.surface, pointer + "/surface");
  return !surfaces.empty() &&
         std::all_of(surfaces.begin(), surfaces.end(), [&checked](const auto& surface) {
           const auto body = checked.protocol.bodies.find(surface.first);
           return body == checked.protocol.bodies.end() || body->second.mesh ||
                  body->second.texture;
         });
}

bool is_on_a_body(CheckedDocument& checked, const StimulusTemplate& stimulus,
                  const std::string& texture, const std::string& pointer) {
  auto bodies = texts_of(checked, stimulus.surface, pointer + "/surface");
  for (auto& tool : texts_of(checked, stimulus.tool, pointer + "/tool"))
    bodies.push_back(std::move(tool));
  return std::any_of(bodies.begin(), bodies.end(), [&](const auto& named) {
    const auto body = checked.protocol.bodies.find(named.first);
    return body != checked.protocol.bodies.end() && body->second.texture == texture;
  });
}

}  // namespace asperity
