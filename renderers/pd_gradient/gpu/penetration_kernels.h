// Declares the source of the kernels, which the driver of a device compiles.

#pragma once

#include <string_view>

namespace asperity {

/// The text of faces.cl and penetration.cl.
extern const std::string_view kPenetrationKernels;

}  // namespace asperity
