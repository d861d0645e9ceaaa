// Implements the transfers to the device and back, and the differences of the depths it found.

#include "renderers/pd_gradient/gpu/gpu_penetration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "renderers/compute/open_cl.h"
#include "renderers/pd_gradient/gpu/penetration_kernels.h"

namespace asperity {
namespace {

// These are repeated in penetration.cl.
constexpr std::size_t kSurfaces = 12;  // B; A here; A forth and back along u, v, about u, v, n
constexpr std::size_t kGroup = 256;
constexpr std::size_t kSums = 12;
constexpr std::size_t kRates = 5;
constexpr int kSurfacesOfSmooth = 2;

struct Task {
  std::array<double, 12> frame{};
  std::array<std::array<double, 12>, kSurfaces> poses{};
  double spacing_m = 0.0;
  double width_m = 0.0;
  std::array<double, 2> leaning{};
  double tau_m = 0.0;
  std::int32_t samples = 0;
  std::int32_t used_surfaces = 0;
  std::array<std::int32_t, 2> first{};
  std::array<std::int32_t, 2> count{};
  std::int32_t first_face = 0;
  std::int32_t padding = 0;
};

struct Answer {
  std::array<double, kSurfaces> depth_m{};
  double height_m = 0.0;
  std::array<double, kSums> sums{};
  std::int32_t sample = 0;
  std::int32_t covered = 0;
  std::int32_t folded = 0;
  std::int32_t at_border = 0;
};

struct DeviceCorner {
  std::array<double, 3> point_m{};
  std::array<double, 3> normal{};
  std::array<double, 2> place{};
  std::int32_t vertex = 0;
  std::int32_t padding = 0;
};

constexpr std::size_t kFaceBytes = 8 * (3 * 8 + 1) + 4 * 8;
constexpr std::size_t kFoundBytes = 8 + 4 * 4;
static_assert(sizeof(Task) == 8 * (12 + 12 * kSurfaces + 5) + 4 * 8);
static_assert(sizeof(Answer) == 8 * (kSurfaces + 1 + kSums) + 4 * 4);
static_assert(sizeof(DeviceCorner) == 8 * 8 + 4 * 2);

std::array<double, 12> columns_of(const Pose& pose) {
  const glm::dmat3& r = pose.rotation;
  const glm::dvec3& p = pose.position_m;
  return {r[0].x, r[0].y, r[0].z, r[1].x, r[1].y, r[1].z, r[2].x, r[2].y, r[2].z, p.x, p.y, p.z};
}

Pose moved_along(Pose pose, const glm::dvec3& by_m) {
  pose.position_m += by_m;
  return pose;
}

Pose turned_about(const Pose& pose, const glm::dvec3& centre_m, const glm::dvec3& axis,
                  double angle_rad) {
  const glm::dmat3 turn = glm::mat3_cast(glm::angleAxis(angle_rad, axis));
  return {.rotation = turn * pose.rotation,
          .position_m = centre_m + turn * (pose.position_m - centre_m)};
}

// A's poses forth and back, in the order of the kernel's surfaces from the third.
void set_differences(const GpuContact& contact, const HardMaximum& law, Task& task) {
  const DifferenceSteps steps = difference_steps(contact.grid, law.step_m);
  const ContactFrame& frame = contact.frame;
  std::size_t surface = 2;
  for (const glm::dvec3& axis : {frame.u, frame.v}) {
    for (const double way : {1.0, -1.0}) {
      task.poses[surface++] = columns_of(moved_along(contact.pose_a, way * steps.along_m * axis));
    }
  }
  const auto about = [&](const glm::dvec3& axis, double step_rad) {
    for (const double way : {1.0, -1.0}) {
      task.poses[surface++] =
          columns_of(turned_about(contact.pose_a, frame.origin_m, axis, way * step_rad));
    }
  };
  about(frame.u, steps.tilt_rad);
  about(frame.v, steps.tilt_rad);
  about(frame.n, steps.turn_rad);
}

// If one of the two configurations has no overlap, the difference is one-sided; if both have none, it is 0.
double difference(double forth_m, double back_m, double here_m, double step) {
  if (!std::isnan(forth_m) && !std::isnan(back_m)) return (forth_m - back_m) / (2.0 * step);
  if (!std::isnan(forth_m)) return (forth_m - here_m) / step;
  if (!std::isnan(back_m)) return (here_m - back_m) / step;
  return 0.0;
}

void set_gradient(const Answer& answer, const SamplingGrid& grid, const HardMaximum& law,
                  Penetration& result) {
  const DifferenceSteps steps = difference_steps(grid, law.step_m);
  const auto& depth_m = answer.depth_m;
  const auto rate = [&](std::size_t forth, double step) {
    return difference(depth_m[forth], depth_m[forth + 1], depth_m[1], step);
  };
  result.slope = {rate(2, steps.along_m), rate(4, steps.along_m)};
  result.lever_m = {rate(6, steps.tilt_rad), rate(8, steps.tilt_rad), rate(10, steps.turn_rad)};
}

void set_gradient(const Answer& answer, const SmoothMaximum& law, Penetration& result) {
  const auto& sums = answer.sums;
  const double sunk = sums[1] / sums[0];  // (δ − here)/τ
  std::array<double, kRates> rates{};
  for (std::size_t q = 0; q < kRates; ++q) {
    // δ decreases where A rises.
    rates[q] = -((1.0 - sunk) * sums[2 + q] + sums[2 + kRates + q]) / sums[0];
  }
  result.depth_m += law.tau_m * sunk;
  result.slope = {rates[0], rates[1]};
  result.lever_m = {rates[2], rates[3], rates[4]};
}

std::optional<Penetration> penetration_of(const Answer& answer, const GpuContact& contact) {
  if (answer.covered == 0) return std::nullopt;
  const SamplingGrid& grid = contact.grid;
  const int row = answer.sample / grid.samples;
  const int column = answer.sample % grid.samples;
  Penetration result{.depth_m = answer.depth_m[1],
                     .deepest_m = {grid.place_m(column), grid.place_m(row), answer.height_m},
                     .covered = answer.covered,
                     .folded = answer.folded,
                     .at_border = answer.at_border != 0,
                     .at_window = grid.is_outermost(row, column)};
  if (const auto* hard = std::get_if<HardMaximum>(&contact.law)) {
    set_gradient(answer, grid, *hard, result);
  } else {
    set_gradient(answer, std::get<SmoothMaximum>(contact.law), result);
  }
  return result;
}

std::vector<DeviceCorner> corners_of(const TexturedMesh& mesh) {
  std::vector<DeviceCorner> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[i][k];
      const glm::dvec3& p = mesh.vertices_m[vertex];
      const glm::dvec3& n = mesh.normals[vertex];
      const glm::dvec2& place = mesh.places[i][k];
      corners.push_back({.point_m = {p.x, p.y, p.z},
                         .normal = {n.x, n.y, n.z},
                         .place = {place.x, place.y},
                         .vertex = static_cast<std::int32_t>(vertex)});
    }
  }
  return corners;
}

