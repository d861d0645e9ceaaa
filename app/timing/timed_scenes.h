// Declares the measurement of ticks in the scenes of the command bench.

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/timing/quoted_time.h"
#include "app/timing/timed_bodies.h"
#include "renderers/offline/tick_times.h"
#include "stimuli/meshes/read_mesh.h"

namespace asperity {

/// A scene by its name.
struct TimedScene {
  std::string_view name{};
  std::string_view meaning{};
};

/// The scenes of two textured bodies (two_body_scenes.h); plane, loop, mesh_100k and mesh_600k for models of a point; hung_tick and
/// hung_tick_busy for a tick that does not return (hung_ticks.h).
std::vector<TimedScene> timed_scenes();

struct TimingOrder {
  std::vector<std::string> scenes{};            ///< names of `timed_scenes`
  std::vector<std::filesystem::path> meshes{};  ///< of the user, each against the block
  MeshReading reading{};                        ///< of the meshes
  TimedBodiesOrder bodies{};
  TickCount ticks{};
};

/// What evaluated the contacts.
enum class EvaluatedOn { cpu, gpu, opencl_cpu };
/// "cpu", "gpu", "opencl_cpu"
const char* name_of(EvaluatedOn place) noexcept;

/// The triangles of a body.
struct TimedSize {
  std::size_t original = 0;
  std::size_t simplified = 0;
};

/// One measurement. A tick is complete: from the position of the hand to the force, in `loop` from reading the device to the record.
struct TimedRow {
  std::string scene{};
  std::string model{};
  EvaluatedOn place = EvaluatedOn::cpu;
  std::string device{};          ///< the processor, or the OpenCL device with its driver
  bool has_cold_caches = false;  ///< other data replaced those of the tick before each tick
  TickTimes times{};
  bool has_rate = true;  ///< its times limit the rate of a loop
  std::optional<double> largest_force_N{};
  std::optional<TimedSize> tool{};
  std::optional<TimedSize> surface{};
  std::string reason{};  ///< why there are no times; empty if there are
  std::optional<QuotedTime> quoted{};
};

struct TimingOutcome {
  std::vector<TimedRow> rows{};
  bool is_complete = true;  ///< false after a requested stop; `rows` are those until then
};

/// Measures in this thread, scene by scene: in a scene of two bodies `pd_gradient` with its defaults on the processor and on the first
/// OpenCL device, in the scenes of points every built-in model of a point. What cannot run is a row with the reason.
///
/// The files of all meshes are read before the first measurement. Errors: ResultsError or std::invalid_argument naming the file;
/// std::invalid_argument for an unknown scene.
TimingOutcome time_scenes(const TimingOrder& order, const TimingCourse& course);

}  // namespace asperity
