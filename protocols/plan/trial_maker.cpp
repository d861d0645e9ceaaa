// Implements the making of one trial: stimuli resolved from factors, options, correct responses.

#include "protocols/plan/trial_maker.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/arranged_patches.h"
#include "protocols/plan/roughness_matching.h"

namespace asperity {

using Block = Protocol::Block;

namespace {

const Level& presented_level(const FactorLevels& factors, const FactorLevels& with,
                             const std::string& name) {
  const auto own = with.find(name);
  return own == with.end() ? factors.at(name) : own->second;
}

std::string resolved(const Binding<std::string>& binding, const FactorLevels& factors,
                     const FactorLevels& with) {
  if (binding.value) return *binding.value;
  return binding.factor.empty() ? std::string{}
                                : text_of(presented_level(factors, with, binding.factor));
}

/// A body of the protocol with the paths of its files. `texture` is applied to a body without one.
std::optional<BodyDescription> planned_body(const Protocol& protocol, const std::string& name,
                                            const std::string& texture) {
  if (name.empty()) return {};
  BodyDescription body = protocol.bodies.at(name);
  if (!body.mesh && !body.texture && !texture.empty()) body.texture = texture;
  if (body.texture) body.height_field = protocol.textures.at(*body.texture).height_field;
  return body;
}

/// What a surface counts as where the protocol does not name it.
std::string counted_item_of(const Protocol& protocol, const Block& block,
                            const Protocol::Presented& presented, const FactorLevels& factors,
                            const PlannedPresentation& planned) {
  const ExperimentKind& kind = kind_of(block);
  // A standard is not one of the items.
  const bool is_item = kind.item_factor != nullptr && presented.role == kind.roles.front();
  const std::string factor = is_item ? kind.item_factor(protocol) : std::string();
  if (presented.with.contains(factor) || factors.contains(factor)) {
    return text_of(presented_level(factors, presented.with, factor));
  }
  return kind.item_of(planned);
}

PlannedPresentation presentation_of(const Protocol& protocol, const Block& block,
                                    const Protocol::Presented& presented,
                                    const FactorLevels& factors) {
  const StimulusTemplate& source = protocol.stimuli.at(presented.stimulus);
  PlannedPresentation planned{};
  planned.role = presented.role;
  planned.stimulus_template = source.name;
  planned.stimulus.model = resolved(source.model, factors, presented.with);
  planned.stimulus.texture = resolved(source.texture, factors, presented.with);
  planned.stimulus.name = source.name;
  const std::string surface = resolved(source.surface, factors, presented.with);
  const std::string tool = resolved(source.tool, factors, presented.with);
  for (const std::string& part : {planned.stimulus.texture, planned.stimulus.model,
                                  source.surface.factor.empty() ? std::string{} : surface,
                                  source.tool.factor.empty() ? std::string{} : tool}) {
    if (!part.empty()) planned.stimulus.name += "_" + part;
  }
  if (!planned.stimulus.texture.empty()) {
    planned.stimulus.height_field = protocol.textures.at(planned.stimulus.texture).height_field;
    planned.stimulus.declared_assets = protocol.textures.at(planned.stimulus.texture).assets;
  }
  // A point model, which has no tool, renders the texture itself.
  planned.stimulus.surface =
      planned_body(protocol, surface, tool.empty() ? std::string{} : planned.stimulus.texture);
  planned.stimulus.tool = planned_body(protocol, tool, {});
  for (const auto& [name, binding] : source.parameters) {
    if (binding.value) {
      planned.stimulus.parameters[name] = *binding.value;
    } else {
      const Level& level = presented_level(factors, presented.with, binding.factor);
      planned.stimulus.parameters[name] = level;
      planned.stimulus.name += "_" + text_of(level);
    }
  }
  if (block.vary && block.vary->role == presented.role) {
    const Level& level = factors.at(block.vary->factor);
    if (block.vary->is_relative_amplitude()) {
      planned.stimulus.relative_amplitude = std::get<double>(level);
    } else {
      planned.stimulus.parameters[block.vary->parameter] = level;
    }
    planned.stimulus.name += "_" + text_of(level);
  }
  planned.stimulus.material = {
      .stiffness_N_per_m = source.stiffness_N_per_m.value_or(protocol.material.stiffness_N_per_m),
      .friction = source.friction.value_or(protocol.material.friction)};
  planned.has_own_material = source.stiffness_N_per_m || source.friction;
  planned.stimulus.patch = protocol.patch;
  planned.equal_force = source.equal_force;
  planned.item = presented.item.empty()
                     ? counted_item_of(protocol, block, presented, factors, planned)
                     : presented.item;
  return planned;
}

std::string place_code(std::size_t index) { return std::string(1, static_cast<char>('A' + index)); }

/// Uniform over many periods of every texture.
glm::dvec2 drawn_origin_m(Random random) {
  constexpr double kRange_m = 1.0;
  const double x_m = kRange_m * random.uniform();
  return {x_m, kRange_m * random.uniform()};
}

void rove(const Roving& roving, const Random& random, PlannedPresentation& planned) {
  const auto drawn = [&random](const std::vector<double>& levels, const char* what) {
    return levels[static_cast<std::size_t>(random.split(what).below(levels.size()))];
  };
  Material& material = planned.stimulus.material;
  if (!roving.stiffness_N_per_m.empty()) {
    material.stiffness_N_per_m = drawn(roving.stiffness_N_per_m, "stiffness_N_per_m");
    planned.has_own_material = true;
  }
  if (!roving.friction.empty()) {
    material.friction = drawn(roving.friction, "friction");
    planned.has_own_material = true;
  }
  if (!roving.raised_m.empty()) planned.patch.centre_m.z += drawn(roving.raised_m, "raised_m");
}

std::string with_code(std::string prompt, const std::string& code) {
  constexpr std::string_view kPlaceholder = "{code}";
  for (std::size_t at = prompt.find(kPlaceholder); at != std::string::npos;
       at = prompt.find(kPlaceholder, at + code.size())) {
    prompt.replace(at, kPlaceholder.size(), code);
  }
  return prompt;
}

/// The texture of the first surface, where it has one.
const Texture* texture_of(const Protocol& protocol, const Trial& trial) {
  const auto texture = protocol.textures.find(trial.presentations.front().stimulus.texture);
  return texture == protocol.textures.end() ? nullptr : &texture->second;
}

Question planned_question(const Protocol& protocol, const Protocol::TrialQuestionTemplate& source,
                          const Trial& trial, const std::vector<std::string>& pictures) {
  Question question = static_cast<const Question&>(source);  // the part that is asked
  question.options.clear();
  if (!has_options(question.form)) return question;
  if (!source.options.empty()) {
    for (Option option : source.options) {
      option.label = std::to_string(question.options.size() + 1);
      question.options.push_back(std::move(option));
    }
  } else if (pictures.empty()) {
    for (const PlannedPresentation& planned : trial.presentations) {
      question.options.push_back({planned.item, planned.code, std::nullopt, {}});
    }
    if (const auto* const pair = source.own_as<PairQuestion>()) {
      const std::string label = std::to_string(question.options.size() + 1);
      question.options.push_back({kTieOption, label, std::nullopt, pair->tie});
    }
  } else {
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      question.options.push_back(
          {pictures[i], std::to_string(i + 1), protocol.textures.at(pictures[i]).picture, {}});
    }
  }
  if (source.allow_cannot_tell) {
    question.options.push_back({kCannotTellOption, "I cannot tell", std::nullopt, {}});
  }
  const ExperimentKind& kind = kind_named(trial.kind);
  if (kind.correct_of != nullptr && !question.is_additional)
    question.correct = kind.correct_of(source, trial);
  return question;
}

}  // namespace

