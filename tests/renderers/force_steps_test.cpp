// The table of docs/safety.md: how far the force grows within a millisecond in every event, and what bounds it there.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "device/force_limiter.h"
#include "renderers/built_in_models.h"
#include "renderers/force/adjacent_patches.h"
#include "renderers/force/contact_fade.h"
#include "stimuli/meshes/solid_body.h"
#include "tests/renderers/force_scene.h"
#include "tests/renderers/points_on_bodies.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr std::array kRates_Hz{500.0, 1000.0, 2000.0, 4000.0};
constexpr double kStiffness_N_per_m = 1000.0;
constexpr double kDown_m_per_s = 0.05;
constexpr double kAcross_m_per_s = 0.2;
constexpr double kHalfPatch_m = 0.010;
constexpr double kGap_s = 0.045;
constexpr double kRounding_N = 1e-6;
constexpr double kRounding_N_m = 1e-9;

enum class Place { fade, wall, no_border, sphere, cylinder, box, plug_in };

const char* text_of(Place place) {
  switch (place) {
    case Place::fade:
      return "plane, `fade`";
    case Place::wall:
      return "plane, `wall`";
    case Place::no_border:
      return "plane without a border";
    case Place::sphere:
      return "sphere of 40 mm";
    case Place::cylinder:
      return "cylinder of 40 mm, lying";
    case Place::box:
      return "box of 20 mm";
    case Place::plug_in:
      return "plug-in";
  }
  return "";
}

/// A surface, and how a hand touches it.
struct Surface {
  std::string name{};
  std::function<std::unique_ptr<ForceRenderer>(Place place, double stiffness_N_per_m)> make{};
  double contact_m = 0.0;  ///< the height of the probe at which it touches
  double depth_m = 0.001;
  double stalled_m = 0.005;  ///< the depth after a stall

  glm::dvec3 above_m(double x_m) const { return {x_m, 0.0, contact_m + 0.0015}; }
  glm::dvec3 inside_m(double x_m) const { return {x_m, 0.0, contact_m - depth_m}; }
};

void touch_down(Scene& scene, const Surface& surface, Place place, double x_m) {
  scene.place(surface.above_m(x_m));
  scene.present(surface.make(place, kStiffness_N_per_m));
  scene.rest(0.06);
  scene.move(surface.inside_m(x_m), kDown_m_per_s);
}

/// A hand that has pressed and rests.
void press(Scene& scene, const Surface& surface, Place place) {
  touch_down(scene, surface, place, 0.0);
  scene.rest(0.02);
  scene.begin_event();
}

using Run = std::function<void(Scene& scene, const Surface& surface, Place place)>;

/// What the force may grow by within a window, with the limiter wide open.
using Bound = std::function<double(const Scene& scene, const Measured& reference)>;

struct Event {
  std::string name{};
  std::string reason{};  ///< of the bound
  Run run{};
  std::optional<Bound> bound{};
  Run reference{};  ///< what the bound compares the event with
  std::vector<Place> places{Place::fade, Place::wall, Place::sphere};
};

const std::vector<Place> kBorders{Place::fade, Place::wall};
const std::vector<Place> kEveryBody{Place::fade, Place::wall, Place::sphere, Place::cylinder,
                                    Place::box};

/// The body at a place; null on a plane.
std::shared_ptr<const BodySurface> body_at(Place place) {
  const auto body = [](TexturedMesh mesh) {
    return std::make_shared<const BodySurface>(placed(std::move(mesh), BodyRole::surface));
  };
  if (place == Place::sphere) return sphere();
  if (place == Place::cylinder) {
    static const auto kCylinder =
        body(turned(body_mesh(CylinderShape{2.0 * kGlobeRadius_m, 2.0 * kGlobeRadius_m}, nullptr),
                    BodyAxis::y));
    return kCylinder;
  }
  if (place == Place::box) {
    static const auto kBox =
        body(body_mesh(BoxShape{{2.0 * kHalfPatch_m, 2.0 * kHalfPatch_m, 0.02}}, nullptr));
    return kBox;
  }
  return nullptr;
}

double own_N(const Scene& scene, const Measured&) { return scene.measured.own.largest; }

