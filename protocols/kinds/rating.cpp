// The tests, checks and judgement of a rating.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "protocols/kinds/kind_list.h"
#include "protocols/kinds/rating_responses.h"

namespace asperity {

namespace {

constexpr std::array kRatingTests{
    KindTest{"ratings", "whether ratings differ between the items, for every scale"},
    KindTest{"rated_pairs",
             "whether the ratings of two items differ, for every pair of items on every scale"},
    KindTest{"rating_model",
             "whether the ratings depend on the item in an analysis of variance of the "
             "participants' mean ratings, for every scale"},
    KindTest{"accompanying_scales",
             "whether ratings differ between correct and incorrect responses, for every scale that "
             "accompanies a question with correct responses"},
    KindTest{kGroupsTest,
             "whether the mean ratings of two groups differ, for every scale and pair of groups"},
    KindTest{kGroupProfilesTest,
             "whether the differences between the items differ between two groups, for every scale "
             "and pair"}};

std::string item_of_rating(const PlannedPresentation& surface) {
  return surface.stimulus.texture.empty() ? surface.stimulus.model : surface.stimulus.texture;
}

void check_block_of_rating(const BlockOfKind& checked, ProblemSink& problems) {
  if (checked.block.presented.size() != 1) {
    problems.report(
        checked.pointer + "/presented",
        phrase("Protocols", "a rating presents exactly one surface per trial; list one here"));
  }
}

/// The confidence in a response: of the n points of the scale the one with the number 1 + ⌊n·q⌋, from the lowest, at most n,
/// q being the certainty of the response (VirtualObserver::certainty). The points are equally probable where the decision
/// variable is normal with the criterion as its mean, and q grows with its distance from the criterion. In a lapse, after a
/// guess, and if deaf, every point is equally probable.
VirtualResponse rate_confidence(const Judgement& judgement) {
  const int steps = std::get<ScaleForm>(judgement.question.form).steps();
  const std::optional<double>& certainty = judgement.rated->certainty;
  const int step =
      certainty ? std::min(steps, static_cast<int>(std::floor(*certainty * (steps + 1))))
                : static_cast<int>(judgement.observer.guess(static_cast<std::size_t>(steps) + 1));
  return {ScalePoint{step}, judgement.rated->is_guess};
}

/// The confidence in a response (`rate_confidence`), or a point on the scale: the standard logistic function of
/// 3·l·(r + ε + 4.3) + b + η.
///
/// r + ε is what the observer perceives of the first surface (VirtualObserver::estimate): with the normal force, −3 to −5.2
/// for the textures of the demo study. l is the loading of the question, between 0.5 and 1 with either sign, which
/// its name determines: scales correlate positively or negatively, and for all participants alike.
/// b ~ N(0, 0.3²) is the participant's bias on this scale, and η ~ N(0, 0.4²) varies over responses.
VirtualResponse judge_rating(const Judgement& judgement) {
  if (judgement.rated != nullptr) return rate_confidence(judgement);
  constexpr double kMedium = -4.3;
  constexpr double kSlope = 3.0;
  const auto& form = std::get<ScaleForm>(judgement.question.form);
  const std::string& name = judgement.question.name;
  Random of_question = Random(0).split("loading of a scale").split(name);
  const double sign = of_question.uniform() < 0.5 ? -1.0 : 1.0;
  const double loading = sign * (0.5 + 0.5 * of_question.uniform());
  Random of_participant = judgement.of_participant.split("bias on a scale").split(name);
  Random of_response = judgement.of_attempt.split("response on a scale").split(name);
  constexpr NumberHabit kExact{.modulus = 1.0, .digits = 6};
  const double perceived = std::log(judgement.observer.estimate(judgement.felt.front(), kExact));
  const double position = kSlope * loading * (perceived - kMedium) + 0.3 * of_participant.normal() +
                          0.4 * of_response.normal();
  const double share = 1.0 / (1.0 + std::exp(-position));
  return {ScalePoint{static_cast<int>(std::lround(share * form.steps()))}, false};
}

}  // namespace

const ExperimentKind& rating_kind() {
  static const ExperimentKind kKind{.id = "rating",
                                    .name = phrase("Protocols", "rating"),
                                    .roles = kTargetRole,
                                    .form = ScaleForm{},
                                    .asks_several = true,
                                    .tests = kRatingTests,
                                    .item_of = item_of_rating,
                                    .check_block = check_block_of_rating,
                                    .judge = judge_rating,
                                    .responses = &rating_responses()};
  return kKind;
}

}  // namespace asperity
