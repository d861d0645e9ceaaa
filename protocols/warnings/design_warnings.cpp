// Checks each block for unused factors, priors, parts, unbalanced positions and equal trials, and scales of one name for one
// wording.

#include "protocols/warnings/design_warnings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "protocols/design/block_factors.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/question_place.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/kind_keys/discrimination_design.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/plan/block_rows.h"
#include "protocols/plan/roughness_matching.h"
#include "protocols/plan/surface_order.h"
#include "protocols/procedures/procedure.h"

namespace asperity {

namespace {

using Block = Protocol::Block;

/// Its levels number the repetitions of the same trials.
constexpr std::string_view kRepetitionFactor = "column";

/// Keys that state which trials there are, not what a trial presents.
constexpr std::array<std::string_view, 8> kKeysOfRows{
    "factors",          "crossed",          "drawn",          "exclude", "repetitions_of",
    "minimum_distance", "maximum_in_a_row", "fixed_positions"};

/// Texts for people, in which the name of a factor can be a word.
constexpr std::array<std::string_view, 6> kKeysOfTexts{"prompt",    "text",        "title",
                                                       "statement", "description", "label"};

bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Also within a formula: "speed / wavelength".
bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !is_word_character(text[at - 1]);
    if (begins && (end == text.size() || !is_word_character(text[end]))) return true;
  }
  return false;
}

bool names_factor(const nlohmann::json& value, const std::string& factor) {
  if (value.is_string()) return has_word(value.get_ref<const std::string&>(), factor);
  if (value.is_object()) {
    return std::any_of(value.items().begin(), value.items().end(), [&factor](const auto& entry) {
      const std::string& key = entry.key();
      if (std::find(kKeysOfRows.begin(), kKeysOfRows.end(), key) != kKeysOfRows.end() ||
          std::find(kKeysOfTexts.begin(), kKeysOfTexts.end(), key) != kKeysOfTexts.end()) {
        return false;
      }
      return key == factor || names_factor(entry.value(), factor);
    });
  }
  return value.is_array() && std::any_of(value.begin(), value.end(), [&factor](const auto& each) {
           return names_factor(each, factor);
         });
}

bool states_repetitions(const Block& block, const FactorLevels& row) {
  return std::ranges::any_of(block.repetitions_of, [&row](const Block::RowRepetitions& stated) {
    return has_levels(row, stated.levels);
  });
}

class DesignWarnings final {
 public:
  DesignWarnings(const Protocol& protocol, const std::string& file_name)
      : protocol_(protocol), document_(protocol.source, file_name) {}

  std::vector<Diagnostic> all() {
    for (const auto& [name, block] : protocol_.blocks) {
      const std::string pointer = pointer_to("/blocks", name);
      warn_of_unused_factors(block, pointer);
      warn_of_prior(block, pointer);
      warn_of_parts(block, pointer);
      warn_of_positions(block, pointer);
      warn_of_equal_rows(block, pointer);
    }
    warn_of_scales();
    return std::move(found_);
  }

 private:
  void warn(const std::string& pointer, Phrase message) {
    found_.push_back(document_.at(pointer, std::move(message)));
  }

  void warn_of_unused_factors(const Block& block, const std::string& pointer) {
    for (std::size_t i = 0; i < block.crossed.size(); ++i) {
      const std::string& factor = block.crossed[i];
      const auto known = protocol_.factors.find(factor);
      if (factor == kRepetitionFactor || known == protocol_.factors.end() ||
          known->second.levels.size() < 2 || names_factor(document_.root(), factor)) {
        continue;
      }
      warn(pointer_to(pointer + "/crossed", i),
           phrase("Protocols",
                  "no stimulus, exploration or question uses the factor %1, so that its levels "
                  "repeat the same trials; use it, or remove it and state repetitions")
               .with(in_quotes(factor)));
    }
  }

  void warn_of_prior(const Block& block, const std::string& pointer) {
    if (!block.procedure) return;
    for (const ProcedureSettings& settings : block.procedure->tracks) {
      const PosteriorTrack* const track = posterior_track_of(settings);
      if (track == nullptr) continue;
      double smallest = 0.0;
      double largest = 0.0;
      for (const double level : levels_of(track->grid)) {
        const double difference = std::abs(level - track->origin);
        if (difference > 0.0 && (smallest == 0.0 || difference < smallest)) smallest = difference;
        largest = std::max(largest, difference);
      }
      const ValueRange& prior = track->prior.thresholds;
      if (prior.highest >= smallest && prior.lowest <= largest) continue;
      warn(pointer + "/procedure/prior/threshold",
           prior.highest < smallest
               ? phrase("Protocols",
                        "all thresholds of the prior are below the smallest difference of the "
                        "levels from the standard, so that the procedure cannot find a threshold "
                        "within the levels; state a range that contains the expected threshold")
               : phrase("Protocols",
                        "all thresholds of the prior are above the largest difference of the "
                        "levels from the standard, so that the procedure cannot find a threshold "
                        "within the levels; state a range that contains the expected threshold"));
      return;
    }
  }

