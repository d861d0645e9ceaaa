// Holds the table of designs with their trials, roles and responses.

#include "protocols/kind_keys/discrimination_design.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr std::string_view kStandard = "standard";
constexpr std::string_view kComparison = "comparison";

constexpr std::array kTrialsOfTwoAlternatives{DesignTrial{{kStandard, kComparison}}};
constexpr std::array kTrialsOfYesNo{DesignTrial{{kComparison, {}}},
                                    DesignTrial{{kStandard, {}}, false}};
constexpr std::array kTrialsOfSameDifferent{
    DesignTrial{{kStandard, kComparison}}, DesignTrial{{kStandard, kStandard}, false},
    DesignTrial{{kStandard, kComparison}}, DesignTrial{{kComparison, kComparison}, false}};
// The surface that is to be chosen is the last one, so that its place is balanced where positions are.
constexpr std::array kTrialsOfThreeAlternatives{DesignTrial{{kStandard, kStandard, kComparison}}};
constexpr std::array kTrialsOfOddity{DesignTrial{{kStandard, kStandard, kComparison}},
                                     DesignTrial{{kComparison, kComparison, kStandard}}};

}  // namespace

std::size_t DesignTrial::surfaces() const noexcept {
  return static_cast<std::size_t>(std::count_if(
      roles.begin(), roles.end(), [](std::string_view role) { return !role.empty(); }));
}

bool DesignTrial::presents(std::string_view role) const noexcept {
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

bool DiscriminationDesign::is_signal(std::size_t comparisons) const noexcept {
  return std::any_of(trials.begin(), trials.end(), [comparisons](const DesignTrial& trial) {
    const auto own = std::count(trial.roles.begin(), trial.roles.end(), kComparison);
    return trial.is_signal && static_cast<std::size_t>(own) == comparisons;
  });
}

std::string_view DiscriminationDesign::correct_response(std::size_t comparisons) const noexcept {
  if (has_noise()) return is_signal(comparisons) ? yes : no;
  return asks_for_odd_one && comparisons > 1 ? kStandard : kComparison;
}

const DiscriminationDesign& two_alternatives() noexcept {
  static const DiscriminationDesign kDesign{
      .id = "two_alternatives",
      .name = "two-alternative forced choice",
      .with_article = phrase("Protocols", "a two-alternative forced choice"),
      .trials = kTrialsOfTwoAlternatives};
  return kDesign;
}

const DiscriminationDesign& yes_no_task() noexcept {
  static const DiscriminationDesign kDesign{.id = "yes_no",
                                            .name = "yes/no task",
                                            .with_article = phrase("Protocols", "a yes/no task"),
                                            .trials = kTrialsOfYesNo,
                                            .yes = "yes",
                                            .no = "no"};
  return kDesign;
}

const DiscriminationDesign& same_different_task() noexcept {
  static const DiscriminationDesign kDesign{
      .id = "same_different",
      .name = "same–different task",
      .with_article = phrase("Protocols", "a same–different task"),
      .trials = kTrialsOfSameDifferent,
      .yes = "different",
      .no = "same"};
  return kDesign;
}

const DiscriminationDesign& three_alternatives() noexcept {
  static const DiscriminationDesign kDesign{
      .id = "three_alternatives",
      .name = "three-alternative forced choice",
      .with_article = phrase("Protocols", "a three-alternative forced choice"),
      .trials = kTrialsOfThreeAlternatives};
  return kDesign;
}

const DiscriminationDesign& oddity_task() noexcept {
  static const DiscriminationDesign kDesign{.id = "oddity",
                                            .name = "oddity task",
                                            .with_article = phrase("Protocols", "an oddity task"),
                                            .trials = kTrialsOfOddity,
                                            .asks_for_odd_one = true};
  return kDesign;
}

std::span<const DiscriminationDesign* const> discrimination_designs() {
  static const std::array kDesigns{&two_alternatives(), &three_alternatives(), &oddity_task(),
                                   &yes_no_task(), &same_different_task()};
  return kDesigns;
}

const DiscriminationDesign* find_design(std::string_view id) noexcept {
  for (const DiscriminationDesign* const design : discrimination_designs()) {
    if (design->id == id) return design;
  }
  return nullptr;
}

const DiscriminationDesign* design_with_option(std::string_view option) noexcept {
  for (const DiscriminationDesign* const design : discrimination_designs()) {
    if (design->has_noise() && (design->yes == option || design->no == option)) return design;
  }
  return nullptr;
}

}  // namespace asperity
