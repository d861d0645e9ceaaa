// Implements the charts of a point model on a body.

#include "renderers/force/point_on_body.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "analysis/number_text.h"
#include "renderers/force/adjacent_patches.h"

namespace asperity {
namespace {

constexpr double kBlend = 0.15;  // of components of the normal
// The height of a texture is examined at as many places along each side of a square of this size.
constexpr int kExaminedPlaces = 64;
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
    const double u = std::max(0.0, 1.0 + (size[static_cast<int>(axis)] - largest) / kBlend);
    weights[axis] = u * u * (3.0 - 2.0 * u);
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

}  // namespace

PointOnBody::PointOnBody(const ForceModel& model, const RendererInputs& inputs)
    : border_(inputs.patch, inputs.material, inputs.parameters), proxy_(inputs.body) {
  for (Chart& chart : charts_) chart.renderer = make_renderer(model, on_chart(inputs));
  require_low_texture();
}

void PointOnBody::require_low_texture() {
  ForceRenderer& renderer = *charts_.front().renderer;
  ProbeState probe{};
  probe.position_m.z = SurfaceProxy::kReach_m;
  for (int i = 0; i < kExaminedPlaces * kExaminedPlaces; ++i) {
    probe.position_m.x = kExamined_m * ((i % kExaminedPlaces + 0.5) / kExaminedPlaces - 0.5);
    probe.position_m.y = kExamined_m * ((i / kExaminedPlaces + 0.5) / kExaminedPlaces - 0.5);
    renderer.reset(probe);
    if (renderer.tick(probe, 1e-3).penetration_m > 0.0) {
      throw std::invalid_argument("the texture rises more than " +
                                  number_text(SurfaceProxy::kReach_m) +
                                  " m above the body; reduce its amplitude");
    }
  }
}

void PointOnBody::reset(const ProbeState&) noexcept {
  proxy_.reset();
  for (Chart& chart : charts_) chart.weight = 0.0;
}

RenderedTick PointOnBody::no_contact() noexcept {
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

void PointOnBody::enter(Chart& chart, const ProbeState& local) noexcept {
  chart.renderer->reset(local);
  const auto last = std::max_element(
      charts_.begin(), charts_.end(),
      [](const Chart& one, const Chart& other) { return one.weight < other.weight; });
  Friction* const friction = chart.renderer->friction();
  if (!(last->weight > 0.0) || friction == nullptr) return;
  const Tangents& from = last->tangents;
  const Tangents& to = chart.tangents;
  friction->continue_contact_of(*last->renderer->friction(),
                                {.from_m = from.texture_m,
                                 .to_m = to.texture_m,
                                 .turn = {{glm::dot(from.x, to.x), glm::dot(from.x, to.y)},
                                          {glm::dot(from.y, to.x), glm::dot(from.y, to.y)}}});
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
  RenderedTick blend{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Chart& chart = charts_[axis];
    if (!(weights[axis] > 0.0)) continue;
    const Tangents tangents = tangents_of(static_cast<int>(axis), *place);
    ProbeState local = probe;
    local.position_m = {tangents.texture_m, place->height_m};
    local.velocity_m_per_s = {glm::dot(probe.velocity_m_per_s, tangents.x),
                              glm::dot(probe.velocity_m_per_s, tangents.y),
                              glm::dot(probe.velocity_m_per_s, place->normal)};
    chart.tangents = tangents;
    if (!(chart.weight > 0.0)) enter(chart, local);
    const RenderedTick of_chart = chart.renderer->tick(local, dt_s);
    const glm::dvec3& force_N = of_chart.wrench.force_N;
    blend.wrench.force_N += weights[axis] * (force_N.x * tangents.x + force_N.y * tangents.y +
                                             force_N.z * place->normal);
    blend.penetration_m += weights[axis] * of_chart.penetration_m;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) charts_[axis].weight = weights[axis];
  if (blend.penetration_m > 0.0) blend.wrench.force_N += glm::dvec3(border.wall_N, 0.0);
  blend.wrench.force_N *= border.gain;
  return blend;
}

}  // namespace asperity
