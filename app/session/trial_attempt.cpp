// Presents the surfaces in their arrangement, waits for contact and answers, and judges the records.

#include "app/session/trial_attempt.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/session/attempt_measures.h"
#include "app/session/layout.h"
#include "app/session/response_rows.h"
#include "app/session/rig/clock.h"
#include "app/session/rig/recording_columns.h"
#include "app/session/rig/stroke_count.h"
#include "app/session/session_setup.h"
#include "app/session/sound/masking_sound.h"
#include "app/study_files/parameter_json.h"
#include "app/words/coded_phrases.h"
#include "app/words/reason.h"
#include "renderers/servo/contact.h"

namespace asperity {

namespace {

// A virtual hand explores slightly longer than the protocol's minimum, as participants do.
constexpr double kBeyondMinimum = 1.25;
constexpr double kSlice_s = SessionCourse::kSlice_s;
// From the wish to lift to the end of the contact.
constexpr double kLifting_s = 0.3;
// A tick that has not returned for so long since a standstill is not waited for any longer.
constexpr double kForLateTick_s = 0.2;
// A surface that is not touched is given up this long after the longest contact.
constexpr double kPatience_s = 5.0;
// The ratio of two numbers for one stimulus above which a confirmation is required: a typing error
// is likely.
constexpr double kDoubtfulRatio = 10.0;
// After these repeats the attempt is kept and flagged: a surface that vibrates every time does not end the session.
constexpr int kMostRepeatsForBuzz = 2;

std::optional<std::int64_t> first_contact_ns(const std::vector<PresentationRow>& surfaces) {
  std::optional<std::int64_t> first_ns{};
  for (const PresentationRow& surface : surfaces) {
    if (surface.contact_ns)
      first_ns = std::min(first_ns.value_or(*surface.contact_ns), *surface.contact_ns);
  }
  return first_ns;
}

/// Empty where the exploration complied with the protocol.
Phrase failed_measures(std::span<const ComplianceRow> rows) {
  Phrase failures{};
  for (const ComplianceRow& row : rows) {
    if (row.passed.value_or(true)) continue;
    failures = with_comma(failures, failed_measure(row.quantity, row.position));
  }
  return failures;
}

}  // namespace

TrialAttempt::TrialAttempt(SessionCourse& course, TrialSurfaces surfaces, const AttemptOrder& order)
    : course_(course),
      order_(order),
      trial_(order.trial),
      block_(course.protocol().blocks.at(order.trial.block)),
      waiting_([&course](double duration_s) { course.wait(duration_s); }),
      surfaces_(std::move(surfaces)),
      visits_(order.trial.presentations.size(), course.protocol().rate_Hz,
              judged_force_of(course.rig().capability())) {
  const Layout layout{course.row().mirrored};
  exploration_ = layout.of(exploration_of(course.protocol(), trial_));
  patch_ = layout.of(course.protocol().patch);
  row_.trial = trial_.ordinal;
  row_.attempt = order.attempt;
  row_.segment = order.segment;
  row_.purpose = order.purpose;
}

TrialAttempt::~TrialAttempt() = default;

AttemptRow TrialAttempt::make() {
  prepare();
  row_.onset_ns = course_.now_ns();
  course_.begin_attempt();
  try {
    carry_out();
  } catch (const Interruption& caught) {
    interruption_ = caught;
  } catch (const RespondentGone& gone) {
    interruption_ = Interruption{AttemptOutcome::aborted, gone.said()};
  }
  row_.offset_ns = course_.now_ns();
  course_.set_guiding_tones(false);  // no guidance once the surface is removed
  if (interruption_) take_surface_away();
  if (interruption_ && interruption_->fault == Fault::standstill) {
    const bool hangs_in_driver = hanging_tick_ && !hanging_tick_->rendering;
    course_.report_to_experimenter(
        hangs_in_driver
            ? "The servo loop stalled for more than 50 ms: zero force was requested, but the "
              "driver "
              "does not respond. If the handle still exerts a force, switch the device off."
            : "The servo loop stalled for more than 50 ms: the force was set to zero.");
  }
  course_.set_masking(false);
  course_.update([](SessionSnapshot& snapshot) {
    snapshot.surface = 0;
    snapshot.contact_s = 0.0;
    snapshot.wanted_contact_s = 0.0;
  });

  Rig& rig = course_.rig();
  const Recorder::Attempt recorded = course_.recorder().finish(rig.records());
  row_.recording = recorded.recording;
  row_.servo =
      servo_quality_of(recorded.records, course_.protocol().rate_Hz, recorded.lost_records);
  row_.servo->fault = name_of(rig.loop().status().fault);
  measure(recorded.records);
  if (interruption_) {
    name_failed_plugin();
    name_hanging_tick();
    row_.outcome = interruption_->outcome;
    row_.valid = false;
    row_.invalid_reason = stored(interruption_->reason);
  } else {
    store_answers();
    judge();
  }
  row_.events = course_.take_attempt_events();
  return row_;
}

void TrialAttempt::name_failed_plugin() {
  if (interruption_->fault != Fault::not_finite) return;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const std::string_view error = surfaces_.error(i);
    if (error.empty()) continue;
    interruption_->reason =
        phrase_of(Reason::plugin_failed)
            .with(surfaces_.stimulus(i).model->declaration.id, std::string(error));
    return;
  }
}

