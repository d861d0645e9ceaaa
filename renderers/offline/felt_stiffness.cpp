// Implements central differences of a model's force, at the depth of the force limit, and the search for their maximum.

#include "renderers/offline/felt_stiffness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "analysis/numbers/random.h"
#include "device/refusal.h"
#include "renderers/force/indentation_law.h"

namespace asperity {
namespace {

constexpr int kPlacesAcross = 128;
constexpr int kPlacesAlongALine = 4096;
constexpr std::size_t kFollowed = 16;
constexpr double kDeepest_m = 0.1;  // more than any texture or hand, unless it is very soft
/// As fractions of the depth of the force limit on a plain plate.
constexpr double kStepAlongZ = 1.0 / 2000.0;
constexpr double kShallower = 2.0 * kStepAlongZ;
/// A fraction of the greatest force: a saturating spring comes closest to it just before it saturates.
constexpr double kNearlyGreatest = 0.999;
/// The difference at a jump grows with 1/step; at a kink it is at most about twice another one.
constexpr double kFinerStep = 0.25;
constexpr double kGrowthOfAJump = 2.0;

/// The largest eigenvalue of a symmetric matrix, by Jacobi rotations.
double largest_eigenvalue(glm::dmat3 m) {
  for (int round = 0; round < 8; ++round) {
    for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
      if (m[p][q] == 0.0) continue;
      const double theta = 0.5 * std::atan2(2.0 * m[p][q], m[q][q] - m[p][p]);
      const double c = std::cos(theta);
      const double s = std::sin(theta);
      for (int i = 0; i < 3; ++i) {
        const double ip = m[i][p];
        const double iq = m[i][q];
        m[i][p] = c * ip - s * iq;
        m[i][q] = s * ip + c * iq;
      }
      for (int i = 0; i < 3; ++i) {
        const double pi = m[p][i];
        const double qi = m[q][i];
        m[p][i] = c * pi - s * qi;
        m[q][i] = s * pi + c * qi;
      }
    }
  }
  return std::max({m[0][0], m[1][1], m[2][2]});
}

struct Place {
  double x_m = 0.0;
  double y_m = 0.0;
  double stiffness_N_per_m = 0.0;
};

/// The field that the model renders; null for a model that only derives parameters from it.
const HeightField* rendered_field(const ForceModel& model, const RendererInputs& inputs) {
  return model.declaration.needs_height_field ? inputs.height_field.get() : nullptr;
}

StiffnessSearch completed(StiffnessSearch search, const ForceModel& model,
                          const RendererInputs& inputs) {
  constexpr double kStepsOfPitch = 64.0;
  constexpr double kStepsOfWave = 256.0;
  constexpr double kSmallStep_m = 1e-6;
  const double motion = inputs.patch.motion_scale;
  const HeightField* const field = rendered_field(model, inputs);
  if (!search.extent_m) {
    search.extent_m = inputs.patch.extent_m;
    if (field != nullptr) {
      search.extent_m->x = std::min(search.extent_m->x, field->width_m() / motion);
      search.extent_m->y = std::min(search.extent_m->y, field->length_m() / motion);
    }
  }
  if (!search.step_m) {
    search.step_m = kSmallStep_m;
    const auto wavelength_m = inputs.parameters.find("wavelength_m");
    if (field != nullptr) {
      search.step_m = field->grid().pitch_m / motion / kStepsOfPitch;
    } else if (wavelength_m != inputs.parameters.end()) {
      search.step_m = std::get<double>(wavelength_m->second) / motion / kStepsOfWave;
    }
  }
  return search;
}

/// Collects the elements with the largest values.
class Largest final {
 public:
  void offer(double value, const Place& place) {
    if (kept_.size() == kMost && value <= kept_.front().first) return;
    if (kept_.size() == kMost) {
      std::pop_heap(kept_.begin(), kept_.end(), is_larger);
      kept_.pop_back();
    }
    kept_.emplace_back(value, place);
    std::push_heap(kept_.begin(), kept_.end(), is_larger);
  }
  void append_to(std::vector<Place>& places) const {
    for (const auto& [value, place] : kept_) places.push_back(place);
  }

