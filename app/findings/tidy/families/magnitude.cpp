// Roughness by magnitude estimation: normalised means, exponents, quadratic curves and their peaks.

#include "analysis/scales/magnitude.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/summary.h"
#include "analysis/tests/repeated_measures.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/repeated_rows.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

/// Estimates with the indices of their participants, probes and spacings.
struct Estimates {
  std::vector<std::string> participants{};  ///< in the order of their first positive estimate
  std::vector<std::string> probes{};
  /// A stimulus whose estimates are compared: an item, or all rows with one spacing.
  struct Stimulus {
    std::string name{};               ///< in the keys of findings
    std::optional<double> spacing{};  ///< its value of the predictor; nothing where there is none
  };
  std::vector<Stimulus>
      stimuli{};  ///< in ascending order of the predictor, or otherwise of their first row
  std::vector<MagnitudeEstimate> positive{};
  std::size_t missing = 0;
  std::size_t zeros = 0;
};

ZeroRule zero_rule_of(const std::string& name) {
  if (name == "exclude") return ZeroRule::exclude;
  if (name == "halfmin") return ZeroRule::half_of_least;
  throw std::runtime_error("the option \"zero_rule\" is \"" + name +
                           "\"; it must be exclude or halfmin");
}

std::string names_text(const std::vector<Estimates::Stimulus>& stimuli) {
  std::string text{};
  for (const Estimates::Stimulus& one : stimuli) text += (text.empty() ? "" : ", ") + one.name;
  return text;
}

/// Numbers in canonical form, other names unchanged: 0.50 and 0.5 are one probe.
std::string probe_name(std::string_view text) {
  const TidyTable one("p\n" + std::string(text) + '\n', "");
  try {
    return number_text(one.all_numbers("p").front());
  } catch (const std::exception&) {
    return std::string(text);
  }
}

/// The stimuli of a table, and that of each row.
struct StimulusRows {
  std::vector<Estimates::Stimulus> stimuli{};
  std::vector<std::size_t> of_row{};
};

void refuse_spacing(const TidyTable& table, std::size_t row, double spacing) {
  if (spacing > 0.0) return;
  table.refuse(row, "spacing",
               "spacing is " + number_text(spacing) +
                   "; it must be above 0, because its logarithm is the abscissa");
}

StimulusRows stimuli_by_spacing(const std::vector<double>& spacings) {
  std::vector<double> levels = spacings;
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  StimulusRows rows{};
  for (const double level : levels) rows.stimuli.push_back({number_text(level), level});
  for (const double spacing : spacings) {
    const auto level = std::lower_bound(levels.begin(), levels.end(), spacing);
    rows.of_row.push_back(static_cast<std::size_t>(level - levels.begin()));
  }
  return rows;
}

/// By the column `item`, with the predictor in the column `spacing`, if there is one.
StimulusRows stimuli_by_item(const TidyTable& table) {
  const LabelColumn items = table.all_labels("item");
  StimulusRows rows{};
  for (const std::string& name : items.names) rows.stimuli.push_back({name, std::nullopt});
  rows.of_row.assign(items.codes.begin(), items.codes.end());
  if (!table.has("spacing")) return rows;
  const std::vector<double> spacings = table.all_numbers("spacing");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    refuse_spacing(table, row, spacings[row]);
    Estimates::Stimulus& stimulus = rows.stimuli[rows.of_row[row]];
    if (stimulus.spacing && *stimulus.spacing != spacings[row]) {
      table.refuse(row, "spacing",
                   "spacing is " + number_text(spacings[row]) + ", and in an earlier row of " +
                       stimulus.name + " it is " + number_text(*stimulus.spacing) +
                       "; an item has one value of the predictor");
    }
    stimulus.spacing = spacings[row];
  }
  std::vector<std::size_t> order(rows.stimuli.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&rows](std::size_t a, std::size_t b) {
    return rows.stimuli[a].spacing < rows.stimuli[b].spacing;
  });
  std::vector<std::size_t> place_of(order.size());
  StimulusRows sorted{};
  for (std::size_t place = 0; place < order.size(); ++place) {
    place_of[order[place]] = place;
    sorted.stimuli.push_back(rows.stimuli[order[place]]);
  }
  for (const std::size_t stimulus : rows.of_row) sorted.of_row.push_back(place_of[stimulus]);
  return sorted;
}

