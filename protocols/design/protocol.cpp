// Implements the texts of enumerations and levels, as they are written in files and in the store.

#include "protocols/design/protocol.h"

#include "protocols/design/wording.h"

namespace asperity {

const char* text_of(ProtocolDesign design) noexcept {
  switch (design) {
    case ProtocolDesign::chapter:
      return "chapter";
    case ProtocolDesign::improved:
      return "improved";
  }
  return "";
}

const char* text_of(Vision vision) noexcept {
  switch (vision) {
    case Vision::free:
      return "free";
    case Vision::hand_occluded:
      return "hand_occluded";
    case Vision::blindfold:
      return "blindfold";
  }
  return "";
}

const char* text_of(VisualTexture texture) noexcept {
  switch (texture) {
    case VisualTexture::on:
      return "on";
    case VisualTexture::off:
      return "off";
    case VisualTexture::neutral:
      return "neutral";
  }
  return "";
}

const char* text_of(Phase phase) noexcept {
  switch (phase) {
    case Phase::familiarisation:
      return "familiarisation";
    case Phase::practice:
      return "practice";
    case Phase::main:
      return "main";
  }
  return "";
}

const char* text_of(AnchorPlace place) noexcept {
  switch (place) {
    case AnchorPlace::start:
      return "start";
    case AnchorPlace::middle:
      return "middle";
    case AnchorPlace::end:
      return "end";
  }
  return "";
}

const char* text_of(ObserverDeclaration::MagnitudeOf what) noexcept {
  switch (what) {
    case ObserverDeclaration::MagnitudeOf::lateral_force:
      return "lateral_force";
    case ObserverDeclaration::MagnitudeOf::normal_force:
      return "normal_force";
    case ObserverDeclaration::MagnitudeOf::held_tool:
      return "held_tool";
    case ObserverDeclaration::MagnitudeOf::compliance:
      return "compliance";
  }
  return "";
}

std::vector<Question> questions_about_participant(const Protocol& protocol) {
  std::vector<Question> questions{};
  for (const std::string& name : protocol.participant_questions) {
    const auto found = protocol.questions.find(name);
    if (found != protocol.questions.end()) questions.push_back(found->second);
  }
  return questions;
}

const char* text_of(Protocol::Groups::Assignment assigned) noexcept {
  switch (assigned) {
    case Protocol::Groups::Assignment::balanced:
      return "balanced";
    case Protocol::Groups::Assignment::permuted_blocks:
      return "permuted_blocks";
    case Protocol::Groups::Assignment::by_experimenter:
      return "by_experimenter";
  }
  return "";
}

const char* text_of(Protocol::Noise::Kind kind) noexcept {
  switch (kind) {
    case Protocol::Noise::Kind::none:
      return "none";
    case Protocol::Noise::Kind::white:
      return "white";
    case Protocol::Noise::Kind::pink:
      return "pink";
  }
  return "";
}

std::vector<std::string> speech_cues() {
  std::vector<std::string> cues{"next", "question", "accepted", "refused",  "right",   "wrong",
                                "rest", "paused",   "mask_on",  "mask_off", "finished"};
  constexpr int kMost = 26;  // surfaces have letters
  for (int number = 1; number <= kMost; ++number) {
    cues.push_back("surface_" + std::to_string(number));
    cues.push_back("option_" + std::to_string(number));
  }
  return cues;
}

std::string text_of(const Level& level) {
  const double* const number = std::get_if<double>(&level);
  return number == nullptr ? std::get<std::string>(level) : digits(*number);
}

}  // namespace asperity
