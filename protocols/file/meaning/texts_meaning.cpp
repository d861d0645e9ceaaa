// Implements the checks of the placeholders in texts that participants read.

#include <algorithm>

#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/texts/protocol_texts.h"

namespace asperity {

namespace {

std::vector<std::string> number_names() {
  std::vector<std::string> names{};
  for (const DesignNumber& number : kDesignNumbers) names.emplace_back(number.name);
  return names;
}

std::string in_braces(const std::string& name) { return '{' + name + '}'; }

/// Why a placeholder cannot be used as it is written; empty if it can.
Phrase problem_of_form(const Placeholder& placeholder) {
  if (!placeholder.is_closed) {
    return phrase("Protocols",
                  "the brace before %1 begins a number of the design, such as {surfaces}; add the "
                  "closing brace, or write {{ for a brace in the text")
        .with(in_quotes(placeholder.name));
  }
  const DesignNumber* const number = find_design_number(placeholder.name);
  if (number == nullptr) {
    return phrase("Protocols", "%1; use %2, or write {{ for a brace in the text")
        .with(with_guess(phrase("Protocols", "there is no number of the design %1")
                             .with(in_quotes(placeholder.name)),
                         placeholder.name, number_names()),
              joined_by_or(quoted(number_names())));
  }
  if (!placeholder.forms.empty() && placeholder.forms.size() != 2) {
    return phrase("Protocols", "%1 takes two forms, for one and for several: %2")
        .with(in_braces(placeholder.name), in_braces(placeholder.name + "|form|forms"));
  }
  if (!placeholder.forms.empty() && placeholder.name == "surface_names") {
    return phrase("Protocols",
                  "{surface_names} has no forms; write {surface_names}, or {surfaces|form|forms}");
  }
  return {};
}

/// What a session lacks that a placeholder states; empty if it lacks nothing.
Phrase missing_in_session(const std::string& name, const Protocol& protocol) {
  if (name == "breaks") {
    return has_known_breaks(protocol)
               ? Phrase()
               : phrase("Protocols",
                        "a session has no breaks, or their number depends on responses or on the "
                        "time in contact");
  }
  const auto runs = [&protocol](bool of_main) {
    return std::any_of(protocol.flow.begin(), protocol.flow.end(), [&](const auto& step) {
      const auto* const run = std::get_if<Protocol::Run>(&step);
      const auto block = run == nullptr ? protocol.blocks.end() : protocol.blocks.find(run->block);
      return block != protocol.blocks.end() && (block->second.phase == Phase::main) == of_main;
    });
  };
  if (name == "practice_trials") {
    return runs(false) ? Phrase() : phrase("Protocols", "a session has no trials of practice");
  }
  return name == "minutes" || runs(true) ? Phrase()
                                         : phrase("Protocols", "a session has no main part");
}

}  // namespace

void check_texts(CheckedDocument& checked) {
  for (const TextPlace& place : participant_texts(checked.document.root(), checked.protocol)) {
    for (const Placeholder& placeholder : placeholders_in(place.text)) {
      const std::string& name = placeholder.name;
      const Phrase problem = problem_of_form(placeholder);
      if (!problem.empty()) {
        checked.report(place.pointer, problem);
        continue;
      }
      const DesignNumber& number = *find_design_number(name);
      if (number.scope == NumberScope::session) {
        if (place.is_of_session) {
          const Phrase missing = missing_in_session(name, checked.protocol);
          if (!missing.empty())
            checked.report(place.pointer,
                           phrase("Protocols", "%1; remove %2").with(missing, in_braces(name)));
          continue;
        }
        checked.report(
            place.pointer,
            phrase("Protocols",
                   "%1 is known when a session begins: use it in %2, in a screen or "
                   "break of %3, or in %4")
                .with(in_braces(name), key_name("consent"), key_name("flow"), key_name("resume")));
        continue;
      }
      if (values_of_design(checked.protocol, place).contains(name)) continue;
      checked.report(place.pointer,
                     (place.block != nullptr
                          ? phrase("Protocols",
                                   "a trial of this block has no %1; remove %2, or state another "
                                   "number")
                          : phrase("Protocols",
                                   "the main blocks have no %1, or differ in them; write the "
                                   "number, or use %2 in a text of the block"))
                         .with(noun_of(number), in_braces(name)));
    }
  }
}

}  // namespace asperity
