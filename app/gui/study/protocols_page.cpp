// Fills a table and a detail view from the overviews, and adds the examination of stimuli when it arrives.

#include "app/gui/study/protocols_page.h"

#include <algorithm>

#include <QtCore/QFileInfo>
#include <QtCore/QFileSystemWatcher>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QSplitter>
#include <QtWidgets/QStackedWidget>
#include <nlohmann/json.hpp>

#include "app/gui/base/command_lines.h"
#include "app/gui/base/form_words.h"
#include "app/gui/base/progress_cell.h"
#include "app/gui/base/settings.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"
#include "app/gui/plan/plan_preview.h"
#include "app/gui/study/interrupted_news.h"
#include "app/gui/study/protocol_file_actions.h"
#include "app/gui/study/protocol_texts.h"
#include "app/gui/study/template_dialog.h"
#include "protocols/plan/groups.h"

namespace asperity {

namespace {

constexpr int kStateColumn = 5;
constexpr int kVirtualParticipants = 12;
constexpr int kLeastBelow = 48;
constexpr int kMostGroupWidth = 280;

/// Its pages scroll: they take the height that is left, whatever their texts would need.
class ScrolledPages final : public QStackedWidget {
 public:
  using QStackedWidget::QStackedWidget;
  bool hasHeightForWidth() const override { return false; }
};

}  // namespace

ProtocolsPage::ProtocolsPage(OpenStudy& study, QWidget* parent)
    : StudyPage(study, tr("Protocols"), parent) {
  setObjectName("protocols_page");
  QPushButton* add = make_button(tr("Create from template…"), ButtonRole::plain, this);
  add->setObjectName("protocols_new");
  connect(add, &QPushButton::clicked, this, &ProtocolsPage::choose_template);
  examining_ = make_text({}, this, true);
  examining_->setObjectName("protocols_examining");
  examining_->setWordWrap(false);
  head().addWidget(examining_);
  if (!study.can_be_written()) head().addWidget(make_text(tr("Read-only"), this, true));
  head().addWidget(add);
  auto* empty = new EmptyState(
      tr("No protocols yet"),
      tr("A protocol defines stimuli, tasks and trial order. Begin with one from the library, or "
         "copy a protocol file into the study's folder “protocols”: it appears here at once."),
      this);
  auto* first = empty->add_action(tr("Create from template…"), ButtonRole::primary,
                                  [this] { choose_template(); });
  set_empty_state(empty);
  for (QPushButton* button : {add, first}) button->setEnabled(study.can_be_written());

  interrupted_ = new Banner(this);
  interrupted_->setObjectName("protocols_interrupted");
  body().addWidget(interrupted_);
  splitter_ = make_splitter(Qt::Vertical, this);
  using Align = StudyTable::Align;
  table_ = new StudyTable({{tr("Protocol"), 0, Align::text},
                           {tr("Name"), 192, Align::text},
                           {tr("Kind"), 120, Align::text},
                           {tr("Version"), 80, Align::text},
                           {tr("Participants"), 168, Align::text},
                           {tr("State"), 144, Align::text}},
                          splitter_);
  table_->setObjectName("protocols_table");
  table_->setAccessibleName(tr("Protocols"));
  table_->setItemDelegateForColumn(4, new ProgressDelegate(table_));
  table_->wrap_texts();
  table_->leave_out_when_tight({3, 2, 1});  // which the card below states as well
  splitter_->addWidget(table_);
  splitter_->addWidget(make_detail());
  splitter_->setStretchFactor(0, 0);
  splitter_->setStretchFactor(1, 1);
  body().addWidget(splitter_, 1);
  // Until the experimenter moves the border.
  splitter_->installEventFilter(this);
  connect(table_, &StudyTable::rows_fitted, this, &ProtocolsPage::share_height);
  connect(splitter_, &QSplitter::splitterMoved, this, [this] { is_shared_by_hand_ = true; });

  connect(table_, &StudyTable::row_selected, this, &ProtocolsPage::show_selected);
  connect(table_, &StudyTable::row_opened, this, [this] { start_->animateClick(); });
  connect(&study.examiner(), &StimulusExaminer::held_changed, this,
          &ProtocolsPage::show_whether_examined);
  watcher_ = new QFileSystemWatcher(this);
  connect(watcher_, &QFileSystemWatcher::directoryChanged, this, &ProtocolsPage::refresh);
  connect(watcher_, &QFileSystemWatcher::fileChanged, this, &ProtocolsPage::refresh);
  watch_files();
  read_with<std::vector<ProtocolOverview>>(
      Need::when_shown,  // it builds every stimulus: not beside a session that runs
      [&models = study.models()](const Study& own, const std::stop_token& stop) {
        return protocol_overviews(own, models, stop);
      },
      [this](const std::vector<ProtocolOverview>& protocols) { show_protocols(protocols); });
  read_with<std::vector<InterruptedSession>>(
      Need::when_shown,
      [](const Study& own, const std::stop_token& stop) { return interrupted_sessions(own, stop); },
      [this](const std::vector<InterruptedSession>& sessions) { show_interrupted(sessions); });
}

void ProtocolsPage::select_file(const QString& file) {
  table_->select(file);
  if (table_->selected_key() != file) select_next_ = file;
}

/// The table has the rows that fit into half of the height, and ends below the last of them. It has fewer where the buttons of
/// the card below it need the room. The selected row stays in sight.
void ProtocolsPage::share_height() {
  if (is_shared_by_hand_) return;
  const QModelIndexList selected = table_->selectionModel()->selectedRows();
  const bool is_seen = !selected.isEmpty() &&
                       table_->viewport()->rect().intersects(table_->visualRect(selected.front()));
  const int both = splitter_->height() - splitter_->handleWidth();
  const int card = detail_->layout()->totalMinimumHeightForWidth(splitter_->width());
  const int table = table_->height_of_rows_within(std::min(both / 2, both - card));
  splitter_->setSizes({table, both - table});
  if (is_seen) table_->scrollTo(selected.front());
}

bool ProtocolsPage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == splitter_ && event->type() == QEvent::Resize) share_height();
  return StudyPage::eventFilter(watched, event);
}

