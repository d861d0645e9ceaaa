// Dissimilarity of stimuli by their confusions: a tree and a map; the tree also of rated dissimilarities.

#include "app/findings/shared/figures/similarity_figures.h"

#include <algorithm>
#include <cmath>

#include "analysis/dissimilarity/dissimilarity.h"
#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/finding_parts.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

struct Distances {
  std::vector<std::string> names{};
  Dissimilarities matrix{};
};

/// Nothing where the distance of a pair is missing, or there are fewer than two items.
std::optional<Distances> distances_of(const FoundNumbers& found, QuantityName quantity) {
  Distances read{};
  const std::vector<const Finding*> pairs = found.all(quantity);
  const auto place = [&read](const std::string& name) {
    const auto at = std::find(read.names.begin(), read.names.end(), name);
    return static_cast<Eigen::Index>(at - read.names.begin());
  };
  for (const Finding* pair : pairs) {
    const std::vector<std::string>& parts = pair->key.names();
    if (parts.size() != 2 || !pair->value) return {};
    for (const std::string& name : parts) {
      if (place(name) == static_cast<Eigen::Index>(read.names.size())) read.names.push_back(name);
    }
  }
  const auto items = static_cast<Eigen::Index>(read.names.size());
  if (items < 2) return {};
  read.matrix = Dissimilarities::Zero(items, items);
  for (const Finding* pair : pairs) {
    const std::vector<std::string>& parts = pair->key.names();
    const Eigen::Index a = place(parts[0]);
    const Eigen::Index b = place(parts[1]);
    read.matrix(a, b) = *pair->value;
    read.matrix(b, a) = *pair->value;
  }
  return read;
}

Phrase dissimilarity_axis() { return phrase("Figures", "dissimilarity (Shepard)"); }

/// Adds a warning where the distances are based on too few confusions.
Phrase with_warning(const Phrase& note, const FoundNumbers& found) {
  const Finding* too_few = found.find("scm.too.few");
  if (too_few == nullptr || too_few->word != "TRUE") return note;
  return phrase(
             "Figures",
             "%1 Too few confusions (pairs that were never confused: %2 of %3): the distances of "
             "these pairs are set by the ½ added to every count.")
      .with(note, fixed(found.value("scm.pairs.never").value_or(0.0), 0),
            fixed(found.value("scm.pairs").value_or(0.0), 0));
}

/// Joined items, in drawing order.
struct Cluster {
  std::vector<std::size_t> items{};
  double height = 0.0;
  double place = 0.0;
};

}  // namespace

TreeChoice tree_of_confusions() {
  return {.quantity = "hclust.shepard.average.cophenetic",
          .title = phrase("Figures", "Dendrogram of the confusions"),
          .note = phrase("Figures",
                         "Average linkage (UPGMA): clusters join at the mean dissimilarity of "
                         "their textures."),
          .axis = dissimilarity_axis(),
          .none = phrase("Figures",
                         "There are no confusions from which to make a dendrogram; collect "
                         "responses first.")};
}

TreeChoice rated_tree() {
  return {.quantity = "hclust.average.cophenetic",
          .title = phrase("Figures", "Dendrogram of the rated dissimilarities"),
          .note = phrase("Figures",
                         "Average linkage (UPGMA): clusters join at the mean dissimilarity of "
                         "their items."),
          .axis = phrase("Figures", "mean dissimilarity"),
          .none = phrase("Figures",
                         "A dendrogram requires ratings of every pair; collect responses first.")};
}

Figure dendrogram(const FoundNumbers& found, const TreeChoice& choice) {
  Figure figure{.name = "similarity_tree",
                .title = choice.title,
                .note = with_warning(choice.note, found),
                .shape = FigureShape::rows};
  const std::optional<Distances> read = distances_of(found, choice.quantity);
  if (!read) {
    figure.instead = choice.none;
    return figure;
  }
  // Heights at which items are first joined already form a tree; single linkage recovers it.
  const Tree tree = agglomerate(read->matrix, Linkage::single);
  std::vector<Cluster> clusters(read->names.size());
  for (std::size_t i = 0; i < clusters.size(); ++i) clusters[i].items = {i};
  for (const Tree::Join& join : tree.joins) {
    std::vector<std::size_t>& items = clusters[join.first].items;
    const std::vector<std::size_t> other = std::move(clusters[join.second].items);
    items.insert(items.end(), other.begin(), other.end());
  }
  const std::vector<std::size_t> order = clusters.front().items;
  for (std::size_t row = 0; row < order.size(); ++row) {
    figure.y.places.push_back(read->names[order[row]]);
    clusters[order[row]] = {.place = static_cast<double>(row)};
  }
  FigureSeries joins{};
  double highest = 0.0;
  for (const Tree::Join& join : tree.joins) {
    Cluster& first = clusters[join.first];
    const Cluster& second = clusters[join.second];
    joins.lines.push_back({{.x = first.height, .y = first.place},
                           {.x = join.height, .y = first.place},
                           {.x = join.height, .y = second.place},
                           {.x = second.height, .y = second.place}});
    first.place = 0.5 * (first.place + second.place);
    first.height = join.height;
    highest = std::max(highest, join.height);
  }
  if (!(highest > 0.0)) {
    figure.instead = phrase("Figures",
                            "All dissimilarities are 0, so that there are no distances to show; "
                            "collect more responses.");
    return figure;
  }
  figure.x = {.name = choice.axis, .low = 0.0, .high = 1.05 * highest};
  figure.series.push_back(std::move(joins));
  return figure;
}

Figure similarity_map(const FoundNumbers& found) {
  Figure figure{
      .name = "similarity_map",
      .title = phrase("Figures", "MDS configuration of the dissimilarities (classical scaling)"),
      .shape = FigureShape::square};
  const std::optional<Distances> read = distances_of(found, "mds.shepard.dist2d");
  if (read && !(read->matrix.maxCoeff() > 0.0)) {
    figure.instead = phrase("Figures",
                            "All dissimilarities are 0, so that there are no distances to show; "
                            "collect more responses.");
    return figure;
  }
  if (!read) {
    figure.instead = phrase("Figures",
                            "The dissimilarities span fewer than two dimensions, so that there is "
                            "no configuration to show; collect more responses or add stimuli.");
    return figure;
  }
  figure.note =
      with_warning(phrase("Figures",
                          "Classical scaling: distances can be interpreted, directions cannot. Two "
                          "dimensions account for %1 % of the sum of the absolute eigenvalues.")
                       .with(fixed(100.0 * found.value("mds.shepard.gof1").value_or(0.0), 0)),
                   found);
  // Distances in a plane determine the positions up to rotation: scaling recovers them.
  const Eigen::MatrixXd places = classical_scaling(read->matrix).points;
  const Eigen::RowVector2d middle =
      0.5 * (places.colwise().minCoeff() + places.colwise().maxCoeff());
  const double reach =
      1.25 *
      std::max(0.5 * (places.colwise().maxCoeff() - places.colwise().minCoeff()).maxCoeff(), 1e-9);
  FigureSeries points{};
  for (std::size_t i = 0; i < read->names.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    points.points.push_back({.x = places(row, 0), .y = places(row, 1), .label = read->names[i]});
  }
  figure.x = {.name = phrase("Figures", "first MDS dimension"),
              .low = middle(0) - reach,
              .high = middle(0) + reach};
  figure.y = {.name = phrase("Figures", "second dimension"),
              .low = middle(1) - reach,
              .high = middle(1) + reach};
  figure.series.push_back(std::move(points));
  return figure;
}

}  // namespace asperity
