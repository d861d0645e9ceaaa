// Makes some pages only when they are shown, and compares the state of the store to find changes.

#include "app/gui/window/study_window.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <system_error>
#include <utility>

#include <QtCore/QDateTime>
#include <QtCore/QDir>
#include <QtCore/QFileInfo>
#include <QtCore/QFileSystemWatcher>
#include <QtCore/QUrl>
#include <QtGui/QActionGroup>
#include <QtGui/QCloseEvent>
#include <QtGui/QScreen>
#include <QtWidgets/QApplication>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QStackedWidget>

#include "app/gui/base/documents.h"
#include "app/gui/base/settings.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/data/attempt_page.h"
#include "app/gui/editor/protocol_editor_page.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/study/about_dialog.h"
#include "app/gui/study/metadata_dialog.h"
#include "app/gui/study/new_study_dialog.h"
#include "app/gui/study/share_study_dialog.h"
#include "app/gui/study/trials_page.h"
#include "app/gui/window/navigation_list.h"
#include "app/gui/window/welcome_page.h"
#include "app/gui/workbench/workbench_page.h"
#include "app/tasks/new_study.h"
#include "app/words/phrase_of_error.h"
#include "results_schema/study_sharing.h"

namespace asperity {

namespace {

constexpr const char* kGeometry = "study_window";
constexpr QSize kUsualSize{1280, 800};
constexpr QSize kFrame{16, 48};  // that a desktop draws around a window, and then some
constexpr QSize kSmallestPages{640, 400};

/// Changes whenever somebody has written to the store.
QString state_of_store(const std::filesystem::path& folder) {
  QString state{};
  for (const char* name : {"study.sqlite", "study.sqlite-wal"}) {
    const QFileInfo file(QString::fromStdString((folder / name).string()));
    state += QString("%1 %2 ").arg(file.size()).arg(file.lastModified().toMSecsSinceEpoch());
  }
  return state;
}

}  // namespace

StudyWindow::StudyWindow(QWidget* parent) : QMainWindow(parent) {
  setObjectName("study_window");
  if (!restore_geometry(*this, kGeometry)) {
    resize(kUsualSize.boundedTo(screen()->availableSize() - kFrame));
  }
  watcher_ = new QFileSystemWatcher(this);
  connect(watcher_, &QFileSystemWatcher::directoryChanged, this, &StudyWindow::watch_folder);
  refill();
}

StudyWindow::~StudyWindow() {
  remove_pages();  // while the study that they show is still there
}

void StudyWindow::refill() {
  const QString shown = shown_page();
  auto edited = editor() == nullptr || editor()->file().empty()
                    ? std::nullopt
                    : std::optional<ProtocolEditorPage::Shown>(editor()->hand_over());
  const auto* worked_on = qobject_cast<WorkbenchPage*>(made_page("workbench"));
  const auto work =
      worked_on == nullptr ? std::nullopt : std::optional<WorkbenchPage::Work>(worked_on->work());
  const auto* trials = qobject_cast<TrialsPage*>(made_page("trials"));
  const std::int64_t session = trials == nullptr ? 0 : trials->session();
  const auto* opened = qobject_cast<AttemptPage*>(made_page("attempt"));
  const std::optional<qlonglong> attempt = opened == nullptr ? std::nullopt : opened->attempt();
  remove_pages();
  make_menus();
  auto* centre = new QWidget(this);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  banner_ = new Banner(centre);
  banner_->setObjectName("study_banner");
  layout->addWidget(banner_);
  auto* row = new QHBoxLayout();
  row->setSpacing(0);
  layout->addLayout(row, 1);
  navigation_ = new NavigationList(centre);
  pages_ = new QStackedWidget(centre);
  pages_->setObjectName("study_pages");
  // In place of what the largest page asks for, which changes with what it shows: the window is as
  // large as somebody has made it, whatever page or language is chosen.
  pages_->setMinimumSize(kSmallestPages);
  row->addWidget(navigation_);
  line_ = new QFrame(centre);
  line_->setFixedWidth(1);
  line_->setStyleSheet("background: " + theme().line.name());
  row->addWidget(line_);
  row->addWidget(pages_, 1);
  connect(navigation_, &NavigationList::page_selected, this, &StudyWindow::show_page);
  welcome_ = new WelcomePage(pages_);
  pages_->addWidget(welcome_);
  connect(welcome_, &WelcomePage::study_wanted, this,
          [this](const std::filesystem::path& folder) { open_study(folder); });
  connect(welcome_, &WelcomePage::session_wanted, this,
          [this](const std::filesystem::path& folder, const SessionWish& wish) {
            open_study(folder, [this, wish] { emit session_wanted(wish); });
          });
  connect(welcome_, &WelcomePage::sessions_wanted, this,
          [this](const std::filesystem::path& folder) {
            open_study(folder, [this] { show_page("sessions"); });
          });
  connect(welcome_, &WelcomePage::new_study_wanted, this, &StudyWindow::ask_for_new_study);
  connect(welcome_, &WelcomePage::open_wanted, this, &StudyWindow::ask_for_study);
  setCentralWidget(centre);  // deletes the one before
  make_pages();
  if (edited) qobject_cast<ProtocolEditorPage*>(page("editor"))->resume(std::move(*edited));
  if (work) qobject_cast<WorkbenchPage*>(page("workbench"))->resume(*work);
  if (session != 0) qobject_cast<TrialsPage*>(page("trials"))->show_session(session);
  if (attempt) qobject_cast<AttemptPage*>(page("attempt"))->show_attempt(*attempt);
  if (!shown.isEmpty() && page(shown) != nullptr) show_page(shown);
}

void StudyWindow::make_pages() {
  const bool open = study_ != nullptr;
  navigation_->setVisible(open);
  line_->setVisible(open);
  close_action_->setEnabled(open);
  share_action_->setEnabled(open && Study::can_be_written(study_->folder()));
  metadata_action_->setEnabled(share_action_->isEnabled());
  if (!open) {
    setWindowTitle(tr("Asperity"));
    pages_->setCurrentWidget(welcome_);
    welcome_->show_recent();
    return;
  }
  setWindowTitle(tr("%1 – Asperity").arg(QString::fromStdString(study_->study().name())));
  add_pages();
  emit study_opened(study_.get());
  navigation_->setCurrentRow(0);
  tell_limits();
}

void StudyWindow::tell_limits() {
  if (const std::vector<std::string>& problems = study_->plugin_problems(); !problems.empty()) {
    QStringList sentences{};
    for (const std::string& problem : problems) sentences.append(QString::fromStdString(problem));
    banner_->show_news(
        State::look,
        tr("A plug-in was not loaded (Study → Plug-ins…): %1").arg(sentences.join("; ")));
  } else if (!study_->can_be_written()) {
    banner_->show_news(State::look,
                       tr("This study is read-only: its folder or its disk cannot be written to. "
                          "It can be viewed, analysed and exported; to run sessions, copy it to a "
                          "folder that you may write to."));
  }
}

void StudyWindow::remove_pages() {
  if (pages_ == nullptr) return;
  // Otherwise each page would show the one before it as it goes, which would begin to look for devices, or to read.
  pages_->setCurrentWidget(welcome_);
  for_later_.clear();
  navigation_->clear();
  for (int i = pages_->count() - 1; i >= 0; --i) {
    QWidget* widget = pages_->widget(i);
    if (widget == welcome_) continue;
    pages_->removeWidget(widget);
    delete widget;
  }
}

void StudyWindow::add_page(const QString& key, const QString& name, QWidget* page) {
  take_over(key, page);
  if (!name.isEmpty()) navigation_->add_page(key, name);
}

void StudyWindow::add_page_for_later(const QString& key, const QString& name,
                                     std::function<QWidget*()> make) {
  for_later_[key] = std::move(make);
  if (!name.isEmpty()) navigation_->add_page(key, name);
}

void StudyWindow::take_over(const QString& key, QWidget* page) {
  page->setProperty("page", key);
  pages_->addWidget(page);
}

void StudyWindow::show_page(const QString& key) {
  QWidget* widget = page(key);
  if (widget == nullptr) return;
  pages_->setCurrentWidget(widget);
  navigation_->select(key);
}

QString StudyWindow::shown_page() const {
  if (pages_ == nullptr || pages_->currentWidget() == nullptr) return {};
  return pages_->currentWidget()->property("page").toString();
}

QWidget* StudyWindow::page(const QString& key) {
  if (auto make = for_later_.extract(key)) take_over(key, make.mapped()());
  return made_page(key);
}

QWidget* StudyWindow::made_page(const QString& key) const {
  for (int i = 0; pages_ != nullptr && i < pages_->count(); ++i) {
    if (pages_->widget(i)->property("page").toString() == key) return pages_->widget(i);
  }
  return nullptr;
}

void StudyWindow::set_count(const QString& key, const QString& count) {
  navigation_->set_count(key, count);
}

bool StudyWindow::open_study(const std::filesystem::path& place,
                             const std::function<void()>& opened) {
  std::error_code unknown{};  // of a removed current folder; an empty path is no study
  const std::filesystem::path folder = std::filesystem::absolute(place, unknown).lexically_normal();
  if (must_stay([this, folder, opened] { open_study(folder, opened); })) return false;
  const auto is_open = std::make_shared<bool>(false);
  with_plugins(
      plugin_files(),
      [this, folder, opened, is_open](const LoadedModels& models) {
        *is_open = show_study(folder, models);
        if (*is_open && opened) opened();
      },
      tr("The study was not opened, because loading the plug-ins was cancelled. Open it again, or "
         "remove plug-ins (Study → Plug-ins…)."));
  return *is_open;
}

bool StudyWindow::show_study(const std::filesystem::path& folder, const LoadedModels& models) {
  std::unique_ptr<OpenStudy> opened{};
  QString name{};
  try {
    opened = std::make_unique<OpenStudy>(folder, models);
    name = QString::fromStdString(opened->study().name());
  } catch (const std::exception& error) {
    banner_->show_news(State::stop,
                       tr("The study could not be opened: %1").arg(words_of(phrase_of(error))));
    return false;
  }
  close_study();
  study_ = std::move(opened);
  remember_study(study_->folder(), name);
  banner_->hide();
  connect(study_.get(), &OpenStudy::changed, this,
          [this] { seen_store_ = state_of_store(study_->folder()); });
  seen_store_ = state_of_store(study_->folder());
  watcher_->addPath(QString::fromStdString(study_->folder().string()));
  make_pages();
  return true;
}

void StudyWindow::close_study() {
  if (study_ == nullptr) return;
  if (const QStringList watched = watcher_->directories(); !watched.isEmpty()) {
    watcher_->removePaths(watched);
  }
  remove_pages();
  study_.reset();
  banner_->hide();
  make_pages();
}

void StudyWindow::add_line(QWidget* line) {
  qobject_cast<QVBoxLayout*>(centralWidget()->layout())->insertWidget(1, line);
}

void StudyWindow::set_busy(const QString& reason) { busy_ = reason; }

ProtocolEditorPage* StudyWindow::editor() const {
  return pages_ == nullptr ? nullptr : qobject_cast<ProtocolEditorPage*>(made_page("editor"));
}

bool StudyWindow::must_stay(std::function<void()> again) {
  if (loading_ != nullptr || refuse_when_busy()) return true;
  if (editor() == nullptr || editor()->may_leave(std::move(again))) return false;
  show_page("editor");
  return true;
}

bool StudyWindow::refuse_when_busy() {
  if (busy_.isEmpty()) return false;
  banner_->show_news(State::look, busy_);
  return true;
}

bool StudyWindow::refuse_to_cover() { return refuse_when_busy() || refuse_for_a_page("uncovered"); }

bool StudyWindow::refuse_for_a_page(const char* property) {
  for (int i = 0; i < pages_->count(); ++i) {
    const QString reason = pages_->widget(i)->property(property).toString();
    if (reason.isEmpty()) continue;
    banner_->show_news(State::look, reason);
    return true;
  }
  return false;
}

void StudyWindow::watch_folder() {
  if (study_ == nullptr || Study::exists(study_->folder())) return;
  banner_->show_news(
      State::stop,
      tr("The study is no longer at %1: its folder was removed or renamed, or is on a disk that "
         "is no longer connected. Restore the folder, or close the study.")
          .arg(text_of_path(study_->folder())),
      tr("Close study"), [this] { close_action_->trigger(); });
}

void StudyWindow::look_whether_changed() {
  if (study_ == nullptr) return;
  watch_folder();
  if (state_of_store(study_->folder()) != seen_store_) study_->announce_change();
}

void StudyWindow::changeEvent(QEvent* event) {
  // Another program may have written meanwhile; while this one runs a session, it says so itself.
  if (event->type() == QEvent::ActivationChange && isActiveWindow() && busy_.isEmpty()) {
    look_whether_changed();
  }
  QMainWindow::changeEvent(event);
}

void StudyWindow::closeEvent(QCloseEvent* event) {
  if (loading_ != nullptr) {
    loading_->reject();
  } else if (must_stay([this] { close(); })) {
    event->ignore();
    return;
  }
  remember_geometry(*this, kGeometry);
  QMainWindow::closeEvent(event);
}

void StudyWindow::make_menus() {
  menuBar()->clear();
  make_study_menu();
  make_view_menu();
  make_help_menu();
}

void StudyWindow::make_study_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&Study"));
  menu->addAction(tr("&New…"), QKeySequence::New, this, &StudyWindow::ask_for_new_study);
  menu->addAction(tr("&Open…"), QKeySequence::Open, this, &StudyWindow::ask_for_study);
  menu->addAction(tr("Open the &demo study"), this, &StudyWindow::open_demo);
  QMenu* recent = menu->addMenu(tr("&Recent"));
  connect(recent, &QMenu::aboutToShow, this, [this, recent] { fill_recent_menu(*recent); });
  menu->addSeparator();
  metadata_action_ = menu->addAction(tr("&Metadata…"), this, &StudyWindow::ask_for_metadata);
  metadata_action_->setObjectName("menu_metadata");
  share_action_ = menu->addAction(tr("S&hare…"), this, &StudyWindow::ask_whom_to_share_with);
  share_action_->setObjectName("menu_share_study");
  menu->addAction(tr("&Plug-ins…"), this, &StudyWindow::ask_for_plugins)
      ->setObjectName("menu_plugins");
  close_action_ = menu->addAction(tr("&Close"), QKeySequence::Close, this, [this] {
    if (!must_stay([this] { close_study(); })) close_study();
  });
  menu->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);
}

