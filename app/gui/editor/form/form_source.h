// Declares the text that a form shows, and what its fields offer.

#pragma once

#include <string>
#include <vector>

#include <QtCore/QString>
#include <QtCore/QStringList>
#include <nlohmann/json_fwd.hpp>

#include "protocols/file/json_document.h"
#include "protocols/keys/names_in.h"
#include "protocols/shapes/key.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// A text that is JSON, whether or not it is a valid protocol.
class FormSource final {
 public:
  /// `models` outlives it. Errors: ProtocolError for a text that is no JSON.
  FormSource(std::string text, const std::vector<ModelDeclaration>& models);
  FormSource(const FormSource&) = delete;
  FormSource& operator=(const FormSource&) = delete;

  const JsonDocument& document() const noexcept { return document_; }
  const ProtocolNames& names() const noexcept { return names_; }
  /// Null if there is no value.
  const nlohmann::json* find(const std::string& pointer) const;
  /// The characters of a value.
  std::string_view characters(const std::string& pointer) const;

  /// The names that a reference can have here; of a level those of what it can be, such as textures.
  QStringList names_for(const NameShape& shape, const std::string& pointer) const;
  /// What a name that follows from the blocks means, in the language of the windows; empty where nothing states it.
  QString meaning_of_name(const NameShape& shape, const QString& name) const;
  /// The number of other places with the name that is declared by the value.
  std::size_t references_to(const std::string& pointer) const;
  /// The parameter of a force model whose value is at `pointer`; null elsewhere and for unknown names.
  const Parameter* parameter_at(const std::string& pointer) const;
  /// The parameters of the force models that the stimulus with these parameters can have.
  std::vector<const Parameter*> parameters_of(const std::string& stimulus) const;

 private:
  QStringList names_of_level(const std::string& levels) const;

  std::string text_{};
  JsonDocument document_;
  ProtocolNames names_{};
  const std::vector<ModelDeclaration>& models_;
};

/// The pointer to the same value where keys around it have other names: a key of `before` is taken for the one at its position
/// in an object of the same size that has the first no more. Otherwise unchanged.
std::string renamed_pointer(const JsonDocument& before, const JsonDocument& after,
                            const std::string& pointer);

/// The meaning of a key, and where it belongs to it that of every word.
QString meaning_of_key(const ProtocolKey& key);

}  // namespace asperity
