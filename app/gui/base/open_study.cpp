#include "app/gui/base/open_study.h"

#include <exception>

#include "app/gui/base/settings.h"
#include "app/plugins/plugin_files.h"

namespace asperity {

OpenStudy::OpenStudy(const std::filesystem::path& folder, QObject* parent)
    : QObject(parent),
      study_(Study::open(folder, Access::read_only)),
      can_be_written_(Study::can_be_written(folder)) {
  for (const std::filesystem::path& file : plugin_files()) {
    try {
      add_plugin(file, models_);
    } catch (const std::exception& error) {
      plugin_problems_.emplace_back(error.what());
    }
  }
}

}  // namespace asperity

#include "moc_open_study.cpp"
