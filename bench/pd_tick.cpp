// What a whole tick of two textured bodies costs, from poses to the wrench, and how far it is from
// the bodies they were made of.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <thread>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <malloc.h>
#include <nlohmann/json.hpp>

#include "device/machine.h"
#include "renderers/offline/tick_times.h"
#include "renderers/offline/two_body_scenes.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "stimuli/meshes/detailed_bodies.h"
#include "stimuli/meshes/mesh_decimation.h"
#include "stimuli/meshes/mesh_file.h"
#include "stimuli/meshes/mesh_repair.h"
#include "stimuli/meshes/texture_baking.h"

namespace asperity {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kWave_m = 1e-3;  // the shortest of all textures
constexpr int kWarmUp = 500;
constexpr int kCounted = 5'000;
constexpr int kPosesForErrors = 8;
constexpr std::size_t kContactsForErrors = 3;  // of a pose, the longest
constexpr int kTruthSamples = 256;             // at least, and twice those of the window

double peak_MiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double seconds_since(Clock::time_point started) {
  return std::chrono::duration<double>(Clock::now() - started).count();
}

TickTimes measure(int rounds, const RepeatedTicks& motion) {
  return shortest_of_ticks({.warm_up = kWarmUp, .counted = kCounted}, rounds, motion);
}

nlohmann::json quantile_ns(const TickTimes& times, double fraction) {
  const auto time_ns = times.quantile_ns(fraction);
  return time_ns ? nlohmann::json(*time_ns) : nlohmann::json(nullptr);
}

/// A body, what it was made of, and what that took.
struct Body {
  std::string name{};
  TriangleMesh original{};
  std::shared_ptr<const TexturedMesh> textured{};
  nlohmann::ordered_json made{};
  bool is_given = false;
};

/// As a file holds it: what importing costs is part of baking.
std::vector<std::byte> binary_stl(const TriangleMesh& mesh) {
  std::vector<std::byte> bytes(84 + 50 * mesh.triangles.size());
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  std::memcpy(bytes.data() + 80, &count, sizeof(count));
  std::byte* to = bytes.data() + 84;
  for (const auto& corners : mesh.triangles) {
    to += 12;  // no normal
    for (const std::uint32_t corner : corners) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto place_mm = static_cast<float>(1e3 * mesh.vertices_m[corner][axis]);
        std::memcpy(to, &place_mm, sizeof(place_mm));
        to += sizeof(place_mm);
      }
    }
    to += 2;
  }
  return bytes;
}

Body bake(const std::string& name, const std::vector<std::byte>& file, std::size_t triangles) {
  const Workers workers{.jobs = std::max(1U, std::thread::hardware_concurrency())};
  const auto started = Clock::now();
  const std::clock_t processor = std::clock();
  Body body{.name = name};
  body.original = repair_mesh(decode_mesh(file, {}, name).mesh, {}, name).mesh;
  const double imported_s = seconds_since(started);
  const TriangleMesh simplified = decimate_mesh(body.original, triangles, name, workers).mesh;
  const double simplified_s = seconds_since(started);
  BakedMesh baked = bake_texture(body.original, simplified, {}, workers);
  const double all_s = seconds_since(started);
  body.made = {{"name", name},
               {"original_triangles", body.original.triangles.size()},
               {"triangles", baked.mesh.triangles.size()},
               {"texels", baked.mesh.atlas.values.size()},
               {"import_s", imported_s},
               {"simplify_s", simplified_s - imported_s},
               {"bake_s", all_s - simplified_s},
               {"all_s", all_s},
               {"processor_s", static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC},
               {"peak_memory_MiB", peak_MiB()},
               {"plain_rms_m", baked.report.plain.rms_m},
               {"textured_rms_m", baked.report.textured.rms_m}};
  body.textured = std::make_shared<const TexturedMesh>(std::move(baked.mesh));
  return body;
}

