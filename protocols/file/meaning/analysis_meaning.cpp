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
        checked.report(
            at,
            (known.empty() ? phrase("Protocols", "no main block of ratings has a scale %1; add one")
                           : phrase("Protocols", "no main block of ratings has a scale %1; use %2"))
                .with(in_quotes(scale), joined_by_or(quoted(known))));
      } else if (std::find(construct.scales.begin(), here, scale) != here) {
        checked.report(at, phrase("Protocols", "the scale %1 is named twice; name it once")
                               .with(in_quotes(scale)));
      } else if (first == nullptr) {
        first = &found->second;
      } else if (found->second.minimum != first->minimum ||
                 found->second.maximum != first->maximum) {
        checked.report(
            at, phrase("Protocols",
                       "the scales of a construct are added up and have one range: %1 has %2 to "
                       "%3, the first scale %4 to %5; give them the same minimum and maximum")
                    .with(in_quotes(scale), digits(found->second.minimum),
                          digits(found->second.maximum), digits(first->minimum),
                          digits(first->maximum)));
      }
    }
    for (std::size_t i = 0; i < construct.reverse_keyed.size(); ++i) {
      const std::string& scale = construct.reverse_keyed[i];
      if (std::find(construct.scales.begin(), construct.scales.end(), scale) !=
          construct.scales.end()) {
        continue;
      }
      checked.report(pointer_to(pointer + "/reverse_keyed", i),
                     phrase("Protocols", "%1 is not one of the scales of this construct; use %2")
                         .with(in_quotes(scale), joined_by_or(quoted(construct.scales))));
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
    if (const auto nearest = nearest_name(key, known)) {
      checked.report_key("/analysis/" + key,
                         phrase("Protocols", "%1 is not a key of the analysis; did you mean %2?")
                             .with(in_quotes(key), key_name(*nearest)));
    }
  }
  const AnalysisDeclaration& declared = checked.protocol.analysis;
  if (declared.target) {
    const std::set<std::string> items = items_of_main_blocks(checked);
    if (!items.contains(*declared.target)) {
      const std::vector<std::string> names(items.begin(), items.end());
      checked.report(
          "/analysis/target",
          (names.empty()
               ? phrase("Protocols", "the target %1 cannot be chosen in a main block")
               : phrase("Protocols", "the target %1 cannot be chosen in a main block; use %2"))
              .with(in_quotes(*declared.target), joined_by_or(quoted(names))));
    }
  }
  const bool has_catch_trials = std::any_of(
      checked.protocol.blocks.begin(), checked.protocol.blocks.end(), [](const auto& each) {
        const auto& procedure = each.second.procedure;
        return each.second.phase == Phase::main && procedure && procedure->catch_trials;
      });
  if (declared.exclude && !has_catch_trials) {
    checked.report("/analysis/exclude",
                   phrase("Protocols",
                          "no main block has catch trials, by whose errors participants are "
                          "excluded; add %1 to the procedure of a discrimination, or remove this "
                          "key")
                       .with(key_name("catch_trials")));
  }
  check_constructs(checked);
  std::vector<std::string> tests{};
  Phrase kinds{};
  const std::vector<const ExperimentKind*> analysed = analysed_kinds_of(checked.protocol);
  for (const ExperimentKind* const kind : analysed) {
    const Phrase& name = kind->name;
    kinds = kinds.empty() ? name : phrase("Protocols", "%1 or a %2").with(kinds, name);
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
      checked.report(pointer, phrase("Protocols", "a %1 has no test %2; use %3")
                                  .with(kinds, in_quotes(name), joined_by_or(quoted(tests))));
    } else if (std::find(declared.family.begin(), here, name) != here) {
      checked.report(
          pointer,
          phrase("Protocols", "the test %1 is named twice; name it once").with(in_quotes(name)));
    } else if (compares_groups(name) && !checked.protocol.groups) {
      checked.report(pointer,
                     phrase("Protocols",
                            "the test %1 compares the groups of the protocol, which has none: add "
                            "the key %2")
                         .with(in_quotes(name), key_name("groups")));
    } else if (!declared.target && needs_target(name)) {
      checked.report(pointer, phrase("Protocols", "the test %1 requires a target: name it with %2")
                                  .with(in_quotes(name), key_name("target")));
    }
  }
  const auto has = [&declared](const char* name) {
    return std::find(declared.family.begin(), declared.family.end(), name) != declared.family.end();
  };
  if (has("pairs") && has("target_pairs")) {
    checked.report("/analysis/family",
                   phrase("Protocols", "%1 includes the pairs of the target; keep one of the two")
                       .with(in_quotes("pairs")));
  }
}

}  // namespace asperity
