// Analysis of variance of repeated measures, with follow-up tests.

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/tests/effect_size.h"
#include "analysis/tests/multiplicity.h"
#include "analysis/tests/repeated_measures.h"
#include "analysis/tests/t_test.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/repeated_rows.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

constexpr const char* kNoErrorVariance =
    "the participants differ in the effect by nothing but rounding, so that there is no error "
    "variance to test it against: check that the table has the participants' own values";

using DesignFactor = std::pair<std::string, std::vector<std::string>>;

struct Design {
  std::vector<DesignFactor> within{};
  std::vector<DesignFactor> between{};  ///< none or one
  std::vector<FindingKey> cells{};
  std::vector<std::string> participants{};  ///< with all cells
  std::vector<std::string> dropped{};
  std::vector<CellRows> rows{};  ///< of the participants with all cells
  RepeatedMeasures data{};
};

/// A level by name, or by an equal number: 0.50 is 0.5.
std::optional<std::size_t> level_of(std::string_view text, const std::vector<std::string>& levels) {
  const auto same = std::find(levels.begin(), levels.end(), text);
  if (same != levels.end()) return static_cast<std::size_t>(same - levels.begin());
  const auto number = [](std::string_view one) {
    const TidyTable table("y\n" + std::string(one) + '\n', "");
    return table.all_numbers("y").front();
  };
  try {
    const double value = number(text);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (number(levels[i]) == value) return i;
    }
  } catch (const std::exception&) {
    return std::nullopt;  // a number is not compared with a name
  }
  return std::nullopt;
}

std::vector<std::size_t> codes_of(const TidyTable& table, const DesignFactor& factor) {
  const LabelColumn column = table.all_labels(factor.first);
  std::vector<std::size_t> of_names{};
  for (std::size_t name = 0; name < column.names.size(); ++name) {
    const std::optional<std::size_t> level = level_of(column.names[name], factor.second);
    if (!level) {
      const auto first = std::find(column.codes.begin(), column.codes.end(), name);
      table.refuse(static_cast<std::size_t>(first - column.codes.begin()), factor.first,
                   '"' + column.names[name] + "\" is not a level of " + factor.first +
                       " in the options; correct the cell or add the level to the options");
    }
    of_names.push_back(*level);
  }
  std::vector<std::size_t> codes{};
  for (const std::size_t code : column.codes) codes.push_back(of_names[code]);
  return codes;
}

std::vector<FindingKey> cell_names(const std::vector<DesignFactor>& within) {
  std::vector<FindingKey> cells{FindingKey{}};
  for (const auto& [name, levels] : within) {
    std::vector<FindingKey> longer{};
    for (const FindingKey& cell : cells) {
      for (const std::string& level : levels) {
        longer.push_back({cell, level});
      }
    }
    cells = std::move(longer);
  }
  return cells;
}