Body bake(const std::string& name, const TriangleMesh& mesh, std::size_t triangles) {
  return bake(name, binary_stl(mesh), triangles);
}

/// A scene with the bodies before they were baked.
struct BakedScene {
  TwoBodyScene scene{};
  const Body* tool = nullptr;
  const Body* surface = nullptr;
};

/// The tool where it begins; an error names a scene without contact.
ProbeState pressed(const TwoBodyScene& scene) {
  const auto start = pressed_tool(scene);
  if (!start) throw std::runtime_error(scene.name + ": the tool does not touch the surface.");
  return *start;
}

ParameterValues sampled_by(double cell_m) { return {{"cell_m", cell_m}, {"step_m", cell_m}}; }

/// Sums over the contacts of many poses.
struct Errors {
  double depth_m2 = 0.0;
  double force_N2 = 0.0;
  double torque_N2_m2 = 0.0;

  void add(const Penetration& found, const Penetration& truth) {
    const Wrench one = contact_wrench(found, {}, kSceneStiffness_N_per_m);
    const Wrench other = contact_wrench(truth, {}, kSceneStiffness_N_per_m);
    const auto square = [](const glm::dvec3& v) { return glm::dot(v, v); };
    const double depth_m = std::max(0.0, found.depth_m) - std::max(0.0, truth.depth_m);
    depth_m2 += depth_m * depth_m;
    force_N2 += square(one.force_N - other.force_N);
    torque_N2_m2 += square(one.torque_N_m - other.torque_N_m);
  }
  nlohmann::ordered_json rms(double count) const {
    return {{"depth_m", std::sqrt(depth_m2 / count)},
            {"force_N", std::sqrt(force_N2 / count)},
            {"torque_N_m", std::sqrt(torque_N2_m2 / count)}};
  }
};

/// A mesh without texture, and which of its triangles are near a contact.
struct PlainPatch {
  TexturedMesh mesh{};
  std::vector<std::uint32_t> triangles{};

  explicit PlainPatch(const TriangleMesh& of) {
    mesh.vertices_m = of.vertices_m;
    mesh.normals.assign(of.vertices_m.size(), {0.0, 0.0, 1.0});  // moved along by nothing
    mesh.triangles = of.triangles;
    mesh.places.assign(of.triangles.size(), {});
    mesh.atlas = {.rows = 1, .columns = 1, .step_m = 0.0, .values = {0}};
  }
  ContactPatch near(const Pose& pose, const ContactFrame& frame, double width_m) {
    const glm::dvec3 origin_m = glm::transpose(pose.rotation) * (frame.origin_m - pose.position_m);
    triangles.clear();
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      double nearest_m = 1.0;
      double size_m = 0.0;
      const auto& corners = mesh.triangles[i];
      for (const std::uint32_t corner : corners) {
        nearest_m = std::min(nearest_m, glm::distance(mesh.vertices_m[corner], origin_m));
        size_m =
            std::max(size_m, glm::distance(mesh.vertices_m[corner], mesh.vertices_m[corners[0]]));
      }
      if (nearest_m < width_m + size_m) triangles.push_back(i);
    }
    return {.mesh = mesh, .triangles = triangles, .pose = pose};
  }
};

TriangleMesh without_texture(const TexturedMesh& mesh) {
  return {.vertices_m = mesh.vertices_m, .triangles = mesh.triangles};
}

