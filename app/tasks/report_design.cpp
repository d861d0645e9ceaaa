// What was asked, with what, in which order, as the protocol's file says it.

#include <algorithm>
#include <map>
#include <set>

#include "app/analyses/reading_number.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/report_sections.h"

namespace asperity {

namespace {

std::string quoted(const std::string& text) { return "“" + text + "”"; }

std::string task_text(const Protocol& protocol) {
  switch (protocol.kind) {
    case ProtocolKind::selection: {
      std::string text =
          "In each trial participants felt several renderings of one texture and chose the most "
          "realistic one";
      if (!protocol.realism_standard) return text + '.';
      switch (*protocol.realism_standard) {
        case RealismStandard::photograph:
          return text + ", measured against the texture’s picture, which was shown.";
        case RealismStandard::physical_sample:
          return text + ", measured against a physical sample that lay before them.";
        case RealismStandard::memory:
          return text + ", measured against their own idea of the material.";
      }
      return text + '.';
    }
    case ProtocolKind::matching:
      return "In each trial participants felt several textures and gave each one of as many "
             "pictures.";
    case ProtocolKind::recognition:
      return "In each trial participants felt one texture and chose, among pictures, the one that "
             "it was.";
    case ProtocolKind::magnitude:
      return "In each trial participants felt one surface and gave it a number for how rough it "
             "felt "
             "(absolute magnitude estimation with free modulus).";
  }
  return {};
}

/// What people are asked to wear and to hear; nothing else of it could be done to virtual ones.
std::string senses_asked_of_people(const Protocol& protocol) {
  std::vector<std::string> asked{};
  if (protocol.vision == Vision::hand_occluded)
    asked.emplace_back("that their hand is out of sight");
  if (protocol.vision == Vision::blindfold) asked.emplace_back("an eye mask");
  if (protocol.masking_noise.kind != Protocol::Noise::Kind::none) {
    asked.emplace_back("noise that masks the sound of the device");
  }
  const std::string asks =
      asked.empty() ? "" : "Of people the protocol asks " + listed(asked) + "; v";
  return (asks.empty() ? "V" : asks) + "irtual participants neither see nor hear.";
}

std::string senses_text(const Protocol& protocol) {
  std::string text{};
  switch (protocol.vision) {
    case Vision::free:
      text = "They saw the screen, the device and their hand";
      break;
    case Vision::hand_occluded:
      text = "They saw the screen, but not their hand";
      break;
    case Vision::blindfold:
      text = "They wore an eye mask while they felt";
      break;
  }
  const Protocol::Noise& noise = protocol.masking_noise;
  switch (noise.kind) {
    case Protocol::Noise::Kind::none:
      return text + "; no noise masked the sound of the device.";
    case Protocol::Noise::Kind::white:
      text += "; white noise";
      break;
    case Protocol::Noise::Kind::pink:
      text += "; pink noise";
      break;
  }
  if (noise.level_dBA) text += " of " + reading_number(*noise.level_dBA) + " dBA at the ear";
  return text + " masked the sound of the device.";
}

std::string factors_text(const Protocol& protocol) {
  std::vector<std::string> factors{};
  for (const auto& [name, factor] : protocol.factors) {
    std::vector<std::string> levels{};
    for (const Level& level : factor.levels) levels.push_back(text_of(level));
    std::string text = name + " (" + listed(levels);
    if (!factor.unit.empty()) text += ' ' + factor.unit;
    text += ')';
    std::string meaning = factor.meaning;
    if (meaning.ends_with('.')) meaning.pop_back();
    if (!meaning.empty()) text += ": " + meaning;
    factors.push_back(text);
  }
  if (factors.empty()) return {};
  std::string text = factors.size() == 1 ? "Factor: " : "Factors: ";
  for (std::size_t i = 0; i < factors.size(); ++i) text += (i == 0 ? "" : "; ") + factors[i];
  return text + '.';
}

std::string order_text(const Protocol::Block& block) {
  std::string text{};
  switch (block.order) {
    case Protocol::Block::Order::fixed:
      text = "in fixed order";
      break;
    case Protocol::Block::Order::shuffle:
      text = "in random order";
      break;
    case Protocol::Block::Order::shuffle_within_repetition:
      text = "in random order within each repetition";
      break;
  }
  if (block.presented.size() < 2) return text;
  switch (block.positions) {
    case Protocol::Block::Positions::as_listed:
      return text + ", the surfaces of a trial always in the same places";
    case Protocol::Block::Positions::shuffle:
      return text + ", the surfaces of a trial in random places";
    case Protocol::Block::Positions::balanced:
      return text + ", the places of the surfaces balanced over the trials";
  }
  return text;
}

ReportList blocks_list(const Protocol& protocol) {
  ReportList list{};
  for (const Protocol::Step& step : protocol.flow) {
    const auto* run = std::get_if<Protocol::Run>(&step);
    if (run == nullptr) continue;
    const Protocol::Block& block = protocol.blocks.at(run->block);
    std::string text = "Block " + quoted(block.name) + " (" + text_of(block.phase) + "): ";
    text += order_text(block);
    if (block.repetitions > 1) text += ", " + std::to_string(block.repetitions) + " repetitions";
    if (!run->for_each.empty()) text += ", once for each level of " + run->for_each;
    if (!block.anchor.empty()) text += ", after an anchor that is not analysed";
    text += ". Question: " + quoted(block.question.prompt);
    if (block.question.allow_cannot_tell) text += " “Cannot tell” was an answer, too.";
    if (!block.question.allow_revisit) text += " Surfaces could not be felt again.";
    list.items.push_back(text);
  }
  return list;
}

/// "speed 30 mm/s to 60 mm/s"; nothing for an open band.
void add_band(const std::string& name, const Band& band, const std::string& unit,
              std::vector<std::string>& bands) {
  if (!band.minimum && !band.maximum && !band.target) return;
  std::string text = name;
  if (band.minimum) text += " from " + reading_quantity(*band.minimum, unit);
  if (band.maximum) text += " up to " + reading_quantity(*band.maximum, unit);
  if (band.target) text += " (aiming at " + reading_quantity(*band.target, unit) + ')';
  bands.push_back(text);
}

std::string guidance_text(const Exploration& exploration, const ReportFacts& facts) {
  if (exploration.guidance == Exploration::Guidance::experimenter) return {};
  const auto unguided = static_cast<std::uint64_t>(
      std::count_if(facts.sessions.begin(), facts.sessions.end(),
                    [](const ReportedSession& session) { return session.is_unguided; }));
  const std::string nobody =
      " (a virtual participant, a person at a terminal, or no sound output).";
  if (unguided > 0 && unguided == facts.sessions.size()) {
    return " The protocol guides the hand by what participants see or hear of force and speed, but "
           "nobody saw or heard it" +
           nobody;
  }
  std::string text{};
  switch (exploration.guidance) {
    case Exploration::Guidance::experimenter:
      break;
    case Exploration::Guidance::bars:
      text = " Participants saw force and speed as bars with their bands.";
      break;
    case Exploration::Guidance::moving_target:
      text = " Participants followed a mark that moved to and fro at the speed aimed at" +
             std::string(exploration.normal_force_N.minimum || exploration.normal_force_N.maximum
                             ? ", and saw the force as a bar with its band."
                             : ".");
      break;
    case Exploration::Guidance::tones:
      text = " Tones told participants when force or speed left their bands.";
      break;
  }
  if (unguided == 0) return text;
  return text + " Not so in " + reading_count(unguided) + " of " +
         reading_count(facts.sessions.size()) + " sessions, in which nobody saw or heard it" +
         nobody;
}

std::string exploration_text(const Exploration& exploration, const ReportFacts& facts) {
  std::vector<std::string> bands{};
  add_band("normal force", exploration.normal_force_N, "N", bands);
  add_band("speed", exploration.speed_m_per_s, "m/s", bands);
  add_band("length of a stroke", exploration.stroke_length_m, "m", bands);
  add_band("strokes", exploration.strokes, "", bands);
  std::string text = "Each surface was to be felt for " +
                     reading_quantity(exploration.minimum_contact_s, "s") + " to " +
                     reading_quantity(exploration.maximum_contact_s, "s");
  if (!bands.empty()) text += ", with " + listed(bands);
  text += '.';
  if (exploration.required_fraction_in_band > 0.0) {
    const std::string share = reading_percent(exploration.required_fraction_in_band);
    const auto bounded = [](const Band& band) { return band.minimum || band.maximum; };
    if (bounded(exploration.normal_force_N)) {
      text += " The force had to lie in its band for " + share + " of the contact time.";
    }
    if (bounded(exploration.speed_m_per_s)) {
      text += " The speed of " + share +
              " of the strokes (length divided by time, from turn to turn) had to lie in its band.";
    }
  }
  text += guidance_text(exploration, facts);
  switch (exploration.on_failure) {
    case Exploration::OnFailure::flag:
      return text + " Attempts that were not explored so are flagged and count.";
    case Exploration::OnFailure::repeat_now:
      return text + " Attempts that were not explored so were repeated at once, up to " +
             count_in_words(static_cast<std::uint64_t>(exploration.maximum_repeats)) + " times.";
    case Exploration::OnFailure::requeue_at_end_of_block:
      return text +
             " Attempts that were not explored so were asked again at the end of the block, up "
             "to " +
             count_in_words(static_cast<std::uint64_t>(exploration.maximum_repeats)) + " times.";
  }
  return text;
}

std::string rendering_text(const Protocol& protocol, const ReportFacts& facts) {
  std::string text{};
  if (!facts.models.empty()) {
    text = "The surfaces were rendered with " + listed({facts.models.begin(), facts.models.end()}) +
           " (force model and its version)";
    std::vector<std::string> textures{};
    for (const auto& [name, texture] : protocol.textures) {
      if (texture.height_field) textures.push_back(name);
    }
    if (!textures.empty()) text += ", from height fields of " + listed(textures);
    text += ". ";
  }
  text += "Their stiffness is " + reading_quantity(protocol.material.stiffness_N_per_m, "N/m") +
          ", and no force is stronger than " + reading_quantity(protocol.force_limit_N, "N") + '.';
  const bool equal =
      std::any_of(protocol.stimuli.begin(), protocol.stimuli.end(),
                  [](const auto& named) { return named.second.equal_force.has_value(); });
  if (equal) {
    text +=
        " The models were made equal in the RMS of their texture force along a prescribed "
        "path.";
  }
  return text;
}

std::string trials_text(const ReportFacts& facts) {
  std::set<int> main_trials{};
  std::set<int> planned{};
  for (const ReportedSession& session : facts.sessions) {
    main_trials.insert(session.main_trials);
    planned.insert(session.planned_trials);
  }
  const auto range = [](const std::set<int>& counts) {
    return *counts.begin() == *counts.rbegin()
               ? std::to_string(*counts.begin())
               : std::to_string(*counts.begin()) + " to " + std::to_string(*counts.rbegin());
  };
  if (planned.empty()) return {};
  std::string text = "A session has " + range(main_trials) +
                     (main_trials == std::set<int>{1} ? " trial" : " trials") + " that count";
  if (planned != main_trials) {
    text += ", of " + range(planned) + " with " +
            (facts.has_anchors() ? "familiarisation, practice and anchors"
                                 : "familiarisation and practice");
  }
  text += '.';
  if (!facts.surfaces.empty()) {
    std::vector<std::string> counts{};
    for (const std::size_t count : facts.surfaces) counts.push_back(count_in_words(count));
    text += ' ' + capitalised(listed(counts)) +
            (facts.surfaces == std::set<std::size_t>{1} ? " surface was" : " surfaces were") +
            " felt in each.";
  }
  return text;
}

std::string counterbalance_text(const Protocol& protocol) {
  switch (protocol.counterbalance) {
    case Protocol::Counterbalance::none:
      return {};
    case Protocol::Counterbalance::latin:
      return " The order of the levels was counterbalanced over participants by a Latin square.";
    case Protocol::Counterbalance::williams:
      return " The order of the levels was counterbalanced over participants by a Williams square.";
  }
  return {};
}

}  // namespace

ReportSection design_section(const ReportFacts& facts) {
  ReportSection section{"Design", {}};
  const ProtocolRow& row = facts.protocol;
  const ProtocolCheck check =
      check_protocol_text(row.source, row.name, built_in_models(), std::nullopt, std::nullopt);
  if (facts.sources.size() > 1) {
    section.parts.emplace_back(
        ReportText{count_in_words(facts.sources.size()) +
                       " different files carry the name and version of this protocol; their "
                       "answers are counted together, and what follows is from the first.",
                   ReportText::Tone::notice});
  }
  if (!check.protocol) {
    section.parts.emplace_back(ReportText{stopped(
        "The protocol " + row.name + ", version " + row.version + ", is a " + row.kind + " (" +
        row.design + "). This program cannot read its file, which is stored in the study: " +
        (check.diagnostics.empty() ? std::string("it says nothing")
                                   : check.diagnostics.front().message))});
    section.parts.emplace_back(ReportText{trials_text(facts)});
    return section;
  }
  const Protocol& protocol = *check.protocol;
  if (!protocol.title.empty()) {
    section.parts.emplace_back(ReportText{protocol.title, ReportText::Tone::lead});
  }
  if (!protocol.description.empty()) section.parts.emplace_back(ReportText{protocol.description});
  section.parts.emplace_back(
      ReportText{task_text(protocol) + ' ' + trials_text(facts) + counterbalance_text(protocol)});
  const std::string factors = factors_text(protocol);
  if (!factors.empty()) section.parts.emplace_back(ReportText{factors});
  section.parts.emplace_back(blocks_list(protocol));
  section.parts.emplace_back(ReportText{rendering_text(protocol, facts) + ' ' +
                                        (facts.group == AnswerGroup::virtual_participants
                                             ? senses_asked_of_people(protocol)
                                             : senses_text(protocol))});
  for (const auto& [name, exploration] : protocol.explorations) {
    const std::string which =
        protocol.explorations.size() == 1 ? "" : "Exploration " + quoted(name) + ": ";
    section.parts.emplace_back(ReportText{which + exploration_text(exploration, facts)});
  }
  return section;
}

}  // namespace asperity
