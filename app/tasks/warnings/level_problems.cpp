// Compares levels after rounding to 12 significant digits, and finds levels that scale a flat relief.

#include "app/tasks/warnings/level_problems.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "results_schema/tables/table.h"

namespace asperity {
namespace {

std::string place_of_levels(const std::string& block, const Dimension& dimension) {
  const std::string levels =
      pointer_to("/blocks", block) + "/vary/" + std::string(key_of(dimension.measure));
  return dimension.grid ? levels + "/step" : levels;
}

/// Whether the parameter is a factor of the heights, or of the slopes, of the file.
bool scales_file(const ForceModel& model, const Dimension& dimension) {
  return model.declaration.needs_height_field &&
         model.declaration.amplitude_parameter == dimension.parameter;
}

}  // namespace

std::vector<Diagnostic> problems_of_values(const Protocol& protocol, const std::string& file_name) {
  const JsonDocument document(protocol.source, file_name);
  std::vector<Diagnostic> problems{};
  for (const auto& [name, block] : protocol.blocks) {
    if (!block.vary || !has_levels(*block.vary)) continue;
    const Dimension& dimension = *block.vary;
    const std::vector<double> values = dimension.values();
    const auto equal = std::adjacent_find(values.begin(), values.end());
    if (equal == values.end()) continue;
    const std::vector<double> levels = dimension.levels();
    const auto first = static_cast<std::size_t>(equal - values.begin());
    const Phrase sentence =
        dimension.grid ? phrase("Protocols",
                                "the levels %1 and %2 are the same value of %3, %4, because values "
                                "have 12 significant digits; use a larger step")
                       : phrase("Protocols",
                                "the levels %1 and %2 are the same value of %3, %4, because values "
                                "have 12 significant digits; leave one of them out");
    problems.push_back(
        document.at(place_of_levels(name, dimension),
                    sentence.with(text_of_number(levels[first]), text_of_number(levels[first + 1]),
                                  in_quotes(dimension.parameter), text_of_number(*equal))));
  }
  return problems;
}

std::vector<Diagnostic> problems_of_scaled_heights(const CheckedProtocol& checked,
                                                   StimulusBuilder& builder) {
  const Protocol& protocol = checked.protocol;
  const JsonDocument document(protocol.source, checked.file_name);
  std::vector<Diagnostic> problems{};
  std::set<std::pair<std::string, std::string>> looked_at{};  // blocks and files
  for (const Trial& trial : checked.trials()) {
    const auto block = protocol.blocks.find(trial.block);
    if (block == protocol.blocks.end() || !block->second.vary) continue;
    const Dimension& dimension = *block->second.vary;
    for (const PlannedPresentation& planned : trial.presentations) {
      const StimulusDescription& stimulus = planned.stimulus;
      const ForceModel* const model = builder.models().find(stimulus.model);
      if (planned.role != dimension.role || !stimulus.height_field || model == nullptr ||
          !scales_file(*model, dimension) ||
          !looked_at.emplace(trial.block, *stimulus.height_field).second) {
        continue;
      }
      const LoadedHeightField loaded = builder.height_field(*stimulus.height_field);
      if (loaded.field->maximum_m() > loaded.field->minimum_m()) continue;
      problems.push_back(document.at(
          pointer_to("/blocks", trial.block) + "/vary/parameter",
          phrase("Protocols",
                 "all heights of %1 are the same, so that the surface has no texture at any level "
                 "of %2; use a height field with a texture, or vary another parameter")
              .with(*stimulus.height_field, in_quotes(dimension.parameter))));
    }
  }
  return problems;
}

}  // namespace asperity
