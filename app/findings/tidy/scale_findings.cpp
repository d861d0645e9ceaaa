// t intervals from CR2 errors, CR0 errors or Wald intervals of a scale, and the findings of Friedman's test.

#include "app/findings/tidy/scale_findings.h"

#include <string>

#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/tidy/simulated_coverage.h"

namespace asperity {

void add_clustered_scale(std::span<const std::string> items, const ClusteredScale& scale,
                         const ClusteredNames& names, FindingList& findings) {
  const bool has_errors = !scale.errors.empty();
  const std::string method = names.method + ", mean 0";
  const std::string error_method =
      method + "; CR2 standard error with participants as clusters, Satterthwaite's df";
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double value = scale.centred.value(static_cast<Eigen::Index>(i));
    Basis basis{.n = names.n, .method = method};
    if (has_errors) {
      const ClusteredError& error = scale.errors[i];
      basis.method += "; t interval based on the CR2 standard error with participants as clusters";
      const auto limit = t_limit({.confidence = names.confidence, .df = error.df});
      if (error.standard_error > 0.0 && limit) {
        const double half = *limit * error.standard_error;
        basis.interval = {.low = value - half, .high = value + half};
        basis.confidence = names.confidence;
      }
    }
    findings.number(names.value, items[i], value, basis);
    if (!has_errors) continue;
    const Basis of_error{.n = names.n, .method = error_method};
    findings.number(names.prefix + ".se.sumzero.cr2", items[i], scale.errors[i].standard_error,
                    of_error);
    findings.number(names.prefix + ".df.sumzero.cr2", items[i], scale.errors[i].df, of_error);
  }
  if (has_errors) return;
  findings.word(names.prefix + ".cluster.status", "", "too_few_participants",
                "an interval over participants needs at least " + std::to_string(kFewestClusters) +
                    " participants: with fewer, differences between participants cannot be "
                    "estimated; add participants",
                {.n = names.n, .method = error_method});
}

void add_cluster_errors(std::span<const std::string> items, const Abilities& clustered,
                        const ScaleNames& names, FindingList& findings) {
  const Eigen::VectorXd errors = clustered.standard_error();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double error = names.n > 1 ? errors(static_cast<Eigen::Index>(i)) : kUndefined;
    findings.number(names.error, items[i], error,
                    {.n = names.n,
                     .method = names.method + ", participants as clusters (CR0: too small with "
                                              "few participants)",
                     .undefined = "differences between participants cannot be estimated from one "
                                  "participant: add participants"});
  }
}

void add_scale(std::span<const std::string> items, const Abilities& scale, const ScaleNames& names,
               FindingList& findings) {
  const Eigen::VectorXd errors = scale.standard_error();
  const double z = normal_limit(names.confidence);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    const double value = scale.value(index);
    const double error = errors(index);
    const std::string method = names.method + ", judgements treated as independent";
    Basis basis{.n = names.n, .method = method + "; Wald interval" + names.coverage};
    if (error > 0.0) {
      basis.interval = {.low = value - z * error, .high = value + z * error};
      basis.confidence = names.confidence;
    }
    findings.number(names.value, items[i], value, basis);
    findings.number(names.error, items[i], error, {.n = names.n, .method = method});
  }
}

void add_friedman(const FriedmanTest& test, const FriedmanRows& rows, FindingList& findings) {
  const std::size_t n = rows.n;
  const Basis friedman{.n = n,
                       .method = "Friedman's test, corrected for ties",
                       .undefined =
                           "all items are tied in every row, so that there is no order to test: "
                           "add rows in which they differ"};
  if (n < 2) {
    // With a single row, W is 1 and p is constant whatever the data.
    findings.word("friedman.chisq", "", n == 0 ? "no_data" : "undefined_one_row",
                  n == 0 ? rows.none : rows.one, friedman);
    return;
  }
  const auto with_method = [&friedman](const char* method) {
    Basis basis = friedman;
    basis.method = method;
    return basis;
  };
  const Basis iman = with_method(
      "Iman–Davenport F test; in simulations without differences the Type I error rate at α = .05 "
      "was "
      "up to 6 % with 12 or 20 rows, and up to 7 % with 2 to 6");
  findings.number("friedman.chisq", "", test.chi_squared, friedman);
  findings.number("friedman.df", "", test.df, friedman);
  findings.number("friedman.p", "", test.p, friedman);
  Basis concordance = with_method("Kendall's W");
  if (rows.concordance) {
    concordance.interval = rows.concordance;
    concordance.confidence = rows.confidence;
    concordance.method +=
        "; jackknife interval of the mean rank correlation" + simulated_coverage({93, 100});
  }
  findings.number("kendall.W", "", test.concordance, concordance);
  if (rows.concordance) {
    findings.number("kendall.W.ci.lower", "", rows.concordance->low, with_method("limit of W"));
    findings.number("kendall.W.ci.upper", "", rows.concordance->high, with_method("limit of W"));
  }
  findings.number("iman.davenport.F", "", test.f, iman);
  findings.number("iman.davenport.p", "", test.f_p, iman);
}

}  // namespace asperity
