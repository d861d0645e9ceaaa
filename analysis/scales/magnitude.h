// Magnitude estimation: how a felt size grows with a physical one.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "analysis/numbers/proportion.h"
#include "analysis/tests/t_test.h"

namespace asperity {

/// One number that a participant gave. Participants, conditions (the probes, say) and levels (the
/// spacings) are places in lists of the caller's.
struct MagnitudeEstimate {
  std::size_t participant = 0;
  std::size_t condition = 0;
  std::size_t level = 0;
  double estimate = 0.0;
};

/// A zero has no logarithm: it is left out, or stands for half of the participant's smallest
/// positive estimate.
enum class ZeroRule { exclude, half_of_least };

/// The estimates without zeros. Throws std::invalid_argument for an estimate that is negative or
/// not finite, and where `half_of_least` meets a participant without any positive estimate.
std::vector<MagnitudeEstimate> without_zeros(std::span<const MagnitudeEstimate> estimates,
                                             ZeroRule rule);

/// Mean log₁₀ estimates of the participants that have at least one estimate in every cell.
///
/// A cell is the mean over its repetitions, so repetitions that are missing in one do not weigh on
/// the others.
struct MagnitudeCells {
  std::vector<std::size_t> complete{};    ///< participants, in their order
  std::vector<std::size_t> incomplete{};  ///< left out: an empty cell
  /// By condition: complete participants × levels.
  std::vector<Eigen::MatrixXd> log10{};
};
struct MagnitudeDesign {
  std::size_t participants = 0;
  std::size_t conditions = 0;
  std::size_t levels = 0;
};
/// Positive estimates only; throws std::invalid_argument for others and for places outside the
/// design.
MagnitudeCells magnitude_cells(std::span<const MagnitudeEstimate> estimates,
                               const MagnitudeDesign& design);

/// Mean over the cells of each complete participant, log₁₀.
Eigen::VectorXd participant_means(const MagnitudeCells& cells);

/// Removes each participant's own scale: L − (mean of the participant's cells) + (grand mean).
std::vector<Eigen::MatrixXd> normalised_to_grand_mean(const MagnitudeCells& cells);
/// Or with a standard: L − (mean at the standard level over conditions) + log₁₀(modulus).
struct MagnitudeStandard {
  std::size_t level = 0;
  double modulus = 1.0;
};
std::vector<Eigen::MatrixXd> normalised_to_standard(const MagnitudeCells& cells,
                                                    const MagnitudeStandard& standard);

/// Curves over x = log₁₀ of the physical size, one participant per row of `log10`, one level per
/// column; at least two participants, and at least as many different levels as coefficients.
/// Otherwise every function below throws std::invalid_argument.
struct MagnitudeCurves {
  Eigen::MatrixXd log10{};
  Eigen::VectorXd x{};
  double confidence = 0.95;
};

/// log₁₀R = a + n·x by least squares per participant; n is the exponent of the power law. The line
/// through the means of all participants has the same slope, but `pooled_slope_se` from its
/// residuals says nothing about participants.
struct PowerLaw {
  std::vector<double> exponents{};
  OneSampleT exponent{};  ///< over participants, against 0
  double intercept = 0.0;
  double pooled_slope = 0.0;
  double pooled_slope_se = 0.0;
  double pooled_r2 = 0.0;  ///< NaN where the means are all the same
};
PowerLaw power_law(const MagnitudeCurves& curves);

/// a + b·x + c·x².
struct Quadratic {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;

  double slope(double x) const noexcept { return b + 2.0 * c * x; }
  /// −b/(2c); nothing unless c < 0.
  std::optional<double> peak() const noexcept;
};

/// The shape of one participant's curve between the lowest and the highest x, by its slopes there:
/// the kinds that [Kornbrot 2007] counted, descending and quadratic, and the rest. No test decides.
///
/// [Kornbrot 2007] Kornbrot, Penn, Petrie, Furner, Hardwick: Roughness perception in haptic virtual
/// reality for sighted and blind people.
enum class CurveType {
  descending,  ///< falls at both ends
  inverted_u,  ///< rises at the lowest x and falls at the highest
  other
};
struct TestedRange {
  double lowest_x = 0.0;
  double highest_x = 0.0;
};
CurveType curve_type(const Quadratic& curve, const TestedRange& tested) noexcept;

/// The one-sided test that the mean curve rises at the lowest x, or falls at the highest: an
/// inverted U needs both [Lind 2010], its p is the larger one.
///
/// [Lind 2010] Lind, Mehlum: With or without U? The appropriate test for a U-shaped relationship.
struct EndSlope {
  double slope = 0.0;
  std::optional<double> t{};
  std::optional<double> p{};
};

enum class PeakStatus {
  inside,         ///< between the lowest and the highest x
  outside_range,  ///< the curve is bent downwards, but its peak was not tested
  no_maximum      ///< c ≥ 0
};

/// Quadratic curves per participant, and the peak of their mean.
///
/// The peak is x* = −b/(2c) of the mean coefficients; its standard error follows by the delta
/// method from the covariance of the means between participants, t with N − 1 degrees of freedom.
/// Fieller's set {x: (b + 2cx)² ≤ t²·(V_bb + 4x·V_bc + 4x²·V_cc)} does not rest on a linearisation;
/// it is absent where it is no interval, because c is not clearly below 0 [Fieller 1954].
///
/// [Fieller 1954] Fieller: Some problems in interval estimation.
struct QuadraticFit {
  std::vector<Quadratic> participants{};
  Quadratic mean{};
  Eigen::Matrix3d covariance{};  ///< of the mean coefficients a, b, c between participants
  OneSampleT curvature{};        ///< c over participants, against 0
  double pooled_r2 = 0.0;     ///< of the curve through the means; NaN where these are all the same
  std::optional<double> F{};  ///< of the curve against the line, through the means
  std::optional<double> p{};
  std::array<EndSlope, 2> ends{};  ///< rising at the lowest x, falling at the highest
  /// Of the test that the curve has its maximum between them; nothing where an end has no test.
  std::optional<double> interior_maximum_p() const;