Design read_design(const TidyInput& input) {
  Design design{.within = input.options.levels("within"),
                .between = input.options.levels("between")};
  if (design.within.empty() || design.between.size() > 1) {
    throw std::runtime_error(design.within.empty()
                                 ? "the option \"within\" names no factor; name at least one"
                                 : "the option \"between\" names " +
                                       std::to_string(design.between.size()) +
                                       " factors; name at most one");
  }
  design.cells = cell_names(design.within);
  const TidyTable& table = input.table();
  const LabelColumn subjects = table.all_labels("subject");
  const std::vector<std::optional<double>> values = table.numbers("y");
  std::vector<std::size_t> cells(table.rows(), 0);
  for (const DesignFactor& factor : design.within) {
    const std::vector<std::size_t> codes = codes_of(table, factor);
    for (std::size_t row = 0; row < table.rows(); ++row) {
      cells[row] = cells[row] * factor.second.size() + codes[row];
    }
  }
  std::vector<std::size_t> groups(table.rows(), 0);
  if (!design.between.empty()) groups = codes_of(table, design.between.front());

  // Participants without any number are ignored.
  struct Person {
    std::vector<double> sums{};
    std::vector<std::size_t> counts{};
    std::size_t group = 0;
  };
  std::vector<Person> people(subjects.names.size());
  std::vector<std::size_t> order{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!values[row]) continue;
    Person& person = people[subjects.codes[row]];
    if (person.sums.empty()) {
      person.sums.assign(design.cells.size(), 0.0);
      person.counts.assign(design.cells.size(), 0);
      person.group = groups[row];
      order.push_back(subjects.codes[row]);
    }
    if (person.group != groups[row]) {
      table.refuse(row, design.between.front().first,
                   subjects.names[subjects.codes[row]] + " is in the groups \"" +
                       design.between.front().second[person.group] + "\" and \"" +
                       design.between.front().second[groups[row]] +
                       "\"; enter one group for each participant");
    }
    person.sums[cells[row]] += *values[row];
    ++person.counts[cells[row]];
  }
  std::vector<std::size_t> complete{};
  for (const std::size_t one : order) {
    const bool has_all = std::all_of(people[one].counts.begin(), people[one].counts.end(),
                                     [](std::size_t count) { return count > 0; });
    if (has_all) {
      complete.push_back(one);
      design.participants.push_back(subjects.names[one]);
    } else {
      design.dropped.push_back(subjects.names[one]);
    }
  }
  design.data.y.resize(static_cast<Eigen::Index>(complete.size()),
                       static_cast<Eigen::Index>(design.cells.size()));
  for (std::size_t i = 0; i < complete.size(); ++i) {
    const Person& person = people[complete[i]];
    for (std::size_t cell = 0; cell < design.cells.size(); ++cell) {
      design.data.y(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(cell)) =
          person.sums[cell] / static_cast<double>(person.counts[cell]);
      design.rows.push_back({.participant = design.participants[i],
                             .cell = design.cells[cell].text(),
                             .rows = person.counts[cell]});
    }
    design.data.group.push_back(person.group);
  }
  for (const DesignFactor& factor : design.within)
    design.data.levels.push_back(factor.second.size());
  design.data.groups = design.between.empty() ? 1 : design.between.front().second.size();
  return design;
}

SumsOfSquares type_of(const FamilyOptions& options) {
  const double type = options.number_or("type", 3.0);
  if (type == 2.0) return SumsOfSquares::type_2;
  if (type == 3.0) return SumsOfSquares::type_3;
  throw std::runtime_error("the option \"type\" is " + number_text(type) + "; it must be 2 or 3");
}

class AnovaList final {
 public:
  AnovaList(const TidyInput& input, const Design& design)
      : input_(input), design_(design), confidence_(input.options.confidence()) {}

  std::vector<Finding> findings() {
    std::string dropped{};
    for (const std::string& one : design_.dropped) {
      dropped += (dropped.empty() ? "" : ";") + one;
    }
    list_.word("subjects.dropped", "", dropped.empty() ? "none" : dropped,
               dropped.empty() ? "ok"
                               : "these participants have an empty cell and were left out: add "
                                 "the missing values to include them",
               basis("participants left out"));
    list_.count("n.subjects", "", design_.participants.size(),
                basis("participants with a value in every cell"));
    add_replicates(design_.rows, design_.participants.size(), list_);
    if (design_.participants.size() <= design_.data.groups) {
      list_.word(
          "status", "", "too_few_participants",
          "an error term requires more participants with a value in every cell than groups: add "
          "participants",
          basis("participants with a value in every cell"));
      return list_.take();
    }
    for (std::size_t group = 0; group < design_.data.groups; ++group) {
      const auto& of = design_.data.group;
      if (std::count(of.begin(), of.end(), group) == 0) {
        list_.word(
            "status", design_.between.front().second[group], "empty_group",
            "no participant of this group has a value in every cell: add participants, or leave "
            "the group out",
            basis("participants with a value in every cell"));
        return list_.take();
      }
    }
    const AnovaTable table = repeated_measures_anova(design_.data, type_of(input_.options));
    number("SS.error.total", "", table.all_errors, "all error strata, participants included");
    for (const AnovaEffect& one : table.effects) effect(one, table.all_errors);
    means();
    for (std::size_t factor = 0; factor < design_.within.size(); ++factor) {
      const Eigen::MatrixXd marginal = marginal_means(design_.data, factor);
      if (input_.options.text_or("trend", "") == design_.within[factor].first) {
        trend(design_.within[factor], marginal);
      }
      pairs(design_.within[factor], marginal);
    }
    return list_.take();
  }