Estimates read_estimates(const TidyTable& table, ZeroRule rule) {
  const LabelColumn subjects = table.all_labels("subject");
  const LabelColumn probes = table.all_labels("probe");
  const bool has_items = table.has("item");
  const std::vector<double> spacings =
      has_items ? std::vector<double>{} : table.all_numbers("spacing");
  const std::vector<std::optional<double>> values = table.numbers("estimate");
  Estimates read{};
  const StimulusRows stimuli = has_items ? stimuli_by_item(table) : stimuli_by_spacing(spacings);
  std::vector<MagnitudeEstimate> answered{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!values[row]) {
      ++read.missing;
      continue;
    }
    if (*values[row] < 0.0) {
      table.refuse(row, "estimate",
                   "estimate is " + number_text(*values[row]) + "; it must be at least 0");
    }
    if (!has_items) refuse_spacing(table, row, spacings[row]);
    read.zeros += *values[row] == 0.0 ? 1 : 0;
    answered.push_back({.participant = subjects.codes[row],
                        .condition = probes.codes[row],
                        .level = stimuli.of_row[row],
                        .estimate = *values[row]});
  }
  if (rule == ZeroRule::half_of_least) {
    std::vector<bool> has_positive(subjects.names.size(), false);
    for (const MagnitudeEstimate& one : answered) {
      if (one.estimate > 0.0) has_positive[one.participant] = true;
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (values[row] && !has_positive[subjects.codes[row]]) {
        table.refuse(row, "estimate",
                     "all estimates of " + subjects.names[subjects.codes[row]] +
                         " are 0, but halfmin requires a positive estimate; leave this participant "
                         "out, or set zero_rule to exclude");
      }
    }
  }
  read.positive = without_zeros(answered, rule);

  std::vector<std::string> probe_names{};
  for (const std::string& name : probes.names) probe_names.push_back(probe_name(name));
  // Only rows with an estimate count; names are in the order of their first one.
  std::map<std::size_t, std::size_t> participant_places{};
  std::map<std::string, std::size_t> probe_places{};
  std::map<std::size_t, std::size_t> level_places{};
  for (const MagnitudeEstimate& one : read.positive) level_places.emplace(one.level, 0);
  for (auto& [level, place] : level_places) {
    place = read.stimuli.size();
    read.stimuli.push_back(stimuli.stimuli[level]);
  }
  for (MagnitudeEstimate& one : read.positive) {
    const auto participant = participant_places.emplace(one.participant, read.participants.size());
    if (participant.second) read.participants.push_back(subjects.names[one.participant]);
    const std::string& name = probe_names[one.condition];
    const auto probe = probe_places.emplace(name, read.probes.size());
    if (probe.second) read.probes.push_back(name);
    one.participant = participant.first->second;
    one.condition = probe.first->second;
    one.level = level_places.at(one.level);
  }
  return read;
}

std::vector<std::vector<std::size_t>> resampled_people(const TidyTable& table,
                                                       std::size_t participants) {
  std::vector<std::vector<std::size_t>> rows(table.rows());
  for (std::size_t draw = 1; table.has('s' + std::to_string(draw)); ++draw) {
    const std::string column = 's' + std::to_string(draw);
    const std::vector<std::uint64_t> places = table.counts(column);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (places[row] < 1 || places[row] > participants) {
        table.refuse(row, column,
                     "the number of the participant is " + std::to_string(places[row]) +
                         "; it must be from 1 to " + std::to_string(participants));
      }
      rows[row].push_back(static_cast<std::size_t>(places[row] - 1));
    }
  }
  return rows;
}

enum class Normalisation { grand_mean, standard, none };

class MagnitudeList final {
 public:
  MagnitudeList(const TidyInput& input, const Estimates& read)
      : input_(input), read_(read), confidence_(input.options.confidence()) {}

