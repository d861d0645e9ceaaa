// Implements the warnings about valid protocols.

#include "protocols/warnings/warnings.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "analysis/numbers/rounded_text.h"
#include "protocols/design/block_factors.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/plan/groups.h"
#include "protocols/procedures/procedure.h"
#include "stimuli/properties/other_unit.h"

namespace asperity {

namespace {

// Hands do not explore surfaces faster; m/s and mm/s are easily confused.
constexpr double kFastestHand_m_per_s = 1.0;
// A fraction of the force limit: a greater mean force exceeds the limit at the crests of the texture.
constexpr double kRoomForTexture = 0.8;

class Warnings final {
 public:
  Warnings(const Protocol& protocol, const std::string& file_name)
      : protocol_(protocol), document_(protocol.source, file_name) {}

  std::vector<Diagnostic> all() {
    for (const auto& [name, exploration] : protocol_.explorations) {
      const std::string pointer = pointer_to("/explorations", name);
      warn_of_use(name, pointer);
      warn_of_rule(exploration, pointer);
      warn_of_bands(exploration, pointer);
      warn_of_strokes(exploration, pointer);
    }
    warn_of_words();
    warn_of_groups_without_screen();
    warn_of_comparison();
    for (const auto& [name, block] : protocol_.blocks) {
      warn_of_trained_levels(block);
      warn_of_target(block);
    }
    return std::move(found_);
  }

 private:
  void warn(const std::string& pointer, Phrase message) {
    found_.push_back(document_.at(pointer, std::move(message)));
  }

  void warn_of_use(const std::string& name, const std::string& pointer) {
    const bool is_used =
        std::any_of(protocol_.blocks.begin(), protocol_.blocks.end(), [&](const auto& named) {
          const Binding<std::string>& asked = named.second.exploration;
          if (asked.value) return *asked.value == name;
          const auto factor = protocol_.factors.find(asked.factor);
          return factor != protocol_.factors.end() &&
                 std::any_of(factor->second.levels.begin(), factor->second.levels.end(),
                             [&](const Level& level) { return text_of(level) == name; });
        });
    if (!is_used)
      warn(pointer,
           phrase("Protocols", "no block uses the exploration %1; name it in a block, or remove it")
               .with(in_quotes(name)));
  }

  void warn_of_rule(const Exploration& asked, const std::string& pointer) {
    const bool repeats = asked.on_failure != Exploration::OnFailure::flag;
    if (!repeats || asked.required_fraction_in_band > 0.0) return;
    const auto bounded = [](const Band& band) { return band.minimum || band.maximum; };
    if (!bounded(asked.normal_force_N) && !bounded(asked.speed_m_per_s)) return;
    warn(pointer + "/on_failure",
         phrase("Protocols",
                "no trial is repeated because of its force or speed while %1 is 0: state the "
                "fraction that has to lie in the bands, such as %2")
             .with(key_name("required_fraction_in_band"), digits(0.6)));
  }

  void warn_of_bands(const Exploration& asked, const std::string& pointer) {
    const auto look = [&](const std::optional<double>& value, double most, const char* place,
                          const auto& sentence_about) {
      if (!value || *value <= most) return false;
      warn(pointer + place, sentence_about(*value));
      return true;
    };
    const auto no_hand = [](double value) {
      const auto is_permitted = [](double other) { return other <= kFastestHand_m_per_s; };
      return phrase("Protocols", "%1 m/s is faster than a hand strokes; request a slower stroke%2")
          .with(digits(value), meant_in_other_unit(value, "m/s", is_permitted));
    };
    const Band& speed = asked.speed_m_per_s;
    if (!look(speed.minimum, kFastestHand_m_per_s, "/speed_m_per_s/minimum", no_hand)) {
      look(speed.target, kFastestHand_m_per_s, "/speed_m_per_s/target", no_hand);
    }
    const double most_N = kRoomForTexture * protocol_.force_limit_N;
    const auto no_room = [&](double value) {
      return phrase("Protocols",
                    "%1 N leaves little room below the device's limit of %2 N: a texture's crests "
                    "exceed it and are clipped; set %3 N or less, or raise %4")
          .with(digits(value), digits(protocol_.force_limit_N), digits(most_N),
                place_name("/device/force_limit_N"));
    };
    const Band& force = asked.normal_force_N;
    if (!look(force.minimum, most_N, "/normal_force_N/minimum", no_room)) {
      look(force.target, most_N, "/normal_force_N/target", no_room);
    }
  }