 private:
  Basis basis(std::string method) const {
    return {.n = design_.participants.size(), .method = std::move(method)};
  }
  void number(const char* quantity, const FindingKey& key, const std::optional<double>& value,
              std::string method) {
    Basis shown = basis(std::move(method));
    shown.undefined = undefined_;
    list_.number(quantity, key, value.value_or(kUndefined), std::move(shown));
  }

  std::string name_of(const AnovaEffect& effect) const {
    std::string name = effect.between ? design_.between.front().first : "";
    for (const std::size_t factor : effect.within) {
      name += (name.empty() ? "" : ":") + design_.within[factor].first;
    }
    return name;
  }

  /// The interval of partial η², from F with the degrees of freedom of its corrected test.
  std::optional<ConfidenceInterval> eta_interval(const AnovaEffect& effect) const {
    if (!effect.F) return std::nullopt;
    double epsilon = 1.0;
    if (effect.sphericity) {
      if (!effect.sphericity->gg) return std::nullopt;
      epsilon = *effect.sphericity->gg;
    }
    return partial_eta_interval(
        {.value = *effect.F, .df1 = epsilon * effect.df1, .df2 = epsilon * effect.df2},
        confidence_);
  }

  void effect_size(const std::string& quantity, const FindingKey& key,
                   const std::optional<double>& value,
                   const std::optional<ConfidenceInterval>& interval, const std::string& method) {
    Basis shown = basis(method);
    if (value && interval) {
      shown.interval = interval;
      shown.confidence = confidence_;
    }
    list_.number(quantity, key, value.value_or(kUndefined), shown);
    if (!value || !interval) return;
    list_.number(quantity + ".ci.lower", key, interval->low, basis("limit of " + quantity));
    list_.number(quantity + ".ci.upper", key, interval->high, basis("limit of " + quantity));
  }

  void effect(const AnovaEffect& effect, double all_errors) {
    const FindingKey key = name_of(effect);
    undefined_ = effect.error_sum_of_squares > 0.0 ? "" : kNoErrorVariance;
    number("SS", key, effect.sum_of_squares, "sum of squares");
    number("SS.error", key, effect.error_sum_of_squares,
           "sum of squares of the effect's error term");
    number("df1", key, effect.df1, "degrees of freedom");
    number("df2", key, effect.df2, "degrees of freedom of the error");
    number("F", key, effect.F, "F");
    number("p", key, effect.p, "F test, without a correction for sphericity");
    const std::optional<ConfidenceInterval> partial = eta_interval(effect);
    std::optional<ConfidenceInterval> generalised{};
    if (partial && effect.error_sum_of_squares > 0.0) {
      const double errors = all_errors / effect.error_sum_of_squares;
      generalised = {.low = generalised_eta(partial->low, errors),
                     .high = generalised_eta(partial->high, errors)};
    }
    effect_size("pes", key, effect.pes, partial,
                "partial η²; interval from the noncentral F distribution, degrees of freedom "
                "corrected for sphericity" +
                    simulated_coverage({95, 100}));
    effect_size(
        "ges", key, effect.ges, generalised,
        "generalised η², all factors manipulated; interval from the noncentral F distribution" +
            simulated_coverage({93, 100}));
    if (!design_.between.empty()) {
      number("ges.observed", key, effect.ges_observed,
             "generalised η², between-participants factor measured");
    }
    number("omega2.partial", key, effect.omega2, "partial ω²");
    if (effect.sphericity) sphericity(key, *effect.sphericity);
    undefined_.clear();
  }

