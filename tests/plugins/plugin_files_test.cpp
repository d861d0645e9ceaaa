// Loading plug-ins: what is refused and with which sentence, what is latched, and that a plug-in is unloaded.

#include "app/plugins/plugin_files.h"

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/conformance/heap_calls.h"
#include "renderers/servo/servo_loop.h"
#include "results_schema/hashes/sha256.h"
#include "tests/support/refusal.h"
#include "tests/support/scripted_device.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::filesystem::path with_fault(const std::string& fault) {
  return std::filesystem::path(ASPERITY_FAULTY_PLUGINS) / ("faulty_" + fault + ".so");
}

/// The sentence with which the plug-in is refused.
std::string refusal_of_plugin(const std::filesystem::path& file) {
  return refusal_of<std::runtime_error>([&] { (void)models_with({file}); });
}

ProbeState at_depth(double depth_m, int tick) {
  ProbeState probe{};
  probe.time_ns = tick * 1'000'000LL;
  probe.position_m = {0.0, 0.0, -depth_m};
  return probe;
}

TEST(PluginFiles, AddAModelLikeABuiltInOne) {
  const ModelRegistry models = models_with({with_fault("none")});
  const ForceModel* const model = models.find("faulty");
  ASSERT_NE(model, nullptr);
  const ModelRegistry built_in = built_in_models();
  EXPECT_EQ(models.models().size(), built_in.models().size() + 1);
  EXPECT_EQ(model->plugin.value().file, "faulty_none.so");
  EXPECT_EQ(model->plugin.value().sha256, sha256_of_file(with_fault("none")));
  // Its own parameter comes first, then those of the shared layers.
  EXPECT_EQ(model->declaration.parameters.front().name, "amplitude_m");
  EXPECT_TRUE(complete_values(model->declaration, {}).contains("friction_law"));
  const auto renderer = models.make("faulty", {.material = {.stiffness_N_per_m = 800.0}});
  renderer->reset(at_depth(0.0, 0));
  EXPECT_NEAR(renderer->tick(at_depth(0.001, 1), 0.001).wrench.force_N.z, 0.8, 1e-12);
  EXPECT_EQ(renderer->error(), "");
}

TEST(PluginFiles, KeepThePluginLoadedAsLongAsARendererExists) {
  const std::filesystem::path file = with_fault("none");
  const auto is_loaded = [] {
    std::ifstream maps("/proc/self/maps");
    const std::string mapped{std::istreambuf_iterator<char>(maps), {}};
    return mapped.find("faulty_none.so") != std::string::npos;
  };
  std::unique_ptr<ForceRenderer> renderer{};
  {
    const ModelRegistry models = models_with({file});
    renderer = models.make("faulty", {});
  }
  EXPECT_TRUE(is_loaded());
  EXPECT_EQ(renderer->tick(at_depth(-0.001, 1), 0.001).penetration_m, 0.0);
  renderer.reset();
  EXPECT_FALSE(is_loaded());
}

TEST(PluginFiles, LoadAPluginThatWasBuiltAnewBesideItsFormerState) {
  const TemporaryFolder folder{};
  const std::filesystem::path file = folder.path() / "model.so";
  std::filesystem::copy_file(with_fault("none"), file);
  const ForceModel former = open_plugin(file);
  const auto overwrite = std::filesystem::copy_options::overwrite_existing;
  std::filesystem::copy_file(with_fault("anew"), file, overwrite);
  const ForceModel anew = open_plugin(file);
  EXPECT_EQ(former.declaration.version, "1");
  EXPECT_EQ(anew.declaration.version, "2");
  EXPECT_NE(former.plugin.value().sha256, anew.plugin.value().sha256);
  const auto renderer = make_renderer(former, {});
  renderer->reset(at_depth(0.0, 0));
  EXPECT_GT(renderer->tick(at_depth(0.001, 1), 0.001).wrench.force_N.z, 0.0) << "the former code";
}

TEST(PluginFiles, KeepSeveralBuildsOnlyToRenderAttemptsAgain) {
  const std::filesystem::path former = with_fault("none");
  const std::filesystem::path rebuilt = with_fault("rebuilt");
  EXPECT_THAT(refusal_of<std::runtime_error>([&] {
                (void)models_with({former, rebuilt});
              }),
              HasSubstr("the id \"faulty\" of its force model is that of the plug-in "
                        "faulty_none.so; choose another id"));
  const ModelBuilds builds = models_with_builds({former, rebuilt, former});
  const ModelRegistry built_in = built_in_models();
  EXPECT_EQ(builds.models().models().size(), built_in.models().size() + 1);
  for (const std::filesystem::path& file : {former, rebuilt}) {
    const std::string sha256 = sha256_of_file(file);
    const ForceModel* const build = builds.find("faulty", sha256);
    ASSERT_NE(build, nullptr) << file;
    EXPECT_EQ(build->plugin.value().file, file.filename());
    const ModelRegistry chosen = builds.with({{"faulty", sha256}});
    EXPECT_EQ(chosen.models().size(), builds.models().models().size());
    EXPECT_EQ(chosen.find("faulty")->plugin.value().sha256, sha256);
  }
  EXPECT_EQ(builds.models().find("faulty"), builds.find("faulty", sha256_of_file(former)));
  const std::string another(64, '0');
  EXPECT_EQ(builds.find("faulty", another), nullptr);
  EXPECT_FALSE(builds.has({{"faulty", another}}));
  const ModelRegistry without = builds.with({{"faulty", another}});
  EXPECT_NE(without.find("faulty"), nullptr) << "the first one";
  EXPECT_EQ(builds.find("sinusoid", ""), nullptr) << "a built-in model";
}

