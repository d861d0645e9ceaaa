// Counts by participant and column in one pass; proportions and their p come from the family `proportion`.

#include "app/findings/outcome/tally.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/summary.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/study_findings.h"

namespace asperity {

namespace {

constexpr double kTallyConfidence = 0.95;
constexpr const char* kOtherSex = "Other or not told";

ResultColumn of_force(const char* id, const Phrase& heading) {
  return {.id = id, .heading = heading, .unit = "N", .digits = Digits::force};
}
const ResultColumn kModel{.id = "model", .heading = phrase("AnalysisWords", "model")};
const ResultColumn kSurfaces{.id = "surfaces", .heading = phrase("AnalysisWords", "surfaces")};
const ResultColumn kMatchedMean =
    of_force("matched_mean_N", phrase("AnalysisWords", "intended, mean"));
const ResultColumn kAchievedMean =
    of_force("achieved_mean_N", phrase("AnalysisWords", "achieved, mean"));
const ResultColumn kAchievedSd = of_force("achieved_sd_N", phrase("AnalysisWords", "achieved, SD"));
const ResultColumn kAchievedMinimum =
    of_force("achieved_minimum_N", phrase("AnalysisWords", "achieved, minimum"));
const ResultColumn kAchievedMaximum =
    of_force("achieved_maximum_N", phrase("AnalysisWords", "achieved, maximum"));

/// The counts of a level of the factor `column`, or of all.
ResultColumn of_repetition(const std::string& level) {
  if (level == kAllColumns) return {.id = level, .heading = phrase("AnalysisWords", "all")};
  return {.id = "repetition_" + level,
          .heading = phrase("AnalysisWords", "repetition %1").with(level)};
}

std::string finding_key(const ShareTable& shares, const ShareRow& row) {
  std::string key{};
  for (std::size_t i = 0; i < shares.key_columns.size(); ++i) {
    key += (key.empty() ? "" : " ") + shares.key_columns[i].id + '=' + row.keys.at(i);
  }
  return key;
}

Finding interval_finding(const Finding& about, double low, double high, std::string method) {
  Finding finding = about;
  finding.low = low;
  finding.high = high;
  finding.confidence = kTallyConfidence;
  finding.method = std::move(method);
  return finding;
}

/// Every row analysed by the family of single counts, by the row's number. Where there is no single
/// chance level, its p is meaningless and is not used.
std::vector<Finding> numbers_of(const ShareTable& shares) {
  std::string text = "id,k,n,p0\n";
  for (std::size_t i = 0; i < shares.rows.size(); ++i) {
    const Tally& tally = shares.rows[i].tally;
    const double chance = 1.0 / static_cast<double>(tally.outcomes().value_or(1));
    text += std::to_string(i) + ',' + std::to_string(tally.hits().hits) + ',' +
            std::to_string(tally.hits().trials) + ',' + number_text(chance) + '\n';
  }
  TidyInput input{};
  input.tables.emplace_back(text, shares.name);
  return proportion_findings(input);
}

}  // namespace

void Tally::count(std::uint32_t person, bool hit, std::uint64_t outcomes, std::uint64_t times) {
  hits_.trials += times;
  if (hit) hits_.hits += times;
  if (seen_.size() <= person) seen_.resize(person + 1);
  if (!seen_[person]) ++persons_;
  seen_[person] = true;
  if (outcomes == last_outcomes_) return;
  outcomes_.insert(outcomes);
  last_outcomes_ = outcomes;
}

std::optional<std::uint64_t> Tally::outcomes() const {
  if (outcomes_.size() != 1) return std::nullopt;
  return *outcomes_.begin();
}

ResultTable& add_shares(const ShareTable& shares, AnalysisOutcome& outcome) {
  using namespace columns;
  ResultTable made{shares.name, shares.title, shares.key_columns, shares.note};
  made.columns.insert(made.columns.end(), {shares.hits_column, kOf, kPersons, kShare, kWilson,
                                           kClopperPearson, kChance, kP});
  const std::vector<Finding> numbers = numbers_of(shares);
  const FoundNumbers found(numbers);
  for (std::size_t i = 0; i < shares.rows.size(); ++i) {
    const ShareRow& row = shares.rows[i];
    const std::string id = std::to_string(i);
    const HitCount count = row.tally.hits();
    ResultRow& cells = made.rows.emplace_back(row.keys.begin(), row.keys.end());
    cells.insert(cells.end(), {count_cell(count.hits), count_cell(count.trials),
                               count_cell(row.tally.persons())});
    Finding about{};
    about.quantity = shares.quantity;
    about.key = finding_key(shares, row);
    about.unit = "1";
    about.n = row.tally.persons();
    if (count.trials == 0) {
      cells.resize(made.columns.size());
      about.status = "there are no responses that count";
      outcome.findings.push_back(about);
      continue;
    }
    const auto number = [&](QuantityName quantity) { return found.value(quantity, id).value(); };
    about.value = number("phat");
    outcome.findings.push_back(interval_finding(about, number("wilson.lower"),
                                                number("wilson.upper"), "Wilson score interval"));
    outcome.findings.push_back(interval_finding(about, number("cp.lower"), number("cp.upper"),
                                                "Clopper–Pearson interval"));
    cells.insert(cells.end(),
                 {*about.value, interval_cell(number("wilson.lower"), number("wilson.upper")),
                  interval_cell(number("cp.lower"), number("cp.upper"))});

    Finding test = about;
    test.quantity = "p";
    const std::optional<std::uint64_t> outcomes = row.tally.outcomes();
    if (outcomes) {
      const double chance = 1.0 / static_cast<double>(*outcomes);
      test.value = number("p.two");
      test.method = "exact two-sided binomial test of the proportion against the chance level 1/" +
                    std::to_string(*outcomes);
      cells.insert(cells.end(), {chance, *test.value});
      outcome.tests_in_tables.insert(name_of(test));
    } else {
      test.value.reset();
      test.status =
          "the chance level differs between the trials, so that one test of all trials is not "
          "valid";
      cells.resize(made.columns.size());
    }
    outcome.findings.push_back(std::move(test));
  }
  return outcome.tables.emplace_back(std::move(made));
}

Phrase chance_note(const Tally& tally, const Phrase& at_chance) {
  const std::optional<std::uint64_t> outcomes = tally.outcomes();
  if (!outcomes) return phrase("Analysis", "The chance level differs between trials.");
  return at_chance.with(std::to_string(*outcomes));
}

ChapterCells::ChapterCells(const GatheredAnswers& gathered)
    : column_of_word_(gathered.words.size(), 0) {
  std::set<std::uint32_t> levels{};
  for (const GatheredAnswer& answer : gathered.answers) levels.insert(gathered.column_of(answer));
  for (const std::uint32_t level : levels) {
    if (!gathered.word(level).empty()) columns_.push_back(gathered.word(level));
  }
  std::sort(columns_.begin(), columns_.end());
  const bool numbers = std::all_of(columns_.begin(), columns_.end(), [](const std::string& level) {
    return number_in(level).has_value();
  });
  if (numbers) {
    std::sort(columns_.begin(), columns_.end(), [](const std::string& a, const std::string& b) {
      return *number_in(a) < *number_in(b);
    });
  }
  columns_.emplace_back(kAllColumns);
  for (const std::uint32_t level : levels) {
    const auto found = std::find(columns_.begin(), columns_.end() - 1, gathered.word(level));
    column_of_word_[level] = static_cast<std::size_t>(found - columns_.begin());
  }
  sexes_ = {"Female", "Male"};
  const auto is_other = [](const AnsweringPerson& person) {
    return person.sex != "F" && person.sex != "M";
  };
  if (std::any_of(gathered.people.begin(), gathered.people.end(), is_other)) {
    sexes_.emplace_back(kOtherSex);
  }
  sexes_.emplace_back("Total");
  for (const AnsweringPerson& person : gathered.people) {
    sex_of_person_.push_back(person.sex == "F" ? 0 : person.sex == "M" ? 1 : 2);
  }
}

ChapterTally::ChapterTally(const GatheredAnswers& gathered)
    : cells_(gathered),
      by_cell_(cells_.columns().size() * cells_.sexes().size()),
      hits_(count_table(cells_.sexes(), cells_.columns())) {
  hits_.label_column = columns::kSex;
}

void ChapterTally::count(const ChapterAnswer& answer) {
  cells_.for_each(answer.column, answer.person, [&](std::size_t column, std::size_t sex) {
    by_cell_[column * cells_.sexes().size() + sex].count(answer.person, answer.hit, answer.outcomes,
                                                         answer.times);
    if (answer.hit) hits_.at(sex, column) += answer.times;
  });
}

void ChapterTally::add(const std::string& name, const Phrase& title, const Phrase& note,
                       AnalysisOutcome& outcome) const {
  CountTable counts = hits_;
  counts.name = name;
  counts.title = title;
  counts.note = note;
  add_counts(counts, outcome);
}

void ChapterTally::add_rows(ShareTable& shares) const {
  const std::size_t sexes = cells_.sexes().size();
  for (std::size_t column = 0; column < cells_.columns().size(); ++column) {
    for (std::size_t sex = 0; sex < sexes; ++sex) {
      shares.rows.push_back(
          {{cells_.columns()[column], cells_.sexes()[sex]}, by_cell_[column * sexes + sex]});
    }
  }
}

CountTable count_table(std::vector<std::string> labels, std::vector<std::string> columns) {
  CountTable counts{};
  counts.counts.resize(labels.size() * columns.size());
  counts.labels = std::move(labels);
  counts.columns = std::move(columns);
  return counts;
}

void add_counts(const CountTable& counts, AnalysisOutcome& outcome) {
  ResultTable made{counts.name, counts.title, {counts.label_column}, counts.note};
  for (const std::string& column : counts.columns) made.columns.push_back(of_repetition(column));
  for (std::size_t label = 0; label < counts.labels.size(); ++label) {
    ResultRow& cells = made.rows.emplace_back();
    cells.emplace_back(counts.labels[label]);
    for (std::size_t column = 0; column < counts.columns.size(); ++column) {
      cells.push_back(count_cell(counts.counts[label * counts.columns.size() + column]));
    }
  }
  outcome.tables.push_back(std::move(made));
}

std::size_t ConfusionTally::at(std::uint32_t felt, std::uint32_t answer) const {
  const auto found = counts_.find({felt, answer});
  return found == counts_.end() ? 0 : found->second;
}

ResultTable& ConfusionTally::add_table(const GatheredAnswers& gathered,
                                       const std::set<std::string>& options,
                                       AnalysisOutcome& outcome) const {
  std::map<std::string, std::uint32_t> felt_words{};
  std::set<std::string> names = options;
  for (const auto& [pair, times] : counts_) {
    felt_words.emplace(gathered.word(pair.first), pair.first);
    names.insert({gathered.word(pair.first), gathered.word(pair.second)});
  }
  const auto rank = [&](const std::string& name) {
    const std::vector<std::string>& pictures = gathered.pictures;
    return std::tuple(name == kCannotTell, !felt_words.contains(name),
                      std::find(pictures.begin(), pictures.end(), name) - pictures.begin());
  };
  std::vector<std::string> columns(names.begin(), names.end());
  std::stable_sort(columns.begin(), columns.end(),
                   [&rank](const auto& a, const auto& b) { return rank(a) < rank(b); });
  ResultTable made{"confusion",
                   phrase("Analysis", "Confusion matrix: stimulus (rows) and response (columns)"),
                   {asperity::columns::kFelt},
                   {}};
  for (const std::string& column : columns) {
    made.columns.push_back({.id = column, .heading = words_of_item(column)});
  }
  for (const std::string& felt : columns) {
    const auto word = felt_words.find(felt);
    if (word == felt_words.end()) continue;
    ResultRow& cells = made.rows.emplace_back();
    cells.emplace_back(felt);
    for (const std::string& column : columns) {
      const std::optional<std::uint32_t> answer = gathered.words.find(column);
      cells.push_back(count_cell(answer ? at(word->second, *answer) : 0));
    }
  }
  return outcome.tables.emplace_back(std::move(made));
}

void add_texture_force(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const bool is_matched =
      std::any_of(gathered.forces.begin(), gathered.forces.end(),
                  [](const auto& of_model) { return !of_model.second.matched_N.empty(); });
  ResultTable made{
      "texture_force",
      is_matched ? phrase("Analysis",
                          "Texture force (RMS) per model, as computed: intended on the prescribed "
                          "path, and achieved in the attempts")
                 : phrase("Analysis", "Texture force (RMS) per model, as computed in the attempts"),
      {kModel, kSurfaces, kMatchedMean, kAchievedMean, kAchievedSd, kAchievedMinimum,
       kAchievedMaximum},
      phrase("Analysis",
             "Equal RMS does not mean equal perceived intensity, which also depends on frequency. "
             "The force achieved depends on how the participant pressed and moved the handle.")};
  for (const auto& [model, forces] : gathered.forces) {
    ResultRow& cells = made.rows.emplace_back();
    cells.insert(cells.end(), {model, count_cell(forces.surfaces)});
    const std::optional<Summary> matched = summary_of(forces.matched_N);
    const std::optional<Summary> achieved = summary_of(forces.achieved_N);
    cells.push_back(matched ? ResultCell{matched->mean} : ResultCell{});
    if (achieved) {
      cells.insert(cells.end(),
                   {achieved->mean, achieved->n > 1 ? ResultCell{achieved->sd} : ResultCell{},
                    achieved->minimum, achieved->maximum});
    }
    cells.resize(made.columns.size());
    Finding finding{};
    finding.quantity = "achieved_texture_force_N";
    finding.key = "model=" + model;
    finding.unit = "N";
    finding.method = "mean over the surfaces presented";
    finding.n = forces.achieved_N.size();
    if (achieved) {
      finding.value = achieved->mean;
    } else {
      finding.status = "no surface was in contact for long enough";
    }
    outcome.findings.push_back(std::move(finding));
  }
  const bool measured =
      std::any_of(gathered.forces.begin(), gathered.forces.end(), [](const auto& of_model) {
        return !of_model.second.matched_N.empty() || !of_model.second.achieved_N.empty();
      });
  if (measured) outcome.tables.push_back(std::move(made));
}

void remark_on_pooling(std::size_t answers, std::size_t persons, AnalysisOutcome& outcome) {
  if (answers <= persons) return;
  const Phrase pooled =
      persons == 1
          ? phrase("Analysis",
                   "Proportions of all responses pool several trials of one participant (%1 in "
                   "total). The trials need not be independent: the CIs of these proportions may "
                   "be too narrow, and their p values too small.")
          : phrase("Analysis",
                   "Proportions of all responses pool several trials of the same participants (%1 "
                   "trials of %2 participants in total). The trials need not be independent: the "
                   "CIs of these proportions may be too narrow, and their p values too small. For "
                   "means over the participants, the participant is the unit of analysis.");
  outcome.remarks.push_back(pooled.with(std::to_string(answers), std::to_string(persons)));
}

}  // namespace asperity
