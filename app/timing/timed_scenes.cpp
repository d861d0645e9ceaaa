#include "app/timing/timed_scenes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>

#include <glm/geometric.hpp>

#include "device/machine.h"
#include "renderers/built_in_models.h"
#include "renderers/compute/compute_device.h"
#include "renderers/force/indentation_law.h"
#include "renderers/offline/point_strokes.h"
#include "renderers/offline/two_body_scenes.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "renderers/proxy/body_surface.h"
#include "stimuli/meshes/detailed_bodies.h"

namespace asperity {

namespace {

// Nobody holds a device: a tick may take as long as a driver without a GPU needs.
constexpr std::chrono::minutes kPatience{10};
constexpr const char* kGround = "block";  // under the meshes of the user
constexpr const char* kPlane = "plane";
constexpr double kPressed_m = 0.0015;  // into the plane
constexpr double kFriction = 0.3;

/// The bumpy torus under the models of a point.
struct TorusScene {
  std::string_view name{};
  std::uint32_t around = 0;
  std::uint32_t along = 0;
};
constexpr std::array kToruses{TorusScene{"mesh_100k", 316, 159}, TorusScene{"mesh_600k", 775, 388}};

TriangleMesh torus(const TorusScene& scene, std::optional<std::size_t> triangles) {
  if (!triangles) return bumpy_torus(scene.around, scene.along);
  const auto around = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(*triangles)));
  return bumpy_torus(around, static_cast<std::uint32_t>(*triangles / (2 * around)));
}

/// The measurements of one order.
class Timing final {
 public:
  Timing(const TimingOrder& order, const TimingCourse& course)
      : order_(order), course_(course), bodies_(order.bodies, course) {}

  TimingOutcome run() {
    try {
      std::vector<TimedBody> given;
      for (const auto& file : order_.meshes) given.push_back(bodies_.of_file(file, order_.reading));
      for (const std::string& scene : order_.scenes) time_scene(scene);
      for (std::size_t i = 0; i < given.size(); ++i) {
        time_two_bodies(order_.meshes[i].filename().string(), given[i], bodies_.named(kGround));
      }
    } catch (const TimingStopped&) {
      outcome_.is_complete = false;
    }
    return std::move(outcome_);
  }

 private:
  void time_scene(const std::string& name) {
    if (name == kPlane) return time_plane();
    for (const TorusScene& each : kToruses) {
      if (each.name == name) return time_torus(each);
    }
    for (const SceneBodies& each : two_body_scenes()) {
      if (each.scene != name) continue;
      const TimedBody tool = bodies_.named(each.tool);
      return time_two_bodies(name, tool, bodies_.named(each.surface));
    }
    throw std::invalid_argument("there is no scene \"" + name + "\"; choose one of timed_scenes()");
  }

  void time_two_bodies(const std::string& name, const TimedBody& tool, const TimedBody& surface) {
    const TwoBodyScene scene = two_body_scene(name, tool.mesh, surface.mesh);
    begin(name);
    const std::optional<ProbeState> start = pressed_tool(scene);
    const std::vector<ComputeDevice> devices = ComputeDevice::all();
    for (const bool on_device : {false, true}) {
      TimedRow row = new_row(name, "pd_gradient");
      row.tool = TimedSize{tool.original_triangles, tool.mesh->triangles.size()};
      row.surface = TimedSize{surface.original_triangles, surface.mesh->triangles.size()};
      std::shared_ptr<const Compute> compute{};
      if (on_device) {
        row.place = EvaluatedOn::gpu;
        row.device.clear();
        if (!devices.empty()) {
          compute = std::make_shared<const Compute>(Compute{devices.front(), kPatience});
          row.device = described(compute->device.name());
          if (!compute->device.name().is_gpu) row.place = EvaluatedOn::opencl_cpu;
        } else {
          row.reason =
              "This computer has no OpenCL device with double precision; install the OpenCL driver "
              "of its GPU.";
        }
      }
      if (!start) row.reason = "The tool passes the surface without contact; use another mesh.";
      if (row.reason.empty()) {
        time_row(row, [&] { return ready_tool(scene, *start, compute); });
      }
      add(std::move(row));
    }
  }

  /// A tick by its number: the wrench on the hand.
  using Tick = std::function<Wrench(int)>;

  Tick ready_tool(const TwoBodyScene& scene, const ProbeState& start,
                  const std::shared_ptr<const Compute>& compute) const {
    std::shared_ptr<ForceRenderer> renderer =
        make_renderer(pd_gradient_model(compute), inputs_of(scene, {}));
    start_clear(*renderer, scene, start, order_.ticks.longest);
    return [renderer, scene, start](int tick) {
      return renderer->tick(moved_tool(scene, start, tick), kSceneTick_s).wrench;
    };
  }

