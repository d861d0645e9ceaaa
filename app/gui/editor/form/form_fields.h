// Declares the fields for values on one line of a form, or in one box.

#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "app/gui/editor/form/form_part.h"
#include "protocols/shapes/key.h"

namespace asperity {

/// The key of a value: without one (null) it is an entry of a list or a map.
struct FieldOf {
  const ProtocolKey* key = nullptr;
  /// The default of the key; null if there is none.
  nlohmann::json standard() const;
  /// An emptied field is the key without its value.
  bool may_be_absent() const noexcept { return key != nullptr && !key->is_required; }
};

/// Whether a field can show values of the shape; `value` is the present one, null if there is none.
bool has_field(const ValueShape& shape, const nlohmann::json* value);

/// A word as a choice shows it, with its meaning.
QString shown_word(const KeyWord& word);
/// The numbers that a parameter of a force model can have.
NumberShape number_shape(const Parameter& parameter);

/// A field for the shape, for which `has_field` is true.
FormPart* make_field(FormContext& context, const ValueShape& shape, const FieldOf& of,
                     const std::string& pointer, QWidget* parent);

/// A field of one line for a name that is declared by the key of the member at `pointer`.
FormPart* make_key_field(FormContext& context, const std::string& pointer, QWidget* parent);

}  // namespace asperity
