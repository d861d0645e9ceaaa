// The section on the design: tasks, factors, blocks, exploration, questionnaires and what was rendered.

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/overloaded.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/task_words.h"
#include "app/report/text/report_arrangement.h"
#include "app/report/text/report_languages.h"
#include "app/report/text/report_order.h"
#include "app/report/text/report_roughness.h"
#include "app/report/text/report_sections.h"
#include "app/words/text_parts.h"
#include "protocols/design/block_factors.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/course.h"
#include "protocols/plan/plan.h"
#include "protocols/texts/protocol_texts.h"

namespace asperity {

namespace {

std::string factors_text(const Protocol& protocol) {
  std::vector<std::string> factors{};
  for (const auto& [name, factor] : protocol.factors) {
    if (is_varied(protocol, name)) continue;  // described with the task
    std::string meaning = factor.meaning;
    if (meaning.ends_with('.')) meaning.pop_back();
    factors.push_back(factor_text(name, factor) + (meaning.empty() ? "" : ": " + meaning));
  }
  if (factors.empty()) return {};
  std::string text = factors.size() == 1 ? "Factor of the protocol: " : "Factors of the protocol: ";
  for (std::size_t i = 0; i < factors.size(); ++i) text += (i == 0 ? "" : "; ") + factors[i];
  return text + '.';
}

/// The task of every kind of the protocol's blocks, the kind named where there are several.
std::string tasks_text(const Protocol& protocol) {
  const std::vector<const ExperimentKind*> kinds = kinds_of(protocol);
  std::string text{};
  for (const ExperimentKind* const kind : kinds) {
    std::string task = find_analysis(kind->id)->task(protocol);
    constexpr std::string_view kHead = "Task: ";
    if (kinds.size() > 1 && task.starts_with(kHead)) {
      task.replace(0, kHead.size(), "Task of the " + name_of_kind(kind->id) + ": ");
    }
    text += (text.empty() ? "" : " ") + task;
  }
  return text;
}

/// ", with anchors at the start, in the middle and at the end, which are not analysed"; empty without anchors.
std::string anchors_text(const Protocol::Block& block) {
  if (!block.has_anchors()) return {};
  const std::vector<AnchorPlace>& places = block.anchor_places;
  if (places == std::vector{AnchorPlace::start}) return ", after an anchor that is not analysed";
  std::vector<std::string> words{};
  for (const AnchorPlace place : places) {
    words.push_back((place == AnchorPlace::middle ? "in the " : "at the ") +
                    std::string(text_of(place)));
  }
  return places.size() == 1 ? ", with an anchor " + words.front() + ", which is not analysed"
                            : ", with anchors " + listed(words) + ", which are not analysed";
}

ReportList blocks_list(const Protocol& protocol, const ReportFacts& facts) {
  ReportList list{};
  for (const Protocol::Step& step : protocol.flow) {
    const auto* run = std::get_if<Protocol::Run>(&step);
    if (run == nullptr) continue;
    const Protocol::Block& block = protocol.blocks.at(run->block);
    std::string text = "Block " + quoted(block.name) + " (" + text_of(block.phase) + "): ";
    text += order_of_run(protocol, block, *run, Tense::present);
    text += anchors_text(block);
    text += feedback_text(block);
    const auto& questions = block.questions;
    text += questions.size() == 1 ? ". Question: " : ". Questions: ";
    for (std::size_t i = 0; i < questions.size(); ++i) {
      text += (i == 0 ? "" : "; ") + quoted(questions[i].prompt);
      if (questions[i].condition) text += " (asked if " + clause_of(*questions[i].condition) + ")";
      if (questions[i].is_additional) {
        text += " (additional, not analysed)";
      }
    }
    if (std::any_of(questions.begin(), questions.end(), [](const auto& question) {
          return question.allow_cannot_tell && !question.is_additional;
        })) {
      text += " “Cannot tell” is also a response option.";
    }
    if (std::any_of(questions.begin(), questions.end(), [](const auto& question) {
          return question.template own_as<PairQuestion>() != nullptr;
        })) {
      text += " A tie is also a response option.";
    }
    text += arrangement_sentences(block);
    text += presented_trials_text(block, facts);
    text += unmet_text(run->block, facts);
    list.items.push_back(text);
  }
  return list;
}

/// "a scale from 0 to 10", with its article.
std::string form_text(const Question& question) {
  const auto options = [&] { return counted(question.options.size(), "option", "options"); };
  return std::visit(
      Overloaded{[&](const ChoiceForm&) { return "one of " + options(); },
                 [&](const MultipleChoiceForm&) { return "one or more of " + options(); },
                 [](const NumberForm& number) {
                   return "a number" + (number.unit.empty() ? "" : " in " + number.unit);
                 },
                 [](const ScaleForm& scale) {
                   return "a scale from " + number_text(scale.minimum) + " to " +
                          number_text(scale.maximum) +
                          (scale.points == 0 ? ""
                                             : " with " + std::to_string(scale.points) + " points");
                 },
                 [&question](const auto&) { return description_of(question.form).english(); }},
      question.form);
}

/// The questions that the flow asks, with their conditions; no items where it asks none.
ReportList questionnaire_list(const Protocol& protocol) {
  ReportList list{};
  std::set<std::string> asked{};
  for (const Protocol::Step& step : protocol.flow) {
    const auto* const ask = std::get_if<Protocol::Ask>(&step);
    if (ask == nullptr) continue;
    for (const std::string& name : ask->questions) {
      if (!asked.insert(name).second) continue;
      const Question& question = protocol.questions.at(name);
      std::string text = "Question of the questionnaire: " + quoted(question.prompt) + " (" +
                         form_text(question) + (question.optional ? ", optional" : "") + ')';
      if (question.condition) text += ", asked if " + clause_of(*question.condition);
      list.items.push_back(text + '.');
    }
  }
  return list;
}

/// The texts that only some groups of participants read, with the numbers of the first one's plan.
ReportList texts_of_groups(const Protocol& protocol) {
  ReportList list{};
  for (const Protocol::Step& step : protocol.flow) {
    const auto* const screen = std::get_if<Protocol::Screen>(&step);
    if (screen == nullptr || screen->groups.empty()) continue;
    std::vector<std::string> names{};
    for (const std::string& group : screen->groups) names.push_back(quoted(group));
    const DesignValues values = values_of_session(
        protocol, example_plan(protocol, {.seed = 1, .group = screen->groups.front()}));
    std::string text = "Text for the " + std::string(names.size() == 1 ? "group " : "groups ") +
                       listed(names) +
                       " only: " + quoted(with_values(screen->text, values, protocol.language));
    if (screen->condition) text += ", shown if " + clause_of(*screen->condition);
    list.items.push_back(text + '.');
  }
  return list;
}

/// "speed 30 mm/s to 60 mm/s"; nothing for an open band.
void add_band(const std::string& name, const Band& band, const std::string& unit,
              std::vector<std::string>& bands) {
  if (!band.minimum && !band.maximum && !band.target) return;
  std::string text{};
  if (unit.empty()) {  // a number of `name`
    if (band.minimum) text += "at least " + display_quantity(*band.minimum, unit) + ' ';
    if (band.maximum) {
      text += (band.minimum ? "and at most " : "at most ") + display_quantity(*band.maximum, unit) +
              ' ';
    }
    const double last = band.maximum.value_or(band.minimum.value_or(0.0));
    text += last == 1.0 ? name.substr(0, name.size() - 1) : name;  // "1 stroke"
  } else {
    text = name;
    if (band.minimum && band.maximum) {
      text += " from " + display_quantity(*band.minimum, unit) + " to " +
              display_quantity(*band.maximum, unit);
    } else if (band.minimum) {
      text += " of at least " + display_quantity(*band.minimum, unit);
    } else if (band.maximum) {
      text += " of at most " + display_quantity(*band.maximum, unit);
    }
  }
  if (band.target) text += " (target " + display_quantity(*band.target, unit) + ')';
  bands.push_back(text);
}

/// "the force or the speed is outside its band", for the quantities that have a band.
std::string guided_by_tones(const Exploration& exploration) {
  const auto has_band = [](const Band& band) { return band.minimum || band.maximum; };
  const bool force = has_band(exploration.normal_force_N);
  const bool speed = has_band(exploration.speed_m_per_s);
  if (force && speed) return "the force or the speed is outside its band";
  return force   ? "the force is outside its band"
         : speed ? "the speed is outside its band"
                 : "the force or the speed is outside its band (no band is set)";
}

std::string guidance_text(const Exploration& exploration, const ReportFacts& facts) {
  std::string requested{};
  std::string given{};
  switch (exploration.guidance) {
    case Exploration::Guidance::experimenter:
      return {};
    case Exploration::Guidance::bars:
      requested = "bars that show force and speed with their bands";
      given = "Participants were shown the bars";
      break;
    case Exploration::Guidance::moving_target:
      requested =
          "a mark that moves back and forth at the target speed" +
          std::string(exploration.normal_force_N.minimum || exploration.normal_force_N.maximum
                          ? ", and a bar that shows the force with its band"
                          : "");
      given = "Participants were shown the mark";
      break;
    case Exploration::Guidance::tones:
      requested = "tones while " + guided_by_tones(exploration);
      given = "The tones were played";
      break;
  }
  const auto unguided = static_cast<std::size_t>(
      std::count_if(facts.sessions.begin(), facts.sessions.end(),
                    [](const ReportedSession& session) { return session.is_unguided; }));
  const std::size_t all = facts.sessions.size();
  std::string text = " The protocol requests guidance of the hand by " + requested + '.';
  if (unguided < all) {
    text += ' ' + given + ' ' + SessionShare{.whole = all - unguided, .all = all}.text() + '.';
  }
  if (unguided > 0) {
    const bool is_virtual = facts.group == AnswerGroup::virtual_participants;
    const char* const reason = is_virtual ? " (participants are virtual)"
                               : exploration.guidance == Exploration::Guidance::tones
                                   ? " (run at a terminal, or no sound output was available)"
                                   : " (at a terminal)";
    text += " There was no such guidance " +
            SessionShare{.whole = unguided, .all = all}.text_after_not() + reason + '.';
  }
  return text;
}

/// "at most two times", "at most once"
std::string repeats_text(int maximum) {
  return maximum == 1 ? "at most once"
                      : "at most " + count_in_words(static_cast<std::uint64_t>(maximum)) + " times";
}

/// Applies to every response of the protocol to exploration outside its limits.
constexpr const char* kUntouched =
    "; an attempt in which a surface is not touched does not count and is repeated.";
const std::string kLastRepeat =
    std::string("; the last attempt is then flagged and included") + kUntouched;

std::string exploration_text(const Exploration& exploration, const ReportFacts& facts) {
  std::string text = "The protocol requests that each surface be explored " +
                     instructed_exploration(exploration) + '.';
  const auto bounded = [](const Band& band) { return band.minimum || band.maximum; };
  if (exploration.required_fraction_in_band > 0.0) {
    const std::string fraction = display_percent(exploration.required_fraction_in_band);
    if (bounded(exploration.normal_force_N)) {
      text +=
          " The force must be within its band for at least " + fraction + " of the contact time.";
    }
    if (bounded(exploration.speed_m_per_s)) {
      text +=
          " The speed of at least " + fraction +
          " of the strokes (length divided by time, from turn to turn) must be within its band.";
    }
  }
  const bool is_judged_in_part =
      exploration.required_fraction_in_band <= 0.0 &&
      (bounded(exploration.normal_force_N) || bounded(exploration.speed_m_per_s));
  if (is_judged_in_part) {
    text +=
        " The bands of force and speed alone set no limits, because the protocol requires no "
        "minimum proportion of the contact time or of the strokes within them.";
  }
  text += guidance_text(exploration, facts);
  const bool repeats = exploration.maximum_repeats > 0;
  switch (repeats ? exploration.on_failure : Exploration::OnFailure::flag) {
    case Exploration::OnFailure::flag:
      return text +
             " According to the protocol, attempts outside these limits are flagged and included" +
             kUntouched;
    case Exploration::OnFailure::repeat_now:
      return text +
             " According to the protocol, attempts outside these limits are repeated at once, " +
             repeats_text(exploration.maximum_repeats) + kLastRepeat;
    case Exploration::OnFailure::requeue_at_end_of_block:
      return text +
             " According to the protocol, attempts outside these limits are repeated at the end of "
             "the block, " +
             repeats_text(exploration.maximum_repeats) + kLastRepeat;
  }
  return text;
}

/// Of the stored presentations, and the limits of the protocol.
std::string rendering_text(const Protocol& protocol, const ReportFacts& facts) {
  std::string text{};
  if (!facts.models.empty()) {
    std::vector<std::string> models(facts.models.begin(), facts.models.end());
    for (std::string& model : models) {
      if (facts.plugin_builds.contains(model)) model += " (plug-in)";
    }
    text = "Force models of the surfaces presented, with their versions: " + listed(models);
    if (!facts.height_fields.empty()) {
      text +=
          "; height fields: " + listed({facts.height_fields.begin(), facts.height_fields.end()});
    }
    if (!facts.body_textures.empty()) {
      text += "; textures of the bodies: " +
              listed({facts.body_textures.begin(), facts.body_textures.end()});
    }
    if (!facts.points_on_bodies.empty()) {
      text += "; rendered on the surface of a body, at a proxy of the hand: " +
              listed({facts.points_on_bodies.begin(), facts.points_on_bodies.end()});
    }
    text += ". ";
  } else {
    text = "No surface was presented. ";
  }
  text +=
      "According to the protocol, or by default where it does not state a value, the stiffness "
      "was " +
      stiffness_text(facts.stiffness_N_per_m, protocol) + ", the coefficient of friction was " +
      friction_text(facts.friction, protocol) + ", and forces were limited to " +
      display_quantity(protocol.force_limit_N, "N") + '.';
  if (const std::string matched = equal_force_text(facts); !matched.empty()) text += ' ' + matched;
  if (const std::string matched = equal_roughness_text(facts); !matched.empty()) {
    text += ' ' + matched;
  }
  return text;
}

/// "Three surfaces were presented in each answered trial."
std::string surfaces_text(const ReportFacts& facts) {
  if (facts.surfaces.empty()) return {};
  std::string counts{};
  for (const std::size_t count : facts.surfaces) {
    counts += (counts.empty() ? "" : " or ") + count_in_words(count);
  }
  return ' ' + capitalised(counts) +
         (facts.surfaces == std::set<std::size_t>{1} ? " surface was" : " surfaces were") +
         " presented in each answered trial.";
}

std::string counterbalance_text(const Protocol& protocol, const ReportFacts& facts) {
  std::string square{};
  switch (protocol.counterbalance) {
    case Protocol::Counterbalance::none:
      return {};
    case Protocol::Counterbalance::latin:
      square = "Latin";
      break;
    case Protocol::Counterbalance::williams:
      square = "Williams";
      break;
  }
  std::set<int> rows{};
  for (const ReportedSession& session : facts.sessions) rows.insert(session.row.counterbalance_row);
  return " The order of the levels is counterbalanced over sessions by a " + square + " square; " +
         (facts.sessions.size() == 1 ? "the only session uses " : "the sessions use ") +
         display_count(rows.size()) + " of its " + std::to_string(counterbalance_rows(protocol)) +
         " rows.";
}

}  // namespace

std::string factor_text(const std::string& name, const Factor& factor) {
  std::vector<std::string> levels{};
  for (const Level& level : factor.levels) {
    const auto* number = std::get_if<double>(&level);
    levels.push_back(number != nullptr && !factor.unit.empty()
                         ? display_quantity(*number, factor.unit)
                         : text_of(level));
  }
  return (factor.unit.empty() ? name : words_of_parameter(name)) + " (" + listed(levels) + ')';
}

std::string after_failure(const Exploration& exploration) {
  const bool repeats = exploration.maximum_repeats > 0;
  const std::string outside = "attempts outside these limits were ";
  switch (repeats ? exploration.on_failure : Exploration::OnFailure::flag) {
    case Exploration::OnFailure::flag:
      return outside + "flagged and included";
    case Exploration::OnFailure::repeat_now:
      return outside + "repeated at once, " + repeats_text(exploration.maximum_repeats) +
             ", and the last attempt was then included";
    case Exploration::OnFailure::requeue_at_end_of_block:
      return outside + "repeated at the end of the block, " +
             repeats_text(exploration.maximum_repeats) + ", and the last attempt was then included";
  }
  return {};
}

std::string instructed_exploration(const Exploration& exploration) {
  std::vector<std::string> bands{};
  add_band("normal force", exploration.normal_force_N, "N", bands);
  add_band("speed", exploration.speed_m_per_s, "m/s", bands);
  add_band("length of a stroke", exploration.stroke_length_m, "m", bands);
  add_band("strokes", exploration.strokes, "", bands);
  std::string text = "for " + display_quantity(exploration.minimum_contact_s, "s") + " to " +
                     display_quantity(exploration.maximum_contact_s, "s");
  if (!bands.empty()) text += ", with " + listed(bands);
  return text;
}

ReportSection design_section(const ReportFacts& facts) {
  ReportSection section{"Design", {}};
  const ProtocolRow& row = facts.protocol;
  const ProtocolCheck& check = facts.file;
  if (facts.sources.size() > 1) {
    const std::string files = capitalised(count_in_words(facts.sources.size()));
    const std::string languages = languages_text(facts);
    section.parts.emplace_back(
        facts.are_translations
            ? ReportText{files +
                         " texts have the name and version of this protocol. They differ in "
                         "language and texts only; the texts below are from the first." +
                         languages}
            : ReportText{
                  files +
                      " different texts have the name and version of this protocol; "
                      "their responses are pooled, and the description below is from the first." +
                      languages,
                  ReportText::Tone::notice});
  }
  if (!check.protocol) {
    section.parts.emplace_back(ReportText{stopped(
        "The protocol " + row.name + ", version " + row.version + ", is a " + row.kind + " (" +
        row.design + "). This program cannot read its file, which is stored in the study: " +
        (check.diagnostics.empty() ? std::string("the reason is unknown")
                                   : check.diagnostics.front().message.english()))});
    section.parts.emplace_back(ReportText{planned_trials_text(facts) + surfaces_text(facts)});
    return section;
  }
  const Protocol& protocol = *check.protocol;
  if (!protocol.title.empty()) {
    section.parts.emplace_back(ReportText{protocol.title, ReportText::Tone::lead});
  }
  if (!protocol.description.empty())
    section.parts.emplace_back(
        ReportText{"The protocol’s own description: " + protocol.description});
  section.parts.emplace_back(ReportText{tasks_text(protocol) + ' ' + planned_trials_text(facts) +
                                        surfaces_text(facts) +
                                        counterbalance_text(protocol, facts)});
  const std::string factors = factors_text(protocol);
  if (!factors.empty()) section.parts.emplace_back(ReportText{factors});
  section.parts.emplace_back(blocks_list(protocol, facts));
  for (ReportList list : {texts_of_groups(protocol), questionnaire_list(protocol)}) {
    if (!list.items.empty()) section.parts.emplace_back(std::move(list));
  }
  section.parts.emplace_back(ReportText{rendering_text(protocol, facts)});
  for (const auto& [name, exploration] : protocol.explorations) {
    const std::string which =
        protocol.explorations.size() == 1 ? "" : "Exploration " + quoted(name) + ": ";
    section.parts.emplace_back(ReportText{which + exploration_text(exploration, facts)});
  }
  return section;
}

}  // namespace asperity