 private:
  static constexpr std::size_t kMost = 64;
  using Kept = std::pair<double, Place>;
  static bool is_larger(const Kept& one, const Kept& other) { return one.first > other.first; }
  std::vector<Kept> kept_{};
};

/// The index of the texture sample that is `beyond` samples after the first one, out of `count` in a row.
std::size_t sample_at(std::ptrdiff_t beyond, std::ptrdiff_t count, Tiling tiling) {
  switch (tiling) {
    case Tiling::repeat:
      beyond = (beyond + count) % count;
      break;
    case Tiling::mirror:
      if (beyond < 0) beyond = -1 - beyond;
      if (beyond >= count) beyond = 2 * count - 1 - beyond;
      break;
    case Tiling::bounded:
      break;
  }
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(beyond, 0, count - 1));
}

/// Adds the samples with the greatest upward curvature and with the greatest inclination: a grid would miss the
/// sharpest of a million samples. The curvature is that of the cubics between samples, which differs on the two sides
/// of a sample.
void add_sharpest(const HeightField& field, const SurfacePatch& patch, const glm::dvec2& extent_m,
                  std::vector<Place>& places) {
  const auto rows = static_cast<std::ptrdiff_t>(field.grid().rows);
  const auto columns = static_cast<std::ptrdiff_t>(field.grid().columns);
  const double pitch_m = field.grid().pitch_m / patch.motion_scale;
  Largest bent{};
  Largest inclined{};
  std::array<const float*, 5> lines_m{};
  std::array<std::size_t, 5> across{};
  constexpr auto bend = [](double a, double b, double c, double d, double e) {
    return std::max(2.0 * b - 5.0 * c + 4.0 * d - e, 2.0 * d - 5.0 * c + 4.0 * b - a);
  };
  for (std::ptrdiff_t r = 0; r < rows; ++r) {
    const double y_m = (0.5 * static_cast<double>(rows - 1) - static_cast<double>(r)) * pitch_m;
    if (std::abs(y_m) > 0.5 * extent_m.y) continue;
    for (std::ptrdiff_t i = 0; i < 5; ++i) {
      lines_m[static_cast<std::size_t>(i)] =
          field.heights_m().data() +
          sample_at(r + i - 2, rows, patch.tiling) * field.grid().columns;
    }
    for (std::ptrdiff_t c = 0; c < columns; ++c) {
      const double x_m =
          (static_cast<double>(c) - 0.5 * static_cast<double>(columns - 1)) * pitch_m;
      if (std::abs(x_m) > 0.5 * extent_m.x) continue;
      for (std::ptrdiff_t i = 0; i < 5; ++i) {
        across[static_cast<std::size_t>(i)] = sample_at(c + i - 2, columns, patch.tiling);
      }
      const auto at = [&](std::size_t row, std::size_t column) {
        return static_cast<double>(lines_m[row][across[column]]);
      };
      const Place place{.x_m = x_m, .y_m = y_m};
      const double rise_x = at(2, 3) - at(2, 1);
      const double rise_y = at(3, 2) - at(1, 2);
      inclined.offer(rise_x * rise_x + rise_y * rise_y, place);
      const double xx = bend(at(2, 0), at(2, 1), at(2, 2), at(2, 3), at(2, 4));
      const double yy = bend(at(0, 2), at(1, 2), at(2, 2), at(3, 2), at(4, 2));
      const double xy = 0.25 * (at(3, 3) - at(3, 1) - at(1, 3) + at(1, 1));
      bent.offer(0.5 * (xx + yy) + std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy), place);
    }
  }
  bent.append_to(places);
  inclined.append_to(places);
}

class StiffestPlace final {
 public:
  StiffestPlace(const ForceModel& model, const RendererInputs& inputs,
                const StiffnessSearch& search)
      : force_limit_N_(search.force_limit_N),
        extent_m_(*search.extent_m),
        step_m_(*search.step_m),
        centre_m_(inputs.patch.centre_m),
        plate_depth_m_(search.force_limit_N / inputs.material.stiffness_N_per_m),
        deepest_m_(std::max(kDeepest_m, 2.0 * plate_depth_m_)) {
    RendererInputs borderless = inputs;
    borderless.patch.edge = PatchEdge::wall;  // never reached
    borderless.patch.extent_m = 2.0 * (inputs.patch.extent_m + extent_m_);
    renderer_ = make_renderer(model, borderless);
  }