/// Against the original meshes in the same windows, along the same n.
nlohmann::ordered_json errors_of(const BakedScene& baked, double cell_m) {
  const TwoBodyScene& scene = baked.scene;
  ParameterValues parameters = sampled_by(cell_m);
  parameters["most_samples"] = 512.0;  // no contact is wide enough for longer cells
  parameters["coupling"] = std::string("none");
  PdGradient renderer(
      [&] {
        RendererInputs inputs = inputs_of(scene, parameters);
        inputs.parameters = complete_values(pd_gradient_model().declaration, inputs.parameters);
        return inputs;
      }(),
      instruction_sets_here().back());
  PlainPatch tool(baked.tool->original);
  PlainPatch surface(baked.surface->original);
  PlainPatch plain_tool(without_texture(*scene.tool));
  PlainPatch plain_surface(without_texture(*scene.surface));
  const ProbeState start = pressed(scene);
  renderer.reset(start);
  Errors textured;
  Errors plain;
  Errors whole;
  int contacts = 0;
  for (int i = 0; i < kPosesForErrors; ++i) {
    const ProbeState probe = moved_tool(scene, start, 137 * i);
    for (int again = 0; again < 40; ++again) renderer.tick(probe, kSceneTick_s);
    const Pose a{.rotation = glm::mat3_cast(probe.orientation), .position_m = probe.position_m};
    const auto found = renderer.contacts();
    for (const TexturedContact& contact : found.first(std::min(found.size(), kContactsForErrors))) {
      if (contact.is_fading) continue;  // it has a depth of earlier ticks
      const double step_m = cell_m;
      const auto reference = [&](PlainPatch& of_a, PlainPatch& of_b) {
        return reference_penetration(of_a.near(a, contact.frame, contact.grid.width_m),
                                     of_b.near({}, contact.frame, contact.grid.width_m),
                                     contact.frame,
                                     {.width_m = contact.grid.width_m,
                                      .samples = std::max(kTruthSamples, 2 * contact.grid.samples)},
                                     HardMaximum{.step_m = step_m});
      };
      const auto truth = reference(tool, surface);
      const auto bare = reference(plain_tool, plain_surface);
      if (!truth || !bare) continue;
      textured.add(contact.penetration, *truth);
      plain.add(*bare, *truth);
      whole.add({}, *truth);
      ++contacts;
    }
  }
  return {{"contacts", contacts},
          {"truth", whole.rms(contacts)},
          {"textured", textured.rms(contacts)},
          {"untextured", plain.rms(contacts)},
          {"depth", std::sqrt(textured.depth_m2 / plain.depth_m2)},
          {"force", std::sqrt(textured.force_N2 / plain.force_N2)},
          {"torque", std::sqrt(textured.torque_N2_m2 / plain.torque_N2_m2)}};
}

std::size_t allocated_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

/// Where the tool's mesh is while the device is there: without a coupling they are the same.
Pose pose_of(const ProbeState& probe) {
  return {.rotation = glm::mat3_cast(probe.orientation), .position_m = probe.position_m};
}

/// What the numbers of a case are of.
struct Load {
  double contacts = 0.0;
  double pairs = 0.0;
  double samples = 0.0;   ///< of the widest window, each way
  double blending = 0.0;  ///< in what part of the ticks a contact rises or fades
  double kept = 0.0;      ///< or goes on although nothing is cut
};

Load load_of(const TwoBodyScene& scene, const ProbeState& start, double cell_m) {
  const TexturedBody a(*scene.tool, 1.0);
  const TexturedBody b(*scene.surface, 1.0);
  MeshQuery query(a.hull_clusters(), b.hull_clusters(), TexturedContacts::kMostPairs);
  TexturedContacts contacts({*scene.tool, 1.0}, {*scene.surface, 1.0},
                            {.law = HardMaximum{.step_m = cell_m}, .cell_m = cell_m},
                            instruction_sets_here().back());
  Load load;
  for (int tick = kWarmUp; tick < kWarmUp + kCounted; ++tick) {
    const Pose pose = pose_of(moved_tool(scene, start, tick));
    const auto found = contacts.find(pose, {}, kSceneTick_s);
    load.contacts += static_cast<double>(found.size()) / kCounted;
    load.pairs += static_cast<double>(query.find(pose).size()) / kCounted;
    bool is_blending = false;
    bool is_kept = false;
    for (const TexturedContact& contact : found) {
      load.samples = std::max(load.samples, static_cast<double>(contact.grid.samples));
      is_blending = is_blending || contact.share < 1.0;
      is_kept = is_kept || contact.is_kept;
    }
    load.blending += is_blending ? 1.0 / kCounted : 0.0;
    load.kept += is_kept ? 1.0 / kCounted : 0.0;
  }
  return load;
}

