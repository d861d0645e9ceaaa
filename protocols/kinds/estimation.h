// The checks of the key "estimation": the factors, the predictor and the modulus of magnitude estimates.

#pragma once

#include <cstddef>
#include <string_view>

#include "protocols/design/problem_sink.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// The different spacings, or values of a predictor, that a curve needs: those of a parabola.
inline constexpr std::size_t kLevelsOfCurve = 3;

/// The two ways to estimate, as keys of "estimation" (KindTest::estimated_by).
inline constexpr std::string_view kBySpacing = "spacing";
inline constexpr std::string_view kByFactor = "factor";

/// Whether the estimates of a protocol can be analysed as it states (EstimationDeclaration), and its main blocks present
/// what that needs. Nothing where it states nothing.
void check_estimation(const Protocol& protocol, ProblemSink& problems);

/// Whether a predictor (EstimationDeclaration) is computed from the recordings of the attempts: the force in an octave of
/// wavelength.
inline bool is_of_recordings(std::string_view predictor) noexcept {
  return predictor.starts_with("waves_");
}

}  // namespace asperity