  std::optional<FeltStiffness> find(std::vector<Place> places) {
    add_spread(places);
    for (Place& place : places) place.stiffness_N_per_m = at(place, step_m_);
    std::sort(places.begin(), places.end(), [](const Place& one, const Place& other) {
      return one.stiffness_N_per_m > other.stiffness_N_per_m;
    });
    std::optional<FeltStiffness> stiffest{};
    std::size_t followed = 0;
    for (const Place& place : places) {
      if (followed == kFollowed) break;
      const double here_N_per_m = without_jumps(place);
      if (!(here_N_per_m > 0.0)) continue;
      ++followed;
      const Place top = uphill({place.x_m, place.y_m, here_N_per_m});
      if (!stiffest || top.stiffness_N_per_m > stiffest->stiffness_N_per_m) {
        stiffest = FeltStiffness{.stiffness_N_per_m = top.stiffness_N_per_m,
                                 .force_N = pressed(top).force_N};
      }
    }
    return stiffest;
  }

 private:
  struct Pressed {
    double z_m = 0.0;
    double force_N = 0.0;  ///< 0 where there is no force
  };

  double half_x_m() const { return 0.5 * extent_m_.x; }
  double half_y_m() const { return 0.5 * extent_m_.y; }

  void add_spread(std::vector<Place>& places) const {
    Random random = Random(0).split("places");
    const bool is_line = extent_m_.x == 0.0 || extent_m_.y == 0.0;
    const int columns = extent_m_.x == 0.0 ? 1 : is_line ? kPlacesAlongALine : kPlacesAcross;
    const int rows = extent_m_.y == 0.0 ? 1 : is_line ? kPlacesAlongALine : kPlacesAcross;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const double across = (column + random.uniform()) / columns - 0.5;
        const double along = (row + random.uniform()) / rows - 0.5;
        places.push_back({.x_m = across * extent_m_.x, .y_m = along * extent_m_.y});
      }
    }
  }

  glm::dvec3 force_N(double x_m, double y_m, double z_m) {
    const ProbeState probe{.position_m = centre_m_ + glm::dvec3(x_m, y_m, z_m)};
    renderer_->reset(probe);
    constexpr double kPeriod_s = 1e-3;  // of a force at rest
    return renderer_->tick(probe, kPeriod_s).wrench.force_N;
  }

  /// The depth of the tip at this place, relative to the depth on a plain plate.
  Pressed pressed(const Place& place) {
    const auto normal_N = [&](double z_m) { return force_N(place.x_m, place.y_m, z_m).z; };
    double step_m = plate_depth_m_;
    double deep_m = -plate_depth_m_;
    double shallow_m = deep_m;
    double wanted_N = force_limit_N_;
    double found_N = normal_N(deep_m);
    if (found_N >= wanted_N) {
      while (shallow_m < deepest_m_ && normal_N(shallow_m) >= wanted_N) {
        deep_m = shallow_m;
        shallow_m += step_m;
        step_m *= 2.0;
      }
    } else {
      double greatest_N = found_N;
      double greatest_m = deep_m;
      while (deep_m > -deepest_m_ && found_N < wanted_N) {
        shallow_m = deep_m;
        deep_m = std::max(deep_m - step_m, -deepest_m_);
        step_m *= 2.0;
        found_N = normal_N(deep_m);
        if (found_N > greatest_N) {
          greatest_N = found_N;
          greatest_m = deep_m;
        }
      }
      if (found_N < wanted_N) {
        if (!(greatest_N > 0.0)) return {};
        wanted_N = kNearlyGreatest * greatest_N;
        deep_m = greatest_m;
        shallow_m = deep_m;
        for (step_m = plate_depth_m_; shallow_m < deepest_m_ && normal_N(shallow_m) >= wanted_N;
             step_m *= 2.0) {
          deep_m = shallow_m;
          shallow_m += step_m;
        }
      }
    }
    constexpr int kHalvings = 14;
    for (int i = 0; i < kHalvings && deep_m < shallow_m; ++i) {
      const double middle_m = 0.5 * (deep_m + shallow_m);
      (normal_N(middle_m) >= wanted_N ? deep_m : shallow_m) = middle_m;
    }
    const double depth_m = std::min(plate_depth_m_, wanted_N / force_limit_N_ * plate_depth_m_);
    return {.z_m = deep_m + kShallower * depth_m, .force_N = wanted_N};
  }

  double at(const Place& place, double step_m) { return at(place, pressed(place), step_m); }

  double at(const Place& place, const Pressed& pressed, double step_m) {
    if (pressed.force_N == 0.0) return 0.0;
    const glm::dvec3 steps_m{step_m, step_m,
                             kStepAlongZ * plate_depth_m_ * pressed.force_N / force_limit_N_};
    glm::dmat3 gradient{0.0};
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 aside_m{0.0};
      aside_m[axis] = steps_m[axis];
      const glm::dvec3 here_m{place.x_m, place.y_m, pressed.z_m};
      const glm::dvec3 beyond_m = here_m + aside_m;
      const glm::dvec3 before_m = here_m - aside_m;
      gradient[axis] = (force_N(before_m.x, before_m.y, before_m.z) -
                        force_N(beyond_m.x, beyond_m.y, beyond_m.z)) /
                       (2.0 * steps_m[axis]);
    }
    return largest_eigenvalue(0.5 * (gradient + glm::transpose(gradient)));
  }

  /// The stiffness at a place; 0 if the force jumps there.
  double without_jumps(const Place& place) {
    const Pressed tip = pressed(place);
    const double coarse = at(place, tip, step_m_);
    const double fine = at(place, tip, kFinerStep * step_m_);
    if (fine <= kGrowthOfAJump * coarse) return std::min(coarse, fine);
    const double finest = at(place, tip, kFinerStep * kFinerStep * step_m_);
    return finest > kGrowthOfAJump * fine ? 0.0 : std::min(fine, finest);
  }

  Place uphill(Place place) {
    glm::dvec2 reach_m = extent_m_ / static_cast<double>(kPlacesAcross);
    while (std::max(reach_m.x, reach_m.y) > step_m_) {
      Place best = place;
      for (const auto& [right, up] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        Place next{.x_m = std::clamp(place.x_m + right * reach_m.x, -half_x_m(), half_x_m()),
                   .y_m = std::clamp(place.y_m + up * reach_m.y, -half_y_m(), half_y_m())};
        next.stiffness_N_per_m = without_jumps(next);
        if (next.stiffness_N_per_m > best.stiffness_N_per_m) best = next;
      }
      if (best.stiffness_N_per_m > place.stiffness_N_per_m) {
        place = best;
      } else {
        reach_m *= 0.5;
      }
    }
    return place;
  }

  double force_limit_N_ = 0.0;
  glm::dvec2 extent_m_{0.0};
  double step_m_ = 0.0;
  glm::dvec3 centre_m_{0.0};
  double plate_depth_m_ = 0.0;
  double deepest_m_ = kDeepest_m;
  std::unique_ptr<ForceRenderer> renderer_{};
};

}  // namespace

std::optional<FeltStiffness> felt_stiffness(const ForceModel& model, const RendererInputs& inputs,
                                            const StiffnessSearch& search) {
  const StiffnessSearch all = completed(search, model, inputs);
  require_positive("StiffnessSearch::force_limit_N", all.force_limit_N);
  require_positive("StiffnessSearch::step_m", *all.step_m);
  StiffestPlace stiffest(model, inputs, all);
  if (!model.declaration.needs_bodies) {
    RendererInputs complete = inputs;
    complete.parameters = complete_values(model.declaration, inputs.parameters);
    const std::unique_ptr<ForceRenderer> own = model.make(complete);
    if (const auto* const law = dynamic_cast<const IndentationLaw*>(own.get())) {
      return FeltStiffness{
          .stiffness_N_per_m = law->indentation_stiffness_N_per_m(all.force_limit_N),
          .force_N = all.force_limit_N};
    }
  }
  std::vector<Place> places;
  if (const HeightField* const field = rendered_field(model, inputs)) {
    add_sharpest(*field, inputs.patch, *all.extent_m, places);
  }
  return stiffest.find(std::move(places));
}

}  // namespace asperity
