// Implements the integration step of the coupled tool.

#include "renderers/pd_gradient/contact/coupled_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Vector6 stacked(const glm::dvec3& first, const glm::dvec3& second) {
  Vector6 both;
  both << first.x, first.y, first.z, second.x, second.y, second.z;
  return both;
}

glm::dvec3 head_of(const Vector6& both) { return {both[0], both[1], both[2]}; }
glm::dvec3 tail_of(const Vector6& both) { return {both[3], both[4], both[5]}; }

/// The rotation vector [rad] of a unit quaternion, with a length of at most π.
glm::dvec3 rotation_vector(glm::dquat turn) noexcept {
  if (turn.w < 0.0) turn = -turn;
  const glm::dvec3 axis(turn.x, turn.y, turn.z);
  const double sine = glm::length(axis);
  // Below this value sin(a/2) equals a/2 to the last digit.
  if (sine < 1e-9) return 2.0 * axis;
  return axis * (2.0 * std::atan2(sine, turn.w) / sine);
}

glm::dquat turn_by(const glm::dvec3& rotation_rad) noexcept {
  const double angle_rad = glm::length(rotation_rad);
  if (angle_rad < 1e-12) return {1.0, 0.0, 0.0, 0.0};
  const double sine = std::sin(0.5 * angle_rad);
  return {std::cos(0.5 * angle_rad), rotation_rad * (sine / angle_rad)};
}

/// The matrix of a damper perpendicular to n at a point: b·Jᵀ(1 − n nᵀ)J, with J the point's velocity per twist.
Matrix6 friction_of(const PenaltyContact& contact) noexcept {
  Eigen::Matrix<double, 3, 6> point = Eigen::Matrix<double, 3, 6>::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 unit(0.0);
    unit[axis] = 1.0;
    const glm::dvec3 turned = glm::cross(unit, contact.arm_m);
    const glm::dvec3 moved_across = unit - contact.n * glm::dot(contact.n, unit);
    const glm::dvec3 turned_across = turned - contact.n * glm::dot(contact.n, turned);
    point.col(axis) << moved_across.x, moved_across.y, moved_across.z;
    point.col(3 + axis) << turned_across.x, turned_across.y, turned_across.z;
  }
  return contact.friction_N_s_per_m * (point.transpose() * point);
}

void require(bool holds, const char* field, double value, const char* what) {
  if (holds) return;
  throw std::invalid_argument(std::string(field) + " of the coupled tool is " + number_text(value) +
                              "; it " + what);
}

}  // namespace

CoupledTool::CoupledTool(const Properties& properties) : properties_(properties) {
  const auto is_positive = [](double value, const char* field) {
    require(std::isfinite(value) && value > 0.0, field, value, "must be a positive number");
  };
  is_positive(properties.mass_kg, "mass_kg");
  is_positive(properties.inertia_kg_m2, "inertia_kg_m2");
  is_positive(properties.stiffness_N_per_m, "stiffness_N_per_m");
  is_positive(properties.angular_stiffness_N_m_per_rad, "angular_stiffness_N_m_per_rad");
  const auto is_damping = [](double value, const char* field) {
    require(std::isfinite(value) && value >= 0.0, field, value, "must be a number of at least 0");
  };
  is_damping(properties.damping_N_s_per_m, "damping_N_s_per_m");
  is_damping(properties.angular_damping_N_m_s_per_rad, "angular_damping_N_m_s_per_rad");
}

glm::dvec3 CoupledTool::arm_m(const ProbeState& device) const noexcept {
  return device.orientation * properties_.centre_in_tool_m;
}

void CoupledTool::reset(const ProbeState& device) noexcept {
  const glm::dvec3 arm = arm_m(device);
  pose_ = {.centre_m = device.position_m + arm, .orientation = device.orientation};
  velocity_m_per_s_ = device.velocity_m_per_s + glm::cross(device.angular_velocity_rad_per_s, arm);
  angular_velocity_rad_per_s_ = device.angular_velocity_rad_per_s;
}

