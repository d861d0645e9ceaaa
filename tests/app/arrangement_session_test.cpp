// Trials as their blocks arrange them: in sequence, side by side, on request. Times and visits are those of the recorded hand.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/records/recorded_attempt.h"
#include "app/session/layout.h"
#include "app/session/rig/recording_columns.h"
#include "app/tasks/verify/verify_study.h"
#include "app/words/coded_phrases.h"
#include "protocols/observer/virtual_observer.h"
#include "renderers/force/adjacent_patches.h"
#include "renderers/offline/recorded_force.h"
#include "renderers/servo/contact.h"
#include "results_schema/recording.h"
#include "tests/app/scripted_session.h"
#include "tests/support/replies.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Two trials with two gratings each, of different amplitudes.
std::string arranged(const std::string& arrangement) {
  return R"({
  "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "arranged",
  "version": "1.0.0", "title": "Arranged",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "surface": {"centre_m": [0, 0, 0], "extent_m": [0.1, 0.1], "tiling": "repeat", "edge": "fade",
              "edge_width_m": 0.005, "motion_scale": 1},
  "material": {"stiffness_N_per_m": 500, "friction": 0.2},
  "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}},
  "explorations": {"stroking": {"minimum_contact_s": 0.3, "maximum_contact_s": 8,
                                "stroke_length_m": {"target": 0.04}, "speed_m_per_s": {"target": 0.1}}},
  "blocks": {
    "main": {
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels_ratio": [2]},
      "repetitions": 2,
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "positions": "balanced", "exploration": "stroking", "pause_before_trial_s": 0,
      "arrangement": )" +
         arrangement + R"(,
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
  "flow": [{"run": "main"}]})";
}

class ArrangedSession : public SessionTest {
 protected:
  std::vector<AttemptRow> attempts_of(const std::string& arrangement) {
    begin(arranged(arrangement));
    links_ = {};
    EXPECT_EQ(run().state, SessionState::completed);
    return attempts();
  }
  std::vector<TickRecord> records_of_attempt(const AttemptRow& attempt) const {
    const std::filesystem::path file = study_->folder() / attempt.recording.value().path;
    return records_of(read_recording(file), file);
  }
  void expect_verified() {
    EXPECT_THAT(verify_study(*study_, models_, true, {}, [](double) {}).problems, ElementsAre());
  }
};

TEST_F(ArrangedSession, PresentsASequenceTwice) {
  const std::vector<AttemptRow> attempts =
      attempts_of(R"({"visits": {"minimum": 2, "maximum": 2}})");
  EXPECT_THAT(person_.felt_positions, ElementsAre(1, 2, 1, 2, 1, 2, 1, 2));
  for (const AttemptRow& attempt : attempts) {
    ASSERT_EQ(attempt.presentations.size(), 2U);
    EXPECT_EQ(attempt.presentations[0].visits.size(), 2U);
    EXPECT_EQ(attempt.presentations[1].visits.size(), 2U);
  }
  expect_verified();
}

/// From the last contact to the first tick of the next surface.
TEST_F(ArrangedSession, WaitsFromTheLastContactToTheNextSurface) {
  const std::vector<AttemptRow> attempts =
      attempts_of(R"({"visits": {"maximum": 1}, "interval_s": 0.9})");
  for (const AttemptRow& attempt : attempts) {
    const VisitRow& first = attempt.presentations[0].visits.at(0);
    const double interval_s =
        1e-9 * static_cast<double>(*attempt.presentations[1].onset_ns - first.offset_ns);
    EXPECT_NEAR(interval_s, 0.9, SessionCourse::kSlice_s);
  }
}

