// Compares the statements of texts for participants with what the protocol and its plan contain.

#include "protocols/warnings/text_warnings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

#include "protocols/design/block_factors.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/plan/course.h"
#include "protocols/plan/groups.h"
#include "protocols/texts/protocol_texts.h"
#include "protocols/texts/stated_numbers.h"

namespace asperity {

namespace {

using Numbers = std::map<std::string, std::set<int>, std::less<>>;

void add_values(Numbers& numbers, const DesignValues& values) {
  for (const auto& [name, value] : values) {
    if (value.names.empty()) numbers[name].insert(value.number);
  }
}

/// Surfaces that differ in a stimulus.
int distinct_surfaces(const Protocol& protocol, const Plan& plan, bool of_main) {
  std::set<std::string> names{};
  for (const Trial& trial : plan.trials) {
    if (of_main && protocol.blocks.at(trial.block).phase != Phase::main) continue;
    for (const PlannedPresentation& each : trial.presentations) names.insert(each.stimulus.name);
  }
  return static_cast<int>(names.size());
}

bool has_scale(const Protocol& protocol, bool without_points) {
  const auto fits = [without_points](const ScaleForm& scale) {
    return !without_points || !scale.points;
  };
  for (const auto& [name, question] : protocol.questions) {
    const auto* const scale = std::get_if<ScaleForm>(&question.form);
    if (scale != nullptr && fits(*scale)) return true;
  }
  for (const auto& [name, block] : protocol.blocks) {
    for (const auto& question : block.questions) {
      const auto* const scale = std::get_if<ScaleForm>(&question.form);
      if (scale != nullptr && fits(*scale)) return true;
      if (without_points && std::holds_alternative<LineForm>(question.form)) return true;
    }
  }
  return false;
}

template <class Test>
bool any_block(const Protocol& protocol, const Test& test) {
  return std::any_of(protocol.blocks.begin(), protocol.blocks.end(),
                     [&test](const auto& named) { return test(named.second); });
}

bool is_prepared(const Protocol& protocol) {
  return any_block(protocol, [](const auto& block) { return block.phase != Phase::main; });
}

bool has_breaks(const Protocol& protocol) {
  return std::any_of(protocol.flow.begin(), protocol.flow.end(), [](const Protocol::Step& step) {
    const auto* const run = std::get_if<Protocol::Run>(&step);
    return std::holds_alternative<Protocol::Break>(step) || (run != nullptr && run->pause);
  });
}

bool permits_cannot_tell(const Protocol& protocol) {
  return any_block(protocol, [](const auto& block) {
    return std::any_of(block.questions.begin(), block.questions.end(),
                       [](const auto& each) { return each.allow_cannot_tell; });
  });
}

using Phrases = std::span<const std::string_view>;

/// A part of a design that texts mention.
struct Part {
  Phrases english{};
  Phrases german{};
  bool (*is_there)(const Protocol& protocol) = nullptr;
  Phrase otherwise{};  ///< what the protocol lacks
};

// Phrases with which instructions mention a part; a word alone occurs in other senses ("in practice", "photosensitive").
constexpr std::array<std::string_view, 3> kScaleEn{"on the scale", "on each scale", "scales"};
constexpr std::array<std::string_view, 3> kScaleDe{"auf der skala", "auf jeder skala", "skalen"};
constexpr std::array<std::string_view, 2> kLineEn{"mark on the line", "answer on the line"};
constexpr std::array<std::string_view, 3> kLineDe{"dann auf der linie", "sie auf der linie",
                                                  "sie es auf der linie"};
constexpr std::array<std::string_view, 3> kFamiliarEn{"become familiar", "familiarisation",
                                                      "familiarization"};
constexpr std::array<std::string_view, 3> kFamiliarDe{"aufgabe kennenzulernen",
                                                      "vertraut zu machen", "eingewöhnung"};
constexpr std::array<std::string_view, 3> kPractiseEn{"practise the task", "practice trial*",
                                                      "practice block"};
constexpr std::array<std::string_view, 3> kPractiseDe{"üben sie die aufgabe", "übungsdurchg*",
                                                      "in der übung"};
constexpr std::array<std::string_view, 3> kPictureEn{"the picture", "pictures", "the photograph"};
constexpr std::array<std::string_view, 4> kPictureDe{"das bild", "bilder", "bildern", "das foto"};
// Participants may take a break at any time, which is no break of the flow.
constexpr std::array<std::string_view, 3> kBreakEn{"there is a break", "will be a break",
                                                   "will be breaks"};
constexpr std::array<std::string_view, 2> kBreakDe{"gibt es eine pause", "gibt es pausen"};
constexpr std::array<std::string_view, 3> kMaskEn{"eye mask", "the blindfold", "blindfolded"};
constexpr std::array<std::string_view, 3> kMaskDe{"augenbinde", "augenmaske", "schlafmaske"};
constexpr std::array<std::string_view, 1> kCannotTellEn{"i cannot tell"};
constexpr std::array<std::string_view, 1> kCannotTellDe{"ich kann es nicht sagen"};

const std::vector<Part>& parts() {
  static const Phrase kUnprepared =
      phrase("Protocols", "there is no block of familiarisation or practice");
  static const std::vector<Part> kParts{
      {kScaleEn, kScaleDe, [](const Protocol& each) { return has_scale(each, false); },
       phrase("Protocols", "no question has a scale")},
      {kLineEn, kLineDe, [](const Protocol& each) { return has_scale(each, true); },
       phrase("Protocols", "no question is answered on a line")},
      {kFamiliarEn, kFamiliarDe, is_prepared, kUnprepared},
      {kPractiseEn, kPractiseDe, is_prepared, kUnprepared},
      {kPictureEn, kPictureDe, has_pictures, phrase("Protocols", "no picture is shown")},
      {kBreakEn, kBreakDe, has_breaks, phrase("Protocols", "the flow has no break")},
      {kMaskEn, kMaskDe,
       [](const Protocol& each) {
         return each.vision == Vision::blindfold ||
                any_block(each, [](const auto& block) { return block.pictures_after_feeling; });
       },
       phrase("Protocols", "no eye mask is worn (%1)").with(place_name("/environment/vision"))},
      {kCannotTellEn, kCannotTellDe, permits_cannot_tell,
       phrase("Protocols", "no question has this option (%1)")
           .with(key_name("allow_cannot_tell"))}};
  return kParts;
}

// Of a sentence whose minutes are those of the session, and of one whose minutes may be those of a break.
constexpr std::array<std::string_view, 8> kSessions{
    "session*", "experiment*", "study", "sitzung*", "studie", "versuch", "insgesamt", "in all"};
constexpr std::array<std::string_view, 4> kRests{"break*", "rest", "pause*", "ruhen"};

/// Whether what a text calls so is one of `parts()`, or its number is not known (breaks).
bool is_named_as_part(std::string_view name) {
  return name == "scales" || name == "pictures" || name == "breaks";
}

/// Collects what texts can state, and compares them.
class TextWarnings final {
 public:
  TextWarnings(const Protocol& protocol, const std::string& file_name, const Plan& example)
      : protocol_(protocol),
        example_(example),
        document_(protocol.source, file_name),
        has_single_surfaces_(
            !any_block(protocol, [](const auto& block) { return surfaces_in_trial(block) > 1; })) {}