void TrialAttempt::name_hanging_tick() {
  if (!hanging_tick_ || interruption_->fault != Fault::standstill) return;
  if (!hanging_tick_->rendering) {
    interruption_->reason = phrase_of(Reason::driver_does_not_return);
    return;
  }
  std::vector<std::string> found{};  // side by side, any of them
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    if (surfaces_.has(i)) continue;
    const std::string& id = surfaces_.stimulus(i).model->declaration.id;
    if (std::find(found.begin(), found.end(), id) == found.end()) found.push_back(id);
  }
  std::string models{};
  for (const std::string& id : found) models += (models.empty() ? "" : ", ") + id;
  interruption_->reason = phrase_of(Reason::model_does_not_return).with(models);
}

void TrialAttempt::prepare() {
  const SessionRow& session = course_.row();
  const Protocol& protocol = course_.protocol();
  random_ = random_of_attempt(session, trial_.ordinal, order_.attempt);
  nlohmann::ordered_json models = nlohmann::ordered_json::array();
  for (const PlannedPresentation& planned : trial_.presentations) {
    const ModelDeclaration& model = surfaces_.stimulus(models.size()).model->declaration;
    models.push_back(
        {{"position", planned.position}, {"model", model.id}, {"version", model.version}});
  }

  course_.rig().prepare_attempt(habits_of_hand(), random_.split("hand"));
  course_.respondent().begin_attempt(trial_.ordinal, order_.attempt);
  std::unique_ptr<RecordingWriter> writer{};
  if (order_.record && protocol.record) {
    const nlohmann::ordered_json about{{"participant", session.participant},
                                       {"session", session.session},
                                       {"trial", trial_.ordinal},
                                       {"attempt", order_.attempt},
                                       {"presentations", models}};
    writer = std::make_unique<RecordingWriter>(
        course_.study().folder(), recording_path(),
        RecordingHeader{protocol.rate_Hz, recording_columns(), about.dump()});
  }
  course_.recorder().begin(std::move(writer), protocol.rate_Hz, course_.rig().records());
  const auto asked = [](const Band& band) { return AskedBand{band.minimum, band.maximum}; };
  course_.watch_hand({.normal_force_N = asked(exploration_.normal_force_N),
                      .speed_m_per_s = asked(exploration_.speed_m_per_s),
                      .direction_rad = exploration_.direction_rad,
                      .usual_stroke_m = habits_for(exploration_, patch_).stroke_length_m,
                      .force = judged_force_of(course_.rig().capability())});
}

HandHabits TrialAttempt::habits_of_hand() const {
  if (trial_.arrangement.surfaces != Arrangement::Surfaces::side_by_side) {
    return habits_for(exploration_, patch_);
  }
  const Layout layout{course_.row().mirrored};
  std::vector<SurfacePatch> patches{};
  for (const PlannedPresentation& planned : trial_.presentations) {
    patches.push_back(layout.of(planned));
  }
  return habits_over_patches(exploration_, patch_, patches, trial_.arrangement.minimum_visits);
}

