// One option for each surface.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

struct AnsweredItem;
struct TrialQuestion;

/// Every surface is assigned one option, and every option belongs to one surface at most.
struct AssignmentForm {
  static constexpr std::string_view kName = "assignment";
};

struct AssignedOptions {
  std::vector<std::size_t>
      options{};  ///< indices in TrialQuestion::options, by position of the surface
};

constexpr int items_of(const AssignmentForm&, int surfaces) noexcept { return surfaces; }
std::vector<AnsweredItem> items_of(const TrialQuestion& question, const AssignmentForm&,
                                   const AssignedOptions& answer);
std::vector<std::string> problems_with(const TrialQuestion& question, const AssignmentForm&,
                                       const AnsweredItem& stored);
std::string label_of(const TrialQuestion& question, const AssignmentForm&,
                     const std::string& stored);

}  // namespace asperity