// A body's triangles and texture on the device.
struct DeviceBody {
  DeviceBody(const cl::Context& context, const TexturedMesh& mesh, double gain)
      : triangles(mesh.triangles.size()),
        rows(static_cast<cl_int>(mesh.atlas.rows)),
        columns(static_cast<cl_int>(mesh.atlas.columns)),
        step_m(gain * mesh.atlas.step_m) {
    std::vector<DeviceCorner> list = corners_of(mesh);
    if (list.empty()) throw std::invalid_argument("TexturedMesh: there is no triangle.");
    constexpr cl_mem_flags kCopied = CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR;
    corners = cl::Buffer(context, kCopied, list.size() * sizeof(DeviceCorner), list.data());
    std::vector<std::int16_t> values = mesh.atlas.values;
    texels = cl::Buffer(context, kCopied, values.size() * sizeof(std::int16_t), values.data());
  }

  std::size_t triangles = 0;
  cl_int rows = 0;
  cl_int columns = 0;
  cl_double step_m = 0.0;
  cl::Buffer corners{};
  cl::Buffer texels{};
};

[[noreturn]] void refuse(const ComputeDevice& device, const std::string& problem) {
  throw std::runtime_error("The compute device " + described(device.name()) + ": " + problem);
}

}  // namespace

// The objects of the driver, and the room on both sides.
class GpuPenetration::Program final {
 public:
  Program(const ComputeDevice& device, const TexturedMesh& a, double gain_a, const TexturedMesh& b,
          double gain_b, const GpuRoom& room)
      : program_(compiled_for(device, kPenetrationKernels)),
        context_(device.handle().context),
        queue_(context_, device.handle().device),
        a_(context_, a, gain_a),
        b_(context_, b, gain_b),
        room_(room),
        most_tiles_((room.samples / kSamplesOfTile) * (room.samples / kSamplesOfTile)),
        tasks_(room.contacts),
        answers_(room.contacts) {
    lists_.reserve(room.triangles);
    make_kernels(program_);
    const auto samples = static_cast<std::size_t>(room.samples * room.samples);
    const auto make = [this](std::size_t bytes) {
      return cl::Buffer(context_, CL_MEM_READ_WRITE, bytes);
    };
    device_tasks_ = make(room.contacts * sizeof(Task));
    device_lists_ = make(room.triangles * sizeof(std::int32_t));
    device_answers_ = make(room.contacts * sizeof(Answer));
    faces_ = make(room.triangles * (kSurfaces - 1) * kFaceBytes);
    heights_m_ = make(room.contacts * 2 * samples * sizeof(double));
    rates_ = make(room.is_smooth ? room.contacts * kRates * samples * sizeof(double) : 1);
    found_ = make(room.contacts * kSurfaces * static_cast<std::size_t>(most_tiles_) * kFoundBytes);
    set_arguments();
    queue_.finish();
  }

