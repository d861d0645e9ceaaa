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
std::string problem_of_form(const Placeholder& placeholder) {
  if (!placeholder.is_closed) {
    return "the brace before " + in_quotes(placeholder.name) +
           " begins a number of the design, such as {surfaces}; add the closing brace, or write {{ "
           "for a brace in the text";
  }
  const DesignNumber* const number = find_design_number(placeholder.name);
  if (number == nullptr) {
    return "there is no number of the design " + in_quotes(placeholder.name) +
           did_you_mean(placeholder.name, number_names()) + "; use " + one_of(number_names()) +
           ", or write {{ for a brace in the text";
  }
  if (!placeholder.forms.empty() && placeholder.forms.size() != 2) {
    return in_braces(placeholder.name) + " takes two forms, for one and for several: {" +
           placeholder.name + "|form|forms}";
  }
  if (!placeholder.forms.empty() && placeholder.name == "surface_names") {
    return "{surface_names} has no forms; write {surface_names}, or {surfaces|form|forms}";
  }
  return {};
}

/// What a session lacks that a placeholder states; empty if it lacks nothing.
std::string missing_in_session(const std::string& name, const Protocol& protocol) {
  if (name == "breaks") {
    return has_known_breaks(protocol)
               ? ""
               : "a session has no breaks, or their number depends on responses or on the time in "
                 "contact";
  }
  const auto runs = [&protocol](bool of_main) {
    return std::any_of(protocol.flow.begin(), protocol.flow.end(), [&](const auto& step) {
      const auto* const run = std::get_if<Protocol::Run>(&step);
      const auto block = run == nullptr ? protocol.blocks.end() : protocol.blocks.find(run->block);
      return block != protocol.blocks.end() && (block->second.phase == Phase::main) == of_main;
    });
  };
  if (name == "practice_trials") return runs(false) ? "" : "a session has no trials of practice";
  return name == "minutes" || runs(true) ? "" : "a session has no main part";
}

}  // namespace

void check_texts(CheckedDocument& checked) {
  for (const TextPlace& place : participant_texts(checked.document.root(), checked.protocol)) {
    for (const Placeholder& placeholder : placeholders_in(place.text)) {
      const std::string& name = placeholder.name;
      const std::string problem = problem_of_form(placeholder);
      if (!problem.empty()) {
        checked.report(place.pointer, problem);
        continue;
      }
      if (find_design_number(name)->scope == NumberScope::session) {
        if (place.is_of_session) {
          const std::string missing = missing_in_session(name, checked.protocol);
          if (!missing.empty())
            checked.report(place.pointer, missing + "; remove " + in_braces(name));
          continue;
        }
        checked.report(place.pointer,
                       in_braces(name) +
                           " is known when a session begins: use it in \"consent\", in a screen or "
                           "break of \"flow\", or in \"resume\"");
        continue;
      }
      if (values_of_design(checked.protocol, place).contains(name)) continue;
      checked.report(place.pointer, place.block != nullptr
                                        ? "a trial of this block has no " + name + "; remove " +
                                              in_braces(name) + ", or state another number"
                                        : "the main blocks have no " + name +
                                              ", or differ in them; write the number, or use " +
                                              in_braces(name) + " in a text of the block");
    }
  }
}

}  // namespace asperity
