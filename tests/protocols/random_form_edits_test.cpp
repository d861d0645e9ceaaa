// Random edits of the library's protocols by the values of a form.

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/file/library_protocols.h"
#include "protocols/form/form_edits.h"
#include "protocols/form/new_values.h"
#include "tests/protocols/form_values.h"

namespace asperity {
namespace {

using nlohmann::json;

/// The text has only a part between the same beginning and the same end replaced: its length.
std::size_t changed_length(const std::string& one, const std::string& other) {
  const std::size_t shorter = std::min(one.size(), other.size());
  std::size_t begin = 0;
  while (begin < shorter && one[begin] == other[begin]) ++begin;
  std::size_t end = 0;
  while (end < shorter - begin && one[one.size() - 1 - end] == other[other.size() - 1 - end]) ++end;
  return one.size() - begin - end;
}

// Every value that a form shows takes the simplest value of its shape, is stated where it was absent, and is removed: the tree is
// that of the same edit of the tree, and the text outside of the value is the same.
TEST(RandomFormEdits, ChangeNothingButTheirValue) {
  std::mt19937 random(7);
  std::size_t edits = 0;
  constexpr std::size_t kEditsPerProtocol = 7 * ASPERITY_EDITS_PER_TEXT;
  for (const LibraryProtocol& library : library_protocols()) {
    const std::string text(library.text);
    const JsonDocument protocol(text, "");
    const std::vector<test::ShownValue> all = test::values_of_form(protocol.root());
    const ProtocolNames names = names_in(protocol.root());
    for (std::size_t i = 0; i < kEditsPerProtocol; ++i, ++edits) {
      const test::ShownValue& shown = all[1 + random() % (all.size() - 1)];
      const json value = json::parse(new_value(shown.shape, names).dump());
      const FormEdit edit = with_value(protocol, shown.pointer, value.dump());
      json expected = protocol.root();
      expected[json::json_pointer(shown.pointer)] = value;
      ASSERT_EQ(json::parse(edit.text), expected) << library.name << shown.pointer;
      const JsonDocument changed(edit.text, "");
      if (!shown.is_present) {
        ASSERT_EQ(without(changed, std::array{shown.pointer}).text, text)
            << library.name << shown.pointer;
        continue;
      }
      const JsonPlace place = protocol.place_of(shown.pointer).value();
      ASSERT_LE(changed_length(text, edit.text), place.end - place.value)
          << library.name << shown.pointer;
      const std::string before = text.substr(place.value, place.end - place.value);
      ASSERT_EQ(with_value(changed, shown.pointer, before).text, text)
          << library.name << shown.pointer;
    }
  }
  EXPECT_GE(edits, 25 * kEditsPerProtocol);
}

}  // namespace
}  // namespace asperity