std::vector<Event> events_of_touch() {
  const auto down = [](double x_m) {
    return [x_m](Scene& scene, const Surface& surface, Place place) {
      touch_down(scene, surface, place, x_m);
    };
  };
  const Bound limit = [](const Scene&, const Measured&) { return ForceLimits{}.slew_N; };
  // What a law takes from the depth grows by the stiffness times the way, and on the slopes of this grating by up to a tenth more. What it
  // does not take from the depth is a force along the surface, of a hand that comes straight down: it fades in (contact_fade.h).
  const Bound begins_at_zero = [](const Scene& scene, const Measured&) {
    constexpr double kSlopes = 1.1;
    constexpr double kSteepest = 1.5;
    const double way_m = kDown_m_per_s * window_s(scene.rate_Hz());
    const double faded_in = std::min(1.0, kSteepest * way_m / kContactFade_m);
    const double along_N = std::hypot(scene.sent_N().x, scene.sent_N().y);
    return std::min(ForceLimits{}.slew_N,
                    kSlopes * kStiffness_N_per_m * way_m + faded_in * along_N);
  };
  const Run across = [](Scene& scene, const Surface& surface, Place place) {
    press(scene, surface, place);
    scene.move(surface.inside_m(kHalfPatch_m + 0.002), kAcross_m_per_s);
  };
  const auto without_border = [](const Run& run) {
    return [run](Scene& scene, const Surface& surface, Place) {
      run(scene, surface, Place::no_border);
    };
  };
  return {
      {.name = "touch-down in the middle, 50 mm/s",
       .reason = "the force begins at 0, or fades in over 0.1 mm: 1.1 × stiffness × way, and in 1 "
                 "ms three "
                 "quarters of a force along the surface",
       .run = down(0.0),
       .bound = begins_at_zero,
       .places = kEveryBody},
      {.name = "touch-down 2 mm inside the border",
       .reason = "the same",
       .run = down(kHalfPatch_m - 0.002),
       .bound = begins_at_zero,
       .places = kBorders},
      // Deeper than to the side: the contact stays on the face on which it began.
      {.name = "touch-down 0.5 mm inside an edge",
       .reason = "the same",
       .run = down(kHalfPatch_m - 0.0005),
       .bound = begins_at_zero,
       .places = {Place::box}},
      {.name = "touch-down 5 mm beyond the border",
       .reason = "the wall begins where contact begins: no more than without a border",
       .run = down(kHalfPatch_m + 0.005),
       .bound = [](const Scene&, const Measured& endless) { return endless.open.largest; },
       .reference = without_border(down(kHalfPatch_m + 0.005)),
       .places = kBorders},
      // |ΔF| ≤ k·v·t of the wall (border_wall.h). A fade over 5 mm changes the force by 1.5·v·t/5 mm of it, 6 % in 1 ms:
      // less than the 0.2 N of the wall for any force up to 3.3 N.
      {.name = "stroke across the border, 200 mm/s",
       .reason = "the change without a border, and stiffness × way",
       .run = across,
       .bound =
           [](const Scene& scene, const Measured& endless) {
             return endless.own.largest +
                    kStiffness_N_per_m * kAcross_m_per_s * window_s(scene.rate_Hz());
           },
       .reference = without_border(across),
       .places = kBorders},
      {.name = "stroke across an edge, 200 mm/s",
       .reason = "the force turns within a tick at a sharp edge: 1 N",
       .run = across,
       .bound = limit,
       .places = {Place::box}},
  };
}

double no_growth(const Scene&, const Measured&) { return 0.0; }

/// Exerts the force of another renderer, until it fails.
class FailingRenderer final : public ForceRenderer {
 public:
  /// `fails` must outlive the renderer's last tick.
  FailingRenderer(std::unique_ptr<ForceRenderer> renderer, const bool& fails)
      : renderer_(std::move(renderer)), fails_(fails) {}
  void reset(const ProbeState& first) noexcept override { renderer_->reset(first); }
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    RenderedTick tick = renderer_->tick(probe, dt_s);
    if (fails_) tick.wrench.force_N.x = std::numeric_limits<double>::quiet_NaN();
    return tick;
  }

 private:
  std::unique_ptr<ForceRenderer> renderer_;
  const bool& fails_;
};