void TrialAttempt::carry_out() {
  course_.enter(SessionPhase::fore);
  if (!trial_.experimenter_prompt.empty()) {
    course_.ask_experimenter(trial_.experimenter_prompt, waiting_);
  }
  // On request the question comes first.
  const bool begins_with_question =
      trial_.arrangement.surfaces == Arrangement::Surfaces::on_request;
  if (!begins_with_question || !has_to_be_seen()) course_.put_mask(true, waiting_);
  course_.show({});
  course_.set_masking(true);
  // The noise is fully faded in before the device can be heard.
  const double fade_s = course_.is_masking() ? MaskingSound::kFade_s : 0.0;
  course_.wait(std::max(block_.pause_before_trial_s, fade_s));
  switch (trial_.arrangement.surfaces) {
    case Arrangement::Surfaces::sequential:
      for (int pass = 0; pass < trial_.arrangement.minimum_visits; ++pass) {
        for (std::size_t i = 0; i < surfaces_.size(); ++i) {
          if (!felt_.empty()) wait_between_surfaces();
          feel_once(i);
        }
      }
      break;
    case Arrangement::Surfaces::side_by_side:
      feel_once(0);
      break;
    case Arrangement::Surfaces::on_request:
      break;  // the question is asked, and the participant requests each surface
  }
  if (!trial_.arrangement.allows_revisits()) course_.set_masking(false);
  if (!begins_with_question) {
    std::vector<JudgedSurface> surfaces{};
    for (std::size_t i = 0; i < surfaces_.size(); ++i) surfaces.push_back(judged_surface(i));
    instability_.begin(std::move(surfaces), course_.recorder().records(),
                       course_.protocol().rate_Hz);
  }
  for (const std::span<const Question> page : pages_of(trial_)) {
    if (!is_to_be_asked(page.front())) {
      answered_.push_back({.question = page.front(), .answer_ns = course_.now_ns()});
    } else if (!answer_page(page)) {
      return;
    }
  }
}

bool TrialAttempt::is_to_be_asked(const Question& question) const {
  if (!question.condition) return true;
  const auto earlier = std::ranges::find_if(answered_, [&](const Answered& each) {
    return each.question.name == question.condition->question && each.answer;
  });
  return earlier != answered_.end() &&
         is_met(*question.condition, texts_of(items_of(earlier->question, *earlier->answer)));
}

JudgedSurface TrialAttempt::judged_surface(std::size_t index) const {
  const PlannedPresentation& planned = trial_.presentations[index];
  const EqualForce request = planned.equal_force.value_or(EqualForce{});
  return {.position = planned.position,
          .model = *surfaces_.stimulus(index).model,
          .inputs = surfaces_.inputs_as_felt(index),
          .band = {request.band_low_Hz, request.band_high_Hz}};
}

void TrialAttempt::wait_between_surfaces() {
  course_.enter(SessionPhase::fore);
  course_.show(scene_between_surfaces(trial_, felt_));
  if (!trial_.arrangement.interval) {
    course_.wait_refusing_answers(block_.pause_between_surfaces_s);
    return;
  }
  const Arrangement::Interval& limits = *trial_.arrangement.interval;
  const double drawn = random_.split("interval").split(intervals_++).uniform();
  const double interval_s = limits.shortest_s + drawn * (limits.longest_s - limits.shortest_s);
  const double passed_s = seconds_between(lifted_ns_, course_.now_ns());
  course_.wait_refusing_answers(std::max(0.0, interval_s - passed_s));
}

bool TrialAttempt::answer_page(std::span<const Question> page) {
  Asking asking{.page = page};
  Reply reply{};
  for (;;) {
    reply = ask(asking);
    const FeelAgain* const wish = reply.feel_again();
    if (wish == nullptr) {
      if (!is_doubtful(asking, reply)) break;
      doubt(asking, reply);
      continue;
    }
    if (has_required_visits()) {
      records_before_revisit_.push_back(course_.recorder().records().size());
    }
    course_.enter(SessionPhase::fore);
    course_.put_mask(true, waiting_);
    if (trial_.arrangement.interval && !felt_.empty()) wait_between_surfaces();
    // What was felt before stays valid: without a contact the question returns, and the visit does not count.
    if (feel(static_cast<std::size_t>(wish->position - 1)) == Contact::none) {
      course_.respondent().visit_was_without_contact(wish->position);
    }
  }
  if (reply.answers() == nullptr && asking.doubted) {
    reply = *asking.doubted;
    asking.answer_ns = reply.answered_ns.value_or(asking.answer_ns);
  }
  for (const PlannedPresentation& planned : trial_.presentations) require_touch(planned.position);
  const GivenAnswers* const given = reply.answers();
  if (given == nullptr) return false;
  for (const PlannedPresentation& planned : trial_.presentations) require_visits(planned.position);
  for (std::size_t i = 0; i < page.size(); ++i) {
    answered_.push_back({.question = page[i],
                         .answer = given->at(i).answer,
                         .cue_ns = asking.cue_ns.value(),
                         .answer_ns = given->at(i).given_ns.value_or(asking.answer_ns),
                         .source = course_.respondent().source()});
  }
  course_.play(Cue::accepted);
  return true;
}

