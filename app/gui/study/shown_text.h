// How paths, times and durations are written on the pages of a study.

#pragma once

#include <filesystem>
#include <string>

#include <QtCore/QCoreApplication>
#include <QtCore/QString>

#include "results_schema/rows.h"

namespace asperity {

/// With "~" for the home folder.
QString text_of_path(const std::filesystem::path& path);
std::filesystem::path path_of_text(const QString& text);

/// "today 16:10", "yesterday 16:10", or the date and the time; as written when it is no time.
QString text_of_time(const std::string& utc);
/// "42 min", "1 h 05 min", "18 s"
QString text_of_duration(double duration_s);

}  // namespace asperity
