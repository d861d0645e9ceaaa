// Replays each surface on a worker thread, which is given up if a renderer does not return in time.

#include "app/session/attempt_instability.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <exception>
#include <future>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "analysis/numbers/number_text.h"
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
                             double rate_Hz, AttemptInstability::Values wanted) {
  const RecordedTexture texture = texture_of(surface, records, rate_Hz);
  const std::optional<double> rms_N = recorded_texture_force_rms_N(texture, surface.band);
  ReplayedMeasures measures{};
  if (rms_N && std::isfinite(*rms_N)) measures.texture_force_N = rms_N;
  if (wanted == AttemptInstability::Values::all) {
    const bool is_perceivable_band = surface.band == TextureForceBand{};
    measures.instability = instability_row(perceived_instability(
        surface.model, surface.inputs, texture, is_perceivable_band ? rms_N : std::nullopt));
  }
  return measures;
}

/// A renderer whose calls are counted, so that one that does not return is noticed from another thread.
class CountedRenderer final : public ForceRenderer {
 public:
  CountedRenderer(std::unique_ptr<ForceRenderer> inner,
                  std::shared_ptr<std::atomic<std::uint64_t>> calls)
      : inner_(std::move(inner)), calls_(std::move(calls)) {}
  void reset(const ProbeState& first) noexcept override {
    inner_->reset(first);
    ++*calls_;
  }
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const RenderedTick rendered = inner_->tick(probe, dt_s);
    ++*calls_;
    return rendered;
  }
  Friction* friction() noexcept override { return inner_->friction(); }
  TipOnCharts* tip() noexcept override { return inner_->tip(); }
  std::span<const NamedCount> limits() const noexcept override { return inner_->limits(); }
  std::string_view error() const noexcept override { return inner_->error(); }

 private:
  std::unique_ptr<ForceRenderer> inner_;
  std::shared_ptr<std::atomic<std::uint64_t>> calls_;
};

}  // namespace

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

struct AttemptInstability::Work {
  std::vector<JudgedSurface> surfaces{};
  std::vector<TickRecord>
      felt{};  // the recorder's records move in memory while the session continues
  double rate_Hz = 0.0;
  Values wanted = Values::all;
  std::shared_ptr<std::atomic<std::uint64_t>> calls =
      std::make_shared<std::atomic<std::uint64_t>>(0);
  std::atomic<std::size_t> surface = 0;  // that is judged at present
  std::promise<std::map<int, Judged>> result{};
  std::future<std::map<int, Judged>> found = result.get_future();

  void run() noexcept {
    try {
      std::map<int, Judged> judged{};
      for (const JudgedSurface& each : surfaces) {
        const auto id = static_cast<std::uint64_t>(each.position);
        judged[each.position] = {.records = records_of(id, felt),
                                 .values = measures_of(each, felt, rate_Hz, wanted)};
        ++surface;
      }
      result.set_value(std::move(judged));
    } catch (...) {
      result.set_exception(std::current_exception());
    }
  }
};

AttemptInstability::AttemptInstability(std::chrono::milliseconds patience) : patience_(patience) {}

AttemptInstability::~AttemptInstability() {
  try {
    finish();
  } catch (const std::exception&) {  // nobody wants the values
  }
}

void AttemptInstability::begin(std::vector<JudgedSurface> surfaces,
                               std::span<const TickRecord> records, double rate_Hz, Values wanted) {
  try {
    const auto work = std::make_shared<Work>();
    work->surfaces = std::move(surfaces);
    work->felt.assign(records.begin(), records.end());
    work->rate_Hz = rate_Hz;
    work->wanted = wanted;
    for (JudgedSurface& surface : work->surfaces) {
      surface.model.make = [make = std::move(surface.model.make),
                            calls = work->calls](const RendererInputs& inputs) {
        auto renderer = std::make_unique<CountedRenderer>(make(inputs), calls);
        ++*calls;
        return renderer;
      };
    }
    std::thread([work] { work->run(); }).detach();
    work_ = work;
  } catch (const std::system_error&) {  // no thread
  } catch (const std::bad_alloc&) {
  }
}

void AttemptInstability::finish() {
  const std::shared_ptr<Work> work = std::exchange(work_, nullptr);
  if (work == nullptr) return;
  std::uint64_t calls = *work->calls;
  while (work->found.wait_for(patience_) != std::future_status::ready) {
    const std::uint64_t before = std::exchange(calls, work->calls->load());
    if (calls != before) continue;
    const std::size_t last = work->surfaces.size() - 1;  // of one that is judged this moment
    hanging_model_ = work->surfaces.at(std::min(last, work->surface.load())).model.declaration.id;
    return;
  }
  judged_ = work->found.get();
}

ReplayedMeasures AttemptInstability::take(const JudgedSurface& surface,
                                          std::span<const TickRecord> records, double rate_Hz,
                                          Values wanted) {
  const auto id = static_cast<std::uint64_t>(surface.position);
  const auto is_judged = [&] {
    const auto found = judged_.find(surface.position);
    return found != judged_.end() && found->second.records == records_of(id, records);
  };
  try {
    finish();
    if (!hanging_model_ && !is_judged()) {
      begin({surface}, records, rate_Hz, wanted);
      finish();
    }
    return is_judged() ? judged_.at(surface.position).values : ReplayedMeasures{};
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