  void sphericity(const FindingKey& key, const AnovaEffect::Sphericity& of) {
    number("eps.GG", key, of.gg, "Greenhouse–Geisser ε");
    number("eps.lower", key, of.lower_bound, "lower bound of ε");
    number("eps.HF.lecoutre", key, of.hf_lecoutre, "Huynh–Feldt ε, Lecoutre's correction");
    number("eps.HF.original", key, of.hf_original, "Huynh–Feldt ε, as published");
    number("p.GG", key, of.p_gg,
           "F test, Greenhouse–Geisser-corrected; conservative with few participants: in "
           "simulations of four levels and 3 to 12 participants the Type I error rate at α = .05 "
           "was 1 to 4 %");
    number("p.HF", key, of.p_hf, "F test, Huynh–Feldt-corrected (Lecoutre), ε at most 1");
    number("p.lower", key, of.p_lower_bound, "F test, corrected with the lower bound of ε");
    if (!undefined_.empty()) {
      list_.word("mauchly.W", key, "undefined", undefined_, basis("Mauchly's test of sphericity"));
      return;
    }
    if (!of.mauchly) {
      list_.word("mauchly.W", key, "undefined",
                 "there are fewer participants than contrasts, so that W is undefined: use the "
                 "corrected p (p.GG)",
                 basis("Mauchly's test of sphericity"));
      return;
    }
    number("mauchly.W", key, of.mauchly->W, "Mauchly's W");
    number("mauchly.chisq", key, of.mauchly->chi_squared, "χ² of W");
    number("mauchly.df", key, of.mauchly->df, "degrees of freedom of χ²");
    number("mauchly.p.firstorder", key, of.mauchly->p_first_order,
           "χ² test of W, first-order approximation");
    number("mauchly.p.anderson", key, of.mauchly->p_second_order,
           "χ² test of W, second-order approximation");
    number("mauchly.p.car", key, of.mauchly->p_as_r,
           "χ² test of W, second-order approximation, as computed by R with the number of cells "
           "instead of contrasts; not to be reported");
  }

  void means() {
    const std::vector<std::string> groups =
        design_.between.empty() ? std::vector<std::string>{"all"} : design_.between.front().second;
    for (std::size_t group = 0; group < groups.size(); ++group) {
      std::vector<Eigen::Index> rows{};
      for (std::size_t i = 0; i < design_.data.group.size(); ++i) {
        if (design_.between.empty() || design_.data.group[i] == group) {
          rows.push_back(static_cast<Eigen::Index>(i));
        }
      }
      const CellMeans means = cell_means(design_.data.y(rows, Eigen::all), confidence_);
      for (std::size_t cell = 0; cell < design_.cells.size(); ++cell) {
        const auto i = static_cast<Eigen::Index>(cell);
        const FindingKey key{groups[group], design_.cells[cell]};
        Basis shown{.n = rows.size(), .method = "mean of the participants; t interval"};
        if (means.half_width) {
          shown.interval = ConfidenceInterval{.low = means.mean(i) - (*means.half_width)(i),
                                              .high = means.mean(i) + (*means.half_width)(i)};
          shown.confidence = confidence_;
        }
        list_.number("cell.mean", key, means.mean(i), shown);
        number("cell.ci.half", key, means.half_width ? (*means.half_width)(i) : kUndefined,
               "half width of the t interval");
        number("cell.ci.half.morey", key,
               means.within_half_width ? (*means.within_half_width)(i) : kUndefined,
               "half width of the within-participant interval (Cousineau and Morey)");
      }
    }
  }

  static std::vector<double> scores(const Eigen::VectorXd& column) {
    return {column.begin(), column.end()};
  }