/// Of two gratings whose amplitudes differ by 2 %, in both orders and after intervals of any length.
TEST_F(ArrangedSession, IsFeltInTheSameWayInEitherOrder) {
  std::string text =
      arranged(R"({"visits": {"maximum": 1}, "interval_s": {"shortest": 0, "longest": 1.5}})");
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace(R"("levels_ratio": [2])", R"("levels_ratio": [1.02])");
  replace(R"("repetitions": 2)", R"("repetitions": 60)");
  replace(R"("minimum_contact_s": 0.3)", R"("minimum_contact_s": 1.5)");
  begin(text);
  links_ = {};
  EXPECT_EQ(run().state, SessionState::completed);
  int first = 0;
  std::vector<double> force_N(2);  // the mean of each visit, over the attempts
  const std::vector<AttemptRow> attempts = this->attempts();
  for (const AttemptRow& attempt : attempts) {
    const std::vector<TickRecord> records = records_of_attempt(attempt);
    const auto features = [&records](std::uint64_t position) {
      return recorded_force_features({records, position, 1000.0});
    };
    // Neither noise nor bias.
    VirtualObserver observer({.feature_noise = 0.0,
                              .position_bias = 0.0,
                              .lapse = 0.0,
                              .magnitude_of = ObserverDeclaration::MagnitudeOf::normal_force},
                             Random(1));
    const std::size_t chosen = observer.compare(features(1), features(2), 0.0).value();
    EXPECT_EQ(attempt.presentations.at(chosen).role, "comparison") << "the rougher one";
    first += chosen == 0 ? 1 : 0;
    for (std::size_t i = 0; i < 2; ++i) {
      force_N[i] += attempt.presentations[i].visits.at(0).force_mean_N.value() / 60.0;
    }
    EXPECT_NEAR(attempt.presentations[0].contact_s, attempt.presentations[1].contact_s, 2e-3);
  }
  ASSERT_EQ(attempts.size(), 60U);
  EXPECT_GT(first, 20) << "both orders occur";
  EXPECT_LT(first, 40);
  EXPECT_NEAR(force_N[0], force_N[1], 1e-4);
}

TEST_F(ArrangedSession, DrawsIntervalsBetweenTheirLimits) {
  const std::vector<AttemptRow> attempts = attempts_of(
      R"({"visits": {"minimum": 3, "maximum": 3}, "interval_s": {"shortest": 0.6, "longest": 1.2}})");
  std::vector<double> intervals_s{};
  for (const AttemptRow& attempt : attempts) {
    const std::vector<TickRecord> records = records_of_attempt(attempt);
    std::int64_t last_contact_ns = 0;
    for (const TickRecord& record : records) {
      if (record.has(TickFlag::first_of_presentation) && last_contact_ns != 0) {
        intervals_s.push_back(1e-9 * static_cast<double>(record.probe.time_ns - last_contact_ns));
      }
      if (is_in_contact(record)) last_contact_ns = record.probe.time_ns;
    }
  }
  ASSERT_EQ(intervals_s.size(), 10U);
  const auto [shortest, longest] = std::minmax_element(intervals_s.begin(), intervals_s.end());
  EXPECT_GE(*shortest, 0.6 - 0.01);
  EXPECT_LE(*longest, 1.2 + SessionCourse::kSlice_s);
  EXPECT_GT(*longest - *shortest, 0.15) << "they are drawn";
}

TEST_F(ArrangedSession, EndsEveryVisitAfterTheSameNumberOfStrokes) {
  const std::vector<AttemptRow> attempts =
      attempts_of(R"({"visits": {"maximum": 1}, "exposure": {"strokes": 3}})");
  int surfaces = 0;
  for (const AttemptRow& attempt : attempts) {
    EXPECT_FALSE(attempt.flagged);
    for (const ComplianceRow& row : attempt.compliance) {
      if (row.quantity != "strokes") continue;
      ++surfaces;
      EXPECT_EQ(row.mean, 3.0) << "not the stroke that had begun and is cut off by the lift";
    }
  }
  EXPECT_EQ(surfaces, 4);
}

TEST_F(ArrangedSession, FlagsAVisitThatEndedBeforeItsStrokes) {
  std::string text = arranged(R"({"visits": {"maximum": 1}, "exposure": {"strokes": 30}})");
  begin(text);
  links_ = {};
  EXPECT_EQ(run().state, SessionState::completed);
  for (const AttemptRow& attempt : attempts()) {
    ASSERT_TRUE(attempt.flagged);
    EXPECT_THAT(codes_of(attempt.flag_reason.value()), HasSubstr("visit_cut_short"));
  }
}

TEST_F(ArrangedSession, EndsEveryVisitAfterTheSameContact) {
  const std::vector<AttemptRow> attempts =
      attempts_of(R"({"visits": {"maximum": 1}, "exposure": {"contact_s": 1.5}})");
  for (const AttemptRow& attempt : attempts) {
    for (const PresentationRow& surface : attempt.presentations) {
      EXPECT_NEAR(surface.contact_s, 1.6, 0.15) << "and until the hand has lifted";
    }
  }
}