void ProtocolsPage::showEvent(QShowEvent* event) {
  StudyPage::showEvent(event);
  examine_stimuli();
}

void ProtocolsPage::hideEvent(QHideEvent* event) {
  study().examiner().withdraw(this);
  StudyPage::hideEvent(event);
}

QWidget* ProtocolsPage::make_detail() {
  QVBoxLayout* layout = nullptr;
  QFrame* card = make_card(this, layout);
  detail_ = card;
  name_ = make_heading({}, card);
  name_->setObjectName("protocol_name");
  facts_ = make_text({}, card);
  facts_->setObjectName("protocol_facts");
  last_run_ = make_text({}, card, true);
  last_run_->setObjectName("protocol_last_run");
  layout->addWidget(name_);
  layout->addWidget(facts_);
  layout->addWidget(last_run_);

  auto* row = new WrappingRow(nullptr, kGrid);
  start_ = make_button(tr("Start session…"), ButtonRole::primary, card);
  start_->setObjectName("protocol_start");
  edit_ = make_button(tr("Edit"), ButtonRole::plain, card);
  edit_->setObjectName("protocol_edit");
  preview_ = make_button(tr("Preview plan"), ButtonRole::plain, card);
  preview_->setObjectName("protocol_preview");
  simulate_ = make_button(tr("Simulate…"), ButtonRole::plain, card);
  simulate_->setObjectName("protocol_simulate");
  simulate_several_ = make_button(tr("Simulate %n participants", nullptr, kVirtualParticipants),
                                  ButtonRole::plain, card);
  simulate_several_->setObjectName("protocol_simulate_several");
  simulate_several_->setToolTip(
      tr("Virtual participants, in the background. Their results are then shown. “Simulate…” "
         "offers another number."));
  by_mouse_ = make_button(tr("Try it with the mouse"), ButtonRole::plain, card);
  by_mouse_->setObjectName("protocol_by_mouse");
  by_mouse_->setToolTip(tr("Two trials, without force, in a temporary copy. Nothing is stored."));
  mouse_group_ = new ChoiceBox(card);
  mouse_group_->setObjectName("protocol_mouse_group");
  mouse_group_->setAccessibleName(tr("Group of the trial with the mouse"));
  mouse_group_->setToolTip(tr("Group of the participant in the trial with the mouse"));
  mouse_group_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  mouse_group_->setMaximumWidth(kMostGroupWidth);
  mouse_group_->hide();
  reason_ = make_text(tr("The protocols are being read."), card, true);
  reason_->setObjectName("protocol_reason");
  for (QWidget* widget : std::initializer_list<QWidget*>{start_, edit_, preview_, simulate_,
                                                         simulate_several_, by_mouse_}) {
    widget->setEnabled(false);  // until there is a protocol
  }
  file_actions_ = new ProtocolFileActions(study(), card);
  QPushButton* shown_commands = make_commands_button([this] { return commands(); }, card);
  close_ = make_button(tr("Close the plan"), ButtonRole::link, card);
  close_->setObjectName("protocol_close_below");
  for (QPushButton* const button : {start_, edit_, preview_, simulate_, simulate_several_}) {
    row->addWidget(button);
  }
  auto* by_mouse = new QHBoxLayout();  // next to each other where the row wraps
  by_mouse->setSpacing(kGrid);
  by_mouse->addWidget(by_mouse_);
  by_mouse->addWidget(mouse_group_);
  row->add_layout(by_mouse);
  for (QPushButton* const button : {file_actions_->button(), shown_commands, close_}) {
    row->addWidget(button);
  }
  close_->hide();
  layout->addSpacing(kGrid);
  layout->addLayout(row);
  layout->addWidget(reason_);
  layout->addWidget(file_actions_);
  layout->addSpacing(kGrid);

  below_ = new ScrolledPages(card);
  below_->setMinimumHeight(kLeastBelow);  // the list keeps half of the height
  auto* scroll = new QScrollArea(below_);
  scroll->setAccessibleName(tr("Description"));
  scroll->setWidgetResizable(true);
  scroll->viewport()->setAutoFillBackground(false);
  description_ = make_text({}, scroll);
  description_->setObjectName("protocol_description");
  description_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  scroll->setWidget(description_);
  description_->setAutoFillBackground(false);  // setWidget turns it on
  problems_ = new StudyTable({{tr("Problem"), 0, StudyTable::Align::text}}, below_);
  problems_->setObjectName("protocol_problems");
  problems_->setAccessibleName(tr("Problems"));
  problems_->wrap_texts();
  plan_ = new PlanPreview(PlanPreview::Shape::wide, below_);
  for (QWidget* widget : std::initializer_list<QWidget*>{scroll, problems_, plan_}) {
    below_->addWidget(widget);
  }
  layout->addWidget(below_, 1);

  connect(start_, &QPushButton::clicked, this, [this] {
    if (const ProtocolOverview* protocol = selected()) {
      emit session_wanted({.protocol = protocol->check.file});
    }
  });
  connect(edit_, &QPushButton::clicked, this, [this] {
    if (const ProtocolOverview* protocol = selected()) emit edit_wanted(text(protocol->check.file));
  });
  connect(preview_, &QPushButton::clicked, this, [this] {
    plan_->show_protocol(*selected()->check.protocol);
    show_below(plan);
    share_height();
  });
  connect(simulate_, &QPushButton::clicked, this, [this] {
    if (const ProtocolOverview* protocol = selected()) {
      emit session_wanted({.protocol = protocol->check.file, .simulate = true});
    }
  });
  connect(simulate_several_, &QPushButton::clicked, this, [this] {
    if (const ProtocolOverview* protocol = selected()) {
      emit session_wanted({.simulation = simulation_of(*protocol)});
      seed_ = new_seed();
    }
  });
  connect(by_mouse_, &QPushButton::clicked, this, [this] {
    if (const ProtocolOverview* protocol = selected()) {
      emit session_wanted({.protocol = protocol->check.file,
                           .by_mouse = true,
                           .group = mouse_group_->currentData().toString().toStdString()});
    }
  });
  connect(close_, &QPushButton::clicked, this, [this] {
    show_below(what_it_asks);
    share_height();
  });
  connect(file_actions_, &ProtocolFileActions::changed, this, [this](const QString& file) {
    banner().hide();
    select_next_ = file;
    study().announce_change();
  });
  connect(file_actions_, &ProtocolFileActions::refused, this,
          [this](const QString& why) { banner().show_news(State::look, why); });
  return card;
}

