// The examination of a text that does not stay the same.

#include "app/gui/editor/live_examination.h"

#include <memory>
#include <string>

#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "tests/app/small_study.h"
#include "tests/gui/support/gated_examination.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

class TheLiveExamination : public testing::Test {
 protected:
  TheLiveExamination() {
    make_small_study(folder_ / "study");
    examiner_.set_examine(examine_through(gate_));
  }
  std::shared_ptr<const Protocol> protocol() const {
    return std::make_shared<const Protocol>(read_small_protocol(models_, small_protocol()));
  }

  TemporaryFolder folder_{};
  ModelRegistry models_ = built_in_models();
  std::shared_ptr<GatedExamination> gate_ = std::make_shared<GatedExamination>();
  StimulusExaminer examiner_{folder_ / "study", models_};
  LiveExamination live_{examiner_};
};

TEST_F(TheLiveExamination, BeginsOnceTheTextIsStill) {
  live_.want(protocol());
  EXPECT_FALSE(live_.is_under_way()) << "the text may change at once";
  live_.want(protocol());
  ASSERT_TRUE(eventually([&] { return live_.is_under_way(); }));
  EXPECT_EQ(live_.result(), nullptr);
  gate_->is_open = true;
  ASSERT_TRUE(eventually([&] { return live_.result() != nullptr; }));
  EXPECT_FALSE(live_.is_under_way());
  EXPECT_EQ(live_.result()->warnings.size(), 1U);
  EXPECT_EQ(gate_->begun, 1);
}

TEST_F(TheLiveExamination, IsAbandonedWithItsResultWhenTheTextChanges) {
  live_.want(protocol());
  ASSERT_TRUE(eventually([&] { return gate_->has_begun(1); }));
  live_.abandon();
  EXPECT_FALSE(live_.is_under_way());
  ASSERT_TRUE(eventually([&] { return gate_->has_stopped(1); }));
  gate_->is_open = true;
  live_.want(protocol());
  ASSERT_TRUE(eventually([&] { return live_.result() != nullptr; }));
  live_.abandon();
  EXPECT_EQ(live_.result(), nullptr);
}

}  // namespace
}  // namespace asperity
