// The conformance suite: the built-in models meet it, and a faulty model violates the check for its fault.

#include "renderers/conformance/conformance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/conformance/check_paths.h"
#include "renderers/conformance/heap_calls.h"
#include "renderers/models/sinusoid.h"
#include "renderers/servo/servo_thread.h"

namespace asperity {
namespace {

/// What a fault does to a result of the sinusoid, in the tick of this number since the last reset.
using PlantedFault = std::function<void(RenderedTick&, int tick, double dt_s)>;

class FaultyRenderer final : public ForceRenderer {
 public:
  FaultyRenderer(std::unique_ptr<ForceRenderer> sound, PlantedFault fault)
      : sound_(std::move(sound)), fault_(std::move(fault)) {}
  void reset(const ProbeState& first) noexcept override {
    ticks_ = 0;
    sound_->reset(first);
  }
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    RenderedTick result = sound_->tick(probe, dt_s);
    fault_(result, ticks_++, dt_s);
    return result;
  }

 private:
  std::unique_ptr<ForceRenderer> sound_{};
  PlantedFault fault_{};
  int ticks_ = 0;
};

ForceModel with_fault(const PlantedFault& fault) {
  ForceModel model = sinusoid_model();
  model.make = [sound = model.make, fault](const RendererInputs& inputs) {
    return std::make_unique<FaultyRenderer>(sound(inputs), fault);
  };
  return model;
}

std::vector<std::string> violated_by(const ForceModel& model) {
  std::vector<std::string> names{};
  for (const ConformanceCheck& check : conformance_of(model)) {
    if (check.result == Conformance::violated) names.emplace_back(check.name);
  }
  return names;
}

class BuiltInModel : public testing::TestWithParam<std::string> {};

TEST_P(BuiltInModel, MeetsEveryCheck) {
  const ModelRegistry registry = built_in_models();
  for (const ConformanceCheck& check : conformance_of(*registry.find(GetParam()))) {
    EXPECT_NE(check.result, Conformance::violated)
        << check.name << ": " << check.measured << "; required " << check.required;
  }
}

std::vector<std::string> ids_of_built_in_models() {
  std::vector<std::string> ids{};
  const ModelRegistry registry = built_in_models();
  for (const ForceModel& model : registry.models()) ids.push_back(model.declaration.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Conformance, BuiltInModel, testing::ValuesIn(ids_of_built_in_models()),
                         [](const auto& model) { return model.param; });

// The velocity of the last of them is that of the tick before, half a tick late.
TEST(ConformancePaths, HaveTheVelocitiesOfTheirPositions) {
  const ForceModel model = sinusoid_model();
  for (const std::vector<ProbeState>& path :
       {stroke(model, 1.0, kConformanceRate_Hz), wandering(model, 1.0), around_sphere(1.0)}) {
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const double between_s =
          1e-9 * static_cast<double>(path[i + 1].time_ns - path[i - 1].time_ns);
      const glm::dvec3 moved_m = path[i + 1].position_m - path[i - 1].position_m;
      ASSERT_LT(glm::distance(path[i].velocity_m_per_s, moved_m / between_s), 5e-3) << i;
    }
  }
}

TEST(Conformance, HasNoCheckThatDoesNotApplyToAPointModel) {
  if (!kCountsHeapCalls) GTEST_SKIP() << "the sanitizer owns the heap";
  std::vector<std::string> names{};
  for (const ConformanceCheck& check : conformance_of(sinusoid_model())) {
    EXPECT_EQ(check.result, Conformance::met) << check.name;
    EXPECT_NE(check.measured, "") << check.name;
    EXPECT_NE(check.required, "") << check.name;
    names.emplace_back(check.name);
    if (check.name == "finite") {
      EXPECT_THAT(check.measured, testing::MatchesRegex("[1-9][0-9 ]* ticks.*"));
    }
  }
  EXPECT_THAT(names, testing::ElementsAre("zero_amplitude", "deterministic", "finite",
                                          "no_allocation", "band", "time_per_tick"));
}

TEST(Conformance, IsViolatedByAForceThatRemainsAtAmplitudeZero) {
  const auto offset = [](RenderedTick& result, int, double) {
    if (result.penetration_m > 0.0) result.wrench.force_N.x += 0.01;
  };
  EXPECT_THAT(violated_by(with_fault(offset)), testing::ElementsAre("zero_amplitude"));
}

TEST(Conformance, IsViolatedByAModelThatRemembersEarlierPresentations) {
  const auto drift = [step = 0.0](RenderedTick& result, int, double) mutable {
    step += 1e-13;  // below what the plate allows
    if (result.penetration_m > 0.0) result.wrench.force_N.z += step;
  };
  EXPECT_THAT(violated_by(with_fault(drift)), testing::ElementsAre("deterministic"));
  for (const ConformanceCheck& check : conformance_of(with_fault(drift))) {
    if (check.name != "deterministic") continue;
    EXPECT_THAT(check.measured, testing::MatchesRegex(".* [1-9][0-9]{0,2} after reset, of 600"));
  }
}

TEST(Conformance, IsViolatedByANumberThatIsNotFiniteAndByAForceInFreeSpace) {
  const auto division = [](RenderedTick& result, int tick, double) {
    if (tick == 200 && result.penetration_m > 0.0) {
      result.wrench.force_N.x = std::numeric_limits<double>::quiet_NaN();
    }
  };
  EXPECT_THAT(violated_by(with_fault(division)), testing::Contains("finite"));
  // Infinite in a recording, which has floats.
  const auto overflow = [](RenderedTick& result, int tick, double) {
    if (tick == 200 && result.penetration_m > 0.0) result.wrench.torque_N_m.y = 1e39;
  };
  EXPECT_THAT(violated_by(with_fault(overflow)), testing::ElementsAre("finite"));
  const auto pull = [](RenderedTick& result, int, double) {
    if (result.penetration_m == 0.0) result.wrench.force_N.z = 0.1;
  };
  EXPECT_THAT(violated_by(with_fault(pull)), testing::ElementsAre("finite"));
}

ConformanceCheck finite_of(const ForceModel& model) {
  for (ConformanceCheck& check : conformance_of(model)) {
    if (check.name == "finite") return check;
  }
  throw std::runtime_error("the suite has no check finite");
}

TEST(Conformance, IsViolatedByLimitsOfSeveralParametersTogether) {
  ForceModel model = sinusoid_model();
  model.make = [sound = model.make](const RendererInputs& inputs) {
    const auto limit_of = [&](const std::string& name, double Parameter::*limit) {
      for (const Parameter& parameter : sinusoid_model().declaration.parameters) {
        if (parameter.name == name) return parameter.*limit;
      }
      throw std::runtime_error("no parameter " + name);
    };
    const bool is_steepest = number_of(inputs.parameters, "amplitude_m") ==
                                 limit_of("amplitude_m", &Parameter::maximum) &&
                             number_of(inputs.parameters, "wavelength_m") ==
                                 limit_of("wavelength_m", &Parameter::minimum);
    return std::make_unique<FaultyRenderer>(
        sound(inputs), [is_steepest](RenderedTick& result, int, double) {
          if (is_steepest) result.wrench.force_N.x = std::numeric_limits<double>::quiet_NaN();
        });
  };
  const ConformanceCheck check = finite_of(model);
  EXPECT_EQ(check.result, Conformance::violated);
  EXPECT_THAT(
      check.measured,
      testing::AllOf(testing::HasSubstr("a number that is not finite as stored with "),
                     testing::HasSubstr("amplitude_m="), testing::HasSubstr("wavelength_m=")));
}

TEST(Conformance, IsViolatedByAFailureOnABody) {
  // On the plane of `finite` a contact begins above the surface, and on a body also where another projection comes into use.
  const auto begins_in_contact = [](RenderedTick& result, int tick, double) {
    if (tick == 0 && result.penetration_m > 0.0) {
      result.wrench.force_N.x = std::numeric_limits<double>::quiet_NaN();
    }
  };
  ForceModel model = with_fault(begins_in_contact);
  for (Parameter& parameter : model.declaration.parameters) {
    // At a greater amplitude the path on the plane begins in the surface.
    if (parameter.name == "amplitude_m") {
      parameter.maximum = std::get<double>(parameter.default_value);
    }
  }
  const ConformanceCheck check = finite_of(model);
  EXPECT_EQ(check.result, Conformance::violated);
  EXPECT_THAT(check.measured, testing::HasSubstr("with default parameters on a sphere"));
}

TEST(Conformance, CanBeFollowedAndStopped) {
  std::stop_source source{};
  std::vector<double> progress{};
  const ForceModel model = sinusoid_model();
  const std::vector<ConformanceCheck> all =
      conformance_of(model, {.progress = [&](double done) { progress.push_back(done); }});
  ASSERT_EQ(all.size(), progress.size());
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.front(), 0.0);
  EXPECT_LT(progress.back(), 1.0);
  std::size_t begun = 0;
  const std::vector<ConformanceCheck> checks =
      conformance_of(model, {.stop = source.get_token(), .progress = [&](double) {
                               if (++begun == 2) source.request_stop();
                             }});
  EXPECT_EQ(checks.size(), 2U);
}

