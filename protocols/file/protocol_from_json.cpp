// Implements the conversion, key by key in the order of protocol.h. Defaults are those of the struct.

#include "protocols/file/protocol_from_json.h"

#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "protocols/design/block_factors.h"
#include "protocols/file/derived_levels.h"
#include "protocols/file/json_reading.h"
#include "protocols/file/levels_from_json.h"
#include "protocols/file/question_from_json.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

using Block = Protocol::Block;

using nlohmann::json;

/// Calls `visit(name, member)` for every named member except comments.
template <class Visit>
void for_each_named(const json& object, const char* key, const Visit& visit) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  for (const auto& [name, member] : found->items()) {
    if (!name.starts_with("x-") && name != "$comment") visit(name, member);
  }
}

Level level_of(const json& value) {
  return value.is_string() ? Level(value.get<std::string>()) : Level(value.get<double>());
}

std::map<std::string, Level, std::less<>> levels_of(const json& object) {
  std::map<std::string, Level, std::less<>> levels{};
  for (const auto& [name, member] : object.items()) {
    if (!name.starts_with("x-") && name != "$comment") levels[name] = level_of(member);
  }
  return levels;
}

Binding<ParameterValue> parameter_binding(const json& value) {
  Binding<ParameterValue> binding{};
  if (value.is_object()) {
    binding.factor = value.at("factor").get<std::string>();
  } else if (value.is_string()) {
    binding.value = value.get<std::string>();
  } else {
    binding.value = value.get<double>();
  }
  return binding;
}

Protocol::Break break_of(const json& object) {
  Protocol::Break pause{};
  read(object, "minimum_s", pause.minimum_s);
  read(object, "text", pause.text);
  read(object, "zero_force", pause.zero_force);
  return pause;
}

Texture texture_of(const std::string& name, const json& object) {
  Texture texture{};
  texture.name = name;
  read(object, "code", texture.code);
  read(object, "height_field", texture.height_field);
  read(object, "picture", texture.picture);
  read(object, "true_height_field", texture.true_height_field);
  for_each_named(object, "assets", [&](const std::string& role, const json& path) {
    texture.assets[role] = path.get<std::string>();
  });
  read(object, "spacing_m", texture.spacing_m);
  read(object, "note", texture.note);
  if (const auto found = object.find("prior"); found != object.end()) {
    ForceFeatures prior{};
    read(*found, "spectrum", prior.spectrum);
    read(*found, "size", prior.size);
    read(*found, "roughness", prior.roughness);
    texture.prior = prior;
  }
  return texture;
}

glm::dvec3 size_of(const json& object) {
  const json& size = object.at("size_m");
  return {size.at(0).get<double>(), size.at(1).get<double>(), size.at(2).get<double>()};
}

/// nullopt if a size is missing, which the check of meaning reports.
std::optional<Shape> shape_of(const json& object) {
  const auto found = object.find("shape");
  if (found == object.end()) return {};
  const auto shape = found->get<std::string>();
  if (shape == "plate" || shape == "box") {
    if (!object.contains("size_m")) return {};
    if (shape == "plate") return PlateShape{size_of(object)};
    return BoxShape{size_of(object)};
  }
  if (!object.contains("diameter_m")) return {};
  const auto diameter_m = object.at("diameter_m").get<double>();
  if (shape == "sphere") return SphereShape{diameter_m};
  if (shape == "disc") return disc_of(diameter_m);
  if (!object.contains("length_m")) return {};
  return CylinderShape{diameter_m, object.at("length_m").get<double>()};
}

BodyDescription body_of(const std::string& name, const json& object) {
  BodyDescription body{};
  body.name = name;
  read(object, "mesh", body.mesh);
  body.shape = shape_of(object);
  read_choice(object, "axis", body.axis,
              {{"x", BodyAxis::x}, {"y", BodyAxis::y}, {"z", BodyAxis::z}});
  read(object, "texture", body.texture);
  return body;
}