void ProtocolsPage::choose_template() {
  auto* dialog = new TemplateDialog(study().folder(), study().models(), this);
  connect(dialog, &TemplateDialog::wanted, this, &ProtocolsPage::add_from_template);
  dialog->open();
}

void ProtocolsPage::add_from_template(const TemplateChoice& choice) {
  write_task_.run<std::filesystem::path>(
      [choice, folder = study().folder()](const std::stop_token&, const BackgroundTask::Progress&) {
        return protocol_from_template(folder, choice);
      },
      [this](const std::filesystem::path& file) {
        select_next_ = QString::fromStdString(file.string());
        refresh();
      },
      [this](const QString& what) {
        banner().show_news(State::stop, tr("The protocol could not be created: %1").arg(what));
      });
}

void ProtocolsPage::show_interrupted(const std::vector<InterruptedSession>& sessions) {
  if (!study().can_be_written()) return;  // nothing can be resumed in it
  std::tuple<std::int64_t, bool, int> first{};
  if (!sessions.empty()) {
    const InterruptedSession& session = sessions.front();
    first = {session.row.id, session.protocol_file.has_value(), session.trials_done};
  }
  // A dismissed message is not shown again at every change of the study.
  if (first == reported_) return;
  reported_ = first;
  report_interrupted(
      *interrupted_, sessions, {}, [this](const SessionWish& wish) { emit session_wanted(wish); },
      [this] { emit sessions_wanted(); });
}

