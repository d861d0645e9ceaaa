// The tables that every family has, each also as findings.

#include "app/analyses/tally.h"

#include <algorithm>
#include <utility>

#include "analysis/summary.h"

namespace asperity {

namespace {

constexpr double kConfidence = 0.95;
constexpr const char* kOtherSex = "Other or not told";

Cell whole(std::uint64_t count) { return static_cast<std::int64_t>(count); }

std::string finding_key(const ShareTable& shares, const ShareRow& row) {
  std::string key{};
  for (std::size_t i = 0; i < shares.key_columns.size(); ++i) {
    key += (key.empty() ? "" : " ") + shares.key_columns[i] + '=' + row.keys.at(i);
  }
  return key;
}

Finding interval_finding(const Finding& about, const ConfidenceInterval& interval,
                         std::string method) {
  Finding finding = about;
  finding.low = interval.low;
  finding.high = interval.high;
  finding.confidence = kConfidence;
  finding.method = std::move(method);
  return finding;
}

}  // namespace

void Tally::count(const std::string& person, bool hit, std::uint64_t outcomes) {
  ++hits_.trials;
  if (hit) ++hits_.hits;
  persons_.insert(person);
  outcomes_.insert(outcomes);
}

std::optional<std::uint64_t> Tally::outcomes() const {
  if (outcomes_.size() != 1) return std::nullopt;
  return *outcomes_.begin();
}

void add_shares(const ShareTable& shares, AnalysisOutcome& outcome) {
  NamedTable made{shares.name, shares.title, {}, shares.note};
  made.table.columns = shares.key_columns;
  for (const char* column : {"of", "persons", "share", "wilson_low", "wilson_high",
                             "clopper_pearson_low", "clopper_pearson_high", "chance", "p"}) {
    made.table.columns.push_back(column);
  }
  made.table.columns.insert(
      made.table.columns.begin() + static_cast<std::ptrdiff_t>(shares.key_columns.size()),
      shares.hits_column);
  for (const ShareRow& row : shares.rows) {
    const HitCount count = row.tally.hits();
    std::vector<Cell>& cells = made.table.rows.emplace_back(row.keys.begin(), row.keys.end());
    cells.insert(cells.end(), {whole(count.hits), whole(count.trials), whole(row.tally.persons())});
    Finding about{};
    about.quantity = shares.quantity;
    about.key = finding_key(shares, row);
    about.unit = "1";
    about.n = row.tally.persons();
    if (count.trials == 0) {
      cells.resize(made.table.columns.size());
      about.status = "nobody has answered yet";
      outcome.findings.push_back(about);
      continue;
    }
    about.value = proportion(count);
    const ConfidenceInterval wilson = wilson_interval(count, kConfidence);
    const ConfidenceInterval exact = clopper_pearson_interval(count, kConfidence);
    outcome.findings.push_back(interval_finding(about, wilson, "Wilson score interval"));
    outcome.findings.push_back(interval_finding(about, exact, "Clopper–Pearson interval"));
    cells.insert(cells.end(), {*about.value, wilson.low, wilson.high, exact.low, exact.high});

    Finding test = about;
    test.quantity = "p";
    const std::optional<std::uint64_t> outcomes = row.tally.outcomes();
    if (outcomes) {
      const double chance = 1.0 / static_cast<double>(*outcomes);
      test.value = binomial_test(count, chance);
      test.method = "exact two-sided binomial test of " + shares.quantity + " against chance 1/" +
                    std::to_string(*outcomes);
      cells.insert(cells.end(), {chance, *test.value});
    } else {
      test.value.reset();
      test.status = "chance differs between the trials, so that one test of all would be wrong";
      cells.resize(made.table.columns.size());
    }
    outcome.findings.push_back(std::move(test));
  }
  outcome.tables.push_back(std::move(made));
}

Phrase chance_note(const Tally& tally, const Phrase& at_chance) {
  const std::optional<std::uint64_t> outcomes = tally.outcomes();
  if (!outcomes) return phrase("Analysis", "Chance differs between the trials.");
  return at_chance.with(std::to_string(*outcomes));
}

void add_person_shares(std::span<const PersonShares> shares, const std::string& key_column,
                       const std::string& quantity, AnalysisOutcome& outcome) {
  NamedTable made{
      "persons",
      phrase("Analysis", "The person as the unit: each person's own share, over the persons"),
      {{key_column, "persons", "mean", "sd", "minimum", "median", "maximum"}, {}},
      {}};
  for (const PersonShares& item : shares) {
    std::vector<double> own{};
    for (const auto& [person, tally] : item.people) own.push_back(proportion(tally.hits()));
    const std::optional<Summary> summary = summary_of(own);
    if (!summary) continue;
    made.table.rows.push_back({item.key, whole(summary->n), summary->mean,
                               summary->n > 1 ? Cell{summary->sd} : Cell{}, summary->minimum,
                               summary->p50, summary->maximum});
    Finding finding{};
    finding.quantity = "mean_of_persons_" + quantity;
    finding.key = key_column + '=' + item.key;
    finding.value = summary->mean;
    finding.unit = "1";
    finding.method = "mean of the persons' own shares";
    finding.n = summary->n;
    outcome.findings.push_back(std::move(finding));
  }
  outcome.tables.push_back(std::move(made));
}

void add_counts(const CountTable& counts, std::span<const std::string> columns,
                const std::function<std::size_t(std::size_t, const std::string&)>& at,
                AnalysisOutcome& outcome) {
  NamedTable made{counts.name, counts.title, {}, counts.note};
  made.table.columns.push_back(counts.label_column);
  for (const std::string& column : columns) {
    made.table.columns.push_back(column == kAllColumns ? column : "column_" + column);
  }
  for (std::size_t label = 0; label < counts.labels.size(); ++label) {
    std::vector<Cell>& cells = made.table.rows.emplace_back();
    cells.push_back(counts.labels[label]);
    for (const std::string& column : columns) cells.push_back(whole(at(label, column)));
  }
  outcome.tables.push_back(std::move(made));
}

void add_confusion(std::span<const std::pair<std::string, std::string>> pairs,
                   const std::set<std::string>& options, AnalysisOutcome& outcome) {
  std::map<std::string, std::map<std::string, std::size_t>> chosen{};
  std::set<std::string> columns = options;
  for (const auto& [felt, answer] : pairs) {
    ++chosen[felt][answer];
    columns.insert(answer);
  }
  NamedTable made{kConfusion,
                  phrase("Analysis", "Confusions: felt (down) and chosen picture (across)"),
                  {},
                  {}};
  made.table.columns.push_back("felt");
  made.table.columns.insert(made.table.columns.end(), columns.begin(), columns.end());
  for (const auto& [felt, counts] : chosen) {
    std::vector<Cell>& cells = made.table.rows.emplace_back();
    cells.push_back(felt);
    for (const std::string& column : columns) {
      const auto found = counts.find(column);
      cells.push_back(whole(found == counts.end() ? 0 : found->second));
    }
  }
  outcome.tables.push_back(std::move(made));
}

void add_texture_force(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  struct Forces {
    std::size_t surfaces = 0;
    std::vector<double> matched_N{};
    std::vector<double> achieved_N{};
  };
  std::map<std::string, Forces> by_model{};
  for (const GatheredAnswer& answer : gathered.answers) {
    for (const FeltSurface& surface : answer.surfaces) {
      Forces& forces = by_model[surface.model];
      ++forces.surfaces;
      if (surface.matched_texture_force_N)
        forces.matched_N.push_back(*surface.matched_texture_force_N);
      if (surface.achieved_texture_force_N) {
        forces.achieved_N.push_back(*surface.achieved_texture_force_N);
      }
    }
  }
  NamedTable made{
      "texture_force",
      phrase("Analysis",
             "Texture force (RMS) per model: aimed at on the prescribed path, achieved by the "
             "hands"),
      {{"model", "surfaces", "matched_mean_N", "achieved_mean_N", "achieved_sd_N",
        "achieved_minimum_N", "achieved_maximum_N"},
       {}},
      phrase("Analysis",
             "Equal RMS is not equal intensity: what is felt also depends on frequency, and each "
             "hand presses and moves in its own way.")};
  for (const auto& [model, forces] : by_model) {
    std::vector<Cell>& cells = made.table.rows.emplace_back();
    cells.insert(cells.end(), {model, whole(forces.surfaces)});
    const std::optional<Summary> matched = summary_of(forces.matched_N);
    const std::optional<Summary> achieved = summary_of(forces.achieved_N);
    cells.push_back(matched ? Cell{matched->mean} : Cell{});
    if (achieved) {
      cells.insert(cells.end(), {achieved->mean, achieved->n > 1 ? Cell{achieved->sd} : Cell{},
                                 achieved->minimum, achieved->maximum});
    }
    cells.resize(made.table.columns.size());
    Finding finding{};
    finding.quantity = "achieved_texture_force_N";
    finding.key = "model=" + model;
    finding.unit = "N";
    finding.method = "mean over the surfaces felt";
    finding.n = forces.achieved_N.size();
    if (achieved) {
      finding.value = achieved->mean;
    } else {
      finding.status = "no surface was felt for long enough";
    }
    outcome.findings.push_back(std::move(finding));
  }
  const bool measured = std::any_of(by_model.begin(), by_model.end(), [](const auto& of_model) {
    return !of_model.second.matched_N.empty() || !of_model.second.achieved_N.empty();
  });
  if (measured) outcome.tables.push_back(std::move(made));
}

void remark_on_pooling(std::size_t answers, std::size_t persons, AnalysisOutcome& outcome) {
  if (answers <= persons) return;
  const Phrase pooled =
      persons == 1
          ? phrase("Analysis",
                   "Where \"of\" is larger than \"persons\", answers of the same person are "
                   "pooled (%1 answers of one person in all). They are not independent: the "
                   "intervals are too narrow and the p too small.")
          : phrase("Analysis",
                   "Where \"of\" is larger than \"persons\", answers of the same persons are "
                   "pooled (%1 answers of %2 persons in all). They are not independent: the "
                   "intervals are too narrow and the p too small. The table \"persons\" takes the "
                   "person as the unit.");
  outcome.remarks.push_back(pooled.with(std::to_string(answers), std::to_string(persons)));
}

std::vector<std::string> columns_of(const GatheredAnswers& gathered) {
  std::set<std::string> levels{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!answer.column.empty()) levels.insert(answer.column);
  }
  std::vector<std::string> columns(levels.begin(), levels.end());
  const bool numbers = std::all_of(columns.begin(), columns.end(), [](const std::string& level) {
    return number_in(level).has_value();
  });
  if (numbers) {
    std::sort(columns.begin(), columns.end(), [](const std::string& a, const std::string& b) {
      return *number_in(a) < *number_in(b);
    });
  }
  columns.emplace_back(kAllColumns);
  return columns;
}

bool stands_in(const GatheredAnswer& answer, const std::string& column) {
  return column == kAllColumns || answer.column == column;
}

std::vector<std::string> sex_labels(const GatheredAnswers& gathered) {
  std::vector<std::string> labels{"Female", "Male"};
  const bool others =
      std::any_of(gathered.answers.begin(), gathered.answers.end(),
                  [](const GatheredAnswer& answer) { return is_of(answer, kOtherSex); });
  if (others) labels.emplace_back(kOtherSex);
  labels.emplace_back("Total");
  return labels;
}

bool is_of(const GatheredAnswer& answer, const std::string& sex_label) {
  if (sex_label == "Total") return true;
  const std::string sex = answer.sex.value_or("");
  if (sex == "F") return sex_label == "Female";
  if (sex == "M") return sex_label == "Male";
  return sex_label == kOtherSex;
}

}  // namespace asperity
