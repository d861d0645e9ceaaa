// Tables of the similarity of textures.

#include "app/findings/methods/recognition/recognition_similarity.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/shared/figures/similarity_figures.h"

namespace asperity {

namespace {

const ResultColumn kSimilarity{.id = "similarity",
                               .heading = phrase("AnalysisWords", "similarity")};

}  // namespace

bool is_about_similarity(const Finding& finding) {
  constexpr std::array<std::string_view, 4> kStarts{"scm.", "dis.", "mds.", "hclust."};
  return std::any_of(kStarts.begin(), kStarts.end(), [&finding](std::string_view start) {
    return finding.quantity.starts_with(start);
  });
}

void withhold_fit(std::vector<Finding>& similarity) {
  const bool too_few = std::any_of(similarity.begin(), similarity.end(), [](const Finding& one) {
    return is(one, "scm.too.few") && one.word == "TRUE";
  });
  if (!too_few) return;
  for (Finding& one : similarity) {
    if (!is(one, "scm.p") && !is(one, "scm.G2") && !is(one, "scm.X2")) continue;
    one.value.reset();
    one.word = "too_few_confusions";
    one.status = "at least half of the pairs were never confused: too few confusions for a fit";
  }
}

void add_similarity_tables(const std::vector<std::string>& felt, const FoundNumbers& found,
                           AnalysisOutcome& outcome) {
  const Finding* too_few = found.find("scm.too.few");
  if (too_few != nullptr && too_few->word == "TRUE" && felt.size() > 1) {
    const auto count = [&](QuantityName quantity) {
      return fixed(found.value(quantity).value_or(0.0), 0);
    };
    outcome.remarks.push_back(
        phrase("Analysis",
               "Similarities, MDS configuration and dendrogram are based on too few confusions "
               "(between textures that were presented: %1; pairs of textures that were never "
               "confused: %2 of %3). The dissimilarities of these pairs are set by the ½ that is "
               "added to every count; collect more responses.")
            .with(count("scm.confusions"), count("scm.pairs.never"), count("scm.pairs")));
  }
  if (felt.size() < 2 || found.find("dis.shepard", {felt[0], felt[1]}) == nullptr) return;
  using namespace columns;
  ResultTable pairs{
      kTextureSimilarity,
      phrase("Analysis", "Similarity of the textures"),
      {kFelt, kOther, kSimilarity, kDissimilarity},
      phrase("Analysis",
             "Similarity η: Luce's choice model, 1 for indistinguishable textures, with response "
             "biases separated; above 1: according to the model, confused more often than "
             "recognised. Dissimilarity: Shepard's −ln √(n_ij n_ji / (n_ii n_jj)) of the counts "
             "plus ½, not below 0; it is not the −ln of this similarity.")};
  ResultTable map{"map",
                  phrase("Analysis", "MDS configuration of the textures"),
                  {kItem, kX, kY},
                  phrase("Analysis",
                         "Classical scaling of the dissimilarities. Only distances can be "
                         "interpreted: the configuration may be rotated and mirrored.")};
  ResultTable tree{"tree",
                   phrase("Analysis", "Dendrogram of the textures"),
                   {kJoin, kFirst, kSecond, kHeight},
                   phrase("Analysis",
                          "Average linkage of the dissimilarities. Each row joins the cluster of "
                          "the first texture with that of the second.")};
  map.figures = [](const ResultTable&, const AnalysisOutcome& drawn) {
    return std::vector{similarity_map(FoundNumbers(drawn.findings, kTextureSimilarity))};
  };
  tree.figures = [](const ResultTable&, const AnalysisOutcome& drawn) {
    return std::vector{dendrogram(FoundNumbers(drawn.findings, kTextureSimilarity))};
  };
  for (std::size_t i = 0; i < felt.size(); ++i) {
    for (std::size_t j = i + 1; j < felt.size(); ++j) {
      const FindingKey key{felt[i], felt[j]};
      pairs.add({felt[i], felt[j], found.cell("scm.eta", key), found.cell("dis.shepard", key)});
    }
    map.add({felt[i], found.cell("mds.shepard.x", felt[i]), found.cell("mds.shepard.y", felt[i])});
  }
  for (std::size_t join = 1; join < felt.size(); ++join) {
    const FindingKey key = std::to_string(join);
    const Finding* first = found.find("hclust.shepard.average.first", key);
    const Finding* second = found.find("hclust.shepard.average.second", key);
    if (first == nullptr || second == nullptr) break;
    tree.add({count_cell(join), first->word, second->word,
              found.cell("hclust.shepard.average.height", key)});
  }
  for (ResultTable* table : {&pairs, &map, &tree}) outcome.tables.push_back(std::move(*table));
}

}  // namespace asperity
