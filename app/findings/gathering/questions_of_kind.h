// Which questions of a stored protocol each kind of experiment analyses.

#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "protocols/design/protocol.h"

namespace asperity {

/// The questions of one kind in a protocol.
struct QuestionsOfKind {
  /// The names of the questions, by block; nothing where the block has only one, whatever its name.
  std::map<std::string, std::optional<std::set<std::string>>, std::less<>> by_block{};
  /// The blocks that belong to other kinds only, or nothing: a block that the stored protocol lacks is of
  /// the protocol's kind.
  std::optional<std::set<std::string, std::less<>>> others{};
  /// The blocks of other kinds in which its questions accompany another one.
  std::set<std::string, std::less<>> accompanied{};
  /// By block of this kind, the scale that rates the confidence of the response to its question.
  std::map<std::string, std::string, std::less<>> confidences{};
  /// By block, the questions that no kind analyses.
  std::map<std::string, std::set<std::string>, std::less<>> additional{};

  bool is_additional(const std::string& block, const std::string& question) const {
    const auto names = additional.find(block);
    return names != additional.end() && names->second.contains(question);
  }
  bool has_block(const std::string& block) const {
    return by_block.contains(block) || (others && !others->contains(block));
  }
  bool has(const std::string& block, const std::string& question) const {
    const auto names = by_block.find(block);
    if (names == by_block.end()) return has_block(block);
    return !names->second || names->second->contains(question);
  }
};

/// The id of the kind of a block; that of the protocol where the block states none.
const std::string& kind_of_stored_block(const std::string& kind_of_protocol,
                                        const Protocol::Block& block);
/// The id of the kind that analyses a question of a block; empty where none does.
std::string kind_of_stored(const std::string& kind_of_protocol, const Protocol::Block& block,
                           const Protocol::TrialQuestionTemplate& question);
/// What the stored protocol of sessions asks, by kind.
std::map<std::string, QuestionsOfKind> questions_by_kind(const Protocol& protocol,
                                                         const std::string& kind_of_protocol);

}  // namespace asperity