/// The hand strokes in one patch after the other; the recording tells them apart.
TEST_F(ArrangedSession, PresentsSurfacesSideBySide) {
  person_.has_had_enough = true;
  const std::vector<AttemptRow> attempts =
      attempts_of(R"({"surfaces": "side_by_side", "visits": {"minimum": 2}, "phase": "drawn"})");
  ASSERT_EQ(attempts.size(), 2U);
  EXPECT_THAT(person_.felt_positions, ElementsAre(1, 1)) << "announced once in each trial";
  for (const AttemptRow& attempt : attempts) {
    EXPECT_TRUE(attempt.valid) << attempt.invalid_reason.value_or("").text;
    const PresentationRow& left = attempt.presentations.at(0);
    const PresentationRow& right = attempt.presentations.at(1);
    EXPECT_GE(left.visits.size(), 2U);
    EXPECT_GE(right.visits.size(), 2U);
    EXPECT_LE(
        std::abs(static_cast<int>(left.visits.size()) - static_cast<int>(right.visits.size())), 1)
        << "they alternate";
    for (const TickRecord& record : records_of_attempt(attempt)) {
      if (!is_in_contact(record)) continue;
      const double x_m = record.probe.position_m.x;
      EXPECT_EQ(record.presentation, x_m < 0.0 ? 1U : 2U) << x_m;
      EXPECT_GE(std::abs(x_m), 0.003 + kBlend_m - 1e-6)
          << "neither between the patches nor in a blend";
    }
    double contact_s = 0.0;
    for (const VisitRow& visit : left.visits) {
      contact_s += visit.contact_s;
      EXPECT_GT(visit.path_m, 0.0);
      EXPECT_GT(visit.speed_mean_m_per_s, 0.02);
    }
    EXPECT_NEAR(contact_s, left.contact_s, 1e-9);
    const bool is_left = left.role == "comparison";
    EXPECT_NEAR((is_left ? left : right).achieved_texture_force_N.value() /
                    (is_left ? right : left).achieved_texture_force_N.value(),
                2.0, 0.2);
  }
  expect_verified();
}

/// The hand slides over both patches, with its strokes along them; the renderers alternate.
TEST_F(ArrangedSession, TellsThePatchesApartThatAHandSlidesOver) {
  begin(arranged(R"({"surfaces": "side_by_side", "visits": {"minimum": 2}})"));
  links_ = {};
  person_.has_had_enough = true;
  rig_->at_prepare = [](HandHabits& habits) {
    habits.centre_m = {};
    habits.stroke_length_m = 0.08;
    habits.further_centres = 0;
  };
  EXPECT_EQ(run().state, SessionState::completed);
  std::set<std::uint64_t> touched{};
  for (const AttemptRow& attempt : attempts()) {
    EXPECT_LE(std::abs(static_cast<int>(attempt.presentations.at(0).visits.size()) -
                       static_cast<int>(attempt.presentations.at(1).visits.size())),
              1)
        << "they alternate";
    for (const TickRecord& record : records_of_attempt(attempt)) {
      if (!is_in_contact(record)) continue;
      const double x_m = record.probe.position_m.x;
      EXPECT_EQ(record.presentation, x_m <= -0.003 ? 1U : x_m >= 0.003 ? 2U : kSideBySide) << x_m;
      touched.insert(record.presentation);
    }
  }
  EXPECT_THAT(touched, ElementsAre(1U, 2U, kSideBySide));
  expect_verified();
}

/// Strokes of 30 mm along x at 0.1 m/s, over patches along an axis. The lift at the end cuts one of them off.
std::string with_bands_along(const std::string& axis) {
  std::string text = arranged(R"({"surfaces": "side_by_side", "axis": ")" + axis + R"("})");
  const std::string stated =
      R"("stroke_length_m": {"target": 0.04}, "speed_m_per_s": {"target": 0.1})";
  text.replace(text.find(stated), stated.size(),
               R"("direction_rad": 0, "required_fraction_in_band": 0.7, "on_failure": "flag",
                  "stroke_length_m": {"target": 0.03, "minimum": 0.024, "maximum": 0.036},
                  "speed_m_per_s": {"target": 0.1, "minimum": 0.07, "maximum": 0.13})");
  const std::string contact = R"("minimum_contact_s": 0.3)";
  text.replace(text.find(contact), contact.size(), R"("minimum_contact_s": 2)");
  return text;
}

