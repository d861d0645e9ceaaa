// Writes the texts of protocols for their list and the card below it.

#include "app/gui/study/protocol_texts.h"

#include <nlohmann/json.hpp>

#include "app/gui/base/form_words.h"
#include "app/gui/base/progress_cell.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/study/protocols_page.h"
#include "app/gui/study/sessions_page.h"

namespace asperity {

namespace {

QString count_text(int count, const QString& one, const QString& many) {
  return count == 1 ? one : many.arg(count);
}

QStandardItem* state_cell(State state, const QString& words, int order) {
  QStandardItem* cell = text_cell(shape_of(state) + ' ' + words, order);
  cell->setForeground(color_of(state));
  return cell;
}

}  // namespace

QString title_of(const ProtocolOverview& overview) {
  const std::string& title = overview.read().title;
  return text(title.empty() ? overview.name() : title);
}

QString overview_facts(const ProtocolOverview& overview) {
  const Protocol& protocol = overview.read();
  QStringList facts{text(overview.name())};
  if (!protocol.kind.empty()) facts.append(text_of_kind(protocol.kind));
  if (!protocol.version.empty()) {
    facts.append(ProtocolsPage::tr("version %1").arg(text(protocol.version)));
  }
  if (!overview.check.protocol) return facts.join(" · ");
  if (overview.is_valid()) {
    const QString trials = count_text(overview.check.cost.trials, ProtocolsPage::tr("1 trial"),
                                      ProtocolsPage::tr("%1 trials"));
    facts << QStringList{
        is_length_estimated(protocol) ? ProtocolsPage::tr("about %1").arg(trials) : trials,
        count_text(overview.blocks, ProtocolsPage::tr("1 block"), ProtocolsPage::tr("%1 blocks")),
        ProtocolsPage::tr("about %1").arg(text_of_duration(overview.check.cost.total_s))};
  }
  if (protocol.sessions > 1) {
    facts.append(ProtocolsPage::tr("%1 sessions each").arg(protocol.sessions));
  }
  facts.append(text_of_vision(protocol.vision));
  facts.append(text_of_noise(protocol.masking_noise));
  return facts.join(" · ");
}

QString last_run_of(const ProtocolOverview& overview) {
  if (!overview.last_session) return ProtocolsPage::tr("Not run yet.");
  SessionOverview session{};
  session.row = *overview.last_session;
  const QString state = session.row.state == SessionState::open ? ProtocolsPage::tr("not ended")
                                                                : text_of_session_state(session);
  if (has_made_up_dates(session.row)) {
    return ProtocolsPage::tr("Last run on a simulated clock, %1, %2.")
        .arg(text(session.row.participant), state);
  }
  return ProtocolsPage::tr("Last run %1, %2, %3.")
      .arg(text_of_time(session.row.started_utc), text(session.row.participant), state);
}

QStandardItem* validity_cell(const ProtocolOverview& overview) {
  const int problems = static_cast<int>(overview.check.diagnostics.size());
  const int warnings = static_cast<int>(overview.check.warnings.size());
  if (!overview.is_valid()) {
    return state_cell(
        State::stop,
        count_text(problems, ProtocolsPage::tr("1 problem"), ProtocolsPage::tr("%1 problems")),
        problems);
  }
  if (warnings > 0) {
    return state_cell(State::look,
                      count_text(warnings, ProtocolsPage::tr("valid, 1 warning"),
                                 ProtocolsPage::tr("valid, %1 warnings")),
                      0);
  }
  return state_cell(State::fine, ProtocolsPage::tr("valid"), 0);
}

StudyTable::Row protocol_row(const ProtocolOverview& overview) {
  const Protocol& protocol = overview.read();
  const QString none("–");
  return {text(overview.check.file),
          {text_cell(title_of(overview)), text_cell(text(overview.name())),
           text_cell(protocol.kind.empty() ? none : text_of_kind(protocol.kind)),
           text_cell(protocol.version.empty() ? none : text(protocol.version)),
           progress_cell(overview.people_done, protocol.planned_participants),
           validity_cell(overview)}};
}

QString description_of(const ProtocolOverview& overview) {
  QStringList paragraphs{};
  const auto protocol = nlohmann::json::parse(overview.check.text, nullptr, false);
  for (const Diagnostic& warning : overview.check.warnings) {
    paragraphs += ProtocolsPage::tr("▲ %1").arg(remark_in_form(protocol, warning));
  }
  paragraphs += text(overview.read().description);
  for (const auto& [block, design] : overview.check.designs) {
    paragraphs += ProtocolsPage::tr("Block %1: %2.").arg(text(block), words_of(design));
  }
  paragraphs.removeAll(QString());
  return paragraphs.join("\n\n");
}

}  // namespace asperity
