// Holds random edits of library protocols in seven styles to what they may change: 1,000 every day, 10,000 in a slow test.

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "protocols/design/json_pointer.h"
#include "protocols/editing/edits.h"
#include "protocols/editing/renaming.h"
#include "protocols/file/library_protocols.h"
#include "protocols/keys/names_in.h"
#include "tests/protocols/protocol_files.h"

namespace asperity {
namespace {

using Tree = nlohmann::ordered_json;
using Pointer = Tree::json_pointer;

// Of 175 texts.
constexpr std::size_t kEditsPerText = ASPERITY_EDITS_PER_TEXT;
constexpr std::size_t kReversedPerText = (kEditsPerText + 3) / 4;
constexpr const char* kNewKey = "new \"µ\"";

/// A number from 0 to below `n`.
std::size_t drawn(Random& random, std::size_t n) {
  return static_cast<std::size_t>(random.below(n));
}

std::string with_crlf(const std::string& text) {
  std::string result{};
  for (const char c : text) result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

std::string with_tabs(const std::string& text) {
  std::string result{};
  bool is_indentation = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    is_indentation = text[i] == '\n' || (is_indentation && text[i] == ' ');
    if (is_indentation && text[i] == ' ') {
      result += '\t';
      ++i;  // two spaces are a level
    } else {
      result += text[i];
    }
  }
  return result;
}

std::string on_one_line(const std::string& text) {
  std::string result{};
  bool is_indentation = false;
  for (const char c : text) {
    if (c == '\n' && result.ends_with(',')) result += ' ';
    is_indentation = c == '\n' || (is_indentation && c == ' ');
    if (!is_indentation) result += c;
  }
  return result;
}

/// Space before commas, around colons and in brackets, also in empty ones, and empty lines.
std::string spread_out(const std::string& text) {
  std::string result{};
  bool is_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_text && c == '\\') {
      result += c;
      result += text[++i];
      continue;
    }
    if (c == '"') is_text = !is_text;
    if (!is_text && (c == ',' || c == ':')) {
      result += ' ';
    } else if (c == '\n') {
      result += "\n ";
    }
    result += c;
    if (!is_text && (c == '[' || c == '{')) result += ' ';
  }
  return result;
}

/// Comments and unknown keys in every object, among its other members.
Tree with_comments(const Tree& tree) {
  if (tree.is_array()) {
    Tree list = Tree::array();
    for (const Tree& entry : tree) list.push_back(with_comments(entry));
    return list;
  }
  if (!tree.is_object()) return tree;
  Tree object = Tree::object({{"$comment", "first, {\"or\": [last]}"}});
  for (const auto& [key, member] : tree.items()) {
    object[key] = with_comments(member);
    if (object.size() == 2) object["x-own"] = {{"deep/~", {1.5, Tree::object(), Tree::array()}}};
  }
  object["unknown"] = nullptr;
  return object;
}

/// A text, and the pointers of all values in it except the document.
struct Sample {
  std::string text{};
  Tree tree{};
  std::vector<std::string> places{};
};

void add_places(const Tree& tree, const std::string& pointer, std::vector<std::string>& places) {
  if (!pointer.empty()) places.push_back(pointer);
  if (!tree.is_structured()) return;
  for (const auto& [key, member] : tree.items())
    add_places(member, pointer_to(pointer, key), places);
}

const std::vector<Sample>& samples() {
  static const std::vector<Sample> made = [] {
    std::vector<Sample> result{};
    const std::span<const LibraryProtocol> protocols = library_protocols();
    for (std::size_t i = 0; i < protocols.size(); ++i) {
      const std::string text =
          i % 2 == 0 ? std::string(protocols[i].text) : test::library_text(protocols[i].name, "de");
      const Tree tree = Tree::parse(text);
      const std::string commented = with_comments(tree).dump(1) + '\n';
      for (const std::string& styled : {text, with_crlf(text), with_tabs(text), on_one_line(text),
                                        tree.dump(), spread_out(commented), commented}) {
        result.push_back({styled, Tree::parse(styled), {}});
        add_places(result.back().tree, "", result.back().places);
      }
    }
    return result;
  }();
  return made;
}

enum class Kind { set, insert, remove, move, duplicate };

struct Edit {
  Kind kind = Kind::set;
  std::string pointer{};  ///< of the value; for `insert`, of the container
  std::size_t index = 0;  ///< for `insert` and `move`
  std::string value{};
};

