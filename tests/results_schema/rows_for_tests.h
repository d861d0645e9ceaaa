// Rows in which every field has a value of its own, so that a swapped column shows.

#pragma once

#include <string>
#include <vector>

#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"

namespace asperity {

inline ParticipantRow some_participant(const std::string& label = "P01") {
  return {.label = label,
          .is_virtual = true,
          .age_years = 34.5,
          .sex = "F",
          .handedness = "left",
          .answers_json = R"({"touch_problems":"none"})",
          .created_utc = "2026-03-01T09:00:00Z"};
}

inline ProtocolRow some_protocol(const std::string& source = R"({"name":"selection"})") {
  return {.name = "selection",
          .version = "1.0.0",
          .kind = "selection",
          .design = "chapter",
          .source_sha256 = sha256_of(source),
          .source = source};
}

inline SessionRow some_session(std::int64_t protocol_id, const std::string& participant = "P01") {
  return {.participant = participant,
          .session = 0,
          .protocol_id = protocol_id,
          .mode = SessionMode::simulate,
          .seed = "18446744073709551615",
          .generator = "philox4x64/1",
          .counterbalance_row = 2,
          .group_level = "haptic",
          .program_version = "0.2.0",
          .program_commit = "abc",
          .program_build = "release",
          .program_sha256 = sha256_of("program"),
          .instruction_set = "avx2",
          .os = "Debian 12",
          .device = "simulated",
          .device_json = R"({"peak_force_N":5})",
          .pacing = "stepped",
          .scheduling = "none",
          .rate_Hz = 1000.0,
          .started_utc = "2026-03-01T09:01:00Z",
          .clock_zero_ns = 1'000'000'000,
          .consent_version = "2",
          .consent_utc = "2026-03-01T09:00:30Z",
          .observer_json = R"({"noise":0})"};
}

inline std::vector<PlannedTrialRow> some_plan(int trials) {
  std::vector<PlannedTrialRow> plan;
  for (int trial = 1; trial <= trials; ++trial) {
    plan.push_back({.trial = trial,
                    .block = "main",
                    .block_ordinal = 1,
                    .phase = "main",
                    .repetition = 1,
                    .factors_json = R"({"texture":"metal"})",
                    .plan_json = "{\"trial\":" + std::to_string(trial) + "}"});
  }
  return plan;
}

inline AttemptRow some_attempt(int trial, int attempt = 1) {
  const std::int64_t onset_ns = std::int64_t{2'000'000'000} * trial;
  AttemptRow row{.trial = trial,
                 .attempt = attempt,
                 .segment = 1,
                 .outcome = AttemptOutcome::answered,
                 .valid = true,
                 .flagged = true,
                 .flag_reason = "saturated for 3 ticks",

                 .onset_ns = onset_ns,
                 .offset_ns = onset_ns + 1'500'000'000};
  row.presentations = {{.position = 1,
                        .role = "alternative",
                        .item = "A",
                        .stimulus = "metal",
                        .model = "height_map",
                        .model_version = "1",
                        .texture = "stimuli/metal.png",
                        .parameters_json = R"({"height_scale":1.5})",
                        .seed = "17",
                        .stiffness_N_per_m = 450.0,
                        .friction = 0.25,
                        .raised_m = 0.001,
                        .onset_ns = row.onset_ns,
                        .contact_ns = row.onset_ns + 1,
                        .offset_ns = row.offset_ns,
                        .contact_s = 1.25,
                        .gaps_in_contact = 4,
                        .matched_texture_force_N = 0.1,
                        .achieved_texture_force_N = 0.09,
                        .assets = {{"height_field", sha256_of("metal")},
                                   {"surface", sha256_of("plate")},
                                   {"tool", sha256_of("ball")},
                                   {"vibrations", sha256_of("recorded")}},
                        .limits = {{"folded", 0}, {"too_fast", 12}},
                        .visits = {{.contact_ns = row.onset_ns + 1,
                                    .offset_ns = row.onset_ns + 2,
                                    .contact_s = 0.75,
                                    .path_m = 0.06,
                                    .force_mean_N = 1.1,
                                    .force_sd_N = 0.2,
                                    .speed_mean_m_per_s = 0.08,
                                    .speed_sd_m_per_s = 0.03},
                                   {.contact_ns = row.onset_ns + 3,
                                    .offset_ns = row.onset_ns + 4,
                                    .contact_s = 0.5}},
                        .instability = InstabilityRow{.buzz = 0.31,
                                                      .buzz_force_N = 0.032,
                                                      .buzz_ns = row.onset_ns + 2,
                                                      .resting_s = 0.8,
                                                      .alive_force_N = 0.041,
                                                      .alive_plate_force_N = 0.037,
                                                      .alive_motion_m = 2e-5,
                                                      .alive_work_J = -3e-6,
                                                      .no_crest_share = "no_crests"}},
                       {.position = 2, .role = "alternative", .item = "B", .seed = "18"}};
  row.responses = {{.question = "which",
                    .item = 1,
                    .answer = "B",
                    .answer_number = 2.0,
                    .correct = true,
                    .options_json = R"(["A","B"])",
                    .time_ns = row.offset_ns,
                    .from_contact_s = 1.5,
                    .from_cue_s = 0.5,
                    .source = "virtual"},
                   {.question = "confidence", .answer = "sure", .time_ns = 1, .source = "virtual"}};
  row.servo = ServoQualityRow{.rate_Hz = 1000.0,
                              .ticks = 1500,
                              .period_mean_s = 0.001,
                              .period_sd_s = 0.002,
                              .period_p50_s = 0.003,
                              .period_p99_s = 0.004,
                              .period_p99_9_s = 0.005,
                              .period_maximum_s = 0.006,
                              .lateness_p50_s = 0.007,
                              .lateness_p99_s = 0.008,
                              .lateness_maximum_s = 0.009,
                              .execution_p99_s = 0.010,
                              .execution_maximum_s = 0.011,
                              .missed_deadlines = 9,
                              .missed_in_contact = 1,
                              .gaps_in_contact = 6,
                              .held_readings = 7,
                              .saturated_ticks = 2,
                              .slew_limited_ticks = 3,
                              .not_finite_ticks = 4,
                              .lost_records = 5,
                              .fault = "late"};
  row.compliance = {{.position = 1,
                     .quantity = "normal_force_N",
                     .minimum = 0.5,
                     .maximum = 1.5,
                     .mean = 1.0,
                     .sd = 0.1,
                     .p05 = 0.8,
                     .p50 = 1.01,
                     .p95 = 1.2,
                     .fraction_in_band = 0.97,
                     .passed = true},
                    {.position = 1, .quantity = "contact_s", .mean = 1.25}};
  row.events = {{.time_ns = 5, .kind = "contact", .text = "first", .data_json = R"({"z":1})"},
                {.time_ns = 4, .kind = "later", .text = "though earlier"}};
  return row;
}

/// A study with one participant and one session of `trials` trials, ready for attempts.
struct StudyWithSession {
  Study study;
  std::int64_t session_id = 0;
};

inline StudyWithSession study_with_session(const std::filesystem::path& folder, int trials) {
  Study study = Study::create(folder, "some study");
  study.add_participant(some_participant());
  const std::int64_t protocol_id = study.add_protocol(some_protocol());
  const std::int64_t session_id = study.add_session(some_session(protocol_id), some_plan(trials));
  study.begin_segment(session_id, 1'000'000'000);
  return {std::move(study), session_id};
}

}  // namespace asperity