void StudyWindow::fill_recent_menu(QMenu& menu) {
  menu.clear();
  for (const RecentStudy& study : recent_studies()) {
    QString text = tr("%1 (%2)").arg(study.name, text_of_path(study.folder));
    text.replace('&', "&&");
    menu.addAction(text, this, [this, folder = study.folder] { open_study(folder); });
  }
  if (menu.isEmpty()) menu.addAction(tr("No study has been opened yet"))->setEnabled(false);
}

void StudyWindow::make_view_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  QMenu* themes = menu->addMenu(tr("&Theme"));
  auto* theme_group = new QActionGroup(themes);
  const auto add_theme = [&](const QString& name, ThemeChoice choice) {
    QAction* action = themes->addAction(name, this, [this, choice] { choose_theme(choice); });
    action->setCheckable(true);
    theme_group->addAction(action);
    // A choice may have been refused.
    connect(themes, &QMenu::aboutToShow, action,
            [action, choice] { action->setChecked(theme_choice() == choice); });
  };
  add_theme(tr("Use &system setting"), ThemeChoice::system);
  add_theme(tr("&Light"), ThemeChoice::light);
  add_theme(tr("&Dark"), ThemeChoice::dark);

  QMenu* languages = menu->addMenu(tr("L&anguage"));
  auto* language_group = new QActionGroup(languages);
  const auto add_language = [&](const QString& name, const QString& code) {
    QAction* action = languages->addAction(name, this, [this, code] { choose_language(code); });
    action->setCheckable(true);
    language_group->addAction(action);
    connect(languages, &QMenu::aboutToShow, action,
            [action, code] { action->setChecked(language_choice() == code); });
  };
  add_language(tr("Use &system setting"), "system");
  for (const QString& code : available_languages()) {
    add_language(text_of_language(code.toStdString()), code);
  }
}

