// Answers which textures were confused with each other.

#include "app/findings/methods/recognition/recognition_confusions.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "app/findings/outcome/tally.h"
#include "app/findings/outcome/test_sentences.h"

namespace asperity {

namespace {

/// Two textures that were felt, and how often one of them was confused with the other.
struct ConfusedPair {
  std::string names{};
  FindingKey key{};
  std::size_t times = 0;
  std::size_t answers = 0;  ///< to either

  double share() const { return static_cast<double>(times) / static_cast<double>(answers); }
};

/// The pairs with the largest proportion of confusions.
std::vector<ConfusedPair> most_confused(const GatheredAnswers& gathered,
                                        const std::vector<JudgedAnswer>& judged,
                                        const std::vector<std::string>& felt) {
  ConfusionTally confusions{};
  std::vector<std::size_t> answers(gathered.words.size());
  for (const JudgedAnswer& one : judged) {
    confusions.count(one.felt, one.chosen);
    ++answers[one.felt];
  }
  std::vector<ConfusedPair> most{};
  for (std::size_t i = 0; i < felt.size(); ++i) {
    for (std::size_t j = i + 1; j < felt.size(); ++j) {
      const std::uint32_t a = *gathered.words.find(felt[i]);
      const std::uint32_t b = *gathered.words.find(felt[j]);
      ConfusedPair pair{.names = felt[i] + " / " + felt[j],
                        .key = {felt[i], felt[j]},
                        .times = confusions.at(a, b) + confusions.at(b, a),
                        .answers = answers[a] + answers[b]};
      // In integers, so that equal proportions of different numbers of responses are equal.
      const std::size_t mine = most.empty() ? 0 : pair.times * most.front().answers;
      const std::size_t others = most.empty() ? 0 : most.front().times * pair.answers;
      if (mine < others) continue;
      if (mine > others) most.clear();
      most.push_back(std::move(pair));
    }
  }
  return most;
}

/// One texture that was identified as another picture, whose texture may or may not have been felt.
struct Confusion {
  std::string felt{};
  std::string called{};
  std::size_t times = 0;
  std::size_t answers = 0;  ///< to the felt texture

