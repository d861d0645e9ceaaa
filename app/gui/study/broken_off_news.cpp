#include "app/gui/study/broken_off_news.h"

#include <utility>

#include <QtCore/QCoreApplication>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

QString news_text(const BrokenOffSession& session, const QString& study) {
  const QString participant = QString::fromStdString(session.row.participant);
  const QString text =
      study.isEmpty()
          ? QCoreApplication::translate(
                "asperity::BrokenOffNews",
                "Session %1 of %2 was interrupted: %3 of its %4 trials are completed and stored.")
          : QCoreApplication::translate("asperity::BrokenOffNews",
                                        "Session %1 of %2 in the study “%5” was interrupted: %3 of "
                                        "its %4 trials are completed and stored.");
  const QString filled =
      text.arg(session.row.session).arg(participant).arg(session.trials_done).arg(session.trials);
  return study.isEmpty() ? filled : filled.arg(study);
}

}  // namespace

void tell_broken_off(Banner& banner, const std::vector<BrokenOffSession>& sessions,
                     const QString& study, std::function<void(const SessionWish&)> go_on,
                     std::function<void()> show_sessions) {
  if (sessions.empty()) {
    banner.hide();
    return;
  }
  const BrokenOffSession& session = sessions.front();
  QStringList said{news_text(session, study)};
  if (!session.protocol_file) {
    said << QCoreApplication::translate("asperity::BrokenOffNews",
                                        "None of the study's protocols has the text that the "
                                        "session began with: restore %1 version %2 to resume.")
                .arg(QString::fromStdString(session.protocol_name),
                     QString::fromStdString(session.protocol_version));
  }
  if (sessions.size() > 1) {
    said << QCoreApplication::translate(
        "asperity::BrokenOffNews",
        "Other sessions were interrupted as well; they are listed on the Sessions page.");
  }
  if (!session.protocol_file) {
    banner.show_news(State::look, said.join(' '),
                     QCoreApplication::translate("asperity::BrokenOffNews", "Show the sessions"),
                     std::move(show_sessions));
    return;
  }
  const SessionWish wish{.protocol = *session.protocol_file,
                         .participant = session.row.participant,
                         .session = session.row.id};
  banner.show_news(State::look, said.join(' '),
                   QCoreApplication::translate("asperity::BrokenOffNews", "Resume session %1 of %2")
                       .arg(session.row.session)
                       .arg(QString::fromStdString(session.row.participant)),
                   [go_on = std::move(go_on), wish] { go_on(wish); });
}

}  // namespace asperity
