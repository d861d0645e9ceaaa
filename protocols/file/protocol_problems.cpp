// Implements the search for problems in all layers of a protocol.

#include "protocols/file/protocol_problems.h"

#include <algorithm>
#include <set>
#include <utility>

#include "protocols/file/follow_ups.h"
#include "protocols/file/form_check.h"
#include "protocols/file/json_document.h"
#include "protocols/file/meaning/meaning.h"
#include "protocols/file/protocol_from_json.h"

namespace asperity {

namespace {

/// The problems of meaning that do not depend on the replaced values.
std::vector<Diagnostic> certain_problems(const JsonDocument& document, const Repair& repair,
                                         const std::vector<ModelDeclaration>& models) {
  std::vector<Diagnostic> certain{};
  bool is_first = true;
  for (const nlohmann::json& root : repair.roots) {
    const JsonDocument variant = document.with_root(root);
    const std::vector<Diagnostic> found =
        check_meaning(protocol_from_json(root, models), variant, models);
    const auto is_found = [&found](const Diagnostic& problem) {
      return std::any_of(found.begin(), found.end(), [&problem](const Diagnostic& other) {
        return other.pointer == problem.pointer && other.message == problem.message;
      });
    };
    if (is_first) {
      std::copy_if(found.begin(), found.end(), std::back_inserter(certain),
                   [&repair](const Diagnostic& problem) {
                     return !may_follow_from(repair, problem.pointer, problem.message);
                   });
    } else {
      std::erase_if(certain, [&](const Diagnostic& problem) { return !is_found(problem); });
    }
    is_first = false;
  }
  if (repair.roots.empty()) return certain;
  return without_follow_ups(std::move(certain), document.with_root(repair.roots.front()), models);
}

}  // namespace

void sort_by_line(std::vector<Diagnostic>& diagnostics) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return std::pair(a.line, a.column) < std::pair(b.line, b.column);
                   });
}

ProtocolReading read_protocol_with_problems(std::string_view text, const std::string& file_name,
                                            const std::vector<ModelDeclaration>& models) {
  ProtocolReading reading{};
  try {
    const JsonDocument document(text, file_name, &reading.problems);
    const bool has_unusable_texts = !reading.problems.empty();
    const std::vector<Diagnostic> of_form = check_form(document);
    append(reading.problems, of_form);
    reading.has_form = of_form.empty();
    if (reading.has_form) {
      reading.protocol = protocol_from_json(document.root(), models);
      append(
          reading.problems,
          without_follow_ups(check_meaning(*reading.protocol, document, models), document, models));
    } else {
      reading.repair = repaired(document);
      if (!reading.repair.roots.empty()) {
        append(reading.problems, certain_problems(document, reading.repair, models));
        reading.protocol = protocol_from_json(reading.repair.roots.front(), models);
      }
    }
    if (has_unusable_texts) {
      reading.protocol.reset();
      reading.has_form = false;
    }
    if (reading.protocol) reading.protocol->source = std::string(text);
  } catch (const ProtocolError& error) {
    reading.problems = error.diagnostics();
  }
  sort_by_line(reading.problems);
  return reading;
}

}  // namespace asperity
