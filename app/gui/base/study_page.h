// What the pages of a study have in common: a title, a banner, and a look into the study that is
// repeated when something has changed.

#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include <QtWidgets/QWidget>

#include "app/gui/base/open_study.h"
#include "app/gui/base/repeated_read.h"
#include "app/gui/look/controls.h"

class QHBoxLayout;
class QStackedLayout;
class QVBoxLayout;

namespace asperity {

class StudyPage : public QWidget {
  Q_OBJECT
 public:
  /// Reads the study again, soon.
  void refresh();

 signals:
  /// What is in it, for the navigation.
  void counted(const QString& count);

 protected:
  StudyPage(OpenStudy& study, const QString& title, QWidget* parent);

  OpenStudy& study() noexcept { return study_; }
  Banner& banner() noexcept { return *banner_; }
  QLabel& title() noexcept { return *title_; }
  /// For what belongs at the right of the title.
  QHBoxLayout& head() noexcept { return *head_; }
  QVBoxLayout& body() noexcept { return *body_; }
  /// Takes the place of the body while there is nothing to show.
  void set_empty_state(EmptyState* empty);
  void show_empty(bool empty);

  /// When a reading is needed: for what the navigation says of the page, or for what it shows.
  enum class Need { always, when_shown };

  /// `read` runs on a thread of its own with a Study of its own, as soon as it is needed and again
  /// after every change; what it returns goes to `show` on the GUI thread, what it throws to the
  /// banner.
  template <class Result>
  void read_with(Need need, std::function<Result(const Study&, const std::stop_token&)> read,
                 std::function<void(const Result&)> show) {
    add_reading(
        need,
        new RepeatedRead(
            std::function<std::shared_ptr<const Result>(const std::stop_token&)>(
                [folder = study_.folder(), read = std::move(read)](const std::stop_token& stop) {
                  const Study own = Study::open(folder, Access::read_only);
                  return std::make_shared<const Result>(read(own, stop));
                }),
            std::function<void(std::shared_ptr<const Result>)>(
                [show = std::move(show)](const std::shared_ptr<const Result>& result) {
                  show(*result);
                }),
            std::function<void(QString)>([this](const QString& what) { show_failure(what); }),
            this));
  }
  /// Ends all readings; the page shows what it shows until there are others.
  void forget_readings();

  void showEvent(QShowEvent* event) override;

 private:
  void add_reading(Need need, RepeatedRead* reading);
  void show_failure(const QString& what);

  OpenStudy& study_;
  Banner* banner_ = nullptr;
  QLabel* title_ = nullptr;
  QHBoxLayout* head_ = nullptr;
  QVBoxLayout* body_ = nullptr;
  QStackedLayout* stack_ = nullptr;
  std::vector<RepeatedRead*> always_{};
  std::vector<RepeatedRead*> when_shown_{};
  bool stale_ = true;  ///< what is read when shown
};

}  // namespace asperity
