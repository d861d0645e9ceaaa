#include "app/power/calibration.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "app/findings/study/study_analysis.h"
#include "app/power/power_tables.h"
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

}  // namespace

std::vector<Assumption> calibrated(std::vector<Assumption> assumptions, const Protocol& protocol,
                                   std::span<const GatheredAnswers> of_study,
                                   const std::string& source) {
  for (const auto& [name, block] : tabulated_blocks(protocol)) {
    for (const TabulatedBlock::OfQuestion& question : block.questions) {
      const ExperimentKind& kind =
          *kind_of_question(kind_of(question.asked.block), question.asked.question.form);
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
                                            const Protocol& protocol,
                                            const std::filesystem::path& study) {
  const Study opened = Study::open(study, Access::read_only);
  std::vector<GatheredAnswers> all = gather_answers(opened, protocol.name, {});
  std::erase_if(all, [](const GatheredAnswers& each) { return each.answers.empty(); });
  for (const AnswerGroup group :
       {AnswerGroup::pilot, AnswerGroup::people, AnswerGroup::virtual_participants}) {
    std::vector<GatheredAnswers> of_group{};
    std::copy_if(all.begin(), all.end(), std::back_inserter(of_group),
                 [group](const GatheredAnswers& each) { return each.group == group; });
    if (of_group.empty()) continue;
    const std::string source = text_of_group(group) + study.filename().string() + ", " +
                               std::to_string(of_group.front().count.participants) +
                               " participants";
    return calibrated(std::move(assumptions), protocol, of_group, source);
  }
  throw std::runtime_error("the study " + study.string() + " has no responses to the protocol \"" +
                           protocol.name +
                           "\" from which assumptions could be taken; state a "
                           "study in which this protocol was run, piloted or simulated");
}

}  // namespace asperity
