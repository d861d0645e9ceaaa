#include "protocols/file/block_from_json.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "protocols/design/block_factors.h"
#include "protocols/file/json_reading.h"
#include "protocols/file/levels_from_json.h"
#include "protocols/file/question_from_json.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {

namespace {

using Block = Protocol::Block;
using nlohmann::json;

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

}  // namespace

Protocol::Block block_of(const std::string& name, const nlohmann::json& object,
                         const std::string& kind_of_protocol) {
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
  if (const auto found = object.find("anchor_pair"); found != object.end()) {
    for (const json& level : *found) block.anchor_pair.push_back(level_of(level));
  }
  if (const auto found = object.find("anchor_at"); found != object.end()) {
    block.anchor_places.clear();
    for (const AnchorPlace place : {AnchorPlace::start, AnchorPlace::middle, AnchorPlace::end}) {
      if (std::find(found->begin(), found->end(), text_of(place)) != found->end()) {
        block.anchor_places.push_back(place);
      }
    }
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

}  // namespace asperity
