// Lists recent studies, searches them for interrupted sessions, and makes the demo in background tasks.

#include "app/gui/window/welcome_page.h"

#include <exception>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <QtCore/QDir>
#include <QtCore/QEvent>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QTableWidget>

#include "app/gui/base/shown_text.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/study/interrupted_news.h"
#include "app/tasks/new_study.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

constexpr int kColumnWidth = 880;
constexpr int kFolder = Qt::UserRole;
constexpr int kPresent = Qt::UserRole + 1;

/// Where the demo study is, or where it can be made: the first of demo, demo-2, … that holds
/// nothing else.
std::filesystem::path demo_folder(const std::filesystem::path& parent) {
  std::filesystem::path folder = parent / "demo";
  std::error_code ignored{};
  for (int number = 2; std::filesystem::exists(folder, ignored); ++number) {
    if (holds_demo_study(folder)) return folder;
    folder = parent / ("demo-" + std::to_string(number));
  }
  return folder;
}

/// Empty when it was cancelled.
std::filesystem::path made_demo_study(const std::filesystem::path& folder,
                                      const std::stop_token& stop,
                                      const BackgroundTask::Progress& progress) {
  if (holds_demo_study(folder)) return folder;
  if (std::filesystem::exists(folder)) {
    throw std::runtime_error(folder.string() + " already exists; choose another folder");
  }
  std::filesystem::create_directories(folder.parent_path());
  try {
    new_demo_study(folder, [&](double fraction) {
      if (stop.stop_requested()) throw std::runtime_error("cancelled");
      progress(fraction);
    });
  } catch (...) {
    if (stop.stop_requested()) return {};
    throw;
  }
  return folder;
}

/// Its content is at least as high as the column in it needs at the column's width. Qt takes the height at the preferred width
/// of texts, which cuts those that wrap into more lines.
class AreaOfColumn final : public QScrollArea {
 public:
  using QScrollArea::QScrollArea;
  void set_column(QWidget* column) {
    column_ = column;
    column->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool may_need_more =
        event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest;
    if (watched == column_ && may_need_more) {
      // The layout rounds the heights of wrapped texts by itself.
      widget()->setMinimumHeight(column_->layout()->totalHeightForWidth(column_->width()) + kGrid);
    }
    return QScrollArea::eventFilter(watched, event);
  }

 private:
  QWidget* column_ = nullptr;
};

}  // namespace

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent), demo_parent_((QDir::homePath() + "/Asperity").toStdString()) {
  setObjectName("welcome_page");
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  banner_ = new Banner(this);
  outer->addWidget(banner_);
  interrupted_ = new Banner(this);
  interrupted_->setObjectName("welcome_interrupted");
  outer->addWidget(interrupted_);
  // On a small screen the page scrolls, and no part of it is cut.
  auto* area = new AreaOfColumn(this);
  area->setObjectName("welcome_area");
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->viewport()->setAutoFillBackground(false);
  auto* inside = new QWidget(area);
  auto* middle = new QHBoxLayout(inside);
  middle->setContentsMargins(0, 0, 0, 0);

  auto* column = new QWidget(inside);
  column->setMaximumWidth(kColumnWidth);
  auto* layout = new QVBoxLayout(column);
  layout->setSpacing(kMargin);
  layout->addSpacing(kGroupGap);
  layout->addWidget(make_title(tr("Asperity"), column));
  layout->addWidget(
      make_text(tr("Psychophysics experiments on haptic texture: participants feel rendered "
                   "surfaces, compare them with pictures, and report what they felt.\nA study is a "
                   "folder with its protocols, its stimuli, and all responses and recordings."),
                column));
  layout->addSpacing(kGrid);
  layout->addWidget(make_demo_card());

  auto* others = new QHBoxLayout();
  others->setSpacing(kGrid);
  QPushButton* create = make_button(tr("Create a study…"), ButtonRole::plain, column);
  create->setObjectName("welcome_new");
  QPushButton* open = make_button(tr("Open a study…"), ButtonRole::plain, column);
  open->setObjectName("welcome_open");
  others->addWidget(create);
  others->addWidget(open);
  others->addStretch(1);
  layout->addLayout(others);
  QLabel* versions = make_text(words_of(one_version_per_study()), column, true);
  versions->setObjectName("welcome_versions");
  layout->addWidget(versions);
  layout->addSpacing(kGrid);
  layout->addWidget(make_recent_card(), 1);
  middle->addStretch(1);
  middle->addWidget(column, 8);
  middle->addStretch(1);
  area->setWidget(inside);
  area->set_column(column);
  inside->setAutoFillBackground(false);  // setWidget turns it on
  outer->addWidget(area, 1);

  connect(create, &QPushButton::clicked, this, &WelcomePage::new_study_wanted);
  connect(open, &QPushButton::clicked, this, &WelcomePage::open_wanted);
  show_demo_place();
  show_working(false);
}

