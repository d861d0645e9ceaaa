// What the contacts of a tick cost on a compute device and on the processor, by window and number of contacts.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "device/machine.h"
#include "renderers/pd_gradient/gpu/gpu_penetration.h"
#include "renderers/pd_gradient/sampling/cached_penetration.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "tests/renderers/pd_gradient_surfaces.h"

namespace asperity {
namespace {

constexpr double kDepth_m = 0.1e-3;
constexpr HardMaximum kStep{.step_m = ContactsByChance::kShortest_m / 8.0};
constexpr std::chrono::minutes kPatience{10};

struct Times {
  std::string name{};
  std::vector<double> us{};

  double quantile(double fraction) const {
    return us[static_cast<std::size_t>(
        std::llround(fraction * static_cast<double>(us.size() - 1)))];
  }
};

template <typename Work>
Times measured(std::string name, int ticks, const Work& work) {
  Times times{.name = std::move(name)};
  for (int tick = -ticks / 10 - 1; tick < ticks; ++tick) {
    const auto started = std::chrono::steady_clock::now();
    work(tick);
    const std::chrono::duration<double, std::micro> took =
        std::chrono::steady_clock::now() - started;
    if (tick >= 0) times.us.push_back(took.count());
  }
  std::sort(times.us.begin(), times.us.end());
  return times;
}

// One contact, pressed in, evaluated at many places at once: each a little further along the slide.
class Slide final {
 public:
  explicit Slide(int samples) : grid_{.width_m = ContactsByChance::kWindow_m, .samples = samples} {
    contact_ = ContactsByChance(1).draw(ContactKind::convex_on_flat);
    const auto found = reference_penetration(contact_.a(), contact_.b(), {}, grid_, kStep);
    contact_.pose_a.position_m.z -= kDepth_m - found->depth_m;
  }

  const ChanceContact& contact() const { return contact_; }
  const SamplingGrid& grid() const { return grid_; }

  Pose pose_a(int tick, int place) const {
    Pose pose = contact_.pose_a;
    const double phase_rad = 0.02 * tick + 0.6 * place;
    pose.position_m.x += 0.5e-3 * std::sin(phase_rad);
    pose.position_m.y += 0.3e-3 * std::sin(0.137 * phase_rad);
    return pose;
  }

