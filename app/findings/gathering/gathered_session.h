// Adds the responses of one session to those of its group.

#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/gathering/questions_of_kind.h"

namespace asperity {

/// A session with the questions of the kind that is gathered.
struct SessionToGather {
  const SessionRow& row;
  const ParticipantRow& participant;
  const SessionAnswers& answers;
  const QuestionsOfKind& questions;
};

/// Indices in GatheredAnswers::option_lists, by the JSON of a list.
using OptionListPlaces = std::map<std::string, std::uint32_t>;

/// Counts the session and its attempts in `gathered`, and adds its responses, anchors and catch trials.
void gather_session(const SessionToGather& session, OptionListPlaces& option_lists,
                    GatheredAnswers& gathered);

}  // namespace asperity
