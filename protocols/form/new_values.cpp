// Implements the simplest values of shapes.

#include "protocols/form/new_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocols/form/offered_names.h"
#include "protocols/shapes/key.h"

namespace asperity {

namespace {

using nlohmann::ordered_json;

ordered_json number_of(const NumberShape& shape) {
  constexpr double kInside = 0.5;  // of a range without its ends
  double number = 0.0;
  if (!lies_within(shape, number)) {
    if (shape.minimum) {
      number = *shape.minimum;
    } else if (shape.above) {
      const double step = shape.below ? kInside * (*shape.below - *shape.above)
                                      : std::min(1.0, shape.maximum.value_or(1.0) - *shape.above);
      number = *shape.above + step;
    } else {
      number = shape.maximum.value_or(0.0);
    }
  }
  if (shape.is_whole) return static_cast<std::int64_t>(std::ceil(number));
  return number;
}

/// Whether a factor that is named here gets its level in each trial from the block or the flow.
bool sets_levels(const std::string& pointer) {
  if (pointer.starts_with("/flow/")) return true;
  constexpr std::array<std::string_view, 4> kSetting{"/crossed", "/listed", "/drawn", "/all_pairs"};
  return pointer.starts_with("/blocks/") &&
         std::any_of(kSetting.begin(), kSetting.end(), [&pointer](std::string_view key) {
           return pointer.find(key) != std::string::npos;
         });
}

struct NewValue {
  const ProtocolNames& names;

  ordered_json operator()(const NumberShape& shape) const { return number_of(shape); }
  ordered_json operator()(const TruthShape&) const { return true; }
  ordered_json operator()(const WordShape& shape) const { return shape.words.front().name; }
  ordered_json operator()(const TextShape& shape) const {
    if (!shape.name.registry.empty()) return named(shape.name);
    if (!shape.pattern.empty()) return "new";
    return "";  // refused by the check where a text is required
  }
  ordered_json operator()(const NameShape& shape) const { return named(shape); }
  ordered_json operator()(const ListShape& shape) const {
    ordered_json list = ordered_json::array();
    for (std::size_t i = 0; i < std::max<std::size_t>(shape.shortest, 1); ++i) {
      list.push_back(i == 0 ? std::visit(*this, *shape.entry) : another(*shape.entry, list));
    }
    return list;
  }
  ordered_json operator()(const MapShape& shape) const {
    ordered_json map = ordered_json::object();
    if (shape.shortest > 0) {
      map[named(shape.key).get<std::string>()] = std::visit(*this, *shape.entry);
    }
    return map;
  }
  ordered_json operator()(const ObjectShape& shape) const {
    const KeyTable& table = *shape.table;
    ordered_json object = ordered_json::object();
    for (const ProtocolKey& key : table.keys) {
      const bool decides = !table.deciding.empty() && key.name == table.deciding.front();
      if (key.is_required || decides) object[std::string(key.name)] = std::visit(*this, key.shape);
    }
    if (object.empty() && !table.may_be_empty) {
      object[std::string(table.keys.front().name)] = std::visit(*this, table.keys.front().shape);
    }
    return object;
  }
  ordered_json operator()(const BoundShape& shape) const { return std::visit(*this, *shape.value); }
  ordered_json operator()(const FormsShape& shape) const {
    return std::visit(*this, shape.forms.front());
  }

  /// The first name of the registry, of the groups the one with the fewest texts; of a declaration, a name that is free. The
  /// factor of the groups is one that neither blocks nor the flow set; if there is none, its name is empty.
  ordered_json named(const NameShape& shape) const {
    std::vector<std::string> known = offered_names(names, shape);
    if (shape.levels == kGroupNames) {
      std::erase_if(known, [this](const std::string& factor) { return is_set(factor); });
      return known.empty() ? std::string() : known.front();
    }
    if (shape.registry == kGroupNames && !known.empty()) return least_used(known);
    if (!shape.is_declared && !known.empty()) return known.front();
    return free_name(known, "new");
  }
  /// One of the names that the list does not have, if there is one.
  ordered_json another(const ValueShape& entry, const ordered_json& list) const {
    if (const auto* const name = std::get_if<NameShape>(&entry)) {
      for (const std::string& one : offered_names(names, *name)) {
        if (std::find(list.begin(), list.end(), one) == list.end()) return one;
      }
    }
    return std::visit(*this, entry);
  }
  std::string least_used(const std::vector<std::string>& groups) const {
    return *std::ranges::min_element(groups, {}, [this](const std::string& group) {
      return std::ranges::count_if(names.uses, [&](const NameUse& use) {
        return use.registry == names.groups && use.name == group;
      });
    });
  }
  bool is_set(const std::string& factor) const {
    return std::ranges::any_of(names.uses, [&factor](const NameUse& use) {
      return use.registry == kFactorNames && use.name == factor && !use.is_declared &&
             sets_levels(use.pointer);
    });
  }
};

}  // namespace

std::string free_name(std::string_view wish,
                      const std::function<bool(const std::string& name)>& is_taken) {
  std::string name(wish);
  for (int number = 2; is_taken(name); ++number) {
    name = std::string(wish) + "_" + std::to_string(number);
  }
  return name;
}

std::string free_name(const std::vector<std::string>& names, std::string_view wish) {
  return free_name(wish, [&names](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  });
}

std::vector<std::string> declared_names(const ProtocolNames& names, std::string_view registry) {
  if (registry == kGroupNames) {
    std::vector<std::string> groups = declared_names(names, names.groups);
    groups.insert(groups.end(), names.numbers_of_groups.begin(), names.numbers_of_groups.end());
    return groups;
  }
  std::vector<std::string> declared{};
  for (const NameUse& use : names.uses) {
    if (!use.is_declared || use.registry != registry) continue;
    if (std::ranges::find(declared, use.name) == declared.end()) declared.push_back(use.name);
  }
  return declared;
}

ordered_json new_value(const ValueShape& shape, const ProtocolNames& names) {
  return std::visit(NewValue{names}, shape);
}

}  // namespace asperity
