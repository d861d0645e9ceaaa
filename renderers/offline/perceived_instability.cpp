// Implements the detectors of perceived instability.

#include "renderers/offline/perceived_instability.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "analysis/signals/spectrum.h"
#include "renderers/offline/replay.h"
#include "renderers/offline/slow_hand.h"
#include "renderers/offline/unexplained_vibration.h"
#include "renderers/servo/contact.h"

namespace asperity {
namespace {

constexpr FrequencyBand kAlive{2.0, 20.0};
constexpr double kLeastRest_s = 0.5;   // one period of the lower limit
constexpr double kReturn_m = 50e-6;    // a few steps of a device's position
constexpr double kLeastPart_s = 0.05;  // a shorter part is noise of the position
constexpr double kLeastSlow_s = 0.5;
constexpr double kNearCrest_cycles = 0.15;

/// Indices of records, the second one after the last.
using IndexRange = std::pair<std::size_t, std::size_t>;

double seconds_of(const TickRecord& from, const TickRecord& to) {
  return static_cast<double>(to.probe.time_ns - from.probe.time_ns) * 1e-9;
}

double speed_along_surface_m_per_s(const TickRecord& record) {
  return glm::length(glm::dvec2(record.probe.velocity_m_per_s));
}

/// The stretches of the header: from contact to contact.
std::vector<IndexRange> stretches_of(std::span<const TickRecord> felt, double rate_Hz) {
  std::vector<IndexRange> stretches{};
  std::optional<std::size_t> first{};
  std::size_t last = 0;
  const auto end = [&] {
    if (first) stretches.emplace_back(*first, last + 1);
    first.reset();
  };
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const bool is_consecutive = i > 0 &&
                                seconds_of(felt[i - 1], felt[i]) * rate_Hz < kUnbroken_ticks &&
                                !felt[i].has(TickFlag::first_of_presentation);
    if (!is_consecutive || felt[i].gain < 1.0 ||
        (first && seconds_of(felt[last], felt[i]) > kLift_s)) {
      end();
    }
    if (!measures_hand(felt[i])) continue;
    if (!first) first = i;
    last = i;
  }
  end();
  return stretches;
}

/// The parts of the stretches in which the hand rests for long enough.
std::vector<IndexRange> rests_in(std::span<const TickRecord> slow,
                                 const std::vector<IndexRange>& stretches) {
  std::vector<IndexRange> rests{};
  for (const auto& [from, to] : stretches) {
    std::size_t begin = from;
    for (std::size_t i = from; i <= to; ++i) {
      if (i < to && speed_along_surface_m_per_s(slow[i]) < kResting_m_per_s) continue;
      if (i > begin && seconds_of(slow[begin], slow[i - 1]) >= kLeastRest_s) {
        rests.emplace_back(begin, i);
      }
      begin = i + 1;
    }
  }
  return rests;
}

std::optional<Buzz> buzz_of(std::span<const TickRecord> felt,
                            std::span<const RenderedTick> explained, double texture_N,
                            const std::vector<IndexRange>& stretches, double rate_Hz) {
  std::optional<Buzz> greatest{};
  for (const auto& [from, to] : stretches) {
    std::vector<glm::dvec3> delivered_N{};
    std::vector<glm::dvec3> explained_N{};
    for (std::size_t i = from; i < to; ++i) {
      delivered_N.push_back(felt[i].sent.force_N);
      explained_N.push_back(explained[i].wrench.force_N);
    }
    const auto vibration = unexplained_vibration({delivered_N, explained_N, rate_Hz});
    if (!vibration || (greatest && vibration->rms_N <= greatest->force_N)) continue;
    greatest =
        Buzz{.force_N = vibration->rms_N, .time_ns = felt[from + vibration->middle].probe.time_ns};
  }
  if (greatest) greatest->ratio = greatest->force_N / std::max(texture_N, kLeastTexture_N);
  return greatest;
}

/// Mean squares of vectors over several stretches, pooled.
class PooledRms final {
 public:
  template <typename VectorOf>
  void add(const IndexRange& range, double rate_Hz, const VectorOf& vector_of) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values{};
      for (std::size_t i = range.first; i < range.second; ++i) values.push_back(vector_of(i)[axis]);
      const double rms = band_rms(values, rate_Hz, kAlive.low_Hz, kAlive.high_Hz);
      squares_ += rms * rms * static_cast<double>(values.size());
    }
    samples_ += range.second - range.first;
  }
  double rms() const { return std::sqrt(squares_ / static_cast<double>(samples_)); }

 private:
  double squares_ = 0.0;
  std::size_t samples_ = 0;
};

/// Over the closed parts of one rest; nullopt without one.
std::optional<double> work_in_closed_parts_J(std::span<const TickRecord> felt,
                                             std::span<const RenderedTick> plate,
                                             const IndexRange& rest) {
  std::optional<double> work_J{};
  std::size_t begin = rest.first;
  while (begin + 1 < rest.second) {
    std::size_t end = rest.second - 1;
    const auto is_closed = [&] {
      return glm::length(felt[end].probe.position_m - felt[begin].probe.position_m) <= kReturn_m;
    };
    while (seconds_of(felt[begin], felt[end]) >= kLeastPart_s && !is_closed()) --end;
    if (seconds_of(felt[begin], felt[end]) < kLeastPart_s) {
      // No part begins here. The next attempt is one part later, which bounds the number of comparisons.
      const std::size_t from = begin;
      while (begin + 1 < rest.second && seconds_of(felt[from], felt[begin]) < kLeastPart_s) ++begin;
      continue;
    }
    const auto added_N = [&](std::size_t i) {
      return felt[i].sent.force_N - plate[i].wrench.force_N;
    };
    glm::dvec3 mean_N{0.0};
    for (std::size_t i = begin; i < end; ++i) mean_N += added_N(i);
    mean_N /= static_cast<double>(end - begin);
    work_J = work_J.value_or(0.0);
    for (std::size_t i = begin; i < end; ++i) {
      *work_J +=
          glm::dot(added_N(i) - mean_N, felt[i + 1].probe.position_m - felt[i].probe.position_m);
    }
    begin = end;
  }
  return work_J;
}

