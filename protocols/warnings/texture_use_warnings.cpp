// Compares the textures with the names in the protocol, and the listed trials of a block with each other.

#include "protocols/warnings/texture_use_warnings.h"

#include <algorithm>
#include <cstddef>

#include <nlohmann/json.hpp>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/keys/names_in.h"
#include "protocols/plan/block_rows.h"

namespace asperity {

namespace {

using Block = Protocol::Block;

bool states_repetitions(const Block& block, const FactorLevels& row) {
  return std::ranges::any_of(block.repetitions_of, [&row](const Block::RowRepetitions& stated) {
    return has_levels(row, stated.levels);
  });
}

class TextureUseWarnings final {
 public:
  TextureUseWarnings(const Protocol& protocol, const std::string& file_name)
      : protocol_(protocol), document_(protocol.source, file_name) {}

  std::vector<Diagnostic> all() {
    warn_of_unused_textures();
    for (const auto& [name, block] : protocol_.blocks) {
      // A fixed order is a sequence of trials, in which one may return.
      if (block.order != Block::Order::fixed) warn_of_equal_rows(block);
    }
    return std::move(found_);
  }

 private:
  void warn_of_unused_textures() {
    const ProtocolNames names = names_in(nlohmann::json::parse(protocol_.source));
    for (const auto& [name, texture] : protocol_.textures) {
      const std::string pointer = pointer_to("/textures", name);
      const NameUse* const declared = declaration_at(names, pointer, true);
      if (declared == nullptr || uses_of(names, declared->registry, name).size() > 1) continue;
      found_.push_back(
          document_.at(pointer, phrase("Protocols",
                                       "no stimulus, level, question or body uses the texture %1; "
                                       "use it, or remove it")
                                    .with(in_quotes(name))));
    }
  }

  void warn_of_equal_rows(const Block& block) {
    const std::string pointer = pointer_to("/blocks", block.name) + "/listed";
    for (auto row = block.listed.begin(); row != block.listed.end(); ++row) {
      const auto first = std::find(block.listed.begin(), row, *row);
      if (first == row || states_repetitions(block, *row)) continue;
      const auto number_of = [&block](auto at) {
        return std::to_string(at - block.listed.begin() + 1);
      };
      found_.push_back(document_.at(
          pointer_to(pointer, static_cast<std::size_t>(row - block.listed.begin())),
          phrase("Protocols",
                 "the listed trials %1 and %2 have the same levels, so that this trial is presented "
                 "twice; change a level, or remove one of them and state the number of its "
                 "repetitions")
              .with(number_of(first), number_of(row))));
    }
  }

  const Protocol& protocol_;
  JsonDocument document_;
  std::vector<Diagnostic> found_{};
};

}  // namespace

std::vector<Diagnostic> warnings_about_texture_use(const Protocol& protocol,
                                                   const std::string& file_name) {
  return TextureUseWarnings(protocol, file_name).all();
}

}  // namespace asperity