void ProtocolsPage::show_protocols(const std::vector<ProtocolOverview>& protocols) {
  read_ = protocols;
  std::erase_if(examined_, [this](const auto& one) {
    return std::none_of(read_.begin(), read_.end(), [&one](const ProtocolOverview& overview) {
      return overview.is_valid() && overview.check.protocol->source == one.first;
    });
  });
  protocols_.clear();
  for (const ProtocolOverview& overview : read_) protocols_.push_back(with_examination(overview));
  watch_files();
  std::vector<StudyTable::Row> rows{};
  for (const ProtocolOverview& overview : protocols_) rows.push_back(protocol_row(overview));
  table_->fill(rows);
  show_empty(protocols_.empty());
  if (!select_next_.isEmpty()) table_->select(std::exchange(select_next_, {}));
  if (table_->selected_key().isEmpty()) table_->selectRow(0);
  examine_stimuli();
}

ProtocolOverview ProtocolsPage::with_examination(const ProtocolOverview& overview) const {
  ProtocolOverview examined = overview;
  if (!overview.is_valid()) return examined;
  const auto found = examined_.find(overview.check.protocol->source);
  if (found != examined_.end()) add_examination(examined.check, *found->second);
  return examined;
}

void ProtocolsPage::examine_stimuli() {
  std::vector<std::shared_ptr<const Protocol>> protocols{};
  for (const ProtocolOverview& overview : read_) {
    if (isVisible() && overview.is_valid()) {
      protocols.push_back(std::make_shared<const Protocol>(*overview.check.protocol));
    }
  }
  study().examiner().request(
      this, std::move(protocols),
      [this](const Protocol& protocol, const StimulusExaminer::Result& result) {
        take_examination(protocol.source, result);
      });
  show_whether_examined();
}

/// Rows stay where they are: the list may be in use.
void ProtocolsPage::take_examination(const std::string& source,
                                     const StimulusExaminer::Result& result) {
  if (std::exchange(examined_[source], result) == result) return;
  for (std::size_t i = 0; i < read_.size(); ++i) {
    if (!read_[i].is_valid() || read_[i].check.protocol->source != source) continue;
    protocols_[i] = with_examination(read_[i]);
    table_->replace_cell(text(read_[i].check.file), kStateColumn, validity_cell(protocols_[i]));
    if (selected() == &protocols_[i]) show_selected();
  }
  show_whether_examined();
}

void ProtocolsPage::show_whether_examined() {
  const auto valid = std::count_if(read_.begin(), read_.end(),
                                   [](const auto& overview) { return overview.is_valid(); });
  const auto examined = std::count_if(read_.begin(), read_.end(), [this](const auto& overview) {
    return overview.is_valid() && examined_.contains(overview.check.protocol->source);
  });
  examining_->setVisible(examined < valid);
  examining_->setText(study().examiner().is_held()
                          ? tr("The stimuli are examined when the device is free again.")
                          : tr("Examining stimuli: %1 of %2").arg(examined).arg(valid));
}

