// Labels of participants, and their answers to the protocol's questions.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "protocols/design/protocol.h"
#include "results_schema/rows.h"

namespace asperity {

/// The label that continues those of the study's people: among the labels with the most common
/// prefix, the highest number plus one, with the same number of digits ("P009" → "P010"). "sub001"
/// where no label ends with digits.
std::string suggested_label(const std::vector<ParticipantRow>& participants);
/// "virtual0003" after two virtual participants.
std::string next_virtual_label(const std::vector<ParticipantRow>& participants);

/// The problem of an answer, as a sentence; nothing when it is acceptable. An empty answer is an
/// omitted one.
std::optional<Phrase> complaint_about_answer(const Question& question, const std::string& answer);

/// Answers by the name of their question.
using ParticipantAnswers = std::map<std::string, std::string, std::less<>>;

/// A participant with the answers where the store keeps them: "sex", "handedness" and "age" in
/// separate columns, the others together. Omitted answers are not stored.
ParticipantRow person_of(const std::string& label, const Protocol& protocol,
                         const ParticipantAnswers& answers, const std::string& created_utc);

/// Whether the left hand holds the handle: by "hand_used" where it was asked, otherwise by
/// handedness.
bool uses_left_hand(const ParticipantRow& person);

}  // namespace asperity
