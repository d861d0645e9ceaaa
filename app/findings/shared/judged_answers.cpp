// Represents the responses of a recognition as correct and incorrect ones.

#include "app/findings/shared/judged_answers.h"

#include <algorithm>
#include <map>
#include <utility>

#include "app/findings/gathering/answer_columns.h"
#include "app/findings/outcome/tally.h"

namespace asperity {

namespace {

std::vector<std::set<std::string>> pictures_of(const GatheredAnswers& gathered) {
  std::vector<std::set<std::string>> pictures{};
  for (const std::vector<std::string>& options : gathered.option_lists) {
    pictures.emplace_back(options.begin(), options.end()).erase(std::string(kCannotTell));
  }
  return pictures;
}

}  // namespace

std::vector<JudgedAnswer> judged_answers(const GatheredAnswers& gathered,
                                         AnalysisOutcome& outcome) {
  std::vector<JudgedAnswer> judged{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const GatheredReply& reply = gathered.reply_of(answer);
    if (!reply.correct || answer.surface_count == 0) continue;
    judged.push_back({&answer, gathered.surfaces_of(answer)[0].item, reply.answer, *reply.correct});
  }
  const std::size_t left_out = gathered.answers.size() - judged.size();
  if (left_out > 0) {
    outcome.remarks.push_back(
        phrase("Analysis", "Responses in trials without a declared correct response, left out: %1.")
            .with(std::to_string(left_out)));
  }
  return judged;
}

RecognitionPictures pictures_in(const GatheredAnswers& gathered,
                                const std::vector<JudgedAnswer>& judged) {
  RecognitionPictures pictures{.of_list = pictures_of(gathered)};
  std::set<std::uint32_t> lists{};
  std::set<std::uint32_t> felt{};
  for (const JudgedAnswer& one : judged) {
    lists.insert(one.answer->options);
    felt.insert(one.felt);
  }
  for (const std::uint32_t list : lists) {
    const std::set<std::string>& own = pictures.of_list[list];
    pictures.always_the_same = pictures.always_the_same && own == pictures.of_list[*lists.begin()];
    pictures.all.insert(own.begin(), own.end());
  }
  for (const std::uint32_t word : felt) pictures.felt.push_back(gathered.word(word));
  std::sort(pictures.felt.begin(), pictures.felt.end());
  return pictures;
}

std::vector<HitCount> responses_of_people(const GatheredAnswers& gathered,
                                          const std::vector<JudgedAnswer>& judged) {
  std::vector<HitCount> own(gathered.people.size());
  for (const JudgedAnswer& one : judged) {
    ++own[one.answer->person].trials;
    own[one.answer->person].hits += one.right ? 1 : 0;
  }
  return own;
}

TidyInput judged_trials_table(const GatheredAnswers& gathered,
                              const std::vector<JudgedAnswer>& judged,
                              const std::vector<std::string>& labels) {
  std::vector<std::size_t> label_of(gathered.words.size(), LabelColumn::kMissing);
  for (std::size_t word = 0; word < label_of.size(); ++word) {
    const auto found = std::lower_bound(labels.begin(), labels.end(),
                                        gathered.word(static_cast<std::uint32_t>(word)));
    if (found != labels.end() && *found == gathered.word(static_cast<std::uint32_t>(word))) {
      label_of[word] = static_cast<std::size_t>(found - labels.begin());
    }
  }
  LabelColumn people = labels_of_people(gathered);
  LabelColumn felt{.names = labels};
  LabelColumn chosen{.names = labels};
  for (const JudgedAnswer& one : judged) {
    people.codes.push_back(one.answer->person);
    felt.codes.push_back(label_of[one.felt]);
    chosen.codes.push_back(label_of[one.chosen]);
  }
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"subject", std::move(people)},
                                                           {"stimulus", std::move(felt)},
                                                           {"response", std::move(chosen)}},
                            "the answers");
  input.options.set("labels", labels);
  return input;
}

TidyInput judged_textures_table(const GatheredAnswers& gathered,
                                const std::vector<JudgedAnswer>& judged, std::size_t pictures) {
  std::map<std::string, HitCount> by_texture{};
  for (const JudgedAnswer& one : judged) {
    HitCount& count = by_texture[gathered.word(one.felt)];
    ++count.trials;
    count.hits += one.right ? 1 : 0;
  }
  LabelRows ids{};
  NumberColumn hits{};
  NumberColumn trials{};
  const NumberColumn chances(by_texture.size(), 1.0 / static_cast<double>(pictures));
  for (const auto& [texture, count] : by_texture) {
    ids.add(texture);
    hits.push_back(static_cast<double>(count.hits));
    trials.push_back(static_cast<double>(count.trials));
  }
  TidyInput input{};
  input.tables.emplace_back(std::vector<TidyTable::Column>{{"id", std::move(ids).take()},
                                                           {"k", std::move(hits)},
                                                           {"n", std::move(trials)},
                                                           {"p0", chances}},
                            "the textures");
  return input;
}

}  // namespace asperity
