// Implements the checks that the declared analysis is possible.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/kinds/analysed_names.h"

namespace asperity {

namespace {

void check_constructs(CheckedDocument& checked) {
  const std::map<std::string, ScaleForm, std::less<>> scales = rated_scales(checked.protocol);
  std::vector<std::string> known{};
  for (const auto& [name, scale] : scales) known.push_back(name);
  for (const auto& [name, construct] : checked.protocol.analysis.constructs) {
    const std::string pointer = pointer_to("/analysis/constructs", name);
    auto first = scales.end();
    for (std::size_t i = 0; i < construct.scales.size(); ++i) {
      const std::string at = pointer_to(pointer + "/scales", i);
      const std::string& scale = construct.scales[i];
      const auto found = scales.find(scale);
      if (found == scales.end()) {
        checked.report(
            at,
            (known.empty() ? phrase("Protocols", "no main block of ratings has a scale %1; add one")
                           : phrase("Protocols", "no main block of ratings has a scale %1; use %2"))
                .with(in_quotes(scale), joined_by_or(quoted(known))));
      } else if (first == scales.end()) {
        first = found;
      } else if (found->second.minimum != first->second.minimum ||
                 found->second.maximum != first->second.maximum) {
        checked.report(
            at, phrase("Protocols",
                       "the scales of a construct are added up and have one range: %1 has %2 to "
                       "%3, %4 has %5 to %6; give them the same minimum and maximum")
                    .with(in_quotes(scale), digits(found->second.minimum),
                          digits(found->second.maximum), in_quotes(first->first),
                          digits(first->second.minimum), digits(first->second.maximum)));
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
  if (!checked.document.root().contains("analysis")) return;
  const AnalysisDeclaration& declared = checked.protocol.analysis;
  if (declared.target) {
    const std::set<std::string> items = chosen_items(checked.protocol);
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
  Phrase kinds{};
  for (const ExperimentKind* const kind : analysed_kinds_of(checked.protocol)) {
    const Phrase& name = kind->name;
    kinds = kinds.empty() ? name : phrase("Protocols", "%1 or a %2").with(kinds, name);
  }
  std::vector<std::string> tests{};
  std::set<std::string> with_target{};
  for (const KindTest* const test : tests_of(checked.protocol)) {
    const std::string name(test->name);
    if (std::find(tests.begin(), tests.end(), name) == tests.end()) tests.push_back(name);
    if (test->needs_target) with_target.insert(name);
  }
  for (std::size_t i = 0; i < declared.family.size(); ++i) {
    const std::string& name = declared.family[i];
    const std::string pointer = pointer_to("/analysis/family", i);
    if (std::find(tests.begin(), tests.end(), name) == tests.end()) {
      checked.report(pointer, phrase("Protocols", "a %1 has no test %2; use %3")
                                  .with(kinds, in_quotes(name), joined_by_or(quoted(tests))));
    } else if (compares_groups(name) && !checked.protocol.groups) {
      checked.report(pointer,
                     phrase("Protocols",
                            "the test %1 compares the groups of the protocol, which has none: add "
                            "the key %2")
                         .with(in_quotes(name), key_name("groups")));
    } else if (!declared.target && with_target.contains(name)) {
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