  std::vector<Finding> findings() {
    const MagnitudeCells cells =
        magnitude_cells(read_.positive, {.participants = read_.participants.size(),
                                         .conditions = read_.probes.size(),
                                         .levels = read_.stimuli.size()});
    participants(cells);
    if (cells.complete.empty()) {
      list_.word(
          "status", "", "no_data",
          "no participant has an estimate in every cell, so that nothing can be compared: add "
          "the missing estimates",
          basis("participants with an estimate in every cell"));
      return list_.take();
    }
    const std::vector<Eigen::MatrixXd> normalised = normalise(cells);
    means(normalised);
    if (n_ < 2) {
      list_.word("status", "", "one_participant",
                 "differences between participants cannot be estimated from one participant: add "
                 "participants for intervals and tests",
                 basis("participants with an estimate in every cell"));
      return list_.take();
    }
    curves(normalised);
    return list_.take();
  }

 private:
  Basis basis(std::string method) const { return {.n = n_, .method = std::move(method)}; }
  void number(const std::string& quantity, const FindingKey& key, double value,
              std::string method) {
    list_.number(quantity, key, value, basis(std::move(method)));
  }
  void number(const std::string& quantity, const FindingKey& key,
              const std::optional<double>& value, std::string method) {
    number(quantity, key, value.value_or(kUndefined), std::move(method));
  }

  void participants(const MagnitudeCells& cells) {
    list_.count("n.missing", "", read_.missing, basis("rows without an estimate, left out"));
    list_.count("n.zero", "", read_.zeros,
                basis("estimates of 0, " + input_.options.text("zero_rule")));
    std::string incomplete{};
    for (const std::size_t one : cells.incomplete) {
      incomplete += (incomplete.empty() ? "" : ";") + read_.participants[one];
    }
    list_.word("subjects.incomplete", "", incomplete.empty() ? "none" : incomplete,
               incomplete.empty() ? "ok"
                                  : "these participants have an empty cell and were left out: "
                                    "add the missing estimates to include them",
               basis("participants left out"));
    n_ = cells.complete.size();
    for (const std::size_t one : cells.complete) names_.push_back(read_.participants[one]);
    list_.count("n.subjects", "", n_, basis("participants with an estimate in every cell"));
    replicates(cells);
    const Eigen::VectorXd own = participant_means(cells);
    for (std::size_t i = 0; i < n_; ++i) {
      number("subject.geomean", names_[i], std::pow(10.0, own(static_cast<Eigen::Index>(i))),
             "geometric mean of the participant's cells");
    }
  }

  void replicates(const MagnitudeCells& cells) {
    const std::size_t probes = read_.probes.size();
    const std::size_t spacings = read_.stimuli.size();
    std::vector<std::size_t> estimates(read_.participants.size() * probes * spacings);
    for (const MagnitudeEstimate& one : read_.positive) {
      ++estimates[(one.participant * probes + one.condition) * spacings + one.level];
    }
    std::vector<CellRows> rows{};
    for (const std::size_t one : cells.complete) {
      for (std::size_t probe = 0; probe < probes; ++probe) {
        for (std::size_t level = 0; level < spacings; ++level) {
          rows.push_back({.participant = read_.participants[one],
                          .cell = cell_key(probe, level).text(),
                          .rows = estimates[(one * probes + probe) * spacings + level]});
        }
      }
    }
    add_replicates(rows, n_, list_);
  }

  std::vector<Eigen::MatrixXd> normalise(const MagnitudeCells& cells) {
    const std::string name = input_.options.text("normalisation");
    if (name == "geomean") {
      number("grand.geomean", "", std::pow(10.0, participant_means(cells).mean()),
             "geometric mean of all cells");
      normalisation_ = Normalisation::grand_mean;
      return normalised_to_grand_mean(cells);
    }
    if (name == "none") {
      normalisation_ = Normalisation::none;
      return cells.log10;
    }
    if (name != "standard") {
      throw std::runtime_error("the option \"normalisation\" is \"" + name +
                               "\"; it must be geomean, standard or none");
    }
    normalisation_ = Normalisation::standard;
    return normalised_to_standard(
        cells, {.level = level_of_standard(), .modulus = input_.options.number("modulus")});
  }