nlohmann::ordered_json case_of(const std::string& name, const TickTimes& times, const Load& load) {
  return {{"name", name},
          {"unit", "ns"},
          {"p50", quantile_ns(times, 0.5)},
          {"p99", quantile_ns(times, 0.99)},
          {"p99_9", quantile_ns(times, 0.999)},
          {"longest", quantile_ns(times, 1.0)},
          {"over_5_medians", times.longer_than_medians(5.0)},
          {"count", times.undisturbed_ns.size()},
          {"preempted", times.preempted},
          {"contacts", load.contacts},
          {"pairs", load.pairs},
          {"blending", load.blending},
          {"kept", load.kept},
          {"window_samples", load.samples}};
}

/// The parts and the whole, over the same motion.
void time_scene(const TwoBodyScene& scene, int rounds, nlohmann::ordered_json& cases,
                double& used) {
  const ProbeState start = pressed(scene);
  const InstructionSet widest = instruction_sets_here().back();
  const TexturedBody a(*scene.tool, 1.0);
  const TexturedBody b(*scene.surface, 1.0);
  MeshQuery query(a.hull_clusters(), b.hull_clusters(), TexturedContacts::kMostPairs);
  ContactRegions regions(a.hull(), b.hull(), TexturedContacts::kMostPairs, kMostContacts);
  const Load at_8 = load_of(scene, start, kWave_m / 8.0);
  const auto add_case = [&](const std::string& name, const Load& load,
                            const RepeatedTicks& motion) {
    cases.push_back(case_of(name, measure(rounds, motion), load));
  };
  add_case(scene.name + "/query", at_8,
           {.restart = [] {},
            .tick =
                [&](int tick) {
                  used += static_cast<double>(
                      query.find(pose_of(moved_tool(scene, start, tick))).size());
                }});
  add_case(scene.name + "/query_and_regions", at_8,
           {.restart = [&] { regions.reset(); },
            .tick =
                [&](int tick) {
                  const Pose pose = pose_of(moved_tool(scene, start, tick));
                  used += static_cast<double>(regions.update(query.find(pose), pose, {}).size());
                }});
  struct Grid {
    const char* name = "";
    double cell_m = 0.0;
  };
  for (const Grid& grid :
       {Grid{"8", kWave_m / 8.0}, Grid{"12", kWave_m / 12.0}, Grid{"32", kWave_m / 32.0}}) {
    if (at_8.contacts > 1.5 && grid.cell_m < kWave_m / 12.0) continue;  // of one contact only
    const Load load = load_of(scene, start, grid.cell_m);
    const std::string at = scene.name + "/" + grid.name + "_samples_a_wave/";
    for (const Heights heights : {Heights::sampled, Heights::kept}) {
      TexturedContacts contacts(
          {*scene.tool, 1.0}, {*scene.surface, 1.0},
          {.law = HardMaximum{.step_m = grid.cell_m}, .cell_m = grid.cell_m, .heights = heights},
          widest);
      const char* name = heights == Heights::kept ? "contacts_kept" : "contacts_sampled";
      add_case(at + name, load,
               {.restart = [&] { contacts.reset(); },
                .tick =
                    [&](int tick) {
                      const Pose pose = pose_of(moved_tool(scene, start, tick));
                      for (const TexturedContact& contact : contacts.find(pose, {}, kSceneTick_s)) {
                        used += contact.penetration.depth_m;
                      }
                    }});
    }
    const auto add_tick = [&](const std::string& name, const ParameterValues& parameters) {
      const std::size_t before_bytes = allocated_bytes();
      const auto renderer = make_renderer(pd_gradient_model(), inputs_of(scene, parameters));
      const std::size_t bytes = allocated_bytes() - before_bytes;
      add_case(
          at + name, load,
          {.restart = [&] { start_clear(*renderer, scene, start); },
           .tick =
               [&](int tick) {
                 used +=
                     renderer->tick(moved_tool(scene, start, tick), kSceneTick_s).wrench.force_N.z;
               }});
      cases.back()["bytes"] = bytes;
    };
    for (const char* maximum : {"hard", "smooth"}) {
      for (const char* coupling : {"none", "virtual"}) {
        ParameterValues parameters = sampled_by(grid.cell_m);
        parameters["coupling"] = std::string(coupling);
        parameters["maximum"] = std::string(maximum);
        add_tick(std::string("tick_") + maximum + "_coupling_" + coupling, parameters);
      }
    }
    ParameterValues refined = sampled_by(grid.cell_m);
    refined["most_halvings"] = 2.0;
    add_tick("tick_refined_coupling_virtual", refined);
  }
}

