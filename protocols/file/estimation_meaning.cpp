// Whether the numbers of a magnitude can be analysed by spacing and condition.

#include <algorithm>

#include "protocols/file/meaning_checks.h"

namespace asperity {

using Block = Protocol::Block;
using Run = Protocol::Run;

void Meaning::check_spacings(const std::string& factor) {
  const std::vector<Level>& levels = protocol_.factors.at(factor).levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::string place = pointer_to(pointer_to("/factors", factor) + "/levels", i);
    if (const double* const spacing_m = std::get_if<double>(&levels[i])) {
      if (*spacing_m <= 0.0) report(place, "a spacing has to be above 0");
      continue;
    }
    const auto texture = protocol_.textures.find(text_of(levels[i]));
    if (texture == protocol_.textures.end()) {
      report(place, in_quotes(text_of(levels[i])) +
                        " is used as a spacing but is neither a number nor a texture");
    } else if (!texture->second.spacing_m) {
      report(pointer_to("/textures", texture->first),
             "estimates are analysed by the spacing of this texture: give it a \"spacing_m\"");
    }
  }
  std::set<double> spacings{};
  for (const auto& [level, spacing_m] : protocol_.estimation->spacing_m) spacings.insert(spacing_m);
  constexpr std::size_t kCoefficients = 3;  // of a parabola
  if (spacings.size() < kCoefficients) {
    report(pointer_to("/factors", factor) + "/levels",
           "a curve needs at least three different spacings, but there are " +
               std::to_string(spacings.size()));
  }
}

void Meaning::check_estimation() {
  if (!protocol_.estimation || protocol_.kind != ProtocolKind::magnitude) return;
  const EstimationDeclaration& estimation = *protocol_.estimation;
  const auto is_known = [&](const std::string& factor, const char* key) {
    if (factor.empty() || protocol_.factors.contains(factor)) return !factor.empty();
    report(std::string("/estimation/") + key, unknown("factor", factor, protocol_.factors));
    return false;
  };
  const bool has_spacing = is_known(estimation.spacing, "spacing");
  const bool has_condition = is_known(estimation.condition, "condition");
  if (has_spacing) check_spacings(estimation.spacing);
  if (estimation.condition == estimation.spacing) {
    report("/estimation/condition", "spacing and condition are the same factor; name another one");
    return;
  }
  for (const auto& [name, block] : protocol_.blocks) {
    if (block.phase != Phase::main) continue;
    const std::string pointer = pointer_to("/blocks", name);
    const auto within = [&block = block](const std::string& factor) {
      return std::find(block.crossed.begin(), block.crossed.end(), factor) != block.crossed.end() ||
             std::any_of(block.listed.begin(), block.listed.end(),
                         [&](const auto& row) { return row.contains(factor); });
    };
    if (has_spacing && !within(estimation.spacing)) {
      report(pointer, "a main block has to cross or list the spacings, the factor " +
                          in_quotes(estimation.spacing));
    }
    if (!has_condition) continue;
    std::set<Level> held{};
    for (const auto& row : block.listed) {
      const auto level = row.find(estimation.condition);
      if (level != row.end()) held.insert(level->second);
    }
    const bool varies = held.size() > 1 ||
                        std::find(block.crossed.begin(), block.crossed.end(),
                                  estimation.condition) != block.crossed.end() ||
                        std::find(block.drawn.begin(), block.drawn.end(), estimation.condition) !=
                            block.drawn.end();
    if (varies) {
      report(pointer,
             "the condition must be constant within a block: run this block for_each level of " +
                 in_quotes(estimation.condition) + " instead of mixing them");
      continue;
    }
    for (const Run* const run : runs_of(block)) {
      if (factors_set_by(block, run).contains(estimation.condition)) continue;
      report(pointer, "nothing sets the condition " + in_quotes(estimation.condition) +
                          " in this main block: run it for_each of its levels");
    }
  }
}

}  // namespace asperity