std::optional<Aliveness> aliveness_of(std::span<const TickRecord> felt,
                                      std::span<const RenderedTick> plate,
                                      const std::vector<IndexRange>& rests, double rate_Hz) {
  if (rests.empty()) return {};
  Aliveness alive{};
  PooledRms force{};
  PooledRms of_plate{};
  PooledRms position{};
  for (const IndexRange& rest : rests) {
    alive.resting_s += static_cast<double>(rest.second - rest.first) / rate_Hz;
    force.add(rest, rate_Hz, [&](std::size_t i) { return felt[i].sent.force_N; });
    of_plate.add(rest, rate_Hz, [&](std::size_t i) { return plate[i].wrench.force_N; });
    position.add(rest, rate_Hz, [&](std::size_t i) { return felt[i].probe.position_m; });
    if (const auto work_J = work_in_closed_parts_J(felt, plate, rest)) {
      alive.net_work_J = alive.net_work_J.value_or(0.0) + *work_J;
    }
  }
  alive.force_N = force.rms();
  alive.plate_N = of_plate.rms();
  alive.position_m = position.rms();
  return alive;
}

std::optional<Ridge> ridge_of(const ForceModel& model, const RendererInputs& inputs,
                              std::span<const TickRecord> slow,
                              const std::vector<IndexRange>& stretches, double rate_Hz) {
  RendererInputs complete = inputs;
  complete.parameters = complete_values(model.declaration, inputs.parameters);
  std::size_t slow_ticks = 0;
  std::size_t near_crests = 0;
  for (const auto& [from, to] : stretches) {
    for (std::size_t i = from; i < to; ++i) {
      if (!is_in_contact(slow[i]) || speed_along_surface_m_per_s(slow[i]) >= kSlow_m_per_s)
        continue;
      ++slow_ticks;
      const double phase = model.crest_phase(complete, slow[i].probe.position_m);
      if (std::abs(phase) <= kNearCrest_cycles) ++near_crests;
    }
  }
  const double slow_s = static_cast<double>(slow_ticks) / rate_Hz;
  if (slow_s < kLeastSlow_s) return {};
  return Ridge{.crest_share = static_cast<double>(near_crests) / static_cast<double>(slow_ticks),
               .slow_s = slow_s};
}

}  // namespace

const char* name_of(NotJudged reason) noexcept {
  switch (reason) {
    case NotJudged::too_short:
      return "too_short";
    case NotJudged::no_force:
      return "no_force";
    case NotJudged::low_rate:
      return "low_rate";
    case NotJudged::no_crests:
      return "no_crests";
  }
  return "unknown";
}

PerceivedInstability perceived_instability(const ForceModel& model, const RendererInputs& inputs,
                                           const RecordedTexture& texture,
                                           std::optional<double> texture_force_N) {
  PerceivedInstability judged{};
  const double rate_Hz = texture.rate_Hz;
  if (!(rate_Hz > 2.0 * kBuzzFrom_Hz)) {
    judged.no_buzz = judged.no_aliveness = judged.no_ridge = NotJudged::low_rate;
    return judged;
  }
  const std::vector<TickRecord>& felt = texture.felt;
  const std::vector<IndexRange> stretches = stretches_of(felt, rate_Hz);
  const bool is_delivered = std::any_of(felt.begin(), felt.end(), [](const TickRecord& record) {
    return record.sent.force_N != glm::dvec3(0.0);
  });
  const std::vector<TickRecord> slow = slow_hand(felt, rate_Hz);
  if (!is_delivered) {
    judged.no_buzz = judged.no_aliveness =
        stretches.empty() ? NotJudged::too_short : NotJudged::no_force;
  } else {
    const auto explained = replay(*make_renderer(model, inputs), slow, rate_Hz);
    if (!texture_force_N) texture_force_N = recorded_texture_force_rms_N(texture, {});
    const double texture_N = texture_force_N.value_or(0.0);
    judged.buzz = buzz_of(felt, explained, texture_N, stretches, rate_Hz);
    if (!judged.buzz) judged.no_buzz = NotJudged::too_short;
    const std::vector<IndexRange> rests = rests_in(slow, stretches);
    if (rests.empty()) {
      judged.no_aliveness = NotJudged::too_short;
    } else {
      judged.aliveness = aliveness_of(felt, texture.plate, rests, rate_Hz);
    }
  }
  if (!model.crest_phase || inputs.body) {
    judged.no_ridge = NotJudged::no_crests;
  } else {
    judged.ridge = ridge_of(model, inputs, slow, stretches, rate_Hz);
    if (!judged.ridge) judged.no_ridge = NotJudged::too_short;
  }
  return judged;
}

}  // namespace asperity