std::vector<std::byte> bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(file.string() + " cannot be read.");
  std::vector<std::byte> bytes(std::filesystem::file_size(file));
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

struct Order {
  bool as_json = false;
  bool with_errors = true;
  int rounds = 1;
  std::size_t triangles = 300'000;
  std::optional<std::string> only{};  ///< a scene
  std::optional<std::filesystem::path> meshes{};
};

/// What bodies that are given are drawn over.
constexpr const char* kGround = "block";

bool is_wanted(const Order& order, std::string_view body) {
  if (order.meshes && body == kGround) return true;
  const auto scenes = two_body_scenes();
  return !order.only || std::any_of(scenes.begin(), scenes.end(), [&](const SceneBodies& each) {
    return *order.only == each.scene && (body == each.tool || body == each.surface);
  });
}

/// As in docs/performance.md.
std::size_t simplified_to(const DetailedBody& body) {
  if (body.name == "hammer") return 700;
  if (body.name == "file") return 600;
  return body.name == "part" ? 750 : body.simplified;
}

/// The bodies of all scenes. By pointer: scenes refer to them.
std::vector<std::unique_ptr<const Body>> make_bodies(const Order& order) {
  std::vector<std::unique_ptr<const Body>> bodies;
  for (const DetailedBody& each : detailed_bodies()) {
    if (!is_wanted(order, each.name)) continue;
    bodies.push_back(std::make_unique<const Body>(
        bake(std::string(each.name), make_detailed_body(each.name, order.triangles),
             simplified_to(each))));
    std::fprintf(stderr, "%s\n", bodies.back()->made.dump().c_str());
  }
  std::vector<std::filesystem::path> files;
  if (order.meshes) {
    for (const auto& file : std::filesystem::directory_iterator(*order.meshes)) {
      if (file.is_regular_file()) files.push_back(file.path());
    }
    std::sort(files.begin(), files.end());
  }
  for (const std::filesystem::path& file : files) {
    try {
      Body body = bake("given_" + file.stem().string(), bytes_of(file), 700);
      body.is_given = true;
      bodies.push_back(std::make_unique<const Body>(std::move(body)));
      std::fprintf(stderr, "%s\n", bodies.back()->made.dump().c_str());
    } catch (const std::exception& error) {  // one file of many
      std::fprintf(stderr, "left out: %s\n", error.what());
    }
  }
  return bodies;
}

std::vector<BakedScene> scenes_of(const std::vector<std::unique_ptr<const Body>>& bodies) {
  const auto body = [&](std::string_view name) {
    for (const auto& each : bodies) {
      if (each->name == name) return each.get();
    }
    return static_cast<const Body*>(nullptr);
  };
  std::vector<BakedScene> scenes;
  const auto add = [&scenes](std::string_view name, const Body* tool, const Body* surface) {
    if (tool == nullptr || surface == nullptr) return;
    scenes.push_back({.scene = two_body_scene(std::string(name), tool->textured, surface->textured),
                      .tool = tool,
                      .surface = surface});
  };
  for (const SceneBodies& each : two_body_scenes()) {
    add(each.scene, body(each.tool), body(each.surface));
  }
  for (const auto& each : bodies) {
    if (each->is_given) add(each->name, each.get(), body(kGround));
  }
  return scenes;
}