bool TrialAttempt::is_doubtful(const Asking& asking, const Reply& reply) const {
  const auto* const form = std::get_if<NumberForm>(&asking.page.front().form);
  if (form == nullptr || !form->is_estimate) return false;
  const std::optional<double> number = reply.number();
  if (!number || !order_.earlier_estimate || asking.doubted) return false;
  const double ratio = *number / *order_.earlier_estimate;
  return ratio >= kDoubtfulRatio || ratio <= 1.0 / kDoubtfulRatio;
}

void TrialAttempt::doubt(Asking& asking, const Reply& reply) {
  asking.doubted = reply;
  asking.doubted->answered_ns = asking.answer_ns;
  const double number = reply.number().value();
  course_.event("estimate_doubted", number_text(number),
                nlohmann::ordered_json{
                    {"estimate", number},
                    {"earlier_estimate", *order_.earlier_estimate},
                    {"from_cue_s", seconds_between(asking.cue_ns.value(), asking.answer_ns)}}
                    .dump());
}

Reply TrialAttempt::ask(Asking& asking) {
  std::vector<ForceFeatures> features{};
  for (const PlannedPresentation& planned : trial_.presentations) {
    features.push_back(recorded_force_features({course_.recorder().records(),
                                                static_cast<std::uint64_t>(planned.position),
                                                course_.protocol().rate_Hz}));
  }
  course_.respondent().refuse_answers();  // inputs from the time in between
  if (has_to_be_seen()) course_.put_mask(false, waiting_);
  course_.enter(SessionPhase::response);
  std::vector<Question> questions(asking.page.begin(), asking.page.end());
  if (asking.doubted) {
    ParticipantScene scene =
        scene_of_doubt(trial_, asking.page, felt_, asking.doubted->number().value());
    questions.front().prompt = scene.text;
    course_.show(std::move(scene));
  } else {
    course_.show(scene_of_question(trial_, asking.page, felt_));
  }
  course_.play(Cue::question);
  const std::int64_t asked_ns = course_.now_ns();
  if (!asking.cue_ns) asking.cue_ns = asked_ns;
  std::optional<double> left_s = block_.response_deadline_s;
  if (left_s) left_s = std::max(0.0, *left_s - asking.answerable_s);
  Reply reply = course_.respondent().ask(trial_, questions, features, left_s, waiting_);
  asking.answer_ns = reply.answered_ns.value_or(course_.now_ns());
  asking.answerable_s += seconds_between(asked_ns, asking.answer_ns);
  return reply;
}

void TrialAttempt::require_touch(int position) const {
  if (std::find(felt_.begin(), felt_.end(), position) != felt_.end()) return;
  throw Interruption{AttemptOutcome::not_compliant,
                     phrase_of(Reason::not_touched).with(std::to_string(position))};
}

int TrialAttempt::required_visits() const noexcept {
  // Side by side, one presentation has all the visits, which `feel` has counted.
  return trial_.arrangement.surfaces == Arrangement::Surfaces::side_by_side
             ? 1
             : trial_.arrangement.minimum_visits;
}

int TrialAttempt::visits_to(int position) const {
  return static_cast<int>(std::count(felt_.begin(), felt_.end(), position));
}

bool TrialAttempt::has_required_visits() const {
  return std::all_of(trial_.presentations.begin(), trial_.presentations.end(),
                     [this](const PlannedPresentation& planned) {
                       return visits_to(planned.position) >= std::max(1, required_visits());
                     });
}

