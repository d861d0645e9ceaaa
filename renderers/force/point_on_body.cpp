// Implements the charts of a point model on a body.

#include "renderers/force/point_on_body.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/words/phrased_error.h"
#include "renderers/force/adjacent_patches.h"
#include "renderers/force/smoothstep.h"
#include "renderers/force/tip_on_charts.h"

namespace asperity {
namespace {

constexpr double kBlend = 0.15;  // of components of the normal
// The height of a texture is examined at as many places of a square of at least this size.
constexpr int kExaminedPlaces = 4096;
constexpr double kExamined_m = 0.1;

/// Inputs of the model on the plane of a chart.
RendererInputs on_chart(RendererInputs inputs) {
  inputs = without_border(std::move(inputs));
  inputs.patch.centre_m = glm::dvec3(0.0);
  inputs.body.reset();
  return inputs;
}

std::array<double, 3> projection_weights_of(const glm::dvec3& normal) noexcept {
  const glm::dvec3 size = glm::abs(normal);
  const double largest = std::max({size.x, size.y, size.z});
  std::array<double, 3> weights{};
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    weights[axis] = smoothstep(1.0 + (size[static_cast<int>(axis)] - largest) / kBlend);
    sum += weights[axis];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Turns a vector by the smallest rotation from one unit vector to another one that is less than 180° away.
glm::dvec3 turned(const glm::dvec3& vector, const glm::dvec3& from, const glm::dvec3& to) noexcept {
  const glm::dvec3 axis = glm::cross(from, to);
  const glm::dvec3 across = glm::cross(axis, vector);
  return vector + across + glm::cross(axis, across) / (1.0 + glm::dot(from, to));
}

/// The place of a sample of a height field on a patch about the origin.
glm::dvec2 place_of_sample(const HeightField& field, std::size_t sample,
                           const SurfacePatch& patch) noexcept {
  const HeightField::Grid& grid = field.grid();
  const double column = static_cast<double>(sample % grid.columns);
  const double row = static_cast<double>(sample / grid.columns);
  const glm::dvec2 on_texture_m =
      grid.pitch_m * glm::dvec2(column - 0.5 * (static_cast<double>(grid.columns) - 1.0),
                                0.5 * (static_cast<double>(grid.rows) - 1.0) - row);
  return (on_texture_m - glm::dvec2(patch.texture_origin_m)) / patch.motion_scale;
}

/// `renderer` is one of a chart; its state and its counts change.
void require_low_texture(ForceRenderer& renderer, const RendererInputs& inputs) {
  const auto require_low_at = [&](const glm::dvec2& place_m) {
    ProbeState probe{};
    probe.position_m = {place_m, SurfaceProxy::kReach_m};
    renderer.reset(probe);
    const RenderedTick tick = renderer.tick(probe, 1e-3);
    if (!is_finite_as_stored(tick)) {
      const std::string error(renderer.error());
      throw PhrasedRefusal(
          phrase("Models",
                 "the model computes no finite force above the body%1; correct the "
                 "model or its parameters")
              .with(error.empty() ? "" : " (" + error + ')'));
    }
    if (tick.penetration_m > 0.0) {
      throw PhrasedRefusal(phrase("Models",
                                  "the texture rises more than %1 m above the body; reduce its "
                                  "amplitude")
                               .with(number_text(SurfaceProxy::kReach_m)));
    }
  };
  double side_m = kExamined_m;
  if (inputs.height_field) {
    const HeightField& field = *inputs.height_field;
    const auto [lowest, highest] =
        std::minmax_element(field.heights_m().begin(), field.heights_m().end());
    for (const auto& at : {lowest, highest}) {
      const auto sample = static_cast<std::size_t>(at - field.heights_m().begin());
      require_low_at(place_of_sample(field, sample, inputs.patch));
    }
    side_m = std::max({side_m, field.width_m() / inputs.patch.motion_scale,
                       field.length_m() / inputs.patch.motion_scale});
  }
  // The multiples of 1/g and 1/g² modulo 1, with g³ = g + 1, are spread evenly and repeat in no texture.
  constexpr double kPlastic = 1.32471795724474602596;
  double whole = 0.0;
  for (int i = 0; i < kExaminedPlaces; ++i) {
    require_low_at(side_m * glm::dvec2(std::modf(i / kPlastic, &whole) - 0.5,
                                       std::modf(i / (kPlastic * kPlastic), &whole) - 0.5));
  }
}

}  // namespace

PointOnBody::PointOnBody(const ForceModel& model, const RendererInputs& inputs)
    : border_(inputs.patch, inputs.material, inputs.parameters), proxy_(inputs.body) {
  const RendererInputs plane = on_chart(inputs);
  require_low_texture(*make_renderer(model, plane), plane);
  renderers_.push_back(make_renderer(model, plane));
  while (renderers_.front()->tip() == nullptr && renderers_.size() < charts_.size()) {
    renderers_.push_back(make_renderer(model, plane));
  }
  const std::span<const NamedCount> counts = renderers_.front()->limits();
  counts_.assign(counts.begin(), counts.end());
}

void PointOnBody::reset(const ProbeState&) noexcept {
  proxy_.reset();
  no_contact();
}

RenderedTick PointOnBody::no_contact() noexcept {
  border_.reset();
  tip_frame_.reset();
  for (Chart& chart : charts_) chart.weight = 0.0;
  return {};
}

PointOnBody::Tangents PointOnBody::tangents_of(int axis, const ProxyPlace& place) noexcept {
  // The upright axis of a chart, and the one that makes it right-handed with the normal.
  const int upright = axis == 2 ? 1 : 2;
  const double side = place.normal[axis] < 0.0 ? -1.0 : 1.0;
  glm::dvec3 towards(0.0);
  glm::dvec3 y(0.0);
  towards[axis] = side;
  y[upright] = 1.0;
  const glm::dvec3 x = glm::cross(y, towards);
  return {.x = turned(x, towards, place.normal),
          .y = turned(y, towards, place.normal),
          .texture_m = {glm::dot(x, place.point_m), place.point_m[upright]}};
}

glm::dmat2 PointOnBody::turn_between(const Tangents& from, const Tangents& to) noexcept {
  return {{glm::dot(from.x, to.x), glm::dot(from.x, to.y)},
          {glm::dot(from.y, to.x), glm::dot(from.y, to.y)}};
}

/// The state of the last chart is that of the previous tick, in coordinates of the texture. They are converted at the
/// present place, and this tick's motion follows when the entered chart is called.
void PointOnBody::enter(std::size_t axis, const ProxyPlace& place,
                        const ProbeState& local) noexcept {
  renderers_[axis]->reset(local);
  const auto last = std::max_element(
      charts_.begin(), charts_.end(),
      [](const Chart& one, const Chart& other) { return one.weight < other.weight; });
  Friction* const friction = renderers_[axis]->friction();
  if (!(last->weight > 0.0) || friction == nullptr) return;
  const auto last_axis = static_cast<std::size_t>(last - charts_.begin());
  const Tangents from = tangents_of(static_cast<int>(last_axis), place);
  const Tangents& to = charts_[axis].tangents;
  friction->continue_contact_of(
      *renderers_[last_axis]->friction(),
      {.from_m = from.texture_m, .to_m = to.texture_m, .turn = turn_between(from, to)});
}

std::string_view PointOnBody::error() const noexcept {
  for (const std::unique_ptr<ForceRenderer>& renderer : renderers_) {
    if (!renderer->error().empty()) return renderer->error();
  }
  return {};
}

void PointOnBody::count_limits() noexcept {
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    counts_[i].ticks = 0;
    for (const std::unique_ptr<ForceRenderer>& renderer : renderers_) {
      const std::span<const NamedCount> counts = renderer->limits();
      if (i < counts.size()) counts_[i].ticks += counts[i].ticks;
    }
  }
}

ProbeState PointOnBody::in_frame(const ProbeState& probe, const Tangents& axes,
                                 const ProxyPlace& place) noexcept {
  ProbeState local = probe;
  local.position_m = {axes.texture_m, place.height_m};
  local.velocity_m_per_s = {glm::dot(probe.velocity_m_per_s, axes.x),
                            glm::dot(probe.velocity_m_per_s, axes.y),
                            glm::dot(probe.velocity_m_per_s, place.normal)};
  return local;
}

glm::dvec3 PointOnBody::of_device(const glm::dvec3& force_N, const Tangents& axes,
                                  const ProxyPlace& place) noexcept {
  return force_N.x * axes.x + force_N.y * axes.y + force_N.z * place.normal;
}

RenderedTick PointOnBody::points(const ProbeState& probe, const ProxyPlace& place,
                                 const std::array<double, 3>& weights, double dt_s) noexcept {
  std::array<ProbeState, 3> local{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (weights[axis] > 0.0) local[axis] = in_frame(probe, charts_[axis].tangents, place);
  }
  // All charts are entered before one is called, so that the result does not depend on the order of the axes.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (weights[axis] > 0.0 && !(charts_[axis].weight > 0.0)) enter(axis, place, local[axis]);
  }
  RenderedTick blend{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(weights[axis] > 0.0)) continue;
    const RenderedTick of_chart = renderers_[axis]->tick(local[axis], dt_s);
    blend.wrench.force_N +=
        weights[axis] * of_device(of_chart.wrench.force_N, charts_[axis].tangents, place);
    blend.penetration_m += weights[axis] * of_chart.penetration_m;
  }
  return blend;
}

