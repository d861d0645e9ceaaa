// Analyses a made-up study in memory, and keeps outcomes by name for several tests.

#include "tests/app/analysed_study.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

namespace asperity {

namespace {

template <class Part>
const Part* find_named(const std::vector<Part>& parts, const std::string& name) {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&name](const Part& each) { return each.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

}  // namespace

void add_participants(MadeUpStudy& made, std::int64_t protocol, const MadeUpParticipants& people,
                      const TrialsOfParticipant& trials_of) {
  for (int i = 0; i < people.number; ++i) {
    const std::string label = "p" + std::to_string(people.first + i);
    made.add_person(label, !people.of_both ? people.sex : i < people.number / 2 ? "F" : "M");
    made.add_session(label, protocol, trials_of(i));
  }
}

AnalysisOutcome analysed(const std::string& kind, const std::string& source,
                         const MadeUpParticipants& people, const TrialsOfParticipant& trials_of) {
  MadeUpStudy made;
  add_participants(made, made.add_protocol("made_up", kind, source), people, trials_of);
  for (AnalysisOutcome& outcome : analyze_study(made.study())) {
    if (outcome.kind == kind) return std::move(outcome);
  }
  throw std::runtime_error("there is no analysis of the kind " + kind);
}

AnalysisOutcome analysed(const std::string& kind, const std::string& source,
                         MadeUpParticipants people,
                         const std::vector<std::vector<MadeUpTrial>>& by_person) {
  people.number = static_cast<int>(by_person.size());
  return analysed(kind, source, people, [&by_person](int person) {
    return by_person.at(static_cast<std::size_t>(person));
  });
}

const AnalysisOutcome& outcome_once(const std::string& key,
                                    const std::function<AnalysisOutcome()>& make) {
  static std::map<std::string, AnalysisOutcome> kOutcomes{};
  const auto known = kOutcomes.find(key);
  return known != kOutcomes.end() ? known->second : kOutcomes.emplace(key, make()).first->second;
}

const StoredTable* find_table(const AnalysisOutcome& outcome, const std::string& name) {
  static std::deque<StoredTable> kRead{};
  const ResultTable* const found = find_named(outcome.tables, name);
  return found == nullptr ? nullptr : &kRead.emplace_back(stored(*found));
}

const StoredTable& table_of(const AnalysisOutcome& outcome, const std::string& name) {
  const StoredTable* const found = find_table(outcome, name);
  if (found == nullptr) throw std::runtime_error("there is no table " + name);
  return *found;
}

Table shown_table(const AnalysisOutcome& outcome, const std::string& name) {
  const ResultTable* const found = find_named(outcome.tables, name);
  if (found == nullptr) throw std::runtime_error("there is no table " + name);
  return shown_table(*found);
}

const AnsweredQuestion* find_question(const AnalysisOutcome& outcome, const std::string& name) {
  return find_named(outcome.questions, name);
}

const AnsweredQuestion& question_of(const AnalysisOutcome& outcome, const std::string& name) {
  const AnsweredQuestion* const found = find_question(outcome, name);
  if (found == nullptr) throw std::runtime_error("there is no question " + name);
  return *found;
}

std::string answer_to(const AnalysisOutcome& outcome, const std::string& name) {
  const AnsweredQuestion* const found = find_question(outcome, name);
  return found == nullptr ? std::string() : found->answer.english();
}

const Finding& finding_of(const AnalysisOutcome& outcome, const std::string& analysis,
                          const std::string& quantity, const std::string& key) {
  for (const Finding& each : outcome.findings) {
    if (each.analysis == analysis && each.quantity == quantity && each.key == key) return each;
  }
  throw std::runtime_error("there is no finding " + quantity + ' ' + key);
}

std::vector<Finding> part_of(const AnalysisOutcome& outcome, const std::string& analysis) {
  std::vector<Finding> part{};
  std::copy_if(outcome.findings.begin(), outcome.findings.end(), std::back_inserter(part),
               [&](const Finding& each) { return each.analysis == analysis; });
  return part;
}

std::string sentence_about(const AnalysisOutcome& outcome, const std::string& test,
                           const TestSubject& about) {
  for (const TestSentence& each : outcome.test_sentences) {
    if (each.test == test && (about.empty() || each.about == about)) return each.text;
  }
  return {};
}

std::string remarks_of(const AnalysisOutcome& outcome) {
  std::string all{};
  for (const Phrase& remark : outcome.remarks) all += remark.english() + '\n';
  return all;
}

}  // namespace asperity
