// Implements the tool, its contacts and the wrench on the hand.

#include "renderers/pd_gradient/contact/pd_gradient.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

constexpr double kSamplesPerWave = 8.0;  // with fewer, the error of the gradient exceeds 10 %
constexpr double kWavesPerTick = 0.5;    // with more, the servo's samples alias the waves
constexpr double kTouching_m = 1e-9;     // the smallest penetration that is reported for contact

const RendererInputs& checked(const RendererInputs& inputs) {
  if (inputs.patch.motion_scale != 1.0) {
    throw std::invalid_argument(
        "SurfacePatch::motion_scale must be 1 for pd_gradient, whose tool turns as well as moves, "
        "but it is " +
        number_text(inputs.patch.motion_scale));
  }
  return inputs;
}

WindowSampling sampling_of(const ParameterValues& values) {
  MaximumLaw law = HardMaximum{.step_m = number_of(values, "step_m")};
  if (choice_of(values, "maximum") == "smooth") {
    law = SmoothMaximum{.tau_m = number_of(values, "tau_m")};
  }
  return {.law = law,
          .cell_m = number_of(values, "cell_m"),
          .most_samples = static_cast<int>(number_of(values, "most_samples")),
          .most_halvings = static_cast<int>(number_of(values, "most_halvings"))};
}

TexturedBody body_of(const std::shared_ptr<const TexturedMesh>& mesh, double gain,
                     PdGradient::SharedParts* shared) {
  return shared != nullptr ? shared->bodies.body(mesh, gain) : TexturedBody(*mesh, gain);
}

std::unique_ptr<ComputedContacts> computed_of(const RendererInputs& inputs,
                                              const Compute* compute) {
  if (compute == nullptr) return nullptr;
  const WindowSampling sampling = sampling_of(inputs.parameters);
  return std::make_unique<ComputedContacts>(
      *compute, *inputs.tool, number_of(inputs.parameters, "tool_texture_gain"), *inputs.surface,
      number_of(inputs.parameters, "texture_gain"),
      GpuRoom{.contacts = TexturedContacts::kMostComputed,
              .samples = sampling.most_samples / kSamplesOfTile * kSamplesOfTile,
              .is_smooth = std::holds_alternative<SmoothMaximum>(sampling.law)});
}

CoupledTool::Properties properties_of(const ParameterValues& values,
                                      const glm::dvec3& centre_in_tool_m) {
  return {
      .mass_kg = number_of(values, "tool_mass_kg"),
      .inertia_kg_m2 = number_of(values, "tool_inertia_kg_m2"),
      .stiffness_N_per_m = number_of(values, "coupling_stiffness_N_per_m"),
      .damping_N_s_per_m = number_of(values, "coupling_damping_N_s_per_m"),
      .angular_stiffness_N_m_per_rad = number_of(values, "coupling_angular_stiffness_N_m_per_rad"),
      .angular_damping_N_m_s_per_rad = number_of(values, "coupling_angular_damping_N_m_s_per_rad"),
      .centre_in_tool_m = centre_in_tool_m};
}

/// Converts a wrench about `from_m` to one about another point.
Wrench about(const glm::dvec3& point_m, const glm::dvec3& from_m, const Wrench& wrench) noexcept {
  return {.force_N = wrench.force_N,
          .torque_N_m = wrench.torque_N_m + glm::cross(from_m - point_m, wrench.force_N)};
}

glm::dvec3 across(const glm::dvec3& n, const glm::dvec3& vector) noexcept {
  return vector - n * glm::dot(n, vector);
}

}  // namespace

PdGradient::PdGradient(const RendererInputs& inputs, InstructionSet instructions,
                       const Compute* compute, SharedParts* shared)
    : patch_(checked(inputs).patch, inputs.material, inputs.parameters),
      contacts_(body_of(inputs.tool, number_of(inputs.parameters, "tool_texture_gain"), shared),
                body_of(inputs.surface, number_of(inputs.parameters, "texture_gain"), shared),
                sampling_of(inputs.parameters), instructions, computed_of(inputs, compute),
                shared != nullptr ? &shared->samplers : nullptr),
      centre_in_tool_m_(tool_body().hull_clusters()->centre_m()),
      contact_damping_N_s_per_m_(number_of(inputs.parameters, "contact_damping_N_s_per_m")),
      friction_speed_m_per_s_(number_of(inputs.parameters, "friction_speed_m_per_s")),
      finest_wave_m_(std::min(tool_body().finest_wave_m(), surface_body().finest_wave_m())),
      has_compute_device_(compute != nullptr),
      limits_{{{.name = "contact"},
               {.name = "folded"},
               {.name = "window_border"},
               {.name = "fine_detail"},
               {.name = "fast"},
               {.name = "coarse_window"},
               {.name = "left_out"},
               {.name = "too_deep"},
               {.name = "kept"},
               {.name = "wholly_inside"},
               {.name = "no_compute"}}} {
  if (has_virtual_coupling(inputs.parameters)) {
    tool_.emplace(properties_of(inputs.parameters, centre_in_tool_m_));
  }
}