  ~Program() {
    try {
      queue_.finish();  // the transfers use the memory of this object
    } catch (const cl::Error&) {
      // The device is lost, and with it everything on it.
    }
  }

  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  GpuOutcome evaluate(std::span<const GpuContact> contacts,
                      std::span<std::optional<Penetration>> answers,
                      std::chrono::nanoseconds deadline) noexcept {
    const auto until = std::chrono::steady_clock::now() + deadline;
    if (is_lost_) return GpuOutcome::lost;
    try {
      if (is_late_ && !has_ended()) return GpuOutcome::busy;
      is_late_ = false;
      if (contacts.empty()) return GpuOutcome::answered;
      if (!fill(contacts)) return GpuOutcome::too_much;
      submit(contacts.size());
      while (!has_ended()) {
        if (std::chrono::steady_clock::now() >= until) {
          is_late_ = true;
          return GpuOutcome::late;
        }
        std::this_thread::yield();
      }
    } catch (const cl::Error&) {
      is_lost_ = true;
      return GpuOutcome::lost;
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      answers[i] = penetration_of(answers_[i], contacts[i]);
    }
    return GpuOutcome::answered;
  }

 private:
  void make_kernels(const cl::Program& program) {
    prepare_faces_ = cl::Kernel(program, "prepare_faces");
    sample_b_ = cl::Kernel(program, "sample_tiles");
    sample_a_ = cl::Kernel(program, "sample_tiles");
    find_deepest_ = cl::Kernel(program, "find_deepest");
    weigh_ = cl::Kernel(program, "weigh");
  }

  template <typename... Arguments>
  static void give(cl::Kernel& kernel, const Arguments&... arguments) {
    cl_uint place = 0;
    (kernel.setArg(place++, arguments), ...);
  }

