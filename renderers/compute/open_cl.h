// The OpenCL headers, with the settings of this folder. Errors are exceptions of the type cl::Error.

#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_TARGET_OPENCL_VERSION 120
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include <CL/opencl.hpp>

#include "renderers/compute/compute_device.h"

namespace asperity {

struct ComputeDevice::Handle {
  explicit Handle(const cl::Device& of_driver) : device(of_driver) {}

  cl::Device device;
  /// The programs that were compiled for this device, by their source: a driver takes a second for one.
  std::mutex mutex{};
  cl::Context context{};
  std::map<std::string, cl::Program, std::less<>> programs{};
};

/// A program for the device, compiled when it is first requested; on any thread. Throws cl::Error, and
/// std::runtime_error with the compiler's messages.
cl::Program compiled_for(const ComputeDevice& device, std::string_view source);

}  // namespace asperity
