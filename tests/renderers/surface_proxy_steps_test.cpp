// Steps of the force of a proxy: there are none at the edges of facets.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderers/proxy/surface_proxy.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/proxy_paths.h"

namespace asperity {
namespace {

constexpr double kSteps_N_per_m = 1000.0;
constexpr double kProxyStep_m = 1e-6;

struct GreatestChanges {
  double force_N = 0.0;  ///< of the vector
  double beyond_N =
      0.0;  ///< of its size, less that of a spring that is pressed by the whole motion
};

GreatestChanges greatest_changes(const std::shared_ptr<const BodySurface>& surface,
                                 double depth_m) {
  constexpr int kStrokes = 12;
  constexpr std::size_t kTicks = 10'000;
  GreatestChanges greatest{};
  for (int stroke = 0; stroke < kStrokes; ++stroke) {
    SurfaceProxy proxy(surface);
    std::optional<ProxyPlace> last{};
    glm::dvec3 last_m{0.0};
    for (const glm::dvec3& probe_m :
         stroke_in_torus_m(depth_m, kProxyStep_m, kTicks, 0.9 * stroke)) {
      const auto place = proxy.follow(probe_m);
      if (last) {
        greatest.force_N = std::max(greatest.force_N,
                                    kSteps_N_per_m * glm::distance(place->height_m * place->normal,
                                                                   last->height_m * last->normal));
        greatest.beyond_N = std::max(greatest.beyond_N,
                                     kSteps_N_per_m * (std::abs(place->height_m - last->height_m) -
                                                       glm::distance(probe_m, last_m)));
      }
      last = place;
      last_m = probe_m;
    }
  }
  return greatest;
}

TEST(SurfaceProxySteps, TheForceOfASmoothBodyHasNone) {
  struct SmoothBody {
    std::uint32_t around = 0;
    std::uint32_t along = 0;
    double depth_m = 0.0;
    double force_N = 0.0;
  };
  for (const SmoothBody& each :
       {SmoothBody{316, 159, 0.001, 0.0003}, SmoothBody{316, 159, 0.003, 0.0008},
        SmoothBody{100, 50, 0.001, 0.0003}, SmoothBody{100, 50, 0.003, 0.0008}}) {
    const auto surface = std::make_shared<const BodySurface>(bumpy_torus(each.around, each.along));
    const GreatestChanges greatest = greatest_changes(surface, each.depth_m);
    EXPECT_LT(greatest.force_N, each.force_N) << each.around << " at " << each.depth_m;
    EXPECT_LT(greatest.beyond_N, 1e-6) << each.around << " at " << each.depth_m;
  }
}

}  // namespace
}  // namespace asperity