void StudyWindow::make_help_menu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  menu->addAction(tr("&Documents"), QKeySequence::HelpContents, this, [this] {
    if (!refuse_to_cover()) (new DocumentDialog("README.md", this))->show();
  });
  menu->addAction(tr("&About Asperity"), this, &StudyWindow::show_about);
}

void StudyWindow::show_about() {
  if (!refuse_to_cover()) (new AboutDialog(this))->open();
}

void StudyWindow::refill_after(const std::function<void()>& change) {
  if (loading_ != nullptr || refuse_when_busy() || refuse_for_a_page("keep")) return;
  // In the language in which it was typed.
  if (editor() != nullptr && !editor()->commit()) return show_page("editor");
  change();
  QMetaObject::invokeMethod(this, &StudyWindow::refill, Qt::QueuedConnection);
}

void StudyWindow::choose_theme(ThemeChoice choice) {
  refill_after([choice] {
    remember_theme(choice);
    apply_theme(*qobject_cast<QApplication*>(QCoreApplication::instance()), choice);
  });
}

void StudyWindow::choose_language(const QString& code) {
  refill_after([code] {
    remember_language(code);
    apply_language(code);
  });
}

void StudyWindow::ask_for_new_study() {
  if (refuse_to_cover()) return;
  auto* dialog = new NewStudyDialog(place_of_studies(), this);
  connect(dialog, &NewStudyDialog::wanted, this, &StudyWindow::make_new_study);
  dialog->open();
}

