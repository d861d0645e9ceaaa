// Implements the rigid tip on a half-space.

#include "renderers/models/elastic_halfspace.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "renderers/elastic/relaxing_half_space.h"
#include "renderers/elastic/surface_dent.h"
#include "renderers/force/indentation_law.h"
#include "renderers/force/layers.h"
#include "renderers/models/tip_contact.h"

namespace asperity {
namespace {

constexpr HalfSpaceContact::Effort kPerTick{.most_iterations = 8, .residual = 1e-6};
/// Of a presentation that begins in contact.
constexpr HalfSpaceContact::Effort kAtReset{.most_iterations = 60, .residual = 1e-6};
constexpr double kInstant_s = 1e-9;
constexpr double kUnfinished = 1e-2;
constexpr double kLargestStrain = 0.3;  // a/R

/// E* of the relaxed body.
double reduced_modulus_Pa(const ParameterValues& parameters) {
  const double poisson = number_of(parameters, "poisson_ratio");
  return number_of(parameters, "youngs_modulus_Pa") / (1.0 - poisson * poisson);
}

class ElasticHalfspace final : public ForceRenderer, public IndentationLaw, public DentsSurface {
 public:
  explicit ElasticHalfspace(const RendererInputs& inputs)
      : tip_(inputs),
        shape_(tip_shape_of(inputs.parameters)),
        ratio_(number_of(inputs.parameters, "relaxation_ratio")),
        modulus_Pa_(reduced_modulus_Pa(inputs.parameters)),
        body_({.ratio = ratio_, .time_s = number_of(inputs.parameters, "relaxation_time_s")}) {}

  void reset(const ProbeState& first) noexcept override {
    tip_.reset();
    body_.reset();
    is_outside_ = false;
    last_m_ = glm::dvec2(first.position_m);
    if (const PressedTip::Overlap* const overlap = tip_.overlap(first)) {
      body_.advance(overlap->depth_m, glm::dvec2(0.0), kInstant_s, kAtReset);
    }
  }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const glm::dvec2 here_m(probe.position_m);
    const glm::dvec2 moved = (here_m - last_m_) / tip_.cell_m();
    last_m_ = here_m;
    const PressedTip::Overlap* const overlap = tip_.overlap(probe);
    if (overlap == nullptr) {
      if (!is_outside_) body_.reset();
      is_outside_ = true;
      return tip_.no_contact();
    }
    is_outside_ = false;
    const double residual = body_.advance(overlap->depth_m, moved, dt_s, kPerTick);
    if (!body_.is_loaded() || !(overlap->deepest_m > 0.0)) return tip_.no_contact();
    count(residual);
    return tip_.force(probe, body_.load_m(), modulus_Pa_ * tip_.cell_m(), &body_.dent_m(), dt_s);
  }

  Friction* friction() noexcept override { return tip_.friction(); }
  TipOnCharts* tip() noexcept override { return &tip_; }
  std::span<const NamedCount> limits() const noexcept override { return limits_; }

  std::optional<SurfaceDent> dent() const override {
    if (is_outside_ || (!body_.is_loaded() && !body_.has_dent())) return {};
    const CellField& load_m = body_.load_m();
    const double sum_m = std::accumulate(load_m.begin(), load_m.end(), 0.0);
    return SurfaceDent{.centre_m = last_m_,
                       .cell_m = tip_.cell_m(),
                       .depth_m = body_.displacement_m(),
                       .far_m2 = tip_.cell_m() * sum_m / std::numbers::pi};
  }

  /// 2·E₀*·a, with the contact as wide as after relaxation and a change that is too fast for it.
  double indentation_stiffness_N_per_m(double force_N) const override {
    return 2.0 * ratio_ * modulus_Pa_ * contact_radius_m(force_N);
  }

