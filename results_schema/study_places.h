// The places that participants have in a study that is divided among stations. Seen by this folder only.

#pragma once

#include <cstdint>
#include <string>

#include "results_schema/rows.h"
#include "results_schema/sqlite.h"

namespace asperity {

/// The place of the session's participant in the protocols of this name, in sessions of its mode, or else the first of the
/// claim's places that is free and, where the session states a group, of this group. To be called in the transaction that
/// stores the session.
///
/// Errors: ResultsError where no place is free.
ClaimedPlace claimed_place(Database& database, const std::string& protocol_name,
                           const SessionRow& session, const SessionClaim& claim);

/// Stores the place as an event at the beginning of the session.
void add_dealt_event(Database& database, std::int64_t session_id, const SessionRow& session,
                     const ClaimedPlace& place);

}  // namespace asperity
