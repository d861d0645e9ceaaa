// Setting and measuring the masking noise before a session.

#include "app/gui/sound/noise_check.h"

#include <QtGui/QWheelEvent>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QBoxLayout>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSlider>
#include <gtest/gtest.h>

#include "app/gui/look/controls.h"
#include "app/gui/look/theme.h"
#include "tests/gui/sound/fake_card.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

MaskingNoise declared_noise() {
  MaskingNoise noise{};
  noise.kind = MaskingNoise::Kind::pink;
  noise.declared_dBA = 65.0;
  return noise;
}

TEST(NoiseCheck, PlaysTheNoiseUntilItIsStoppedOrHidden) {
  FakeCard card{};
  NoiseCheck check(declared_noise(), output_of(card));
  check.show();
  EXPECT_EQ(card.opened, 0) << "the card is left alone until it is needed";
  auto& play = child<QPushButton>(check, "play_noise");
  QTest::mouseClick(&play, Qt::LeftButton);
  EXPECT_EQ(play.text(), "Stop noise");
  EXPECT_TRUE(eventually([&] { return card.peak > 0.1; }));
  QTest::mouseClick(&play, Qt::LeftButton);
  EXPECT_TRUE(eventually([&] { return card.peak == 0.0; }));
  QTest::mouseClick(&play, Qt::LeftButton);
  EXPECT_TRUE(eventually([&] { return card.peak > 0.1; }));
  check.hide();
  EXPECT_TRUE(eventually([&] { return !card.open; }));
  EXPECT_FALSE(play.isChecked());
}

TEST(NoiseCheck, PlaysACueWithoutNoise) {
  FakeCard card{};
  NoiseCheck check(declared_noise(), output_of(card));
  check.show();
  QTest::mouseClick(&child<QPushButton>(check, "play_cue"), Qt::LeftButton);
  EXPECT_TRUE(eventually([&] { return card.highest_peak > 0.1; }));
  EXPECT_TRUE(eventually([&] { return card.peak == 0.0; }));
}

TEST(NoiseCheck, TheGainIsHeardAtOnceAndMakesAMeasurementVoid) {
  FakeCard card{};
  MaskingNoise noise = declared_noise();
  noise.measured_dBA = 65.5;
  noise.verified_by = "M. Weber";
  NoiseCheck check(noise, output_of(card));
  check.show();
  EXPECT_EQ(check.reservation(), "");
  QSignalSpy changed(&check, &NoiseCheck::changed);
  QTest::mouseClick(&child<QPushButton>(check, "play_noise"), Qt::LeftButton);
  EXPECT_TRUE(eventually([&] { return card.peak > 0.2; }));
  auto& gain = child<QSlider>(check, "noise_gain");
  gain.setFocus();
  for (int i = 0; i < 8; ++i) QTest::keyClick(&gain, Qt::Key_PageDown);  // 8 times 3 dB
  EXPECT_NEAR(check.value().gain, 0.1 * std::pow(10.0, -24.0 / 20.0), 1e-9);
  EXPECT_TRUE(eventually([&] { return card.peak < 0.04; }));
  EXPECT_FALSE(check.value().measured_dBA.has_value());
  EXPECT_TRUE(check.reservation().contains("was not measured"));
  EXPECT_GE(changed.count(), 8);
}

TEST(NoiseCheck, KeepsItsLevelsUnderTheWheel) {
  FakeCard card{};
  NoiseCheck check(declared_noise(), output_of(card));
  check.show();
  child<QDoubleSpinBox>(check, "measured_level").setValue(64.0);
  const double gain = check.value().gain;
  for (const char* name : {"noise_gain", "measured_level"}) {
    auto& field = child<QWidget>(check, name);
    field.setFocus();
    const QPointF middle(field.rect().center());
    QWheelEvent turned(middle, field.mapToGlobal(middle), {}, {0, 240}, Qt::NoButton,
                       Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&field, &turned);
    EXPECT_FALSE(turned.isAccepted()) << "the page scrolls";
  }
  EXPECT_EQ(check.value().gain, gain);
  EXPECT_EQ(check.value().measured_dBA, 64.0);
}

