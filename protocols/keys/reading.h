// Declares the reading of an object by the table of its keys.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocols/keys/valid_part.h"
#include "protocols/shapes/key.h"

namespace asperity {

/// Stores the part of the object at `pointer` that has the form of the table, and returns the problems of the rest: what
/// was not read. This is the one reader of files, of the valid rest of invalid ones, and of stored protocols.
template <class Owner>
std::vector<FormProblem> read_keys(const KeyTableOf<Owner>& table, const nlohmann::json& object,
                                   const std::string& pointer, Owner& owner) {
  ValidPart part = valid_part(object, table, pointer);
  if (part.value) read_keys(table, *part.value, static_cast<void*>(&owner));
  return std::move(part.problems);
}

}  // namespace asperity