TEST(Conformance, IsViolatedByAnAllocationInATick) {
  if (!kCountsHeapCalls) GTEST_SKIP() << "the sanitizer owns the heap";
  const auto allocation = [kept = std::vector<int>()](RenderedTick&, int tick, double) mutable {
    kept.assign(static_cast<std::size_t>(tick + 1), tick);
    kept.shrink_to_fit();
  };
  EXPECT_THAT(violated_by(with_fault(allocation)), testing::ElementsAre("no_allocation"));
}

TEST(Conformance, IsViolatedByATextureAboveItsDeclaredBand) {
  ForceModel model = sinusoid_model();
  model.band = [](const RendererInputs&) { return TextureBand{.per_m = 20.0}; };
  EXPECT_THAT(violated_by(model), testing::ElementsAre("band"));
  model.band = [](const RendererInputs&) { return TextureBand{}; };
  EXPECT_THAT(violated_by(model), testing::ElementsAre("band"));
}

TEST(Conformance, IsViolatedByATickThatTakesMostOfThePeriod) {
  const auto wait = [](RenderedTick&, int tick, double dt_s) {
    // Only in the long path of the check of the time, which takes a second this way.
    if (tick < 900 || dt_s < 0.001) return;
    const std::int64_t end_ns = monotonic_now_ns() + 600'000;
    while (monotonic_now_ns() < end_ns) continue;
  };
  EXPECT_THAT(violated_by(with_fault(wait)), testing::ElementsAre("time_per_tick"));
}

TEST(Conformance, IsViolatedByAModelThatRefusesItsDefaults) {
  ForceModel model = sinusoid_model();
  model.make = [](const RendererInputs&) -> std::unique_ptr<ForceRenderer> {
    throw std::invalid_argument("no grating today");
  };
  const std::vector<ConformanceCheck> checks = conformance_of(model);
  EXPECT_FALSE(is_conformant(checks));
  EXPECT_EQ(checks.front().measured, "no grating today");
}

}  // namespace
}  // namespace asperity
