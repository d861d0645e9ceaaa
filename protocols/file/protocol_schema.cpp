// Implements the schema of protocols.

#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "protocols/keys/schema_of.h"
#include "protocols/keys/tables.h"

namespace asperity {

const nlohmann::json& protocol_schema() {
  static const nlohmann::json kSchema = [] {
    nlohmann::json schema = schema_of(kProtocolTable);
    schema["$schema"] = "http://json-schema.org/draft-07/schema#";
    schema["title"] = "Asperity protocol, format 1";
    return schema;
  }();
  return kSchema;
}

}  // namespace asperity
