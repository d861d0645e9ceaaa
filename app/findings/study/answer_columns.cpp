#include "app/findings/study/answer_columns.h"

#include "analysis/number_text.h"

namespace asperity {

LabelColumn column_of_people(const GatheredAnswers& gathered) {
  LabelColumn people{};
  for (const AnsweringPerson& person : gathered.people) people.names.push_back(person.label);
  for (const GatheredAnswer& answer : gathered.answers) people.codes.push_back(answer.person);
  return people;
}

LabelColumn column_of_times(const GatheredAnswers& gathered) {
  LabelColumn times{};
  for (const GatheredAnswer& answer : gathered.answers) {
    times.codes.push_back(answer.response_time_s ? times.names.size() : LabelColumn::kMissing);
    if (answer.response_time_s) times.names.push_back(number_text(*answer.response_time_s));
  }
  return times;
}

}  // namespace asperity
