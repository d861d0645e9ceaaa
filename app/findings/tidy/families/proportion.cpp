// Single counts of hits: intervals, exact tests, and both adjustments over all of them.

#include "analysis/numbers/proportion.h"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/tests/multiplicity.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/repeated_rows.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

void refuse_wrong(const TidyTable& table, std::size_t row, const HitCount& count, double chance,
                  double confidence) {
  if (count.hits > count.trials) {
    table.refuse(row, "k",
                 "k is " + std::to_string(count.hits) + " and n is " +
                     std::to_string(count.trials) + "; k must be at most n");
  }
  if (!(chance >= 0.0 && chance <= 1.0)) {
    table.refuse(row, "p0",
                 "p0 is " + number_text(chance) + "; a chance level must lie between 0 and 1");
  }
  if (!(confidence > 0.0 && confidence < 1.0)) {
    table.refuse(row, table.has("conf") ? "conf" : "n",
                 "conf is " + number_text(confidence) + "; it must lie between 0 and 1");
  }
}

}  // namespace

std::vector<Finding> proportion_findings(const TidyInput& input) {
  const TidyTable& table = input.table();
  refuse_repeated(table, "id", "one row per count of hits");
  const std::vector<std::string_view> ids = table.texts("id");
  const std::vector<std::uint64_t> hits = table.counts("k");
  const std::vector<std::uint64_t> trials = table.counts("n");
  const std::vector<double> chances = table.all_numbers("p0");
  const std::vector<double> confidences =
      table.has("conf") ? table.all_numbers("conf")
                        : std::vector<double>(table.rows(), input.options.confidence());
  FindingList findings{};
  std::vector<FindingKey> keys{};
  std::vector<double> p{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string id(ids[row]);
    const HitCount count{.hits = hits[row], .trials = trials[row]};
    const double chance = chances[row];
    const double confidence = confidences[row];
    refuse_wrong(table, row, count, chance, confidence);
    const Basis basis{.n = count.trials};
    if (count.trials == 0) {
      findings.word("status", id, "no_data",
                    "n is 0, so that nothing can be estimated: leave this row out", basis);
      continue;
    }
    findings.word("status", id, "ok", "ok", basis);
    const auto number = [&](const char* quantity, double value, const std::string& method) {
      findings.number(quantity, id, value, {.n = count.trials, .method = method});
    };
    const auto interval = [&](const std::string& name, const ConfidenceInterval& ends,
                              const std::string& method) {
      number((name + ".lower").c_str(), ends.low, method);
      number((name + ".upper").c_str(), ends.high, method);
    };
    findings.count("hits", id, count.hits, basis);
    const ConfidenceInterval wilson = wilson_interval(count, confidence);
    findings.number("phat", id, proportion(count),
                    {.n = count.trials,
                     .method = "proportion of hits; Wilson interval",
                     .interval = wilson,
                     .confidence = confidence});
    interval("wilson", wilson, "Wilson interval");
    interval("cp", clopper_pearson_interval(count, confidence), "Clopper–Pearson interval");
    interval("jeffreys", jeffreys_interval(count, confidence), "Jeffreys interval");
    interval("agresticoull", agresti_coull_interval(count, confidence), "Agresti–Coull interval");
    const std::string against = "against the chance level " + number_text(chance);
    number("p.greater", binomial_upper_tail(count, chance),
           "exact binomial test, one-sided " + against);
    number("p.less", binomial_lower_tail(count, chance),
           "exact binomial test, one-sided " + against);
    const double two_sided = binomial_test(count, chance);
    number("p.two", two_sided, "exact binomial test, two-sided " + against);
    number("midp.greater", binomial_upper_mid_tail(count, chance),
           "exact binomial mid-p, one-sided " + against);
    number("midp.two", binomial_mid_test(count, chance),
           "exact binomial mid-p, two-sided " + against);
    const auto arcsine = [chance](double share) {
      return 2.0 * std::asin(std::sqrt(share)) - 2.0 * std::asin(std::sqrt(chance));
    };
    findings.number(
        "cohen.h", id, cohen_h(count, chance),
        {.n = count.trials,
         .method = "Cohen's h " + against + "; interval from the Wilson limits",
         .interval = ConfidenceInterval{.low = arcsine(wilson.low), .high = arcsine(wilson.high)},
         .confidence = confidence});
    keys.push_back(id);
    p.push_back(two_sided);
  }
  const std::vector<double> holm = holm_adjusted(p);
  const std::vector<double> bh = benjamini_hochberg_adjusted(p);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    findings.number("p.two.holm", keys[i], holm[i],
                    {.n = keys.size(), .method = "p.two, Holm-corrected over all rows"});
    findings.number(
        "p.two.bh", keys[i], bh[i],
        {.n = keys.size(), .method = "p.two, Benjamini–Hochberg-corrected over all rows"});
  }
  return findings.take();
}

}  // namespace asperity