void PdGradient::reset(const ProbeState& first) noexcept {
  contacts_.reset();
  found_ = {};
  touching_ = 0;
  has_been_clear_ = false;
  patch_.reset();
  if (tool_) tool_->reset(first);
}

RenderedTick PdGradient::tick(const ProbeState& probe, double dt_s) noexcept {
  const Pose surface{.position_m = patch_.patch().centre_m};
  if (!has_been_clear_) {
    has_been_clear_ = !contacts_.touch(
        {.rotation = glm::mat3_cast(probe.orientation), .position_m = probe.position_m}, surface);
  }
  found_ = contacts_.find(pose_of(probe), surface, dt_s);
  find_touches(probe);
  watch(dt_s);
  RenderedTick answer{.wrench = tool_ ? coupled(probe, dt_s) : direct(probe)};
  for (const Touch& touch : std::span(touches_).first(touching_)) {
    answer.penetration_m = std::max(answer.penetration_m, touch.contact->penetration.depth_m);
  }
  const PatchPoint point = patch_.locate(probe.position_m);
  if (answer.penetration_m > 0.0) {
    answer.wrench.force_N += glm::dvec3{patch_.wall_N(point), 0.0};
  } else {
    patch_.reset();
  }
  answer.wrench.force_N *= point.gain;
  answer.wrench.torque_N_m *= point.gain;
  if (point.gain == 0.0) {
    answer.penetration_m = 0.0;
  } else if (!has_been_clear_) {
    answer.penetration_m = std::max(answer.penetration_m, kTouching_m);
  }
  return answer;
}

std::span<const NamedCount> PdGradient::limits() const noexcept {
  const std::span<const NamedCount> all(limits_);
  return has_compute_device_ ? all : all.first(static_cast<std::size_t>(Limit::no_compute));
}

std::optional<TipPose> PdGradient::simulated_tool() const noexcept {
  if (!tool_) return {};
  const ToolPose& pose = tool_->pose();
  return TipPose{.position_m = pose.centre_m - pose.orientation * centre_in_tool_m_,
                 .orientation = pose.orientation};
}

Pose PdGradient::pose_of(const ProbeState& probe) const noexcept {
  if (!tool_) {
    return {.rotation = glm::mat3_cast(probe.orientation), .position_m = probe.position_m};
  }
  const ToolPose& pose = tool_->pose();
  const glm::dmat3 rotation = glm::mat3_cast(pose.orientation);
  return {.rotation = rotation, .position_m = pose.centre_m - rotation * centre_in_tool_m_};
}

void PdGradient::find_touches(const ProbeState& probe) noexcept {
  touching_ = 0;
  for (const TexturedContact& contact : found_) {
    if (!is_felt(contact)) continue;
    const glm::dvec3 deepest_m =
        contact.frame.origin_m + contact.frame.to_world(contact.penetration.deepest_m);
    const glm::dvec3 velocity_m_per_s =
        tool_ ? tool_->velocity_m_per_s(deepest_m - tool_->pose().centre_m)
              : probe.velocity_m_per_s +
                    glm::cross(probe.angular_velocity_rad_per_s, deepest_m - probe.position_m);
    touches_[touching_++] = {
        .contact = &contact, .deepest_m = deepest_m, .velocity_m_per_s = velocity_m_per_s};
  }
}

double PdGradient::friction_N_s_per_m(const Touch& touch) const noexcept {
  const Material& material = patch_.material();
  const double normal_N =
      touch.contact->share * material.stiffness_N_per_m * touch.contact->penetration.depth_m;
  const double speed_m_per_s = glm::length(across(touch.contact->frame.n, touch.velocity_m_per_s));
  return material.friction * normal_N / std::hypot(speed_m_per_s, friction_speed_m_per_s_);
}

