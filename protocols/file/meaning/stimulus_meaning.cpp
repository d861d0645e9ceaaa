// Implements the checks that stimuli can be made: models, parameters, textures, equal force.

#include <algorithm>

#include "protocols/file/meaning/meaning_checks.h"

namespace asperity {

namespace {

/// The position of a level of a factor: of the formula, where the level is computed.
std::string place_of_level(CheckedDocument& checked, const std::string& factor, std::size_t level) {
  for (const auto& [name, block] : checked.protocol.blocks) {
    if (block.derived.contains(factor)) {
      return pointer_to(pointer_to("/blocks", name) + "/derived", factor);
    }
  }
  return pointer_to(pointer_to("/factors", factor) + "/levels", level);
}

/// Whether the textures have the files that the models declare.
void check_assets_of(CheckedDocument& checked, const StimulusTemplate& stimulus,
                     const std::vector<const ModelDeclaration*>& models,
                     const std::string& pointer) {
  const bool has_texture = stimulus.texture.value || !stimulus.texture.factor.empty();
  for (const ModelDeclaration* const model : models) {
    for (const AssetDeclaration& asset : model->assets) {
      if (!has_texture) {
        checked.report(pointer, phrase("Protocols",
                                       "the model %1 needs the asset %2 (%3): give the stimulus a "
                                       "%4 that has it")
                                    .with(in_quotes(model->id), in_quotes(asset.role),
                                          asset.meaning, key_name("texture")));
      }
      for (const auto& [name, place] : texts_of(checked, stimulus.texture, pointer + "/texture")) {
        const auto texture = checked.protocol.textures.find(name);
        if (texture == checked.protocol.textures.end() ||
            texture->second.assets.contains(asset.role)) {
          continue;
        }
        checked.report(place,
                       phrase("Protocols",
                              "the model %1 needs the asset %2 (%3), which the texture %4 does not "
                              "have: add its file under %5")
                           .with(in_quotes(model->id), in_quotes(asset.role), asset.meaning,
                                 in_quotes(name), key_name("assets")));
      }
    }
  }
}

void check_equal_force(CheckedDocument& checked, const StimulusTemplate& stimulus,
                       const std::string& pointer) {
  const EqualForce& equal = *stimulus.equal_force;
  const std::string place = pointer + "/equal_force";
  if (equal.band_low_Hz >= equal.band_high_Hz) {
    checked.report(place, phrase("Protocols",
                                 "the band from %1 Hz to %2 Hz is empty; lower its lower limit or "
                                 "raise its upper limit")
                              .with(digits(equal.band_low_Hz), digits(equal.band_high_Hz)));
  }
  if (equal.band_high_Hz > 0.5 * checked.protocol.rate_Hz) {
    checked.report(place, phrase("Protocols",
                                 "the band ends at %1 Hz, above half the servo rate of %2 Hz; "
                                 "lower its upper limit")
                              .with(digits(equal.band_high_Hz), digits(checked.protocol.rate_Hz)));
  }
  if (equal.rms_N && *equal.rms_N > checked.protocol.force_limit_N) {
    checked.report(place + "/rms_N",
                   phrase("Protocols",
                          "%1 N exceeds the force limit of %2 N (%3); lower the force or raise the "
                          "limit")
                       .with(digits(*equal.rms_N), digits(checked.protocol.force_limit_N),
                             place_name("/device/force_limit_N")));
  }
  if (!equal.to_model.empty() && !checked.models.contains(equal.to_model)) {
    checked.report(place + "/to_model",
                   unknown_name("force model", equal.to_model, checked.models));
  } else if (!equal.to_model.empty() && checked.models.find(equal.to_model)->second->needs_bodies) {
    checked.report(place + "/to_model",
                   phrase("Protocols",
                          "the model %1 cannot be the reference of equal force: its texture force "
                          "depends on two bodies; state %2 instead")
                       .with(in_quotes(equal.to_model), key_name("rms_N")));
  }
  for (const auto& [id, at] : texts_of(checked, stimulus.model, pointer + "/model")) {
    const auto model = checked.models.find(id);
    if (model == checked.models.end()) continue;
    // The reference model of equal force is compared with its default amplitude: with a different amplitude it would be
    // the only model of another strength.
    const std::optional<std::string>& amplitude = model->second->amplitude_parameter;
    if (model->second->needs_bodies) {
      checked.report(
          at, phrase("Protocols",
                     "the texture force of the model %1, which depends on two bodies, cannot be "
                     "made equal to another; remove %2, and state the strength as %3")
                  .with(in_quotes(id), key_name("equal_force"),
                        amplitude ? Phrase(in_quotes(*amplitude)) : key_name("parameters")));
    } else if (!amplitude) {
      if (id == equal.to_model) continue;
      checked.report(at, phrase("Protocols",
                                "the model %1 has no amplitude by which its texture force could be "
                                "made equal; remove %2 or use another model")
                             .with(in_quotes(id), key_name("equal_force")));
    } else if (stimulus.parameters.contains(*amplitude)) {
      checked.report_key(
          pointer_to(pointer + "/parameters", *amplitude),
          (id == equal.to_model
               ? phrase("Protocols",
                        "the texture forces of the other models are made equal to that of %1 with "
                        "this parameter at its default; remove this key")
               : phrase("Protocols", "%2 determines this parameter of %1; remove this key"))
              .with(in_quotes(id), key_name("equal_force")));
    }
  }
}

}  // namespace

std::vector<std::pair<std::string, std::string>> texts_of(CheckedDocument& checked,
                                                          const Binding<std::string>& binding,
                                                          const std::string& pointer) {
  if (binding.value) return {{*binding.value, pointer}};
  const auto factor = checked.protocol.factors.find(binding.factor);
  if (factor == checked.protocol.factors.end()) {
    if (!binding.factor.empty()) {
      checked.report(pointer + "/factor",
                     unknown_name("factor", binding.factor, checked.protocol.factors));
    }
    return {};
  }
  std::vector<std::pair<std::string, std::string>> texts{};
  for (std::size_t i = 0; i < factor->second.levels.size(); ++i) {
    const std::string place = place_of_level(checked, binding.factor, i);
    if (const auto* const text = std::get_if<std::string>(&factor->second.levels[i])) {
      texts.emplace_back(*text, place);
    } else {
      checked.report(place, phrase("Protocols",
                                   "%1 is a number, but the factor is used as a name at %2; use "
                                   "names as its levels")
                                .with(text_of(factor->second.levels[i]), place_name(pointer)));
    }
  }
  return texts;
}

void check_stimulus(CheckedDocument& checked, const StimulusTemplate& stimulus,
                    const std::string& pointer) {
  std::vector<const ModelDeclaration*> models{};
  bool needs_height_field = false;
  for (const auto& [id, place] : texts_of(checked, stimulus.model, pointer + "/model")) {
    const auto model = checked.models.find(id);
    if (model == checked.models.end()) {
      const Phrase unknown = unknown_name("force model", id, checked.models);
      checked.report(place,
                     (unknown.english().ends_with('?')
                          ? phrase("Protocols",
                                   "%1 If it is in a plug-in, load the plug-in with "
                                   "--plugin FILE, or under Study → Plug-ins… in the windows")
                          : phrase("Protocols",
                                   "%1; if it is in a plug-in, load the plug-in with "
                                   "--plugin FILE, or under Study → Plug-ins… in the windows"))
                         .with(unknown));
      continue;
    }
    models.push_back(model->second);
    const std::optional<double>& highest_Hz = model->second->maximum_rate_Hz;
    if (highest_Hz && checked.protocol.rate_Hz > *highest_Hz) {
      checked.report(place,
                     phrase("Protocols",
                            "a tick of the force model %1 takes longer than a period at the %2 Hz "
                            "of %3: set it to at most %4, or choose another model")
                         .with(id, digits(checked.protocol.rate_Hz), place_name("/device/rate_Hz"),
                               digits(*highest_Hz)));
    }
    needs_height_field = needs_height_field || model->second->needs_height_field;
  }
  check_bodies_of(checked, stimulus, models, pointer);
  const bool all_need_bodies = !models.empty() && std::all_of(models.begin(), models.end(),
                                                              [](const ModelDeclaration* each) {
                                                                return each->needs_bodies;
                                                              });
  const bool has_texture = stimulus.texture.value || !stimulus.texture.factor.empty();
  if (needs_height_field && !has_texture) {
    checked.report(pointer,
                   phrase("Protocols", "the model needs a height field: give the stimulus a %1")
                       .with(key_name("texture")));
  }
  std::vector<const ModelDeclaration*> rendered = models;
  if (stimulus.equal_force) {
    const auto reference = checked.models.find(stimulus.equal_force->to_model);
    if (reference != checked.models.end()) rendered.push_back(reference->second);
  }
  check_assets_of(checked, stimulus, rendered, pointer);
  const bool all_need_assets_alone =
      !models.empty() &&
      std::all_of(models.begin(), models.end(), [](const ModelDeclaration* each) {
        return !each->assets.empty() && !each->needs_height_field && !each->needs_bodies;
      });
  const auto named = texts_of(checked, stimulus.texture, pointer + "/texture");
  for (const auto& [name, place] : named) {
    const auto texture = checked.protocol.textures.find(name);
    if (texture == checked.protocol.textures.end()) {
      checked.report(place, unknown_name("texture", name,
                                         names_not_in(names_of(named), checked.protocol.textures)));
    } else if (all_need_bodies && brings_its_relief(checked, stimulus, pointer)) {
      // The texture is the name and the picture of a body's own relief.
      if (texture->second.height_field && !is_on_a_body(checked, stimulus, name, pointer)) {
        checked.report(
            place,
            phrase("Protocols",
                   "the height field of the texture %1 is on neither body: the surface has its own "
                   "relief; put the texture on a body, or remove its %2")
                .with(in_quotes(name), key_name("height_field")));
      }
    } else if (!texture->second.height_field && !all_need_assets_alone) {
      checked.report(place,
                     phrase("Protocols", "the texture %1 cannot be felt: it has no %2; give it one")
                         .with(in_quotes(name), key_name("height_field")));
    }
  }
  for (const auto& [name, binding] : stimulus.parameters) {
    const std::string place = pointer_to(pointer + "/parameters", name);
    std::vector<std::pair<ParameterValue, std::string>> values{};
    if (binding.value) {
      values.emplace_back(*binding.value, place);
    } else if (const auto factor = checked.protocol.factors.find(binding.factor);
               factor != checked.protocol.factors.end()) {
      for (std::size_t i = 0; i < factor->second.levels.size(); ++i) {
        values.emplace_back(factor->second.levels[i], place_of_level(checked, binding.factor, i));
      }
    } else {
      checked.report(place + "/factor",
                     unknown_name("factor", binding.factor, checked.protocol.factors));
    }
    for (const ModelDeclaration* const model : models) {
      const auto declared =
          std::find_if(model->parameters.begin(), model->parameters.end(),
                       [&name = name](const Parameter& each) { return each.name == name; });
      if (declared == model->parameters.end()) {
        std::map<std::string, int> names{};
        for (const Parameter& each : model->parameters) names[each.name] = 0;
        checked.report_key(place,
                           phrase("Protocols", "the model %1: %2")
                               .with(in_quotes(model->id), unknown_name("parameter", name, names)));
        continue;
      }
      for (const auto& [value, at] : values) {
        if (const auto complaint = complaint_about(*declared, value))
          checked.report(at, *complaint);
      }
    }
  }
  // Values bound to factors are checked in the trials that set them.
  ParameterValues constants{};
  for (const auto& [name, binding] : stimulus.parameters) {
    if (binding.value) constants.emplace(name, *binding.value);
  }
  if (constants.size() == stimulus.parameters.size()) {
    for (const ModelDeclaration* const model : models)
      check_together(checked, *model, constants, pointer);
  }
  if (stimulus.equal_force) check_equal_force(checked, stimulus, pointer);
}

void check_together(CheckedDocument& checked, const ModelDeclaration& model,
                    const ParameterValues& given, const std::string& pointer) {
  if (!model.conflict_among) return;
  ParameterValues complete{};
  for (const Parameter& declared : model.parameters) {
    const auto found = given.find(declared.name);
    const ParameterValue& value = found == given.end() ? declared.default_value : found->second;
    if (complaint_about(declared, value)) return;  // reported at its own location
    complete.emplace(declared.name, value);
  }
  const std::optional<ParameterConflict> conflict = model.conflict_among(complete);
  if (!conflict) return;
  const auto changeable =
      std::find_if(conflict->parameters.begin(), conflict->parameters.end(),
                   [&given](const std::string& name) { return given.contains(name); });
  checked.report(changeable == conflict->parameters.end()
                     ? pointer
                     : pointer_to(pointer + "/parameters", *changeable),
                 conflict->message);
}

}  // namespace asperity
