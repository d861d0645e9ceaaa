// Counts responses by participant, condition and level, and states why there are none.

#include "app/exports/fit_table.h"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "app/exports/columns/column_making.h"
#include "app/exports/detection_table.h"
#include "app/findings/gathering/gathered_answers.h"
#include "results_schema/analysis_use.h"
#include "results_schema/tables/table_file.h"

namespace asperity {

using namespace export_columns;

namespace {

constexpr const char* kCorrect = "correct";

std::string factor_level_text(const nlohmann::json& level) {
  return level.is_string() ? level.get<std::string>() : level.dump();
}

}  // namespace

bool is_counted_for_fits(const ExportPlace& at) {
  return at.session->state == SessionState::completed && !at.response->answer_number &&
         at.response->source != kNotAsked &&
         use_in_analyses(*at.trial, *at.attempt) == AnalysisUse::counted;
}

std::string levels_text_of_factors(const nlohmann::json& factors,
                                   const std::vector<std::string>& without) {
  std::string text{};
  for (const auto& [name, level] : factors.items()) {
    if (name == kColumnFactor) continue;
    if (std::find(without.begin(), without.end(), name) != without.end()) continue;
    text += (text.empty() ? "" : ", ") + name + " = " + factor_level_text(level);
  }
  return text;
}

Columns FitTable::columns() const {
  Columns columns{};
  const auto add = [&columns](const char* name, const char* type, const char* description) {
    columns.push_back(column(name, type, "", description, {}));
  };
  add("condition", "text",
      "data of one psychometric function: participant, protocol, question, counted responses, and "
      "the levels of all factors except x and column (the repetition)");
  add("x", "number", "level of the numeric factor named in the column factor, in its unit");
  add("k", "integer",
      "responses at this level that are counted (see the column counted), in completed sessions; "
      "the other sessions contain only some of the conditions");
  add("n", "integer", "responses at this level, in completed sessions");
  add("unsure", "integer",
      "responses \"cannot tell\" of a discrimination among n; none of them is in k, and each "
      "counts "
      "as 1/m of a counted response when a function is fitted");
  columns.push_back(missing("not a discrimination", column("m", "integer", "",
                                                           "number of surfaces of which one is "
                                                           "chosen",
                                                           {})));
  add("participant", "text", "label of the participant");
  add("protocol", "text", "name of the protocol");
  add("protocol_version", "text", "version of the protocol");
  add("question", "text", "name of the question");
  add("factor", "text", "name of the numeric factor; x is its level");
  add("counted", "text", "responses counted in k: the correct ones, or those with this value");
  if (vocabulary_.known_languages.size() > 1) {
    add("language", "text", "language of the texts for the participant, a BCP 47 tag");
  }
  columns[2].minimum = 0.0;
  columns[3].minimum = 1.0;
  columns[4].minimum = 0.0;
  return columns;
}

void FitTable::add(const ExportPlace& at) {
  if (!is_counted_for_fits(at)) return;
  const ResponseRow& response = *at.response;
  // Neither a text nor several options is an event with a probability.
  if (vocabulary_.is_free_text(response.question) ||
      vocabulary_.has_several_answers(response.question)) {
    return;
  }
  has_choices_ = true;
  const auto* const discrimination = discrimination_of(vocabulary_, at);
  const DiscriminationDesign* const design =
      discrimination == nullptr ? nullptr : discrimination->task.design;
  if (design != nullptr && design->has_noise()) {
    has_detections_ = true;
    return;
  }
  for (const auto& [name, level] : at.factors->items()) {
    if (!level.is_number() || name == kColumnFactor) continue;
    Levels& levels = curves_[{at.participant->label, at.protocol->name, at.protocol->version,
                              at.protocol->source_sha256, response.question, name,
                              levels_text_of_factors(*at.factors, {name})}];
    Count& count = levels.counts[level.get<double>()];
    if (design != nullptr) {
      levels.alternatives = design->alternatives();
      if (response.answer == kCannotTell) {
        ++count.unsure;
        continue;
      }
    }
    ++count.responses;
    ++count.chosen[response.answer];
    if (response.correct) {
      ++count.judged;
      count.correct += *response.correct ? 1 : 0;
    }
  }
}

std::optional<Phrase> FitTable::why_empty(const std::string& name) const {
  if (!has_choices_) {
    return phrase("FitTable",
                  "%1 was not written: no completed session has choices that count in analyses. "
                  "Complete a session, then export again.")
        .with(name);
  }
  if (curves_.empty() && has_detections_) {
    return phrase("FitTable",
                  "%1 was not written: the responses are those of yes/no or same–different tasks, "
                  "whose hits and false alarms are in detection.tsv.")
        .with(name);
  }
  if (curves_.empty()) {
    return phrase("FitTable",
                  "%1 was not written: no factor of the trials has numeric levels (those of the "
                  "factor column are repetitions). Use the other tables, or vary a factor with "
                  "numeric levels.")
        .with(name);
  }
  if (std::none_of(curves_.begin(), curves_.end(),
                   [](const auto& curve) { return curve.second.counts.size() > 1; })) {
    return phrase("FitTable",
                  "%1 was not written: no participant has choices at two levels of a numeric "
                  "factor. Complete more trials, then export again.")
        .with(name);
  }
  return {};
}

void FitTable::write(ExportFolder& folder, const std::string& name) const {
  TableFile file(folder.path_of(name), TableFile::Format::tsv, column_names(columns()));
  for (const auto& [curve, levels] : curves_) {
    if (levels.counts.size() < 2) continue;
    std::set<std::string> counted{};
    bool is_judged = false;
    for (const auto& [x, count] : levels.counts) {
      is_judged = is_judged || count.judged > 0;
      for (const auto& [answer, times] : count.chosen) counted.insert(answer);
    }
    if (is_judged) counted = {kCorrect};
    for (const std::string& what : counted) {
      const std::string condition = curve.participant + ": " + curve.protocol + ' ' +
                                    curve.version + ", " + curve.question + ", " + what +
                                    (curve.others.empty() ? "" : ", " + curve.others);
      for (const auto& [x, count] : levels.counts) {
        const auto chosen = count.chosen.find(what);
        const std::int64_t k = is_judged                      ? count.correct
                               : chosen == count.chosen.end() ? 0
                                                              : chosen->second;
        const std::int64_t n = (is_judged ? count.judged : count.responses) + count.unsure;
        std::vector<Cell> row{condition,
                              x,
                              k,
                              n,
                              count.unsure,
                              levels.alternatives == 0
                                  ? Cell{}
                                  : Cell{static_cast<std::int64_t>(levels.alternatives)},
                              curve.participant,
                              curve.protocol,
                              curve.version,
                              curve.question,
                              curve.factor,
                              what};
        if (vocabulary_.known_languages.size() > 1) {
          row.emplace_back(vocabulary_.languages.at(curve.source_sha256));
        }
        file.add(row);
      }
    }
  }
  folder.add(name, file.finish());
}

}  // namespace asperity
