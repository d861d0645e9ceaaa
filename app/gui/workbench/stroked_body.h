// The body on which the point models of the workbench render the relief.

#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "renderers/proxy/body_surface.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

struct BodyChoice {
  std::string shape = "plane";   ///< one of `body_parameters`
  double diameter_m = 0.0;       ///< of the sphere, and of the cylinder, whose axis is along y
  std::filesystem::path mesh{};  ///< of the shape "mesh"

  bool operator==(const BodyChoice&) const = default;
};

/// The shape and the diameter, as the form declares them.
std::vector<Parameter> body_parameters();

/// A body whose highest point is in the middle of the relief, in its plane.
class StrokedBody final {
 public:
  explicit StrokedBody(BodyChoice choice) : choice_(std::move(choice)) {}
  const BodyChoice& choice() const noexcept { return choice_; }
  /// Null for the plane. Made when first asked for, which takes up to a second; from any thread, and then shared.
  ///
  /// Errors: std::invalid_argument if no file of a mesh is chosen; those of `load_textured_mesh`.
  std::shared_ptr<const BodySurface> surface();

 private:
  BodyChoice choice_{};
  std::once_flag made_{};
  std::shared_ptr<const BodySurface> surface_{};
};

}  // namespace asperity
