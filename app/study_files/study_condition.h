// What is said, and what is refused, when the file of a study is not as it was left.

#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "app/words/phrase.h"
#include "results_schema/study.h"

namespace asperity {

/// A sentence for readers of numbers of a study whose file was changed, or is too large for its
/// checksum to be compared before an analysis: from 1 GiB on, which a disk may take
/// two seconds to read, and an analysis need not read. None when it is whole; a broken one is refused.
std::optional<Phrase> remark_on(const Study& study);

/// Runs what reads a study, while its file is looked at in the background (Study::condition), and
/// refuses what was read from a broken one, in which rows can be missing without a trace. A file that
/// was merely changed is read: that can have been meant, and `remark_on` states it.
///
/// When `stop` is requested, what was read until then is discarded: the file is not waited for, and
/// nothing refused.
///
/// Errors: ResultsError when the file is broken, in place of whatever `read` may throw then, and with the
/// remark when `read` throws on a file that was changed.
void read_unless_broken(const Study& study, const std::function<void()>& read,
                        const std::stop_token& stop);

/// The same before writing.
void refuse_if_broken(const Study& study);

}  // namespace asperity
