// Declares the numbers of a design that the texts of its protocol can state with placeholders, and where each is known.

#pragma once

#include <array>
#include <string>
#include <string_view>

#include "analysis/words/phrase.h"
#include "protocols/plan/plan.h"
#include "protocols/texts/placeholders.h"

namespace asperity {

/// What a placeholder belongs to.
enum class NumberScope {
  block,  ///< a trial of one block; in a text outside blocks it has a value where the main blocks agree
  session  ///< the participant's plan; in the consent, the screens and breaks of the flow, and those of a resumed session
};

struct DesignNumber {
  std::string_view name{};
  NumberScope scope = NumberScope::block;
  std::string_view meaning{};  ///< after "the"
};

/// None of them reveals a group, a level or a correct response.
inline constexpr std::array kDesignNumbers{
    DesignNumber{"surfaces", NumberScope::block, "number of surfaces of a trial"},
    DesignNumber{"surface_names", NumberScope::block,
                 "names of the surfaces of a trial as the participant reads them: A, B and C"},
    DesignNumber{"questions", NumberScope::block, "number of questions of a trial"},
    DesignNumber{"scales", NumberScope::block, "number of scales of a trial"},
    DesignNumber{"options", NumberScope::block,
                 "number of options of the block's question, without “I cannot tell”"},
    DesignNumber{
        "pictures", NumberScope::block,
        "number of pictures of the block's question; 1 where the picture of the texture is shown"},
    DesignNumber{"trials", NumberScope::session, "number of trials of the main part"},
    DesignNumber{"practice_trials", NumberScope::session,
                 "number of trials of familiarisation and practice"},
    DesignNumber{"blocks", NumberScope::session, "number of blocks of the main part"},
    DesignNumber{"breaks", NumberScope::session, "number of breaks"},
    DesignNumber{
        "minutes", NumberScope::session,
        "estimated duration in minutes, rounded up; from 15 minutes on to a multiple of 5"}};

/// Null if there is no such number.
const DesignNumber* find_design_number(std::string_view name) noexcept;

/// What it counts: "scales".
Phrase noun_of(const DesignNumber& number);

/// Those of a trial of the block that have a value: no `scales` in a block without scales.
DesignValues values_of_block(const Protocol& protocol, const Protocol::Block& block);

/// Those in which all blocks of the main phase that have them agree; of all blocks if there is none of the main phase.
DesignValues values_of_all_blocks(const Protocol& protocol);

/// Whether the number of breaks of a session is known when it begins, and there are any.
bool has_known_breaks(const Protocol& protocol);

/// Those of the session, and those of `values_of_all_blocks`. `example`: a plan of the participant's session (example_plan), from
/// which the numbers of tracks that end early, and of practice to a criterion, are replaced by the largest ones. `breaks` has a
/// value only with has_known_breaks.
DesignValues values_of_session(const Protocol& protocol, const Plan& example);

/// Those that hold for every participant, before a row of the counterbalancing and a group are assigned: the largest number
/// where the sessions differ. Left out are those that some sessions do not have. Makes a plan for each row and group.
DesignValues values_of_every_session(const Protocol& protocol);

}  // namespace asperity