const ProtocolOverview* ProtocolsPage::selected() const {
  const std::string file = table_->selected_key().toStdString();
  const auto found = std::find_if(
      protocols_.begin(), protocols_.end(),
      [&file](const ProtocolOverview& overview) { return overview.check.file == file; });
  return found == protocols_.end() ? nullptr : &*found;
}

SimulationInputs ProtocolsPage::simulation_of(const ProtocolOverview& protocol) {
  SimulationInputs inputs{};
  inputs.protocols = {protocol.check.file};
  inputs.study = study().folder();
  inputs.participants = kVirtualParticipants;
  inputs.seed = seed_;
  return inputs;
}

std::vector<ShownCommand> ProtocolsPage::commands() {
  const ProtocolOverview* protocol = selected();
  if (protocol == nullptr) return {};
  std::vector<ShownCommand> commands{
      {.action = tr("Check the protocol"),
       .line = check_line(protocol->check.file, study().folder(), plugin_files())}};
  if (simulate_several_->isEnabled()) {
    commands.push_back({.action = simulate_several_->text(),
                        .line = simulate_line(simulation_of(*protocol), plugin_files())});
  }
  return commands;
}

void ProtocolsPage::show_selected() {
  const ProtocolOverview* overview = selected();
  detail_->setVisible(overview != nullptr);
  if (overview != nullptr) file_actions_->set_file(overview->check.file);
  if (overview == nullptr) return;
  const std::optional<Protocol>& protocol = overview->check.protocol;
  name_->setText(title_of(*overview));
  facts_->setText(overview_facts(*overview));
  last_run_->setText(last_run_of(*overview));
  const bool valid = overview->is_valid();
  const bool can_run = valid && study().can_be_written();
  for (QPushButton* button : {start_, simulate_, simulate_several_}) button->setEnabled(can_run);
  preview_->setEnabled(valid);
  by_mouse_->setEnabled(valid);
  show_groups(*overview);
  edit_->setEnabled(true);
  if (!valid) {
    reason_->setText(tr("Fix the problems listed below first."));
  } else {
    reason_->setText(can_run ? QString{}
                             : tr("This study is read-only: no session can be stored. Copy it to a "
                                  "folder that you may write to."));
  }
  reason_->setVisible(!reason_->text().isEmpty());
  description_->setText(description_of(*overview));
  const auto json = nlohmann::json::parse(overview->check.text, nullptr, false);
  std::vector<StudyTable::Row> rows{};
  for (const Diagnostic& problem : overview->check.diagnostics) {
    const auto number = static_cast<int>(rows.size());  // in the order of the file
    rows.push_back({QString::number(number), {text_cell(remark_in_form(json, problem), number)}});
  }
  problems_->fill(rows);
  if (QString key = table_->selected_key(); key != planned_) {
    plan_->forget();
    planned_ = std::move(key);
  }
  if (!valid) {
    show_below(problems);
  } else if (below_->currentIndex() == plan) {
    plan_->show_protocol(*protocol);
  } else {
    show_below(what_it_asks);
  }
  share_height();
}

void ProtocolsPage::show_groups(const ProtocolOverview& overview) {
  const QVariant before = mouse_group_->currentData();
  mouse_group_->clear();
  if (overview.is_valid()) {
    for (const std::string& group : groups_of(*overview.check.protocol)) {
      mouse_group_->addItem(tr("as group %1").arg(text(group)), text(group));
    }
  }
  mouse_group_->setCurrentIndex(std::max(mouse_group_->findData(before), 0));
  mouse_group_->setVisible(mouse_group_->count() > 0);
}

void ProtocolsPage::show_below(Below below) {
  close_->setVisible(below == plan);
  below_->setCurrentIndex(below);
}

// An editor that puts a new file in the old one's place ends the watch on it.
void ProtocolsPage::watch_files() {
  const std::filesystem::path folder = study().folder() / "protocols";
  QStringList wanted{QString::fromStdString(folder.string())};
  for (const ProtocolOverview& overview : protocols_) wanted.append(text(overview.check.file));
  for (const QString& path : std::as_const(wanted)) {
    if (!watcher_->directories().contains(path) && !watcher_->files().contains(path) &&
        QFileInfo::exists(path)) {
      watcher_->addPath(path);
    }
  }
}

}  // namespace asperity

#include "moc_protocols_page.cpp"