std::vector<Level> balanced_draws(const std::vector<Level>& levels, std::size_t count,
                                  Random random) {
  std::vector<Level> draws{};
  while (draws.size() < count) {
    std::vector<Level> round = levels;
    random.shuffle(std::span<Level>(round));
    const std::size_t wanted = std::min(round.size(), count - draws.size());
    draws.insert(draws.end(), round.begin(), round.begin() + static_cast<std::ptrdiff_t>(wanted));
  }
  return draws;
}

namespace {

std::vector<Protocol::Presented> surfaces_of_type(const Block& block, const DesignTrial& type) {
  std::vector<Protocol::Presented> surfaces{};
  for (const std::string_view role : type.roles) {
    if (role.empty()) continue;
    const auto has_role = [role](const Protocol::Presented& each) { return each.role == role; };
    const auto listed = std::find_if(block.presented.begin(), block.presented.end(), has_role);
    const bool is_second = std::any_of(surfaces.begin(), surfaces.end(), has_role);
    surfaces.push_back(*listed);
    if (is_second) surfaces.back().item = std::string(role) + "_2";
  }
  return surfaces;
}

}  // namespace

std::vector<Protocol::Presented> surfaces_of(const Block& block, const BlockRow& row) {
  if (row.type != nullptr) return surfaces_of_type(block, *row.type);
  std::vector<Protocol::Presented> surfaces = block.presented;
  for (std::size_t i = 0; i < row.pair.size(); ++i) {
    surfaces[i].with[block.all_pairs->factor] = row.pair[i];
    surfaces[i].item = text_of(row.pair[i]);
  }
  return surfaces;
}