std::string drawn_value(Random& random) {
  static const std::vector<std::string> kValues{
      "6e-05",
      "-1.50",
      "0.10000000000000001",
      "true",
      "null",
      R"("a, \"b\": [µ}\n")",
      "[]",
      "{}",
      R"([1,2.0,{"a":[ true ]}])",
      R"({"a long name of a member": [1, 2, 3], "another long name": {"x": "text text text text text", "y": [{}, []]},
          "a third one": "and more text than a line has"})"};
  return kValues[drawn(random, kValues.size())];
}

/// The container of the value, and the index of the value in it.
std::pair<std::string, std::size_t> place_among_siblings(const Tree& tree,
                                                         const std::string& pointer) {
  const Pointer path(pointer);
  const Tree& parent = tree.at(path.parent_pointer());
  if (parent.is_array()) return {path.parent_pointer().to_string(), std::stoul(path.back())};
  const auto found = std::find_if(parent.items().begin(), parent.items().end(),
                                  [&](const auto& item) { return item.key() == path.back(); });
  return {path.parent_pointer().to_string(),
          static_cast<std::size_t>(std::distance(parent.items().begin(), found))};
}

Edit drawn_edit(const Sample& sample, Kind kind, Random& random) {
  Edit edit{kind, sample.places[drawn(random, sample.places.size())], 0, drawn_value(random)};
  if (kind == Kind::insert) {
    while (!edit.pointer.empty() && !sample.tree.at(Pointer(edit.pointer)).is_structured()) {
      edit.pointer = Pointer(edit.pointer).parent_pointer().to_string();
    }
    edit.index = drawn(random, sample.tree.at(Pointer(edit.pointer)).size() + 1);
  } else if (kind == Kind::move) {
    const std::string parent = place_among_siblings(sample.tree, edit.pointer).first;
    edit.index = drawn(random, sample.tree.at(Pointer(parent)).size());
  }
  return edit;
}

TextChanges changes_of(const Sample& sample, const JsonDocument& document, const Edit& edit) {
  switch (edit.kind) {
    case Kind::set:
      return set_value(document, edit.pointer, edit.value);
    case Kind::remove:
      return remove_entry(document, edit.pointer);
    case Kind::move:
      return move_entry(document, edit.pointer, edit.index);
    case Kind::duplicate:
      return duplicate_entry(document, edit.pointer, kNewKey);
    case Kind::insert:
      break;
  }
  const Tree& container = sample.tree.at(Pointer(edit.pointer));
  if (container.is_array()) return insert_entry(document, edit.pointer, edit.index, edit.value);
  std::vector<std::string> keys{};
  for (const auto& [key, member] : container.items()) keys.push_back(key);
  std::vector<std::string_view> order(keys.begin(), keys.end());
  order.insert(order.begin() + static_cast<std::ptrdiff_t>(edit.index), kNewKey);
  return insert_member(document, edit.pointer, kNewKey, edit.value, order);
}

/// The pointer of the value that the edit changes, and this value after the edit, with the order of its members.
std::pair<Pointer, Tree> expected_value(const Tree& tree, const Edit& edit) {
  if (edit.kind == Kind::set) return {Pointer(edit.pointer), Tree::parse(edit.value)};
  std::string parent = edit.pointer;
  std::size_t index = edit.index;
  if (edit.kind != Kind::insert) {
    std::tie(parent, index) = place_among_siblings(tree, edit.pointer);
  }
  const Tree& container = tree.at(Pointer(parent));
  std::vector<std::pair<std::string, Tree>> entries{};
  for (const auto& [key, member] : container.items()) entries.emplace_back(key, member);
  const auto at = [&entries](std::size_t i) {
    return entries.begin() + static_cast<std::ptrdiff_t>(i);
  };
  if (edit.kind == Kind::insert) {
    entries.insert(at(index), {kNewKey, Tree::parse(edit.value)});
  } else if (edit.kind == Kind::duplicate) {
    const Tree copy = entries[index].second;
    entries.insert(at(index + 1), {kNewKey, copy});
  } else {
    const std::pair<std::string, Tree> entry = entries[index];
    entries.erase(at(index));
    if (edit.kind == Kind::move) entries.insert(at(edit.index), entry);
  }
  Tree result = container.is_array() ? Tree::array() : Tree::object();
  for (auto& [key, member] : entries) {
    if (container.is_array()) {
      result.push_back(std::move(member));
    } else {
      result[key] = std::move(member);
    }
  }
  return {Pointer(parent), std::move(result)};
}

