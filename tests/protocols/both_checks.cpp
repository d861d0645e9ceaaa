// Implements the check by valijson.

#include "tests/protocols/both_checks.h"

#include <memory>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "protocols/file/library_protocols.h"

namespace asperity::test {

bool follows_schema(const nlohmann::json& document) {
  using Adapter = valijson::adapters::NlohmannJsonAdapter;
  static const auto kRules = [] {
    auto rules = std::make_unique<valijson::Schema>();
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(Adapter(protocol_schema()), *rules);
    return rules;
  }();
  valijson::Validator validator{};
  return validator.validate(*kRules, Adapter(document), nullptr);
}

}  // namespace asperity::test
