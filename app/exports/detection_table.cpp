// Counts hits and false alarms while attempts are added, and writes the rows at the end.

#include "app/exports/detection_table.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/exports/columns/column_making.h"
#include "app/exports/fit_table.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/methods/discrimination/sensitivity/discrimination_sensitivity.h"
#include "results_schema/tables/table.h"
#include "results_schema/tables/table_file.h"

namespace asperity {

using namespace export_columns;

const StudyVocabulary::BlockOfDiscrimination* discrimination_of(const StudyVocabulary& vocabulary,
                                                                const ExportPlace& at) {
  const auto block = vocabulary.discriminations.find({at.protocol->source_sha256, at.trial->block});
  if (block == vocabulary.discriminations.end()) return nullptr;
  return block->second.task.question == at.response->question ? &block->second : nullptr;
}

std::size_t comparisons_in(const AttemptRow& attempt) {
  return static_cast<std::size_t>(
      std::count_if(attempt.presentations.begin(), attempt.presentations.end(),
                    [](const PresentationRow& surface) { return surface.role == "comparison"; }));
}

Columns DetectionTable::columns() {
  Columns columns{};
  const auto add = [&columns](const char* name, const char* type, const char* description) {
    columns.push_back(column(name, type, "", description, {}));
  };
  add("id", "text",
      "protocol, question, level of the comparison, and the levels of all other factors that are "
      "not drawn for every trial");
  add("subject", "text", "label of the participant");
  add("design", "text",
      "yesno (response \"yes\" or \"no\") or samediff (response \"same\" or \"different\")");
  add("signal_yes", "integer",
      "hits: responses \"yes\" to the comparison at this level, or \"different\" to different "
      "surfaces, in completed sessions");
  add("signal_n", "integer", "trials with a signal at this level, in completed sessions");
  add("noise_yes", "integer",
      "false alarms: responses \"yes\" to the standard, or \"different\" to equal surfaces, in "
      "completed sessions; those of all levels together, and therefore the same in the rows of all "
      "levels");
  add("noise_n", "integer", "trials without a signal, of all levels together");
  add("level", "number", "level of the comparison, in the unit of the factor");
  add("standard", "number", "value of the same parameter in the standard");
  add("factor", "text", "name of the factor that is varied");
  add("protocol", "text", "name of the protocol");
  add("protocol_version", "text", "version of the protocol");
  add("question", "text", "name of the question");
  for (ExportColumn& each : columns) {
    if (each.type == "integer") each.minimum = 0.0;
  }
  return columns;
}

void DetectionTable::add(const ExportPlace& at) {
  if (!is_counted_for_fits(at)) return;
  const auto* const block = discrimination_of(vocabulary_, at);
  if (block == nullptr || !block->task.design->has_noise()) return;
  const DiscriminationTask& task = block->task;
  const auto level = at.factors->find(task.varied.factor);
  if (level == at.factors->end() || !level->is_number()) return;
  std::vector<std::string> without = block->drawn;
  without.push_back(task.varied.factor);
  Counts& counts =
      tasks_[{at.participant->label, at.protocol->name, at.protocol->version,
              at.protocol->source_sha256, task.question, std::string(name_in_family(*task.design)),
              task.varied.factor, levels_text_of_factors(*at.factors, without)}];
  counts.standard = task.standard();
  const std::size_t comparisons = comparisons_in(*at.attempt);
  Count& count =
      task.design->is_signal(comparisons) ? counts.signal[level->get<double>()] : counts.noise;
  ++count.trials;
  count.yes += is_hit_response(task, comparisons, at.response->answer) ? 1 : 0;
}

bool DetectionTable::is_empty() const noexcept {
  return std::none_of(tasks_.begin(), tasks_.end(), [](const auto& each) {
    return each.second.noise.trials > 0 && !each.second.signal.empty();
  });
}

void DetectionTable::write(ExportFolder& folder, const std::string& name) const {
  TableFile file(folder.path_of(name), TableFile::Format::tsv, column_names(columns()));
  for (const auto& [task, counts] : tasks_) {
    if (counts.noise.trials == 0) continue;
    for (const auto& [level, signal] : counts.signal) {
      const std::string id = task.protocol + ' ' + task.version + ", " + task.question + ", " +
                             task.factor + " = " + text_of_number(level) +
                             (task.others.empty() ? "" : ", " + task.others);
      file.add({id, task.participant, task.design, signal.yes, signal.trials, counts.noise.yes,
                counts.noise.trials, level, counts.standard, task.factor, task.protocol,
                task.version, task.question});
    }
  }
  folder.add(name, file.finish());
}

}  // namespace asperity