/// Speeds and lengths of strokes are in their bands, wherever the patches lie.
class BandsOverPatches : public ArrangedSession, public testing::WithParamInterface<const char*> {};

TEST_P(BandsOverPatches, AreMetWithinEachPatch) {
  const std::string axis = GetParam();
  begin(with_bands_along(axis));
  links_ = {};
  person_.has_had_enough = true;
  EXPECT_EQ(run().state, SessionState::completed);
  int bands = 0;
  for (const AttemptRow& attempt : attempts()) {
    EXPECT_FALSE(attempt.flagged);
    for (const ComplianceRow& row : attempt.compliance) {
      if (row.quantity != "speed_m_per_s" && row.quantity != "stroke_length_m") continue;
      ++bands;
      EXPECT_EQ(row.passed, true) << row.quantity << ' ' << row.mean;
    }
    for (const TickRecord& record : records_of_attempt(attempt)) {
      if (!is_in_contact(record)) continue;
      const glm::dvec3& place_m = record.probe.position_m;
      EXPECT_EQ(record.presentation, (axis == "x" ? place_m.x : place_m.y) < 0.0 ? 1U : 2U);
    }
  }
  EXPECT_EQ(bands, 2 * 2 * 2) << "of two trials with two surfaces";
}

INSTANTIATE_TEST_SUITE_P(AlongEachAxis, BandsOverPatches, testing::Values("x", "y"));

/// A hand that stops after two visits never reaches the required number: the attempt does not count.
TEST_F(ArrangedSession, DoesNotCountAnAttemptWithTooFewVisits) {
  begin(arranged(R"({"surfaces": "side_by_side", "visits": {"minimum": 20}})"));
  links_ = {};
  person_.has_had_enough = true;
  rig_->at_pass = [this] {  // it would be asked for ever
    if (!done_.empty()) conductor_->requests().abort("tested");
  };
  EXPECT_NE(run().state, SessionState::completed);
  const AttemptRow first = attempts().at(0);
  EXPECT_EQ(first.outcome, AttemptOutcome::not_compliant);
  EXPECT_EQ(codes_of(first.invalid_reason.value()), "surface_visited_too_rarely");
}

