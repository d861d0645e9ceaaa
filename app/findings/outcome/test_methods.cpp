// One row per quantity that is a p; rows of the same method for different quantities have the same code.

#include "app/findings/outcome/test_methods.h"

#include <algorithm>

namespace asperity {

namespace {

Phrase binomial() { return phrase("TestMethods", "exact binomial test, one-sided"); }
Phrase permuted_pictures() {
  return phrase("TestMethods", "permutation test, pictures relabelled per participant, one-sided");
}
Phrase number_correct() { return phrase("TestMethods", "number correct"); }
Phrase difference_of_means() { return phrase("TestMethods", "difference of the means"); }
Phrase hedges_g_name() { return phrase("TestMethods", "Hedges’ g"); }
Phrase cohen_h_name() { return phrase("TestMethods", "Cohen’s h"); }
Phrase generalised_eta_name() { return phrase("TestMethods", "generalised η²"); }
Phrase coverage_of_d() {
  return phrase("TestMethods",
                "The CIs of d for choices are approximate: in simulations, their coverage was at "
                "least 92 % with a true d of at most 0.8, and at least 57 % with a larger one.");
}
Phrase coverage_of_w() {
  return phrase("TestMethods",
                "The CIs of W for choices are approximate: in simulations with 12 and 20 "
                "participants, their coverage was 77 to 100 %.");
}
Phrase permuted_groups() { return phrase("TestMethods", "permutation test of group labels"); }

std::string text_of(TestSides sides) {
  switch (sides) {
    case TestSides::undirected:
      return "non-directional";
    case TestSides::two_sided:
      return "two-sided";
    case TestSides::one_sided:
      return "one-sided";
  }
  return {};
}

/// Null where no test has the code.
const TestMethod* method_with_code(std::string_view code) {
  const auto methods = test_methods();
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [code](const TestMethod& each) { return each.code == code; });
  return found == methods.end() ? nullptr : &*found;
}

}  // namespace