const std::vector<Kind> kKinds{Kind::set, Kind::insert, Kind::remove, Kind::move, Kind::duplicate};

/// Calls `check(sample, document, edit)` for random edits of these kinds in every text.
template <class Check>
void for_random_edits(std::string_view name, std::size_t edits_per_text,
                      const std::vector<Kind>& kinds, const Check& check) {
  Random random = Random(20261129).split(name);
  for (const Sample& sample : samples()) {
    const JsonDocument document(sample.text, "a.json");
    for (std::size_t i = 0; i < edits_per_text && !testing::Test::HasFailure(); ++i) {
      check(sample, document, drawn_edit(sample, kinds[drawn(random, kinds.size())], random));
    }
  }
}

TEST(RandomEdits, GiveTheTreeOfTheSameEditOfTheTree) {
  EXPECT_GE(samples().size() * kEditsPerText, 1000U);
  for_random_edits(
      "tree", kEditsPerText, kKinds,
      [](const Sample& sample, const JsonDocument& document, const Edit& edit) {
        Tree read = Tree::parse(changed(sample.text, changes_of(sample, document, edit)));
        const auto [place, expected] = expected_value(sample.tree, edit);
        EXPECT_EQ(read.at(place), expected) << static_cast<int>(edit.kind) << ' ' << edit.pointer;
        read.at(place) = sample.tree.at(place);
        EXPECT_EQ(read, sample.tree) << static_cast<int>(edit.kind) << ' ' << edit.pointer;
      });
}

/// The entry in such a piece of a text, as an object or a list with this entry alone.
Tree entry_in(std::string piece, bool is_member) {
  piece.erase(0, piece.find_first_not_of(" \t\r\n"));
  piece.erase(piece.find_last_not_of(" \t\r\n") + 1);
  if (piece.starts_with(',')) {
    piece.erase(0, 1);
  } else if (piece.ends_with(',')) {
    piece.pop_back();
  }
  return Tree::parse(is_member ? '{' + piece + '}' : '[' + piece + ']', nullptr, false);
}

/// Whether `longer` is `shorter` with one further piece: this entry, one comma at most, and white space.
bool has_further(const std::string& longer, const std::string& shorter, const Tree& entry) {
  if (longer.size() <= shorter.size()) return false;
  const std::size_t length = longer.size() - shorter.size();
  const auto same = std::mismatch(shorter.begin(), shorter.end(), longer.begin()).first;
  // Where the neighbours begin alike, the piece can begin earlier than the first difference.
  for (auto from = static_cast<std::size_t>(same - shorter.begin()) + 1; from-- > 0;) {
    if (longer.compare(from + length, std::string::npos, shorter, from) != 0) return false;
    if (entry_in(longer.substr(from, length), entry.is_object()) == entry) return true;
  }
  return false;
}

Tree alone(bool is_member, const std::string& key, const Tree& value) {
  if (!is_member) return Tree::array({value});
  Tree object = Tree::object();
  object[key] = value;
  return object;
}

TEST(RandomEdits, ChangeNothingButTheEntryAndOneComma) {
  const auto check = [](const Sample& sample, const JsonDocument& document, const Edit& edit) {
    const TextChanges changes = changes_of(sample, document, edit);
    const std::string text = changed(sample.text, changes);
    const Tree& target = sample.tree.at(Pointer(edit.pointer));
    const bool is_insertion = edit.kind == Kind::insert;
    const bool is_member = is_insertion
                               ? target.is_object()
                               : sample.tree.at(Pointer(edit.pointer).parent_pointer()).is_object();
    if (edit.kind == Kind::set) {
      if (target == Tree::parse(edit.value)) {
        EXPECT_EQ(text, sample.text);
        return;
      }
      const std::size_t from = document.place_of(edit.pointer)->value;
      ASSERT_TRUE(text.starts_with(sample.text.substr(0, from) + edit.value)) << edit.pointer;
      const std::string rest = text.substr(from + edit.value.size());
      ASSERT_TRUE(sample.text.ends_with(rest));
      EXPECT_EQ(Tree::parse(sample.text.substr(from, sample.text.size() - rest.size() - from)),
                target);
    } else if (edit.kind == Kind::remove) {
      const Tree removed = alone(is_member, Pointer(edit.pointer).back(), target);
      EXPECT_TRUE(has_further(sample.text, text, removed)) << edit.pointer;
    } else if (edit.kind == Kind::move) {
      ASSERT_EQ(text.size(), sample.text.size());
      for (const TextChange& change : changes) {
        std::string before = sample.text.substr(change.offset, change.length);
        std::string after = text.substr(change.offset, change.length);
        EXPECT_TRUE(std::is_permutation(before.begin(), before.end(), after.begin(), after.end()));
      }
    } else {
      const Tree added = alone(is_member, kNewKey, is_insertion ? Tree::parse(edit.value) : target);
      EXPECT_TRUE(has_further(text, sample.text, added)) << edit.pointer;
    }
  };
  for_random_edits("outside", kEditsPerText, kKinds, check);
}

