#include "app/analyses/tidy/scale_findings.h"

#include "analysis/tail_probabilities.h"

namespace asperity {

void add_scale(std::span<const std::string> items, const Abilities& scale, const ScaleNames& names,
               FindingList& findings) {
  const Eigen::VectorXd errors = scale.standard_error();
  const double z = normal_limit(names.confidence);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    const double value = scale.value(index);
    const double error = errors(index);
    Basis basis{.n = names.n, .method = names.method + "; interval of Wald"};
    if (error > 0.0) {
      basis.interval = {.low = value - z * error, .high = value + z * error};
      basis.confidence = names.confidence;
    }
    findings.number(names.value, items[i], value, basis);
    findings.number(names.error, items[i], error, {.n = names.n, .method = names.method});
  }
}

void add_friedman(const FriedmanTest& test, const FriedmanRows& rows, FindingList& findings) {
  const std::size_t n = rows.n;
  const Basis friedman{.n = n,
                       .method = "Friedman's test, ties corrected for",
                       .undefined = "all items are tied in every row: there is no order to test"};
  if (n < 2) {
    // One row agrees with itself alone: its W is 1 and its p the same whatever it says.
    findings.word("friedman.chisq", "", n == 0 ? "no_data" : "undefined_one_row",
                  n == 0 ? rows.none : rows.one, friedman);
    return;
  }
  const auto with_method = [&friedman](const char* method) {
    Basis basis = friedman;
    basis.method = method;
    return basis;
  };
  const Basis iman = with_method("F of Iman and Davenport");
  findings.number("friedman.chisq", "", test.chi_squared, friedman);
  findings.number("friedman.df", "", test.df, friedman);
  findings.number("friedman.p", "", test.p, friedman);
  Basis concordance = with_method("Kendall's W");
  if (rows.concordance) {
    concordance.interval = rows.concordance;
    concordance.confidence = rows.confidence;
    concordance.method += "; interval by the jackknife of the mean rank correlation";
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
