// What guides the hand of a participant on the screen.

#include <QtCore/QLocale>
#include <gtest/gtest.h>

#include "app/gui/participant/live_guide.h"
#include "app/gui/participant/pages/guide_rows.h"
#include "device/monotonic_clock.h"
#include "tests/gui/participant/participant_seat.h"
#include "tests/gui/participant/scenes.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

using Item = ParticipantItem;

/// What the guide shows of a hand that does this.
QImage guide_with(Seat& seat, double pressing_N, std::optional<double> speed_m_per_s) {
  LiveBin bin{};
  bin.touching = true;
  bin.is_felt = true;
  bin.pressing_N = pressing_N;
  bin.stroking_m_per_s = speed_m_per_s;
  seat.monitor.add_bin(bin);
  auto* guide = seat.view.findChild<LiveGuide*>();
  EXPECT_TRUE(eventually([&] {
    return guide->shown().pressing_N == pressing_N &&
           guide->shown().stroking_m_per_s == speed_m_per_s;
  }));
  return guide->grab().toImage();
}

int pixels_of(const QImage& image, const QColor& color, const QRect& where) {
  int count = 0;
  for (int y = where.top(); y <= where.bottom(); ++y) {
    for (int x = where.left(); x <= where.right(); ++x) {
      if (image.pixelColor(x, y) == color) ++count;
    }
  }
  return count;
}

TEST(ParticipantView, MarksTheHandInsideAndOutsideOfItsBands) {
  Seat seat(scenes::guided(Exploration::Guidance::bars));
  const auto* guide = seat.view.findChild<LiveGuide*>();
  ASSERT_TRUE(guide->isVisible());
  EXPECT_TRUE(seat.view.rect().contains(guide->geometry()));
  const QColor outside("#D55E00");
  QImage seen = guide_with(seat, 0.9, 0.09);  // the force in its band, too fast
  QRect force = seen.rect();
  force.setBottom(seen.height() / 2 - 1);
  QRect speed = seen.rect();
  speed.setTop(seen.height() / 2);
  EXPECT_EQ(pixels_of(seen, outside, force), 0);
  EXPECT_GT(pixels_of(seen, outside, speed), 200);
  seen = guide_with(seat, 1.5, 0.054);
  EXPECT_GT(pixels_of(seen, outside, force), 200);
  EXPECT_EQ(pixels_of(seen, outside, speed), 0);
  // Too much stands on the right of the band, too little on its left.
  const QRect left(0, 0, seen.width() / 3, seen.height() / 2);
  EXPECT_EQ(pixels_of(seen, outside, left), 0);
  EXPECT_GT(pixels_of(guide_with(seat, 0.3, 0.054), outside, left), 200);
  // A hand that has not stroked far enough yet is not asked for speed; one that rests is.
  EXPECT_EQ(pixels_of(guide_with(seat, 0.9, {}), outside, seen.rect()), 0);
  EXPECT_GT(pixels_of(guide_with(seat, 0.9, 0.0), outside, speed), 200);
}

/// From its left to its right edge, in pixels.
std::pair<int, int> band_in(const QImage& image) {
  const QColor ground("#BFDDF2");
  std::pair<int, int> edges{image.width(), 0};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixelColor(x, y) != ground) continue;
      edges.first = std::min(edges.first, x);
      edges.second = std::max(edges.second, x);
    }
  }
  return edges;
}

TEST(ParticipantView, ShowsTheBandsOfAllExplorationsOnOneScale) {
  Protocol protocol{};
  std::vector<ParticipantScene> pressed{};
  for (const double force_N : {0.5, 1.0, 2.0}) {
    ParticipantScene scene = scenes::guided(Exploration::Guidance::bars);
    scene.guide->speed_m_per_s = {};
    scene.guide->normal_force_N = {
        .minimum = 0.7 * force_N, .target = force_N, .maximum = 1.3 * force_N};
    protocol.explorations[std::to_string(pressed.size())] = *scene.guide;
    pressed.push_back(scene);
  }
  // The experimenter's alone: no bar shows it, and none makes room for it.
  Exploration unseen = *pressed.front().guide;
  unseen.guidance = Exploration::Guidance::experimenter;
  unseen.normal_force_N.maximum = 40.0;
  protocol.explorations["unseen"] = unseen;
  EXPECT_DOUBLE_EQ(guide_scale_of(protocol).force_N, 1.25 * 2.6);
  EXPECT_DOUBLE_EQ(guide_scale_of(protocol).speed_m_per_s, 0.0);

  Seat seat{};
  auto* guide = seat.view.findChild<LiveGuide*>();
  std::vector<std::pair<int, int>> bands{};
  for (ParticipantScene& scene : pressed) {
    scene.guide_scale = guide_scale_of(protocol);
    seat.show(scene);
    const double asked_N = *scene.guide->normal_force_N.target;
    LiveBin bin{};
    bin.is_felt = true;
    bin.pressing_N = asked_N;
    seat.monitor.add_bin(bin);
    ASSERT_TRUE(eventually([&] { return guide->shown().pressing_N == asked_N; }));
    bands.push_back(band_in(guide->grab().toImage()));
  }
  EXPECT_GT(bands[1].first, bands[0].second) << "1 N is asked for beyond where 0.5 N was";
  EXPECT_GT(bands[2].first, bands[1].second);
  const auto width = [](const std::pair<int, int>& band) { return band.second - band.first; };
  EXPECT_NEAR(static_cast<double>(width(bands[2])) / width(bands[0]), 4.0, 0.3);
}