  std::vector<Diagnostic> all() {
    gather_session();
    for (const TextPlace& place : participant_texts(document_.root(), protocol_)) {
      // A question of the questionnaire is about anything.
      if (place.pointer.starts_with("/questions/")) continue;
      compare_numbers(place);
      if (!place.pointer.starts_with("/consent/")) compare_parts(place);
    }
    return std::move(found_);
  }

 private:
  void gather_session() {
    const DesignValues values = values_of_session(protocol_, example_);
    add_values(session_, values);
    for (const auto& [name, block] : protocol_.blocks) {
      add_values(session_, values_of_block(protocol_, block));
    }
    if (has_single_surfaces_) {
      for (const bool of_main : {true, false}) {
        session_["surfaces"].insert(distinct_surfaces(protocol_, example_, of_main));
      }
    }
    int scales = 0;
    for (const Protocol::Step& step : protocol_.flow) {
      if (const auto* const run = std::get_if<Protocol::Run>(&step)) add_run(*run);
      const auto* const ask = std::get_if<Protocol::Ask>(&step);
      if (ask == nullptr) continue;
      session_["questions"].insert(static_cast<int>(ask->questions.size()));
      for (const std::string& name : ask->questions) {
        if (protocol_.questions.at(name).is_answered_by<ScaleForm>()) ++scales;
      }
    }
    if (scales > 0) session_["scales"].insert(scales);
    const auto of = [&values](const char* name) {
      const auto found = values.find(name);
      return found == values.end() ? 0 : found->second.number;
    };
    session_["trials"].insert(of("trials") + of("practice_trials"));
    if (!values.contains("breaks")) session_.erase("breaks");
  }

