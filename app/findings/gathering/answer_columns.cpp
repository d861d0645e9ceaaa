// Assigns codes to names in the order of their first occurrence; an empty name is a missing label.

#include "app/findings/gathering/answer_columns.h"

namespace asperity {

LabelColumn labels_of_people(const GatheredAnswers& gathered) {
  LabelColumn people{};
  for (const AnsweringPerson& person : gathered.people) people.names.push_back(person.label);
  return people;
}

LabelColumn column_of_people(const GatheredAnswers& gathered) {
  LabelColumn people = labels_of_people(gathered);
  for (const GatheredAnswer& answer : gathered.answers) people.codes.push_back(answer.person);
  return people;
}

NumberColumn column_of_times(const GatheredAnswers& gathered) {
  NumberColumn times{};
  for (const GatheredAnswer& answer : gathered.answers) times.push_back(answer.response_time_s);
  return times;
}

void LabelRows::add(const std::string& name) {
  if (name.empty()) {
    column_.codes.push_back(LabelColumn::kMissing);
    return;
  }
  const auto [found, is_new] = code_of_.try_emplace(name, column_.names.size());
  if (is_new) column_.names.push_back(name);
  column_.codes.push_back(found->second);
}

void ScoreRows::add(std::size_t person, const std::string& item, double score) {
  people_.codes.push_back(person);
  items_.add(item);
  scores_.push_back(score);
}

TidyInput ScoreRows::take(const char* rater, const char* rated, const std::string& about,
                          const char* score) && {
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{rater, std::move(people_)},
                                                           {rated, std::move(items_).take()},
                                                           {score, std::move(scores_)}},
                            about);
  return input;
}

}  // namespace asperity