TEST(RandomEdits, InsertedThenRemovedGiveTheSameBytes) {
  for_random_edits(
      "remove", kReversedPerText, {Kind::insert, Kind::duplicate},
      [](const Sample& sample, const JsonDocument& document, const Edit& edit) {
        const std::string text = changed(sample.text, changes_of(sample, document, edit));
        auto [container, index] = edit.kind == Kind::insert
                                      ? std::pair(edit.pointer, edit.index)
                                      : place_among_siblings(sample.tree, edit.pointer);
        if (edit.kind == Kind::duplicate) ++index;
        const bool is_array = sample.tree.at(Pointer(container)).is_array();
        const std::string added =
            is_array ? pointer_to(container, index) : pointer_to(container, kNewKey);
        EXPECT_EQ(changed(text, remove_entry(JsonDocument(text, {}), added)), sample.text) << added;
      });
}

TEST(RandomEdits, SetOrMovedAndBackGiveTheSameBytes) {
  for_random_edits(
      "back", kReversedPerText, {Kind::set, Kind::move},
      [](const Sample& sample, const JsonDocument& document, const Edit& edit) {
        const std::string text = changed(sample.text, changes_of(sample, document, edit));
        const JsonDocument other(text, {});
        TextChanges back{};
        if (edit.kind == Kind::set) {
          const JsonPlace place = document.place_of(edit.pointer).value();
          back =
              set_value(other, edit.pointer,
                        std::string_view(sample.text).substr(place.value, place.end - place.value));
        } else {
          const auto [container, index] = place_among_siblings(sample.tree, edit.pointer);
          const bool is_array = sample.tree.at(Pointer(container)).is_array();
          back =
              move_entry(other, is_array ? pointer_to(container, edit.index) : edit.pointer, index);
        }
        EXPECT_EQ(changed(text, back), sample.text) << edit.pointer;
      });
}

TEST(RandomEdits, OfAValueToItselfChangeNothing) {
  for_random_edits("itself", kEditsPerText, {Kind::set},
                   [](const Sample& sample, const JsonDocument& document, const Edit& edit) {
                     const std::string same = sample.tree.at(Pointer(edit.pointer)).dump(1);
                     EXPECT_TRUE(set_value(document, edit.pointer, same).empty()) << edit.pointer;
                   });
}

TEST(RandomEdits, OfANameChangeItsUsesOnly) {
  Random random = Random(20261129).split("rename");
  constexpr const char* kNewName = "a_new_name";
  std::size_t count = 0;
  for (const Sample& sample : samples()) {
    const JsonDocument document(sample.text, "a.json");
    const ProtocolNames names = names_in(document.root());
    for (std::size_t i = 0; i < kReversedPerText && !HasFailure(); ++i) {
      const NameUse& use = names.uses[drawn(random, names.uses.size())];
      std::string text{};
      try {
        text = changed(sample.text, rename(document, use.registry, use.name, kNewName));
      } catch (const ProtocolError&) {
        continue;  // a name of the program
      }
      ++count;
      const JsonDocument other(text, {});
      const std::string back = changed(text, rename(other, use.registry, kNewName, use.name));
      EXPECT_EQ(back, sample.text) << use.pointer;
      for (std::size_t at = 0; (at = text.find(kNewName, at)) != std::string::npos;) {
        text.replace(at, std::string_view(kNewName).size(), use.name);
      }
      EXPECT_EQ(text, sample.text) << use.pointer;
    }
  }
  EXPECT_GT(count, samples().size() * kReversedPerText / 2);
}

}  // namespace
}  // namespace asperity
