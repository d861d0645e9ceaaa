// Declares the texts of protocols on their page.

#pragma once

#include <QtCore/QString>

#include "app/gui/base/study_table.h"
#include "app/tasks/study_overview.h"

namespace asperity {

/// "chapter_recognition · absolute identification · version 1.0.0 · 36 trials · 6 blocks · about 42 min · blindfold · masking
/// noise", as far as the protocol can be read.
QString overview_facts(const ProtocolOverview& overview);
/// The title, or the name where there is none.
QString title_of(const ProtocolOverview& overview);
/// "Last run today 16:10, P004, complete."
QString last_run_of(const ProtocolOverview& overview);
/// The same marks as in the editor and in the list of checks before a session.
QStandardItem* validity_cell(const ProtocolOverview& overview);
/// Its key is the file.
StudyTable::Row protocol_row(const ProtocolOverview& overview);
/// What is permitted and may not be meant, then what the author wrote, then the designs of the main blocks.
QString description_of(const ProtocolOverview& overview);

}  // namespace asperity
