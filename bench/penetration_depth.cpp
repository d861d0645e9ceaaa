// What penetration depth and its gradient cost for one contact, and how far they are from the truth.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "device/machine.h"
#include "renderers/offline/tick_times.h"
#include "renderers/pd_gradient/sampling/cached_penetration.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "tests/renderers/pd_gradient_surfaces.h"

namespace asperity {
namespace {

constexpr TickCount kCount{.warm_up = 2'000, .counted = 10'000};
constexpr TickCount kCountOfReference{.warm_up = 1, .counted = 100};
constexpr double kDepth_m = 0.1e-3;
constexpr double kSlide_m = 10e-6;  // from tick to tick
constexpr int kTruthSamples = 1024;
constexpr int kContactsOfAKind = 6;

struct Costs {
  std::string name{};
  TickTimes times{};
};

// Null where the processor was taken away in every call.
nlohmann::json quantile_ns(const Costs& costs, double fraction) {
  const std::optional<std::int64_t> time_ns = costs.times.quantile_ns(fraction);
  return time_ns ? nlohmann::json(*time_ns) : nullptr;
}

const char* kind_name(ContactKind kind) {
  switch (kind) {
    case ContactKind::flat:
      return "flat";
    case ContactKind::convex_on_flat:
      return "convex_on_flat";
    case ContactKind::convex_on_convex:
      return "convex_on_convex";
    case ContactKind::conforming:
      return "conforming";
    case ContactKind::ridge:
      return "ridge";
    case ContactKind::overlapping:
      return "overlapping";
  }
  return "";
}

SamplingGrid window_of(int samples) {
  return {.width_m = ContactsByChance::kWindow_m, .samples = samples};
}

// Pressed in until the surfaces are that deep in each other on this grid.
ChanceContact pressed(ContactsByChance& chance, ContactKind kind, const SamplingGrid& grid) {
  ChanceContact contact = chance.draw(kind);
  const auto found =
      reference_penetration(contact.a(), contact.b(), {}, grid, HardMaximum{.step_m = 1e-4});
  contact.pose_a.position_m.z -= kDepth_m - found->depth_m;
  return contact;
}

// To and fro over a millimetre, slowly drifting aside.
Pose slid(Pose pose, int tick) {
  const double phase_rad = kSlide_m * tick / 0.5e-3;
  pose.position_m.x += 0.5e-3 * std::sin(phase_rad);
  pose.position_m.y += 0.3e-3 * std::sin(0.137 * phase_rad);
  return pose;
}

constexpr HardMaximum kHard{.step_m = ContactsByChance::kShortest_m / 8.0};
// With 96 samples a whole number of cells is a twelfth.
constexpr HardMaximum kHardAt96{.step_m = ContactsByChance::kShortest_m / 12.0};
constexpr SmoothMaximum kSmooth{.tau_m = 20e-6};

template <typename Evaluation>
Costs time_of(Evaluation&& evaluation, const std::string& name, const ChanceContact& contact,
              const PackedSurface& a, const PackedSurface& b, double& used) {
  return {
      name, time_ticks(kCount, [&](int tick) {
        const auto found = evaluation.evaluate(
            {.surface = a, .triangles = contact.triangles_a, .pose = slid(contact.pose_a, tick)},
            {.surface = b, .triangles = contact.triangles_b, .pose = contact.pose_b}, {});
        if (found) used += found->depth_m;
      })};
}

void time_contact(int samples, ContactKind kind, const MaximumLaw& law, InstructionSet set,
                  std::vector<Costs>& all, double& used) {
  ContactsByChance chance(1);
  const ChanceContact contact = pressed(chance, kind, window_of(samples));
  const PackedSurface a(contact.mesh_a);
  const PackedSurface b(contact.mesh_b);
  const SamplerSettings settings{
      .grid = window_of(samples),
      .law = law,
      .most_triangles = std::max(a.triangles().size(), b.triangles().size()),
      .instructions = set};
  const bool is_hard = std::holds_alternative<HardMaximum>(law);
  const std::string name = std::string(is_hard ? "hard/" : "smooth/") + name_of(set) + "/" +
                           std::to_string(samples) + "/" + kind_name(kind);
  all.push_back(time_of(PenetrationSampler(settings), name + "/sampler", contact, a, b, used));
  all.push_back(
      time_of(CachedPenetration({.sampler = settings}), name + "/cached", contact, a, b, used));
}

Costs time_of_reference(int samples, double& used) {
  ContactsByChance chance(1);
  ChanceContact contact = pressed(chance, ContactKind::flat, window_of(samples));
  const Pose start = contact.pose_a;
  return {"reference/" + std::to_string(samples) + "/flat",
          time_ticks(kCountOfReference, [&](int tick) {
            contact.pose_a = slid(start, tick);
            const auto found =
                reference_penetration(contact.a(), contact.b(), {}, window_of(samples), kHard);
            if (found) used += found->depth_m;
          })};
}

// Root mean squares over contacts, relative to the truth's.
struct Errors {
  std::string name{};
  double depth_m2 = 0.0;
  std::array<double, 5> difference{};
  std::array<double, 5> whole{};
  int contacts = 0;

