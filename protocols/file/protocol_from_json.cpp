// Implements the conversion, key by key in the order of protocol.h. Defaults are those of the struct.

#include "protocols/file/protocol_from_json.h"

#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "protocols/design/block_factors.h"
#include "protocols/file/block_from_json.h"
#include "protocols/file/derived_levels.h"
#include "protocols/file/json_reading.h"
#include "protocols/file/levels_from_json.h"
#include "protocols/file/question_from_json.h"
#include "protocols/file/setting_from_json.h"
#include "protocols/file/stimulus_from_json.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

using nlohmann::json;

Protocol::Break break_of(const json& object) {
  Protocol::Break pause{};
  read(object, "minimum_s", pause.minimum_s);
  read(object, "text", pause.text);
  read(object, "zero_force", pause.zero_force);
  if (const auto found = object.find("drift_check"); found != object.end()) {
    pause.drift_check.emplace();
    read(*found, "text", pause.drift_check->text);
    read(*found, "tip_text", pause.drift_check->tip_text);
    read(*found, "duration_s", pause.drift_check->duration_s);
  }
  return pause;
}

Exploration exploration_of(const std::string& name, const json& object) {
  Exploration exploration{};
  exploration.name = name;
  read(object, "direction_rad", exploration.direction_rad);
  read(object, "stroke_length_m", exploration.stroke_length_m);
  read(object, "speed_m_per_s", exploration.speed_m_per_s);
  read(object, "normal_force_N", exploration.normal_force_N);
  read(object, "strokes", exploration.strokes);
  read(object, "minimum_contact_s", exploration.minimum_contact_s);
  read(object, "maximum_contact_s", exploration.maximum_contact_s);
  read(object, "required_fraction_in_band", exploration.required_fraction_in_band);
  using OnFailure = Exploration::OnFailure;
  read_choice(object, "on_failure", exploration.on_failure,
              {{"flag", OnFailure::flag},
               {"repeat_now", OnFailure::repeat_now},
               {"requeue_at_end_of_block", OnFailure::requeue_at_end_of_block}});
  read(object, "maximum_repeats", exploration.maximum_repeats);
  using Guidance = Exploration::Guidance;
  read_choice(object, "guidance", exploration.guidance,
              {{"experimenter", Guidance::experimenter},
               {"bars", Guidance::bars},
               {"moving_target", Guidance::moving_target},
               {"tones", Guidance::tones}});
  return exploration;
}

Protocol::Step step_of(const json& object) {
  if (const auto found = object.find("screen"); found != object.end()) {
    Protocol::Screen screen{.text = found->get<std::string>()};
    screen.condition = condition_in(object);
    return screen;
  }
  if (object.contains("check")) {
    Protocol::Check check{};
    read_choice(object, "check", check.what,
                {{"device", Protocol::Check::What::device},
                 {"force_zero", Protocol::Check::What::force_zero}});
    return check;
  }
  if (const auto found = object.find("break"); found != object.end()) return break_of(*found);
  if (object.contains("ask")) {
    Protocol::Ask ask{};
    read(object, "ask", ask.questions);
    return ask;
  }
  Protocol::Run run{};
  read(object, "run", run.block);
  read(object, "for_each", run.for_each);
  read(object, "break_every_trials", run.break_every_trials);
  double minutes = 0.0;
  read(object, "break_every_contact_minutes", minutes);
  run.break_every_contact_s = 60.0 * minutes;
  if (const auto found = object.find("pause"); found != object.end()) run.pause = break_of(*found);
  return run;
}

void read_head(const json& root, Protocol& protocol) {
  read(root, "kind", protocol.kind);
  read_choice(root, "design", protocol.design,
              {{"chapter", ProtocolDesign::chapter}, {"improved", ProtocolDesign::improved}});
  read(root, "name", protocol.name);
  read(root, "version", protocol.version);
  read(root, "title", protocol.title);
  read(root, "language", protocol.language);
  read(root, "description", protocol.description);
  if (const auto found = root.find("authors"); found != root.end()) {
    for (const json& author : *found) protocol.authors.push_back(author.at("name"));
  }
  read(root, "license", protocol.license);
  read(root, "instructions", protocol.instructions);
  protocol.consent_version = root.at("consent").at("version");
  protocol.consent_statement = root.at("consent").at("statement");
  if (root.contains("realism_standard")) {
    protocol.realism_standard.emplace();
    read_choice(root, "realism_standard", *protocol.realism_standard,
                {{"photograph", RealismStandard::photograph},
                 {"physical_sample", RealismStandard::physical_sample},
                 {"memory", RealismStandard::memory}});
  }
}

