// The keys that only a discrimination has.

#pragma once

#include "protocols/kind_keys/discrimination.h"
#include "protocols/shapes/common_shapes.h"
#include "protocols/shapes/keys_of.h"

namespace asperity {

extern const KeyTableOf<CatchExclusion> kExclusionTable;

inline constexpr auto kJudgements = words_of<DiscriminationJudgement>(
    {{"performance", DiscriminationJudgement::performance,
      "the comparison is the correct response"},
     {"comparison", DiscriminationJudgement::comparison,
      "no response is correct, and the point of subjective equality is estimated"}});
inline constexpr auto kAsksForWords = words_of<DiscriminationQuestion::AsksFor>(
    {{"more", DiscriminationQuestion::AsksFor::more, "the higher value"},
     {"less", DiscriminationQuestion::AsksFor::less, "the lower value"}});

/// Of the question.
inline constexpr auto kDiscriminationQuestionKeys = owned_by(
    {"discrimination"},
    keys_of(
        when(listing_words(member_key<&DiscriminationQuestion::judgement>(
                 "judgement", "Judgement", "Discrimination: whether a response can be correct.",
                 kJudgements)),
             kOfTheKind, without("scale")),
        when(with_standard(
                 member_key<&DiscriminationQuestion::asks_for>(
                     "asks_for", "Asks for",
                     "Discrimination with the judgement comparison: whether the question asks for "
                     "the surface with the higher or the lower value of the varied parameter.",
                     kAsksForWords),
                 [](const ProtocolKey&) { return nlohmann::json("more"); }),
             where("judgement", {"comparison"}))));

/// Of a scale next to it.
inline constexpr auto kConfidenceKeys = owned_by(
    {"discrimination"},
    keys_of(when(member_key<&ConfidenceRating::of>(
                     "confidence_of", "Confidence of",
                     "Of a scale in a block of a discrimination: the earlier question whose "
                     "response it rates the confidence of.",
                     NameShape{kAnswerNames}),
                 kScaleOfTheKind, with("scale"))));

inline constexpr std::array<KeyWord, 5> kDiscriminationDesigns{
    {{"two_alternatives", 0, "one of two surfaces is chosen"},
     {"three_alternatives", 0, "the comparison is chosen among two standards"},
     {"oddity", 0,
      "of three surfaces, two of them equal, the odd one is chosen, which is equally often a "
      "comparison and a standard"},
     {"yes_no", 0, "one surface, the standard or the comparison, with the options yes and no"},
     {"same_different", 0,
      "two surfaces, equal or different, with the options same and different"}}};

inline void store_design(const nlohmann::json& value, DiscriminationBlock& block) {
  block.design = find_design(value.get<std::string>());
}

/// Of a block.
inline constexpr auto kDiscriminationBlockKeys = owned_by(
    {"discrimination"},
    keys_of(with_standard(
        listing_words(custom_key<&store_design>(
            "design", "Design", "Discrimination: the surfaces of a trial, and the response.",
            WordShape{kDiscriminationDesigns})),
        [](const ProtocolKey&) { return nlohmann::json("two_alternatives"); })));

inline constexpr auto kObserverEffects =
    words_of<bool>({{"increases", false, "it increases with the parameter"},
                    {"decreases", true, "it decreases with the parameter"}});

inline constexpr NumberShape kObserverCriterion{.above = 0.0, .maximum = 1000.0};

/// Of a virtual participant.
inline constexpr auto kComparisonKeys = keys_of(
    when(member_key<&DiscriminationObserver::magnitude_decreases>(
             "effect", "Effect of the parameter",
             "Discrimination and paired comparison: whether the magnitude increases or decreases "
             "with the parameter.",
             kObserverEffects),
         of_kinds({"discrimination", "paired_comparison"})));
inline constexpr auto kObserverCriterionKeys = owned_by(
    {"discrimination"},
    keys_of(
        member_key<&DiscriminationObserver::yes_above>(
            "yes_above", "Criterion of yes",
            "Discrimination with the options yes and no: the magnitude above which the response is "
            "yes, in the unit of the judged quantity: as a fraction of the mean normal force, in "
            "m/s² or in mm/N; below which, where a signal has the smaller magnitude.",
            kObserverCriterion),
        member_key<&DiscriminationObserver::different_above>(
            "different_above", "Criterion of different",
            "Discrimination with the options same and different: the relative difference of two "
            "magnitudes from which on the response is different; 0.1 is a difference of 10 %.",
            kObserverCriterion),
        member_key<&DiscriminationObserver::unsure_within>(
            "unsure_within", "Criterion of uncertainty",
            "Discrimination with the option \"I cannot tell\": the relative difference of two "
            "magnitudes below which this is the response; 0.1 is a difference of 10 %.",
            kObserverCriterion)));
inline constexpr auto kDiscriminationObserverKeys = joined(kComparisonKeys, kObserverCriterionKeys);

}  // namespace asperity
