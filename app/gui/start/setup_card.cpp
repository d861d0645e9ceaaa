// Offers device, hand and screen, and remembers screen and keyboard in the settings.

#include "app/gui/start/setup_card.h"

#include <QtCore/QSettings>
#include <QtCore/QSignalBlocker>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QButtonGroup>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include "app/gui/base/question_form.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "app/gui/start/device_chooser.h"

namespace asperity {

namespace {

constexpr const char* kScreen = "start/participant_screen";
constexpr const char* kOwnKeyboard = "start/own_keyboard";
constexpr int kSetupFieldWidth = 320;

}  // namespace

SetupCard::SetupCard(OpenStudy& study, QWidget* parent) : QWidget(parent) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* layout = nullptr;
  outer->addWidget(make_card(this, layout));
  layout->addWidget(make_heading(tr("Device and screens"), this));

  device_ = new DeviceChooser(study, this);
  layout->addWidget(device_);

  auto* hand_row = new QHBoxLayout();
  hand_row->setSpacing(kGrid);
  right_ = make_button(tr("Right hand"), ButtonRole::selector, this);
  right_->setObjectName("right_hand");
  left_ = make_button(tr("Left hand"), ButtonRole::selector, this);
  left_->setObjectName("left_hand");
  auto* hands = new QButtonGroup(this);
  hands->addButton(right_);
  hands->addButton(left_);
  right_->setChecked(true);
  hand_row->addWidget(make_text(tr("Held by"), this), 1);
  hand_row->addWidget(right_);
  hand_row->addWidget(left_);
  layout->addLayout(hand_row);
  hand_text_ = make_text({}, this, true);
  hand_text_->setObjectName("hand_text");
  layout->addWidget(hand_text_);

  screen_row_ = new QWidget(this);
  auto* screen_row = new QHBoxLayout(screen_row_);
  screen_row->setContentsMargins(0, 0, 0, 0);
  screen_row->setSpacing(kMargin);
  screens_ = new ChoiceBox(this);
  screens_->setObjectName("participant_screen");
  screens_->setFixedWidth(kSetupFieldWidth);
  ignore_wheel(*screens_);
  QLabel* screen_label = make_text(tr("The participant's window"), this);
  screen_label->setBuddy(screens_);
  screen_row->addWidget(screen_label, 1);
  screen_row->addWidget(screens_);
  layout->addWidget(screen_row_);
  own_keyboard_ =
      new QCheckBox(tr("The participant has a separate keyboard or device buttons"), this);
  own_keyboard_->setObjectName("own_keyboard");
  own_keyboard_->setChecked(QSettings().value(kOwnKeyboard, false).toBool());
  layout->addWidget(own_keyboard_);
  keyboard_text_ = make_text(tr("If both use one keyboard, the experimenter's text fields are "
                                "disabled while a response is expected."),
                             this, true);
  layout->addWidget(keyboard_text_);

  connect(hands, &QButtonGroup::buttonClicked, this, [this] {
    hand_chosen_ = true;
    set_left(left_->isChecked());
    emit changed();
  });
  connect(screens_, &QComboBox::currentIndexChanged, this, [this] {
    QSettings().setValue(kScreen, participant_screen());
    emit changed();
  });
  connect(own_keyboard_, &QCheckBox::toggled, this, [this](bool own) {
    QSettings().setValue(kOwnKeyboard, own);
    emit changed();
  });
  const auto screens_are_others = [this] {
    list_screens();
    emit screens_changed();
  };
  connect(qGuiApp, &QGuiApplication::screenAdded, this, screens_are_others);
  connect(qGuiApp, &QGuiApplication::screenRemoved, this, screens_are_others);
  list_screens();
  set_left(false);
}

bool SetupCard::is_mirrored() const { return left_->isChecked(); }

std::optional<bool> SetupCard::chosen_left() const {
  return hand_chosen_ ? std::optional(is_mirrored()) : std::nullopt;
}

void SetupCard::choose_left(bool left) {
  hand_chosen_ = true;
  set_left(left);
}

void SetupCard::suggest_left_hand(bool left) {
  if (!hand_chosen_) set_left(left);
}

void SetupCard::fix_hand(bool left) {
  set_left(left);
  right_->setEnabled(false);
  left_->setEnabled(false);
  hand_text_->setText(tr("The same hand as when the session began."));
}

void SetupCard::forget_hand() { hand_chosen_ = false; }

void SetupCard::free_hand() {
  if (right_->isEnabled()) return;  // what somebody chose stays
  right_->setEnabled(true);
  left_->setEnabled(true);
  hand_chosen_ = false;
  set_left(left_->isChecked());
}

void SetupCard::set_virtual(bool is_virtual) {
  screen_row_->setVisible(!is_virtual);
  own_keyboard_->setVisible(!is_virtual);
  keyboard_text_->setVisible(!is_virtual);
}

QString SetupCard::participant_screen() const { return screens_->currentData().toString(); }

bool SetupCard::own_keyboard() const { return own_keyboard_->isChecked(); }

void SetupCard::set_left(bool left) {
  (left ? left_ : right_)->setChecked(true);
  hand_text_->setText(left ? tr("The workspace and the strokes are mirrored left to right.")
                           : tr("The workspace as the protocol describes it."));
}

void SetupCard::list_screens() {
  const QString remembered = QSettings().value(kScreen).toString();
  const QSignalBlocker silent(screens_);
  screens_->clear();
  screens_->addItem(tr("Next to this window"), QString());
  int chosen = 0;
  const QList<QScreen*> screens = QGuiApplication::screens();
  for (const QScreen* screen : screens) {
    if (screens.size() == 1) break;
    screens_->addItem(tr("Full screen on %1 (%2 × %3)")
                          .arg(screen->name())
                          .arg(screen->size().width())
                          .arg(screen->size().height()),
                      screen->name());
    // The first one has the windows of the desktop, and so this one as a rule.
    const bool is_other = screen != QGuiApplication::primaryScreen();
    if ((chosen == 0 && is_other) || screen->name() == remembered) chosen = screens_->count() - 1;
  }
  screens_->setCurrentIndex(chosen);
}

}  // namespace asperity

#include "moc_setup_card.cpp"
