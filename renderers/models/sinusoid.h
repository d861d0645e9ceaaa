// Declares the sinusoid model: a sinusoidal grating rendered through a spring.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders an analytic sinusoidal grating.
///
///   q   = x·cos θ + y·sin θ                along the grating [m]; 0 at the patch's centre
///   h   = A·sin(2πq/L) + A                 height over the plane z_s [m]
///   w   = max(0, h − (p_z − z_s))          penetration [m]
///   F   = k·w·n − D                D the drag of the friction (force/friction.h)
///
/// A = `amplitude_m`, L = `wavelength_m`, θ = `direction_rad` from +x towards +y; k, μ of the Material.
/// `force_direction = fixed` (default): n = ẑ, as in [Wu 2009] (F_mag of [Choi 2004], which is known for ridges that
/// push the hand into the next valley). `local_normal`: n is the unit normal of the grating, (−∂h/∂x, −∂h/∂y, 1)/√(1 +
/// |∇h|²) (F_vec). `gradient`: n = (−∂h/∂x, −∂h/∂y, 1), so that without friction F = −∇U of the energy U = ½·k·w²: the
/// only one of the three with no work on a closed path. D is the drag of F·ẑ: k·w, and k·w/√(1 + |∇h|²) with
/// `local_normal`. Slopes are derivatives with respect to the device's motion, so they include `motion_scale`.
///
/// [Wu 2009] gives neither A nor L. The values suggested for a texture sample are A = √2·RMS of its heights, which
/// gives the grating the sample's RMS, and L = the sample's dominant wavelength; a plane has no dominant wavelength and
/// leaves L at its default.
///
/// Limits: one direction, one wavelength, no saturation with depth.
///
/// [Choi 2004] Choi, Tan: Perceived instability of virtual haptic texture. I. Experimental studies.
/// [Wu 2009] Wu, Song, Zou: A novel haptic texture display based on image processing.
ForceModel sinusoid_model();

}  // namespace asperity
