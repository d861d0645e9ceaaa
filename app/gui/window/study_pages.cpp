// The pages of a study, in the order of the navigation.

#include "app/gui/data/analysis_page.h"
#include "app/gui/data/attempt_page.h"
#include "app/gui/devices/device_test_page.h"
#include "app/gui/editor/protocol_editor_page.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/study/devices_page.h"
#include "app/gui/study/participants_page.h"
#include "app/gui/study/protocols_page.h"
#include "app/gui/study/sessions_page.h"
#include "app/gui/study/stimuli_page.h"
#include "app/gui/study/trials_page.h"
#include "app/gui/study/use_rendering_dialog.h"
#include "app/gui/window/study_window.h"
#include "app/gui/workbench/surface_dialog.h"
#include "app/gui/workbench/workbench_page.h"

namespace asperity {

void StudyWindow::add_pages() {
  auto* protocols = new ProtocolsPage(*study_);
  auto* participants = new ParticipantsPage(*study_);
  auto* sessions = new SessionsPage(*study_);
  auto* trials = new TrialsPage(*study_);
  auto* stimuli = new StimuliPage(*study_);
  auto* devices = new DevicesPage(*study_);
  add_page("protocols", tr("Protocols"), protocols);
  add_page_for_later("editor", {}, [this, protocols] {
    auto* editor = new ProtocolEditorPage(*study_);
    connect(editor, &ProtocolEditorPage::back_wanted, this, [this, protocols, editor] {
      protocols->select_file(path_text(editor->file()));
      show_page("protocols");
    });
    return editor;
  });
  add_page("participants", tr("Participants"), participants);
  add_page("sessions", tr("Sessions"), sessions);
  add_page("trials", {}, trials);
  add_page_for_later("attempt", {}, [this] {
    auto* attempt = new AttemptPage(*study_);
    connect(attempt, &AttemptPage::back_wanted, this, [this] { show_page("trials"); });
    return attempt;
  });
  add_page("stimuli", tr("Stimuli"), stimuli);
  add_page_for_later("workbench", tr("Workbench"), [this] {
    auto* workbench = new WorkbenchPage(*study_);
    connect(workbench, &WorkbenchPage::use_wanted, this, &StudyWindow::use_renderings);
    return workbench;
  });
  add_page("analysis", tr("Analysis"), new AnalysisPage(*study_));
  add_page("devices", tr("Devices"), devices);
  auto* device_test = new DeviceTestPage(*study_);
  add_page("device_test", {}, device_test);

  for (StudyPage* page :
       std::initializer_list<StudyPage*>{participants, sessions, stimuli, devices}) {
    connect(page, &StudyPage::counted, this, [this, page](const QString& count) {
      set_count(page->property("page").toString(), count);
    });
  }
  set_count("devices", devices->count());
  const auto show_sessions = [this, sessions](const QString& words) {
    sessions->set_filter(words);
    show_page("sessions");
  };
  connect(participants, &ParticipantsPage::sessions_wanted, this, show_sessions);
  connect(protocols, &ProtocolsPage::session_wanted, this, &StudyWindow::session_wanted);
  connect(protocols, &ProtocolsPage::sessions_wanted, this, [this] { show_page("sessions"); });
  connect(protocols, &ProtocolsPage::edit_wanted, this, [this](const QString& file) {
    show_page("editor");
    editor()->open(file.toStdString());
  });
  connect(stimuli, &StimuliPage::use_wanted, this, &StudyWindow::use_renderings);
  connect(stimuli, &StimuliPage::open_wanted, this, &StudyWindow::open_in_workbench);
  connect(stimuli, &StimuliPage::generate_wanted, this, [this, stimuli] {
    auto* dialog = new SurfaceDialog(*study_, this);
    connect(dialog, &SurfaceDialog::saved, stimuli, [this, stimuli](const QString& path) {
      stimuli->select_later(path);
      study_->announce_change();
    });
    dialog->open();
  });
  connect(sessions, &SessionsPage::session_wanted, this, &StudyWindow::session_wanted);
  connect(sessions, &SessionsPage::session_opened, this, [this, trials](qlonglong id) {
    trials->show_session(id);
    show_page("trials");
  });
  connect(devices, &DevicesPage::test_wanted, this,
          [this, device_test](const TestedDevice& device) {
            device_test->show_device(device);
            show_page("device_test");
          });
  connect(device_test, &DeviceTestPage::back_wanted, this, [this] { show_page("devices"); });
  connect(trials, &TrialsPage::attempt_opened, this, [this](qlonglong id) {
    qobject_cast<AttemptPage*>(page("attempt"))->show_attempt(id);
    show_page("attempt");
  });
  connect(trials, &TrialsPage::back_wanted, this, [this] { show_page("sessions"); });
}

void StudyWindow::open_in_workbench(const QString& file) {
  auto* workbench = qobject_cast<WorkbenchPage*>(page("workbench"));
  const auto open = [this, workbench, file] {
    show_page("workbench");
    workbench->open_file(file.toStdString());
  };
  if (workbench->property("keep").toString().isEmpty()) return open();
  banner_->show_news(State::look, tr("The relief in the workbench is not saved and would be lost."),
                     tr("Open anyway"), open);
}

void StudyWindow::use_renderings(const QStringList& renderings) {
  std::vector<std::filesystem::path> files{};
  for (const QString& file : renderings) files.emplace_back(file.toStdString());
  auto* dialog = new UseRenderingDialog(
      *study_, std::move(files),
      [this](const std::filesystem::path& protocol) -> std::optional<std::string> {
        if (editor() == nullptr || editor()->file() != protocol) return {};
        return editor()->content();
      },
      this);
  connect(dialog, &UseRenderingDialog::wanted, this,
          [this](const std::filesystem::path& protocol, const std::string& before,
                 const std::string& after, const QString& rendering) {
            show_page("editor");
            editor()->open_changed(protocol, before, after,
                                   tr("The values of “%1” were copied. Save the protocol to keep "
                                      "them; Undo takes them back.")
                                       .arg(rendering));
          });
  dialog->open();
}

}  // namespace asperity