  /// Compares the maximum contact time with the minimum number of strokes, as short and as fast as permitted, and with
  /// the target number at the target length and speed.
  void warn_of_strokes(const Exploration& asked, const std::string& pointer) {
    const auto first = [](std::initializer_list<std::optional<double>> values) {
      for (const std::optional<double>& value : values) {
        if (value) return value;
      }
      return std::optional<double>{};
    };
    const Band& length = asked.stroke_length_m;
    const Band& speed = asked.speed_m_per_s;
    const auto look = [&](const std::optional<double>& strokes, std::optional<double> length_m,
                          std::optional<double> speed_m_per_s, const char* place) {
      if (!strokes || !length_m || !speed_m_per_s || *speed_m_per_s <= 0.0) return false;
      const double takes_s = *strokes * *length_m / *speed_m_per_s;
      if (takes_s <= asked.maximum_contact_s) return false;
      warn(pointer + place,
           (*strokes == 1.0
                ? phrase("Protocols",
                         "%1 stroke of %2 m at %3 m/s does not fit into the %4 s after which the "
                         "surface is removed; raise %5, or request fewer strokes")
                : phrase("Protocols",
                         "%1 strokes of %2 m at %3 m/s do not fit into the %4 s after which the "
                         "surface is removed; raise %5, or request fewer strokes"))
               .with(digits(*strokes), digits(*length_m), digits(*speed_m_per_s),
                     digits(asked.maximum_contact_s), key_name("maximum_contact_s")));
      return true;
    };
    if (look(asked.strokes.minimum, first({length.minimum, length.target}),
             first({speed.maximum, speed.target}), "/strokes/minimum")) {
      return;
    }
    look(asked.strokes.target, first({length.target, length.minimum}),
         first({speed.target, speed.maximum}), "/strokes/target");
  }

  /// Warns about a text that mentions what is neither shown nor heard.
  void warn_of_words() {
    using Guidance = Exploration::Guidance;
    bool by_sight = false;
    bool by_tones = false;
    for (const auto& [name, exploration] : protocol_.explorations) {
      by_tones = by_tones || exploration.guidance == Guidance::tones;
      by_sight = by_sight || exploration.guidance == Guidance::bars ||
                 exploration.guidance == Guidance::moving_target;
    }
    if (by_sight == by_tones) return;
    const std::set<std::string_view> absent =
        by_tones ? std::set<std::string_view>{"bar", "bars"}
                 : std::set<std::string_view>{"tone", "tones", "beep", "beeps"};
    const Phrase mentioned =
        by_tones ? phrase("Protocols",
                          "the text mentions %1, but the hand is guided by tones, and no bar is "
                          "shown; change the text or the guidance")
                 : phrase("Protocols",
                          "the text mentions %1, but the hand is guided by sight, and no tone is "
                          "played; change the text or the guidance");
    const auto look = [&](const std::string& text, const std::string& pointer) {
      std::string word{};
      for (const char c : text + ' ') {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
          word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
          continue;
        }
        if (absent.contains(word)) return warn(pointer, mentioned.with(in_quotes(word)));
        word.clear();
      }
    };
    for (std::size_t i = 0; i < protocol_.flow.size(); ++i) {
      if (const auto* screen = std::get_if<Protocol::Screen>(&protocol_.flow[i])) {
        look(screen->text, pointer_to("/flow", i) + "/screen");
      }
    }
    const std::vector<std::string> again =
        protocol_.resume.screens.value_or(std::vector<std::string>{});
    for (std::size_t i = 0; i < again.size(); ++i) {
      look(again[i], pointer_to("/resume/screens", i));
    }
  }

  /// Whether the participants of a group read a screen.
  bool has_screen(const std::string& group) const {
    return std::ranges::any_of(protocol_.flow, [&group](const Protocol::Step& step) {
      const auto* const screen = std::get_if<Protocol::Screen>(&step);
      return screen != nullptr && is_for_group(screen->groups, group);
    });
  }

