// Implements the transfers to the device and back, and the order of its kernels.

#include "renderers/pd_gradient/gpu/gpu_penetration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "renderers/compute/open_cl.h"
#include "renderers/compute/transfer_memory.h"
#include "renderers/pd_gradient/gpu/device_task.h"
#include "renderers/pd_gradient/gpu/penetration_kernels.h"

namespace asperity {
namespace {

constexpr std::size_t kGroup = 64;            // GROUP
constexpr std::size_t kGroupOfWeights = 256;  // WEIGH_GROUP

// A body's triangles and texture on the device.
struct DeviceBody {
  DeviceBody(const cl::Context& context, const TexturedMesh& mesh, double gain)
      : rows(static_cast<cl_int>(mesh.atlas.rows)),
        columns(static_cast<cl_int>(mesh.atlas.columns)),
        step_m(gain * mesh.atlas.step_m) {
    std::vector<DeviceCorner> list = corners_of(mesh);
    if (list.empty()) throw std::invalid_argument("TexturedMesh: there is no triangle.");
    constexpr cl_mem_flags kCopied = CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR;
    corners = cl::Buffer(context, kCopied, list.size() * sizeof(DeviceCorner), list.data());
    std::vector<std::int16_t> values = mesh.atlas.values;
    for (const std::int16_t value : values) peak_m = std::max(peak_m, std::abs(step_m * value));
    texels = cl::Buffer(context, kCopied, values.size() * sizeof(std::int16_t), values.data());
  }

  cl_int rows = 0;
  cl_int columns = 0;
  cl_double step_m = 0.0;
  cl_double peak_m = 0.0;  // the greatest displacement, of either sign
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
        input_(context_, queue_,
               room.contacts * sizeof(DeviceTask) + room.triangles * sizeof(std::int32_t)),
        answers_(context_, queue_, room.contacts) {
    lists_.reserve(room.triangles);
    make_kernels(program_);
    const auto samples = static_cast<std::size_t>(room.samples * room.samples);
    const auto make = [this](std::size_t bytes) {
      return cl::Buffer(context_, CL_MEM_READ_WRITE, bytes);
    };
    device_input_ = make(input_.bytes());
    device_answers_ = make(answers_.bytes());
    faces_ = make(room.triangles * (kDeviceSurfaces - 1) * kFaceBytes);
    heights_m_ = make(room.contacts * 2 * samples * sizeof(double));
    rates_ = make(room.is_smooth ? room.contacts * kDeviceRates * samples * sizeof(double) : 1);
    bounds_m_ = make(room.contacts * kDeviceSurfaces * sizeof(double));
    found_ =
        make(room.contacts * kDeviceSurfaces * static_cast<std::size_t>(most_tiles_) * kFoundBytes);
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
    sample_here_ = cl::Kernel(program, "sample_here");
    find_bounds_ = cl::Kernel(program, "find_bounds");
    sample_moved_ = cl::Kernel(program, "sample_moved");
    rate_heights_ = cl::Kernel(program, "rate_heights");
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
    give(prepare_faces_, device_input_, cl_int{0}, b_.corners, a_.corners, b_.peak_m, a_.peak_m,
         faces_);
    give(sample_here_, device_input_, faces_, b_.texels, b_.rows, b_.columns, b_.step_m, a_.texels,
         a_.rows, a_.columns, a_.step_m, most_tiles, heights_m_, most_samples, found_);
    give(rate_heights_, device_input_, faces_, a_.texels, a_.rows, a_.columns, a_.step_m,
         heights_m_, most_samples, rates_);
    give(find_bounds_, device_input_, faces_, a_.texels, a_.rows, a_.columns, a_.step_m, most_tiles,
         heights_m_, most_samples, found_, bounds_m_);
    give(sample_moved_, device_input_, faces_, a_.texels, a_.rows, a_.columns, a_.step_m,
         most_tiles, heights_m_, most_samples, bounds_m_, found_);
    give(find_deepest_, device_input_, found_, most_tiles, heights_m_, most_samples, bounds_m_,
         device_answers_);
    give(weigh_, device_input_, heights_m_, rates_, most_samples, device_answers_);
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
      if (std::holds_alternative<SmoothMaximum>(contact.law) && !room_.is_smooth) return false;
      DeviceTask& task = tasks_[i];
      task = device_task_of(contact);
      task.first_face = faces;
      add_list(contact.triangles_b, 0, task);
      add_list(contact.triangles_a, 1, task);
      faces += task.count[0] + (task.used_surfaces - 1) * task.count[1];
      used_tiles_ = std::max(used_tiles_, (samples / kSamplesOfTile) * (samples / kSamplesOfTile));
      used_surfaces_ = std::max(used_surfaces_, task.used_surfaces);
      is_smooth_ = is_smooth_ || task.tau_m > 0.0;
    }
    return true;
  }

