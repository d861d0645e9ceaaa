// In which order the surfaces of a selection come, over many sessions.

#include <array>

#include "analysis/numbers/random.h"
#include "protocols/plan/plan.h"
#include "tests/gates/gate_checks.h"

namespace asperity {
namespace {

// 99.9 % quantiles of χ² with 5 and with 35 degrees of freedom.
constexpr double kOf5 = 20.52;
constexpr double kOf35 = 66.62;

std::string order_in(const Trial& trial) {
  std::string order{};
  for (const PlannedPresentation& surface : trial.presentations) order += surface.item + ' ';
  return order;
}

// Seeds as a simulation deals them out: by participant and session, of one seed.
TEST(SelectionOrders, AreAllAlikeAndTellNothingOfTheNext) {
  const Protocol protocol = library_protocol("chapter_selection");
  std::array<std::map<std::string, std::size_t>, 3> orders{};
  std::array<std::map<std::string, std::size_t>, 2> pairs{};
  for (std::uint64_t participant = 1; participant <= 2000; ++participant) {
    const std::uint64_t seed =
        Random(1).split("session").split(participant).split(std::uint64_t{0}).bits();
    const Plan plan = make_plan(protocol, {seed, 0});
    ASSERT_EQ(plan.trials.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      ++orders[i][order_in(plan.trials[i])];
      if (i > 0) ++pairs[i - 1][order_in(plan.trials[i - 1]) + order_in(plan.trials[i])];
    }
  }
  for (const auto& of_trial : orders) EXPECT_LT(chi_square_of_equal(of_trial, 6), kOf5);
  for (const auto& of_pair : pairs) EXPECT_LT(chi_square_of_equal(of_pair, 36), kOf35);
}

}  // namespace
}  // namespace asperity
