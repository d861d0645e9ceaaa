// Sets each assumption that the analysis of the study's responses estimates, with the study as its source.

#include "app/power/calibration.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/power/power_tables.h"
#include "app/study_files/study_condition.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

void take(const std::string& name, double value, const std::string& source,
          std::vector<Assumption>& assumptions) {
  const auto found = std::find_if(assumptions.begin(), assumptions.end(),
                                  [&name](const Assumption& each) { return each.name == name; });
  if (found == assumptions.end() || found->part == Assumption::Part::effect) return;
  const bool has_to_be_chosen = found->part == Assumption::Part::effect_sd && value == 0.0;
  if (has_to_be_chosen || !is_in_range(found->range, value)) return;
  found->value = value;
  found->source = source;
}

const char* text_of_group(AnswerGroup group) {
  switch (group) {
    case AnswerGroup::people:
      return "study ";
    case AnswerGroup::pilot:
      return "pilot ";
    case AnswerGroup::virtual_participants:
      return "simulated study ";
  }
  return "";
}

/// The responses of a group to this version of the protocol, or otherwise to the last one to which it responded: two versions would
/// give two values of one assumption.
std::vector<GatheredAnswers> of_one_version(const std::vector<GatheredAnswers>& all,
                                            AnswerGroup group, const std::string& version) {
  std::vector<GatheredAnswers> taken{};
  for (const GatheredAnswers& each : all) {
    if (each.group != group) continue;
    if (!taken.empty() && taken.front().version != each.version) {
      if (taken.front().version == version) continue;
      taken.clear();
    }
    taken.push_back(each);
  }
  return taken;
}

/// "pilot study-a, 8 participants"; with the version of the protocol where that is another one.
std::string source_of(const Study& study, const std::vector<GatheredAnswers>& taken,
                      const std::string& version) {
  const GatheredAnswers& first = taken.front();
  std::string source = text_of_group(first.group) +
                       std::filesystem::weakly_canonical(study.folder()).filename().string();
  if (first.version != version) source += ", version " + first.version + " of the protocol";
  return source + ", " + counted(first.count.participants, "participant", "participants");
}

}  // namespace

std::vector<Assumption> calibrated(std::vector<Assumption> assumptions, const Protocol& protocol,
                                   std::span<const GatheredAnswers> of_study,
                                   const std::string& source) {
  for (const auto& [name, block] : tabulated_blocks(protocol)) {
    for (const TabulatedBlock::OfQuestion& question : block.questions) {
      const ExperimentKind& kind =
          *kind_of_question(kind_of(question.asked.block), question.asked.question);
      const StudyAnalysis* const analysis = find_analysis(kind.id);
      if (analysis == nullptr || analysis->shown_parameters == nullptr) continue;
      for (const GatheredAnswers& gathered : of_study) {
        if (gathered.kind != kind.id) continue;
        for (const auto& [parameter, value] :
             analysis->shown_parameters(gathered, question.asked)) {
          take(assumption_name(question.asked, parameter), value, source, assumptions);
        }
      }
    }
  }
  return assumptions;
}

std::vector<Assumption> calibrated_by_study(std::vector<Assumption> assumptions,
                                            const Protocol& protocol, const Study& study) {
  std::vector<GatheredAnswers> all{};
  read_unless_broken(study, [&] { all = gather_answers(study, protocol.name, {}); }, {});
  std::erase_if(all, [](const GatheredAnswers& each) { return each.answers.empty(); });
  for (const AnswerGroup group :
       {AnswerGroup::pilot, AnswerGroup::people, AnswerGroup::virtual_participants}) {
    const std::vector<GatheredAnswers> taken = of_one_version(all, group, protocol.version);
    if (taken.empty()) continue;
    return calibrated(std::move(assumptions), protocol, taken,
                      source_of(study, taken, protocol.version));
  }
  throw std::runtime_error("the study " + study.folder().string() +
                           " has no responses to the protocol \"" + protocol.name +
                           "\" from which assumptions could be taken; state a "
                           "study in which this protocol was run, piloted or simulated");
}

}  // namespace asperity
