// How paths, times, durations and what a protocol asks for are written on the pages of a study.

#pragma once

#include <filesystem>
#include <string>

#include <QtCore/QCoreApplication>
#include <QtCore/QString>

#include "protocols/design/protocol.h"
#include "results_schema/rows.h"

namespace asperity {

/// With "~" for the home folder.
QString text_of_path(const std::filesystem::path& path);
std::filesystem::path path_of_text(const QString& text);

/// "today 16:10", "yesterday 16:10", or the date and the time; as written when it is no time.
QString text_of_time(const std::string& utc);
/// When a session began, as `text_of_time`. The dates of a simulated clock are made up:
/// "simulated clock" stands in their place.
QString text_of_start(const SessionRow& session);
/// Sorts by it: what a simulated clock says comes before every date, by order of storing.
QString order_of_start(const SessionRow& session);
/// "42 min", "1 h 05 min", "18 s"
QString text_of_duration(double duration_s);

/// "amplitude 87.5 µm" for the factor `amplitude_m`; without a unit at the end of its name "column 1".
QString text_of_level(const std::string& factor, double level);

/// Whether sessions with the protocol have different numbers of trials: a track or a practice may end by its responses,
/// and the number of catch trials is drawn.
bool is_length_estimated(const Protocol& protocol);

/// "English", "Deutsch"; the tag itself for a language that Qt does not know.
QString text_of_language(const std::string& tag);
QString text_of_kind(const std::string& kind);
/// "hand hidden, screen visible"
QString text_of_vision(Vision vision);
/// "pink masking noise, 65 dB(A)"
QString text_of_noise(const Protocol::Noise& noise);

}  // namespace asperity
