// Force models and a small protocol for the tests of this folder.

#pragma once

#include <string>
#include <vector>

#include "stimuli/properties/parameter.h"

namespace asperity::test {

/// Declarations like those of the program, but only as many as the tests need.
inline std::vector<ModelDeclaration> example_models() {
  const auto number = [](const char* name, double minimum, double maximum, double value) {
    Parameter parameter{};
    parameter.name = name;
    parameter.minimum = minimum;
    parameter.maximum = maximum;
    parameter.default_value = value;
    return parameter;
  };
  Parameter law{};
  law.name = "law";
  law.kind = ParameterKind::choice;
  law.choices = {"corrected", "literal"};
  law.default_value = std::string("corrected");
  ModelDeclaration height_map{};
  height_map.id = "height_map";
  height_map.needs_height_field = true;
  height_map.amplitude_parameter = "height_scale";
  height_map.parameters = {number("height_scale", 0.0, 10.0, 1.0), law};
  ModelDeclaration sinusoid{};
  sinusoid.id = "sinusoid";
  sinusoid.amplitude_parameter = "amplitude_m";
  sinusoid.parameters = {number("amplitude_m", 0.0, 0.01, 0.0001),
                         number("wavelength_m", 1e-4, 0.1, 0.0025)};
  for (Parameter& parameter : sinusoid.parameters) parameter.unit = "m";
  Parameter direction = law;
  direction.name = "force_direction";
  direction.choices = {"fixed", "local_normal"};
  direction.default_value = std::string("fixed");
  sinusoid.parameters.push_back(direction);
  ModelDeclaration stochastic{};
  stochastic.id = "stochastic";
  stochastic.needs_height_field = true;
  stochastic.amplitude_parameter = "noise_sd_N";
  stochastic.parameters = {number("noise_sd_N", 0.0, 5.0, 0.1)};
  ModelDeclaration plain{};
  plain.id = "plain";
  ModelDeclaration two_bodies{};
  two_bodies.id = "pd_gradient";
  two_bodies.needs_bodies = true;
  two_bodies.amplitude_parameter = "texture_gain";
  two_bodies.parameters = {number("texture_gain", 0.0, 10.0, 1.0), number("step", 1.0, 9.0, 2.0),
                           number("cell", 1.0, 9.0, 2.0), number("step_m", 1e-6, 1e-3, 1e-4),
                           number("cell_m", 1e-6, 1e-3, 1e-4)};
  two_bodies.conflict_among = [](const ParameterValues& values) {
    return std::get<double>(values.at("step")) < std::get<double>(values.at("cell"))
               ? std::optional(
                     ParameterConflict{.parameters = {"step", "cell"},
                                       .message = phrase("Test", "a step is at least a cell")})
               : std::nullopt;
  };
  return {height_map, sinusoid, stochastic, plain, two_bodies};
}

/// A selection that the reader accepts: 3 models × 2 textures × 2 repetitions.
inline std::string example_selection() {
  return R"({
  "format": "asperity.protocol/1",
  "kind": "selection",
  "design": "improved",
  "name": "example_selection",
  "version": "1.0.0",
  "title": "Which rendering feels most like the picture?",
  "consent": {"version": "1", "statement": "I take part and may stop at any time."},
  "realism_standard": "photograph",
  "device": {"rate_Hz": 1000, "force_limit_N": 5},
  "textures": {
    "metal": {"height_field": "stimuli/metal.png", "picture": "stimuli/metal_photo.png"},
    "stone": {"height_field": "stimuli/stone.png", "picture": "stimuli/stone_photo.png"}
  },
  "factors": {
    "model": {"levels": ["height_map", "sinusoid", "stochastic"]},
    "texture": {"levels": ["metal", "stone"]}
  },
  "stimuli": {
    "rendered": {
      "model": {"factor": "model"},
      "texture": {"factor": "texture"},
      "equal_force": {"to_model": "height_map"}
    }
  },
  "explorations": {
    "stroking": {
      "normal_force_N": {"minimum": 0.5, "target": 1, "maximum": 2},
      "speed_m_per_s": {"minimum": 0.03, "target": 0.06, "maximum": 0.12},
      "stroke_length_m": {"target": 0.06},
      "strokes": {"target": 4},
      "minimum_contact_s": 2,
      "maximum_contact_s": 15
    }
  },
  "blocks": {
    "main": {
      "crossed": ["texture"],
      "repetitions": 3,
      "order": "shuffle",
      "maximum_in_a_row": {"texture": 2},
      "presented": [
        {"stimulus": "rendered", "with": {"model": "height_map"}},
        {"stimulus": "rendered", "with": {"model": "sinusoid"}},
        {"stimulus": "rendered", "with": {"model": "stochastic"}}
      ],
      "positions": "balanced",
      "question": {"name": "most_realistic", "prompt": "Which felt most like the picture?"},
      "exploration": "stroking"
    }
  },
  "flow": [
    {"screen": "Welcome."},
    {"check": "device"},
    {"run": "main", "break_every_trials": 3, "pause": {"minimum_s": 60}}
  ]
}
)";
}

/// The same question about tools on a plate, which the reader accepts as well: one tool is a mesh, the
/// others are shapes with a relief.
inline std::string example_bodies() {
  return R"({
  "format": "asperity.protocol/1",
  "kind": "selection",
  "design": "improved",
  "name": "example_bodies",
  "version": "1.0.0",
  "title": "Which tool is the roughest?",
  "consent": {"version": "1", "statement": "I take part and may stop at any time."},
  "realism_standard": "memory",
  "textures": {
    "metal": {"height_field": "stimuli/metal.png"},
    "stone": {"height_field": "stimuli/stone.png"},
    "rasp": {"picture": "stimuli/rasp_photo.png"}
  },
  "factors": {
    "ground": {"levels": ["metal", "stone"]},
    "held": {"levels": ["ball", "roll", "rasp"]}
  },
  "bodies": {
    "plate": {"shape": "plate", "size_m": [0.08, 0.06, 0.01]},
    "ball": {"shape": "sphere", "diameter_m": 0.01},
    "roll": {"shape": "cylinder", "diameter_m": 0.008, "length_m": 0.01, "axis": "x", "texture": "stone"},
    "rasp": {"mesh": "stimuli/rasp.mesh"}
  },
  "stimuli": {
    "felt": {
      "model": "pd_gradient",
      "texture": {"factor": "ground"},
      "surface": "plate",
      "tool": {"factor": "held"}
    }
  },
  "explorations": {"stroking": {"minimum_contact_s": 1, "maximum_contact_s": 10}},
  "blocks": {
    "main": {
      "crossed": ["ground"],
      "presented": [
        {"stimulus": "felt", "with": {"held": "ball"}, "item": "ball"},
        {"stimulus": "felt", "with": {"held": "roll"}, "item": "roll"},
        {"stimulus": "felt", "with": {"held": "rasp"}, "item": "rasp"}
      ],
      "question": {"name": "roughest", "prompt": "Which tool felt the roughest?"},
      "exploration": "stroking"
    }
  },
  "flow": [{"run": "main"}]
}
)";
}

}  // namespace asperity::test