void StudyWindow::ask_whom_to_share_with() {
  if (study_ == nullptr || refuse_to_cover()) return;
  auto* dialog = new ShareStudyDialog(study_->folder(), this);
  connect(dialog, &ShareStudyDialog::wanted, this, &StudyWindow::share_with);
  dialog->open();
}

void StudyWindow::ask_for_metadata() {
  if (study_ == nullptr || refuse_to_cover()) return;
  auto* dialog = new MetadataDialog(study_->study().metadata(), this);
  connect(dialog, &MetadataDialog::wanted, this, &StudyWindow::store_metadata);
  dialog->open();
}

void StudyWindow::store_metadata(const StudyMetadata& metadata) {
  if (study_ == nullptr) return;
  try {
    Study::open(study_->folder(), Access::read_write).set_metadata(metadata);
    study_->announce_change();
    banner_->show_news(State::fine, tr("The metadata of the study have been stored."));
  } catch (const std::exception& error) {
    banner_->show_news(State::stop,
                       tr("The metadata could not be stored: %1").arg(words_of(phrase_of(error))));
  }
}

void StudyWindow::share_with(const QString& group) {
  if (study_ == nullptr) return;
  try {
    share_study(study_->folder(), group.toStdString());
    if (const auto closed = folder_closed_to_group(study_->folder())) {
      banner_->show_news(State::look,
                         tr("The study is shared with the group %1, but its members cannot access "
                            "it: they have no permission for the folder %2. Give the group access "
                            "to that folder, or move the study out of it.")
                             .arg(group, QString::fromStdString(closed->string())));
      return;
    }
    banner_->show_news(
        State::fine,
        tr("The study is shared with the group %1. Other users cannot read it.").arg(group));
  } catch (const std::exception& error) {
    banner_->show_news(State::stop,
                       tr("The study could not be shared: %1").arg(words_of(phrase_of(error))));
  }
}