  void add_list(std::span<const std::uint32_t> triangles, std::size_t body, DeviceTask& task) {
    task.first[body] = static_cast<std::int32_t>(lists_.size());
    task.count[body] = static_cast<std::int32_t>(triangles.size());
    for (const std::uint32_t triangle : triangles) {
      lists_.push_back(static_cast<std::int32_t>(triangle));
    }
    most_count_ = std::max(most_count_, triangles.size());
  }

  void submit(std::size_t contacts) {
    const std::size_t tasks_bytes = contacts * sizeof(DeviceTask);
    const std::size_t lists_bytes = lists_.size() * sizeof(std::int32_t);
    std::memcpy(input_.data(), tasks_.data(), tasks_bytes);
    if (!lists_.empty()) std::memcpy(input_.data() + tasks_bytes, lists_.data(), lists_bytes);
    queue_.enqueueWriteBuffer(device_input_, CL_FALSE, 0, tasks_bytes + lists_bytes, input_.data());
    if (!lists_.empty()) {
      prepare_faces_.setArg(1, static_cast<cl_int>(contacts));
      queue_.enqueueNDRangeKernel(
          prepare_faces_, cl::NullRange,
          cl::NDRange(most_count_, static_cast<std::size_t>(used_surfaces_), contacts));
    }
    const auto tiles = static_cast<std::size_t>(used_tiles_) * kGroup;
    const cl::NDRange group(kGroup, 1, 1);
    queue_.enqueueNDRangeKernel(sample_here_, cl::NullRange, cl::NDRange(2 * tiles, contacts, 1),
                                cl::NDRange(2 * kGroup, 1, 1));
    const std::size_t moved = static_cast<std::size_t>(used_surfaces_) - 2;
    if (moved > 0) {
      queue_.enqueueNDRangeKernel(find_bounds_, cl::NullRange,
                                  cl::NDRange(moved * kGroup, contacts, 1), group);
      queue_.enqueueNDRangeKernel(sample_moved_, cl::NullRange, cl::NDRange(tiles, moved, contacts),
                                  group);
    }
    queue_.enqueueNDRangeKernel(find_deepest_, cl::NullRange,
                                cl::NDRange((moved + 1) * kGroup, contacts, 1), group);
    if (is_smooth_) {
      constexpr std::size_t kSamples = kSamplesOfTile * kSamplesOfTile;
      queue_.enqueueNDRangeKernel(
          rate_heights_, cl::NullRange,
          cl::NDRange(static_cast<std::size_t>(used_tiles_) * kSamples, contacts));
      queue_.enqueueNDRangeKernel(weigh_, cl::NullRange,
                                  cl::NDRange(contacts * kGroupOfWeights, 1, 1),
                                  cl::NDRange(kGroupOfWeights, 1, 1));
    }
    queue_.enqueueReadBuffer(device_answers_, CL_FALSE, 0, contacts * sizeof(DeviceAnswer),
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
  cl::Kernel sample_here_{};
  cl::Kernel find_bounds_{};
  cl::Kernel sample_moved_{};
  cl::Kernel rate_heights_{};
  cl::Kernel find_deepest_{};
  cl::Kernel weigh_{};
  cl::Buffer device_input_{};
  cl::Buffer device_answers_{};
  cl::Buffer faces_{};
  cl::Buffer heights_m_{};
  cl::Buffer rates_{};
  cl::Buffer bounds_m_{};
  cl::Buffer found_{};
  std::vector<DeviceTask> tasks_{};
  TransferMemory<std::byte> input_;  // the tasks, then the lists
  TransferMemory<DeviceAnswer> answers_;
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