  void set_arguments() {
    const cl_int most_tiles = most_tiles_;
    const cl_int most_samples = room_.samples * room_.samples;
    give(prepare_faces_, device_tasks_, device_lists_, b_.corners, a_.corners, faces_);
    const auto give_sampling = [&](cl::Kernel& kernel, cl_int first_surface) {
      give(kernel, device_tasks_, faces_, b_.texels, b_.rows, b_.columns, b_.step_m, a_.texels,
           a_.rows, a_.columns, a_.step_m, first_surface, most_tiles, heights_m_, rates_,
           most_samples, found_);
    };
    give_sampling(sample_b_, 0);
    give_sampling(sample_a_, 1);
    give(find_deepest_, device_tasks_, found_, most_tiles, heights_m_, most_samples,
         device_answers_);
    give(weigh_, device_tasks_, heights_m_, rates_, most_samples, device_answers_);
  }

  // False without enough room.
  bool fill(std::span<const GpuContact> contacts) {
    lists_.clear();
    most_count_ = 0;
    used_tiles_ = 0;
    used_surfaces_ = 0;
    is_smooth_ = false;
    std::int32_t faces = 0;
    if (contacts.size() > room_.contacts) return false;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const GpuContact& contact = contacts[i];
      const int samples = contact.grid.samples;
      if (samples > room_.samples || samples % kSamplesOfTile != 0) return false;
      if (lists_.size() + contact.triangles_a.size() + contact.triangles_b.size() >
          room_.triangles) {
        return false;
      }
      const ContactFrame& frame = contact.frame;
      const auto* smooth = std::get_if<SmoothMaximum>(&contact.law);
      if (smooth != nullptr && !room_.is_smooth) return false;
      Task& task = tasks_[i];
      task = {
          .frame = {frame.origin_m.x, frame.origin_m.y, frame.origin_m.z, frame.u.x, frame.u.y,
                    frame.u.z, frame.v.x, frame.v.y, frame.v.z, frame.n.x, frame.n.y, frame.n.z},
          .spacing_m = contact.grid.spacing_m(),
          .width_m = contact.grid.width_m,
          .leaning = {contact.leaning_b, contact.leaning_a},
          .tau_m = smooth != nullptr ? smooth->tau_m : 0.0,
          .samples = samples,
          .used_surfaces =
              smooth != nullptr ? kSurfacesOfSmooth : static_cast<std::int32_t>(kSurfaces),
          .first_face = faces};
      task.poses[0] = columns_of(contact.pose_b);
      task.poses[1] = columns_of(contact.pose_a);
      if (smooth == nullptr) set_differences(contact, std::get<HardMaximum>(contact.law), task);
      add_list(contact.triangles_b, 0, task);
      add_list(contact.triangles_a, 1, task);
      faces += task.count[0] + (task.used_surfaces - 1) * task.count[1];
      used_tiles_ = std::max(used_tiles_, (samples / kSamplesOfTile) * (samples / kSamplesOfTile));
      used_surfaces_ = std::max(used_surfaces_, task.used_surfaces);
      is_smooth_ = is_smooth_ || smooth != nullptr;
    }
    return true;
  }

  void add_list(std::span<const std::uint32_t> triangles, std::size_t body, Task& task) {
    task.first[body] = static_cast<std::int32_t>(lists_.size());
    task.count[body] = static_cast<std::int32_t>(triangles.size());
    for (const std::uint32_t triangle : triangles) {
      lists_.push_back(static_cast<std::int32_t>(triangle));
    }
    most_count_ = std::max(most_count_, triangles.size());
  }

  void submit(std::size_t contacts) {
    queue_.enqueueWriteBuffer(device_tasks_, CL_FALSE, 0, contacts * sizeof(Task), tasks_.data());
    if (!lists_.empty()) {
      queue_.enqueueWriteBuffer(device_lists_, CL_FALSE, 0, lists_.size() * sizeof(std::int32_t),
                                lists_.data());
      queue_.enqueueNDRangeKernel(
          prepare_faces_, cl::NullRange,
          cl::NDRange(most_count_, static_cast<std::size_t>(used_surfaces_), contacts));
    }
    const auto tiles = static_cast<std::size_t>(used_tiles_) * kGroup;
    const cl::NDRange group(kGroup, 1, 1);
    queue_.enqueueNDRangeKernel(sample_b_, cl::NullRange, cl::NDRange(tiles, 1, contacts), group);
    queue_.enqueueNDRangeKernel(
        sample_a_, cl::NullRange,
        cl::NDRange(tiles, static_cast<std::size_t>(used_surfaces_ - 1), contacts), group);
    const cl::NDRange each(contacts * kGroup, 1, 1);
    queue_.enqueueNDRangeKernel(find_deepest_, cl::NullRange, each, group);
    if (is_smooth_) queue_.enqueueNDRangeKernel(weigh_, cl::NullRange, each, group);
    queue_.enqueueReadBuffer(device_answers_, CL_FALSE, 0, contacts * sizeof(Answer),
                             answers_.data(), nullptr, &end_);
    queue_.flush();
  }

  bool has_ended() const {
    const cl_int status = end_.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>();
    if (status < 0) throw cl::Error(status, "the submission");
    return status == CL_COMPLETE;
  }

  cl::Program program_;
  cl::Context context_;
  cl::CommandQueue queue_;  // in order
  DeviceBody a_;
  DeviceBody b_;
  GpuRoom room_{};
  std::int32_t most_tiles_ = 0;
  cl::Kernel prepare_faces_{};
  cl::Kernel sample_b_{};
  cl::Kernel sample_a_{};
  cl::Kernel find_deepest_{};
  cl::Kernel weigh_{};
  cl::Buffer device_tasks_{};
  cl::Buffer device_lists_{};
  cl::Buffer device_answers_{};
  cl::Buffer faces_{};
  cl::Buffer heights_m_{};
  cl::Buffer rates_{};
  cl::Buffer found_{};
  std::vector<Task> tasks_{};
  std::vector<Answer> answers_{};
  std::vector<std::int32_t> lists_{};
  std::size_t most_count_ = 0;
  std::int32_t used_tiles_ = 0;
  std::int32_t used_surfaces_ = 0;
  bool is_smooth_ = false;
  cl::Event end_{};
  bool is_late_ = false;
  bool is_lost_ = false;
};

