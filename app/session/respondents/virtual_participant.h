// A simulated participant that answers according to a virtual observer.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/session/respondents/respondent.h"
#include "app/session/respondents/visit_tally.h"
#include "app/session/stimulus_builder.h"
#include "device/simulated_device.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/observer/virtual_observer.h"

namespace asperity {

/// By the name of an exploration: what a texture feels like depends on the force and the speed of the hand.
using ExpectationsByExploration = std::map<std::string, Expectations, std::less<>>;

/// The expectations of one virtual participant under a protocol's declaration, for every exploration of the protocol.
///
/// For `true_surface` the true height field of each texture is felt once in each exploration, by the same kind of hand
/// on another stroke with another seed, through the unmodified law of `height_map` at its defaults:
/// never through a renderer of the session. Where the declaration gives a `gaussian_wavelength_m`,
/// the long waves are first removed from the true heights, as a photograph's heights lack them; the
/// expectation contains that band, and no other information on how a texture was made.
///
/// A texture that is felt only on bodies has no heights that would determine its force without
/// them. For such a texture the first stimulus that shows it is felt once, also by another hand
/// with another seed, with its complete bodies, through its own model at that model's defaults.
///
/// For `prior` the expectations are those stated in the protocol.
ExpectationsByExploration expectations_of(const Protocol& protocol, StimulusBuilder& builder,
                                          const Random& random);

/// Answers as a VirtualObserver judges, with the expectations for the exploration of the trial. Every
/// attempt has a separate random stream, so that a session that was interrupted and resumed gives the
/// same answers as an uninterrupted one.
///
/// Where there is no expectation (no truth and no prior) or the observer is deaf, the answer is a
/// guess among the open surfaces or pictures; "I cannot tell" is never answered. `source` is
/// "virtual_guess" after a guess and "virtual" after any other answer; lapses are part of the
/// judgement.
///
/// A rating of the confidence of a response grows with the certainty of the decision (VirtualObserver::certainty).
///
/// A number for a surface is VirtualObserver::estimate of the features of its force, scaled by the
/// participant's habit of choosing numbers; when asked again, it gives the same number. It requires
/// no expectation, and is a guess only for a deaf observer.
///
/// Questions of the questionnaire have random answers, which depend on the participant and the name of the question
/// alone: an option, each option of a multiple choice with the probability ½ (at least one), a whole number in the
/// range, a point of the scale. Texts are left empty.
///
/// Virtual results test the software and are no evidence of which model participants prefer.
class VirtualParticipant final : public Respondent {
 public:
  VirtualParticipant(const Protocol& protocol, ExpectationsByExploration expectations,
                     ParticipantRow person, const Random& random);

  void read(const std::string& text, double minimum_s, const Wait& wait) override;
  void announce(const Trial& trial, const PlannedPresentation& surface) override;
  Reply ask(const Trial& trial, std::span<const Question> page, std::span<const ForceFeatures> felt,
            std::optional<double> deadline_s, const Wait& wait) override;
  void tell(const std::string& text, const Wait& wait) override;
  std::optional<Answer> answer(const Question& question, const Wait& wait) override;
  std::string source() const override { return source_; }
  void begin_attempt(int trial, int attempt) override;

  /// Over surfaces side by side the hand continues until it may go on; elsewhere the session ends a visit.
  bool wants_next(bool may_go) override { return felt_side_by_side_ && may_go; }

 private:
  /// The earlier response of the attempt whose confidence the question rates; null for all other questions.
  const VirtualResponse* response_rated_by(const Trial& trial, const Question& question) const;

  const Protocol& protocol_;
  ExpectationsByExploration expectations_{};
  ParticipantRow person_{};
  VisitTally visits_{};  ///< of the attempt
  std::map<std::string, VirtualResponse, std::less<>>
      responses_{};  ///< of the attempt, by question
  bool felt_side_by_side_ = false;
  Random random_;
  Random attempt_random_;
  std::string source_{};  ///< of the last answer
};

/// The n-th virtual participant of a study: label "virtual0001", sex alternating F, M, age and hand
/// drawn from its stream.
ParticipantRow virtual_person(int number, const Random& random, const std::string& created_utc);

}  // namespace asperity