Wrench PdGradient::direct(const ProbeState& probe) const noexcept {
  const double stiffness_N_per_m = patch_.material().stiffness_N_per_m;
  Wrench sum{};
  for (const Touch& touch : std::span(touches_).first(touching_)) {
    const TexturedContact& contact = *touch.contact;
    const Penetration& found = contact.penetration;
    const glm::dvec3 at_origin_m_per_s =
        probe.velocity_m_per_s +
        glm::cross(probe.angular_velocity_rad_per_s, contact.frame.origin_m - probe.position_m);
    const double depth_rate_m_per_s =
        glm::dot(glm::dvec3{found.slope, -1.0}, contact.frame.to_frame(at_origin_m_per_s)) +
        glm::dot(found.lever_m, contact.frame.to_frame(probe.angular_velocity_rad_per_s));
    const double damped =
        1.0 + contact_damping_N_s_per_m_ * depth_rate_m_per_s / (stiffness_N_per_m * found.depth_m);
    const Wrench push =
        about(probe.position_m, contact.frame.origin_m,
              contact_wrench(found, contact.frame,
                             contact.share * stiffness_N_per_m * std::max(0.0, damped)));
    const Wrench rub = about(
        probe.position_m, touch.deepest_m,
        {.force_N = -friction_N_s_per_m(touch) * across(contact.frame.n, touch.velocity_m_per_s)});
    sum.force_N += push.force_N + rub.force_N;
    sum.torque_N_m += push.torque_N_m + rub.torque_N_m;
  }
  return sum;
}

Wrench PdGradient::coupled(const ProbeState& probe, double dt_s) noexcept {
  std::array<PenaltyContact, kMostContacts> contacts{};
  const glm::dvec3 centre_m = tool_->pose().centre_m;
  for (std::size_t i = 0; i < touching_; ++i) {
    const TexturedContact& contact = *touches_[i].contact;
    const glm::dvec3 gradient = contact.frame.to_world(glm::dvec3{contact.penetration.slope, -1.0});
    contacts[i] = {.stiffness_N_per_m = contact.share * patch_.material().stiffness_N_per_m,
                   .depth_m = contact.penetration.depth_m,
                   .depth_per_m = gradient,
                   // A rotation about the centre also moves the frame's origin.
                   .depth_per_rad_m = contact.frame.to_world(contact.penetration.lever_m) +
                                      glm::cross(contact.frame.origin_m - centre_m, gradient),
                   .damping_N_s_per_m = contact.share * contact_damping_N_s_per_m_,
                   .friction_N_s_per_m = friction_N_s_per_m(touches_[i]),
                   .n = contact.frame.n,
                   .arm_m = touches_[i].deepest_m - centre_m};
  }
  return tool_->step(probe, std::span(contacts).first(touching_), dt_s);
}

void PdGradient::count(Limit limit, bool is_so) noexcept {
  if (is_so) ++limits_[static_cast<std::size_t>(limit)].ticks;
}

void PdGradient::watch(double dt_s) noexcept {
  const std::span<const Touch> touches = std::span(touches_).first(touching_);
  const auto count_any = [&](Limit limit, auto is_so) {
    count(limit, std::any_of(touches.begin(), touches.end(), is_so));
  };
  count(Limit::contact, !touches.empty());
  count_any(Limit::folded,
            [](const Touch& touch) { return touch.contact->penetration.folded > 0; });
  count_any(Limit::window_border,
            [](const Touch& touch) { return touch.contact->penetration.at_window; });
  count_any(Limit::fine_detail, [this](const Touch& touch) {
    return kSamplesPerWave * touch.contact->grid.spacing_m() > finest_wave_m_;
  });
  count_any(Limit::fast, [this, dt_s](const Touch& touch) {
    const double speed_m_per_s =
        glm::length(across(touch.contact->frame.n, touch.velocity_m_per_s));
    return speed_m_per_s * dt_s > kWavesPerTick * finest_wave_m_;
  });
  count_any(Limit::coarse_window, [](const Touch& touch) { return touch.contact->is_coarse; });
  const LeftOut& left = contacts_.left_out();
  count(Limit::left_out, left.pairs + left.regions + left.triangles + left.depths > 0);
  count_any(Limit::too_deep, [](const Touch& touch) { return touch.contact->is_bounded; });
  count_any(Limit::kept, [](const Touch& touch) { return touch.contact->is_kept; });
  count(Limit::wholly_inside, contacts_.is_inside());
  count(Limit::no_compute, left.is_computed_here);
}

