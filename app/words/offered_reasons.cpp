// The table of the offered reasons, with their codes.

#include "app/words/offered_reasons.h"

#include <algorithm>

namespace asperity {

namespace {

struct OfferedReason {
  const char* code = nullptr;
  Phrase words{};
  std::vector<ReasonFor> offered_for{};  ///< empty: not offered, stated by the program
};

const std::vector<OfferedReason>& offered_table() {
  using For = ReasonFor;
  static const std::vector<OfferedReason> kOffers{
      {"participant_distracted",
       phrase("OfferedReasons", "The participant was distracted"),
       {For::repeating}},
      {"wrong_key", phrase("OfferedReasons", "Wrong key pressed"), {For::repeating}},
      {"participant_asked",
       phrase("OfferedReasons", "Requested by the participant"),
       {For::repeating}},
      {"participant_cannot_answer",
       phrase("OfferedReasons", "The participant cannot answer"),
       {For::skipping}},
      {"participant_declines",
       phrase("OfferedReasons", "The participant does not want to continue"),
       {For::skipping}},
      {"participant_stops",
       phrase("OfferedReasons", "The participant wishes to stop"),
       {For::aborting}},
      {"participant_unwell",
       phrase("OfferedReasons", "The participant is unwell"),
       {For::aborting}},
      {"technical_problem",
       phrase("OfferedReasons", "Technical problem"),
       {For::repeating, For::skipping, For::aborting}},
      {"participant_safety",
       phrase("OfferedReasons", "Safety of the participant"),
       {For::unblinding}},
      {"stimulus_fault_suspected",
       phrase("OfferedReasons", "Suspected fault of a stimulus"),
       {For::unblinding}},
      {"experimenter_not_involved",
       phrase("OfferedReasons", "Not the experimenter of this study"),
       {For::unblinding}},
      {"participant_seemed_distracted",
       phrase("OfferedReasons", "The participant seemed distracted"),
       {For::flagging}},
      {"hand_slipped", phrase("OfferedReasons", "The hand slipped"), {For::flagging}},
      {"person_came_in", phrase("OfferedReasons", "A person entered the room"), {For::flagging}},
      {"force_felt_wrong", phrase("OfferedReasons", "The force felt wrong"), {For::flagging}},
      {"answer_retracted",
       phrase("OfferedReasons", "The participant retracted the response"),
       {For::flagging}},
      {"consent_withdrawn",
       phrase("OfferedReasons", "The participant withdrew consent"),
       {For::excluding_session}},
      {"instruction_not_followed",
       phrase("OfferedReasons", "The participant did not follow the instruction"),
       {For::excluding_attempt, For::excluding_session}},
      {"interrupted", phrase("OfferedReasons", "Interrupted"), {For::excluding_attempt}},
      {"answered_by_mistake",
       phrase("OfferedReasons", "Answered by mistake"),
       {For::excluding_attempt}},
      {"device_malfunction",
       phrase("OfferedReasons", "The device malfunctioned"),
       {For::excluding_attempt, For::excluding_session}},
      {"surface_recognized_otherwise",
       phrase("OfferedReasons", "The surface was recognised by cues other than touch"),
       {For::excluding_attempt}},
      {"test_run", phrase("OfferedReasons", "It was a test run"), {For::excluding_session}},
      {"excluded_by_mistake", phrase("OfferedReasons", "Excluded by mistake"), {For::including}},
      {"exclusion_unfounded",
       phrase("OfferedReasons", "The reason proved unfounded"),
       {For::including}},
      {"note_pressed_hard", phrase("OfferedReasons", "Pressed hard"), {For::noting}},
      {"note_lifted_early", phrase("OfferedReasons", "Lifted early"), {For::noting}},
      {"note_grip_changed", phrase("OfferedReasons", "Grip changed"), {For::noting}},
      {"note_hand_slipped", phrase("OfferedReasons", "Hand slipped"), {For::noting}},
      {"note_hand_tired", phrase("OfferedReasons", "Hand is tired"), {For::noting}},
      {"note_jolt", phrase("OfferedReasons", "Felt a jolt"), {For::noting}},
      {"note_distracted", phrase("OfferedReasons", "Distracted"), {For::noting}},
      {"note_question", phrase("OfferedReasons", "Had a question"), {For::noting}},
      {"note_noise", phrase("OfferedReasons", "Noise outside"), {For::noting}},
      {"not_eligible", phrase("OfferedReasons", "The participant was not eligible")},
      {"withdrawn", phrase("OfferedReasons", "The participant was withdrawn")},
  };
  return kOffers;
}

}  // namespace

std::vector<Phrase> offered_reasons(ReasonFor what) {
  std::vector<Phrase> offered{};
  for (const OfferedReason& one : offered_table()) {
    const auto& uses = one.offered_for;
    if (std::find(uses.begin(), uses.end(), what) != uses.end()) {
      offered.push_back(one.words.coded(one.code));
    }
  }
  return offered;
}

std::vector<Phrase> coded_offers() {
  std::vector<Phrase> all{};
  for (const OfferedReason& one : offered_table()) all.push_back(one.words.coded(one.code));
  return all;
}

}  // namespace asperity
