// Reports and rejects studies whose file was changed or damaged.

#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "analysis/words/phrase.h"
#include "results_schema/study.h"

namespace asperity {

/// A sentence for readers of numbers of a study whose file was changed, or is too large for its
/// checksum to be verified before an analysis: from 1 GiB on, which a disk may take two seconds to
/// read, and which an analysis does not otherwise require. None when the file is intact; a damaged
/// one is rejected.
std::optional<Phrase> remark_on(const Study& study);

/// Runs `read` on a study while its file is verified in the background (Study::condition), and
/// rejects what was read from a damaged file, in which rows can be missing without a trace. A file
/// that was merely changed is accepted: the change may be intentional, and `remark_on` reports it.
///
/// When `stop` is requested, the data read until then are discarded: the verification is not waited
/// for, and nothing is rejected.
///
/// Errors: ResultsError when the file is damaged, in place of any exception from `read`, and with
/// the remark when `read` throws on a file that was changed.
void read_unless_broken(const Study& study, const std::function<void()>& read,
                        const std::stop_token& stop);

/// The same check before writing.
void refuse_if_broken(const Study& study);

}  // namespace asperity
