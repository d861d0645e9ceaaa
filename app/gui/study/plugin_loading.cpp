// Loads the plug-ins in a background task; after an error the built-in models remain available.

#include "app/gui/study/plugin_loading.h"

#include <optional>
#include <stop_token>
#include <utility>

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QVBoxLayout>

#include "app/gui/look/controls.h"

namespace asperity {

namespace {

constexpr int kLoadingSteps = 1000;

}  // namespace

PluginLoading::PluginLoading(const std::vector<std::filesystem::path>& plugins, QWidget* parent)
    : QDialog(parent) {
  setObjectName("plugin_loading");
  setWindowTitle(tr("Plug-ins"));
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(480);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  layout->addWidget(make_heading(tr("Loading and checking the plug-ins"), this));
  layout->addWidget(make_text(
      tr("The conformance suite takes from a second to minutes for each plug-in."), this, true));
  bar_ = new QProgressBar(this);
  bar_->setObjectName("loading_progress");
  bar_->setAccessibleName(tr("Progress of the checks"));
  bar_->setTextVisible(false);
  bar_->setRange(0, kLoadingSteps);
  layout->addWidget(bar_);
  auto* buttons = new QHBoxLayout();
  cancel_ = make_button(tr("Cancel"), ButtonRole::plain, this);
  cancel_->setObjectName("loading_cancel");
  buttons->addStretch(1);
  buttons->addWidget(cancel_);
  layout->addLayout(buttons);

  connect(cancel_, &QPushButton::clicked, this, &PluginLoading::reject);
  connect(&task_, &BackgroundTask::progressed, this,
          [this](double done) { bar_->setValue(static_cast<int>(done * kLoadingSteps)); });
  task_.run<std::optional<LoadedModels>>(
      [plugins](const std::stop_token& stop, const BackgroundTask::Progress& progress) {
        return load_models(plugins, stop, progress);
      },
      [this](const std::optional<LoadedModels>& models) {
        accept();  // what follows can show windows of its own
        if (models && !is_cancelled_) {
          emit loaded(*models);
        } else {
          emit cancelled();
        }
      },
      [this](const QString& problem) {
        accept();
        LoadedModels built_in{};
        built_in.problems.push_back(problem.toStdString());
        emit loaded(built_in);
      });
}

void PluginLoading::reject() {
  is_cancelled_ = true;
  cancel_->setEnabled(false);
  cancel_->setText(tr("Cancelling…"));
  task_.cancel();
}

}  // namespace asperity

#include "moc_plugin_loading.cpp"
