// A participant made of arithmetic, with a body and a biography.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/session/respondents/respondent.h"
#include "app/session/stimulus_builder.h"
#include "device/simulated_device.h"
#include "protocols/observer/virtual_observer.h"

namespace asperity {

/// Expectations of one virtual participant under a protocol's declaration.
///
/// For `true_surface` the true height field of each texture is felt once, by the same kind of hand
/// on another stroke with another seed, through the plain law of `height_map` at its defaults:
/// never through a renderer of the session. Where the declaration gives a `gaussian_wavelength_m`,
/// the long waves are taken from the true heights first, as a photograph's heights lack them; the
/// expectation contains that band, and nothing else of how a texture was made.
///
/// A texture that is felt on bodies only has no heights that would determine what it feels like
/// without them: there the first stimulus that shows it is felt once, likewise by another hand with another
/// seed, its bodies whole, through its own model at that model's defaults.
///
/// For `prior` they are those stated in the protocol.
Expectations expectations_of(const Protocol& protocol, StimulusBuilder& builder,
                             const Random& random);

/// Answers as a VirtualObserver judges. Every attempt draws from its own stream, so that a session
/// which was interrupted and resumed gets the answers of one that was not.
///
/// Where nothing is expected (no truth and no prior) or the observer is deaf, the answer is a guess
/// among the surfaces or pictures that are open; "I cannot tell" is never answered. `source` is
/// "virtual_guess" after a guess and "virtual" after any other answer; lapses belong to judging.
///
/// A number for a surface is VirtualObserver::estimate of the features of what was felt, with a habit
/// of choosing numbers that belongs to the participant; asked once more, it chooses the same. It needs no
/// expectation, and is a guess only of who is deaf.
///
/// Virtual results exercise the machinery and are no evidence of which model participants prefer.
class VirtualParticipant final : public Respondent {
 public:
  VirtualParticipant(const Protocol& protocol, Expectations expectations, ParticipantRow person,
                     const Random& random);

  void read(const std::string& text, double minimum_s, const Wait& wait) override;
  void announce(const Trial&, const PlannedPresentation&) override {}
  Reply ask(const Trial& trial, std::span<const ForceFeatures> felt,
            std::optional<double> deadline_s, const Wait& wait) override;
  void tell(const std::string& text, const Wait& wait) override;
  std::string answer(const Question& question, const Wait& wait) override;
  std::string source() const override { return source_; }
  void begin_attempt(int trial, int attempt) override;

 private:
  const Protocol& protocol_;
  Expectations expectations_{};
  ParticipantRow person_{};
  Random random_;
  Random attempt_random_;
  std::string source_{};  ///< of the last answer
};

/// The n-th virtual participant of a study: label "virtual0001", sex alternating F, M, an age and a
/// hand from its stream.
ParticipantRow virtual_person(int number, const Random& random, const std::string& created_utc);

}  // namespace asperity
