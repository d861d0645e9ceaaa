// Declares a stimulus of two textured bodies as a point on one relief.

#pragma once

#include <optional>

#include "renderers/force/force_model.h"
#include "renderers/offline/felt_stiffness.h"
#include "renderers/offline/force_matching.h"
#include "renderers/offline/texture_waves.h"

namespace asperity {

/// The spring and the damper between the hand and a simulated tool.
struct VirtualCoupling {
  double stiffness_N_per_m = 0.0;
  double damping_N_s_per_m = 0.0;
};

/// The stroke for which two bodies become one relief.
struct ReliefStroke {
  double length_m = 0.0;
  double direction_rad = 0.0;  ///< from +x towards +y
};

/// Two textured bodies as the hand feels them along a stroke: a point on the relief that both make under the tool's tip
/// (composed_relief.h), behind the spring of the virtual coupling if there is one. A wave of the tool against one of
/// the surface counts as the two meet; a texture that the tool does not reach does not count.
///
/// Limits: those of composed_relief; the smooth maximum counts as the hard one.
struct BodiesAsRelief {
  /// A model of a point whose force is −k·δ·∇δ, pd_gradient's law, with its inputs; k is the stiffness of the contact.
  const ForceModel* point = nullptr;
  RendererInputs inputs{};
  /// √2 times the RMS of the relief, and the finest wave of either texture (finest_wave.h); empty if neither body has a
  /// texture.
  TextureWaves waves{};
  double contact_damping_N_s_per_m = 0.0;
  std::optional<VirtualCoupling> coupling{};
};

/// `bodies` has a tool, a surface and complete parameters of pd_gradient. Errors: std::runtime_error if `models` has no
/// height_map; as composed_relief.
BodiesAsRelief bodies_as_relief(const RendererInputs& bodies, const ReliefStroke& stroke,
                                const ModelRegistry& models);

/// The stiffness of the contact, without the coupling: differences over one sample of the relief, because the samples
/// are the model and not the curve between them. Errors: as felt_stiffness.
std::optional<FeltStiffness> felt_stiffness(const BodiesAsRelief& relief, double force_limit_N);

/// The texture force within the stroke, where the relief is: its waves are not repeated, and `path` gives everything but
/// the duration. Behind a coupling of stiffness k_t the force is that of a surface of K·k_t/(K + k_t). Errors: as
/// texture_force_rms_N of a model.
double texture_force_rms_N(const BodiesAsRelief& relief, const TextureForcePath& path);

}  // namespace asperity
