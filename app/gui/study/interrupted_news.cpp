// Shows the first session with the number of others, and restricts the button to a session that can resume.

#include "app/gui/study/interrupted_news.h"

#include <utility>

#include <QtCore/QCoreApplication>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

QString news_text(const InterruptedSession& session, const QString& study) {
  const QString participant = QString::fromStdString(session.row.participant);
  const QString text =
      study.isEmpty()
          ? QCoreApplication::translate(
                "asperity::InterruptedNews",
                "Session %1 of %2 was interrupted; trials completed and stored: %3 of %4.")
          : QCoreApplication::translate("asperity::InterruptedNews",
                                        "Session %1 of %2 in the study “%5” was interrupted; "
                                        "trials completed and stored: %3 of %4.");
  const QString filled =
      text.arg(session.row.session).arg(participant).arg(session.trials_done).arg(session.trials);
  return study.isEmpty() ? filled : filled.arg(study);
}

}  // namespace

void report_interrupted(Banner& banner, const std::vector<InterruptedSession>& sessions,
                        const QString& study, std::function<void(const SessionWish&)> resume,
                        std::function<void()> show_sessions) {
  if (sessions.empty()) {
    banner.hide();
    return;
  }
  const InterruptedSession& session = sessions.front();
  QStringList said{news_text(session, study)};
  if (!session.protocol_file) {
    said << QCoreApplication::translate("asperity::InterruptedNews",
                                        "None of the study's protocols has the text that the "
                                        "session began with: restore %1 version %2 to resume.")
                .arg(QString::fromStdString(session.protocol_name),
                     QString::fromStdString(session.protocol_version));
  }
  if (sessions.size() > 1) {
    said << QCoreApplication::translate(
        "asperity::InterruptedNews",
        "Other sessions were interrupted as well; they are listed on the Sessions page.");
  }
  if (!session.protocol_file) {
    banner.show_news(State::look, said.join(' '),
                     QCoreApplication::translate("asperity::InterruptedNews", "Show the sessions"),
                     std::move(show_sessions));
    return;
  }
  const SessionWish wish{.protocol = *session.protocol_file,
                         .participant = session.row.participant,
                         .session = session.row.id};
  banner.show_news(
      State::look, said.join(' '),
      QCoreApplication::translate("asperity::InterruptedNews", "Resume session %1 of %2")
          .arg(session.row.session)
          .arg(QString::fromStdString(session.row.participant)),
      [resume = std::move(resume), wish] { resume(wish); });
}

}  // namespace asperity