void read_observer(const json& root, Protocol& protocol) {
  if (const auto found = root.find("observer"); found != root.end()) {
    ObserverDeclaration& observer = protocol.observer;
    using Expectation = ObserverDeclaration::Expectation;
    read_choice(*found, "expectation", observer.expectation,
                {{"none", Expectation::none},
                 {"true_surface", Expectation::true_surface},
                 {"prior", Expectation::prior}});
    read(*found, "gaussian_wavelength_m", observer.gaussian_wavelength_m);
    read(*found, "deaf", observer.deaf);
    read(*found, "feature_noise", observer.feature_noise);
    read(*found, "position_bias", observer.position_bias);
    read(*found, "lapse", observer.lapse);
    using MagnitudeOf = ObserverDeclaration::MagnitudeOf;
    read_choice(*found, "effect", observer.magnitude_decreases,
                {{"increases", false}, {"decreases", true}});
    read_choice(*found, "magnitude_of", observer.magnitude_of,
                {{"lateral_force", MagnitudeOf::lateral_force},
                 {"normal_force", MagnitudeOf::normal_force},
                 {"held_tool", MagnitudeOf::held_tool},
                 {"compliance", MagnitudeOf::compliance}});
    read(*found, "exponent", observer.exponent);
    read(*found, "yes_above", observer.yes_above);
    read(*found, "different_above", observer.different_above);
    read(*found, "unsure_within", observer.unsure_within);
  }
  if (const auto found = root.find("recording"); found != root.end()) {
    read(*found, "every_tick", protocol.record);
  }
  protocol.analysis = analysis_declared_in(root);
  protocol.estimation = estimation_declared_in(root);
}

}  // namespace

Protocol protocol_from_json(const json& root, const std::vector<ModelDeclaration>& models) {
  Protocol protocol{};
  read_head(root, protocol);
  read_setting(root, protocol);
  for_each_named(root, "textures", [&](const std::string& name, const json& member) {
    protocol.textures[name] = texture_of(name, member);
  });
  for_each_named(root, "bodies", [&](const std::string& name, const json& member) {
    protocol.bodies[name] = body_of(name, member);
  });
  for_each_named(root, "stimuli", [&](const std::string& name, const json& member) {
    protocol.stimuli[name] = stimulus_of(name, member);
  });
  for_each_named(root, "factors", [&](const std::string& name, const json& member) {
    Factor factor{};
    factor.name = name;
    read(member, "meaning", factor.meaning);
    read(member, "unit", factor.unit);
    for (const json& level : member.at("levels")) factor.levels.push_back(level_of(level));
    protocol.factors[name] = std::move(factor);
  });
  for_each_named(root, "explorations", [&](const std::string& name, const json& member) {
    protocol.explorations[name] = exploration_of(name, member);
  });
  for_each_named(root, "questions", [&](const std::string& name, const json& member) {
    protocol.questions[name] = question_of(name, member);
  });
  for_each_named(root, "blocks", [&](const std::string& name, const json& member) {
    protocol.blocks[name] = block_of(name, member, protocol.kind);
  });
  std::set<std::string> factors_of_file{};
  for (const auto& [name, factor] : protocol.factors) factors_of_file.insert(name);
  for (auto& [name, block] : protocol.blocks) {
    if (!block.vary) continue;
    complete_dimension(block, protocol, models);
    const json& object = root.at("blocks").at(name);
    if (const auto found = object.find("procedure"); found != object.end()) {
      block.procedure = procedure_in(*found, *block.vary, *block.design);
      const auto* const judged = judged_question(block);
      if (judged != nullptr && judged->allow_cannot_tell && block.design->alternatives() > 0) {
        declare_unforced(block.design->alternatives(), block.procedure->tracks);
      }
    }
    declare_dimension(block, protocol, factors_of_file);
  }
  for (const auto& [name, block] : protocol.blocks) {
    declare_derived(block, protocol, factors_of_file);
  }
  for (const json& step : root.at("flow")) protocol.flow.push_back(step_of(step));
  if (const auto found = root.find("resume"); found != root.end()) {
    if (const auto screens = found->find("screens"); screens != found->end()) {
      protocol.resume.screens = screens->get<std::vector<std::string>>();
    }
    read(*found, "maximum_age_hours", protocol.resume.maximum_age_hours);
    read(*found, "practice_trials", protocol.resume.practice_trials);
  }
  read_choice(root, "counterbalance", protocol.counterbalance,
              {{"none", Protocol::Counterbalance::none},
               {"latin", Protocol::Counterbalance::latin},
               {"williams", Protocol::Counterbalance::williams}});
  if (const auto found = root.find("groups"); found != root.end()) {
    using Assignment = Protocol::Groups::Assignment;
    protocol.groups.emplace();
    read(*found, "factor", protocol.groups->factor);
    read_choice(*found, "assigned", protocol.groups->assigned,
                {{"balanced", Assignment::balanced},
                 {"permuted_blocks", Assignment::permuted_blocks},
                 {"by_experimenter", Assignment::by_experimenter}});
    read(*found, "block_sizes", protocol.groups->block_sizes);
    read(*found, "seed", protocol.groups->seed);
  }
  if (const auto found = root.find("participants"); found != root.end()) {
    read(*found, "planned", protocol.planned_participants);
    read(*found, "sessions", protocol.sessions);
    if (const auto asked = found->find("questions"); asked != found->end()) {
      for (const json& name : *asked) {
        const auto question = protocol.questions.find(name.get<std::string>());
        if (question != protocol.questions.end()) {
          protocol.participant_questions.push_back(question->second);
        }
      }
    }
  }
  read_observer(root, protocol);
  return protocol;
}

}  // namespace asperity
