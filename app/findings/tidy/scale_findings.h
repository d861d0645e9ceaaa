// Reports a scale of items as findings.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "analysis/choices/bradley_terry.h"
#include "analysis/tests/friedman.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

/// The names of a scale in its findings, and its basis.
struct ScaleNames {
  std::string value{};
  std::string error{};
  std::string method{};
  std::size_t n = 0;
  double confidence = 0.95;
  std::string coverage{};  ///< of Wald's interval, as `simulated_coverage`
};

/// The log-worth of each item about their mean, with the t interval of its CR2 standard error, that
/// error, and its degrees of freedom. With too few participants only the values, and
/// `PREFIX.cluster.status` instead of the others.
struct ClusteredScale {
  Abilities centred{};
  std::span<const ClusteredError> errors{};
};
struct ClusteredNames {
  std::string prefix{};  ///< "pl" in `pl.logworth.sumzero.cluster`
  std::string value{};
  std::string method{};
  std::size_t n = 0;
  double confidence = 0.95;
};
void add_clustered_scale(std::span<const std::string> items, const ClusteredScale& scale,
                         const ClusteredNames& names, FindingList& findings);

/// CR0 standard errors of a scale with participants as clusters: NA for a single one.
void add_cluster_errors(std::span<const std::string> items, const Abilities& clustered,
                        const ScaleNames& names, FindingList& findings);

/// The scale value of each item, with Wald's interval and its standard error, treating all
/// judgements as independent.
void add_scale(std::span<const std::string> items, const Abilities& scale, const ScaleNames& names,
               FindingList& findings);

/// The number of judged rows, the sentences for none and for a single one, and the interval of W.
struct FriedmanRows {
  std::size_t n = 0;
  std::string none{};
  std::string one{};
  std::optional<ConfidenceInterval> concordance{};
  double confidence = 0.95;
};
/// Friedman's test with Kendall's W and the F of Iman and Davenport; for fewer than two rows the
/// word that states why there is none.
void add_friedman(const FriedmanTest& test, const FriedmanRows& rows, FindingList& findings);

}  // namespace asperity
