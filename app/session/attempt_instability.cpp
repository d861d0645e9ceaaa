#include "app/session/attempt_instability.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "analysis/number_text.h"
#include "app/words/phrase_registry.h"
#include "app/words/reason.h"
#include "renderers/servo/contact.h"

namespace asperity {

InstabilityRow instability_row(const PerceivedInstability& judged) {
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
  return row;
}

void AttemptInstability::begin(int position, const PreparedStimulus& stimulus,
                               const RendererInputs& inputs, std::span<const TickRecord> records,
                               double rate_Hz) {
  const auto id = static_cast<std::uint64_t>(position);
  // The recorder's records move in memory while the session continues.
  std::vector<TickRecord> felt{};
  for (const TickRecord& record : records) {
    if (is_rendered(record, id)) felt.push_back(record);
  }
  judged_[position].push_back(std::async(
      std::launch::async, [model = *stimulus.model, inputs, felt = std::move(felt), id, rate_Hz] {
        return perceived_instability(model, inputs, {felt, id, rate_Hz});
      }));
}

std::optional<InstabilityRow> AttemptInstability::take(int position) {
  const auto found = judged_.find(position);
  if (found == judged_.end()) return {};
  return instability_row(found->second.back().get());
}

Phrase excessive_buzz(const Protocol& protocol, std::span<const PresentationRow> surfaces) {
  Phrase excesses{};
  if (!protocol.instability) return excesses;
  const double limit = protocol.instability->buzz_max;
  for (const PresentationRow& surface : surfaces) {
    if (!surface.instability || surface.instability->buzz.value_or(0.0) <= limit) continue;
    const double rounded = std::round(100.0 * *surface.instability->buzz) / 100.0;
    excesses = with_semicolon(excesses, phrase_of(Reason::buzz_too_strong)
                                            .with(std::to_string(surface.position),
                                                  number_text(rounded), number_text(limit)));
  }
  return excesses;
}

}  // namespace asperity
