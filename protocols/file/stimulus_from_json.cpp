#include "protocols/file/stimulus_from_json.h"

#include <optional>

#include <nlohmann/json.hpp>

#include "protocols/file/json_reading.h"

namespace asperity {

namespace {

using nlohmann::json;

Binding<ParameterValue> parameter_binding(const json& value) {
  Binding<ParameterValue> binding{};
  if (value.is_object()) {
    binding.factor = value.at("factor").get<std::string>();
  } else if (value.is_string()) {
    binding.value = value.get<std::string>();
  } else {
    binding.value = value.get<double>();
  }
  return binding;
}

glm::dvec3 size_of(const json& object) {
  const json& size = object.at("size_m");
  return {size.at(0).get<double>(), size.at(1).get<double>(), size.at(2).get<double>()};
}

/// nullopt if a size is missing, which the check of meaning reports.
std::optional<Shape> shape_of(const json& object) {
  const auto found = object.find("shape");
  if (found == object.end()) return {};
  const auto shape = found->get<std::string>();
  if (shape == "plate" || shape == "box") {
    if (!object.contains("size_m")) return {};
    if (shape == "plate") return PlateShape{size_of(object)};
    return BoxShape{size_of(object)};
  }
  if (!object.contains("diameter_m")) return {};
  const auto diameter_m = object.at("diameter_m").get<double>();
  if (shape == "sphere") return SphereShape{diameter_m};
  if (shape == "disc") return disc_of(diameter_m);
  if (!object.contains("length_m")) return {};
  return CylinderShape{diameter_m, object.at("length_m").get<double>()};
}

}  // namespace

Texture texture_of(const std::string& name, const nlohmann::json& object) {
  Texture texture{};
  texture.name = name;
  read(object, "code", texture.code);
  read(object, "height_field", texture.height_field);
  read(object, "picture", texture.picture);
  read(object, "true_height_field", texture.true_height_field);
  for_each_named(object, "assets", [&](const std::string& role, const nlohmann::json& path) {
    texture.assets[role] = path.get<std::string>();
  });
  read(object, "spacing_m", texture.spacing_m);
  read(object, "note", texture.note);
  if (const auto found = object.find("prior"); found != object.end()) {
    ForceFeatures prior{};
    read(*found, "spectrum", prior.spectrum);
    read(*found, "size", prior.size);
    read(*found, "roughness", prior.roughness);
    texture.prior = prior;
  }
  return texture;
}

BodyDescription body_of(const std::string& name, const nlohmann::json& object) {
  BodyDescription body{};
  body.name = name;
  read(object, "mesh", body.mesh);
  body.shape = shape_of(object);
  read_choice(object, "axis", body.axis,
              {{"x", BodyAxis::x}, {"y", BodyAxis::y}, {"z", BodyAxis::z}});
  read(object, "texture", body.texture);
  return body;
}

StimulusTemplate stimulus_of(const std::string& name, const nlohmann::json& object) {
  StimulusTemplate stimulus{};
  stimulus.name = name;
  read(object, "model", stimulus.model);
  read(object, "texture", stimulus.texture);
  read(object, "surface", stimulus.surface);
  read(object, "tool", stimulus.tool);
  for_each_named(object, "parameters",
                 [&](const std::string& parameter, const nlohmann::json& value) {
                   stimulus.parameters[parameter] = parameter_binding(value);
                 });
  if (const auto found = object.find("equal_force"); found != object.end()) {
    EqualForce equal{};
    read(*found, "rms_N", equal.rms_N);
    read(*found, "to_model", equal.to_model);
    read(*found, "band_low_Hz", equal.band_low_Hz);
    read(*found, "band_high_Hz", equal.band_high_Hz);
    stimulus.equal_force = equal;
  }
  if (const auto found = object.find("material"); found != object.end()) {
    read(*found, "stiffness_N_per_m", stimulus.stiffness_N_per_m);
    read(*found, "friction", stimulus.friction);
  }
  return stimulus;
}

}  // namespace asperity