GpuPenetration::GpuPenetration(const ComputeDevice& device, const TexturedMesh& a, double gain_a,
                               const TexturedMesh& b, double gain_b, const GpuRoom& room) {
  require_sound(a);
  require_sound(b);
  if (room.contacts == 0 || room.triangles == 0 || room.samples < kSamplesOfTile ||
      room.samples % kSamplesOfTile != 0) {
    throw std::invalid_argument(
        "GpuRoom: contacts and triangles must be positive, and samples a positive multiple of " +
        std::to_string(kSamplesOfTile) + ".");
  }
  try {
    program_ = std::make_unique<Program>(device, a, gain_a, b, gain_b, room);
  } catch (const cl::Error& error) {
    refuse(device, std::string(error.what()) + " failed with the code " +
                       std::to_string(error.err()) + ".");
  } catch (const std::runtime_error& error) {
    refuse(device, error.what());
  }
}

GpuPenetration::~GpuPenetration() = default;
GpuPenetration::GpuPenetration(GpuPenetration&&) noexcept = default;
GpuPenetration& GpuPenetration::operator=(GpuPenetration&&) noexcept = default;

GpuOutcome GpuPenetration::evaluate(std::span<const GpuContact> contacts,
                                    std::span<std::optional<Penetration>> answers,
                                    std::chrono::nanoseconds deadline) noexcept {
  return program_->evaluate(contacts, answers, deadline);
}

}  // namespace asperity
