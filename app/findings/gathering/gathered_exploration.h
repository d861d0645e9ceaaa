// Stores how the surfaces of a study were explored, as far as tables and models use it: own values of the participants, and contact times.

#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/findings/tidy/described_conditions.h"
#include "results_schema/session_answers.h"

namespace asperity {

struct GatheredAnswer;
struct GatheredAnswers;

/// The quantities that describe an exploration: of each surface, and the response time of each trial. The names are
/// those in tables, with their units.
enum class Explored {
  contact_s,
  visits,
  path_m,
  strokes,
  stroke_length_m,
  response_s,
  force_N,
  force_sd_N,
  speed_m_per_s,
  speed_sd_m_per_s,
};
inline constexpr std::size_t kExploredQuantityCount = 10;

/// Medians of times, because they are skewed; means of all others.
OwnAverage own_average_of(Explored quantity) noexcept;

/// What a level belongs to.
enum class ExploredBy {
  everything,  ///< all surfaces, or all trials
  trial,       ///< a factor of the trials
  block,
  item,  ///< of the surface; of a trial with exactly one surface, that of this surface
};

struct ExploredCondition {
  ExploredBy by = ExploredBy::everything;
  std::string factor{};     ///< of the trials
  std::uint32_t level = 0;  ///< word of GatheredAnswers

  auto operator<=>(const ExploredCondition&) const = default;
};

/// Whether the levels of a factor are not conditions in a block (word of its name): a procedure chose them, or they
/// were drawn for every trial. The repetition (`column`) is always a condition.
bool is_chosen_or_drawn(const GatheredAnswers& gathered, std::uint32_t block,
                        const std::string& factor);

/// A study may have millions of surfaces with nine quantities each: of all but the contact time and the mean force and speed,
/// which models need by row, only the participants' own values by condition are kept. They are computed when all sessions of a participant
/// have been added.
class GatheredExploration final {
 public:
  /// The surfaces of an attempt, in the order of GatheredAnswers::surfaces.
  void add(std::span<const SessionAnswers::Exploration> surfaces);
  /// After the last session of a participant: `gathered` has the answers of participants up to this one.
  void end_participant(const GatheredAnswers& gathered);

  /// Whether a contact time is stored.
  bool empty() const noexcept { return !has_contact_time_; }
  /// Of a surface of GatheredAnswers. 0 is stored for one that was not touched.
  std::optional<double> contact_s(std::size_t surface) const;
  /// Means over the contact with a surface; nothing of one that was not touched.
  std::optional<double> force_N(std::size_t surface) const;
  std::optional<double> speed_m_per_s(std::size_t surface) const;
  /// By participant, those with a measurement; empty where none has one.
  std::span<const OwnValue> own_values(const ExploredCondition& condition, Explored quantity) const;

 private:
  using OwnValues = std::array<std::vector<OwnValue>, kExploredQuantityCount>;

  bool has_contact_time_ = false;
  std::vector<double> contact_s_{};  ///< NaN where there is none: half the memory of an optional
  std::vector<float> force_N_{};     ///< the same
  std::vector<float> speed_m_per_s_{};
  std::vector<SessionAnswers::Exploration> of_participant_{};  ///< the last ones of `contact_s_`
  std::size_t ended_answers_ = 0;
  std::map<ExploredCondition, OwnValues> own_{};
};

}  // namespace asperity