void TrialAttempt::require_visits(int position) const {
  require_touch(position);
  const int visits = visits_to(position);
  if (visits >= required_visits()) return;
  throw Interruption{AttemptOutcome::not_compliant,
                     phrase_of(Reason::visited_too_rarely)
                         .with(std::to_string(position), std::to_string(visits),
                               std::to_string(required_visits()))};
}

void TrialAttempt::feel_once(std::size_t index) {
  if (feel(index) == Contact::made) return;
  require_visits(trial_.presentations.at(index).position);
}

TrialAttempt::Contact TrialAttempt::feel(std::size_t index) {
  const PlannedPresentation& planned = trial_.presentations.at(index);
  const bool all = trial_.arrangement.surfaces == Arrangement::Surfaces::side_by_side;
  const auto show = [this](ParticipantScene scene) {
    scene.show_workspace = course_.protocol().scene.has_value();
    add_guide(scene, exploration_, course_.protocol());
    course_.show(std::move(scene));
  };
  show(all ? scene_of_patches(trial_) : scene_of_surface(trial_, felt_, planned.position));
  course_.play(Cue::surface, planned.position);
  course_.update([&](SessionSnapshot& snapshot) {
    snapshot.surface = planned.position;
    snapshot.contact_s = 0.0;
    snapshot.wanted_contact_s = wanted_contact_s();
  });
  course_.respondent().announce(trial_, planned);

  Rig& rig = course_.rig();
  course_.recorder().watch(surfaces_.id_of(index), all ? surfaces_.size() : 0);
  rig.loop().present(surfaces_.take(index));
  course_.set_guiding_tones(exploration_.guidance == Exploration::Guidance::tones);
  if (all) {
    explore_patches();
  } else {
    explore(planned.position);
  }
  course_.set_guiding_tones(false);
  show(all ? scene_of_lifting_from_patches(trial_)
           : scene_of_lifting(trial_, felt_, planned.position));
  course_.play(Cue::next);
  lift_and_take_back(index);
  if (course_.recorder().live().contact_s <= 0.0) return Contact::none;
  for (const PlannedPresentation& surface : trial_.presentations) {
    if (!all && surface.position != planned.position) continue;
    if (visits_.visits(surface.position).empty()) {
      throw Interruption{AttemptOutcome::not_compliant,
                         phrase_of(Reason::not_touched).with(std::to_string(surface.position))};
    }
    felt_.push_back(surface.position);
    const auto visits = static_cast<int>(visits_.visits(surface.position).size());
    if (all && visits < trial_.arrangement.minimum_visits) {
      throw Interruption{AttemptOutcome::not_compliant,
                         phrase_of(Reason::visited_too_rarely)
                             .with(std::to_string(surface.position), std::to_string(visits),
                                   std::to_string(trial_.arrangement.minimum_visits))};
    }
  }
  return Contact::made;
}

/// Waits for the hand to lift, removes the surface and waits until the loop has returned it.
void TrialAttempt::lift_and_take_back(std::size_t index) {
  Rig& rig = course_.rig();
  const Recorder& recorder = course_.recorder();
  rig.hand().lift();
  lifted_ns_ = course_.now_ns();
  for (double passed_s = 0.0; recorder.live().touching && passed_s < kPatience_s;
       passed_s += kSlice_s) {
    course_.wait_refusing_answers(kSlice_s);
    lifted_ns_ = course_.now_ns();
  }
  rig.loop().withdraw();
  while (!surfaces_.has(index)) {
    course_.wait_refusing_answers(kSlice_s);
    surfaces_.put_back(rig.loop().collect());
  }
  read_visits(course_.recorder().records());
  // Side by side there is no interval that would begin here.
  const std::vector<VisitRow>& visits = visits_.visits(static_cast<int>(index) + 1);
  if (!visits.empty()) lifted_ns_ = std::min(lifted_ns_, visits.back().offset_ns);
}

void TrialAttempt::read_visits(const std::vector<TickRecord>& records) {
  for (; records_read_ < records.size(); ++records_read_) visits_.take(records[records_read_]);
}

/// A virtual hand comes down at the beginning of a slice, so that the slices in which its visits end do not depend on
/// when it was ready.
void TrialAttempt::let_hand_stroke() {
  VirtualHand& hand = course_.rig().hand();
  if (hand.is_ready()) hand.stroke();
}