  double share() const { return static_cast<double>(times) / static_cast<double>(answers); }
};

/// Those with the largest proportion.
std::vector<Confusion> largest_confusions(const GatheredAnswers& gathered,
                                          const std::vector<JudgedAnswer>& judged,
                                          const RecognitionPictures& pictures) {
  ConfusionTally confusions{};
  std::vector<std::size_t> answers(gathered.words.size());
  for (const JudgedAnswer& one : judged) {
    confusions.count(one.felt, one.chosen);
    ++answers[one.felt];
  }
  std::vector<Confusion> most{};
  for (const std::string& felt : pictures.felt) {
    for (const std::string& called : pictures.all) {
      const auto a = gathered.words.find(felt);
      const auto b = gathered.words.find(called);
      if (felt == called || !a || !b) continue;
      const std::size_t times = confusions.at(*a, *b);
      if (times == 0) continue;
      // In integers, so that equal proportions of different numbers of responses are equal.
      const std::size_t own = most.empty() ? 0 : times * most.front().answers;
      const std::size_t others = most.empty() ? 0 : most.front().times * answers[*a];
      if (own < others) continue;
      if (own > others) most.clear();
      most.push_back({.felt = felt, .called = called, .times = times, .answers = answers[*a]});
    }
  }
  return most;
}

/// "brick identified as gravel, brick identified as wood"
Phrase confusions_text(const std::vector<Confusion>& confusions) {
  Phrase all{};
  for (const Confusion& one : confusions) {
    const Phrase text = phrase("Analysis", "%1 identified as %2").with(one.felt, one.called);
    all = all.empty() ? text : phrase("Analysis", "%1, %2").with(all, text);
  }
  return all;
}

constexpr std::size_t kMostNamedConfusions = 3;  // the table lists further pairs and confusions

/// Adds what the pairs do not show: the most frequent confusions in one direction, where one of
/// them belongs to no pair that is reported.
Phrase with_larger_confusions(const Phrase& answer, const std::vector<ConfusedPair>& pairs,
                              const std::vector<Confusion>& largest) {
  const auto is_in_a_pair = [&pairs](const Confusion& one) {
    return std::any_of(pairs.begin(), pairs.end(), [&one](const ConfusedPair& pair) {
      return pair.key == FindingKey{one.felt, one.called} ||
             pair.key == FindingKey{one.called, one.felt};
    });
  };
  if (std::all_of(largest.begin(), largest.end(), is_in_a_pair)) return answer;
  const Confusion& first = largest.front();
  if (first.share() <= pairs.front().share()) return answer;
  if (largest.size() > kMostNamedConfusions) {
    return phrase("Analysis",
                  "%1 Counted in one direction only, %2 confusions are the most frequent: each in "
                  "%3 of the responses to the texture presented.")
        .with(answer, std::to_string(largest.size()), percent(first.share()));
  }
  if (largest.size() > 1) {
    return phrase("Analysis",
                  "%1 Counted in one direction only, these confusions are the most frequent: %2, "
                  "each in %3 of the responses to the texture presented.")
        .with(answer, confusions_text(largest), percent(first.share()));
  }
  return phrase("Analysis",
                "%1 Counted in one direction only, the most frequent confusion is %2 "
                "(responses: %3 of %4).")
      .with(answer, confusions_text(largest), std::to_string(first.times),
            std::to_string(first.answers));
}

}  // namespace

void ask_confusions(const GatheredAnswers& gathered, const std::vector<JudgedAnswer>& judged,
                    const RecognitionPictures& pictures, AnalysisOutcome& outcome) {
  const std::vector<ConfusedPair> most = most_confused(gathered, judged, pictures.felt);
  if (most.empty()) return;
  const ConfusedPair& first = most.front();
  Finding finding{};
  finding.quantity = "share_confused";
  finding.key = first.key;
  finding.value = first.share();
  finding.unit = "1";
  finding.n = first.answers;
  finding.method =
      "proportion of confusions with each other among the responses to the two textures; n counts "
      "responses";
  Phrase answer{};
  if (first.times == 0) {
    answer =
        phrase("Analysis", "No texture was ever confused with another one that was presented.");
  } else if (pictures.felt.size() == 2) {
    answer =
        phrase("Analysis",
               "Only %1 were presented: one was confused with the other (responses: %2 of %3).")
            .with(first.names, std::to_string(first.times), std::to_string(first.answers));
  } else if (most.size() == 1) {
    answer =
        phrase("Analysis",
               "The textures confused most often are %1: one with the other (responses: %2 of %3).")
            .with(first.names, std::to_string(first.times), std::to_string(first.answers));
  } else if (most.size() <= kMostNamedConfusions) {
    Phrase names = first.names;
    for (std::size_t i = 1; i < most.size(); ++i) {
      names =
          (i + 1 == most.size() ? phrase("Analysis", "%1 and %2") : phrase("Analysis", "%1, %2"))
              .with(names, most[i].names);
    }
    answer = phrase("Analysis",
                    "The following pairs are confused equally often: %1; one texture with the "
                    "other in %2 of the responses to the two textures of each pair.")
                 .with(names, percent(first.share()));
  } else {
    answer =
        phrase("Analysis",
               "%1 pairs of textures are confused equally often, and none more often: one texture "
               "with the other in %2 of the responses to the two textures of each pair.")
            .with(std::to_string(most.size()), percent(first.share()));
  }
  add_question(outcome, "confusions",
               phrase("Analysis", "Which textures are confused with each other?"),
               with_larger_confusions(answer, most, largest_confusions(gathered, judged, pictures)),
               pictures.felt.size() == 2
                   ? phrase("Analysis",
                            "Proportion of confusions among the responses to the two textures, all "
                            "participants pooled.")
                   : phrase("Analysis",
                            "Proportion of confusions with each other among the responses to the "
                            "two textures of a pair, all participants pooled. There is no CI, "
                            "because the pair is selected as the one confused most often."),
               "confusion", &finding, CountedUnit::answers);
}

}  // namespace asperity
