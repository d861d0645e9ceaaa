// Declares the elements of an XML file.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// An element with its text and the elements within it; attributes, comments and processing instructions are left out.
struct XmlElement {
  std::string name{};
  std::string text{};    ///< of the element itself, without spaces at its ends
  std::size_t line = 0;  ///< of its beginning, from 1
  std::vector<XmlElement> children{};

  /// The first child of this name; null without one.
  const XmlElement* child(std::string_view child_name) const noexcept;
};

/// Reads the root element of an XML file as far as tables of numbers need it: entities are kept as they are written, and there are
/// no namespaces. `name` names it in messages.
///
/// Errors: std::invalid_argument that begins with `name` and the line, for an element that is not closed, a mark that is not
/// complete, a document type, and nesting of more than 32 elements.
XmlElement xml_root_in(std::string_view xml, const std::string& name);

}  // namespace asperity
