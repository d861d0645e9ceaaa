// Opens the study for reading, and notes whether it can also be written.

#include "app/gui/base/open_study.h"

#include <utility>

namespace asperity {

OpenStudy::OpenStudy(const std::filesystem::path& folder, LoadedModels models, QObject* parent)
    : QObject(parent),
      study_(Study::open(folder, Access::read_only)),
      can_be_written_(Study::can_be_written(folder)),
      models_(std::move(models)),
      examiner_(study_.folder(), models_.models) {}

}  // namespace asperity

#include "moc_open_study.cpp"