  /// Warns of groups that read nothing while others read a screen.
  void warn_of_groups_without_screen() {
    const std::vector<std::string> groups = groups_of(protocol_);
    std::vector<std::string> without{};
    std::ranges::copy_if(groups, std::back_inserter(without),
                         [this](const std::string& group) { return !has_screen(group); });
    if (without.size() == groups.size()) return;
    for (const std::string& group : without) {
      warn("/flow", phrase("Protocols",
                           "participants of the group %1 read no screen, while those of another "
                           "group do: add a screen for them")
                        .with(in_quotes(group)));
    }
  }

  /// Warns about staircases that do not approach the point that is estimated.
  void warn_of_target(const Protocol::Block& block) {
    const Protocol::TrialQuestionTemplate* const judged = judged_question(block);
    if (judged == nullptr || judged->judgement() != DiscriminationJudgement::comparison ||
        !block.procedure || block.procedure->tracks.empty() ||
        !problems_of(block.procedure->tracks.front()).empty() ||
        !chooses_levels_from_answers(block)) {
      return;
    }
    const ProcedureSettings& first = block.procedure->tracks.front();
    const std::optional<double> stated = procedure_of(first).target(first);
    if (!stated || std::abs(*stated - 0.5) < 0.01) return;
    const double target = *stated;
    warn(pointer_to("/blocks", block.name) + "/procedure/method",
         phrase("Protocols",
                "the levels converge on %1 %, but the point of subjective equality lies at 50 %: "
                "state a rule with equal numbers of responses and steps in both directions (%2: 1, "
                "%3: 1), or constant stimuli")
             .with(digits(std::round(1000.0 * target) / 10.0), key_name("down"), key_name("up")));
  }

  /// Warns about feedback at levels at which thresholds are measured.
  void warn_of_trained_levels(const Protocol::Block& practice) {
    if (practice.phase == Phase::main || practice.feedback == Protocol::Block::Feedback::none ||
        !practice.vary) {
      return;
    }
    const std::vector<double> trained = practice.vary->values();
    for (const auto& [name, block] : protocol_.blocks) {
      if (block.phase != Phase::main || !block.vary || block.kind != discrimination_kind().id ||
          block.vary->parameter != practice.vary->parameter) {
        continue;
      }
      const std::vector<double> measured = block.vary->values();
      const std::vector<double> levels = practice.vary->levels();
      std::vector<Phrase> both{};
      for (std::size_t i = 0; i < trained.size(); ++i) {
        // Levels of a grid are sums of steps, and need not be equal to the digits in a file.
        const bool is_measured = std::any_of(measured.begin(), measured.end(), [&](double value) {
          return std::abs(value - trained[i]) <= 1e-9 * std::abs(trained[i]);
        });
        if (is_measured) both.emplace_back(rounded_text(levels[i]));
      }
      if (both.empty()) continue;
      return warn(
          pointer_to("/blocks", practice.name) + "/vary",
          (both.size() == 1
               ? phrase("Protocols",
                        "participants practise with feedback at the level %1, which the block %2 "
                        "measures; practise at levels between or beyond those that are measured")
               : phrase("Protocols",
                        "participants practise with feedback at the levels %1, which the block %2 "
                        "measures; practise at levels between or beyond those that are measured"))
              .with(joined_by_and(both), in_quotes(name)));
    }
  }

  /// Warns about a selection whose analysis answers a different question than the levels of one parameter suggest.
  void warn_of_comparison() {
    const std::optional<std::string> parameter =
        stored_protocol(protocol_.source).compared_parameter;
    if (!parameter) return;
    const auto block =
        std::find_if(protocol_.blocks.begin(), protocol_.blocks.end(),
                     [](const auto& named) { return named.second.phase == Phase::main; });
    if (block == protocol_.blocks.end()) return;
    warn(pointer_to("/blocks", block->first) + "/presented",
         phrase("Protocols",
                "the alternatives differ in %1 alone: the analysis of a selection tests how often "
                "each level is chosen, not whether levels can be discriminated; for a threshold, "
                "use a block of the kind %2")
             .with(in_quotes(*parameter), in_quotes(discrimination_kind().id)));
  }

  const Protocol& protocol_;
  JsonDocument document_;
  std::vector<Diagnostic> found_{};
};

}  // namespace

std::vector<Diagnostic> warnings_about(const Protocol& protocol, const std::string& file_name) {
  return Warnings(protocol, file_name).all();
}

}  // namespace asperity