void expect_zero_at_once(Scene& scene, const Surface& surface) {
  EXPECT_GT(glm::length(scene.sent_N()), 0.0) << surface.name;
  scene.rest(1.0 / scene.rate_Hz());
  EXPECT_EQ(scene.sent_N(), glm::dvec3(0.0)) << surface.name;
  scene.rest(0.01);
}

std::vector<Event> events_in_contact() {
  const auto misread = [](double deeper_m, double duration_s) {
    return [=](Scene& scene, const Surface& surface, Place place) {
      press(scene, surface, place);
      for (int i = 0; i < duration_s * scene.rate_Hz(); ++i) scene.misread({0.0, 0.0, -deeper_m});
      scene.rest(0.005);
    };
  };
  constexpr double kOneReading_s = 1e-6;
  constexpr double kLasting_s = 0.01;
  const Bound as_without = [](const Scene&, const Measured& without) {
    return without.open.largest;
  };
  return {
      {.name = "one reading 25 mm deeper",
       .reason = "the reading before is held: as without it",
       .run = misread(0.025, kOneReading_s),
       .bound = as_without,
       .reference = misread(0.0, kOneReading_s)},
      {.name = "lasting jump of the readings by 25 mm",
       .reason = "the reading before is held for 2 ms, then zero in the same tick: as without it",
       .run =
           [misread](Scene& scene, const Surface& surface, Place place) {
             misread(0.025, kLasting_s)(scene, surface, place);
             EXPECT_EQ(scene.loop().status().fault, Fault::device_lost) << surface.name;
             EXPECT_EQ(scene.sent_N(), glm::dvec3(0.0)) << surface.name;
           },
       .bound = as_without,
       .reference = misread(0.0, kLasting_s)},
      {.name = "lasting jump of the readings by 4 mm",
       .reason = "the limiter alone: up to 5 mm are a possible motion",
       .run =
           [](Scene& scene, const Surface& surface, Place place) {
             press(scene, surface, place);
             scene.place({0.0, 0.0, surface.contact_m - surface.stalled_m});
             scene.rest(0.03);
           }},
      // f = p + s·(a − p) with s = t/T: |Δf| ≤ |Δa| + Δs·|a − p|, and |a − p| ≤ |a|, as 0 is a fall as well (gap_bridge.h).
      {.name = "stall of 45 ms, after which the hand is 4 mm deeper",
       .reason = "the force approaches that of the surface over 45 ms: its change, and force × "
                 "time / 45 ms",
       .run =
           [](Scene& scene, const Surface& surface, Place place) {
             press(scene, surface, place);
             const glm::dvec3 deeper_m{0.0, 0.0, surface.contact_m - surface.stalled_m};
             scene.tick(deeper_m, kGap_s);
             scene.rest(0.06);
           },
       .bound =
           [](const Scene& scene, const Measured&) {
             return scene.measured.own.largest +
                    scene.measured.rendered_N * window_s(scene.rate_Hz()) / kGap_s;
           },
       .places = kEveryBody},
      {.name = "surface presented around the probe",
       .reason = "no force before the hand has been outside: 0",
       .run =
           [](Scene& scene, const Surface& surface, Place place) {
             scene.place(surface.inside_m(0.0));
             scene.present(surface.make(place, kStiffness_N_per_m));
             scene.rest(0.1);
           },
       .bound = no_growth},
      {.name = "next surface, four times as stiff, in contact",
       .reason =
           "the first fades out over 50 ms; no force of the next before the hand has been outside",
       .run =
           [](Scene& scene, const Surface& surface, Place place) {
             press(scene, surface, place);
             scene.present(surface.make(place, 4.0 * kStiffness_N_per_m));
             scene.rest(0.15);
           },
       .bound = own_N},
      {.name = "end of a block in contact, and 0.2 s later the next surface, four times as stiff",
       .reason =
           "the first fades out over 50 ms; no force of the next before the hand has been outside",
       .run =
           [](Scene& scene, const Surface& surface, Place place) {
             press(scene, surface, place);
             scene.loop().withdraw();
             scene.rest(0.2);
             EXPECT_EQ(scene.sent_N(), glm::dvec3(0.0)) << surface.name;
             scene.present(surface.make(place, 4.0 * kStiffness_N_per_m));
             scene.rest(0.1);
           },
       .bound = own_N},
      {.name = "emergency stop in contact",
       .reason = "zero in the same tick",
       .run =
           [](Scene& scene, const Surface& surface, Place place) {
             press(scene, surface, place);
             scene.loop().emergency_stop();
             expect_zero_at_once(scene, surface);
           },
       .bound = no_growth},
      {.name = "force that is not finite, in contact",
       .reason = "zero in the same tick",
       .run =
           [](Scene& scene, const Surface& surface, Place place) {
             bool fails = false;
             const Surface failing{.name = surface.name,
                                   .make =
                                       [&](Place at, double stiffness_N_per_m) {
                                         return std::make_unique<FailingRenderer>(
                                             surface.make(at, stiffness_N_per_m), fails);
                                       },
                                   .contact_m = surface.contact_m,
                                   .depth_m = surface.depth_m};
             press(scene, failing, place);
             fails = true;
             expect_zero_at_once(scene, surface);
             EXPECT_EQ(scene.loop().status().fault, Fault::not_finite) << surface.name;
           },
       .bound = no_growth},
      {.name = "fault, cleared in contact",
       .reason = "zero at once; no force before the hand has been outside",
       .run =
           [](Scene& scene, const Surface& surface, Place place) {
             press(scene, surface, place);
             scene.loop().emergency_stop();
             scene.rest(0.01);
             scene.loop().clear_fault(Fault::emergency_stop);
             scene.rest(0.1);
           },
       .bound = own_N},
  };
}