TEST(PluginFiles, NameAPluginThatEndsTheProgram) {
  EXPECT_DEATH((void)models_with({with_fault("crash")}),
               "the plug-in faulty \\(faulty_crash.so\\) ended the program with an invalid memory "
               "access \\(SIGSEGV\\) in its function tick; correct the plug-in");
}

TEST(PluginFiles, DoNotNameAPluginIfOtherCodeEndsTheProgram) {
  const ModelRegistry models = models_with({with_fault("none")});
  models.make("faulty", {})->reset(at_depth(0.0, 0));
  EXPECT_EXIT(std::abort(), testing::KilledBySignal(SIGABRT), "^$");
}

TEST(PluginFiles, RefuseTextsThatAreNotUtf8) {
  EXPECT_THAT(refusal_of_plugin(with_fault("latin1")),
              AllOf(HasSubstr("faulty_latin1.so"), HasSubstr("asperity_model::summary"),
                    HasSubstr("is not UTF-8; save the source as UTF-8")));
}

TEST(PluginFiles, RefuseWhatIsNotAPlugin) {
  EXPECT_THAT(refusal_of_plugin("no_such_file.so"), HasSubstr("no_such_file.so"));
  EXPECT_THAT(refusal_of_plugin(ASPERITY_SOURCE_DIR "/README.md"),
              HasSubstr("give a shared library for this computer"));
  EXPECT_THAT(refusal_of_plugin(with_fault("symbol")),
              HasSubstr("it has no function asperity_plugin_model; define it"));
  EXPECT_THAT(
      refusal_of_plugin(with_fault("version")),
      HasSubstr("it has version 99 of the plug-in interface, and this program has version 1"));
  EXPECT_THAT(refusal_of_plugin(with_fault("description")),
              HasSubstr("asperity_model::amplitude_parameter is height_m"));
  EXPECT_THAT(refusal_of_plugin(with_fault("unit")),
              HasSubstr("asperity_model::parameters[0] (amplitude_m) has the unit \"mm\", and its "
                        "name ends in the unit \"m\"; correct one of them"));
  EXPECT_THAT(refusal_of_plugin(with_fault("taken")),
              HasSubstr("the id \"sinusoid\" of its force model is that of a built-in model; "
                        "choose another id"));
}

TEST(PluginFiles, RefuseAModelThatViolatesTheConformanceSuite) {
  EXPECT_THAT(refusal_of_plugin(with_fault("exception")), HasSubstr("finite: "));
  EXPECT_THAT(refusal_of_plugin(with_fault("exception")), HasSubstr("the ridge is too steep"));
  EXPECT_THAT(refusal_of_plugin(with_fault("uncaught")),
              HasSubstr("an exception left a function of the plug-in"));
  EXPECT_THAT(refusal_of_plugin(with_fault("nan")), HasSubstr("a result is not finite"));
  EXPECT_THAT(refusal_of_plugin(with_fault("slow")), HasSubstr("time_per_tick: median "));
  if (kCountsHeapCalls) {
    EXPECT_THAT(refusal_of_plugin(with_fault("allocates")), HasSubstr("no_allocation: "));
  }
}

// The stack of a thread can be used up by the plug-in, so that its name could not be written on it.
TEST(PluginFiles, HaveAStackForSignalsInEveryThreadThatLoadsThem) {
  for (int i = 0; i < 2; ++i) {
    bool has_stack = false;
    std::jthread([&] {
      (void)open_plugin(with_fault("none"));
      stack_t present{};
      has_stack = sigaltstack(nullptr, &present) == 0 && (present.ss_flags & SS_DISABLE) == 0;
    }).join();
    EXPECT_TRUE(has_stack) << "thread " << i;
  }
}

TEST(PluginFiles, StopTheirChecksOnRequest) {
  std::stop_source source{};
  source.request_stop();
  ModelRegistry models = built_in_models();
  EXPECT_THAT(refusal_of<std::runtime_error>(
                  [&] { add_plugin(with_fault("none"), models, {.stop = source.get_token()}); }),
              HasSubstr("its checks were stopped; load it again"));
  EXPECT_EQ(models.find("faulty"), nullptr);
}

TEST(PluginFiles, LetTheServoLoopLatchTheForceAtZeroWhenAPluginFails) {
  const ForceModel model = open_plugin(with_fault("late"));
  ScriptedDevice device;
  RecordRing records(4096);
  ServoLoop loop(device, records, {});
  loop.present({.id = 1, .renderer = make_renderer(model, {})});
  std::int64_t now_ns = 0;
  const auto ticks = [&](int count, double height_m) {
    device.probe.position_m.z = height_m;
    for (int i = 0; i < count; ++i) {
      loop.heartbeat();
      loop.tick(now_ns += 1'000'000);
    }
  };
  ticks(10, 0.01);
  ticks(99, -0.0005);
  EXPECT_EQ(loop.status().fault, Fault::none);
  EXPECT_GT(device.last_sent.force_N.z, 0.0);
  ticks(1, -0.0005);
  EXPECT_EQ(loop.status().fault, Fault::not_finite);
  EXPECT_EQ(device.last_sent.force_N.z, 0.0);
  ticks(50, -0.0005);
  EXPECT_EQ(loop.status().fault, Fault::not_finite) << "latched";
  EXPECT_EQ(device.last_sent.force_N.z, 0.0);
  loop.withdraw();
  ticks(60, 0.01);
  const Presentation back = loop.collect();
  ASSERT_NE(back.renderer, nullptr);
  EXPECT_EQ(back.renderer->error(), "the hundredth tick");
  ASSERT_EQ(back.renderer->limits().size(), 2U);
  EXPECT_EQ(back.renderer->limits().front().name, "plugin_error");
  EXPECT_EQ(back.renderer->limits().front().ticks, 1U);
}

}  // namespace
}  // namespace asperity
