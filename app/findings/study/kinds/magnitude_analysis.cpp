#include "app/findings/study/kinds/magnitude_analysis.h"

#include <array>

namespace asperity {

namespace {

constexpr std::array kMagnitudeClaims{
    TestClaim{"spacing", "", "The roughness estimates differed significantly between the spacings",
              "", "The roughness estimates did not differ significantly between the spacings"},
    TestClaim{
        "interaction", "",
        "The effect of spacing on the roughness estimates differed significantly between the "
        "conditions",
        "",
        "The effect of spacing on the roughness estimates did not differ significantly between "
        "the conditions"},
    TestClaim{"condition", "",
              "The roughness estimates differed significantly between the conditions", "",
              "The roughness estimates did not differ significantly between the conditions"},
    TestClaim{"peaks", "", "The peak of %1 was at a significantly larger spacing than that of %2",
              "The peak of %1 was at a significantly smaller spacing than that of %2",
              "The spacings of the peaks of %1 and %2 were not significantly different"}};

std::string task_of_magnitude(const Protocol&) {
  return "Task: in each trial, one surface is presented, and a number is to be assigned to its "
         "roughness (absolute magnitude estimation with free modulus).";
}

std::string paper_task_of_magnitude(const Protocol&) {
  return ", and a number above 0 was to be assigned to its roughness (absolute magnitude "
         "estimation with free modulus).";
}

}  // namespace

const StudyAnalysis& magnitude_analysis() {
  static const StudyAnalysis kAnalysis{
      .kind = "magnitude",
      .name = phrase("Analysis", "magnitude estimation"),
      .claims = kMagnitudeClaims,
      .task = task_of_magnitude,
      .task_for_paper = paper_task_of_magnitude,
      .transformation =
          "Estimates were analysed as logarithms. For means, curves and exponents each "
          "participant's estimates were normalised by the geometric mean of that participant's "
          "cells.",
      .analyze = analyze_magnitude,
      .estimates = exponents_sentence};
  return kAnalysis;
}

}  // namespace asperity