/// What a plug-in may do: its whole force at once.
class StepRenderer final : public ForceRenderer {
 public:
  /// Without a depth, as a force in free space.
  enum class Begins { at_once, in_contact };
  explicit StepRenderer(Begins begins) : begins_(begins) {}
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    RenderedTick tick{};
    if (begins_ == Begins::in_contact && probe.position_m.z >= 0.0) return tick;
    tick.wrench.force_N = {0.0, 3.0, 4.0};
    if (begins_ == Begins::in_contact) tick.penetration_m = -probe.position_m.z;
    return tick;
  }

 private:
  Begins begins_;
};

std::vector<Event> events_of_plug_in() {
  const Run first = [](Scene& scene, const Surface&, Place) {
    scene.present(std::make_unique<StepRenderer>(StepRenderer::Begins::at_once));
    scene.rest(0.1);
  };
  const Run touch = [](Scene& scene, const Surface& surface, Place) {
    scene.place(surface.above_m(0.0));
    scene.present(std::make_unique<StepRenderer>(StepRenderer::Begins::in_contact));
    scene.rest(0.06);
    scene.move(surface.inside_m(0.0), kDown_m_per_s);
  };
  return {
      {.name = "first force of a plug-in, 5 N from its first tick",
       .reason = "it fades in over 50 ms: force × time / 50 ms",
       .run = first,
       .bound =
           [](const Scene& scene, const Measured&) {
             return 5.0 * window_s(scene.rate_Hz()) / ServoSettings{}.ramp_s;
           },
       .places = {Place::plug_in}},
      {.name = "touch-down on a plug-in, 5 N from its first tick in contact",
       .reason = "the limiter alone",
       .run = touch,
       .places = {Place::plug_in}},
  };
}

std::unique_ptr<ForceRenderer> renderer_of(const ForceModel& model, Place place,
                                           double stiffness_N_per_m) {
  RendererInputs inputs{};
  inputs.material = {.stiffness_N_per_m = stiffness_N_per_m, .friction = 0.2};
  inputs.height_field = grating();
  inputs.assets = files_of_models();
  inputs.seed = 1;
  inputs.patch.extent_m = {2.0 * kHalfPatch_m, 2.0 * kHalfPatch_m};
  inputs.patch.edge = place == Place::wall ? PatchEdge::wall : PatchEdge::fade;
  if (model.declaration.needs_bodies) {
    inputs.surface = std::make_shared<const TexturedMesh>(
        body_mesh(PlateShape{{0.04, 0.012, 0.004}}, grating().get()));
    inputs.tool = std::make_shared<const TexturedMesh>(body_mesh(SphereShape{0.002}, nullptr));
    inputs.parameters = {{"coupling", std::string("none")}, {"most_halvings", 0.0}};
  }
  if (const auto body = body_at(place)) {
    inputs.patch = wide_patch();
    inputs.body = body;
  }
  return make_renderer(model, place == Place::no_border ? without_border(inputs) : inputs);
}