  void add(const Penetration& found, const Penetration& truth) {
    depth_m2 += (found.depth_m - truth.depth_m) * (found.depth_m - truth.depth_m);
    const auto gradient = [](const Penetration& p) {
      return std::array{p.slope.x, p.slope.y, p.lever_m.x, p.lever_m.y, p.lever_m.z};
    };
    for (std::size_t i = 0; i < 5; ++i) {
      const double apart = gradient(found)[i] - gradient(truth)[i];
      difference[i] += apart * apart;
      whole[i] += gradient(truth)[i] * gradient(truth)[i];
    }
    ++contacts;
  }
  double relative(std::size_t i) const { return std::sqrt(difference[i] / whole[i]); }
  double depth_um() const { return 1e6 * std::sqrt(depth_m2 / contacts); }
};

// Against the same definition on a grid of 1024 × 1024, with the same step.
std::vector<Errors> accuracy(std::uint64_t seed) {
  constexpr std::array kSamples = {64, 96, 128, 256};
  std::vector<Errors> all;
  for (const int samples : kSamples) {
    const std::string at = "/" + std::to_string(samples);
    for (const char* name : {"hard/reference", "hard/sampler", "hard/cached", "smooth/reference",
                             "smooth/sampler", "smooth/cached"}) {
      all.push_back({.name = name + at});
    }
  }
  ContactsByChance chance(seed);
  for (const ContactKind kind : kContactKinds) {
    for (int i = 0; i < kContactsOfAKind; ++i) {
      const ChanceContact contact = pressed(chance, kind, window_of(256));
      const PackedSurface a(contact.mesh_a);
      const PackedSurface b(contact.mesh_b);
      const auto plain = [&](int samples, const MaximumLaw& law) {
        return reference_penetration(contact.a(), contact.b(), {}, window_of(samples), law).value();
      };
      const auto fast = [&](int samples, const MaximumLaw& law) {
        PenetrationSampler sampler(
            {.grid = window_of(samples),
             .law = law,
             .most_triangles = std::max(a.triangles().size(), b.triangles().size()),
             .instructions = instruction_sets_here().back()});
        return sampler
            .evaluate({.surface = a, .triangles = contact.triangles_a, .pose = contact.pose_a},
                      {.surface = b, .triangles = contact.triangles_b, .pose = contact.pose_b}, {})
            .value();
      };
      // From heights that were kept when A was elsewhere: half as far as it may be.
      const auto kept = [&](int samples, const MaximumLaw& law) {
        CachedPenetration cached(
            {.sampler = {.grid = window_of(samples),
                         .law = law,
                         .most_triangles = std::max(a.triangles().size(), b.triangles().size()),
                         .instructions = instruction_sets_here().back()}});
        const auto answer = [&](const Pose& pose) {
          return cached.evaluate(
              {.surface = a, .triangles = contact.triangles_a, .pose = pose},
              {.surface = b, .triangles = contact.triangles_b, .pose = contact.pose_b}, {});
        };
        Pose before = contact.pose_a;
        before.position_m += glm::dvec3{0.9e-3, -0.7e-3, 0.02e-3};
        before.rotation = turn_about({1, 0, 0}, 0.012) * turn_about({0, 1, 0}, -0.01) *
                          turn_about({0, 0, 1}, 0.03) * before.rotation;
        while (cached.kept_answers() == 0) answer(before);
        return answer(contact.pose_a).value();
      };
      std::size_t row = 0;
      const Penetration truth_at_96 = plain(kTruthSamples, kHardAt96);
      const Penetration truth_elsewhere = plain(kTruthSamples, kHard);
      const Penetration smooth_truth = plain(kTruthSamples, kSmooth);
      for (const int samples : kSamples) {
        const HardMaximum& hard = samples == 96 ? kHardAt96 : kHard;
        const Penetration& hard_truth = samples == 96 ? truth_at_96 : truth_elsewhere;
        all[row++].add(plain(samples, hard), hard_truth);
        all[row++].add(fast(samples, hard), hard_truth);
        all[row++].add(kept(samples, hard), hard_truth);
        all[row++].add(plain(samples, kSmooth), smooth_truth);
        all[row++].add(fast(samples, kSmooth), smooth_truth);
        all[row++].add(kept(samples, kSmooth), smooth_truth);
      }
    }
  }
  return all;
}

nlohmann::ordered_json head() {
  return {{"format", "asperity.bench/1"},
          {"machine", machine()},
          {"commit", ASPERITY_COMMIT},
          {"isa", asperity::name_of(instruction_sets_here().back())}};
}

void print_costs(const std::vector<Costs>& all, bool as_json) {
  nlohmann::ordered_json document = head();
  document["cases"] = nlohmann::ordered_json::array();
  if (!as_json) {
    std::printf("%-40s %9s %9s %9s %7s %9s\n", "case (ns)", "p50", "p99", "p99.9", "count",
                "preempted");
  }
  for (const Costs& costs : all) {
    const std::array quantiles_ns = {quantile_ns(costs, 0.5), quantile_ns(costs, 0.99),
                                     quantile_ns(costs, 0.999)};
    document["cases"].push_back({{"name", costs.name},
                                 {"unit", "ns"},
                                 {"p50", quantiles_ns[0]},
                                 {"p99", quantiles_ns[1]},
                                 {"p99_9", quantiles_ns[2]},
                                 {"count", costs.times.undisturbed_ns.size()},
                                 {"preempted", costs.times.preempted}});
    if (!as_json) {
      std::printf("%-40s %9s %9s %9s %7zu %9lld\n", costs.name.c_str(),
                  quantiles_ns[0].dump().c_str(), quantiles_ns[1].dump().c_str(),
                  quantiles_ns[2].dump().c_str(), costs.times.undisturbed_ns.size(),
                  static_cast<long long>(costs.times.preempted));
    }
  }
  if (as_json) std::puts(document.dump(2).c_str());
}

void print_errors(const std::vector<Errors>& all, bool as_json) {
  constexpr std::array kNames = {"u", "v", "theta_u", "theta_v", "theta_n"};
  nlohmann::ordered_json document = head();
  document["errors"] = nlohmann::ordered_json::array();
  for (const Errors& errors : all) {
    nlohmann::ordered_json row{{"name", errors.name}, {"depth_um", errors.depth_um()}};
    for (std::size_t i = 0; i < kNames.size(); ++i) row[kNames[i]] = errors.relative(i);
    row["contacts"] = errors.contacts;
    document["errors"].push_back(row);
    if (!as_json) {
      std::printf("%-20s depth %6.2f um, relative", errors.name.c_str(), errors.depth_um());
      for (std::size_t i = 0; i < kNames.size(); ++i) {
        std::printf("  %s %.3f", kNames[i], errors.relative(i));
      }
      std::puts("");
    }
  }
  if (as_json) std::puts(document.dump(2).c_str());
}

int run(bool as_json, bool with_accuracy, std::uint64_t seed) {
  if (with_accuracy) {
    print_errors(accuracy(seed), as_json);
    return 0;
  }
  double used = 0.0;  // so that no work can be left out
  std::vector<Costs> all;
  for (const int samples : {64, 128}) {
    for (const ContactKind kind : {ContactKind::flat, ContactKind::convex_on_flat}) {
      for (const InstructionSet set : instruction_sets_here()) {
        time_contact(samples, kind, kHard, set, all, used);
        time_contact(samples, kind, kSmooth, set, all, used);
      }
    }
  }
  all.push_back(time_of_reference(64, used));
  print_costs(all, as_json);
  return std::isfinite(used) ? 0 : 1;
}

}  // namespace
}  // namespace asperity

int main(int argc, char** argv) {
  bool as_json = false;
  bool with_accuracy = false;
  std::uint64_t seed = 2;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--json") == 0) {
      as_json = true;
    } else if (std::strcmp(argv[i], "--accuracy") == 0) {
      with_accuracy = true;
    } else if (std::strcmp(argv[i], "--seed") == 0 && i + 1 < argc) {
      seed = std::strtoull(argv[++i], nullptr, 10);
    } else {
      std::fprintf(stderr, "usage: %s [--json] [--accuracy [--seed N]]\n", argv[0]);
      return 2;
    }
  }
  return asperity::run(as_json, with_accuracy, seed);
}
