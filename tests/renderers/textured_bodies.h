// Small textured bodies for the tests of contacts between them.

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/textured_shape.h"
#include "stimuli/meshes/triangle_mesh.h"
#include "tests/renderers/pd_gradient_surfaces.h"
#include "tests/renderers/surfaces.h"

namespace asperity {

/// h = A·sin(2πx/λ) with ten samples a wavelength, and a texel for each.
inline TexturedMesh with_grating(const Shape& shape, const Grating& wave, double rim_m) {
  return textured_shape(shape,
                        *grating({.amplitude_m = wave.amplitude_m,
                                  .wavelength_m = wave.wavelength_m,
                                  .pitch_m = wave.wavelength_m / 10.0}),
                        {.rim_m = rim_m, .samples_per_wavelength = 2.0});
}

/// A plate of 20 mm with the grating on its upper side, which lies in z = 0.
inline TexturedMesh grated_plate(const Grating& wave) {
  return with_grating(PlateShape{{0.02, 0.02, 0.008}}, wave, 0.001);
}

/// A mesh as a body without texture.
inline TexturedMesh bare(const TriangleMesh& mesh) {
  TexturedMesh body;
  body.vertices_m = mesh.vertices_m;
  body.triangles = mesh.triangles;
  body.places.assign(mesh.triangles.size(), {});
  body.atlas = {.rows = 1, .columns = 1, .step_m = 0.0, .values = {0}};
  set_normals(body);
  return body;
}

/// The same body with its own frame's origin elsewhere.
inline TexturedMesh shifted(TexturedMesh body, const glm::dvec3& by_m) {
  for (glm::dvec3& vertex_m : body.vertices_m) vertex_m += by_m;
  return body;
}

inline std::shared_ptr<const TexturedMesh> shared(TexturedMesh body) {
  return std::make_shared<const TexturedMesh>(std::move(body));
}

}  // namespace asperity