TEST(ParticipantView, PutsRoundNumbersUnderItsBars) {
  EXPECT_EQ(guide_ticks(3.25), (std::vector<double>{0.0, 1.0, 2.0, 3.0}));
  EXPECT_EQ(guide_ticks(162.5), (std::vector<double>{0.0, 50.0, 100.0, 150.0}));
  EXPECT_EQ(guide_ticks(0.5).size(), 6U);
  EXPECT_TRUE(guide_ticks(0.0).empty());
  Seat seat(scenes::guided(Exploration::Guidance::bars));
  const auto names = [&seat] {
    QStringList texts{};
    for (const Item& item : seat.view.items()) texts.push_back(item.text);
    return texts;
  };
  EXPECT_TRUE(names().contains("Force, N"));
  EXPECT_TRUE(names().contains("Speed, mm/s"));
}

/// The guide of a scene in this language, in windows of that one.
QImage guide_in(const std::string& language, const char* of_windows) {
  QLocale::setDefault(QLocale(of_windows));
  ParticipantScene scene = scenes::guided(Exploration::Guidance::bars);
  scene.language = language;
  scene.guide->normal_force_N = {.minimum = 0.3, .target = 0.4, .maximum = 0.5};
  scene.guide_scale = {};
  Seat seat(scene);
  const QImage guide = guide_with(seat, 0.4, {});
  QLocale::setDefault(QLocale("en"));
  return guide;
}

TEST(ParticipantView, WritesTheNumbersUnderItsBarsInTheLanguageOfTheProtocol) {
  const QImage english = guide_in("en", "en");
  EXPECT_EQ(guide_in("en", "de"), english);
  const QImage german = guide_in("de", "en");
  EXPECT_NE(german, english) << "0,1 instead of 0.1";
  EXPECT_EQ(guide_in("de", "de"), german);
}

TEST(ParticipantView, AsksAHandThatIsToLiftForNothing) {
  ParticipantScene scene = scenes::guided(Exploration::Guidance::bars);
  Seat seat(scene);
  const QColor outside("#D55E00");
  const QImage pressed_little = guide_with(seat, 0.3, 0.01);
  EXPECT_GT(pixels_of(pressed_little, outside, pressed_little.rect()), 200);
  scene.text_message = {.what = ParticipantMessage::What::lift, .code = "B"};
  seat.show(scene);
  auto* guide = seat.view.findChild<LiveGuide*>();
  EXPECT_TRUE(eventually([&] { return !guide->shown().pressing_N; }));
  EXPECT_FALSE(guide->shown().stroking_m_per_s);
  EXPECT_EQ(pixels_of(guide->grab().toImage(), outside, pressed_little.rect()), 0);
}

TEST(ParticipantView, LeadsTheHandByATargetUntilItIsToLift) {
  // 60 mm at 40 mm/s: forth in 1.5 s and back in as many.
  EXPECT_NEAR(target_along_m(0.0, 0.06, 0.04), -0.03, 1e-12);
  EXPECT_NEAR(target_along_m(0.75, 0.06, 0.04), 0.0, 1e-12);
  EXPECT_NEAR(target_along_m(1.5, 0.06, 0.04), 0.03, 1e-12);
  EXPECT_NEAR(target_along_m(2.0, 0.06, 0.04), 0.01, 1e-12);
  EXPECT_NEAR(target_along_m(3.75, 0.06, 0.04), 0.0, 1e-12);

  ParticipantScene scene = scenes::guided(Exploration::Guidance::moving_target);
  scene.shown_ns = monotonic_now_ns();
  Seat seat(scene);
  const auto* guide = seat.view.findChild<LiveGuide*>();
  ASSERT_TRUE(guide->isVisible());
  const std::optional<double> before = guide->shown().target_along_m;
  ASSERT_TRUE(before);
  EXPECT_LE(std::abs(*before), 0.03);
  EXPECT_TRUE(eventually([&] { return guide->shown().target_along_m != before; }));
  scene.text_message = {.what = ParticipantMessage::What::lift, .code = "B"};
  seat.show(scene);
  EXPECT_TRUE(eventually([&] { return !guide->shown().target_along_m; }));
}

TEST(ParticipantView, ShowsNothingOfTheHandWhereTheProtocolDoesNotSaySo) {
  Seat seat{};
  const auto* guide = seat.view.findChild<LiveGuide*>();
  seat.show(scenes::feel(3));
  EXPECT_FALSE(guide->isVisible());
  seat.show(scenes::guided(Exploration::Guidance::bars));
  EXPECT_TRUE(guide->isVisible());
  seat.show(scenes::selection(3));
  EXPECT_FALSE(guide->isVisible());
}

}  // namespace
}  // namespace asperity
