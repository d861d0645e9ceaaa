// What a key of a protocol means, from the schema and the declarations of the force models.

#pragma once

#include <optional>
#include <vector>

#include <QtCore/QCoreApplication>
#include <QtCore/QString>
#include <QtCore/QStringList>
#include <nlohmann/json_fwd.hpp>

#include "stimuli/properties/parameter.h"

namespace asperity {

struct KeyHelp {
  QString key{};
  QString meaning{};
  QString form{};  ///< type, range, whether it is required, default: "number · from 0 to 85"
};

class SchemaHelp final {
  Q_DECLARE_TR_FUNCTIONS(asperity::SchemaHelp)
 public:
  explicit SchemaHelp(std::vector<ModelDeclaration> models);

  /// Of the key that a place (see json_place) ends in; of an entry of a list, what the entry is.
  /// Nothing where the format knows no such key.
  std::optional<KeyHelp> of(const QStringList& place) const;

 private:
  const nlohmann::json& resolved(const nlohmann::json& node) const;
  /// What the schema says of one key or entry; null where it says nothing.
  const nlohmann::json* below(const nlohmann::json& node, const std::string& key) const;
  std::optional<KeyHelp> of_parameter(const QString& name) const;

  std::vector<ModelDeclaration> models_;
};

}  // namespace asperity