std::vector<Surface> surfaces_of(const ModelRegistry& models, Place place) {
  if (place == Place::plug_in) return {{.name = "5 N at once"}};
  std::vector<Surface> surfaces{};
  for (const ForceModel& model : models.models()) {
    const bool is_two_bodies = model.declaration.needs_bodies;
    if (is_two_bodies && body_at(place) != nullptr) continue;
    Surface surface{.name = model.declaration.id,
                    .make = [&model](Place at, double stiffness_N_per_m) {
                      return renderer_of(model, at, stiffness_N_per_m);
                    }};
    if (is_two_bodies) {  // a ball of 2 mm, with its origin in its centre
      surface.contact_m = 0.001;
      surface.depth_m = 0.0003;
      surface.stalled_m = 0.0006;
    }
    surfaces.push_back(surface);
  }
  return surfaces;
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

struct Found {
  std::string table{};
  std::vector<std::string> problems{};
};

/// The row of an event at one place, over all surfaces.
void add_row(const ModelRegistry& models, const Event& event, Place place, Found& found) {
  std::string cells{};
  double largest_N = -1.0;
  std::string largest_with{};
  for (const double rate_Hz : kRates_Hz) {
    double open_N = 0.0;
    double limited_N = 0.0;
    for (const Surface& surface : surfaces_of(models, place)) {
      Scene scene(rate_Hz);
      event.run(scene, surface, place);
      Scene reference(rate_Hz);
      if (event.reference) event.reference(reference, surface, place);
      const double grown_N = scene.measured.open.largest;
      const std::string where = event.name + ", " + text_of(place) + ", " + surface.name + ", " +
                                std::to_string(rate_Hz) + " Hz: ";
      if (event.bound) {
        const double bound_N = (*event.bound)(scene, reference.measured);
        if (!(grown_N <= bound_N + kRounding_N)) {
          found.problems.push_back(where + std::to_string(grown_N) + " N, where " +
                                   std::to_string(bound_N) + " N are the bound");
        }
      }
      const double passed_N = scene.measured.limited.largest;
      if (!(passed_N <= ForceLimits{}.slew_N + kRounding_N)) {
        found.problems.push_back(where + std::to_string(passed_N) + " N behind the limiter");
      }
      const double passed_N_m = scene.measured.limited_torque.largest;
      if (!(passed_N_m <= ForceLimits{}.slew_N_m + kRounding_N_m)) {
        found.problems.push_back(where + std::to_string(passed_N_m) + " N·m behind the limiter");
      }
      open_N = std::max(open_N, grown_N);
      limited_N = std::max(limited_N, passed_N);
      if (grown_N > largest_N) {
        largest_N = grown_N;
        largest_with = surface.name;
      }
    }
    cells += ' ' + number(open_N) + "; " + number(limited_N) + " |";
  }
  found.table += "| " + event.name + " | " + event.reason + " | " + text_of(place) + " |" + cells +
                 ' ' + (largest_N > 0.0 ? largest_with : "–") + " |\n";
}

Found found_in_all_events() {
  const ModelRegistry models = built_in_models();
  Found found{};
  found.table =
      "<!-- force steps: written by scripts/force-steps -->\n"
      "| event | bound of the growth without the limiter | surface | 0.5 kHz | 1 kHz | 2 kHz | 4 "
      "kHz | largest with |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const auto& events : {events_of_touch(), events_in_contact(), events_of_plug_in()}) {
    for (const Event& event : events) {
      for (const Place place : event.places) add_row(models, event, place, found);
    }
  }
  found.table += "<!-- end of force steps -->\n";
  return found;
}

class ForceSteps : public testing::Test {
 protected:
  static const Found& found() {
    static const Found kFound = found_in_all_events();
    return kFound;
  }
};

TEST_F(ForceSteps, AreBoundedAtTheirSourceAndBehindTheLimiter) {
  for (const std::string& problem : found().problems) ADD_FAILURE() << problem;
}

// scripts/force-steps writes the table that is printed here into the page.
TEST_F(ForceSteps, AreThoseOfTheTableInSafety) {
  std::ifstream in(std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/safety.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(page.find(found().table), std::string::npos) << found().table;
}

}  // namespace
}  // namespace asperity