QWidget* WelcomePage::make_demo_card() {
  QVBoxLayout* layout = nullptr;
  QFrame* card = make_card(this, layout);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->addWidget(make_heading(tr("Demonstration"), card));
  layout->addWidget(make_text(
      tr("Textures and protocols of every kind, ready to run with the simulated device. No "
         "hardware and no network are needed."),
      card));
  demo_place_ = make_text({}, card, true);
  demo_place_->setObjectName("welcome_demo_place");
  layout->addWidget(demo_place_);

  auto* row = new QHBoxLayout();
  row->setSpacing(kGrid);
  demo_ = make_button(tr("Open the demo study"), ButtonRole::primary, card);
  demo_->setObjectName("welcome_demo");
  demo_elsewhere_ = make_button(tr("Another folder…"), ButtonRole::link, card);
  demo_elsewhere_->setObjectName("welcome_demo_elsewhere");
  progress_ = new QProgressBar(card);
  progress_->setTextVisible(false);
  progress_->setRange(0, 100);
  cancel_ = make_button(tr("Cancel"), ButtonRole::plain, card);
  cancel_->setObjectName("welcome_demo_cancel");
  row->addWidget(demo_);
  row->addWidget(demo_elsewhere_);
  row->addWidget(progress_, 1);
  row->addWidget(cancel_);
  row->addStretch(1);
  layout->addSpacing(kGrid);
  layout->addLayout(row);

  connect(demo_, &QPushButton::clicked, this, &WelcomePage::open_demo);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    cancel_->setEnabled(false);
    demo_place_->setText(tr("Stopping after the current texture…"));
    demo_task_.cancel();
  });
  connect(demo_elsewhere_, &QPushButton::clicked, this, [this] {
    auto* chooser = new QFileDialog(this, tr("Folder for the demo study"),
                                    QString::fromStdString(demo_parent_.string()));
    chooser->setAttribute(Qt::WA_DeleteOnClose);
    chooser->setFileMode(QFileDialog::Directory);
    chooser->setOption(QFileDialog::ShowDirsOnly);
    connect(chooser, &QFileDialog::fileSelected, this, [this](const QString& folder) {
      demo_parent_ = folder.toStdString();
      show_demo_place();
    });
    chooser->open();
  });
  connect(&demo_task_, &BackgroundTask::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(100.0 * fraction)); });
  return card;
}

QWidget* WelcomePage::make_recent_card() {
  auto* group = new QWidget(this);
  auto* layout = new QVBoxLayout(group);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  layout->addWidget(make_heading(tr("Recent studies"), group));
  no_recent_ = make_text(
      tr("None yet. Studies that you open are listed here, the most recently used first."), group,
      true);
  layout->addWidget(no_recent_);

  recent_ = new QTableWidget(0, 3, group);
  recent_->setObjectName("welcome_recent");
  recent_->setHorizontalHeaderLabels({tr("Study"), tr("Folder"), tr("Last used")});
  style_table(*recent_);
  recent_->setSortingEnabled(false);
  recent_->setSelectionMode(QAbstractItemView::SingleSelection);
  recent_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  recent_->horizontalHeader()->setStretchLastSection(false);
  // What is above keeps its height: in a low window the list scrolls.
  recent_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  recent_->setMinimumHeight(2 * kControlHeight + kGrid);
  recent_->setColumnWidth(0, 240);
  recent_->setColumnWidth(2, 240);
  layout->addWidget(recent_, 1);

  recent_buttons_ = new QWidget(group);
  auto* buttons = new QHBoxLayout(recent_buttons_);
  buttons->setContentsMargins(0, 0, 0, 0);
  buttons->setSpacing(kGrid);
  QPushButton* open = make_button(tr("Open"), ButtonRole::plain, recent_buttons_);
  open->setObjectName("welcome_recent_open");
  QPushButton* forget = make_button(tr("Remove from this list"), ButtonRole::link, recent_buttons_);
  forget->setObjectName("welcome_recent_forget");
  QLabel* reason = make_text({}, recent_buttons_, true);
  buttons->addWidget(open);
  buttons->addWidget(forget);
  buttons->addWidget(reason, 1);
  layout->addWidget(recent_buttons_);
  layout->addStretch(0);

  const auto selected = [this]() -> QTableWidgetItem* {
    return recent_->currentRow() < 0 ? nullptr : recent_->item(recent_->currentRow(), 0);
  };
  const auto open_selected = [this, selected] {
    const QTableWidgetItem* item = selected();
    if (item == nullptr || !item->data(kPresent).toBool()) return;
    emit study_wanted(item->data(kFolder).toString().toStdString());
  };
  const auto show_buttons = [open, forget, reason, selected] {
    const QTableWidgetItem* item = selected();
    open->setEnabled(item != nullptr && item->data(kPresent).toBool());
    forget->setEnabled(item != nullptr);
    reason->setText(item == nullptr ? tr("Select a study in the list.")
                    : item->data(kPresent).toBool()
                        ? QString{}
                        : tr("This folder no longer contains a study; restore the study, or remove "
                             "it from this list."));
  };
  connect(recent_, &QTableWidget::itemActivated, this, open_selected);
  connect(open, &QPushButton::clicked, this, open_selected);
  connect(forget, &QPushButton::clicked, this, [this, selected] {
    const QTableWidgetItem* item = selected();
    if (item == nullptr) return;
    forget_study(item->data(kFolder).toString().toStdString());
    show_recent();
  });
  connect(recent_, &QTableWidget::itemSelectionChanged, this, show_buttons);
  show_buttons();
  return group;
}

