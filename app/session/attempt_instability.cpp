#include "app/session/attempt_instability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <utility>

#include "analysis/number_text.h"
#include "app/words/phrase_registry.h"
#include "app/words/reason.h"
#include "renderers/servo/contact.h"

namespace asperity {
namespace {

std::ptrdiff_t records_of(std::uint64_t presentation, std::span<const TickRecord> records) {
  return std::count_if(records.begin(), records.end(), [presentation](const TickRecord& record) {
    return is_rendered(record, presentation);
  });
}

RecordedTexture texture_of(const JudgedSurface& surface, std::span<const TickRecord> records,
                           double rate_Hz) {
  return recorded_texture(surface.model, surface.inputs,
                          {records, static_cast<std::uint64_t>(surface.position), rate_Hz});
}

std::optional<double> finite_texture_force_N(const RecordedTexture& texture,
                                             const TextureForceBand& band) {
  const std::optional<double> rms_N = recorded_texture_force_rms_N(texture, band);
  return rms_N && std::isfinite(*rms_N) ? rms_N : std::nullopt;
}

bool is_finite(const InstabilityRow& row) {
  constexpr std::array kNumbers{&InstabilityRow::buzz,
                                &InstabilityRow::buzz_force_N,
                                &InstabilityRow::resting_s,
                                &InstabilityRow::alive_force_N,
                                &InstabilityRow::alive_plate_force_N,
                                &InstabilityRow::alive_motion_m,
                                &InstabilityRow::alive_work_J,
                                &InstabilityRow::crest_share,
                                &InstabilityRow::slow_s};
  return std::all_of(kNumbers.begin(), kNumbers.end(), [&row](const auto number) {
    return std::isfinite((row.*number).value_or(0.0));
  });
}

ReplayedMeasures measures_of(const JudgedSurface& surface, std::span<const TickRecord> records,
                             double rate_Hz) {
  const RecordedTexture texture = texture_of(surface, records, rate_Hz);
  return {.texture_force_N = finite_texture_force_N(texture, surface.band),
          .instability =
              instability_row(perceived_instability(surface.model, surface.inputs, texture))};
}

}  // namespace

std::optional<double> texture_force_N(const JudgedSurface& surface,
                                      std::span<const TickRecord> records, double rate_Hz) {
  return finite_texture_force_N(texture_of(surface, records, rate_Hz), surface.band);
}

std::optional<InstabilityRow> instability_row(const PerceivedInstability& judged) {
  const auto reason = [](const std::optional<NotJudged>& none) {
    return none ? std::optional<std::string>(name_of(*none)) : std::nullopt;
  };
  InstabilityRow row{};
  if (judged.buzz) {
    row.buzz = judged.buzz->ratio;
    row.buzz_force_N = judged.buzz->force_N;
    row.buzz_ns = judged.buzz->time_ns;
  }
  row.no_buzz = reason(judged.no_buzz);
  if (judged.aliveness) {
    row.resting_s = judged.aliveness->resting_s;
    row.alive_force_N = judged.aliveness->force_N;
    row.alive_plate_force_N = judged.aliveness->plate_N;
    row.alive_motion_m = judged.aliveness->position_m;
    row.alive_work_J = judged.aliveness->net_work_J;
  }
  row.no_aliveness = reason(judged.no_aliveness);
  if (judged.ridge) {
    row.crest_share = judged.ridge->crest_share;
    row.slow_s = judged.ridge->slow_s;
  }
  row.no_crest_share = reason(judged.no_ridge);
  if (!is_finite(row)) return {};
  return row;
}

void AttemptInstability::begin(std::vector<JudgedSurface> surfaces,
                               std::span<const TickRecord> records, double rate_Hz) {
  try {
    // The recorder's records move in memory while the session continues.
    begun_ =
        std::async(std::launch::async,
                   [surfaces = std::move(surfaces),
                    felt = std::vector<TickRecord>(records.begin(), records.end()), rate_Hz] {
                     std::map<int, Judged> judged{};
                     for (const JudgedSurface& surface : surfaces) {
                       const auto id = static_cast<std::uint64_t>(surface.position);
                       judged[surface.position] = {.records = records_of(id, felt),
                                                   .values = measures_of(surface, felt, rate_Hz)};
                     }
                     return judged;
                   });
  } catch (const std::system_error&) {  // no thread
  } catch (const std::bad_alloc&) {
  }
}

ReplayedMeasures AttemptInstability::take(const JudgedSurface& surface,
                                          std::span<const TickRecord> records, double rate_Hz) {
  const auto id = static_cast<std::uint64_t>(surface.position);
  try {
    if (begun_.valid()) judged_ = begun_.get();
    const auto found = judged_.find(surface.position);
    if (found != judged_.end() && found->second.records == records_of(id, records)) {
      return found->second.values;
    }
    return measures_of(surface, records, rate_Hz);
  } catch (const std::exception&) {  // no reason to lose what the participant did
    return {};
  }
}

Phrase excessive_buzz(const Protocol& protocol, std::span<const PresentationRow> surfaces) {
  Phrase excesses{};
  if (!protocol.instability) return excesses;
  const double limit = protocol.instability->buzz_max;
  for (const PresentationRow& surface : surfaces) {
    if (!surface.instability || surface.instability->buzz.value_or(0.0) <= limit) continue;
    const double buzz = *surface.instability->buzz;
    // As exported; an excess of less than half of the last digit must not read as none.
    const double nearest = std::round(1000.0 * buzz) / 1000.0;
    const double rounded = nearest > limit ? nearest : std::ceil(1000.0 * buzz) / 1000.0;
    excesses = with_semicolon(excesses, phrase_of(Reason::buzz_too_strong)
                                            .with(std::to_string(surface.position),
                                                  number_text(rounded), number_text(limit)));
  }
  return excesses;
}

}  // namespace asperity