  struct Minutes {
    int estimate = 0;
    int largest = 0;
  };
  Minutes minutes_of(const Plan& plan) const {
    return {.estimate = static_cast<int>(std::lround(cost_of(protocol_, plan).total_s / 60.0)),
            .largest = values_of_session(protocol_, plan).at("minutes").number};
  }
  /// Of a participant who reads the text: plans of groups differ in the screens that are read.
  Minutes minutes_at(const TextPlace& place) const {
    const bool is_for_first =
        place.groups.empty() || is_for_group(place.groups, groups_of(protocol_).front());
    return minutes_of(is_for_first
                          ? example_
                          : example_plan(protocol_, {.seed = 1, .group = place.groups.front()}));
  }

  /// The trials and surfaces of one run of a block, and its breaks.
  void add_run(const Protocol::Run& run) {
    std::map<int, std::pair<int, int>> sizes{};  // trials and surfaces by ordinal
    std::set<std::string> stimuli{};
    for (const Trial& trial : example_.trials) {
      if (trial.block != run.block) continue;
      auto& [trials, surfaces] = sizes[trial.block_ordinal];
      ++trials;
      surfaces += static_cast<int>(trial.presentations.size());
      for (const PlannedPresentation& each : trial.presentations)
        stimuli.insert(each.stimulus.name);
    }
    int all = 0;
    const bool is_main = protocol_.blocks.at(run.block).phase == Phase::main;
    for (const auto& [ordinal, size] : sizes) {
      all += size.first;
      session_["trials"].insert(size.first);
      if (!is_main) session_["practice_trials"].insert(size.first);
      if (has_single_surfaces_) session_["surfaces"].insert(size.second);
    }
    session_["trials"].insert(all);
    if (has_single_surfaces_) session_["surfaces"].insert(static_cast<int>(stimuli.size()));
    session_["blocks"].insert(static_cast<int>(sizes.size()));
    if (run.break_every_trials > 0) session_["trials"].insert(run.break_every_trials);
  }

  /// Also where the design has none of them, which compare_parts names.
  bool is_of_design(const Numbers& numbers, const StatedNumber& stated,
                    const TextPlace& place) const {
    if (stated.name == "minutes") {
      if (phrase_in(stated.sentence, kSessions).empty()) return true;  // of a part, or of a stroke
      if (!phrase_in(stated.sentence, kRests).empty()) return true;
      const Minutes minutes = minutes_at(place);
      return 3 * stated.number >= 2 * minutes.estimate && 3 * stated.number <= 4 * minutes.largest;
    }
    // "Two surfaces are the same": not how many there are.
    if (stated.name == "surfaces" && stated.begins_clause) return true;
    const auto known = numbers.find(stated.name);
    if (known == numbers.end() || known->second.empty()) return is_named_as_part(stated.name);
    return std::any_of(known->second.begin(), known->second.end(), [&stated](int number) {
      return stated.is_about ? 10 * std::abs(stated.number - number) <= number
                             : stated.number == number;
    });
  }

