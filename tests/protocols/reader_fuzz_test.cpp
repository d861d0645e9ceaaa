// Whatever stands in a file, the reader answers with a protocol or with sentences.

#include <span>

#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/plan.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

/// True when the text was accepted; then it can be planned too.
bool survives(const std::string& text) {
  try {
    const Protocol protocol = read_protocol(text, "fuzz.json", test::example_models());
    (void)cost_of(protocol, make_plan(protocol, {.seed = 3, .counterbalance_row = 1}));
    return true;
  } catch (const ProtocolError& error) {
    EXPECT_FALSE(error.diagnostics().empty());
    for (const Diagnostic& diagnostic : error.diagnostics()) {
      EXPECT_FALSE(diagnostic.message.english().empty());
      EXPECT_GE(diagnostic.line, 1);
      EXPECT_GE(diagnostic.column, 1);
    }
    return false;
  }
}

void damage_bytes(std::string& text, std::uint64_t kind, Random& random) {
  const auto at = static_cast<std::size_t>(random.below(text.size()));
  switch (kind) {
    case 0:
      text[at] = static_cast<char>(random.below(256));
      break;
    case 1:
      text.insert(at, 1, "{}[],:\"\\0-9eEnt\n"[random.below(16)]);
      break;
    case 2:
      text.erase(at, 1 + static_cast<std::size_t>(random.below(20)));
      break;
    default:
      text.resize(at);
      break;
  }
}

TEST(ReaderFuzz, BytesChangedInsertedOrCutNeverBreakIt) {
  Random random = Random(20260101).split("bytes");
  int accepted = 0;
  for (const LibraryProtocol& each : library_protocols()) {
    for (std::uint64_t kind = 0; kind < 4; ++kind) {
      std::string text(each.text);
      damage_bytes(text, kind, random);
      for (auto further = random.below(4); further > 0 && !text.empty(); --further) {
        damage_bytes(text, random.below(4), random);
      }
      accepted += survives(text) ? 1 : 0;
    }
  }
  EXPECT_GT(accepted, 0);  // some changes fall into texts for people
}

void collect(nlohmann::json& node, std::vector<nlohmann::json*>& nodes) {
  nodes.push_back(&node);
  for (auto& member : node) {
    if (member.is_structured()) {
      collect(member, nodes);
    } else {
      nodes.push_back(&member);
    }
  }
}

void damage_values(nlohmann::json& root, std::uint64_t kind, Random& random) {
  std::vector<nlohmann::json*> nodes{};
  collect(root, nodes);
  nlohmann::json& target = *nodes[static_cast<std::size_t>(random.below(nodes.size()))];
  const nlohmann::json other = *nodes[static_cast<std::size_t>(random.below(nodes.size()))];
  switch (kind) {
    case 0:
      target = other;
      break;
    case 1:
      target = nlohmann::json::array({other, other});
      break;
    case 2:
      target = nullptr;
      break;
    case 3:
      target = random.below(2) == 0 ? -1e300 : 1e300;
      break;
    case 4:
      if (target.is_object() && !target.empty()) {
        auto member = target.begin();
        std::advance(member, static_cast<std::ptrdiff_t>(random.below(target.size())));
        target.erase(member);
      } else if (target.is_string()) {
        target = target.get<std::string>() + "x";
      } else if (target.is_number()) {
        target = target.get<double>() * 2;
      }
      break;
    default:
      if (target.is_object()) target["extra"] = other;
      if (target.is_array()) target.push_back(other);
      if (target.is_number()) target = 0;
      break;
  }
}

TEST(ReaderFuzz, ValuesSwappedDroppedOrReplacedNeverBreakIt) {
  Random random = Random(20260101).split("structure");
  std::size_t refused = 0;
  for (const LibraryProtocol& each : library_protocols()) {
    for (std::uint64_t kind = 0; kind < 6; ++kind) {
      auto root = nlohmann::json::parse(each.text);
      damage_values(root, kind, random);
      for (auto further = random.below(3); further > 0; --further) {
        damage_values(root, random.below(6), random);
      }
      refused += survives(root.dump()) ? 0 : 1;
    }
  }
  EXPECT_GT(refused, 2 * library_protocols().size());
}

TEST(ReaderFuzz, TheLongestTextsAndKeysThatAreReadDoNotExhaustTheStack) {
  const std::string longest(8192, 'a');
  for (const char* const from : {"\"1.1.0\"", "\"improved_selection\"", "\"texture\": {",
                                 "\"stroking\": {", "\"hand_occluded\""}) {
    std::string text = test::library_text("improved_selection");
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    text.insert(at + 1, longest.substr(0, 8000));
    EXPECT_FALSE(survives(text)) << from;
    text.erase(at + 1, 8000);
    text.insert(at + 1, longest.substr(0, 250));
    EXPECT_FALSE(survives(text)) << from;
  }
}

}  // namespace
}  // namespace asperity