namespace {

std::vector<Parameter> parameters() {
  return {
      choice_parameter(
          "coupling", {"virtual", "none"},
          phrase("Models",
                 "virtual: springs connect the hand to a simulated tool; none: the tool is at the "
                 "position of the device")),
      choice_parameter(
          "maximum", {"hard", "smooth"},
          phrase("Models",
                 "hard: the largest depth and central differences, as in the source; smooth: a "
                 "soft maximum and its exact gradient, which give a different force")),
      number_parameter(
          "step_m", "m", 1e-6, 5e-3, 1e-4,
          phrase("Models",
                 "Hard maximum only: displacement of the tool for a finite difference; 1, 2, 4 or "
                 "8 cells, and at most an eighth of the shortest wavelength")),
      number_parameter(
          "tau_m", "m", 1e-6, 1e-3, 2e-5,
          phrase(
              "Models",
              "Smooth maximum only: heights within a few tau of the highest contribute together")),
      number_parameter("cell_m", "m", 1e-6, 5e-3, 1e-4,
                       phrase("Models", "Spacing of the samples of a contact")),
      integer_parameter(
          "most_samples", 32, 512, 256.0,
          phrase("Models",
                 "Maximum number of samples across a contact; a wider contact has larger cells")),
      integer_parameter(
          "most_halvings", 0, 3, 2.0,
          phrase("Models",
                 "Hard maximum only: how often the cells of a contact on many crests may be "
                 "halved, up to 8 cells in a step; 0: never")),
      number_parameter("texture_gain", "1", 0.0, 10.0, 1.0,
                       phrase("Models", "Factor applied to the displacements of the surface")),
      number_parameter("tool_texture_gain", "1", 0.0, 10.0, 1.0,
                       phrase("Models", "Factor applied to the displacements of the tool")),
      number_parameter(
          "contact_damping_N_s_per_m", "N s/m", 0.0, 100.0, 0.0,
          phrase(
              "Models",
              "Damping of a contact along its gradient; without a coupling, this damping plus half "
              "the stiffness times the period must be less than the device's damping")),
      number_parameter(
          "coupling_stiffness_N_per_m", "N/m", 10.0, 1e5, 1000.0,
          phrase("Models",
                 "Virtual coupling only: stiffness between hand and tool; half of it times the "
                 "period, "
                 "plus the coupling's damping, must be less than the device's damping")),
      number_parameter(
          "coupling_damping_N_s_per_m", "N s/m", 0.0, 100.0, 1.0,
          phrase("Models",
                 "Virtual coupling only: damping between hand and tool; for its limit see "
                 "coupling_stiffness_N_per_m")),
      number_parameter(
          "coupling_angular_stiffness_N_m_per_rad", "N m/rad", 1e-3, 100.0, 0.3,
          phrase("Models",
                 "Virtual coupling only: angular stiffness between hand and tool, which aligns the "
                 "tool with the hand")),
      number_parameter(
          "coupling_angular_damping_N_m_s_per_rad", "N m s/rad", 0.0, 1.0, 5e-4,
          phrase("Models", "Virtual coupling only: angular damping between hand and tool")),
      number_parameter("tool_mass_kg", "kg", 1e-4, 1.0, 0.002,
                       phrase("Models",
                              "Virtual coupling only: mass of the simulated tool, which is added "
                              "to the mass of the "
                              "device")),
      number_parameter(
          "tool_inertia_kg_m2", "kg m2", 1e-8, 1e-2, 1e-6,
          phrase(
              "Models",
              "Virtual coupling only: moment of inertia of the simulated tool about every axis")),
      friction_speed_parameter()};
}

}  // namespace

bool has_virtual_coupling(const ParameterValues& values) {
  const auto coupling = values.find("coupling");
  return coupling != values.end() && coupling->second == ParameterValue(std::string("virtual"));
}

ForceModel pd_gradient_model(std::shared_ptr<const Compute> compute) {
  ModelDeclaration declaration{
      .id = "pd_gradient",
      .version = "6",
      .summary = phrase(
          "Models",
          "Two textured meshes in six degrees of freedom: the gradient of penetration depth"),
      .source =
          "Otaduy, Jain, Sud, Lin (2004), Haptic display of interaction between textured models, "
          "IEEE Visualization 2004",
      .needs_bodies = true,
      .amplitude_parameter = "texture_gain",
      // Where two places have equal depth, the last digit selects one of two gradients.
      .replay_tolerance_N = 0.01,
      .parameters = parameters(),
      .conflict_among = [](const ParameterValues& values) {
        return conflict_in(sampling_of(values));
      }};
  const auto make = [compute, shared = std::make_shared<PdGradient::SharedParts>()](
                        const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
    return std::make_unique<PdGradient>(inputs, instruction_sets_here().back(), compute.get(),
                                        shared.get());
  };
  return {.declaration = std::move(declaration),
          .make = make,
          .suggested_by = {},
          .conservative_with = ParameterValues{{"coupling", std::string("none")},
                                               {"maximum", std::string("smooth")},
                                               {"contact_damping_N_s_per_m", 0.0}},
          .band =
              [](const RendererInputs& inputs) {
                return TextureBand{.per_m = 1.0 / (2.0 * number_of(inputs.parameters, "cell_m"))};
              },
          .band_formula = "v/(2*cell_m)",
          .compute = std::move(compute)};
}

}  // namespace asperity
