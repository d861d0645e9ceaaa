// Implements the replacement of textures by edits of the text.

#include "protocols/form/own_textures.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "protocols/design/json_pointer.h"
#include "protocols/editing/edits.h"
#include "protocols/editing/renaming.h"
#include "protocols/editing/text_entries.h"
#include "protocols/form/form_edits.h"
#include "protocols/keys/names_in.h"
#include "protocols/shapes/key.h"

namespace asperity {

namespace {

using nlohmann::json;

constexpr std::string_view kTextures = "textures";
constexpr const char* kTemplate = "the protocol of the template";
/// What a texture of the template keeps in the study: how it is called in plots and rendered.
constexpr std::array<std::string_view, 2> kKept{"code", "height_field"};

std::vector<std::string> texture_names(const std::string& text) {
  const JsonDocument protocol(text, kTemplate);
  std::vector<std::string> names{};
  if (!protocol.root().contains(kTextures)) return names;
  const TextContainer textures(protocol, pointer_to("", kTextures));
  for (const TextEntry& entry : textures.entries()) {
    if (!is_comment(entry.key)) names.push_back(entry.key);
  }
  return names;
}

/// All places that name the texture, also as a level.
std::vector<NameUse> uses_of_texture(const JsonDocument& protocol, std::string_view name) {
  return uses_of(names_in(protocol.root()), std::string(kTextures), name);
}

/// The entry of a list that a place belongs to; nullopt if it is in none.
std::optional<std::string> list_entry_around(const json& root, const std::string& pointer) {
  for (json::json_pointer path(pointer); !path.empty(); path.pop_back()) {
    if (root.at(path.parent_pointer()).is_array()) return path.to_string();
  }
  return {};
}

/// Without the texture and the entries of lists that refer to it. Other places, such as the level of an anchor, name
/// `remaining` in its place.
std::string without_texture(std::string text, const std::string& name,
                            const std::string& remaining) {
  const JsonDocument protocol(text, kTemplate);
  std::vector<std::string> removed{};
  for (const NameUse& use : uses_of_texture(protocol, name)) {
    if (use.is_key) {
      removed.push_back(use.pointer);
    } else if (const auto entry = list_entry_around(protocol.root(), use.pointer)) {
      removed.push_back(*entry);
    } else if (!use.is_in_formula) {
      text = with_value(JsonDocument(text, kTemplate), use.pointer, json_string(remaining)).text;
    }
  }
  std::sort(removed.begin(), removed.end());
  removed.erase(std::unique(removed.begin(), removed.end()), removed.end());
  return without(JsonDocument(text, kTemplate), removed).text;
}

/// With a copy of the texture behind it, and of the entries that are its name.
std::string with_copied_texture(const std::string& text, const std::string& name,
                                const std::string& copy) {
  const JsonDocument protocol(text, kTemplate);
  std::string copied =
      changed(text, duplicate_entry(protocol, pointer_to(pointer_to("", kTextures), name), copy));
  std::vector<NameUse> uses = uses_of_texture(protocol, name);
  std::reverse(uses.begin(), uses.end());  // places before an insertion keep their pointers
  for (const NameUse& use : uses) {
    const json::json_pointer path(use.pointer);
    if (use.is_key || !protocol.root().at(path.parent_pointer()).is_array()) continue;
    const JsonDocument present(copied, kTemplate);
    copied = changed(copied, insert_entry(present, path.parent_pointer().to_string(),
                                          std::stoul(path.back()) + 1, json_string(copy)));
  }
  return copied;
}

std::string renamed(const std::string& text, const std::string& name, const std::string& after) {
  return changed(text, rename(JsonDocument(text, kTemplate), std::string(kTextures), name, after));
}

/// The files of the texture are those of the study. Its code is its position: that of a copy would occur twice.
std::string with_files(std::string text, const OwnTexture& texture, std::size_t position) {
  const std::string place = pointer_to(pointer_to("", kTextures), texture.name);
  std::vector<std::string> others{};
  const JsonDocument protocol(text, kTemplate);
  const json before = protocol.root().at(json::json_pointer(place));
  for (const auto& [key, value] : before.items()) {
    const bool is_kept = std::find(kKept.begin(), kKept.end(), key) != kKept.end();
    if (!is_kept) others.push_back(pointer_to(place, key));
  }
  text = without(protocol, others).text;
  const auto set = [&](std::string_view key, const json& value) {
    text = with_value(JsonDocument(text, kTemplate), pointer_to(place, key), value.dump()).text;
  };
  if (before.contains("code")) set("code", "T" + std::to_string(position + 1));
  if (before.contains("spacing_m") && texture.spacing_m) set("spacing_m", *texture.spacing_m);
  set("height_field", texture.height_field);
  if (!texture.picture.empty()) set("picture", texture.picture);
  set("true_height_field", texture.height_field);  // what virtual participants expect
  return text;
}

/// Without what the template states of its own textures in words: its description, and the meanings of the factors that have
/// this one as a level.
std::string without_statements(const std::string& text, const std::string& texture) {
  const JsonDocument protocol(text, kTemplate);
  std::vector<std::string> removed{"/description"};
  for (const NameUse& use : uses_of_texture(protocol, texture)) {
    const json::json_pointer list = json::json_pointer(use.pointer).parent_pointer();
    if (list.back() == "levels") removed.push_back((list.parent_pointer() / "meaning").to_string());
  }
  std::erase_if(removed, [&protocol](const std::string& one) {
    return !protocol.root().contains(json::json_pointer(one));
  });
  return without(protocol, removed).text;
}

/// The value of the key, or an empty one.
const json& member(const json& object, std::string_view key) {
  static const json kNone = json::object();
  const auto found = object.find(key);
  return found == object.end() ? kNone : *found;
}

/// The factors whose levels are the textures.
std::vector<std::string> texture_factors(const json& root) {
  const ProtocolNames names = names_in(root);
  std::vector<std::string> factors{};
  for (const auto& [factor, declared] : member(root, "factors").items()) {
    const std::pair<std::string, std::string> link{levels_of(factor), kTextures};
    if (std::ranges::find(names.links, link) != names.links.end()) factors.push_back(factor);
  }
  return factors;
}

/// With orders and criteria that blocks can have with `textures` levels in place of `before`, which are more. One level always
/// follows itself; at a distance of their number, levels would only follow in turn; and a criterion needs its trials.
std::string with_possible_orders(std::string text, std::size_t textures, std::size_t before) {
  const json root = json::parse(text);
  const auto set = [&text](const json::json_pointer& place, const json& value) {
    text = with_value(JsonDocument(text, kTemplate), place.to_string(), value.dump()).text;
  };
  const auto remove = [&text](const json::json_pointer& place) {
    text = without(JsonDocument(text, kTemplate), std::array{place.to_string()}).text;
  };
  for (const std::string& factor : texture_factors(root)) {
    for (const auto& [name, block] : member(root, "blocks").items()) {
      const json::json_pointer place = json::json_pointer("/blocks") / name;
      for (const char* const order : {"maximum_in_a_row", "minimum_distance"}) {
        const json::json_pointer own = json::json_pointer("") / order / factor;
        if (!block.contains(own)) continue;
        const bool is_distance = order == std::string_view("minimum_distance");
        const std::size_t farthest = textures - 1;  // that leaves a choice
        if (textures == 1 || (is_distance && farthest == 1)) {
          remove(block.at(order).size() == 1 ? place / order : place / order / factor);
        } else if (is_distance && block.at(own) > farthest) {
          set(place / order / factor, farthest);
        }
      }
      const json& crossed = member(block, "crossed");
      const bool is_crossed = std::ranges::find(crossed, json(factor)) != crossed.end();
      if (is_crossed && block.contains("until")) {
        const std::size_t repetitions = block.value("repetitions", 1U);
        set(place / "repetitions", (repetitions * before + textures - 1) / textures);
      }
    }
  }
  return text;
}

}  // namespace

std::string with_textures(const JsonDocument& protocol, std::span<const OwnTexture> textures) {
  std::string text(protocol.text());
  std::vector<std::string> names = texture_names(text);
  if (names.empty() || textures.empty()) return text;
  text = without_statements(text, names.front());
  const std::size_t before = names.size();
  while (names.size() < textures.size()) {
    names.push_back("texture_of_the_study_" + std::to_string(names.size()));
    text = with_copied_texture(text, names[names.size() - 2], names.back());
  }
  const std::string& middle = names[textures.size() / 2];  // in the order of the template
  for (std::size_t i = textures.size(); i < names.size(); ++i) {
    text = without_texture(std::move(text), names[i], middle);
  }
  // In two steps, because a texture can have the name of another one of the template.
  for (std::size_t i = 0; i < textures.size(); ++i) {
    text = renamed(text, names[i], "renamed_texture_" + std::to_string(i));
  }
  for (std::size_t i = 0; i < textures.size(); ++i) {
    text = renamed(text, "renamed_texture_" + std::to_string(i), textures[i].name);
    text = with_files(std::move(text), textures[i], i);
  }
  if (textures.size() < before) text = with_possible_orders(text, textures.size(), before);
  // Features that the template states of its textures are those of no other texture.
  const json::json_pointer expectation("/observer/expectation");
  const JsonDocument made(text, kTemplate);
  const bool is_stated =
      made.root().contains(expectation) && made.root().at(expectation) == "prior";
  if (!is_stated) return text;
  return with_value(made, expectation.to_string(), json_string("true_surface")).text;
}

}  // namespace asperity