  PeakStatus status = PeakStatus::no_maximum;
  struct Peak {
    double x = 0.0;
    double height = 0.0;  ///< log₁₀R
    double standard_error = 0.0;
    ConfidenceInterval interval{};
    /// From the residuals of the means about their curve; a check, no statement about participants.
    std::optional<double> pooled_standard_error{};
  };
  std::optional<Peak> peak{};                   ///< where the status is `inside`
  std::optional<ConfidenceInterval> fieller{};  ///< wherever c < 0
  std::size_t concave_participants = 0;
  std::vector<double> participant_peaks{};  ///< of the concave ones whose peak was tested
};
QuadraticFit quadratic_fit(const MagnitudeCurves& curves);

/// One curve that nobody repeated, as of a simulation: the parabola of least squares through its
/// points.
///
/// Standard error and interval of the peak come from the residuals about the parabola, t with n − 3
/// degrees of freedom: they say how well a parabola describes the curve and how well it places its
/// top, nothing about people. `fieller` as in QuadraticFit, with the covariance of the residuals.
struct CurveFit {
  Quadratic curve{};
  double r2 = 0.0;
  PeakStatus status = PeakStatus::no_maximum;
  struct Peak {
    double x = 0.0;
    double height = 0.0;                     ///< log₁₀R
    std::optional<double> standard_error{};  ///< of more than three points
  };
  std::optional<Peak> peak{};                   ///< where the status is `inside`
  std::optional<ConfidenceInterval> fieller{};  ///< of more than three points, c < 0
};
struct CurvePoints {
  std::span<const double> x{};
  std::span<const double> log10{};
  double confidence = 0.95;
};
/// Throws std::invalid_argument for spans of different length, numbers that are not finite and fewer
/// than three different x.
CurveFit curve_fit(const CurvePoints& points);

/// The peak of resampled participants. Resamples without a maximum are left out and counted.
///
/// `bias_corrected` is BCa [Efron 1987]: z₀ from the resamples below the peak (ties half), the
/// acceleration from leaving each participant out; absent where one of those has no maximum, and
/// where all resamples lie on one side. Quantiles are of type 7.
///
/// [Efron 1987] Efron: Better bootstrap confidence intervals.
struct PeakBootstrap {
  std::size_t valid = 0;
  ConfidenceInterval percentile{};
  double standard_error = 0.0;
  struct BiasCorrected {
    double z0 = 0.0;
    double acceleration = 0.0;
    ConfidenceInterval interval{};
  };
  std::optional<BiasCorrected> bias_corrected{};
};
/// `resamples`: rows of places of participants. Nothing when the mean curve has no maximum or fewer
/// than two resamples have one; std::invalid_argument for a place beyond the participants.
std::optional<PeakBootstrap> bootstrap_peak(const QuadraticFit& fit,
                                            std::span<const std::vector<std::size_t>> resamples,
                                            double confidence = 0.95);

/// How far the peaks of two conditions are apart, with the same participants in both: the delta
/// method with the joint covariance. Nothing unless both mean curves have a maximum.
struct PeakShift {
  double difference = 0.0;  ///< x* of the first minus that of the second
  double standard_error = 0.0;
  std::optional<double> t{};
  std::optional<double> p{};
  ConfidenceInterval interval{};
};
struct TwoConditions {
  const QuadraticFit& first;
  const QuadraticFit& second;
  double confidence = 0.95;
};
std::optional<PeakShift> peak_shift(const TwoConditions& conditions);

}  // namespace asperity
