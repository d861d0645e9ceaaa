// What is examined for which page, what is kept of it, and what ends it.

#include "app/gui/base/stimulus_examiner.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "app/study_files/height_field_files.h"
#include "renderers/built_in_models.h"
#include "stimuli/heights/synthetic_surface.h"
#include "tests/app/small_study.h"
#include "tests/gui/support/gated_examination.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

class Examiner : public testing::Test {
 protected:
  Examiner() {
    make_small_study(study_);
    examiner_ = std::make_unique<StimulusExaminer>(study_, models_);
    examiner_->set_examine(examine_through(gate_));
  }

  /// Each call reads it anew, as pages do.
  std::shared_ptr<const Protocol> protocol(const std::string& version,
                                           const std::string& exploration = "") const {
    std::string text = small_protocol("", exploration);
    text.replace(text.find("1.0.0"), 5, version);
    return std::make_shared<const Protocol>(read_small_protocol(models_, text));
  }
  void request(const QObject& page, std::vector<std::shared_ptr<const Protocol>> protocols) {
    examiner_->request(&page, std::move(protocols),
                       [this](const Protocol& one, const StimulusExaminer::Result& result) {
                         versions_.push_back(one.version);
                         results_.push_back(result);
                       });
  }
  bool arrive(std::size_t count) const {
    return eventually([&] { return results_.size() == count; });
  }
  /// Time for what must not happen.
  static void wait() { QTest::qWait(20); }

  using Versions = std::vector<std::string>;

  TemporaryFolder folder_{};
  std::filesystem::path study_ = folder_ / "study";
  ModelRegistry models_ = built_in_models();
  std::shared_ptr<GatedExamination> gate_ = std::make_shared<GatedExamination>();
  std::unique_ptr<StimulusExaminer> examiner_{};
  QObject list_{};
  QObject editor_{};
  Versions versions_{};
  std::vector<StimulusExaminer::Result> results_{};
};

TEST_F(Examiner, FindsWhatCheckFinds) {
  StimulusExaminer examiner(study_, models_);
  const auto strong = protocol("1.0.0", R"(, "normal_force_N": {"minimum": 2.0, "maximum": 2.5})");
  StimulusExaminer::Result found{};
  examiner.request(&list_, {strong}, [&](const Protocol&, const StimulusExaminer::Result& result) {
    found = result;
  });
  ASSERT_TRUE(eventually([&] { return found != nullptr; }));
  StimulusBuilder builder(models_, study_);
  const StimulusExamination expected = examine_stimuli({*strong, {}}, study_, builder);
  ASSERT_FALSE(expected.warnings.empty());
  ASSERT_EQ(found->warnings.size(), expected.warnings.size());
  for (std::size_t i = 0; i < expected.warnings.size(); ++i) {
    EXPECT_EQ(found->warnings[i].message.english(), expected.warnings[i].message.english());
    EXPECT_EQ(found->warnings[i].line, expected.warnings[i].line);
  }
}

TEST_F(Examiner, SharesOneExaminationOfATextBetweenPages) {
  gate_->is_open = true;
  request(list_, {protocol("1.0.0"), protocol("2.0.0")});
  ASSERT_TRUE(arrive(2));
  request(editor_, {protocol("2.0.0")});
  ASSERT_TRUE(arrive(3));
  EXPECT_EQ(versions_, (Versions{"1.0.0", "2.0.0", "2.0.0"}));
  EXPECT_EQ(results_[2], results_[1]);
  EXPECT_EQ(gate_->begun, 2);
}

TEST_F(Examiner, ExaminesAgainWhenAFileOfTheProtocolIsAnotherOne) {
  gate_->is_open = true;
  request(list_, {protocol("1.0.0")});
  ASSERT_TRUE(arrive(1));
  const HeightField other =
      make_surface("noise", {}, SurfaceCanvas{.width_m = 0.02, .pixels = 128, .seed = 6});
  save_height_field(study_ / "stimuli" / "grain.png", other, {.kind = "noise"}, Overwrite::allow);
  request(list_, {protocol("1.0.0")});
  ASSERT_TRUE(arrive(2));
  EXPECT_EQ(gate_->begun, 2);
}

TEST_F(Examiner, StopsWhatIsWithdrawnAndKeepsNothingOfIt) {
  request(list_, {protocol("1.0.0")});
  ASSERT_TRUE(eventually([&] { return gate_->has_begun(1); }));
  examiner_->withdraw(&list_);
  ASSERT_TRUE(eventually([&] { return gate_->has_stopped(1); }));
  wait();
  EXPECT_TRUE(results_.empty());
  gate_->is_open = true;
  request(list_, {protocol("1.0.0")});
  ASSERT_TRUE(arrive(1));
  EXPECT_EQ(gate_->begun, 2);
}