bool PointOnBody::carry_frame(const ProxyPlace& place, const Tangents& first) noexcept {
  // A proxy that changes to the opposite side within a tick has no smallest rotation, and begins anew.
  constexpr double kOpposite = -0.9;
  const bool continues = tip_frame_ && glm::dot(tip_frame_->normal, place.normal) > kOpposite;
  if (continues) {
    Tangents& axes = tip_frame_->axes;
    const glm::dvec3 x = turned(axes.x, tip_frame_->normal, place.normal);
    axes.x = glm::normalize(x - place.normal * glm::dot(place.normal, x));
    axes.y = glm::cross(place.normal, axes.x);
    const glm::dvec3 way_m = place.point_m - tip_frame_->point_m;
    axes.texture_m += glm::dvec2(glm::dot(way_m, axes.x), glm::dot(way_m, axes.y));
  } else {
    tip_frame_ = CarriedFrame{.axes = {.x = first.x, .y = first.y}};
  }
  tip_frame_->normal = place.normal;
  tip_frame_->point_m = place.point_m;
  return continues;
}

RenderedTick PointOnBody::tip(const ProbeState& probe, const ProxyPlace& place,
                              const std::array<double, 3>& weights, double dt_s) noexcept {
  const auto heaviest =
      static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
  const bool continues = carry_frame(place, charts_[heaviest].tangents);
  const Tangents& axes = tip_frame_->axes;
  std::array<ChartOfTip, TipOnCharts::kMostCharts> charts{};
  std::size_t count = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(weights[axis] > 0.0)) continue;
    const Tangents& tangents = charts_[axis].tangents;
    charts[count++] = {.texture_m = tangents.texture_m,
                       .turn = turn_between(axes, tangents),
                       .weight = weights[axis]};
  }
  ForceRenderer& renderer = *renderers_.front();
  renderer.tip()->touch(std::span(charts).first(count));
  const ProbeState local = in_frame(probe, axes, place);
  if (!continues) renderer.reset(local);
  RenderedTick touched = renderer.tick(local, dt_s);
  touched.wrench = {.force_N = of_device(touched.wrench.force_N, axes, place)};
  return touched;
}

RenderedTick PointOnBody::tick(const ProbeState& probe, double dt_s) noexcept {
  const PatchPoint border = border_.locate(probe.position_m);
  if (border.gain == 0.0) {
    proxy_.reset();
    return no_contact();
  }
  const std::optional<ProxyPlace> place =
      proxy_.follow(probe.position_m - border_.patch().centre_m);
  if (!place) return no_contact();
  const std::array<double, 3> weights = projection_weights_of(place->normal);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(weights[axis] > 0.0)) continue;
    charts_[axis].tangents = tangents_of(static_cast<int>(axis), *place);
  }
  const bool is_tip = renderers_.front()->tip() != nullptr;
  RenderedTick result =
      is_tip ? tip(probe, *place, weights, dt_s) : points(probe, *place, weights, dt_s);
  count_limits();
  for (std::size_t axis = 0; axis < 3; ++axis) charts_[axis].weight = weights[axis];
  if (result.penetration_m > 0.0) {
    result.wrench.force_N += glm::dvec3(border_.wall_N(border), 0.0);
  } else {
    border_.reset();
  }
  result.wrench.force_N *= border.gain;
  return result;
}

}  // namespace asperity