/// The first wish to feel a surface again ends without contact: what was felt before is not lost.
TEST_F(ArrangedSession, KeepsAnAttemptWhoseSurfaceIsNotTouchedWhenFeltAgain) {
  begin(arranged(R"({"visits": {"minimum": 1}})"));
  links_ = {};
  person_.at_question = [](int question, const Trial&) {
    return question == 1 ? feels_again(1) : chooses(0);
  };
  rig_->at_pass = [this] {
    if (person_.felt_positions.size() == 3) rig_->hand().lift();
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(person_.felt_positions, ElementsAre(1, 2, 1, 1, 2));
  const std::vector<AttemptRow> attempts = this->attempts();
  ASSERT_EQ(attempts.size(), 2U);
  EXPECT_EQ(attempts[0].outcome, AttemptOutcome::answered);
  EXPECT_TRUE(attempts[0].valid);
  EXPECT_FALSE(attempts[0].flagged);
  EXPECT_EQ(attempts[0].presentations.at(0).visits.size(), 1U);
  EXPECT_EQ(attempts[0].responses.size(), 1U);
  expect_verified();
}

/// A protocol whose exploration is repeated where it does not comply with `bands`.
std::string repeated_outside(const std::string& bands, const std::string& arrangement) {
  std::string text = arranged(arrangement);
  const std::string length = R"("stroke_length_m": {"target": 0.04})";
  text.replace(text.find(length), length.size(),
               bands + R"(, "on_failure": "repeat_now", "maximum_repeats": 1)");
  return text;
}

/// Each visit has two strokes, and a surface at most three: it complies when the question is asked, and not once it is felt again.
TEST_F(ArrangedSession, KeepsAnAttemptWhoseSurfaceIsFeltAgainOutsideTheBands) {
  begin(repeated_outside(R"("stroke_length_m": {"target": 0.04}, "strokes": {"maximum": 3})",
                         R"({"visits": {"minimum": 1}, "exposure": {"strokes": 2}})"));
  links_ = {};
  person_.at_question = [](int question, const Trial&) {
    return question == 1 ? feels_again(1) : chooses(0);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  const std::vector<AttemptRow> attempts = this->attempts();
  ASSERT_EQ(attempts.size(), 2U) << "nothing is repeated";
  EXPECT_EQ(attempts[0].outcome, AttemptOutcome::answered);
  EXPECT_TRUE(attempts[0].valid);
  EXPECT_THAT(codes_of(attempts[0].flag_reason.value()), HasSubstr("exploration_not_compliant"));
  EXPECT_FALSE(attempts[1].flagged);
  expect_verified();
}

TEST_F(ArrangedSession, RepeatsAnAttemptThatDidNotComplyBeforeASurfaceWasFeltAgain) {
  begin(repeated_outside(R"("stroke_length_m": {"minimum": 0.03, "maximum": 0.05})",
                         R"({"visits": {"minimum": 1}})"));
  links_ = {};
  person_.at_question = [](int question, const Trial&) {
    return question == 1 ? feels_again(1) : chooses(0);
  };
  rig_->at_prepare = [](HandHabits& habits) { habits.stroke_length_m = 0.01; };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(attempts().at(0).outcome, AttemptOutcome::not_compliant);
}

/// A prescribed second visit without contact: the surface was touched, but not often enough.
TEST_F(ArrangedSession, StatesThatASurfaceWasVisitedTooRarelyWhereItWasTouchedOnce) {
  begin(arranged(R"({"visits": {"minimum": 2, "maximum": 2}})"));
  links_ = {};
  rig_->at_pass = [this] {
    if (person_.felt_positions.size() == 3) rig_->hand().lift();
    if (!done_.empty()) conductor_->requests().abort("tested");
  };
  EXPECT_NE(run().state, SessionState::completed);
  const AttemptRow first = attempts().at(0);
  EXPECT_EQ(first.outcome, AttemptOutcome::not_compliant);
  EXPECT_EQ(first.invalid_reason.value().text, "visits to surface 1: 1 of at least 2");
}

/// The participant's screen shows A on the left in every session.
TEST_F(ArrangedSession, KeepsTheFirstSurfaceOnTheLeftInAMirroredSession) {
  std::string text = arranged(R"({"surfaces": "side_by_side"})");
  const std::string centre = R"("centre_m": [0, 0, 0])";
  text.replace(text.find(centre), centre.size(), R"("centre_m": [0.02, 0, 0])");
  begin(text);
  links_ = {};
  const Trial& trial = session_.course->plan().trials.front();
  const Layout mirrored{.mirrored = true};
  EXPECT_NEAR(mirrored.of(trial.presentations[0]).centre_m.x, -0.02 - 0.0265, 1e-12);
  EXPECT_NEAR(mirrored.of(trial.presentations[1]).centre_m.x, -0.02 + 0.0265, 1e-12);
  EXPECT_NEAR(Layout{}.of(trial.presentations[0]).centre_m.x, 0.02 - 0.0265, 1e-12);
}

TEST_F(ArrangedSession, RefusesToFinishBeforeEveryPatchWasVisited) {
  begin(arranged(R"({"surfaces": "side_by_side"})"));
  links_ = {};
  person_.has_had_enough = true;
  rig_->at_prepare = [](HandHabits& habits) {  // stays on the left
    habits.centre_m.x = -0.03;
    habits.stroke_length_m = 0.01;
    habits.further_centres = 0;
  };
  EXPECT_NE(run().state, SessionState::completed);
  const AttemptRow first = attempts().at(0);
  EXPECT_EQ(first.outcome, AttemptOutcome::not_compliant);
  EXPECT_THAT(first.invalid_reason.value().text, HasSubstr("surface 2"));
}

TEST_F(ArrangedSession, PresentsOnRequestWhatTheParticipantAsksFor) {
  begin(arranged(R"({"surfaces": "on_request", "visits": {"minimum": 1, "maximum": 2}})"));
  links_ = {};
  person_.at_question = [](int question, const Trial&) {
    switch ((question - 1) % 4) {
      case 0:
        return feels_again(2);
      case 1:
        return feels_again(1);
      case 2:
        return feels_again(2);
      default:
        return chooses(0);
    }
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(person_.felt_positions, ElementsAre(2, 1, 2, 2, 1, 2));
  for (const AttemptRow& attempt : attempts()) {
    EXPECT_EQ(attempt.presentations[0].visits.size(), 1U);
    ASSERT_EQ(attempt.presentations[1].visits.size(), 2U);
    EXPECT_NEAR(attempt.responses.at(0).from_contact_s.value(),
                1e-9 * static_cast<double>(attempt.responses[0].time_ns -
                                           attempt.presentations[1].contact_ns.value()),
                1e-9)
        << "from the first contact, with surface 2";
    EXPECT_LT(attempt.presentations[1].visits[0].offset_ns,
              attempt.presentations[0].visits[0].contact_ns);
  }
  expect_verified();
}

TEST(ArrangedPhase, IsDrawnForEverySurfaceAndStoredInThePlan) {
  const Protocol protocol = read_small_protocol(
      built_in_models(), arranged(R"({"phase": "drawn", "visits": {"maximum": 1}})"));
  const Plan plan = make_plan(protocol, {1, 0});
  std::set<double> origins_m{};
  for (const Trial& trial : plan.trials) {
    for (const PlannedPresentation& planned : trial.presentations) {
      EXPECT_EQ(planned.stimulus.patch.texture_origin_m, glm::dvec2(0.0)) << "of the stimulus";
      origins_m.insert(planned.patch.texture_origin_m.x);
    }
    EXPECT_THAT(json_of(trial), HasSubstr("texture_origin_m"));
  }
  EXPECT_EQ(origins_m.size(), 4U);
  const Plan again = make_plan(protocol, {1, 0});
  EXPECT_EQ(again.trials[0].presentations[0].patch.texture_origin_m,
            plan.trials[0].presentations[0].patch.texture_origin_m);
}

/// A roved quantity is that of the plan, of the force and of the stored row.
TEST_F(ArrangedSession, StoresTheRovedMaterialOfEverySurface) {
  std::string text = arranged(R"({"visits": {"minimum": 1, "maximum": 1}})");
  const std::string key = "\"repetitions\": 2,";
  text.replace(
      text.find(key), key.size(),
      R"("repetitions": 6, "rove": {"stiffness_N_per_m": [400, 600], "friction": [0.1, 0.3],
                  "raised_m": [-0.001, 0.001]},)");
  begin(text);
  links_ = {};
  EXPECT_EQ(run().state, SessionState::completed);
  std::set<double> stiffness{};
  std::set<double> raised_m{};
  const Plan plan = plan_of(*study_, study_->session(session_.row.id), models_);
  for (const AttemptRow& attempt : attempts()) {
    const Trial& trial = plan.trials.at(static_cast<std::size_t>(attempt.trial - 1));
    for (std::size_t i = 0; i < 2; ++i) {
      const PresentationRow& row = attempt.presentations.at(i);
      const PlannedPresentation& planned = trial.presentations.at(i);
      EXPECT_EQ(row.stiffness_N_per_m, planned.stimulus.material.stiffness_N_per_m);
      EXPECT_EQ(row.friction, planned.stimulus.material.friction);
      stiffness.insert(row.stiffness_N_per_m);
      raised_m.insert(std::round(1e6 * row.raised_m));
    }
    // The hand presses with about 1 N: the depth follows the stiffness and the height of the plane.
    for (const TickRecord& record : records_of_attempt(attempt)) {
      if (!is_in_contact(record)) continue;
      const PlannedPresentation& planned = trial.presentations.at(record.presentation - 1);
      EXPECT_NEAR(record.rendered.force_N.z,
                  planned.stimulus.material.stiffness_N_per_m * record.penetration_m, 1e-3);
      EXPECT_LT(record.probe.position_m.z, planned.patch.centre_m.z + 2.1e-4);
    }
  }
  EXPECT_THAT(stiffness, ElementsAre(400.0, 600.0));
  EXPECT_THAT(raised_m, ElementsAre(-1000.0, 1000.0));
  expect_verified();
}

}  // namespace
}  // namespace asperity
