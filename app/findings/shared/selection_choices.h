// Represents the responses of a selection or a paired comparison as choices among items, and as the
// tables that families of analyses read.

#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// No item, position or texture: for "cannot tell" and for a tie.
inline constexpr std::size_t kNoChoice = LabelColumn::kMissing;

/// The responses of a selection or a paired comparison as choices among items.
struct Selection {
  const GatheredAnswers& gathered;
  std::vector<std::string> items{};     ///< by name
  std::vector<std::string> textures{};  ///< by name
  std::vector<std::size_t> item_of_word{};
  std::vector<std::size_t> texture_of_word{};
  std::size_t positions = 0;  ///< in the largest trial
  bool all_offered = true;    ///< every item in every trial
  bool two_offered = true;    ///< in every trial
  bool can_abstain = false;   ///< cannot_tell was a possible response
  std::size_t abstained = 0;

  explicit Selection(const GatheredAnswers& answers);

  /// kNoChoice for cannot_tell, for a tie, and for items that were not felt.
  std::size_t chosen(const GatheredAnswer& answer) const {
    return item_of_word[gathered.reply_of(answer).answer];
  }
  std::size_t item(const FeltSurface& surface) const { return item_of_word[surface.item]; }
  /// The texture of the first surface; all surfaces of a trial have the same one.
  std::size_t texture(const GatheredAnswer& answer) const {
    return answer.surface_count == 0 ? kNoChoice
                                     : texture_of_word[gathered.surfaces_of(answer)[0].texture];
  }
  std::size_t position(const GatheredAnswer& answer) const {
    const auto surfaces = gathered.surfaces_of(answer);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if (surfaces[i].item == gathered.reply_of(answer).answer) return i;
    }
    return kNoChoice;
  }
  /// The item whose superiority is tested: the declared one, or otherwise the first.
  const std::string& target() const {
    const auto& declared = gathered.declared.target;
    const bool is_known =
        declared && std::find(items.begin(), items.end(), *declared) != items.end();
    return is_known ? *declared : items.front();
  }
  bool has_target() const { return gathered.declared.target == target(); }
};

/// "1", "2", …: the names of positions.
std::vector<std::string> numbers_up_to(std::size_t count);

/// The chosen category of each response: an item, a position, a texture.
using ChoiceOf = std::function<std::size_t(const GatheredAnswer&)>;
/// For the family `selection`: each participant's choices among `names`, by texture.
TidyInput choices_table(const Selection& selection, const std::vector<std::string>& names,
                        const ChoiceOf& choice, const std::string& target);

/// Two items, the first before the second.
struct ItemPair {
  std::size_t first = 0;
  std::size_t second = 0;
};
/// The pairs that some trial offered together, in order.
std::vector<ItemPair> pairs_offered(const Selection& selection);
/// For the family `selection`: the choices between two items, of the trials that offered both. A
/// choice of a third item is not a choice between the two.
TidyInput choices_between(const Selection& selection, const ItemPair& pair);

/// The findings of the family `selection` for each pair separately, of the trials that offered both:
/// keys are both names together, for a proportion the name of its item first. `parts`: those of the family's findings that
/// are needed.
std::vector<Finding> pair_findings(const char* analysis, const Selection& selection,
                                   const char* parts = "all");

/// For the family `paired`: comparisons of two; "cannot tell" is a tie too.
TidyInput comparisons_of(const Selection& selection);
/// For the family `ranking`: the best of several, as rankings of which only the first rank is
/// known.
TidyInput first_places_of(const Selection& selection);

}  // namespace asperity