void StudyWindow::make_new_study(const std::filesystem::path& folder,
                                 const StudyMetadata& metadata) {
  if (make_task_.is_running()) return;
  make_task_.run<bool>(
      [folder, metadata](const std::stop_token&, const BackgroundTask::Progress&) {
        std::filesystem::create_directories(folder.parent_path());
        new_study(folder, {.metadata = metadata});
        return true;
      },
      [this, folder](bool) { open_study(folder); },
      [this](const QString& what) {
        banner_->show_news(State::stop, tr("The study could not be created: %1").arg(what));
      });
}

void StudyWindow::ask_for_study() {
  if (refuse_to_cover()) return;
  const std::filesystem::path place = place_of_studies();
  auto* chooser = new QFileDialog(
      this, tr("Open the folder of a study"),
      std::filesystem::exists(place) ? QString::fromStdString(place.string()) : QDir::homePath());
  chooser->setAttribute(Qt::WA_DeleteOnClose);
  chooser->setFileMode(QFileDialog::Directory);
  chooser->setOption(QFileDialog::ShowDirsOnly);
  connect(chooser, &QFileDialog::fileSelected, this,
          [this](const QString& folder) { open_chosen(folder.toStdString()); });
  chooser->open();
}

void StudyWindow::open_chosen(const std::filesystem::path& folder) {
  // The empty folder of a known study is that of a disk that is not connected.
  const bool is_known = std::ranges::any_of(
      recent_studies(), [&folder](const RecentStudy& study) { return study.folder == folder; });
  if (is_known || !may_become_study(folder)) {
    open_study(folder);
    return;
  }
  banner_->show_news(
      State::look,
      tr("%1 is an empty folder and not yet a study. It can become one.").arg(text_of_path(folder)),
      tr("Create here"), [this, folder] { make_new_study(folder, {}); });
}

void StudyWindow::open_demo() {
  if (must_stay([this] { open_demo(); })) return;
  close_study();
  welcome_->open_demo();
}

}  // namespace asperity

#include "moc_study_window.cpp"