  std::optional<Phrase> indentation_problem(double force_N) const override {
    const double radius_m = contact_radius_m(force_N);
    const double depth_m = shape_.end == TipEnd::ball ? radius_m * radius_m / shape_.radius_m
                                                      : force_N / (2.0 * modulus_Pa_ * radius_m);
    const double strain = depth_m / radius_m;
    if (strain <= kLargestStrain) return {};
    return phrase("Protocols",
                  "under %1 N the tip sinks in by %2 mm, %3 times the contact radius of %4 mm; "
                  "elastic_halfspace assumes small strains, at most %5 times: raise "
                  "youngs_modulus_Pa or tip_radius_m, or request less force")
        .with(number_text(force_N), fixed(1e3 * depth_m, 2), fixed(strain, 2),
              fixed(1e3 * radius_m, 2), fixed(kLargestStrain, 1));
  }

 private:
  enum Limit : std::size_t { contact, unfinished, cell_border, large_strain };

  /// Under a normal force, on a plane and after relaxation.
  double contact_radius_m(double force_N) const {
    if (shape_.end == TipEnd::flat) return shape_.radius_m;
    return std::cbrt(0.75 * force_N * shape_.radius_m / modulus_Pa_);
  }

  void count(double residual) noexcept {
    ++limits_[contact].ticks;
    if (residual > kUnfinished) ++limits_[unfinished].ticks;
    std::size_t loaded = 0;
    bool at_border = false;
    for (std::size_t i = 0; i < kCells; ++i) {
      if (!(body_.load_m()[i] > 0.0)) continue;
      ++loaded;
      at_border = at_border || is_at_border(i);
    }
    if (at_border) ++limits_[cell_border].ticks;
    const double radius_m =
        tip_.cell_m() * std::sqrt(static_cast<double>(loaded) / std::numbers::pi);
    if (shape_.end == TipEnd::ball && radius_m > kLargestStrain * shape_.radius_m) {
      ++limits_[large_strain].ticks;
    }
  }

  TipContact tip_;
  PressedTip::Shape shape_{};
  double ratio_ = 1.0;
  double modulus_Pa_ = 0.0;
  RelaxingHalfSpace body_;
  glm::dvec2 last_m_{0.0};
  bool is_outside_ = false;
  std::array<NamedCount, 4> limits_{{{.name = "contact"},
                                     {.name = "unfinished"},
                                     {.name = "cell_border"},
                                     {.name = "large_strain"}}};
};

}  // namespace

ForceModel elastic_halfspace_model() {
  ModelDeclaration declaration{
      .id = "elastic_halfspace",
      .version = "2",
      .summary = phrase("Models", "A rigid tip on a soft textured body that deforms around it"),
      .source =
          "Johnson (1985), Contact mechanics; Polonsky, Keer (1999), A numerical method for "
          "solving rough contact problems",
      .needs_height_field = true,
      .amplitude_parameter = "height_scale",
      .replay_tolerance_N = 1e-6,
      .maximum_rate_Hz = 1000.0,
      .parameters = {}};
  add_tip_parameters(declaration.parameters);
  const auto number = [&declaration](const char* name, const char* unit, double minimum,
                                     double maximum, double default_value, const Phrase& meaning) {
    declaration.parameters.push_back(
        number_parameter(name, unit, minimum, maximum, default_value, meaning));
  };
  number(
      "youngs_modulus_Pa", "Pa", 1e3, 1e8, 1e5,
      phrase("Models", "Young's modulus of the relaxed body: 0.1 MPa is a soft silicone rubber"));
  number("poisson_ratio", "1", 0.0, 0.5, 0.5,
         phrase("Models", "Poisson's ratio; 0.5: incompressible"));
  number("relaxation_ratio", "1", 1.0, 10.0, 1.2,
         phrase("Models", "Instantaneous modulus divided by the relaxed one; 1: elastic"));
  number("relaxation_time_s", "s", 1e-3, 10.0, 0.02,
         phrase("Models", "Time constant of the relaxation at constant depth"));
  add_layer_parameters(declaration.parameters);
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            return std::make_unique<ElasticHalfspace>(inputs);
          },
          .suggested_by = {},
          .conservative_with = ParameterValues{{"relaxation_ratio", 1.0}},
          .band = band_of_tip,
          .band_formula = kBandOfTip};
}

}  // namespace asperity