/// Waits until the surface was felt for long enough, or the participant wants to continue.
void TrialAttempt::explore(int position) {
  const Arrangement& arrangement = trial_.arrangement;
  const double wanted_s = arrangement.contact_s.value_or(wanted_contact_s());
  const double earlier_s = visits_.contact_s(position);
  StrokeCount strokes(exploration_.direction_rad, judged_force_of(course_.rig().capability()),
                      course_.recorder().records().size());
  double passed_s = 0.0;
  for (;;) {
    let_hand_stroke();
    const double contact_s = course_.recorder().live().contact_s;
    if (contact_s > 0.0) course_.enter(SessionPhase::contact);
    if (passed_s >= exploration_.maximum_contact_s + kPatience_s) break;
    bool may_go = false;
    if (arrangement.strokes) {
      if (strokes.completed(course_.recorder().records()) >= *arrangement.strokes) return;
      if (contact_s >= exploration_.maximum_contact_s - kLifting_s) break;
    } else {
      if (contact_s >= wanted_s) return;
      // The minimum applies to all visits to a surface together.
      may_go = !arrangement.contact_s && contact_s > 0.0 &&
               earlier_s + contact_s >= exploration_.minimum_contact_s;
    }
    if (course_.respondent().wants_next(may_go) && may_go) return;
    course_.wait(kSlice_s);
    passed_s += kSlice_s;
  }
  const bool was_touched = course_.recorder().live().contact_s > 0.0;
  if (was_touched && (arrangement.strokes || arrangement.contact_s)) cut_short_.insert(position);
}

/// Waits until every patch was visited and felt for long enough and the participant wants to continue, or the contact
/// has lasted for as long as is permitted for all of them.
void TrialAttempt::explore_patches() {
  const auto surfaces = static_cast<double>(surfaces_.size());
  const double longest_s = surfaces * exploration_.maximum_contact_s - kLifting_s;
  double passed_s = 0.0;
  for (;;) {
    let_hand_stroke();
    const double contact_s = course_.recorder().live().contact_s;
    if (contact_s > 0.0) course_.enter(SessionPhase::contact);
    if (contact_s >= longest_s || passed_s >= longest_s + kPatience_s) return;
    read_visits(course_.recorder().records());
    const bool may_go =
        contact_s > 0.0 &&
        std::all_of(trial_.presentations.begin(), trial_.presentations.end(),
                    [this](const PlannedPresentation& planned) {
                      return visits_.contact_s(planned.position) >=
                                 exploration_.minimum_contact_s &&
                             static_cast<int>(visits_.visits(planned.position).size()) >=
                                 trial_.arrangement.minimum_visits;
                    });
    if (course_.respondent().wants_next(may_go) && may_go) return;
    course_.wait(kSlice_s);
    passed_s += kSlice_s;
  }
}

double TrialAttempt::wanted_contact_s() const {
  const HandHabits habits = habits_for(exploration_, patch_);
  const double strokes_s = exploration_.strokes.target.value_or(0.0) * kBeyondMinimum *
                           habits.stroke_length_m /
                           (habits.speed_m_per_s * (1.0 - habits.gathering));
  const double longest_s =
      std::max(exploration_.minimum_contact_s, exploration_.maximum_contact_s - kLifting_s);
  return std::min(std::max(kBeyondMinimum * exploration_.minimum_contact_s, strokes_s), longest_s);
}