  void trend(const DesignFactor& factor, const Eigen::MatrixXd& marginal) {
    Eigen::VectorXd levels(static_cast<Eigen::Index>(factor.second.size()));
    const TidyTable table = [&] {
      std::string text = "level\n";
      for (const std::string& level : factor.second) text += level + '\n';
      return TidyTable(text, "levels of " + factor.first);
    }();
    const std::vector<double> numbers = table.all_numbers("level");
    const std::string scale = input_.options.text_or("trend_scale", "linear");
    if (scale != "linear" && scale != "log10") {
      throw std::runtime_error("the option \"trend_scale\" is \"" + scale +
                               "\"; it must be linear or log10");
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (scale == "log10" && !(numbers[i] > 0.0)) {
        table.refuse(i, "level",
                     "the level " + number_text(numbers[i]) +
                         " is not above 0, as trend_scale log10 requires; correct it, or use "
                         "trend_scale linear");
      }
      levels(static_cast<Eigen::Index>(i)) = scale == "log10" ? std::log10(numbers[i]) : numbers[i];
    }
    const std::array<const char*, 3> names{"linear", "quadratic", "cubic"};
    const std::size_t degrees = std::min(names.size(), numbers.size() - 1);
    const Eigen::MatrixXd polynomials = orthonormal_polynomials(levels, degrees);
    for (std::size_t degree = 0; degree < degrees; ++degree) {
      const OneSampleT t =
          one_sample_t(scores(marginal * polynomials.col(static_cast<Eigen::Index>(degree))),
                       {.confidence = confidence_});
      test({factor.first, names[degree]}, t, "trend",
           "orthonormal polynomial on the scaled levels, over participants");
    }
  }

  /// The mean under NAME.estimate or NAME.diff, t and p.
  void test(const FindingKey& key, const OneSampleT& t, const std::string& name,
            const std::string& method) {
    const bool is_pair = name == "pair";
    Basis shown = basis(method + "; t interval");
    if (t.test) {
      shown.interval = t.test->interval;
      shown.confidence = confidence_;
    }
    list_.number(name + (is_pair ? ".diff" : ".estimate"), key, t.mean, shown);
    if (!t.test) {
      list_.word(name + ".t", key, "undefined_zero_variance",
                 "all participants have the same value, so that t is undefined: add participants",
                 basis(method));
      return;
    }
    list_.number(name + ".t", key, t.test->t, basis(method));
    list_.number(name + ".p", key, t.test->p, basis(method + ", two-sided"));
  }

  void pairs(const DesignFactor& factor, const Eigen::MatrixXd& marginal) {
    std::vector<FindingKey> keys{};
    std::vector<double> p{};
    const std::string method = "difference of marginal means; paired t test over participants";
    for (Eigen::Index a = 0; a < marginal.cols(); ++a) {
      for (Eigen::Index b = a + 1; b < marginal.cols(); ++b) {
        const FindingKey key{factor.first, factor.second[static_cast<std::size_t>(a)],
                             factor.second[static_cast<std::size_t>(b)]};
        const OneSampleT t =
            one_sample_t(scores(marginal.col(a) - marginal.col(b)), {.confidence = confidence_});
        test(key, t, "pair", method);
        if (!t.test) continue;
        number("pair.ci.lower", key, t.test->interval.low, "t interval");
        number("pair.ci.upper", key, t.test->interval.high, "t interval");
        const double dz = t.mean / *t.sd;
        effect_size("pair.dz", key, dz,
                    standardised_mean_interval(dz, static_cast<double>(t.n), confidence_),
                    "mean divided by the standard deviation of the differences; interval from the "
                    "noncentral t distribution");
        keys.push_back(key);
        p.push_back(t.test->p);
      }
    }
    const std::vector<double> holm = holm_adjusted(p);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      number("pair.p.holm", keys[i], holm[i], "Holm-corrected over the pairs of this factor");
    }
  }

  const TidyInput& input_;
  const Design& design_;
  std::string
      undefined_{};  ///< why numbers of the current effect are not defined; empty: the default reason
  double confidence_ = 0.95;
  FindingList list_{};
};

}  // namespace

std::vector<Finding> rmanova_findings(const TidyInput& input) {
  const Design design = read_design(input);
  return AnovaList(input, design).findings();
}

}  // namespace asperity