StimulusTemplate stimulus_of(const std::string& name, const json& object) {
  StimulusTemplate stimulus{};
  stimulus.name = name;
  read(object, "model", stimulus.model);
  read(object, "texture", stimulus.texture);
  read(object, "surface", stimulus.surface);
  read(object, "tool", stimulus.tool);
  for_each_named(object, "parameters", [&](const std::string& parameter, const json& value) {
    stimulus.parameters[parameter] = parameter_binding(value);
  });
  if (const auto found = object.find("equal_force"); found != object.end()) {
    EqualForce equal{};
    read(*found, "rms_N", equal.rms_N);
    read(*found, "to_model", equal.to_model);
    read(*found, "band_low_Hz", equal.band_low_Hz);
    read(*found, "band_high_Hz", equal.band_high_Hz);
    stimulus.equal_force = equal;
  }
  if (const auto found = object.find("material"); found != object.end()) {
    read(*found, "stiffness_N_per_m", stimulus.stiffness_N_per_m);
    read(*found, "friction", stimulus.friction);
  }
  return stimulus;
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

Protocol::TrialQuestionTemplate trial_question_of(const json& object, const ExperimentKind& kind) {
  Protocol::TrialQuestionTemplate question{};
  question.form = kind.form;
  if (const auto found = object.find("scale"); found != object.end()) {
    question.form = scale_of(*found);
  }
  if (const auto found = object.find("line"); found != object.end()) {
    LineForm line{};
    read(*found, "longest", line.longest);
    question.form = line;
  }
  if (const auto found = object.find("options"); found != object.end()) {
    for (const json& option : *found) {
      question.words.push_back({option.at("value"), option.at("text")});
    }
  }
  if (const auto found = object.find("tie"); found != object.end()) {
    read(*found, "text", question.tie);
  }
  read(object, "name", question.name);
  read(object, "prompt", question.prompt);
  read(object, "pictures", question.pictures);
  read(object, "reshuffle_pictures", question.reshuffle_pictures);
  read(object, "allow_cannot_tell", question.allow_cannot_tell);
  read(object, "correct_factor", question.correct_factor);
  read(object, "confidence_of", question.confidence_of);
  if (object.contains("judgement")) {
    question.judgement.emplace();
    read_choice(object, "judgement", *question.judgement,
                {{"performance", DiscriminationJudgement::performance},
                 {"comparison", DiscriminationJudgement::comparison}});
  }
  read_choice(object, "asks_for", question.asks_for_less, {{"more", false}, {"less", true}});
  if (object.contains("rates")) {
    question.rates.emplace();
    read_choice(object, "rates", *question.rates,
                {{"dissimilarity", RatedQuantity::dissimilarity},
                 {"similarity", RatedQuantity::similarity}});
  }
  return question;
}

Protocol::Criterion criterion_of(const json& object) {
  Protocol::Criterion criterion{};
  read(object, "correct", criterion.correct);
  read(object, "of_last", criterion.of_last);
  read(object, "maximum_trials", criterion.maximum_trials);
  using OnFailure = Protocol::Criterion::OnFailure;
  read_choice(
      object, "on_failure", criterion.on_failure,
      {{"continue_flagged", OnFailure::continue_flagged}, {"end_session", OnFailure::end_session}});
  return criterion;
}

Arrangement arrangement_of(const json& object) {
  Arrangement arrangement{};
  using Surfaces = Arrangement::Surfaces;
  read_choice(object, "surfaces", arrangement.surfaces,
              {{"sequential", Surfaces::sequential},
               {"side_by_side", Surfaces::side_by_side},
               {"on_request", Surfaces::on_request}});
  if (const auto visits = object.find("visits"); visits != object.end()) {
    read(*visits, "minimum", arrangement.minimum_visits);
    read(*visits, "maximum", arrangement.maximum_visits);
  }
  if (const auto interval = object.find("interval_s"); interval != object.end()) {
    Arrangement::Interval& drawn = arrangement.interval.emplace();
    if (interval->is_number()) {
      drawn.shortest_s = drawn.longest_s = interval->get<double>();
    } else {
      read(*interval, "shortest", drawn.shortest_s);
      read(*interval, "longest", drawn.longest_s);
    }
  }
  if (const auto exposure = object.find("exposure"); exposure != object.end()) {
    read(*exposure, "strokes", arrangement.strokes);
    read(*exposure, "contact_s", arrangement.contact_s);
  }
  read(object, "gap_m", arrangement.gap_m);
  read_choice(object, "axis", arrangement.axis,
              {{"x", Arrangement::Axis::x}, {"y", Arrangement::Axis::y}});
  read_choice(object, "phase", arrangement.draws_phase, {{"fixed", false}, {"drawn", true}});
  return arrangement;
}

/// The question or the questions of a block, and what is stated once for all of them.
void read_questions(const json& object, const ExperimentKind& kind, Block& block) {
  const json* of_trial = &object;
  if (const auto list = object.find("questions"); list != object.end()) {
    block.has_question_list = true;
    for (const json& question : *list) {
      block.questions.push_back(trial_question_of(question, kind));
    }
  } else if (const auto only = object.find("question"); only != object.end()) {
    block.questions.push_back(trial_question_of(*only, kind));
    of_trial = &*only;
  }
  read(*of_trial, "experimenter_prompt", block.experimenter_prompt);
  read(*of_trial, "pictures_after_feeling", block.pictures_after_feeling);
  bool may_revisit = true;
  read(*of_trial, "allow_revisit", may_revisit);
  if (!may_revisit) block.arrangement.maximum_visits = 1;
  read_choice(object, "question_order", block.shuffles_questions,
              {{"fixed", false}, {"shuffle", true}});
  read_choice(object, "question_layout", block.on_one_page,
              {{"one_after_another", false}, {"one_page", true}});
  read(object, "page_prompt", block.page_prompt);
}

Block block_of(const std::string& name, const json& object, const std::string& kind_of_protocol) {
  Block block{};
  block.name = name;
  block.kind = kind_of_protocol;
  read(object, "kind", block.kind);
  const ExperimentKind& kind = kind_of(block);
  if (const auto found = object.find("design"); found != object.end()) {
    block.design = find_design(found->get<std::string>());  // the schema lists their ids
  }
  read_choice(object, "phase", block.phase,
              {{"familiarisation", Phase::familiarisation},
               {"practice", Phase::practice},
               {"main", Phase::main}});
  read(object, "crossed", block.crossed);
  if (const auto found = object.find("listed"); found != object.end()) {
    for (const json& row : *found) block.listed.push_back(levels_of(row));
  }
  if (const auto found = object.find("vary"); found != object.end()) {
    block.vary = dimension_in(*found);
  }
  if (const auto found = object.find("all_pairs"); found != object.end()) {
    block.all_pairs.emplace();
    read(*found, "factor", block.all_pairs->factor);
    read(*found, "in_both_orders", block.all_pairs->in_both_orders);
    read(*found, "with_identical", block.all_pairs->with_identical);
    read(*found, "parts", block.all_pairs->parts);
  }
  if (const auto found = object.find("exclude"); found != object.end()) {
    for (const json& row : *found) block.exclude.push_back(levels_of(row));
  }
  for_each_named(object, "derived", [&](const std::string& factor, const json& formula) {
    block.derived[factor] = formula.get<std::string>();
  });
  read(object, "repetitions", block.repetitions);
  if (const auto found = object.find("repetitions_of"); found != object.end()) {
    for (const json& each : *found) {
      block.repetitions_of.push_back(
          {levels_of(each.at("levels")), each.at("repetitions").get<int>()});
    }
  }
  read(object, "drawn", block.drawn);
  if (const auto found = object.find("anchor"); found != object.end()) {
    block.anchor = levels_of(*found);
  }
  read_choice(object, "order", block.order,
              {{"fixed", Block::Order::fixed},
               {"shuffle", Block::Order::shuffle},
               {"shuffle_within_repetition", Block::Order::shuffle_within_repetition}});
  for_each_named(object, "maximum_in_a_row", [&](const std::string& factor, const json& value) {
    block.maximum_in_a_row[factor] = value.get<int>();
  });
  for_each_named(object, "minimum_distance", [&](const std::string& factor, const json& value) {
    block.minimum_distance[factor] = value.get<int>();
  });
  if (const auto found = object.find("fixed_positions"); found != object.end()) {
    for (const json& each : *found) {
      block.fixed_positions.push_back(
          {each.at("position").get<int>(), levels_of(each.at("levels"))});
    }
  }
  for (const json& member : object.at("presented")) {
    Protocol::Presented presented{};
    presented.role = kind.roles.front();
    read(member, "role", presented.role);
    read(member, "stimulus", presented.stimulus);
    if (const auto with = member.find("with"); with != member.end()) {
      presented.with = levels_of(*with);
    }
    read(member, "item", presented.item);
    block.presented.push_back(std::move(presented));
  }
  if (block.all_pairs && block.presented.size() == 1 && kind.roles.front() == "alternative") {
    block.presented.push_back(block.presented.front());
  }
  read_choice(object, "positions", block.positions,
              {{"as_listed", Block::Positions::as_listed},
               {"shuffle", Block::Positions::shuffle},
               {"balanced", Block::Positions::balanced}});
  read_questions(object, kind, block);
  if (const auto found = object.find("arrangement"); found != object.end()) {
    block.arrangement = arrangement_of(*found);
  }
  if (const auto found = object.find("rove"); found != object.end()) {
    read(*found, "stiffness_N_per_m", block.rove.stiffness_N_per_m);
    read(*found, "friction", block.rove.friction);
    read(*found, "raised_m", block.rove.raised_m);
  }
  if (const auto found = object.find("equal_roughness"); found != object.end()) {
    block.equal_roughness.emplace();
    read(*found, "matched_in", block.equal_roughness->matched_in);
  }
  read(object, "exploration", block.exploration);
  read(object, "pause_before_trial_s", block.pause_before_trial_s);
  read(object, "pause_between_surfaces_s", block.pause_between_surfaces_s);
  read(object, "response_deadline_s", block.response_deadline_s);
  read_choice(object, "feedback", block.feedback,
              {{"none", Block::Feedback::none},
               {"correctness", Block::Feedback::correctness},
               {"correct_answer", Block::Feedback::correct_answer}});
  if (const auto found = object.find("until"); found != object.end()) {
    block.until = criterion_of(*found);
  }
  return block;
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
  read_choice(root, "format", protocol.format,
              {{"asperity.protocol/1", 1}, {"asperity.protocol/2", 2}});
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

void read_senses(const json& environment, Protocol& protocol) {
  read_choice(environment, "vision", protocol.vision,
              {{"free", Vision::free},
               {"hand_occluded", Vision::hand_occluded},
               {"blindfold", Vision::blindfold}});
  if (const auto scene = environment.find("scene"); scene != environment.end()) {
    protocol.scene.emplace();
    read_choice(*scene, "visual_texture", *protocol.scene,
                {{"on", VisualTexture::on},
                 {"off", VisualTexture::off},
                 {"neutral", VisualTexture::neutral}});
  }
  if (const auto pictures = environment.find("pictures"); pictures != environment.end()) {
    read_choice(*pictures, "show", protocol.shows_pictures_in_grey,
                {{"as_they_are", false}, {"grey", true}});
  }
  if (const auto noise = environment.find("masking_noise"); noise != environment.end()) {
    using Kind = Protocol::Noise::Kind;
    read_choice(*noise, "kind", protocol.masking_noise.kind,
                {{"none", Kind::none}, {"white", Kind::white}, {"pink", Kind::pink}});
    read(*noise, "level_dBA", protocol.masking_noise.level_dBA);
  }
  for_each_named(environment, "speech", [&](const std::string& cue, const json& path) {
    protocol.speech[cue] = path.get<std::string>();
  });
}

void read_setting(const json& root, Protocol& protocol) {
  if (const auto found = root.find("environment"); found != root.end()) {
    read_senses(*found, protocol);
  }
  if (const auto found = root.find("device"); found != root.end()) {
    read(*found, "rate_Hz", protocol.rate_Hz);
    read(*found, "force_limit_N", protocol.force_limit_N);
    read(*found, "maximum_missed_deadlines", protocol.maximum_missed_deadlines);
    read(*found, "maximum_lost_records", protocol.maximum_lost_records);
    read(*found, "profile_maximum_age_days", protocol.profile_maximum_age_days);
    read(*found, "refuse_rehearsal_warnings", protocol.refuses_rehearsal_warnings);
    read_choice(*found, "compute", protocol.computes_on_gpu, {{"cpu", false}, {"gpu", true}});
    read(*found, "input_only", protocol.input_only);
    for_each_named(*found, "limits", [&](const std::string& item, const json& limit) {
      protocol.device_limits[item] = limit.get<double>();
    });
  }
  if (const auto found = root.find("instability"); found != root.end()) {
    using OnExcess = InstabilityRule::OnExcess;
    InstabilityRule rule{};
    read(*found, "buzz_max", rule.buzz_max);
    read_choice(*found, "on", rule.on,
                {{"flag", OnExcess::flag}, {"repeat_now", OnExcess::repeat_now}});
    protocol.instability = rule;
  }
  if (const auto found = root.find("surface"); found != root.end()) {
    SurfacePatch& patch = protocol.patch;
    if (const auto centre = found->find("centre_m"); centre != found->end()) {
      patch.centre_m = {centre->at(0), centre->at(1), centre->at(2)};
    }
    if (const auto extent = found->find("extent_m"); extent != found->end()) {
      patch.extent_m = {extent->at(0), extent->at(1)};
    }
    read_choice(
        *found, "tiling", patch.tiling,
        {{"bounded", Tiling::bounded}, {"repeat", Tiling::repeat}, {"mirror", Tiling::mirror}});
    read_choice(*found, "edge", patch.edge, {{"wall", PatchEdge::wall}, {"fade", PatchEdge::fade}});
    read(*found, "edge_width_m", patch.edge_width_m);
    read(*found, "motion_scale", patch.motion_scale);
  }
  if (const auto found = root.find("material"); found != root.end()) {
    read(*found, "stiffness_N_per_m", protocol.material.stiffness_N_per_m);
    read(*found, "friction", protocol.material.friction);
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