  std::size_t level_of_standard() const {
    const bool is_item = input_.table().has("item");
    const std::string option = is_item ? "standard_item" : "standard_spacing";
    const std::string standard =
        is_item ? input_.options.text(option) : number_text(input_.options.number(option));
    const auto found = std::find_if(read_.stimuli.begin(), read_.stimuli.end(),
                                    [&](const auto& one) { return one.name == standard; });
    if (found == read_.stimuli.end()) {
      throw std::runtime_error("the option \"" + option + "\" is " + standard +
                               "; it must be one of the " + (is_item ? "items" : "spacings") +
                               " of the table: " + names_text(read_.stimuli));
    }
    return static_cast<std::size_t>(found - read_.stimuli.begin());
  }

  FindingKey cell_key(std::size_t probe, std::size_t spacing) const {
    return {read_.probes[probe], read_.stimuli[spacing].name};
  }

  void means(const std::vector<Eigen::MatrixXd>& normalised) {
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t probe = 0; probe < normalised.size(); ++probe) {
        for (std::size_t level = 0; level < read_.stimuli.size(); ++level) {
          number("norm.estimate", {names_[i], cell_key(probe, level)},
                 std::pow(10.0, normalised[probe](static_cast<Eigen::Index>(i),
                                                  static_cast<Eigen::Index>(level))),
                 "normalised estimate");
        }
      }
    }
    const auto cells = static_cast<double>(normalised.size() * read_.stimuli.size());
    const double morey = std::sqrt(cells / (cells - 1.0));
    for (std::size_t probe = 0; probe < normalised.size(); ++probe) {
      const CellMeans cell = cell_means(normalised[probe], confidence_);
      for (std::size_t level = 0; level < read_.stimuli.size(); ++level) {
        const auto column = static_cast<Eigen::Index>(level);
        const FindingKey key = cell_key(probe, level);
        const double mean = cell.mean(column);
        // With a single cell, every participant's normalised estimate is the grand mean.
        const bool has_spread =
            cell.half_width && (normalisation_ != Normalisation::grand_mean || cells > 1.0);
        const double half = has_spread ? (*cell.half_width)(column) : kUndefined;
        const ConfidenceInterval ends{.low = std::pow(10.0, mean - half),
                                      .high = std::pow(10.0, mean + half)};
        const ConfidenceInterval wider{.low = std::pow(10.0, mean - half * morey),
                                       .high = std::pow(10.0, mean + half * morey)};
        const bool is_within = normalisation_ == Normalisation::grand_mean;
        Basis shown =
            basis(is_within ? "geometric mean of normalised estimates; within-participant "
                              "interval on the log scale (Cousineau and Morey)"
                  : normalisation_ == Normalisation::none
                      ? "geometric mean of estimates; t interval on the log scale"
                      : "geometric mean of normalised estimates; t interval on the log scale");
        if (has_spread) {
          shown.interval = is_within ? wider : ends;
          shown.confidence = confidence_;
        }
        list_.number("geomean", key, std::pow(10.0, mean), shown);
        const auto limit = [&](const char* quantity, double value, std::string method) {
          Basis of_limit = basis(std::move(method));
          of_limit.undefined =
              cell.half_width ? "with a single cell, all normalised estimates equal the grand mean"
                              : "differences between participants cannot be estimated from one "
                                "participant: add participants";
          list_.number(quantity, key, value, of_limit);
        };
        limit("geomean.ci.lower", ends.low, "t interval on the log scale");
        limit("geomean.ci.upper", ends.high, "t interval on the log scale");
        if (is_within) {
          limit("geomean.ci.lower.morey", wider.low,
                "widened by √(J/(J−1)) for J cells (Cousineau and Morey)");
          limit("geomean.ci.upper.morey", wider.high,
                "widened by √(J/(J−1)) for J cells (Cousineau and Morey)");
        }
      }
    }
  }

  void curves(const std::vector<Eigen::MatrixXd>& normalised) {
    std::set<double> different{};
    for (const Estimates::Stimulus& stimulus : read_.stimuli) {
      if (!stimulus.spacing) return;
      different.insert(*stimulus.spacing);
    }
    const bool has_items = input_.table().has("item");
    if (has_items) {
      for (const Estimates::Stimulus& stimulus : read_.stimuli) {
        number("predictor", stimulus.name, *stimulus.spacing, "value of the predictor");
      }
    }
    if (different.size() < 3) {
      list_.word("status", "", "too_few_spacings",
                 has_items ? "an exponent needs at least three different values of the predictor; "
                             "add stimuli, or state another predictor"
                           : "a curve needs at least three spacings: present more spacings",
                 basis(has_items ? "values of the predictor" : "spacings"));
      return;
    }
    Eigen::VectorXd x(static_cast<Eigen::Index>(read_.stimuli.size()));
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      x(i) = std::log10(*read_.stimuli[static_cast<std::size_t>(i)].spacing);
    }
    const std::vector<std::vector<std::size_t>> resamples =
        input_.tables.size() > 1 ? resampled_people(input_.table(1), n_)
                                 : std::vector<std::vector<std::size_t>>{};
    std::vector<QuadraticFit> fits{};
    for (std::size_t probe = 0; probe < normalised.size(); ++probe) {
      const MagnitudeCurves one{.log10 = normalised[probe], .x = x, .confidence = confidence_};
      line(read_.probes[probe], power_law(one));
      fits.push_back(quadratic_fit(one));
      curve(read_.probes[probe], fits.back());
      types(read_.probes[probe], fits.back(), x);
      if (fits.back().peak && !resamples.empty()) {
        bootstrap(read_.probes[probe], fits.back(), resamples);
      }
    }
    for (std::size_t a = 0; a < fits.size(); ++a) {
      for (std::size_t b = a + 1; b < fits.size(); ++b) {
        shift({read_.probes[a], read_.probes[b]}, fits[a], fits[b]);
      }
    }
  }

  void line(const std::string& probe, const PowerLaw& law) {
    for (std::size_t i = 0; i < n_; ++i) {
      number("exponent.subject", {probe, names_[i]}, law.exponents[i],
             "least squares on logarithms");
    }
    Basis mean = basis("mean exponent over participants; t interval");
    if (law.exponent.test) {
      mean.interval = law.exponent.test->interval;
      mean.confidence = confidence_;
    }
    list_.number("exponent.mean", probe, law.exponent.mean, mean);
    if (const auto& test = law.exponent.test) {
      number("exponent.se", probe, test->standard_error, "over participants");
      number("exponent.ci.lower", probe, test->interval.low, "t interval");
      number("exponent.ci.upper", probe, test->interval.high, "t interval");
      number("exponent.t", probe, test->t, "exponent against 0, t over participants");
      if (input_.table().has("item")) {
        number("exponent.df", probe, static_cast<double>(n_) - 1.0, "degrees of freedom of t");
      }
      number("exponent.p", probe, test->p,
             "exponent against 0, two-sided t test over participants");
    } else {
      list_.word(
          "exponent.t", probe, "undefined_zero_variance",
          "all participants have the same exponent, so that t is undefined: add participants",
          basis("t over participants"));
    }
    number("intercept.mean", probe, law.intercept, "log₁₀R at x = 0, mean over participants");
    number("pooled.linear.slope", probe, law.pooled_slope, "line through the means");
    number("pooled.linear.r2", probe, law.pooled_r2, "line through the means");
    number(
        "pooled.linear.se", probe, law.pooled_slope_se,
        "from the residuals of the means; does not include the differences between participants");
  }

  void curve(const std::string& probe, const QuadraticFit& fit) {
    const std::array<std::string, 3> names{"a", "b", "c"};
    const std::array<double, 3> mean{fit.mean.a, fit.mean.b, fit.mean.c};
    for (std::size_t i = 0; i < 3; ++i) {
      number("quad.coef", {probe, names[i]}, mean[i], "a + bx + cx², mean over participants");
      for (std::size_t j = 0; j < 3; ++j) {
        number("quad.cov", {probe, names[i], names[j]},
               fit.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
               "covariance of the mean coefficients, from the differences between participants");
      }
    }
    number("pooled.quad.r2", probe, fit.pooled_r2, "curve through the means");
    number("pooled.quad.vs.linear.F", probe, fit.F,
           "F of the parabola against the line, through the means");
    number("pooled.quad.vs.linear.p", probe, fit.p,
           "F test of the parabola against the line, through the means");
    if (const auto& test = fit.curvature.test) {
      number("quad.c.t", probe, test->t,
             "curvature of the parabola against 0, t over participants");
      number("quad.c.p", probe, test->p,
             "curvature of the parabola against 0, two-sided t test over participants");
    } else {
      list_.word(
          "quad.c.t", probe, "undefined_zero_variance",
          "all participants have the same curvature, so that t is undefined: add participants",
          basis("curvature of the parabola against 0, t over participants"));
    }
    for (const auto& [name, end] : {std::pair{std::string("low"), fit.ends[0]},
                                    std::pair{std::string("high"), fit.ends[1]}}) {
      number("invU.slope." + name, probe, end.slope, "slope of the mean curve at this end");
      number("invU.t." + name, probe, end.t, "t of the slope of the mean curve at this end");
      number("invU.p." + name, probe, end.p,
             name == "low"
                 ? "slope of the mean curve at the low end, one-sided t test for a rising curve"
                 : "slope of the mean curve at the high end, one-sided t test for a falling curve");
    }
    number("invU.p", probe, fit.interior_maximum_p(),
           "interior maximum: the larger of the two one-sided p values (Lind and Mehlum)");
    list_.truth("invU.significant", probe,
                fit.interior_maximum_p().value_or(1.0) < 1.0 - confidence_,
                basis("whether the mean curve has a significant interior maximum"));
    peak(probe, fit);
    list_.count("peak.subjects.concave", probe, fit.concave_participants,
                basis("participants whose parabola opens downwards"));
    list_.count("peak.subjects.inrange", probe, fit.participant_peaks.size(),
                basis("participants whose own peak lies within the tested spacings"));
    if (!fit.participant_peaks.empty()) {
      number("peak.subjects.median", probe, std::pow(10.0, summary_of(fit.participant_peaks)->p50),
             "median of the participants' own peaks within the tested spacings");
    }
  }

  void types(const std::string& probe, const QuadraticFit& fit, const Eigen::VectorXd& x) {
    std::map<CurveType, std::uint64_t> counts{};
    for (const Quadratic& one : fit.participants) {
      ++counts[curve_type(one, {.lowest_x = x.minCoeff(), .highest_x = x.maxCoeff()})];
    }
    const std::string how = "participants whose own curve ";
    list_.count("curve.descending", probe, counts[CurveType::descending],
                basis(how + "falls at the smallest and the largest spacing"));
    list_.count("curve.inverted_u", probe, counts[CurveType::inverted_u],
                basis(how + "rises at the smallest and falls at the largest spacing"));
    list_.count("curve.other", probe, counts[CurveType::other], basis(how + "has another form"));
  }

  void peak(const std::string& probe, const QuadraticFit& fit) {
    switch (fit.status) {
      case PeakStatus::no_maximum:
        list_.word(
            "peak.status", probe, "no_maximum",
            "the mean parabola opens upwards, so that there is no peak: present a wider range of "
            "spacings",
            basis("peak"));
        return;
      case PeakStatus::outside_range:
        list_.word("peak.status", probe, "outside_range",
                   "the peak lies outside the tested spacings: present a wider range",
                   basis("peak"));
        break;
      case PeakStatus::inside:
        list_.word("peak.status", probe, "ok", "ok", basis("peak"));
        break;
    }
    if (fit.peak) {
      const QuadraticFit::Peak& found = *fit.peak;
      const auto back = [](double x) { return std::pow(10.0, x); };
      number("peak.log10", probe, found.x, "−b/2c of the mean coefficients");
      Basis shown = basis("spacing of the peak; delta interval");
      shown.interval =
          ConfidenceInterval{.low = back(found.interval.low), .high = back(found.interval.high)};
      shown.confidence = confidence_;
      list_.number("peak", probe, back(found.x), shown);
      number("peak.se.log10", probe, found.standard_error, "delta method, over participants");
      number("peak.delta.lower", probe, shown.interval->low, "delta interval");
      number("peak.delta.upper", probe, shown.interval->high, "delta interval");
      number("peak.height", probe, back(found.height), "roughness at the peak");
      number("peak.se.log10.pooledOLS", probe, found.pooled_standard_error,
             "from the residuals of the means; a check only");
    }
    list_.word("peak.fieller", probe, fit.fieller ? "bounded" : "unbounded",
               fit.fieller
                   ? "ok"
                   : "the curvature is not significantly different from 0, so that the peak "
                     "has no finite interval: add participants or spacings",
               basis("Fieller's set"));
    if (fit.peak && fit.fieller) {
      number("peak.fieller.lower", probe, std::pow(10.0, fit.fieller->low), "Fieller's interval");
      number("peak.fieller.upper", probe, std::pow(10.0, fit.fieller->high), "Fieller's interval");
    }
  }

  void bootstrap(const std::string& probe, const QuadraticFit& fit,
                 const std::vector<std::vector<std::size_t>>& resamples) {
    const std::optional<PeakBootstrap> boot = bootstrap_peak(fit, resamples, confidence_);
    if (!boot) {
      list_.word("boot.valid", probe, "NA",
                 "fewer than two resamples have a maximum: use more resamples, or add participants",
                 basis("resampled participants"));
      return;
    }
    list_.count("boot.valid", probe, boot->valid, basis("resamples with a maximum"));
    number("boot.perc.lower", probe, std::pow(10.0, boot->percentile.low), "percentile");
    number("boot.perc.upper", probe, std::pow(10.0, boot->percentile.high), "percentile");
    number("boot.se.log10", probe, boot->standard_error,
           "standard deviation of the resampled peaks");
    if (boot->bias_corrected) {
      number("boot.bca.z0", probe, boot->bias_corrected->z0, "BCa bias");
      number("boot.bca.a", probe, boot->bias_corrected->acceleration, "BCa acceleration");
      number("boot.bca.lower", probe, std::pow(10.0, boot->bias_corrected->interval.low), "BCa");
      number("boot.bca.upper", probe, std::pow(10.0, boot->bias_corrected->interval.high), "BCa");
    }
  }

  void shift(const FindingKey& key, const QuadraticFit& first, const QuadraticFit& second) {
    const std::optional<PeakShift> found =
        peak_shift({.first = first, .second = second, .confidence = confidence_});
    if (!found) return;
    const ConfidenceInterval ends{.low = std::pow(10.0, found->interval.low),
                                  .high = std::pow(10.0, found->interval.high)};
    Basis shown = basis("ratio of the peaks, first over second; delta interval");
    shown.interval = ends;
    shown.confidence = confidence_;
    list_.number("peakratio", key, std::pow(10.0, found->difference), shown);
    number("peakratio.se.log10", key, found->standard_error,
           "delta method, joint covariance of the participants' coefficients");
    number("peakratio.t", key, found->t, "t over participants");
    number("peakratio.df", key, static_cast<double>(n_) - 1.0, "degrees of freedom of t");
    number("peakratio.p", key, found->p, "two-sided t test over participants");
    number("peakratio.lower", key, ends.low, "delta interval");
    number("peakratio.upper", key, ends.high, "delta interval");
  }

  const TidyInput& input_;
  const Estimates& read_;
  double confidence_ = 0.95;
  Normalisation normalisation_ = Normalisation::grand_mean;
  std::size_t n_ = 0;
  std::vector<std::string> names_{};
  FindingList list_{};
};

}  // namespace

std::vector<Finding> magnitude_findings(const TidyInput& input) {
  const Estimates read =
      read_estimates(input.table(), zero_rule_of(input.options.text("zero_rule")));
  return MagnitudeList(input, read).findings();
}

}  // namespace asperity