void TrialAttempt::measure(const std::vector<TickRecord>& records) {
  const double rate_Hz = course_.protocol().rate_Hz;
  read_visits(records);
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const PlannedPresentation& planned = trial_.presentations[i];
    const PreparedStimulus& prepared = surfaces_.stimulus(i);
    const auto id = static_cast<std::uint64_t>(planned.position);
    PresentationRow presentation{};
    presentation.position = planned.position;
    presentation.role = planned.role;
    presentation.item = planned.item;
    presentation.stimulus = planned.stimulus.name;
    presentation.model = prepared.model->declaration.id;
    presentation.model_version = prepared.model->declaration.version;
    presentation.texture = planned.stimulus.texture;
    presentation.parameters_json = json_text_of(prepared.inputs.parameters);
    presentation.assets = prepared.assets;
    presentation.stiffness_N_per_m = prepared.inputs.material.stiffness_N_per_m;
    presentation.friction = prepared.inputs.material.friction;
    presentation.raised_m = planned.patch.centre_m.z - planned.stimulus.patch.centre_m.z;
    presentation.seed = std::to_string(surfaces_.seed(i));
    presentation.visits = visits_.visits(planned.position);
    presentation.matched_texture_force_N = prepared.matched_texture_force_N;
    fill_times(records, id, rate_Hz, presentation);
    presentation.gaps_in_contact = gaps_in_contact_of(records, id);
    if (hanging_tick_) {
      // Replayed, its model might not return here either.
    } else {
      ReplayedMeasures replayed =
          instability_.take(judged_surface(i), records, rate_Hz,
                            interruption_ ? AttemptInstability::Values::texture_force_only
                                          : AttemptInstability::Values::all);
      presentation.achieved_texture_force_N = replayed.texture_force_N;
      if (!interruption_) presentation.instability = std::move(replayed.instability);
    }
    for (const NamedCount& limit : surfaces_.limits(i)) {
      presentation.limits.push_back(
          {std::string(limit.name), static_cast<std::int64_t>(limit.ticks)});
    }
    row_.presentations.push_back(std::move(presentation));
  }
  row_.compliance = compliance_in(records);
  const auto complied_with = [&](std::size_t number) {
    return failed_measures(compliance_in(std::span(records).first(number))).empty();
  };
  explored_before_revisit_ =
      !failed_measures(row_.compliance).empty() &&
      std::any_of(records_before_revisit_.begin(), records_before_revisit_.end(), complied_with);
  if (const auto& model = instability_.hanging_model()) {
    course_.report_to_experimenter(
        "The force model " + *model +
        " did not return when its forces in this attempt were computed again. The attempt is "
        "stored without its texture force and its perceived instability; please report this to "
        "the author of the model.");
  }
}

std::vector<ComplianceRow> TrialAttempt::compliance_in(std::span<const TickRecord> records) const {
  std::vector<ComplianceRow> all{};
  for (const PlannedPresentation& planned : trial_.presentations) {
    const auto id = static_cast<std::uint64_t>(planned.position);
    const bool is_presented =
        std::any_of(records.begin(), records.end(),
                    [id](const TickRecord& record) { return is_rendered(record, id); });
    if (!is_presented) continue;
    for (ComplianceRow& compliance :
         compliance_of(records, id, course_.protocol().rate_Hz, exploration_,
                       judged_force_of(course_.rig().capability()), trial_.arrangement.strokes)) {
      compliance.position = planned.position;
      all.push_back(std::move(compliance));
    }
  }
  return all;
}

void TrialAttempt::store_answers() {
  // A missed deadline is an outcome of the trial; the question that it ended has no response.
  if (answered_.size() < trial_.questions.size()) row_.outcome = AttemptOutcome::timed_out;
  for (const Answered& answered : answered_) {
    if (!answered.answer) {
      row_.responses.push_back(row_not_asked(answered.question, answered.answer_ns).front());
      continue;
    }
    AnswerCircumstances how{.time_ns = answered.answer_ns, .source = answered.source};
    how.from_cue_s = seconds_between(answered.cue_ns, answered.answer_ns);
    if (const auto contact_ns = first_contact_ns(row_.presentations)) {
      how.from_contact_s = seconds_between(*contact_ns, answered.answer_ns);
    }
    for (ResponseRow& row : rows_of(answered.question, answered.answer, how)) {
      row_.responses.push_back(std::move(row));
    }
  }
}