  /// The pairs of a part connect all levels if they contain two successive rounds (part_of_round in block_rows.cpp).
  void warn_of_parts(const Block& block, const std::string& pointer) {
    if (!block.all_pairs || block.all_pairs->parts < 2) return;
    const auto factor = protocol_.factors.find(block.all_pairs->factor);
    if (factor == protocol_.factors.end()) return;
    const std::size_t levels = factor->second.levels.size();
    const auto parts = static_cast<std::size_t>(block.all_pairs->parts);
    if (2 * parts < levels) return;
    warn(pointer + "/all_pairs/parts",
         phrase("Protocols",
                "with %1 parts, the pairs of a participant need not connect all %2 levels of %3; "
                "state fewer than half as many parts as levels, at most %4")
             .with(std::to_string(parts), std::to_string(levels), in_quotes(factor->first),
                   std::to_string((levels - 1) / 2)));
  }

  void warn_of_positions(const Block& block, const std::string& pointer) {
    if (block.phase != Phase::main || block.kind != discrimination_kind().id || !block.vary ||
        block.design()->has_noise() || block.vary->values().size() < 2 ||
        chooses_levels_from_answers(block) || matches_roughness(protocol_, block)) {
      return;
    }
    const std::vector<BlockRow> rows = rows_of(protocol_, block);
    const std::vector<BlockTrial> trials = trials_of(block, rows);
    if (balances_every_row(block, rows, trials)) return;
    Phrase changes{};
    const auto propose = [&changes](const Phrase& change) {
      changes = changes.empty() ? change : phrase("Protocols", "%1; %2").with(changes, change);
    };
    if (block.positions != Block::Positions::balanced) {
      propose(phrase("Protocols", "set %1 to %2, since they are drawn for each trial")
                  .with(key_name("positions"), word_name("balanced")));
    }
    if (block.until) {
      propose(phrase("Protocols", "remove %1, which can end the block after any trial")
                  .with(key_name("until")));
    }
    if (block.procedure) {
      propose(phrase("Protocols",
                     "state %1 in place of %2, whose trials are dealt positions over all levels "
                     "together")
                  .with(key_name("repetitions"), key_name("procedure")));
    } else if (!has_multiples_of_surfaces(block, rows, trials)) {
      propose(phrase("Protocols",
                     "set the repetitions so that each combination of levels has a multiple of %1 "
                     "trials, the number of surfaces")
                  .with(std::to_string(surfaces_in_trial(block))));
    }
    warn(pointer + "/positions",
         phrase("Protocols",
                "positions need not be balanced within each level, so that a level can have the "
                "comparison more often in one position: %1")
             .with(changes));
  }

  /// One for each group of equal rows, at the second of them. In a fixed order a trial may return.
  void warn_of_equal_rows(const Block& block, const std::string& pointer) {
    if (block.order == Block::Order::fixed) return;
    std::map<FactorLevels, std::vector<std::size_t>> groups{};
    for (std::size_t i = 0; i < block.listed.size(); ++i) groups[block.listed[i]].push_back(i);
    for (const auto& [row, group] : groups) {
      if (group.size() < 2 || states_repetitions(block, row)) continue;
      std::vector<Phrase> numbers{};
      for (const std::size_t i : group) numbers.emplace_back(std::to_string(i + 1));
      warn(pointer_to(pointer + "/listed", group[1]),
           phrase("Protocols",
                  "the listed trials %1 have the same levels, so that this trial is presented more "
                  "often than the others; change a level, or remove all but one of them and state "
                  "the number of its repetitions")
               .with(joined_by_and(numbers)));
    }
  }

  /// Responses to a scale are stored under its name, and analyses pool those of all blocks.
  void warn_of_scales() {
    struct Place {
      std::string block{};
      const Question* question = nullptr;
    };
    std::map<std::string, Place> first{};
    for (const auto& [name, block] : protocol_.blocks) {
      for (std::size_t i = 0; i < block.questions.size(); ++i) {
        const Question& scale = block.questions[i];
        if (!scale.is_answered_by<ScaleForm>()) continue;
        const auto [known, is_new] = first.try_emplace(scale.name, Place{name, &scale});
        const Question& other = *known->second.question;
        if (is_new || (scale.prompt == other.prompt && scale.form == other.form)) continue;
        const bool is_prompt = scale.prompt != other.prompt;
        const bool is_labels =
            std::get<ScaleForm>(scale.form).labels != std::get<ScaleForm>(other.form).labels;
        warn(place_of_question(block, i) + (is_prompt ? "/prompt" : "/scale"),
             phrase("Protocols",
                    "the scale %1 has %2 in block %3 than in block %4, and the responses are "
                    "stored under one name; state the same wording and scale in both, or another "
                    "name")
                 .with(in_quotes(scale.name),
                       is_prompt   ? phrase("Protocols", "another question")
                       : is_labels ? phrase("Protocols", "other labels")
                                   : phrase("Protocols", "other points"),
                       in_quotes(name), in_quotes(known->second.block)));
      }
    }
  }

  const Protocol& protocol_;
  JsonDocument document_;
  std::vector<Diagnostic> found_{};
};

}  // namespace

std::vector<Diagnostic> warnings_about_design(const Protocol& protocol,
                                              const std::string& file_name) {
  return DesignWarnings(protocol, file_name).all();
}

}  // namespace asperity