Trial TrialMaker::make(Trial trial, const BlockRun& run,
                       const std::vector<Protocol::Presented>& surfaces,
                       const Random& of_trial) const {
  const Block& block = *run.block;
  trial.block = block.name;
  trial.kind = block.kind;
  trial.block_ordinal = run.ordinal;
  trial.phase = block.phase;
  const std::vector<SurfacePatch> patches =
      arranged_patches(protocol_->patch, block.arrangement, surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    trial.presentations.push_back(presentation_of(*protocol_, block, surfaces[i], trial.factors));
    PlannedPresentation& planned = trial.presentations.back();
    if (block.equal_roughness && !run.matches.empty()) apply_match(run.matches, planned);
    planned.position = static_cast<int>(i) + 1;
    planned.code = place_code(i);
    planned.patch = patches[i];
    if (block.arrangement.draws_phase) {
      planned.patch.texture_origin_m = drawn_origin_m(of_trial.split("phase").split(i));
    }
    rove(block.rove, of_trial.split("rove").split(i), planned);
  }
  const Texture* const texture = texture_of(*protocol_, trial);
  trial.experimenter_prompt = texture == nullptr
                                  ? block.experimenter_prompt
                                  : with_code(block.experimenter_prompt, texture->code);
  // Roughness is matched to a surface that is felt, and the picture is the standard of another question.
  if (texture != nullptr && !matches_roughness(*protocol_, block) &&
      protocol_->realism_standard == RealismStandard::photograph) {
    trial.standard_picture = texture->picture;
  }
  trial.arrangement = block.arrangement;
  trial.flat = protocol_->material;
  trial.pictures_after_feeling = block.pictures_after_feeling;
  for (const Protocol::TrialQuestionTemplate& question : block.questions) {
    // The first question has the stream that it had when it was the only one.
    const Random of_question = trial.questions.empty() ? of_trial : of_trial.split(question.name);
    trial.questions.push_back(
        planned_question(*protocol_, question, trial, pictures_of(question, of_question)));
  }
  trial.on_one_page = block.on_one_page;
  trial.page_prompt = block.page_prompt;
  if (block.shuffles_questions) {
    Random order = of_trial.split("question order");
    order.shuffle(std::span<Question>(trial.questions));
  }
  return trial;
}

/// Questions with the same pictures show them at the same positions, unless they are reshuffled.
std::vector<std::string> TrialMaker::pictures_of(const Protocol::TrialQuestionTemplate& question,
                                                 Random of_trial) const {
  std::vector<std::string> pictures = question.pictures;
  std::sort(pictures.begin(), pictures.end());
  if (question.reshuffle_pictures) {
    of_trial.shuffle(std::span<std::string>(pictures));
  } else {
    Random of_session = of_session_.split("pictures of the session");
    for (const std::string& picture : pictures) of_session = of_session.split(picture);
    of_session.shuffle(std::span<std::string>(pictures));
  }
  return pictures;
}

}  // namespace asperity
