// Runs each scene along its motion, on the processor and on the first compute device.

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
#include <thread>
#include <utility>

#include <glm/geometric.hpp>

#include "analysis/numbers/random.h"
#include "app/timing/hung_ticks.h"
#include "device/machine.h"
#include "device/simulated_device.h"
#include "device/virtual_hand.h"
#include "renderers/built_in_models.h"
#include "renderers/compute/compute_device.h"
#include "renderers/force/indentation_law.h"
#include "renderers/offline/point_strokes.h"
#include "renderers/offline/two_body_scenes.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "renderers/proxy/body_surface.h"
#include "renderers/servo/record_ring.h"
#include "renderers/servo/servo_loop.h"
#include "results_schema/error_text.h"
#include "stimuli/meshes/detailed_bodies.h"

namespace asperity {

namespace {

// Nobody holds a device: a tick may take as long as a driver without a GPU needs.
constexpr std::chrono::minutes kPatience{10};
constexpr const char* kGround = "block";  // under the meshes of the user
constexpr double kPressed_m = 0.0015;     // into the plane
constexpr double kFriction = 0.3;

/// The bumpy torus under the models of a point.
struct TorusScene {
  TimedScene scene{};
  std::uint32_t around = 0;
  std::uint32_t along = 0;
};
constexpr std::array kToruses{
    TorusScene{{"mesh_100k", "the same models, on a bumpy body of 100 488 facets"}, 316, 159},
    TorusScene{{"mesh_600k", "the same models, on a bumpy body of 601 400 facets"}, 775, 388}};

/// A tick that does not return.
struct HungTicks {
  TimedScene scene{};
  unsigned busy_threads_per_core = 0;
};
constexpr std::array kHungTicks{
    HungTicks{{"hung_tick",
               "from the call of a model that does not return to zero force, which another thread "
               "sets"},
              0},
    HungTicks{{"hung_tick_busy", "the same, with two more busy threads for each core"}, 2}};

TriangleMesh torus(const TorusScene& scene, std::optional<std::size_t> triangles) {
  if (!triangles) return bumpy_torus(scene.around, scene.along);
  const auto around = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(*triangles)));
  return bumpy_torus(around, static_cast<std::uint32_t>(*triangles / (2 * around)));
}

/// A tick by its number: the wrench on the hand.
using Tick = std::function<Wrench(int)>;

Tick along(const std::vector<ProbeState>& stroke, std::unique_ptr<ForceRenderer> made) {
  const std::shared_ptr<ForceRenderer> renderer = std::move(made);
  renderer->reset(stroke.front());
  return [renderer, &stroke](int tick) {
    return renderer->tick(stroke[static_cast<std::size_t>(tick)], kStrokeTick_s).wrench;
  };
}

/// A servo loop with a simulated device in a hand that strokes.
struct StrokingLoop {
  explicit StrokingLoop(std::unique_ptr<ForceRenderer> renderer) {
    loop.present({.id = 1, .renderer = std::move(renderer)});
    hand.stroke();
  }
  Wrench tick(int number) {
    loop.tick((static_cast<std::int64_t>(number) + 1) * std::llround(1e9 * kStrokeTick_s));
    loop.heartbeat();
    TickRecord record;
    records.pop(record);
    return record.sent;
  }

  VirtualHand hand{HandHabits{.lift_height_m = 0.001}, Random(2)};
  SimulatedDevice device{hand, SimulatedDeviceSettings{}};
  RecordRing records{};
  ServoLoop loop{device, records, ServoSettings{}};
};

/// The measurements of one order.
class Timing final {
 public:
  struct Scene {
    TimedScene named{};
    std::function<void(Timing&)> measure{};
  };
  static std::vector<Scene> scenes() {
    std::vector<Scene> all;
    for (const SceneBodies& each : two_body_scenes()) {
      all.push_back({{each.scene, each.meaning}, [&each](Timing& timing) {
                       const TimedBody tool = timing.bodies_.named(each.tool);
                       timing.time_two_bodies(std::string(each.scene), tool,
                                              timing.bodies_.named(each.surface));
                     }});
    }
    all.push_back(
        {{"plane", "the models of a point or a soft surface, on a plane"}, &Timing::time_plane});
    all.push_back({{"loop",
                    "the same models, on a plane: the whole tick of a session with a simulated "
                    "device"},
                   &Timing::time_loop});
    for (const TorusScene& each : kToruses) {
      all.push_back({each.scene, [&each](Timing& timing) { timing.time_torus(each); }});
    }
    for (const HungTicks& each : kHungTicks) {
      all.push_back({each.scene, [&each](Timing& timing) { timing.time_hung(each); }});
    }
    return all;
  }

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
    const std::vector<Scene> all = scenes();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Scene& each) { return each.named.name == name; });
    if (found == all.end()) {
      throw std::invalid_argument("there is no scene \"" + name +
                                  "\"; choose one of timed_scenes()");
    }
    found->measure(*this);
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
    const std::vector<ProbeState> stroke = stroke_on_plane(most_ticks(), -kPressed_m);
    begin("plane");
    time_points("plane", nullptr, std::bind_front(along, std::cref(stroke)));
  }

  void time_loop() {
    begin("loop");
    time_points("loop", nullptr, [](std::unique_ptr<ForceRenderer> renderer) -> Tick {
      const auto loop = std::make_shared<StrokingLoop>(std::move(renderer));
      return [loop](int tick) { return loop->tick(tick); };
    });
  }

  void time_torus(const TorusScene& scene) {
    const std::string name(scene.scene.name);
    begin(name);
    const auto surface = std::make_shared<const BodySurface>(torus(scene, order_.bodies.triangles));
    const std::vector<ProbeState> stroke = stroke_on_torus(most_ticks());
    time_points(name, surface, std::bind_front(along, std::cref(stroke)));
  }

  void time_hung(const HungTicks& scene) {
    const std::string name(scene.scene.name);
    begin(name);
    TimedRow row = new_row(name, "endless");
    row.has_rate = false;
    row.times = time_hung_ticks(
        order_.ticks,
        scene.busy_threads_per_core * std::max(1U, std::thread::hardware_concurrency()),
        course_.stop);
    add(std::move(row));
  }

  void time_points(const std::string& scene, const std::shared_ptr<const BodySurface>& body,
                   const std::function<Tick(std::unique_ptr<ForceRenderer>)>& ready) {
    const ModelRegistry registry = built_in_models();
    RendererInputs inputs = rough_plane(registry);
    inputs.material = {.stiffness_N_per_m = kSceneStiffness_N_per_m, .friction = kFriction};
    inputs.patch.extent_m = {1.0, 1.0};
    inputs.body = body;
    for (const ForceModel& model : registry.models()) {
      if (model.declaration.needs_bodies) continue;
      TimedRow row = new_row(scene, model.declaration.id);
      if (body) row.surface = TimedSize{body->facets(), body->facets()};
      time_row(row, [&] {
        if (has_tip(model, inputs)) row.quoted.reset();  // the figures are of a point
        return ready(make_renderer(model, inputs));
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
      row.reason = message_of(error);
    }
  }

  TimedRow new_row(const std::string& scene, const std::string& model) const {
    return {.scene = scene,
            .model = model,
            .device = machine(),
            .has_cold_caches = order_.ticks.evicted_bytes > 0,
            .quoted = quoted_time(scene)};
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
  for (const auto& each : Timing::scenes()) scenes.push_back(each.named);
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
