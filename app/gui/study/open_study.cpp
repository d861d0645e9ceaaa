#include "app/gui/study/open_study.h"

namespace asperity {

OpenStudy::OpenStudy(const std::filesystem::path& folder, QObject* parent)
    : QObject(parent), study_(Study::open_up_to_date(folder)) {}

}  // namespace asperity
