// Joins the warnings that levels of a parameter, or other stimuli, have in common.

#include "app/session/rehearsal/warned_levels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "app/study_files/parameter_json.h"
#include "app/words/phrase_registry.h"
#include "app/words/text_parts.h"

namespace asperity {
namespace {

constexpr std::size_t kListedLevels = 8;

/// How far the device falls short: of two positive numbers their ratio, whichever is greater.
double shortfall(const RehearsalWarning& warning) {
  if (!(warning.asked > 0.0) || !(warning.device > 0.0)) return 0.0;
  return std::abs(std::log(warning.asked / warning.device));
}

std::string english_without(const std::string& name, const Phrase& text) {
  const std::string quoted = '"' + name + '"';
  std::string english = text.english();
  for (std::size_t at = english.find(quoted); at != std::string::npos; at = english.find(quoted)) {
    english.erase(at, quoted.size());
  }
  return english;
}

bool has_same_words(const RehearsalWarning& one, const RehearsalWarning& other) {
  return english_without(one.stimulus, one.text) == english_without(other.stimulus, other.text);
}

/// The levels of a parameter in all blocks that vary it.
std::vector<double> all_levels(const Protocol& protocol, const std::string& parameter) {
  std::vector<double> all{};
  for (const auto& [name, block] : protocol.blocks) {
    if (!block.vary || block.vary->parameter != parameter) continue;
    const std::vector<double> values = block.vary->values();
    all.insert(all.end(), values.begin(), values.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Warnings that differ only in the level of a parameter; or a single one.
struct LevelGroup {
  std::vector<RehearsalWarning> warnings{};

  const RehearsalWarning& worst() const {
    return *std::max_element(warnings.begin(), warnings.end(),
                             [](const RehearsalWarning& one, const RehearsalWarning& other) {
                               return shortfall(one) < shortfall(other);
                             });
  }
  bool is_alike() const {
    return std::all_of(warnings.begin(), warnings.end(), [this](const RehearsalWarning& one) {
      return has_same_words(one, warnings.front());
    });
  }
  std::vector<double> levels() const {
    std::vector<double> levels{};
    for (const RehearsalWarning& one : warnings) {
      if (one.level) levels.push_back(one.level->value);
    }
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    return levels;
  }
};

/// "2 levels of amplitude_m (0.001, 0.002)", or "(0.001 to 0.054)" for many levels without a gap.
Phrase levels_text(const LevelGroup& group, const Protocol& protocol) {
  const std::string& parameter = group.worst().level->parameter;
  const std::vector<double> levels = group.levels();
  const std::vector<double> all = all_levels(protocol, parameter);
  const auto text = [](double level) { return text_of(Level(level)); };
  const auto within = std::count_if(all.begin(), all.end(), [&](double value) {
    return value >= levels.front() && value <= levels.back();
  });
  std::string listed{};
  if (levels.size() > kListedLevels && static_cast<std::size_t>(within) <= levels.size()) {
    listed = text(levels.front()) + " to " + text(levels.back());
  } else {
    std::vector<std::string> texts{};
    for (const double level : levels) texts.push_back(text(level));
    listed = comma_separated(texts);
  }
  return phrase("Rehearsal", "%1 levels of %2 (%3)")
      .with(std::to_string(levels.size()), parameter, listed);
}

/// The worst of the first group; the others have the same words for other stimuli.
RehearsalWarning joined(const std::vector<LevelGroup>& alike, const Protocol& protocol) {
  const LevelGroup& first = alike.front();
  RehearsalWarning one = first.worst();
  if (first.levels().size() > 1 && !first.is_alike()) {
    one.text =
        phrase("Rehearsal",
               "%1 This kind of warning applies to %2; the one shown has the greatest difference.")
            .with(one.text, levels_text(first, protocol));
    return one;
  }
  Phrase also{};
  for (const LevelGroup& group : alike) {
    if (group.levels().size() > 1) {
      also = with_comma(also, levels_text(group, protocol));
    } else if (&group != &first) {
      also = with_comma(also, '"' + group.worst().stimulus + '"');
    }
  }
  if (!also.empty()) {
    one.text = phrase("Rehearsal", "%1 The same applies to %2.").with(one.text, also);
  }
  return one;
}

}  // namespace

std::optional<WarnedLevel> level_of(const Protocol& protocol, const Trial& trial,
                                    const PlannedPresentation& planned) {
  const auto block = protocol.blocks.find(trial.block);
  if (block == protocol.blocks.end() || !block->second.vary) return {};
  const Dimension& vary = *block->second.vary;
  if (vary.role != planned.role) return {};
  const auto level = planned.stimulus.parameters.find(vary.parameter);
  if (level == planned.stimulus.parameters.end()) return {};
  const double* const value = std::get_if<double>(&level->second);
  if (value == nullptr) return {};
  std::string stimulus = planned.stimulus.name;
  const std::string suffix = '_' + text_of(level->second);
  if (stimulus.ends_with(suffix)) stimulus.resize(stimulus.size() - suffix.size());
  return WarnedLevel{.stimulus = stimulus, .parameter = vary.parameter, .value = *value};
}

std::vector<RehearsalWarning> one_for_alike(std::vector<RehearsalWarning> warnings,
                                            const Protocol& protocol) {
  std::vector<LevelGroup> groups{};
  for (RehearsalWarning& warning : warnings) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const LevelGroup& other) {
      const RehearsalWarning& first = other.warnings.front();
      return warning.level && first.level && first.id == warning.id &&
             first.pointer == warning.pointer && first.level->stimulus == warning.level->stimulus &&
             first.level->parameter == warning.level->parameter;
    });
    if (group == groups.end()) {
      groups.push_back({{std::move(warning)}});
    } else {
      group->warnings.push_back(std::move(warning));
    }
  }
  std::vector<std::vector<LevelGroup>> alike{};
  for (LevelGroup& group : groups) {
    const RehearsalWarning& one = group.worst();
    const auto same = std::find_if(alike.begin(), alike.end(), [&](const auto& others) {
      const RehearsalWarning& other = others.front().worst();
      return other.id == one.id && other.pointer == one.pointer && !one.stimulus.empty() &&
             has_same_words(other, one) && others.front().is_alike() && group.is_alike();
    });
    if (same == alike.end()) {
      alike.push_back({std::move(group)});
    } else {
      same->push_back(std::move(group));
    }
  }
  std::vector<RehearsalWarning> left{};
  for (const std::vector<LevelGroup>& one : alike) left.push_back(joined(one, protocol));
  return left;
}

}  // namespace asperity