  void compare_numbers(const TextPlace& place) {
    Numbers numbers = session_;
    if (place.block != nullptr) {
      const DesignValues values = values_of_block(protocol_, *place.block);
      for (const char* const name : {"surfaces", "scales", "options", "pictures", "questions"}) {
        numbers[name].clear();
      }
      add_values(numbers, values);
    }
    for (const StatedNumber& stated : numbers_stated_in(place.text, protocol_.language)) {
      if (is_of_design(numbers, stated, place)) continue;
      warn(place, phrase("Protocols", "the text states %1, but %2")
                      .with(in_quotes(stated.words), design_states(numbers, stated, place)));
    }
  }

  /// "the number of scales is 4; correct the text, or write {scales}"
  Phrase design_states(const Numbers& numbers, const StatedNumber& stated,
                       const TextPlace& place) const {
    const Phrase or_placeholder =
        phrase("Protocols", ", or write %1").with('{' + std::string(stated.name) + '}');
    if (stated.name == "minutes") {
      return phrase("Protocols", "a session takes about %1 minutes by estimate; correct the text%2")
          .with(std::to_string(minutes_at(place).estimate),
                place.is_of_session ? or_placeholder : Phrase());
    }
    const DesignNumber& design = *find_design_number(stated.name);
    const auto known = numbers.find(stated.name);
    std::vector<Phrase> all{};
    if (known != numbers.end()) {
      for (const int number : known->second) all.emplace_back(std::to_string(number));
    }
    if (all.empty()) {
      return phrase("Protocols", "the design has no %1; correct the text").with(noun_of(design));
    }
    const bool can_be_replaced =
        all.size() == 1 && (place.is_of_session || design.scope == NumberScope::block);
    return phrase("Protocols", "the number of %1 is %2; correct the text%3")
        .with(noun_of(design), joined_by_or(all), can_be_replaced ? or_placeholder : Phrase());
  }

  void compare_parts(const TextPlace& place) {
    const bool is_german = is_language(protocol_.language, "de");
    if (!is_german && !is_language(protocol_.language, "en")) return;
    std::set<std::string> said{};
    for (const Part& part : parts()) {
      if (part.is_there(protocol_)) continue;
      const std::string words = phrase_in(place.text, is_german ? part.german : part.english);
      if (words.empty() || !said.insert(part.otherwise.english()).second) continue;
      warn(place, phrase("Protocols", "the text mentions %1, but %2; change the text or the design")
                      .with(in_quotes(words), part.otherwise));
    }
  }

  void warn(const TextPlace& place, Phrase message) {
    found_.push_back(document_.at(place.pointer, std::move(message)));
  }

  const Protocol& protocol_;
  const Plan& example_;
  JsonDocument document_;
  /// No trial compares surfaces: their number in a text can then be that of a run or of the study.
  bool has_single_surfaces_ = false;
  Numbers session_{};
  std::vector<Diagnostic> found_{};
};

}  // namespace

bool has_pictures(const Protocol& protocol) {
  return protocol.realism_standard == RealismStandard::photograph ||
         any_block(protocol, [](const auto& block) {
           return std::any_of(block.questions.begin(), block.questions.end(),
                              [](const auto& each) { return !each.pictures.empty(); });
         });
}

std::vector<Diagnostic> warnings_about_texts(const Protocol& protocol, const std::string& file_name,
                                             const Plan& example) {
  return TextWarnings(protocol, file_name, example).all();
}

}  // namespace asperity
