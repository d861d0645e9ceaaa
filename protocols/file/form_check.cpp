// Implements the check of the form of a document by the tables of keys.

#include "protocols/file/form_check.h"

#include "protocols/file/protocol_problems.h"
#include "protocols/keys/form_sentences.h"
#include "protocols/keys/tables.h"
#include "protocols/keys/valid_part.h"

namespace asperity {

std::vector<Diagnostic> check_form(const JsonDocument& document, const KeyTable& table) {
  std::vector<Diagnostic> found{};
  const ValueShape shape = ObjectShape{&table};
  for (FormProblem& problem : valid_part(document.root(), shape, "", "").problems) {
    found.push_back(problem.is_at_key ? document.at_key(problem.pointer, problem.message)
                                      : document.at(problem.pointer, problem.message));
  }
  sort_by_line(found);
  return found;
}

std::vector<Diagnostic> check_form(const JsonDocument& document) {
  if (!document.root().is_object()) {
    return {document.at(
        "", phrase("Protocols",
                   "%1 is not a protocol; a protocol is an object {…} that begins with \"format\": "
                   "\"asperity.protocol/1\"")
                .with(quoted_value(document.root())))};
  }
  return check_form(document, kProtocolTable);
}

bool has_form_of_protocol(const nlohmann::json& root) {
  return valid_part(root, kProtocolTable, "").problems.empty();
}

}  // namespace asperity