void TrialAttempt::judge() {
  const Protocol& protocol = course_.protocol();
  const ServoQualityRow& servo = *row_.servo;
  // Many ticks may also be late during a slow answer, while nothing is felt.
  if (servo.missed_in_contact > protocol.maximum_missed_deadlines) {
    row_.valid = false;
    row_.invalid_reason = stored(phrase_of(Reason::missed_in_contact)
                                     .with(std::to_string(servo.missed_in_contact),
                                           std::to_string(protocol.maximum_missed_deadlines)));
    return;
  }
  if (servo.gaps_in_contact > protocol.maximum_gaps_in_contact) {
    row_.valid = false;
    row_.invalid_reason = stored(phrase_of(Reason::gaps_in_contact)
                                     .with(std::to_string(servo.gaps_in_contact),
                                           std::to_string(protocol.maximum_gaps_in_contact)));
    return;
  }
  if (servo.lost_records > protocol.maximum_lost_records) {
    row_.valid = false;
    row_.invalid_reason = stored(phrase_of(Reason::lost_records)
                                     .with(std::to_string(servo.lost_records),
                                           std::to_string(protocol.maximum_lost_records),
                                           std::to_string(servo.ticks + servo.lost_records)));
    return;
  }
  Phrase flags{};
  if (servo.saturated_ticks > 0) {
    flags = phrase_of(Reason::force_limited).with(std::to_string(servo.saturated_ticks));
  }
  if (judge_buzz(flags)) return;
  if (const Phrase failures = failed_measures(row_.compliance); !failures.empty()) {
    const Phrase not_explored = phrase_of(Reason::not_explored_as_asked).with(failures);
    const bool ask_again = exploration_.on_failure != Exploration::OnFailure::flag &&
                           order_.explored_wrongly < exploration_.maximum_repeats &&
                           !explored_before_revisit_;
    if (ask_again) {
      row_.outcome = AttemptOutcome::not_compliant;
      row_.valid = false;
      row_.invalid_reason = stored(not_explored);
      return;
    }
    flags = with_semicolon(flags, not_explored);
  }
  for (const int position : cut_short_) {
    flags =
        with_semicolon(flags, phrase_of(Reason::visit_cut_short).with(std::to_string(position)));
  }
  if (!flags.empty()) {
    row_.flagged = true;
    row_.flag_reason = stored(flags);
  }
}

bool TrialAttempt::judge_buzz(Phrase& flags) {
  const Phrase excessive = excessive_buzz(course_.protocol(), row_.presentations);
  if (excessive.empty()) return false;
  const bool ask_again =
      course_.protocol().instability->on == InstabilityRule::OnExcess::repeat_now &&
      order_.repeated_for_buzz < kMostRepeatsForBuzz;
  if (ask_again) {
    row_.valid = false;
    row_.invalid_reason = stored(excessive);
    return true;
  }
  flags = with_semicolon(flags, excessive);
  return false;
}

void TrialAttempt::take_surface_away() {
  Rig& rig = course_.rig();
  rig.hand().lift();
  rig.loop().withdraw();
  const std::vector<TickRecord>& records = course_.recorder().records();
  const TickProgress before = rig.loop().progress();
  for (double passed_s = 0.0; passed_s < 1.0; passed_s += kSlice_s) {
    const Fault fault = rig.loop().status().fault;
    const bool is_fault = fault != Fault::none;
    // A stop is known before its tick: the record has to show that the force was zero.
    if (is_fault && !records.empty() && records.back().has(TickFlag::fault_latched)) {
      // The renderer of a plug-in states its error.
      if (fault != Fault::not_finite) return;
      course_.pass_slice();
      surfaces_.put_back(rig.loop().collect());
      return;
    }
    if (is_fault && passed_s >= kForLateTick_s && rig.loop().progress().hangs_since(before)) {
      hanging_tick_ = rig.loop().progress();
      return;
    }
    course_.pass_slice();
    if (is_fault) continue;
    // Contains the demands on the presentation that exceeded its limits.
    Presentation collected = rig.loop().collect();
    if (collected.renderer == nullptr) continue;
    surfaces_.put_back(std::move(collected));
    return;
  }
}

bool TrialAttempt::has_to_be_seen() const {
  const auto is_shown = [](const Question& question) {
    return is_seen(question.form) ||
           std::any_of(question.options.begin(), question.options.end(),
                       [](const Option& option) { return option.picture.has_value(); });
  };
  return trial_.standard_picture.has_value() ||
         std::any_of(trial_.questions.begin(), trial_.questions.end(), is_shown);
}

std::string TrialAttempt::recording_path() const {
  const auto padded = [](int number, std::size_t width) {
    std::string digits = std::to_string(number);
    if (digits.size() < width) digits.insert(0, width - digits.size(), '0');
    return digits;
  };
  const SessionRow& session = course_.row();
  return "recordings/" + session.participant + "/session-" + padded(session.session, 2) +
         "/trial-" + padded(trial_.ordinal, 4) + "_attempt-" + std::to_string(order_.attempt) +
         ".rec";
}

}  // namespace asperity
