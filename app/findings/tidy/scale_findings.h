// A scale of items as findings.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "analysis/bradley_terry.h"
#include "analysis/friedman.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

/// How a scale is called and what it rests on.
struct ScaleNames {
  std::string value{};
  std::string error{};
  std::string method{};
  std::size_t n = 0;
  double confidence = 0.95;
};

/// The log-worth of each item about their mean, with the t interval of its CR2 standard error, that
/// error, and its degrees of freedom. With too few participants only the values, and
/// `PREFIX.cluster.status` instead.
struct ClusteredScale {
  Abilities centred{};
  std::span<const ClusteredError> errors{};
};
struct ClusteredNames {
  std::string prefix{};  ///< "pl" of `pl.logworth.sumzero.cluster`
  std::string value{};
  std::string method{};
  std::size_t n = 0;
  double confidence = 0.95;
};
void add_clustered_scale(std::span<const std::string> items, const ClusteredScale& scale,
                         const ClusteredNames& names, FindingList& findings);

/// CR0 standard errors of a scale with participants as clusters: NA of a single one.
void add_cluster_errors(std::span<const std::string> items, const Abilities& clustered,
                        const ScaleNames& names, FindingList& findings);

/// The place of each item, with Wald's interval, and its standard error: with all judgements taken as
/// independent.
void add_scale(std::span<const std::string> items, const Abilities& scale, const ScaleNames& names,
               FindingList& findings);

/// How many rows were judged, with the sentences for none and for a single one, and the interval of W.
struct FriedmanRows {
  std::size_t n = 0;
  std::string none{};
  std::string one{};
  std::optional<ConfidenceInterval> concordance{};
  double confidence = 0.95;
};
/// Friedman's test with Kendall's W and the F of Iman and Davenport; of fewer than two rows the word
/// for why there are none.
void add_friedman(const FriedmanTest& test, const FriedmanRows& rows, FindingList& findings);

}  // namespace asperity
