// Replies to the question of a trial, made and read in short.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/session/respondents/respondent.h"

namespace asperity {

/// The option, counted from 0.
inline Reply chooses(std::size_t option) { return {only_answer(ChosenOption{option})}; }
inline Reply feels_again(int position, std::optional<std::int64_t> answered_ns = {}) {
  return {FeelAgain{position}, answered_ns};
}
inline Reply gives(double number) { return {only_answer(GivenNumber{number})}; }

/// The options of a choice or an assignment, counted from 0; empty of any other reply.
inline std::vector<std::size_t> options_of(const Reply& reply) {
  if (reply.answer() == nullptr) return {};
  if (const auto* const chosen = std::get_if<ChosenOption>(reply.answer())) return {chosen->option};
  if (const auto* const assigned = std::get_if<AssignedOptions>(reply.answer()))
    return assigned->options;
  return {};
}
/// Position of the surface to be felt again; 0 of any other reply.
inline int felt_again(const Reply& reply) {
  return reply.feel_again() == nullptr ? 0 : reply.feel_again()->position;
}

}  // namespace asperity
