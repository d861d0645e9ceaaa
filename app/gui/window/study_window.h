// The window that the program opens with: a study and its pages, or the welcome page.

#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include <QtCore/QPointer>
#include <QtWidgets/QDialog>
#include <QtWidgets/QMainWindow>

#include "app/gui/base/loaded_models.h"
#include "app/gui/base/open_study.h"
#include "app/gui/base/session_wish.h"
#include "app/gui/look/background_task.h"
#include "app/gui/look/theme.h"

class QFileSystemWatcher;
class QFrame;
class QStackedWidget;

namespace asperity {

class Banner;
class NavigationList;
class ProtocolEditorPage;
class WelcomePage;

/// Navigation at the left, the pages of the study at the right, news above them.
///
/// What other parts of the program rely on:
/// - `add_page` puts a page into the navigation; one without a name is reached by `show_page` only.
/// - After `study_opened` every page can be had and belongs to that study; pages are made anew with
///   every study, theme and language, the large ones when somebody first wants them. A page with
///   something half done that would be lost says so in its property "keep", a sentence: theme and
///   language then stay, and the sentence is shown. One whose buttons have to stay in reach says so in
///   its property "uncovered": the window's menus open no dialog over it then.
/// - `session_wanted` says that somebody wants to run a session; whoever runs sessions connects it.
///   Until then the pages offer no session to start.
/// - Whatever closes the study asks first when the protocol editor has unsaved changes; another theme or language keeps them.
class StudyWindow final : public QMainWindow {
  Q_OBJECT
 public:
  explicit StudyWindow(QWidget* parent = nullptr);
  ~StudyWindow() override;

  /// Shows the study's pages in place of what was shown, then calls `opened`. States on the banner what went wrong.
  ///
  /// Returns whether the study is open now. With plug-ins in the settings it is not: a dialog shows the progress of their checks
  /// first and can cancel them.
  bool open_study(const std::filesystem::path& place, const std::function<void()>& opened = {});
  void close_study();
  /// Null while the welcome page is shown.
  OpenStudy* study() const noexcept { return study_.get(); }

  /// The window takes the page over. `key` is how `show_page` knows it; with an empty `name` it is
  /// not in the navigation.
  void add_page(const QString& key, const QString& name, QWidget* page);
  /// Likewise, but the page is made by `page` or `show_page`: opening a study need not wait for what takes
  /// long to make.
  void add_page_for_later(const QString& key, const QString& name, std::function<QWidget*()> make);
  void show_page(const QString& key);
  QString shown_page() const;
  /// Null when there is none of this key.
  QWidget* page(const QString& key);
  void set_count(const QString& key, const QString& count);

  Banner& banner() noexcept { return *banner_; }
  /// Below the banner, above every page, until the window is made anew for another theme or language.
  void add_line(QWidget* line);
  /// While it says something, no other study, theme or language can be chosen and the window does
  /// not close; the sentence is shown as the reason.
  void set_busy(const QString& reason);

 signals:
  void study_opened(asperity::OpenStudy* study);
  void session_wanted(const asperity::SessionWish& wish);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void make_menus();
  void make_study_menu();
  void make_view_menu();
  void make_help_menu();
  void fill_recent_menu(QMenu& menu);
  void make_pages();
  /// On the banner: a plug-in was not loaded, or the study can only be read.
  void tell_limits();
  void add_pages();  ///< study_pages.cpp
  void use_renderings(const QStringList& renderings);
  void open_in_workbench(const QString& file);
  void remove_pages();
  QWidget* made_page(const QString& key) const;  ///< null also where it is still to be made
  void take_over(const QString& key, QWidget* page);
  /// Everything anew in the theme and language of now.
  void refill();
  bool refuse_when_busy();
  /// Busy, plug-ins are being loaded, or the editor asks what is to become of unsaved changes and does `again` afterwards.
  bool must_stay(std::function<void()> again);
  ProtocolEditorPage* editor() const;
  /// Changes the theme or the language, unless a page is still at work.
  void refill_after(const std::function<void()>& change);
  bool refuse_to_cover();
  bool refuse_for_a_page(const char* property);
  void choose_theme(ThemeChoice choice);
  void choose_language(const QString& code);
  void ask_for_new_study();
  void ask_for_study();
  /// Opens the study in a folder that the user has just chosen, or offers to make one where the folder is empty.
  void open_chosen(const std::filesystem::path& folder);
  void open_demo();
  void ask_whom_to_share_with();
  void ask_for_plugins();
  void load_plugins(const std::vector<std::filesystem::path>& files);
  /// Calls `use` with the models when the plug-ins are loaded, at once without any. `cancelled` goes to the banner.
  void with_plugins(const std::vector<std::filesystem::path>& files,
                    std::function<void(const LoadedModels&)> use, const QString& cancelled);
  bool show_study(const std::filesystem::path& folder, const LoadedModels& models);
  void share_with(const QString& group);
  void make_new_study(const std::filesystem::path& folder, const StudyMetadata& metadata);
  void ask_for_metadata();
  void store_metadata(const StudyMetadata& metadata);
  void watch_folder();
  void look_whether_changed();
  void show_about();

  Banner* banner_ = nullptr;
  NavigationList* navigation_ = nullptr;
  QFrame* line_ = nullptr;  ///< between navigation and pages
  QStackedWidget* pages_ = nullptr;
  std::map<QString, std::function<QWidget*()>> for_later_{};  ///< pages that nobody has wanted yet
  WelcomePage* welcome_ = nullptr;
  QAction* close_action_ = nullptr;
  QAction* share_action_ = nullptr;
  QAction* metadata_action_ = nullptr;
  QFileSystemWatcher* watcher_ = nullptr;
  std::unique_ptr<OpenStudy> study_{};
  BackgroundTask make_task_{};
  QString busy_{};
  QString seen_store_{};         ///< times and sizes of the store's files
  QPointer<QDialog> loading_{};  ///< while plug-ins are loaded
};

}  // namespace asperity