glm::dvec3 CoupledTool::velocity_m_per_s(const glm::dvec3& arm_m) const noexcept {
  return velocity_m_per_s_ + glm::cross(angular_velocity_rad_per_s_, arm_m);
}

Wrench CoupledTool::step(const ProbeState& device, std::span<const PenaltyContact> contacts,
                         double dt_s) noexcept {
  contacts = contacts.first(std::min(contacts.size(), kMaximumContacts));
  const Properties& own = properties_;
  const glm::dvec3 arm = arm_m(device);
  const Vector6 stiffness =
      stacked(glm::dvec3(own.stiffness_N_per_m), glm::dvec3(own.angular_stiffness_N_m_per_rad));
  const Vector6 damping =
      stacked(glm::dvec3(own.damping_N_s_per_m), glm::dvec3(own.angular_damping_N_m_s_per_rad));
  const Vector6 mass = stacked(glm::dvec3(own.mass_kg), glm::dvec3(own.inertia_kg_m2));
  const Vector6 way =
      stacked(device.position_m + arm - pose_.centre_m,
              rotation_vector(device.orientation * glm::conjugate(pose_.orientation)));
  const Vector6 device_twist =
      stacked(device.velocity_m_per_s + glm::cross(device.angular_velocity_rad_per_s, arm),
              device.angular_velocity_rad_per_s);
  const Vector6 twist_before = stacked(velocity_m_per_s_, angular_velocity_rad_per_s_);

  Matrix6 free_matrix = (mass / dt_s + dt_s * stiffness + damping).asDiagonal();
  const Vector6 free_right = mass.cwiseProduct(twist_before) / dt_s + stiffness.cwiseProduct(way) +
                             damping.cwiseProduct(device_twist);

  // The removal of one contact may make another one pull: the step is repeated until none pulls, at most once per
  // contact.
  std::array<bool, kMaximumContacts> is_left_out{};
  Vector6 twist = twist_before;
  for (bool has_changed = true; has_changed;) {
    Matrix6 matrix = free_matrix;
    Vector6 right = free_right;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (is_left_out[i]) continue;
      const PenaltyContact& contact = contacts[i];
      const Vector6 gradient = stacked(contact.depth_per_m, contact.depth_per_rad_m);
      matrix.noalias() += (dt_s * contact.stiffness_N_per_m + contact.damping_N_s_per_m) *
                          (gradient * gradient.transpose());
      if (contact.friction_N_s_per_m > 0.0) matrix += friction_of(contact);
      right -= contact.stiffness_N_per_m * contact.depth_m * gradient;
    }
    twist = matrix.llt().solve(right);
    has_changed = false;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      if (is_left_out[i]) continue;
      const PenaltyContact& contact = contacts[i];
      const double depth_rate_m_per_s =
          stacked(contact.depth_per_m, contact.depth_per_rad_m).dot(twist);
      const double push_N =
          contact.stiffness_N_per_m * (contact.depth_m + dt_s * depth_rate_m_per_s) +
          contact.damping_N_s_per_m * depth_rate_m_per_s;
      if (push_N < 0.0) is_left_out[i] = has_changed = true;
    }
  }

  const Vector6 coupling =
      stiffness.cwiseProduct(way - dt_s * twist) + damping.cwiseProduct(device_twist - twist);
  velocity_m_per_s_ = head_of(twist);
  angular_velocity_rad_per_s_ = tail_of(twist);
  pose_.centre_m += dt_s * velocity_m_per_s_;
  pose_.orientation =
      glm::normalize(turn_by(dt_s * angular_velocity_rad_per_s_) * pose_.orientation);
  const glm::dvec3 force_N = -head_of(coupling);
  return {.force_N = force_N, .torque_N_m = glm::cross(arm, force_N) - tail_of(coupling)};
}

}  // namespace asperity
