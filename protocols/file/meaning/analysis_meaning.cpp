// Implements the checks that the declared analysis is possible.

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "protocols/file/meaning/meaning_checks.h"

namespace asperity {

namespace {

/// The items that can be chosen in main blocks, for the check of the declared target.
std::set<std::string> items_of_main_blocks(CheckedDocument& checked) {
  std::set<std::string> items{};
  for (const auto& [name, block] : checked.protocol.blocks) {
    if (block.phase != Phase::main) continue;
    if (block.all_pairs && checked.protocol.factors.contains(block.all_pairs->factor)) {
      for (const Level& level : checked.protocol.factors.at(block.all_pairs->factor).levels) {
        items.insert(text_of(level));
      }
      continue;
    }
    for (const Protocol::Presented& presented : block.presented) {
      const auto stimulus = checked.protocol.stimuli.find(presented.stimulus);
      if (!presented.item.empty()) {
        items.insert(presented.item);
      } else if (stimulus != checked.protocol.stimuli.end()) {
        const Binding<std::string>& model = stimulus->second.model;
        const auto fixed = presented.with.find(model.factor);
        if (!model.value && fixed != presented.with.end()) {
          items.insert(text_of(fixed->second));
          continue;
        }
        const std::string pointer = pointer_to("/stimuli", presented.stimulus) + "/model";
        for (const auto& [text, place] : texts_of(checked, model, pointer)) items.insert(text);
      }
    }
  }
  return items;
}

void check_constructs(CheckedDocument& checked) {
  std::map<std::string, ScaleForm, std::less<>> scales{};
  for (const auto& [name, block] : checked.protocol.blocks) {
    if (block.phase != Phase::main || block.kind != "rating") continue;
    for (const Protocol::TrialQuestionTemplate& question : block.questions) {
      if (const auto* const scale = std::get_if<ScaleForm>(&question.form)) {
        scales.emplace(question.name, *scale);
      }
    }
  }
  std::vector<std::string> known{};
  for (const auto& [name, scale] : scales) known.push_back(name);
  for (const auto& [name, construct] : checked.protocol.analysis.constructs) {
    const std::string pointer = pointer_to("/analysis/constructs", name);
    const ScaleForm* first = nullptr;
    for (std::size_t i = 0; i < construct.scales.size(); ++i) {
      const std::string at = pointer_to(pointer + "/scales", i);
      const std::string& scale = construct.scales[i];
      const auto here = construct.scales.begin() + static_cast<std::ptrdiff_t>(i);
      const auto found = scales.find(scale);
      if (found == scales.end()) {
        checked.report(at, "no main block of ratings has a scale " + in_quotes(scale) +
                               (known.empty() ? "; add one" : "; use " + one_of(known)));
      } else if (std::find(construct.scales.begin(), here, scale) != here) {
        checked.report(at, "the scale " + in_quotes(scale) + " is named twice; name it once");
      } else if (first == nullptr) {
        first = &found->second;
      } else if (found->second.minimum != first->minimum ||
                 found->second.maximum != first->maximum) {
        checked.report(
            at, "the scales of a construct are added up and have one range: " + in_quotes(scale) +
                    " has " + digits(found->second.minimum) + " to " +
                    digits(found->second.maximum) + ", the first scale " + digits(first->minimum) +
                    " to " + digits(first->maximum) + "; give them the same minimum and maximum");
      }
    }
    for (std::size_t i = 0; i < construct.reverse_keyed.size(); ++i) {
      const std::string& scale = construct.reverse_keyed[i];
      if (std::find(construct.scales.begin(), construct.scales.end(), scale) !=
          construct.scales.end()) {
        continue;
      }
      checked.report(pointer_to(pointer + "/reverse_keyed", i),
                     in_quotes(scale) + " is not one of the scales of this construct; use " +
                         one_of(construct.scales));
    }
  }
}

}  // namespace

void check_analysis(CheckedDocument& checked) {
  const auto& root = checked.document.root();
  const auto found = root.find("analysis");
  if (found == root.end()) return;
  // Other keys are comments of the author; one that is similar to a known key is a spelling mistake.
  const std::vector<std::string> known{"target", "family", "equivalence_margin", "constructs",
                                       "exclude"};
  for (const auto& [key, value] : found->items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string guess = did_you_mean(key, known);
    if (!guess.empty()) {
      checked.report_key("/analysis/" + key,
                         in_quotes(key) + " is not a key of the analysis" + guess);
    }
  }
  const AnalysisDeclaration& declared = checked.protocol.analysis;
  if (declared.target) {
    const std::set<std::string> items = items_of_main_blocks(checked);
    if (!items.contains(*declared.target)) {
      const std::vector<std::string> names(items.begin(), items.end());
      checked.report("/analysis/target", "the target " + in_quotes(*declared.target) +
                                             " cannot be chosen in a main block" +
                                             (names.empty() ? "" : "; use " + one_of(names)));
    }
  }
  const bool has_catch_trials = std::any_of(
      checked.protocol.blocks.begin(), checked.protocol.blocks.end(), [](const auto& each) {
        const auto& procedure = each.second.procedure;
        return each.second.phase == Phase::main && procedure && procedure->catch_trials;
      });
  if (declared.exclude && !has_catch_trials) {
    checked.report("/analysis/exclude",
                   "no main block has catch trials, by whose errors participants are excluded; add "
                   "\"catch_trials\" to the procedure of a discrimination, or remove this key");
  }
  check_constructs(checked);
  std::vector<std::string> tests{};
  std::string kinds{};
  const std::vector<const ExperimentKind*> analysed = analysed_kinds_of(checked.protocol);
  for (const ExperimentKind* const kind : analysed) {
    kinds += (kinds.empty() ? "" : " or a ") + std::string(kind->name);
    for (const KindTest& test : kind->tests) {
      if (std::find(tests.begin(), tests.end(), test.name) == tests.end()) {
        tests.emplace_back(test.name);
      }
    }
  }
  const auto needs_target = [&analysed](const std::string& name) {
    return std::any_of(analysed.begin(), analysed.end(), [&name](const ExperimentKind* kind) {
      const KindTest* const test = find_test(*kind, name);
      return test != nullptr && test->needs_target;
    });
  };
  for (std::size_t i = 0; i < declared.family.size(); ++i) {
    const std::string& name = declared.family[i];
    const std::string pointer = pointer_to("/analysis/family", i);
    const auto here = declared.family.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(tests.begin(), tests.end(), name) == tests.end()) {
      checked.report(pointer,
                     "a " + kinds + " has no test " + in_quotes(name) + "; use " + one_of(tests));
    } else if (std::find(declared.family.begin(), here, name) != here) {
      checked.report(pointer, "the test " + in_quotes(name) + " is named twice; name it once");
    } else if (compares_groups(name) && !checked.protocol.groups) {
      checked.report(pointer,
                     "the test " + in_quotes(name) +
                         " compares the groups of the protocol, which has none: add the key "
                         "groups");
    } else if (!declared.target && needs_target(name)) {
      checked.report(pointer,
                     "the test " + in_quotes(name) + " requires a target: name it with \"target\"");
    }
  }
  const auto has = [&declared](const char* name) {
    return std::find(declared.family.begin(), declared.family.end(), name) != declared.family.end();
  };
  if (has("pairs") && has("target_pairs")) {
    checked.report("/analysis/family",
                   "\"pairs\" includes the pairs of the target; keep one of the two");
  }
}

}  // namespace asperity