std::span<const TestMethod> test_methods() {
  static const std::array kMethods{
      TestMethod{
          .p = "G.perm.p",
          .code = "g_permutation",
          .sides = TestSides::undirected,
          .name = phrase("TestMethods", "permutation test of independence"),
          .unit = kUnitOfAnswers,
          .symbol = "G²",
          .statistic = "G",
          .degrees = {"G.df", ""},
          .draws = "G.perm.draws",
          .smallest = "G.perm.smallest",
          .effect_symbol = "IT",
          .effect_name = phrase("TestMethods", "bias-corrected transmitted information in bits"),
          .effect = "IT.miller1955",
          .sources = {"Ernst 2004", "Miller 1955"}},
      TestMethod{.p = "friedman.p",
                 .code = "friedman",
                 .sides = TestSides::undirected,
                 .name = phrase("TestMethods", "Friedman test"),
                 .unit = kUnitOfParticipants,
                 .symbol = "χ²",
                 .statistic = "friedman.chisq",
                 .degrees = {"friedman.df", ""},
                 .effect_symbol = "W",
                 .effect_name = phrase("TestMethods", "Kendall’s coefficient of concordance"),
                 .effect = "kendall.W",
                 .effect_is_bounded = true,
                 .sources = {"Friedman 1937", "Kendall 1939"}},
      TestMethod{.p = "exponent.p",
                 .code = "exponent_t",
                 .sides = TestSides::two_sided,
                 .name = phrase("TestMethods", "t test of the exponent against 0, two-sided"),
                 .unit = kUnitOfParticipants,
                 .symbol = "t",
                 .statistic = "exponent.t",
                 .degrees = {"exponent.df", ""},
                 .effect_symbol = "exponent",
                 .effect = "exponent.mean"},
      TestMethod{.p = "group.perm.p.two",
                 .code = "group_permutation",
                 .sides = TestSides::two_sided,
                 .name = permuted_groups(),
                 .unit = kUnitOfParticipants,
                 .symbol = "ΔM",
                 .symbol_name = phrase("TestMethods",
                                       "difference of the mean numbers of correctly matched items "
                                       "per trial"),
                 .statistic = "group.diff",
                 .draws = "group.perm.draws",
                 .effect_symbol = "g",
                 .effect_name = hedges_g_name(),
                 .effect = "group.hedges.g",
                 .sources = {"Ernst 2004", "Hedges 1981"}},
      TestMethod{.p = "p",
                 .code = "rm_anova",
                 .sides = TestSides::undirected,
                 .name = phrase("TestMethods", "repeated-measures ANOVA"),
                 .unit = kUnitOfParticipants,
                 .symbol = "F",
                 .statistic = "F",
                 .degrees = {"df1", "df2"},
                 .effect_symbol = "η²G",
                 .effect_name = generalised_eta_name(),
                 .effect = "ges",
                 .effect_is_bounded = true,
                 .sources = {"", "Bakeman 2005"}},
      TestMethod{.p = "p.GG",
                 .code = "rm_anova_gg",
                 .sides = TestSides::undirected,
                 .name = phrase("TestMethods",
                                "repeated-measures ANOVA with Greenhouse–Geisser correction"),
                 .unit = kUnitOfParticipants,
                 .symbol = "F",
                 .statistic = "F",
                 .degrees = {"df1", "df2"},
                 .epsilon = "eps.GG",
                 .effect_symbol = "η²G",
                 .effect_name = generalised_eta_name(),
                 .effect = "ges",
                 .effect_is_bounded = true,
                 .sources = {"Greenhouse 1959", "Bakeman 2005"}},
      TestMethod{.p = "p.greater",
                 .code = "binomial",
                 .sides = TestSides::one_sided,
                 .name = binomial(),
                 .unit = kUnitOfAnswers,
                 .symbol = "k",
                 .symbol_name = number_correct(),
                 .statistic = "hits",
                 .effect_symbol = "h",
                 .effect_name = cohen_h_name(),
                 .effect = "cohen.h",
                 .sources = {"", "Cohen 1988"}},
      TestMethod{.p = "pc.p.greater",
                 .code = "binomial",
                 .sides = TestSides::one_sided,
                 .name = binomial(),
                 .unit = kUnitOfAnswers,
                 .symbol = "k",
                 .symbol_name = number_correct(),
                 .statistic = "pc.k",
                 .effect_symbol = "h",
                 .effect_name = cohen_h_name(),
                 .effect = "pc.h",
                 .sources = {"", "Cohen 1988"}},
      TestMethod{.p = "peakratio.p",
                 .code = "peak_ratio_t",
                 .sides = TestSides::two_sided,
                 .name = phrase("TestMethods", "t test of the log ratio of two peaks"),
                 .unit = kUnitOfParticipants,
                 .symbol = "t",
                 .statistic = "peakratio.t",
                 .degrees = {"peakratio.df", ""},
                 .effect_symbol = "ratio",
                 .effect = "peakratio"},
      TestMethod{.p = "perfect.relabel.p.greater",
                 .code = "picture_permutation",
                 .sides = TestSides::one_sided,
                 .name = permuted_pictures(),
                 .unit = kUnitOfParticipants,
                 .symbol = "k",
                 .symbol_name = number_correct(),
                 .statistic = "perfect.trials",
                 .draws = "relabel.draws",
                 .smallest = "perfect.relabel.smallest",
                 .effect_symbol = "h",
                 .effect_name = cohen_h_name(),
                 .effect = "perfect.h",
                 .estimate = "perfect.subj.mean",
                 .estimate_name = "mean proportion of trials with all items correct",
                 .sources = {"Ernst 2004", "Cohen 1988"}},
      TestMethod{.p = "perm.p.two",
                 .code = "group_permutation",
                 .sides = TestSides::two_sided,
                 .name = permuted_groups(),
                 .unit = kUnitOfParticipants,
                 .symbol = "ΔM",
                 .symbol_name = difference_of_means(),
                 .statistic = "subj.diff",
                 .draws = "perm.draws",
                 .effect_symbol = "g",
                 .effect_name = hedges_g_name(),
                 .effect = "hedges.g",
                 .sources = {"Ernst 2004", "Hedges 1981"}},
      TestMethod{.p = "profile.perm.p",
                 .code = "profile_permutation",
                 .sides = TestSides::undirected,
                 .name = phrase("TestMethods", "permutation test of group labels of profiles"),
                 .unit = kUnitOfParticipants,
                 .symbol = "R²",
                 .statistic = "profile.r2",
                 .draws = "profile.perm.draws",
                 .smallest = "profile.perm.smallest",
                 .sources = {"Anderson 2001", ""}},
      TestMethod{.p = "property.perm.p",
                 .code = "property_permutation",
                 .sides = TestSides::undirected,
                 .name = phrase("TestMethods", "permutation test of a regression on the positions"),
                 .unit = "items",
                 .symbol = "R²",
                 .statistic = "property.r2",
                 .draws = "property.draws",
                 .sources = {"Chang 1969", ""}},
      TestMethod{.p = "relabel.exact.p",
                 .code = "within_participant_permutation",
                 .sides = TestSides::undirected,
                 .name = phrase("TestMethods", "within-participant permutation test"),
                 .unit = kUnitOfParticipants,
                 .symbol = "X²",
                 .symbol_name = phrase("TestMethods", "Pearson’s X² of the pooled choices"),
                 .statistic = "relabel.X2",
                 .draws = "relabel.draws",
                 .smallest = "relabel.exact.smallest",
                 .effect_symbol = "W",
                 .effect_name = phrase("TestMethods", "Kendall’s W"),
                 .effect = "relabel.W",
                 .effect_is_bounded = true,
                 .sources = {"Ernst 2004", "Kendall 1939"},
                 .coverage = coverage_of_w()},
      TestMethod{.p = "relabel.p.greater",
                 .code = "picture_permutation",
                 .sides = TestSides::one_sided,
                 .name = permuted_pictures(),
                 .unit = kUnitOfParticipants,
                 .symbol = "k",
                 .symbol_name = number_correct(),
                 .statistic = "total.correct",
                 .draws = "relabel.draws",
                 .smallest = "relabel.smallest",
                 .effect_symbol = "θ",
                 .effect_name = phrase("TestMethods", "Mallows’ θ"),
                 .effect = "mallows.theta",
                 .estimate = "subj.mean",
                 .estimate_name = "mean proportion of correctly matched items",
                 .sources = {"Ernst 2004", "Fligner 1986"}},
      TestMethod{.p = "signflip.p.two",
                 .code = "sign_flip",
                 .sides = TestSides::two_sided,
                 .name = phrase("TestMethods", "sign-flip (randomisation) test"),
                 .unit = kUnitOfParticipants,
                 .symbol = "D",
                 .symbol_name = phrase("TestMethods", "difference in the number of choices"),
                 .statistic = "signflip.diff",
                 .draws = "signflip.draws",
                 .smallest = "signflip.smallest",
                 .differing = "signflip.n",
                 .effect_symbol = "d_z",
                 .effect_name = phrase("TestMethods", "Cohen’s d of paired differences"),
                 .effect = "signflip.d",
                 .sources = {"Ernst 2004", "Cohen 1988"},
                 .coverage = coverage_of_d()},
      TestMethod{.p = "stress.perm.p",
                 .code = "stress_permutation",
                 .sides = TestSides::undirected,
                 .name = phrase("TestMethods", "permutation test of the stress"),
                 .unit = kUnitOfParticipants,
                 .symbol = "stress-1",
                 .statistic = "stress.perm.observed",
                 .draws = "stress.perm.draws",
                 .smallest = "stress.perm.smallest",
                 .sources = {"Kruskal 1964", ""}},
      TestMethod{.p = "subj.t.p.two",
                 .code = "one_sample_t",
                 .sides = TestSides::two_sided,
                 .name = phrase("TestMethods", "one-sample t test"),
                 .unit = kUnitOfParticipants,
                 .symbol = "t",
                 .statistic = "subj.t",
                 .degrees = {"subj.t.df", ""},
                 .effect_symbol = "d",
                 .effect_name = phrase("TestMethods", "Cohen’s d"),
                 .effect = "subj.d",
                 .estimate = "subj.mean",
                 .estimate_name = "mean proportion correct",
                 .sources = {"", "Cohen 1988"}},
      TestMethod{.p = "t.p.two",
                 .code = "paired_t",
                 .sides = TestSides::two_sided,
                 .name = phrase("TestMethods", "paired t test"),
                 .unit = kUnitOfParticipants,
                 .symbol = "t",
                 .statistic = "t",
                 .degrees = {"df", ""},
                 .effect_symbol = "d_z",
                 .effect_name = phrase("TestMethods", "Cohen’s d of paired differences"),
                 .effect = "dz",
                 .sources = {"", "Cohen 1988"}},
      TestMethod{.p = "texture.relabel.p.greater",
                 .code = "picture_permutation",
                 .sides = TestSides::one_sided,
                 .name = permuted_pictures(),
                 .unit = kUnitOfParticipants,
                 .symbol = "k",
                 .symbol_name = number_correct(),
                 .statistic = "texture.hits",
                 .draws = "relabel.draws",
                 .smallest = "texture.relabel.smallest",
                 .effect_symbol = "h",
                 .effect_name = cohen_h_name(),
                 .effect = "texture.h",
                 .estimate = "texture.prop",
                 .estimate_name = "proportion of correct matches",
                 .sources = {"Ernst 2004", "Cohen 1988"}},
      TestMethod{.p = "values.log.perm.p.two",
                 .code = "group_permutation_log",
                 .sides = TestSides::two_sided,
                 .name = phrase("TestMethods", "permutation test of group labels of logarithms"),
                 .unit = kUnitOfParticipants,
                 .symbol = "ΔM",
                 .symbol_name = phrase("TestMethods", "difference of the mean logarithms"),
                 .statistic = "values.shift",
                 .draws = "values.perm.draws",
                 .smallest = "values.perm.smallest",
                 .effect_symbol = "g",
                 .effect_name = hedges_g_name(),
                 .effect = "values.hedges.g",
                 .sources = {"Ernst 2004", "Hedges 1981"}},
      TestMethod{.p = "values.perm.p.two",
                 .code = "group_permutation",
                 .sides = TestSides::two_sided,
                 .name = permuted_groups(),
                 .unit = kUnitOfParticipants,
                 .symbol = "ΔM",
                 .symbol_name = difference_of_means(),
                 .statistic = "values.shift",
                 .draws = "values.perm.draws",
                 .smallest = "values.perm.smallest",
                 .effect_symbol = "g",
                 .effect_name = hedges_g_name(),
                 .effect = "values.hedges.g",
                 .sources = {"Ernst 2004", "Hedges 1981"}},
      TestMethod{.p = "wilcoxon.exact.p.two",
                 .code = "wilcoxon",
                 .sides = TestSides::two_sided,
                 .name = phrase("TestMethods", "Wilcoxon signed-rank test"),
                 .unit = kUnitOfParticipants,
                 .symbol = "W⁺",
                 .symbol_name = phrase("TestMethods", "sum of the ranks of positive differences"),
                 .statistic = "wilcoxon.Wplus",
                 .smallest = "wilcoxon.exact.smallest",
                 .differing = "wilcoxon.n",
                 .effect_symbol = "r",
                 .effect_name = phrase("TestMethods", "rank-biserial correlation"),
                 .effect = "wilcoxon.rankbiserial",
                 .effect_is_bounded = true,
                 .direction_is_of_effect = true,
                 .sources = {"Wilcoxon 1945", ""}}};
  return kMethods;
}

const TestMethod* test_method(std::string_view p) {
  const auto methods = test_methods();
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [p](const TestMethod& each) { return each.p == p; });
  return found == methods.end() ? nullptr : &*found;
}

bool is_bounded_effect(std::string_view symbol) {
  const auto methods = test_methods();
  return std::any_of(methods.begin(), methods.end(), [symbol](const TestMethod& each) {
    return each.effect_is_bounded && each.effect_symbol == symbol;
  });
}

Phrase test_method_name(std::string_view code) {
  const TestMethod* const method = method_with_code(code);
  return method == nullptr ? Phrase{} : method->name;
}

std::string text_with_sides(const TestMethod& method) {
  std::string text = method.name.english();
  const std::string sides = text_of(method.sides);
  return text.ends_with(sides) ? text : text + ", " + sides;
}

std::string text_with_sides(std::string_view code) {
  const TestMethod* const method = method_with_code(code);
  return method == nullptr ? std::string(code) : text_with_sides(*method);
}

}  // namespace asperity
