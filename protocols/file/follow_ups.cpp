// Implements the removal of consequences by correcting one value at a time and checking the meaning again.

#include "protocols/file/follow_ups.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "protocols/design/wording.h"
#include "protocols/file/form_check.h"
#include "protocols/file/meaning/meaning.h"
#include "protocols/file/protocol_from_json.h"
#include "protocols/shapes/key.h"

namespace asperity {

namespace {

using nlohmann::json;

/// A check of a protocol takes milliseconds, and the editor waits for it.
constexpr int kMostCorrections = 16;
constexpr int kMostNames = 3;  // similar ones, which may be those of something else

const json* value_at(const json& root, const std::string& pointer) {
  const json::json_pointer at(pointer);
  return root.contains(at) ? &root.at(at) : nullptr;
}

/// Keys and values; values of numbers and sentences are none.
void add_names(const json& value, std::set<std::string>& names) {
  if (value.is_string() && is_name(value.get_ref<const std::string&>())) names.insert(value);
  if (!value.is_structured()) return;
  for (const auto& [key, member] : value.items()) {
    if (value.is_object() && is_name(key)) names.insert(key);
    add_names(member, names);
  }
}

/// The same problem, although the names that it lists for a choice may have changed.
bool is_same(const Diagnostic& a, const Diagnostic& b) {
  const auto statement = [](const Diagnostic& problem) {
    const std::string sentence = problem.message.english();
    return sentence.substr(0, sentence.find("; "));
  };
  return a.pointer == b.pointer && statement(a) == statement(b);
}

bool contains(const std::vector<Diagnostic>& problems, const Diagnostic& sought) {
  return std::any_of(problems.begin(), problems.end(),
                     [&sought](const Diagnostic& problem) { return is_same(problem, sought); });
}

/// With another value a problem at its place has other words.
bool is_corrected(const std::string& pointer, const std::vector<Diagnostic>& problems) {
  return std::none_of(problems.begin(), problems.end(),
                      [&pointer](const Diagnostic& problem) { return problem.pointer == pointer; });
}

class Corrections final {
 public:
  Corrections(const JsonDocument& document, const std::vector<ModelDeclaration>& models)
      : document_(document), models_(models) {
    std::set<std::string> names{};
    add_names(document.root(), names);
    for (const ModelDeclaration& model : models) names.insert(model.id);
    names_.assign(names.begin(), names.end());
  }

  /// What may have been meant by the value at a problem, the most probable first.
  std::vector<json> of(const Diagnostic& problem, const std::vector<Diagnostic>& all) const {
    const json* const value = value_at(document_.root(), problem.pointer);
    if (value == nullptr || value->is_structured()) return {};
    std::vector<json> meant{};
    if (value->is_string()) {
      const auto& text = value->get_ref<const std::string&>();
      const json number = json::parse(text, nullptr, false);
      if (number.is_number()) meant.push_back(number);
      std::vector<std::string> others = names_;
      std::erase(others, text);
      for (int i = 0; i < kMostNames; ++i) {
        const auto nearest = nearest_name(text, others);
        if (!nearest) break;
        meant.emplace_back(*nearest);
        std::erase(others, *nearest);
      }
    }
    for (const Diagnostic& other : all) {
      const json* const named = value_at(document_.root(), other.pointer);
      if (named != nullptr && named->is_string() && *named != *value &&
          std::find(meant.begin(), meant.end(), *named) == meant.end()) {
        meant.push_back(*named);
      }
    }
    return meant;
  }

  /// The problems with another value; nullopt if it does not have the required form.
  std::optional<std::vector<Diagnostic>> problems_with(const std::string& pointer,
                                                       const json& value) const {
    json root = document_.root();
    root.at(json::json_pointer(pointer)) = value;
    if (!has_form_of_protocol(root)) return {};
    const JsonDocument corrected = document_.with_root(root);
    return check_meaning(protocol_from_json(root, models_), corrected, models_);
  }

 private:
  const JsonDocument& document_;
  const std::vector<ModelDeclaration>& models_;
  std::vector<std::string> names_{};
};

}  // namespace

std::vector<std::string> declared_names(const json& root) {
  std::vector<std::string> names{};
  for (const auto& [key, registry] : root.items()) {
    if (!registry.is_object() ||
        !std::all_of(registry.begin(), registry.end(),
                     [](const json& entry) { return entry.is_object(); })) {
      continue;
    }
    for (const auto& [name, entry] : registry.items()) {
      if (is_name(name)) names.push_back(name);
    }
  }
  return names;
}

std::vector<Diagnostic> without_follow_ups(std::vector<Diagnostic> problems,
                                           const JsonDocument& document,
                                           const std::vector<ModelDeclaration>& models) {
  if (problems.size() < 2) return problems;
  const Corrections corrections(document, models);
  int tried = 0;
  for (std::size_t i = 0; i < problems.size() && problems.size() > 1; ++i) {
    const Diagnostic cause = problems[i];
    std::optional<std::vector<Diagnostic>> rest{};  // with the correction that leaves the least
    for (const json& value : corrections.of(cause, problems)) {
      if (++tried > kMostCorrections || (rest && rest->empty())) break;
      auto found = corrections.problems_with(cause.pointer, value);
      if (!found || !is_corrected(cause.pointer, *found)) continue;
      if (!rest || found->size() < rest->size()) rest = std::move(found);
    }
    if (!rest) continue;
    std::erase_if(problems, [&](const Diagnostic& other) {
      return !is_same(other, cause) && !contains(*rest, other);
    });
    // Those before the cause may be among the removed ones.
    i = static_cast<std::size_t>(
        std::find_if(problems.begin(), problems.end(),
                     [&cause](const Diagnostic& other) { return is_same(other, cause); }) -
        problems.begin());
  }
  return problems;
}

}  // namespace asperity
