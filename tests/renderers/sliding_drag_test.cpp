// The mean drag of the models that differ only in their texture, and its modulation by the texture.

#include "renderers/offline/sliding_drag.h"

#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "renderers/models/sinusoid.h"
#include "renderers/models/stochastic.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

RendererInputs textured(const std::string& law, double stiffness_N_per_m = 500.0) {
  return {.parameters = {{"friction_law", law}},
          .material = {.stiffness_N_per_m = stiffness_N_per_m, .friction = 0.2},
          .height_field = grating(),
          .assets = files_of_models(),
          .seed = 3};
}

// The low-pass of the normal force has the mean age 0.5 ms.
constexpr double kAge_s = 0.5e-3;

TEST(SlidingDrag, IsThatOfCoulombForEveryModelWithElastoplasticFrictionAtEveryRate) {
  for (const double rate_Hz : {500.0, 1000.0, 4000.0}) {
    for (const double stiffness_N_per_m : {500.0, 2000.0}) {
      for (const ForceModel& model : point_models()) {
        const std::string& id = model.declaration.id;
        const SlidingDrag drag =
            sliding_drag(model, textured("elastoplastic", stiffness_N_per_m), {.rate_Hz = rate_Hz});
        // Noise in time is no function of the place.
        const double tolerance = id == "auto_regressive" ? 0.03 : 0.01;
        EXPECT_NEAR(drag.mean_N / drag.coulomb_N, 1.0, tolerance) << id << ' ' << rate_Hz;
        // That of white noise is a test of its own.
        if (id == "stochastic") continue;
        EXPECT_NEAR(drag.modulation, 1.0, 0.05) << id << ' ' << rate_Hz << ' ' << stiffness_N_per_m;
      }
    }
  }
}

// A low-pass of the age τ has the real part 1/(1 + (2πfτ)²) at f = v/λ: 99.4 % at 24 Hz.
TEST(SlidingDrag, ShowsTheModulationOfGratingsAlmostCompletely) {
  for (const auto& [wavelength_m, least] :
       {std::pair(2.5e-3, 0.98), std::pair(2e-3, 0.97), std::pair(1.5e-3, 0.95)}) {
    for (const double rate_Hz : {500.0, 1000.0, 2000.0, 4000.0}) {
      RendererInputs inputs = textured("elastoplastic");
      inputs.parameters["amplitude_m"] = 5e-5;
      inputs.parameters["wavelength_m"] = wavelength_m;
      const SlidingDrag drag = sliding_drag(sinusoid_model(), inputs, {.rate_Hz = rate_Hz});
      EXPECT_NEAR(drag.mean_N / drag.coulomb_N, 1.0, 0.01) << wavelength_m << ' ' << rate_Hz;
      EXPECT_GT(drag.modulation, least) << wavelength_m << ' ' << rate_Hz;
      EXPECT_LE(drag.modulation, 1.0 + 1e-9) << wavelength_m << ' ' << rate_Hz;
    }
  }
}

TEST(SlidingDrag, IsThatOfCoulombUnderStrongTexturesAndNoise) {
  RendererInputs inputs = textured("elastoplastic");
  inputs.parameters["amplitude_m"] = 4e-4;
  inputs.parameters["wavelength_m"] = 4e-3;
  SlidingDrag drag = sliding_drag(sinusoid_model(), inputs);
  EXPECT_NEAR(drag.mean_N / drag.coulomb_N, 1.0, 0.01);
  EXPECT_GT(drag.modulation, 0.98);
  for (const double noise_N : {0.1, 0.3}) {
    inputs = textured("elastoplastic");
    inputs.parameters["noise_sd_N"] = noise_N;
    drag = sliding_drag(stochastic_model(), inputs);
    EXPECT_NEAR(drag.mean_N / drag.coulomb_N, 1.0, 0.01) << noise_N;
    // The first weight of the low-pass, T/(T + τ): noise that is white up to the Nyquist frequency.
    EXPECT_NEAR(drag.modulation, 1e-3 / (1e-3 + kAge_s), 0.02) << noise_N;
  }
}

// 1/√(1 + (10/60)²) with `rounded`; `dahl` loses where the normal force increases.
TEST(SlidingDrag, ShowsWhatOtherLawsLose) {
  const SlidingDrag rounded = sliding_drag(sinusoid_model(), textured("rounded"));
  EXPECT_NEAR(rounded.mean_N / rounded.coulomb_N, 0.98639, 1e-4);
  const SlidingDrag dahl = sliding_drag(sinusoid_model(), textured("dahl", 2000.0));
  EXPECT_LT(dahl.mean_N / dahl.coulomb_N, 0.9);
  EXPECT_LT(dahl.modulation, 0.3);
}

TEST(SlidingDrag, RejectsStrokesThatAreNotPositive) {
  EXPECT_THROW(sliding_drag(sinusoid_model(), textured("dahl"), {.speed_m_per_s = 0.0}),
               std::invalid_argument);
}

// The mean normal force is N + kA = 6 N, and 2 · 0.8 · 6 N/(120 N/m) = 80 mm behind a reversal are left out of 40 mm.
TEST(SlidingDrag, LengthensStrokesOnWhichFrictionWouldNotTurnRound) {
  RendererInputs inputs = textured("elastoplastic", 5000.0);
  inputs.material.friction = 0.8;
  inputs.parameters["amplitude_m"] = 1e-3;
  const SlidingDrag drag = sliding_drag(sinusoid_model(), inputs);
  EXPECT_NEAR(drag.coulomb_N, 0.8 * 6.0, 0.05);
  EXPECT_NEAR(drag.mean_N / drag.coulomb_N, 1.0, 0.01);
  EXPECT_GT(drag.modulation, 0.95);
}

}  // namespace
}  // namespace asperity