void print(const nlohmann::ordered_json& document) {
  for (const auto& body : document["bodies"]) {
    std::printf("%-14s %7ld -> %4ld triangles, import %.1f s, simplify %.1f s, bake %.1f s\n",
                body["name"].get<std::string>().c_str(), body["original_triangles"].get<long>(),
                body["triangles"].get<long>(), body["import_s"].get<double>(),
                body["simplify_s"].get<double>(), body["bake_s"].get<double>());
  }
  std::printf("%-64s %8s %8s %8s %8s %9s %9s %6s %6s %4s\n", "case (ns)", "p50", "p99", "p99.9",
              "longest", "5 medians", "preempted", "cont.", "pairs", "N");
  for (const auto& each : document["cases"]) {
    std::printf("%-64s %8s %8s %8s %8s %9ld %9ld %6.1f %6.1f %4.0f\n",
                each["name"].get<std::string>().c_str(), each["p50"].dump().c_str(),
                each["p99"].dump().c_str(), each["p99_9"].dump().c_str(),
                each["longest"].dump().c_str(), each["over_5_medians"].get<long>(),
                each["preempted"].get<long>(), each["contacts"].get<double>(),
                each["pairs"].get<double>(), each["window_samples"].get<double>());
  }
  for (const auto& each : document["errors"]) std::printf("%s\n", each.dump().c_str());
}

int run(const Order& order) {
  const auto bodies = make_bodies(order);
  double used = 0.0;  // so that no work can be left out
  nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                  {"machine", machine()},
                                  {"commit", ASPERITY_COMMIT},
                                  {"isa", name_of(instruction_sets_here().back())},
                                  {"bodies", nlohmann::ordered_json::array()},
                                  {"cases", nlohmann::ordered_json::array()},
                                  {"errors", nlohmann::ordered_json::array()}};
  for (const auto& body : bodies) document["bodies"].push_back(body->made);
  for (const BakedScene& baked : scenes_of(bodies)) {
    const TwoBodyScene& scene = baked.scene;
    std::fprintf(stderr, "%s\n", scene.name.c_str());
    time_scene(scene, order.rounds, document["cases"], used);
    if (!order.with_errors || scene.motion.in_m > 0.0)
      continue;  // there is no truth for the buried
    nlohmann::ordered_json errors{{"scene", scene.name}};
    errors.update(errors_of(baked, kWave_m / 12.0));
    document["errors"].push_back(errors);
  }
  document["peak_memory_MiB"] = peak_MiB();
  if (order.as_json) {
    std::puts(document.dump(2).c_str());
  } else {
    print(document);
  }
  return std::isfinite(used) ? 0 : 1;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  asperity::Order order;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--json") {
      order.as_json = true;
    } else if (argument == "--no-errors") {
      order.with_errors = false;
    } else if (argument == "--triangles" && i + 1 < argc) {
      order.triangles = static_cast<std::size_t>(std::atol(argv[++i]));
    } else if (argument == "--rounds" && i + 1 < argc) {
      order.rounds = std::max(1, std::atoi(argv[++i]));
    } else if (argument == "--scene" && i + 1 < argc) {
      order.only = argv[++i];
    } else if (argument == "--meshes" && i + 1 < argc) {
      order.meshes = argv[++i];
    } else {
      std::fprintf(stderr,
                   "usage: %s [--json] [--no-errors] [--triangles N] [--scene NAME] [--meshes DIR] "
                   "[--rounds N]\n",
                   argv[0]);
      return 2;
    }
  }
  try {
    return asperity::run(order);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