TEST(NoiseCheck, TakesDownWhatWasMeasuredByWhom) {
  FakeCard card{};
  NoiseCheck check(declared_noise(), output_of(card));
  EXPECT_TRUE(check.reservation().contains("was not measured"));
  child<QDoubleSpinBox>(check, "measured_level").setValue(71.0);
  EXPECT_TRUE(check.reservation().contains("measured at 71.0 dB(A); the protocol requires 65.0"));
  child<QDoubleSpinBox>(check, "measured_level").setValue(86.0);
  EXPECT_TRUE(check.reservation().contains("can damage hearing"));
  child<QDoubleSpinBox>(check, "measured_level").setValue(64.0);
  EXPECT_TRUE(check.reservation().contains("who measured"));
  QTest::keyClicks(&child<QLineEdit>(check, "verified_by"), "M. Weber ");
  EXPECT_EQ(check.reservation(), "");
  EXPECT_EQ(check.value().measured_dBA, 64.0);
  EXPECT_EQ(check.value().verified_by, "M. Weber");
  EXPECT_EQ(check.value().kind, MaskingNoise::Kind::pink);
  EXPECT_EQ(check.value().declared_dBA, 65.0);
}

TEST(NoiseCheck, WithoutASoundCardItSaysSoAndPlaysNothing) {
  NoiseCheck check(declared_noise(), null_output());
  EXPECT_EQ(check.reservation(),
            "There is no sound output. Connect headphones to play noise and cues.");
  EXPECT_FALSE(child<QPushButton>(check, "play_noise").isEnabled());
  EXPECT_FALSE(child<QPushButton>(check, "play_cue").isEnabled());
  EXPECT_TRUE(child<StateLabel>(check, "noise_state").text().contains("no sound output"));
}

TEST(NoiseCheck, SaysThatACardDoesNotPlayUntilItDoes) {
  FakeCard card{};
  card.hangs = true;
  MaskingNoise noise = declared_noise();
  noise.measured_dBA = 65.0;
  noise.verified_by = "M. Weber";
  NoiseCheck check(noise, output_of(card));
  check.show();
  EXPECT_EQ(check.reservation(), "");
  QTest::mouseClick(&child<QPushButton>(check, "play_noise"), Qt::LeftButton);
  ASSERT_TRUE(eventually([&] { return !check.reservation().isEmpty(); }));
  EXPECT_TRUE(
      child<StateLabel>(check, "noise_state").text().contains("Headphones produces no sound"));
  card.hangs = false;
  EXPECT_TRUE(eventually([&] { return check.reservation().isEmpty(); }));
}

TEST(NoiseCheck, AProtocolWithoutNoiseStillHasCues) {
  FakeCard card{};
  NoiseCheck check({}, output_of(card));
  check.show();
  EXPECT_FALSE(child<QPushButton>(check, "play_noise").isVisible());
  EXPECT_FALSE(child<QDoubleSpinBox>(check, "measured_level").isVisible());
  EXPECT_TRUE(child<QPushButton>(check, "play_cue").isEnabled());
  EXPECT_EQ(check.reservation(), "");
}

TEST(NoiseCheck, LooksAsItShould) {
  FakeCard card{};
  for (const bool dark : {false, true}) {
    apply_theme(*qobject_cast<QApplication*>(qApp), dark ? ThemeChoice::dark : ThemeChoice::light);
    QWidget page{};
    auto* column = new QVBoxLayout(&page);
    column->setContentsMargins(kGroupGap, kGroupGap, kGroupGap, kGroupGap);
    column->setSpacing(kGroupGap);
    MaskingNoise noise = declared_noise();
    noise.measured_dBA = 64.5;
    noise.verified_by = "M. Weber";
    for (const bool heard : {true, false}) {
      QVBoxLayout* inside = nullptr;
      QFrame* frame = make_card(&page, inside);
      inside->addWidget(make_heading("Masking noise", frame));
      inside->addWidget(heard ? new NoiseCheck(noise, output_of(card), frame)
                              : new NoiseCheck(declared_noise(), null_output(), frame));
      column->addWidget(frame);
    }
    column->addStretch(1);
    take_screenshot(page, dark ? "sound-noise-dark" : "sound-noise", {720, 768});
  }
  apply_theme(*qobject_cast<QApplication*>(qApp), ThemeChoice::light);
}

}  // namespace
}  // namespace asperity
