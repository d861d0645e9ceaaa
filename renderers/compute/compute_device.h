// Declares the devices that can evaluate contacts in parallel: those of the OpenCL drivers of this machine.

#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

/// What is recorded about the device that computed a force.
struct ComputeDeviceName {
  std::string device{};  ///< as its driver names it
  std::string platform{};
  std::string driver{};  ///< the driver's version
  bool is_gpu = false;   ///< false for a driver that computes on the processor
};

/// A device with double precision, ready for use. Copies share what was compiled for it.
class ComputeDevice final {
 public:
  /// The devices of this machine that have double precision: GPUs first, otherwise in the order of their drivers. Empty
  /// without a driver.
  static std::vector<ComputeDevice> all();

  const ComputeDeviceName& name() const noexcept { return name_; }

  /// The driver's own objects, for the code of this folder.
  struct Handle;
  Handle& handle() const noexcept { return *handle_; }

 private:
  explicit ComputeDevice(std::shared_ptr<Handle> handle);

  std::shared_ptr<Handle> handle_{};
  ComputeDeviceName name_{};
};

/// A device for the contacts of a tick, and the time for which a tick waits for it.
struct Compute {
  ComputeDevice device;
  std::chrono::nanoseconds deadline{};
};

/// The first device of this machine. Throws std::runtime_error with the remedy where there is none.
std::shared_ptr<const Compute> first_compute(std::chrono::nanoseconds deadline);

/// "NVIDIA H100 (NVIDIA CUDA, driver 550.54.15)".
std::string described(const ComputeDeviceName& name);

}  // namespace asperity
