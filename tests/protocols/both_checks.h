// Holds the check by the tables of keys to an independent validator of the schema.

#pragma once

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/form_check.h"

namespace asperity::test {

/// Whether valijson finds that the document follows protocol_schema().
bool follows_schema(const nlohmann::json& document);

/// Expects that both accept a protocol or both refuse it.
inline void expect_that_both_checks_agree(const std::string& text) {
  const JsonDocument document(text, "p.json");
  EXPECT_EQ(follows_schema(document.root()), check_form(document).empty()) << text;
}

}  // namespace asperity::test
