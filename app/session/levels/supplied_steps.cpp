// Stores each step as JSON of an event, and supplies a course with them in the stored order.

#include "app/session/levels/supplied_steps.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/words/event_kinds.h"

namespace asperity {

namespace {

std::string place_of(int block_ordinal, const TrackStep& of) {
  return "block " + std::to_string(block_ordinal) + ", track " + std::to_string(of.track) +
         ", step " + std::to_string(of.step);
}

SuppliedStep step_in(const std::string& data_json) {
  try {
    const auto json = nlohmann::json::parse(data_json);
    SuppliedStep step{
        .block_ordinal = json.at("block_ordinal").get<int>(),
        .of = {.track = json.at("track").get<int>(), .step = json.at("step").get<int>()}};
    if (json.contains("end")) {
      step.step = TrackEnd::program;
    } else {
      step.step = NextLevel{json.at("level").get<double>()};
      step.stated = json.at("stated").get<double>();
    }
    return step;
  } catch (const nlohmann::json::exception&) {
    throw std::runtime_error("the stored level of an external program cannot be read: " +
                             data_json + "; restore the study from a copy");
  }
}

}  // namespace

std::string json_of(const SuppliedStep& step) {
  nlohmann::ordered_json json{
      {"block_ordinal", step.block_ordinal}, {"track", step.of.track}, {"step", step.of.step}};
  if (const auto* const next = std::get_if<NextLevel>(&step.step)) {
    json["stated"] = step.stated;
    json["level"] = next->level;
  } else {
    json["end"] = true;
  }
  return json.dump();
}

SuppliedSteps::SuppliedSteps(const std::vector<EventRow>& events) {
  for (const EventRow& event : events) {
    if (event.kind == kExternalLevel) steps_.push_back(step_in(event.data_json));
  }
}

bool SuppliedSteps::supply(Course& course) {
  if (left() == 0) return false;
  const LevelRequest& request = course.requested().value();
  const SuppliedStep& stored = steps_[next_];
  if (stored.block_ordinal != request.block_ordinal || stored.of != request.of) {
    throw std::runtime_error(
        "the stored level of an external program belongs to " +
        place_of(stored.block_ordinal, stored.of) + ", but the earlier responses determine that " +
        place_of(request.block_ordinal, request.of) +
        " comes next; use the version of Asperity that ran the session, or restore the study from "
        "a copy");
  }
  const auto* const next = std::get_if<NextLevel>(&stored.step);
  if (next != nullptr && presented_level(request.settings, stored.stated) != next->level) {
    throw std::runtime_error(
        "the stored level of an external program in " + place_of(stored.block_ordinal, stored.of) +
        " is not the level of its block that is nearest to the one that the program stated; "
        "restore the study from a copy");
  }
  course.supply(stored.step);
  ++next_;
  return true;
}

}  // namespace asperity