TEST_F(Examiner, LeavesNothingRunningForAPageThatIsDestroyed) {
  auto page = std::make_unique<QObject>();
  request(*page, {protocol("1.0.0"), protocol("2.0.0")});
  ASSERT_TRUE(eventually([&] { return gate_->has_begun(1); }));
  page.reset();
  ASSERT_TRUE(eventually([&] { return gate_->has_stopped(1); }));
  wait();
  EXPECT_EQ(gate_->begun, 1);
  EXPECT_TRUE(results_.empty());
}

TEST_F(Examiner, StopsAndWaitsWhenItIsDestroyed) {
  request(list_, {protocol("1.0.0")});
  ASSERT_TRUE(eventually([&] { return gate_->has_begun(1); }));
  examiner_.reset();
  EXPECT_TRUE(gate_->has_stopped(1));
}

TEST_F(Examiner, ExaminesNothingWhileItIsHeldAndAllOfItAfterwards) {
  request(list_, {protocol("1.0.0"), protocol("2.0.0")});
  ASSERT_TRUE(eventually([&] { return gate_->has_begun(1); }));
  StimulusExaminer::Hold session = examiner_->hold();
  StimulusExaminer::Hold device_test = examiner_->hold();  // which ends first
  device_test.reset();
  EXPECT_TRUE(examiner_->is_held());
  ASSERT_TRUE(eventually([&] { return gate_->has_stopped(1); }));
  gate_->is_open = true;
  request(editor_, {protocol("3.0.0")});
  wait();
  EXPECT_EQ(gate_->begun, 1);
  EXPECT_TRUE(results_.empty());
  session.reset();
  ASSERT_TRUE(arrive(3));
  EXPECT_EQ(versions_, (Versions{"1.0.0", "2.0.0", "3.0.0"}));
  EXPECT_EQ(gate_->begun, 4) << "the stopped one was begun again";
}

TEST_F(Examiner, IsHeldAgainAfterAHoldThatEndedTwice) {
  StimulusExaminer::Hold device_test = examiner_->hold();
  device_test.reset();
  device_test.reset();
  EXPECT_FALSE(examiner_->is_held());
  const StimulusExaminer::Hold session = examiner_->hold();
  EXPECT_TRUE(examiner_->is_held());
  request(list_, {protocol("1.0.0")});
  wait();
  EXPECT_EQ(gate_->begun, 0);
  examiner_.reset();  // before the hold ends
}

TEST_F(Examiner, BeginsTheNextOneOnlyWhenAStoppedOneHasEnded) {
  gate_->is_deaf = true;
  request(list_, {protocol("1.0.0")});
  ASSERT_TRUE(eventually([&] { return gate_->has_begun(1); }));
  request(list_, {protocol("2.0.0")});
  wait();
  EXPECT_EQ(gate_->begun, 1);
  gate_->is_open = true;
  ASSERT_TRUE(arrive(1));
  EXPECT_EQ(versions_, Versions{"2.0.0"});
  EXPECT_EQ(gate_->most_running, 1);
}

// A list is read again at every change of the study; an examination of minutes would never end.
TEST_F(Examiner, GoesOnForAPageThatRequestsTheSameAgain) {
  request(list_, {protocol("1.0.0"), protocol("2.0.0")});
  ASSERT_TRUE(eventually([&] { return gate_->has_begun(1); }));
  request(list_, {protocol("1.0.0"), protocol("2.0.0")});
  gate_->is_open = true;
  ASSERT_TRUE(arrive(2));
  EXPECT_EQ(versions_, (Versions{"1.0.0", "2.0.0"}));
  EXPECT_EQ(gate_->begun, 2);
  EXPECT_EQ(gate_->stopped, 0);
}

TEST_F(Examiner, ExaminesAgainAtOnceWhenAFileIsReplacedMeanwhile) {
  request(list_, {protocol("1.0.0")});
  ASSERT_TRUE(eventually([&] { return gate_->has_begun(1); }));
  save_picture(study_ / "stimuli" / "grain_photo.png", {2, 2, {1.0F, 0.0F, 0.0F, 1.0F}},
               Overwrite::allow);
  gate_->is_open = true;
  ASSERT_TRUE(arrive(1));
  EXPECT_EQ(gate_->begun, 2);
}

TEST_F(Examiner, StatesWhyStimuliCouldNotBeExaminedAndTriesAgain) {
  int calls = 0;
  examiner_->set_examine([&calls](const Protocol&, const std::stop_token&) -> StimulusExamination {
    if (++calls == 1) throw std::runtime_error("no memory for the relief");
    return {};
  });
  request(list_, {protocol("1.0.0")});
  ASSERT_TRUE(arrive(1));
  ASSERT_EQ(results_[0]->warnings.size(), 1U);
  EXPECT_EQ(results_[0]->warnings[0].message.english(),
            "the stimuli could not be examined: no memory for the relief");
  request(list_, {protocol("1.0.0")});
  ASSERT_TRUE(arrive(2));
  EXPECT_TRUE(results_[1]->warnings.empty());
}

}  // namespace
}  // namespace asperity
