// Enumerates the platforms of OpenCL, and compiles kernels for a device.

#include "renderers/compute/compute_device.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "renderers/compute/open_cl.h"

namespace asperity {
namespace {

// Drivers pad names with spaces, and end them with zeros.
std::string trimmed(const std::string& text) {
  const std::string padding(" \t\0", 3);
  const std::size_t first = text.find_first_not_of(padding);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(padding) - first + 1);
}

}  // namespace

ComputeDevice::ComputeDevice(std::shared_ptr<Handle> handle) : handle_(std::move(handle)) {
  const cl::Device& device = handle_->device;
  const cl::Platform platform(device.getInfo<CL_DEVICE_PLATFORM>());
  name_ = {.device = trimmed(device.getInfo<CL_DEVICE_NAME>()),
           .platform = trimmed(platform.getInfo<CL_PLATFORM_NAME>()),
           .driver = trimmed(device.getInfo<CL_DRIVER_VERSION>()),
           .is_gpu = (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_GPU) != 0};
}

std::vector<ComputeDevice> ComputeDevice::all() {
  std::vector<ComputeDevice> devices;
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  } catch (const cl::Error&) {
    return devices;  // no driver is installed
  }
  for (const cl::Platform& platform : platforms) {
    std::vector<cl::Device> found;
    try {
      platform.getDevices(CL_DEVICE_TYPE_ALL, &found);
      for (const cl::Device& device : found) {
        const bool is_usable = device.getInfo<CL_DEVICE_AVAILABLE>() != 0 &&
                               device.getInfo<CL_DEVICE_DOUBLE_FP_CONFIG>() != 0;
        if (is_usable) {
          devices.push_back(ComputeDevice(std::make_shared<Handle>(device)));
        }
      }
    } catch (const cl::Error&) {
      continue;  // a driver without a device
    }
  }
  std::stable_sort(devices.begin(), devices.end(), [](const auto& one, const auto& other) {
    return one.name().is_gpu && !other.name().is_gpu;
  });
  return devices;
}

cl::Program compiled_for(const ComputeDevice& device, std::string_view source) {
  ComputeDevice::Handle& handle = device.handle();
  const std::lock_guard lock(handle.mutex);
  if (handle.context() == nullptr) handle.context = cl::Context(handle.device);
  const auto found = handle.programs.find(source);
  if (found != handle.programs.end()) return found->second;
  cl::Program program(handle.context, std::string(source));
  try {
    program.build({handle.device}, "-cl-std=CL1.2");
  } catch (const cl::Error&) {
    throw std::runtime_error("its driver does not compile the program: " +
                             program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(handle.device));
  }
  handle.programs.emplace(source, program);
  return program;
}

std::shared_ptr<const Compute> first_compute(std::chrono::nanoseconds deadline) {
  const std::vector<ComputeDevice> devices = ComputeDevice::all();
  if (devices.empty()) {
    throw std::runtime_error(
        "this machine has no OpenCL device with double precision; install the OpenCL driver of its "
        "GPU, or compute on the processor");
  }
  return std::make_shared<Compute>(Compute{.device = devices.front(), .deadline = deadline});
}

std::string described(const ComputeDeviceName& name) {
  return name.device + " (" + name.platform + ", driver " + name.driver + ")";
}

}  // namespace asperity