void WelcomePage::open_demo() {
  if (demo_task_.is_running()) return;
  const std::filesystem::path folder = demo_folder(demo_parent_);
  if (holds_demo_study(folder)) {
    emit study_wanted(folder);
    return;
  }
  show_working(true);
  demo_place_->setText(tr("Creating the demo study in %1…").arg(text_of_path(folder)));
  demo_task_.run<std::filesystem::path>(
      [folder](const std::stop_token& stop, const BackgroundTask::Progress& progress) {
        return made_demo_study(folder, stop, progress);
      },
      [this](const std::filesystem::path& made) {
        show_working(false);
        show_demo_place();
        if (!made.empty()) emit study_wanted(made);
      },
      [this](const QString& what) {
        show_working(false);
        show_demo_place();
        banner_->show_news(State::stop, tr("The demo study could not be created: %1").arg(what));
      });
}

void WelcomePage::show_recent() {
  const std::vector<RecentStudy> studies = recent_studies();
  // A folder on a network that does not answer must not hold the window.
  recent_task_.run<std::vector<bool>>(
      [studies](const std::stop_token& stop, const BackgroundTask::Progress&) {
        std::vector<bool> present(studies.size(), false);
        for (std::size_t i = 0; i < studies.size() && !stop.stop_requested(); ++i) {
          present[i] = Study::exists(studies[i].folder);
        }
        return present;
      },
      [this, studies](const std::vector<bool>& present) {
        fill_recent(studies, present);
        look_for_interrupted(studies);
      },
      [](const QString&) {});
}

void WelcomePage::look_for_interrupted(const std::vector<RecentStudy>& studies) {
  struct Found {
    RecentStudy study{};
    std::vector<InterruptedSession> sessions{};
  };
  interrupted_task_.run<Found>(
      [studies](const std::stop_token& stop, const BackgroundTask::Progress&) {
        for (const RecentStudy& study : studies) {
          if (stop.stop_requested()) break;
          try {
            if (!Study::can_be_written(study.folder)) continue;  // nothing can be resumed in it
            const Study own = Study::open(study.folder, Access::read_only);
            Found found{study, interrupted_sessions(own, stop)};
            if (!found.sessions.empty()) return found;
          } catch (const std::exception&) {
            // The problems of a study are reported when it is opened.
          }
        }
        return Found{};
      },
      [this](const Found& found) {
        const std::filesystem::path& folder = found.study.folder;
        report_interrupted(
            *interrupted_, found.sessions, found.study.name,
            [this, folder](const SessionWish& wish) { emit session_wanted(folder, wish); },
            [this, folder] { emit sessions_wanted(folder); });
      },
      [](const QString&) {});
}

void WelcomePage::fill_recent(const std::vector<RecentStudy>& studies,
                              const std::vector<bool>& present) {
  recent_->setRowCount(static_cast<int>(studies.size()));
  for (std::size_t i = 0; i < studies.size(); ++i) {
    const RecentStudy& study = studies[i];
    const QString used = text_of_time(study.used.toUTC().toString(Qt::ISODateWithMs).toStdString());
    const QStringList texts{study.name, text_of_path(study.folder),
                            present[i] ? used : tr("study not found")};
    for (int column = 0; column < 3; ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setToolTip(texts[column]);
      item->setData(kFolder, QString::fromStdString(study.folder.string()));
      item->setData(kPresent, static_cast<bool>(present[i]));
      if (!present[i]) item->setForeground(theme().muted);
      recent_->setItem(static_cast<int>(i), column, item);
    }
  }
  no_recent_->setVisible(studies.empty());
  recent_->setVisible(!studies.empty());
  recent_buttons_->setVisible(!studies.empty());
  if (!studies.empty()) recent_->selectRow(0);
}

void WelcomePage::show_demo_place() {
  const std::filesystem::path folder = demo_folder(demo_parent_);
  demo_place_->setText(
      holds_demo_study(folder)
          ? tr("The demo study is in %1.").arg(text_of_path(folder))
          : tr("The demo study will be created in %1 (about 25 MB). This takes a few seconds.")
                .arg(text_of_path(folder)));
}

void WelcomePage::show_working(bool working) {
  demo_->setEnabled(!working);
  demo_elsewhere_->setVisible(!working);
  progress_->setVisible(working);
  progress_->setValue(0);
  cancel_->setVisible(working);
  cancel_->setEnabled(true);
}

}  // namespace asperity

#include "moc_welcome_page.cpp"
