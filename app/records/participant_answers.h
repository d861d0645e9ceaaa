// Who takes part, as they said it: labels, and answers to the protocol's questions.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/words/phrase.h"
#include "protocols/design/protocol.h"
#include "results_schema/rows.h"

namespace asperity {

/// The label that continues those of the study's people: the one with the highest number of the
/// commonest beginning, plus one, with as many digits ("P009" → "P010"). "sub001" where nobody has
/// a label that ends with digits.
std::string suggested_label(const std::vector<ParticipantRow>& participants);
/// "virtual0003" after two virtual participants.
std::string next_virtual_label(const std::vector<ParticipantRow>& participants);

/// What is wrong with an answer, as a sentence; nothing when it is acceptable. An empty answer is
/// one that was left out.
std::optional<Phrase> complaint_about_answer(const Question& question, const std::string& answer);

/// Answers by the name of their question.
using ParticipantAnswers = std::map<std::string, std::string, std::less<>>;

/// A person with their answers where the store keeps them: "sex", "handedness" and "age" in columns
/// of their own, the others together. Answers that were left out are not stored.
ParticipantRow person_of(const std::string& label, const Protocol& protocol,
                         const ParticipantAnswers& answers, const std::string& created_utc);

/// The left hand holds the handle: by "hand_used" where it was asked, otherwise by handedness.
bool uses_left_hand(const ParticipantRow& person);

}  // namespace asperity