  void time_plane() {
    begin(kPlane);
    time_points(kPlane, nullptr, stroke_on_plane(most_ticks(), -kPressed_m));
  }

  void time_torus(const TorusScene& scene) {
    const std::string name(scene.name);
    begin(name);
    const auto surface = std::make_shared<const BodySurface>(torus(scene, order_.bodies.triangles));
    time_points(name, surface, stroke_on_torus(most_ticks(), {}));
  }

  void time_points(const std::string& scene, const std::shared_ptr<const BodySurface>& body,
                   const std::vector<ProbeState>& stroke) {
    const ModelRegistry registry = built_in_models();
    RendererInputs inputs = rough_plane(registry);
    inputs.material = {.stiffness_N_per_m = kSceneStiffness_N_per_m, .friction = kFriction};
    inputs.patch.extent_m = {1.0, 1.0};
    inputs.body = body;
    for (const ForceModel& model : registry.models()) {
      if (model.declaration.needs_bodies) continue;
      TimedRow row = new_row(scene, model.declaration.id);
      if (body) row.surface = TimedSize{body->facets(), body->facets()};
      time_row(row, [&]() -> Tick {
        if (has_tip(model, inputs)) row.quoted.reset();  // the figures are of a point
        std::shared_ptr<ForceRenderer> renderer = make_renderer(model, inputs);
        renderer->reset(stroke.front());
        return [renderer, &stroke](int tick) {
          return renderer->tick(stroke[static_cast<std::size_t>(tick)], kStrokeTick_s).wrench;
        };
      });
      add(std::move(row));
    }
  }

  /// Whether a model has a tip of many cells. On a plane, because on a body the model is wrapped by a point model.
  static bool has_tip(const ForceModel& model, RendererInputs inputs) {
    inputs.body.reset();
    const auto on_plane = make_renderer(model, inputs);
    return dynamic_cast<const IndentationLaw*>(on_plane.get()) != nullptr;
  }

  /// `make` may refuse its inputs, and a driver may fail: the reason of the row.
  void time_row(TimedRow& row, const std::function<Tick()>& make) const {
    TickCount count = order_.ticks;
    if (row.place != EvaluatedOn::cpu) count.waits = TickCount::Waits::for_device;
    double largest_N = 0.0;
    try {
      const Tick tick = make();
      row.times = time_ticks(
          count, [&](int i) { largest_N = std::max(largest_N, glm::length(tick(i).force_N)); },
          course_.stop);
      row.largest_force_N = largest_N;
    } catch (const std::exception& error) {
      row.reason = error.what();
    }
  }

  TimedRow new_row(const std::string& scene, const std::string& model) const {
    return {.scene = scene, .model = model, .device = machine(), .quoted = quoted_time(scene)};
  }

  void begin(const std::string& scene) {
    if (course_.stop.stop_requested()) throw TimingStopped{};
    if (course_.begin_step) course_.begin_step("measuring " + scene);
    if (course_.progress) course_.progress(0.0);
  }

  /// An interrupted row is not complete.
  void add(TimedRow row) {
    if (course_.stop.stop_requested()) throw TimingStopped{};
    outcome_.rows.push_back(std::move(row));
  }

  std::size_t most_ticks() const {
    return static_cast<std::size_t>(order_.ticks.warm_up + order_.ticks.counted);
  }

  const TimingOrder& order_;
  const TimingCourse& course_;
  TimedBodies bodies_;
  TimingOutcome outcome_{};
};

}  // namespace

std::vector<TimedScene> timed_scenes() {
  std::vector<TimedScene> scenes;
  for (const SceneBodies& each : two_body_scenes()) scenes.push_back({each.scene, each.meaning});
  scenes.push_back({kPlane, "the models of a point or a soft surface, on a plane"});
  scenes.push_back({kToruses[0].name, "the same models, on a bumpy body of 100 488 facets"});
  scenes.push_back({kToruses[1].name, "the same models, on a bumpy body of 601 400 facets"});
  return scenes;
}

const char* name_of(EvaluatedOn place) noexcept {
  switch (place) {
    case EvaluatedOn::cpu:
      return "cpu";
    case EvaluatedOn::gpu:
      return "gpu";
    case EvaluatedOn::opencl_cpu:
      return "opencl_cpu";
  }
  return "";
}

TimingOutcome time_scenes(const TimingOrder& order, const TimingCourse& course) {
  return Timing(order, course).run();
}

}  // namespace asperity
