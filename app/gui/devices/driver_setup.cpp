// Telling drivers where things are that they do not find by themselves: a firmware, a library, a service.

#include "app/gui/devices/driver_setup.h"

#include <algorithm>

#include <QtGui/QScreen>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QScrollArea>

#include "app/gui/base/settings.h"
#include "app/gui/base/shown_text.h"
#include "app/gui/devices/driver_words.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"

namespace asperity {

struct DriverSetup::Line {
  std::string driver{};
  DriverNeed need{};
  QLineEdit* place = nullptr;
  QPushButton* browse = nullptr;  ///< null where it is no file
  QPushButton* clear = nullptr;
  StateLabel* found = nullptr;
  SurveyedDriver last{};  ///< as it was found last
  bool was_found = false;
};

namespace {

constexpr int kSetupWidth = 872;
constexpr int kRoomAround = 80;  // of the screen: the frame of the window, a task bar

/// What its maker calls the device, in every language.
QString product_of(const std::string& driver) {
  if (driver == "falcon") return "Novint Falcon";
  if (driver == "force_dimension") return "Force Dimension";
  if (driver == "openhaptics") return "OpenHaptics";
  if (driver == "inverse3") return "Inverse3";
  return text(driver);
}

QString label_of(const std::string& driver, DriverNeed need) {
  switch (need) {
    case DriverNeed::firmware:
      return DriverSetup::tr("%1: firmware").arg(product_of(driver));
    case DriverNeed::library:
      return DriverSetup::tr("%1: library").arg(product_of(driver));
    case DriverNeed::service:
      return DriverSetup::tr("%1: service").arg(product_of(driver));
  }
  return {};
}

QString what_it_is(const std::string& driver, DriverNeed need) {
  switch (need) {
    case DriverNeed::firmware:
      return DriverSetup::tr(
          "The file that came with the device's software. A Falcon loses its firmware when it is "
          "switched off; the firmware is loaded when the device is opened.");
    case DriverNeed::library:
      return driver == "openhaptics"
                 ? DriverSetup::tr(
                       "The file libHD.so of OpenHaptics, if the system does not find it.")
                 : DriverSetup::tr(
                       "The file libdrd.so or libdhd.so of the manufacturer's SDK, if the system "
                       "does not find it.");
    case DriverNeed::service:
      return DriverSetup::tr(
          "Address of Haply's Inverse Service, HOST:PORT, if it is not 127.0.0.1:10001.");
  }
  return {};
}

/// What holds while nothing is named.
QString otherwise(DriverNeed need) {
  switch (need) {
    case DriverNeed::firmware:
      return DriverSetup::tr("no file: only a Falcon whose firmware is already loaded can be used");
    case DriverNeed::library:
      return DriverSetup::tr("the system's search path for libraries");
    case DriverNeed::service:
      return "127.0.0.1:10001";
  }
  return {};
}

QString title_of_choosing(const std::string& driver, DriverNeed need) {
  return need == DriverNeed::firmware ? DriverSetup::tr("Falcon firmware file")
                                      : DriverSetup::tr("Library of %1").arg(product_of(driver));
}

struct Said {
  State state = State::unknown;
  QString words{};
};

/// What a driver says, beside the field that makes it good.
QString sentence_of(const std::string& said) {
  return words_of(phrase_of_driver(said).as_sentence(), DriverSetup::tr("the field above"));
}

/// What its driver makes of it.
Said said_of(const DriverSurvey& survey, bool is_named) {
  QStringList words{};
  if (!survey.found.empty()) words << DriverSetup::tr("Found: %1.").arg(text(survey.found));
  int usable = 0;
  for (const AttachedDevice& device : survey.attached) {
    const QString name =
        text(device.model + (device.serial.empty() ? "" : " ") + device.serial).trimmed();
    usable += device.is_usable() ? 1 : 0;
    words << (device.is_usable() ? DriverSetup::tr("%1: ready.").arg(name)
                                 : sentence_of(device.blocker));
  }
  if (!survey.blocker.empty()) words << sentence_of(survey.blocker);
  if (survey.attached.empty() && survey.blocker.empty()) {
    words << DriverSetup::tr("No device is attached: connect one, and check that it has power.");
  }
  State state = is_named ? State::fine : State::unknown;
  if (usable > 0) state = State::fine;
  if (usable == 0 && !survey.attached.empty()) state = State::look;
  if (!survey.blocker.empty()) state = is_named ? State::stop : State::look;
  return {state, words.join(' ')};
}

}  // namespace

DriverSetup::DriverSetup(const std::vector<std::string>& drivers, QWidget* parent)
    : QDialog(parent) {
  setObjectName("driver_setup");
  setAttribute(Qt::WA_DeleteOnClose);
  setMinimumWidth(kSetupWidth);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
  layout->setSpacing(kMargin);
  const QString title =
      drivers.size() == 1 ? tr("Set up %1").arg(product_of(drivers.front())) : tr("Set up devices");
  setWindowTitle(title);
  layout->addWidget(make_heading(title, this));
  layout->addWidget(make_text(tr("These settings are stored for all studies. Commands at a "
                                 "terminal do not use them; they have options instead."),
                              this, true));
  area_ = new QScrollArea(this);
  area_->setWidgetResizable(true);
  area_->setFrameShape(QFrame::NoFrame);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area_->setFocusPolicy(Qt::NoFocus);
  area_->viewport()->setAutoFillBackground(false);
  inside_ = new QWidget(area_);
  auto* grid = new QGridLayout(inside_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kMargin);
  grid->setVerticalSpacing(kGrid);
  grid->setColumnStretch(1, 1);
  for (const std::string& driver : drivers) {
    if (need_of(driver)) add_line(driver);
  }
  grid->setRowStretch(grid->rowCount(), 1);
  area_->setWidget(inside_);
  inside_->setAutoFillBackground(false);  // which setWidget turns on
  layout->addWidget(area_, 1);
  auto* buttons = new QHBoxLayout();
  QPushButton* done = make_button(tr("Done"), ButtonRole::primary, this);
  done->setObjectName("driver_setup_done");
  buttons->addStretch(1);
  buttons->addWidget(done);
  layout->addLayout(buttons);
  connect(done, &QPushButton::clicked, this, &DriverSetup::leave);
}

DriverSetup::~DriverSetup() { stop_listening(); }

void DriverSetup::done(int result) {
  stop_listening();
  QDialog::done(result);
}

void DriverSetup::stop_listening() {
  for (const auto& line : lines_) line->place->disconnect(this);
}

void DriverSetup::add_line(const std::string& driver) {
  auto line = std::make_unique<Line>();
  line->driver = driver;
  line->need = *need_of(driver);
  const QString name = label_of(driver, line->need);
  const QString id = text(driver);
  const QString what = what_it_is(driver, line->need);
  auto* grid = dynamic_cast<QGridLayout*>(inside_->layout());
  const int row = grid->rowCount();
  QLabel* label = make_text(name, inside_);
  label->setWordWrap(false);
  line->place = new QLineEdit(inside_);
  line->place->setObjectName("driver_place_" + id);
  line->place->setAccessibleName(name);
  line->place->setAccessibleDescription(what);
  line->place->setToolTip(what);
  line->place->setPlaceholderText(otherwise(line->need));
  const std::string place = driver_place(driver);
  line->place->setText(line->need == DriverNeed::service ? text(place) : text_of_path(place));
  label->setBuddy(line->place);
  grid->addWidget(label, row, 0);
  const bool is_file = line->need != DriverNeed::service;
  grid->addWidget(line->place, row, 1, 1, is_file ? 1 : 2);
  Line& here = *line;
  if (is_file) {
    line->browse = make_button(tr("Browse…"), ButtonRole::plain, inside_);
    line->browse->setObjectName("driver_browse_" + id);
    line->browse->setAccessibleName(tr("Browse for %1").arg(name));
    line->browse->setToolTip(tr("Opens a dialog for choosing a file on this computer."));
    grid->addWidget(line->browse, row, 2);
    connect(line->browse, &QPushButton::clicked, this, [this, &here] { choose_file(here); });
  }
  line->clear = make_button(tr("Clear"), ButtonRole::plain, inside_);
  line->clear->setObjectName("driver_clear_" + id);
  line->clear->setAccessibleName(tr("Clear %1").arg(name));
  line->clear->setToolTip(tr("Clears this entry."));
  grid->addWidget(line->clear, row, 3);
  line->found = new StateLabel(inside_);
  line->found->setObjectName("driver_found_" + id);
  line->found->setTextInteractionFlags(Qt::TextSelectableByMouse);
  grid->addWidget(line->found, row + 1, 1, 1, 3);
  grid->setRowMinimumHeight(row + 2, kGrid);
  const auto can_be_cleared = [&here] { here.clear->setEnabled(!here.place->text().isEmpty()); };
  connect(line->place, &QLineEdit::textChanged, this, can_be_cleared);
  connect(line->place, &QLineEdit::editingFinished, this, [this, &here] { take(here); });
  connect(line->clear, &QPushButton::clicked, this, [this, &here] {
    here.place->clear();
    here.place->setFocus();  // the button is grey now
    take(here);
  });
  can_be_cleared();
  lines_.push_back(std::move(line));
}

void DriverSetup::choose_file(Line& line) {
  auto* dialog = new QFileDialog(this, title_of_choosing(line.driver, line.need));
  dialog->setObjectName("driver_file_dialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  if (const std::filesystem::path before = driver_place(line.driver); before.has_parent_path()) {
    dialog->setDirectory(text(before.parent_path().string()));
  }
  if (line.need == DriverNeed::library) {
    dialog->setNameFilters({tr("Libraries (*.so *.so.*)"), tr("All files (*)")});
  }
  connect(dialog, &QFileDialog::fileSelected, this, [this, &line](const QString& file) {
    line.place->setText(text_of_path(file.toStdString()));
    take(line);
  });
  dialog->open();
}

bool DriverSetup::take(Line& line) {
  const QString typed = line.place->text().trimmed();
  std::string place = typed.toStdString();
  if (line.need != DriverNeed::service && !typed.isEmpty()) {
    const std::filesystem::path file = path_of_text(typed);
    if (!file.is_absolute()) {
      line.found->set_state(State::stop,
                            tr("Enter the full path of the file, beginning with “/” or “~”."));
      return false;
    }
    place = file.string();
  }
  if (place != driver_place(line.driver)) {
    remember_driver_place(line.driver, place);
    emit changed();
  } else if (line.was_found) {
    show_found({line.last});  // where something else was typed before
  }
  return true;
}

void DriverSetup::leave() {
  // A field that is being typed into tells of it when the focus leaves, which a key need not do.
  for (const auto& line : lines_) {
    if (take(*line)) continue;
    line->place->setFocus();
    return;
  }
  accept();
}

void DriverSetup::show_looking() {
  for (const auto& line : lines_) {
    line->was_found = false;
    line->found->set_state(State::unknown, tr("Searching…"));
  }
}

void DriverSetup::show_failure(const QString& what) {
  for (const auto& line : lines_) {
    line->found->set_state(State::look, tr("The search for devices failed: %1").arg(what));
  }
  fit(height());
}

void DriverSetup::show_found(const std::vector<SurveyedDriver>& drivers) {
  for (const auto& line : lines_) {
    const auto found =
        std::find_if(drivers.begin(), drivers.end(),
                     [&line](const SurveyedDriver& driver) { return driver.id == line->driver; });
    if (found == drivers.end()) continue;
    const SurveyedDriver driver = *found;
    line->last = driver;
    line->was_found = true;
    const Said said = said_of(driver.survey, !driver_place(driver.id).empty());
    line->found->set_state(said.state, said.words);
  }
  fit(height());
}

void DriverSetup::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  fit(0);
}

void DriverSetup::fit(int least) {
  if (!isVisible()) return;
  layout()->activate();
  const QSize room = area_->viewport()->size();
  const int needed = height() - room.height() + inside_->heightForWidth(room.width());
  const int highest = screen()->availableGeometry().height() - kRoomAround;
  resize(width(), std::max(least, std::min(needed, highest)));
}

std::vector<std::string> drivers_to_set_up(const DriverRegistry& drivers) {
  std::vector<std::string> ids{};
  for (const Driver& driver : drivers.drivers()) {
    if (need_of(driver.id)) ids.push_back(driver.id);
  }
  return ids;
}

QString what_to_set_up(const std::string& driver) {
  const std::optional<DriverNeed> need = need_of(driver);
  return need ? what_it_is(driver, *need) : QString();
}

}  // namespace asperity

#include "moc_driver_setup.cpp"