 private:
  ChanceContact contact_{};
  SamplingGrid grid_{};
};

Times on_device(const Slide& slide, const ComputeDevice& device, int contacts, int ticks) {
  const ChanceContact& contact = slide.contact();
  const auto count = static_cast<std::size_t>(contacts);
  GpuPenetration gpu(device, contact.mesh_a, 1.0, contact.mesh_b, 1.0,
                     {.contacts = count, .samples = slide.grid().samples});
  std::vector<GpuContact> asked(count);
  std::vector<std::optional<Penetration>> answers(count);
  return measured("device", ticks, [&](int tick) {
    for (int i = 0; i < contacts; ++i) {
      asked[static_cast<std::size_t>(i)] = {.grid = slide.grid(),
                                            .law = kStep,
                                            .pose_a = slide.pose_a(tick, i),
                                            .pose_b = contact.pose_b,
                                            .triangles_a = contact.triangles_a,
                                            .triangles_b = contact.triangles_b};
    }
    if (gpu.evaluate(asked, answers, kPatience) != GpuOutcome::answered) {
      throw std::runtime_error("the device did not answer");
    }
  });
}

template <typename Evaluation>
Times on_processor(std::string name, const Slide& slide, int contacts, int ticks,
                   const Evaluation& evaluation) {
  return measured(std::move(name), ticks, [&](int tick) {
    for (int i = 0; i < contacts; ++i) evaluation(slide.pose_a(tick, i), i);
  });
}

std::vector<Times> compared(const ComputeDevice& device, int samples, int contacts, int ticks) {
  const Slide slide(samples);
  const ChanceContact& contact = slide.contact();
  const PackedSurface a(contact.mesh_a);
  const PackedSurface b(contact.mesh_b);
  const SamplerSettings settings{
      .grid = slide.grid(),
      .law = kStep,
      .most_triangles = std::max(a.triangles().size(), b.triangles().size()),
      .instructions = instruction_sets_here().back()};
  PenetrationSampler sampler(settings);
  std::vector<CachedPenetration> cached(static_cast<std::size_t>(contacts),
                                        CachedPenetration({.sampler = settings}));
  double used = 0.0;
  const auto with = [&](auto& evaluation, const Pose& pose) {
    const auto found = evaluation.evaluate(
        {.surface = a, .triangles = contact.triangles_a, .pose = pose},
        {.surface = b, .triangles = contact.triangles_b, .pose = contact.pose_b}, {});
    if (found) used += found->depth_m;
  };
  std::vector<Times> all;
  all.push_back(on_device(slide, device, contacts, ticks));
  all.push_back(on_processor("sampler", slide, contacts, ticks,
                             [&](const Pose& pose, int) { with(sampler, pose); }));
  all.push_back(on_processor("kept_heights", slide, contacts, ticks, [&](const Pose& pose, int i) {
    with(cached[static_cast<std::size_t>(i)], pose);
  }));
  all.push_back(on_processor("reference", slide, contacts, 3, [&](const Pose& pose, int) {
    ChanceContact moved = contact;
    moved.pose_a = pose;
    used += reference_penetration(moved.a(), moved.b(), {}, slide.grid(), kStep)->depth_m;
  }));
  for (Times& times : all) {
    times.name = std::to_string(samples) + "/" + std::to_string(contacts) + "/" + times.name;
  }
  if (!std::isfinite(used)) throw std::runtime_error("a depth is not finite");
  return all;
}

int run(int ticks, int most_samples, bool as_json) {
  const std::vector<ComputeDevice> devices = ComputeDevice::all();
  if (devices.empty()) {
    std::fputs("bench_gpu_contacts: this machine has no OpenCL device with double precision.\n",
               stderr);
    return 1;
  }
  const ComputeDevice& device = devices.front();
  nlohmann::ordered_json document{{"format", "asperity.bench/1"},
                                  {"machine", machine()},
                                  {"device", described(device.name())},
                                  {"commit", ASPERITY_COMMIT},
                                  {"cases", nlohmann::ordered_json::array()}};
  if (!as_json) {
    std::printf("%s\n%s\n%-28s %10s %10s %8s\n", machine().c_str(),
                described(device.name()).c_str(), "window/contacts/where (us)", "p50", "p99",
                "ticks");
  }
  for (int samples = 64; samples <= most_samples; samples *= 2) {
    for (const int contacts : {1, 2, 5, 10}) {
      for (const Times& times : compared(device, samples, contacts, ticks)) {
        document["cases"].push_back({{"name", times.name},
                                     {"unit", "us"},
                                     {"p50", times.quantile(0.5)},
                                     {"p99", times.quantile(0.99)},
                                     {"count", times.us.size()}});
        if (!as_json) {
          std::printf("%-28s %10.1f %10.1f %8zu\n", times.name.c_str(), times.quantile(0.5),
                      times.quantile(0.99), times.us.size());
        }
      }
    }
  }
  if (as_json) std::puts(document.dump(2).c_str());
  return 0;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  int ticks = 1000;
  int most_samples = 512;
  bool as_json = false;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--json") == 0) {
      as_json = true;
    } else if (std::strcmp(argv[i], "--ticks") == 0 && i + 1 < argc) {
      ticks = std::atoi(argv[++i]);
    } else if (std::strcmp(argv[i], "--most-samples") == 0 && i + 1 < argc) {
      most_samples = std::atoi(argv[++i]);
    } else {
      std::fputs("Usage: bench_gpu_contacts [--ticks N] [--most-samples N] [--json]\n", stderr);
      return 2;
    }
  }
  if (ticks < 1 || most_samples < 64) {
    std::fputs("bench_gpu_contacts: --ticks must be positive and --most-samples at least 64.\n",
               stderr);
    return 2;
  }
  try {
    return asperity::run(ticks, most_samples, as_json);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_gpu_contacts: %s\n", error.what());
    return 1;
  }
}
