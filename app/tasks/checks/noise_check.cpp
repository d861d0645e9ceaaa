// Compares the sound output and the stated level with the noise, cues and tones of the protocol.

#include "app/tasks/checks/noise_check.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

}  // namespace

SessionCheck noise_check(const CheckInputs& inputs, const Protocol& protocol) {
  // Silence indicates correct force and speed. Without a sound output it would do so always.
  const bool guides_by_tones = std::any_of(
      protocol.explorations.begin(), protocol.explorations.end(),
      [](const auto& each) { return each.second.guidance == Exploration::Guidance::tones; });
  if (guides_by_tones && !inputs.sound_card && inputs.mode != SessionMode::simulate) {
    SessionCheck unheard{};
    unheard.state = inputs.mode == SessionMode::run ? State::stop : State::look;
    unheard.text =
        phrase("SessionChecks",
               "There is no sound output: the tones by which the protocol guides the hand cannot "
               "be heard, and silence would indicate that force and speed are correct.");
    unheard.remedy = phrase("SessionChecks", "Connect headphones, then check again.");
    return unheard;
  }
  const MaskingNoise declared = declared_noise(protocol);
  if (declared.kind == MaskingNoise::Kind::none) {
    const bool led_by_cues =
        protocol.vision == Vision::blindfold && inputs.mode != SessionMode::simulate;
    if (inputs.sound_card || !led_by_cues) {
      return fine_check(phrase("SessionChecks", "The protocol requires no masking noise."));
    }
    SessionCheck check{};
    check.state = State::look;
    check.text =
        phrase("SessionChecks",
               "There is no sound output: a participant who wears an eye mask hears no cues.");
    check.remedy =
        phrase("SessionChecks",
               "Connect headphones, then check again; or guide the participant by voice.");
    return check;
  }
  if (inputs.mode == SessionMode::simulate) {
    return fine_check(phrase("SessionChecks", "Not needed: no participant listens."));
  }
  SessionCheck check{};
  // A pilot session may serve to find the level; study data require the declared one.
  const State when_unmet = inputs.mode == SessionMode::run ? State::stop : State::look;
  // Without a sound output the noise comes from another source, whose level a named person has measured.
  if (!inputs.sound_card && !inputs.noise.is_attested()) {
    check.state = when_unmet;
    check.text =
        phrase("SessionChecks",
               "There is no sound output: the noise that the protocol requires cannot be heard.");
    check.remedy = phrase("SessionChecks",
                          "Connect headphones, then check again; or play the noise from another "
                          "source, measure it at the ear, and enter the level and your name.");
    return check;
  }
  if (!inputs.noise.is_attested()) {
    check.state = when_unmet;
    check.text =
        inputs.noise.measured_dBA
            ? phrase("SessionChecks", "It is not stated who measured the level at the ear.")
            : phrase("SessionChecks", "The level at the ear was not measured.");
    check.remedy =
        phrase("SessionChecks",
               "Play the noise, measure it at the ear, and enter the level and your name.");
    return check;
  }
  const std::string measured_dBA = fixed(*inputs.noise.measured_dBA, 1);
  if (declared.declared_dBA &&
      std::abs(*inputs.noise.measured_dBA - *declared.declared_dBA) > kNoiseTolerance_dBA) {
    check.state = when_unmet;
    check.text =
        phrase("SessionChecks", "%1 dB(A) at the ear; the protocol requires %2 ± %3 dB(A).")
            .with(measured_dBA, fixed(*declared.declared_dBA, 1), fixed(kNoiseTolerance_dBA, 0));
    check.remedy = phrase("SessionChecks", "Change the gain and measure again.");
    return check;
  }
  if (!inputs.sound_card) {
    check.state = State::look;
    check.text = phrase("SessionChecks",
                        "There is no sound output here; the noise comes from another source, %1 "
                        "dB(A) at the ear, verified by %2.")
                     .with(measured_dBA, inputs.noise.verified_by);
    return check;
  }
  check.text = phrase("SessionChecks", "%1 dB(A) at the ear, verified by %2.")
                   .with(measured_dBA, inputs.noise.verified_by);
  return check;
}

MaskingNoise declared_noise(const Protocol& protocol) {
  MaskingNoise noise{};
  switch (protocol.masking_noise.kind) {
    case Protocol::Noise::Kind::none:
      noise.kind = MaskingNoise::Kind::none;
      break;
    case Protocol::Noise::Kind::white:
      noise.kind = MaskingNoise::Kind::white;
      break;
    case Protocol::Noise::Kind::pink:
      noise.kind = MaskingNoise::Kind::pink;
      break;
  }
  noise.declared_dBA = protocol.masking_noise.level_dBA;
  return noise;
}

}  // namespace asperity
