// The keys of "device": what is read of an object, what is refused, and the agreement with the schema.

#include "protocols/keys/device_keys.h"

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "protocols/keys/page_of.h"
#include "protocols/keys/reading.h"
#include "protocols/keys/schema_of.h"
#include "tests/protocols/both_checks.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using nlohmann::json;
using testing::ElementsAre;

const json kEverything = json::parse(R"({
  "rate_Hz": 2000, "force_limit_N": 3.5, "maximum_missed_deadlines": 1, "maximum_gaps_in_contact": 2,
  "maximum_lost_records": 3, "profile_maximum_age_days": 30, "refuse_rehearsal_warnings": true,
  "compute": "gpu", "input_only": true,
  "limits": {"friction_N": 0.25, "missed_deadlines": 4, "$comment": "of the manual"}, "x-serial": "12"
})");

std::string source_file(const std::string& path) {
  std::ifstream stream(std::string(ASPERITY_SOURCE_DIR) + '/' + path, std::ios::binary);
  EXPECT_TRUE(stream) << path;
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> pointers_of(const std::vector<FormProblem>& problems) {
  std::vector<std::string> pointers{};
  for (const FormProblem& problem : problems) pointers.push_back(problem.pointer);
  return pointers;
}

TEST(DeviceKeys, GoToTheirMembers) {
  Protocol protocol{};
  EXPECT_TRUE(read_keys(device_keys(), kEverything, "/device", protocol).empty());
  EXPECT_EQ(protocol.rate_Hz, 2000.0);
  EXPECT_EQ(protocol.force_limit_N, 3.5);
  EXPECT_EQ(protocol.maximum_missed_deadlines, 1);
  EXPECT_EQ(protocol.maximum_gaps_in_contact, 2);
  EXPECT_EQ(protocol.maximum_lost_records, 3);
  EXPECT_EQ(protocol.profile_maximum_age_days, 30.0);
  EXPECT_TRUE(protocol.refuses_rehearsal_warnings);
  EXPECT_TRUE(protocol.computes_on_gpu);
  EXPECT_TRUE(protocol.input_only);
  EXPECT_EQ(protocol.device_limits,
            (std::map<std::string, double>{{"friction_N", 0.25}, {"missed_deadlines", 4.0}}));
}

TEST(DeviceKeys, AreReadExceptForThoseInAnotherForm) {
  json device = kEverything;
  device["rate_Hz"] = "fast";
  device["maximum_lost_records"] = 1.5;
  device["compute"] = "cpus";
  device["limits"]["friction_N"] = -1;
  device["limits"]["colour"] = 1;
  device["later"] = true;
  Protocol protocol{};
  EXPECT_THAT(
      pointers_of(read_keys(device_keys(), device, "/device", protocol)),
      ElementsAre("/device/compute", "/device/later", "/device/limits/colour",
                  "/device/limits/friction_N", "/device/maximum_lost_records", "/device/rate_Hz"));
  EXPECT_EQ(protocol.rate_Hz, 1000.0);
  EXPECT_EQ(protocol.maximum_lost_records, 0);
  EXPECT_FALSE(protocol.computes_on_gpu);
  EXPECT_EQ(protocol.force_limit_N, 3.5);
  EXPECT_EQ(protocol.device_limits, (std::map<std::string, double>{{"missed_deadlines", 4.0}}));
}

TEST(DeviceKeys, AreNotReadFromAnotherValue) {
  Protocol protocol{};
  EXPECT_THAT(pointers_of(read_keys(device_keys(), json::array({1}), "/device", protocol)),
              ElementsAre("/device"));
  EXPECT_EQ(protocol.rate_Hz, 1000.0);
}

TEST(DeviceKeys, AreThoseOfTheSchema) {
  EXPECT_EQ(schema_of(device_keys()), json::parse(protocol_schema()).at("properties").at("device"));
}

TEST(DeviceKeys, AreThoseOfThePage) {
  const std::string page = source_file("docs/formats/protocol.md");
  for (const KeyTable* const table : {static_cast<const KeyTable*>(&device_keys()),
                                      static_cast<const KeyTable*>(&device_limit_keys())}) {
    const std::string rows = page_rows_of(*table);
    EXPECT_NE(page.find("| --- | --- | --- | --- |\n" + rows + '\n'), std::string::npos) << rows;
  }
}

/// The unit of a quantity ends its name.
TEST(DeviceKeys, HaveALabelAndTheUnitOfTheirName) {
  for (const KeyTable* const table : {static_cast<const KeyTable*>(&device_keys()),
                                      static_cast<const KeyTable*>(&device_limit_keys())}) {
    for (const ProtocolKey& key : table->keys) {
      EXPECT_FALSE(key.label.empty()) << key.name;
      EXPECT_TRUE(key.meaning.ends_with('.')) << key.name;
      const auto* const number = std::get_if<NumberShape>(&key.shape);
      if (number == nullptr || number->unit.empty()) continue;
      std::string ending = "_";
      for (const char c : number->unit) {
        ending += c == ' ' ? std::string("_") : c == '/' ? std::string("_per_") : std::string(1, c);
      }
      EXPECT_TRUE(key.name.ends_with(ending)) << key.name << ' ' << ending;
    }
  }
}

/// Of the objects with tables in all library protocols, and of one with all keys.
TEST(KeysAndSchema, AgreeOnLibraryProtocols) {
  for (const LibraryProtocol& each : library_protocols()) {
    test::expect_that_both_checks_agree(std::string(each.text));
  }
  json file = json::parse(test::example_selection());
  file["device"] = kEverything;
  test::expect_that_both_checks_agree(file.dump(1));
  EXPECT_TRUE(test::problems_in(file).empty());
}

TEST(KeysAndSchema, AgreeOnRandomEdits) {
  constexpr int kEdits = 1500;
  const std::vector<json> values{nullptr,
                                 true,
                                 0,
                                 -1,
                                 1,
                                 50,
                                 1.5,
                                 -0.5,
                                 1e9,
                                 "1000",
                                 "",
                                 "gp",
                                 "x",
                                 {},
                                 json{},
                                 {1, 2},
                                 "gpu",
                                 {{"rate_Hz", 1}},
                                 std::string(300, 'a'),
                                 20,
                                 20.5,
                                 100,
                                 1e4,
                                 10001,
                                 1000000,
                                 1000001,
                                 8000.5,
                                 json::array(),
                                 json::object()};
  Random random = Random(20261129).split("device");
  const auto drawn = [&random](std::size_t n) { return static_cast<std::size_t>(random.below(n)); };
  const auto nth = [](json& object, std::size_t n) {
    auto at = object.begin();
    std::advance(at, static_cast<std::ptrdiff_t>(n));
    return at;
  };
  for (int i = 0; i < kEdits && !testing::Test::HasFailure(); ++i) {
    json file = json::parse(test::example_selection());
    file["device"] = kEverything;
    for (const KeyTable* const table : {static_cast<const KeyTable*>(&device_keys()),
                                        static_cast<const KeyTable*>(&device_limit_keys())}) {
      json& object = table == &device_keys() ? file["device"] : file["device"]["limits"];
      for (std::size_t edits = drawn(4); edits > 0 && object.is_object() && !object.empty();
           --edits) {
        const std::string key(table->keys[drawn(table->keys.size())].name);
        switch (drawn(4)) {
          case 0:
            object[key] = values[drawn(values.size())];
            break;
          case 1:
            object[key + "s"] = values[drawn(values.size())];
            break;
          case 2:
            object.erase(nth(object, drawn(object.size())));
            break;
          default:
            object["x-" + key] = values[drawn(values.size())];
            break;
        }
      }
      if (!file["device"]["limits"].is_object()) break;
    }
    if (drawn(50) == 0) file["device"] = values[drawn(values.size())];
    test::expect_that_both_checks_agree(file.dump(1));
  }
}

}  // namespace
}  // namespace asperity
