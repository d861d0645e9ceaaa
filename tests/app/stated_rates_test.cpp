// Every simulated rate that a text of the program states is that of docs/data/coverage.tsv, or of another simulation that the
// documents describe.

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "tests/app/drawn_rates.h"

namespace asperity {
namespace {

/// A text of a source file, in which literals are joined over the lines.
struct StatedRate {
  std::string file{};  ///< in app/
  std::string text{};
};

std::vector<StatedRate> rates_of_intervals() {
  const Counts psychometric_ends = drawn("psychometric", "threshold");
  const auto of_icc2 = [](const Choice& is_meant) {
    return drawn("ratings", "icc", [is_meant](const DrawnCount& count) {
      return count.key.starts_with("ICC2") && is_meant(count);
    });
  };
  const Counts three_raters = of_icc2([](const DrawnCount& count) { return count.trials == 3.0; });
  const Counts two_targets =
      of_icc2([](const DrawnCount& count) { return count.participants == 2.0; });
  const Counts other_targets = of_icc2(
      [](const DrawnCount& count) { return count.trials != 3.0 && count.participants != 2.0; });
  const Counts alike = both_of(drawn("continuous_scale", "lmm.beta"),
                               drawn("varying_items", "lmm.beta", with_spread(0.0)));
  const Counts varying = drawn("varying_items", "lmm.beta", where_participants_differ(true));
  const Counts changes = both_of(
      drawn("learning_correct", "half.difference"),
      both_of(drawn("learning_times", "half.ratio"), drawn("learning_times", "slope.ratio")));
  const Choice is_up_to_98_percent = [](const DrawnCount& count) {
    return count.truth.value() <= 0.98;
  };
  const Counts halves = both_of(drawn("learning_correct", "half.first", is_up_to_98_percent),
                                drawn("learning_correct", "half.second", is_up_to_98_percent));
  const Counts course = both_of(drawn("learning_times", "block"), halves);
  Counts shares = halves;
  for (const char* const part : {"recognition", "matching", "selection", "groups"}) {
    shares = both_of(shares, drawn(part, "subj.mean", is_up_to_98_percent));
  }
  const auto repeated = [](double from, double to) {
    return drawn("repetitions", "icc", [from, to](const DrawnCount& count) {
      return count.effect >= from && count.effect <= to;
    });
  };
  const Counts no_lapses = drawn("comparison_thresholds", "geomean.jnd", with_effect(0.0));
  const Counts lapses = drawn("comparison_thresholds", "geomean.jnd", with_effect(0.02));
  const auto unforced = [](const char* judgement) {
    return drawn("unforced_thresholds", "jnd", with_key(judgement));
  };
  const std::string tables_per_setting =
      whole(unforced("comparison").front().tables) + " tables per setting";
  const Counts few_unforced = drawn("unforced_thresholds", "jnd", [](const DrawnCount& count) {
    return count.key == "performance" && count.participants * count.trials == 36.0;
  });
  const auto effect_sizes = [](double from, double to) {
    return drawn("choice_effects", "signflip.d", [from, to](const DrawnCount& count) {
      return std::abs(count.truth.value()) >= from && std::abs(count.truth.value()) <= to;
    });
  };
  const auto crossed = [](const char* part, bool at_ceiling) {
    return drawn(part, "glmm.proportion", [at_ceiling](const DrawnCount& count) {
      return (count.truth.value() > 0.9) == at_ceiling;
    });
  };
  const std::string areas =
      span_of(drawn("areas_of_participants", "uv.az", where_participants_differ(true)));
  const std::string trapezoids =
      span_of(drawn("areas_of_participants", "auc", where_participants_differ(true)));
  return {
      {"findings/tidy/finding_list.cpp",
       coverage_of(shares) + ") + \" with mean proportions of at most 98 %"},
      {"findings/tidy/families/rmanova.cpp", coverage_of(drawn("effects", "pes"))},
      {"findings/tidy/families/rmanova.cpp", coverage_of(drawn("effects", "ges"))},
      {"findings/methods/discrimination/thresholds/choices_by_place.cpp",
       coverage_of(drawn("choices_by_place", "place.proportion"))},
      {"findings/tidy/families/components.cpp", coverage_of(drawn("components", "proportion.corrected"))},
      {"findings/tidy/families/components.cpp", coverage_of(drawn("components", "loading.corrected"))},
      {"findings/tidy/families/dprime.cpp", coverage_of(drawn("sensitivity", "dprime.mean"))},
      {"findings/methods/discrimination/thresholds/discrimination_results.cpp",
       coverage_of(drawn("compared_thresholds", "ratio.jnd"))},
      {"findings/tidy/families/group.cpp", coverage_of(drawn("groups", "subj.diff"))},
      {"findings/tidy/families/group_values.cpp", coverage_of(drawn("group_numbers", "values.ratio"))},
      {"findings/tidy/families/group_values.cpp", coverage_of(drawn("group_profiles", "profile.diff"))},
      {"findings/tidy/families/lmm.cpp", coverage_of(alike)},
      {"findings/tidy/families/lmm.cpp", "CoverageSpan" + limits(varying)},
      {"findings/tidy/families/paired.cpp", coverage_of_pooled("pairs", "bt.ability.sumzero")},
      {"findings/tidy/families/ranking.cpp", coverage_of_pooled("worths", "pl.logworth.sumzero")},
      {"findings/tidy/families/matching.cpp", coverage_of_pooled("matching", "perfect")},
      {"findings/tidy/families/recognition.cpp", coverage_of_pooled("recognition", "pc")},
      {"findings/tidy/families/recognition.cpp", coverage_of_pooled("recognition", "dprime")},
      {"findings/tidy/families/roc.cpp", coverage_of(drawn("ratings_of_signal", "auc"))},
      {"findings/tidy/families/roc.cpp", coverage_of_pooled("areas_of_participants", "auc")},
      {"findings/tidy/families/roc.cpp", coverage_of_pooled("areas_of_participants", "uv.az")},
      {"findings/tidy/families/roc.cpp", "\"mean of the participants' A_z\", CoverageSpan" +
                                    limits(drawn("areas_of_participants", "uv.az.mean"))},
      {"findings/tidy/families/roc.cpp", "\"mean of the participants' areas by trapezoids\", CoverageSpan" +
                                    limits(drawn("areas_of_participants", "auc.mean"))},
      {"findings/tidy/families/response_times.cpp", coverage_of(drawn("response_times", "geomean"))},
      {"findings/tidy/scale_findings.cpp", coverage_of(drawn("scores", "kendall.W"))},
      {"findings/tidy/families/selection.cpp", coverage_of(drawn("choice_effects", "relabel.W"))},
      {"findings/tidy/families/psyfit.cpp", coverage_of(psychometric_ends)},
      {"findings/tidy/families/psyfit.cpp", coverage_of(drawn("psychometric", "alpha.profile"))},
      {"findings/tidy/families/psyfit.cpp", coverage_of(drawn("psychometric", "threshold.overdispersed"))},
      {"findings/tidy/families/psyfit.cpp", coverage_of(drawn("bootstrapped", "bootstrap.threshold"))},
      {"findings/tidy/families/icc.cpp",
       "in simulations of normal ratings the coverage of the 95 % interval "
       "was " +
           span_of(other_targets) + ", with three raters " + span_of(three_raters) +
           ", with two targets " + span_of(two_targets)},
      {"findings/shared/crossed_textures.cpp",
       "In simulations with 5 to 20 participants and SDs of 0.5 and 1, the coverage of the 95 % CI "
       "was " +
           span_of(crossed("crossed_textures", false)) + " with four textures and " +
           span_of(crossed("crossed_ten_textures", false)) +
           " with ten for proportions of 25 to 80 %; for 95 %, where few studies have enough "
           "incorrect responses for an estimate, it was " +
           span_of(crossed("crossed_textures", true)) + " and " +
           span_of(crossed("crossed_ten_textures", true))},
      {"findings/shared/learning.cpp",
       "in simulations with 2 to 20 participants, its coverage was " + at_least(changes)},
      {"findings/shared/learning.cpp",
       "in simulations with 2 to 20 participants and proportions of 5 to 98 %, its coverage was " +
           at_least(course)},
      {"findings/shared/response_times.cpp",
       "in simulations with 2 to 20 participants, its coverage was " +
           at_least(drawn("response_times", "geomean"))},
      {"findings/shared/repetition_reliability.cpp",
       "In simulations of proportions of 2 to 20 participants, their coverage was " +
           at_least(repeated(0.25, 0.71)) + " with a mean of 25 to 71 %, and " +
           at_least(repeated(0.87, 0.95)) + " with a mean of 87 or 95 %"},
      {"findings/shared/repetition_reliability.cpp",
       "In simulations with 2 to 20 participants and seven surfaces, the coverage of the CI was " +
           at_least(drawn("repeated_estimates", "icc.mean"))},
      {"findings/outcome/test_methods.cpp",
       "in simulations, their coverage was " + at_least(effect_sizes(0.0, 0.8)) +
           " with a true d of at most 0.8, and " + at_least(effect_sizes(0.8, 1e9)) +
           " with a larger one"},
      {"findings/outcome/test_methods.cpp",
       "in simulations with 12 and 20 participants, their coverage was " +
           span_of(drawn("choice_effects", "relabel.W"))},
      {"findings/methods/rating/rating_components.cpp",
       "which contained the true first proportion in " +
           span_of(drawn("components", "proportion.corrected")) + " of simulations"},
      {"findings/methods/rating/rating_components.cpp",
       "in simulations that of the jackknife over participants contained the true loading in " +
           span_of(drawn("components", "loading.corrected")) + " of the studies"},
      {"findings/shared/exploration_model.cpp",
       "the CIs contained the true difference in " + span_of(varying) + " of the studies"},
      {"findings/methods/discrimination/thresholds/discrimination_results.cpp",
       coverage_of(no_lapses)},
      {"findings/methods/discrimination/thresholds/discrimination_results.cpp",
       "CoverageSpan" + limits(lapses)},
      {"findings/methods/discrimination/discrimination_tables.cpp",
       "in simulations of comparisons by participants who never lapse they contained the true JND "
       "in " +
           span_of(no_lapses) +
           " of the studies, in fewer of them the more participants and trials there were, and "
           "in " +
           span_of(lapses) + " with lapse rates of 2 %"},
      {"findings/methods/discrimination/discrimination_questions.cpp",
       "simulated JNDs were too small by 11 to 13 %, and the CI of the mean contained the true JND "
       "in " +
           span_of(no_lapses) + " of the studies (" + span_of(lapses) +
           " with lapse rates of 2 %)"},
      {"findings/methods/discrimination/threshold_sentences.cpp",
       "the CIs contained the true JND in " + span_of(no_lapses) + " of simulated studies"},
      {"findings/methods/discrimination/thresholds/discrimination_coverage.cpp",
       "In simulations of responses “cannot tell” (two alternatives, 36 to 144 trials at five "
       "levels, " +
           tables_per_setting +
           "), the 95 % CI of the JND of a judgement of performance "
           "contained the true JND in " +
           span_of(unforced("performance")) + " of the tables; with 36 trials it is too narrow (" +
           span_of(few_unforced) + ")"},
      {"findings/methods/discrimination/thresholds/discrimination_coverage.cpp",
       "In simulations of responses “cannot tell” (36 to 144 trials at five levels, " +
           tables_per_setting +
           "), the 95 % CI of the JND of a comparison contained the true JND in " +
           span_of(unforced("comparison")) + " of the tables that had one"},
      {"findings/methods/discrimination/sensitivity/confidence_roc.cpp",
       "in simulations the coverage for A_z was " +
           span_of(drawn("areas_of_participants", "uv.az.mean")) +
           " and for the area by trapezoids " +
           span_of(drawn("areas_of_participants", "auc.mean"))},
      {"findings/methods/discrimination/sensitivity/confidence_roc.cpp",
       "in simulations in which participants had different criteria, that of a bootstrap over "
       "participants contained the common A_z in " +
           areas + " of the studies"},
      {"findings/methods/discrimination/sensitivity/confidence_roc.cpp",
       "in simulations that of a bootstrap over participants contained the common A_z in " + areas +
           " of the studies, and DeLong’s the common area by trapezoids in " + trapezoids},
      {"findings/methods/discrimination/sensitivity/confidence_roc.cpp",
       "in simulations of one participant with 24 to 144 trials of either kind, its coverage was " +
           span_of(drawn("ratings_of_signal", "auc"))},
  };
}

std::vector<StatedRate> rates_of_tests() {
  const Counts groups_of_3 = drawn("groups", "mixed.lr.group.p", with_participants(6, 6));
  const Counts groups_of_6 = drawn("groups", "mixed.lr.group.p", with_participants(12, 12));
  const std::string varying = up_to(drawn("varying_items", "lmm.F.p", with_spread(0.5)));
  const std::string of_varying =
      varying.substr(0, varying.size() - 2) + " and " +
      greatest_size(drawn("varying_items", "lmm.F.p", with_spread(1.0))) + " %";
  const auto iman = [](double from, double to) {
    return up_to(drawn("scores", "iman.davenport.p", with_participants(from, to)));
  };
  const auto recognised = drawn("recognition", "G.p");
  return {
      {"findings/tidy/families/lmm.cpp",
       "in simulations in which neither levels nor participants differed the Type I error rate at "
       "α = .05 was " +
           up_to(drawn("continuous_scale", "lmm.F.p")) +
           ", and with effects that vary over participants (SDs of half and one residual SD) " +
           of_varying},
      {"findings/shared/exploration_model.cpp",
       "in simulations of ratings whose effects varied over participants (SDs of half and one "
       "residual SD) the F test had Type I error rates of " +
           of_varying},
      {"report/text/report_exploration.cpp",
       "Type I error rates of " + of_varying + " at α = .05 in simulations of ratings"},
      {"findings/tidy/families/rmanova.cpp",
       "in simulations of four levels and 3 to 12 participants the Type I error rate at α = .05 "
       "was " +
           least_size(drawn("varying_items", "p.GG")) + " to " +
           greatest_size(drawn("varying_items", "p.GG")) + " %"},
      {"findings/tidy/scale_findings.cpp",
       "in simulations without differences the Type I error rate at α = .05 was " + iman(12, 20) +
           " with 12 or 20 rows, and " + iman(2, 6) + " with 2 to 6"},
      {"findings/tidy/families/group.cpp",
       "in simulations of equal groups the Type I error rate at α = .05 was " + up_to(groups_of_3) +
           " with 3 participants in each group, and " + up_to(groups_of_6) + " with 6"},
      {"findings/tidy/families/icc.cpp",
       "in simulations of proportions without differences between participants the Type I error "
       "rate at α = .05 was " +
           up_to(drawn("repetitions", "icc.p"))},
      {"findings/tidy/families/recognition.cpp",
       "in simulations of 24 to 144 trials without transmitted information the Type I error rate "
       "at α = .05 was " +
           least_size(recognised) + " to " + greatest_size(recognised) + " %"},
      {"findings/tidy/families/selection.cpp",
       "in simulations without a preferred alternative the Type I error rate at α = .05 was " +
           up_to(drawn("selection", "subj.t.p.two", with_participants(12, 20))) +
           " with 12 or 20 participants who differ, and " +
           up_to(drawn("selection", "subj.t.p.two", with_participants(2, 6))) + " with 2 to 6"},
      {"findings/tidy/families/glmm.cpp",
       "in simulations with four items the Type I error rate at α = .05 was " +
           up_to(drawn("crossed_textures", "glmm.p"))},
      {"findings/tidy/families/glmm.cpp",
       "in simulations with covariates the Type I error rate at α = .05 was " +
           up_to(drawn("explored_choices", "glmm.lr.p", with_participants(5, 20))) + ", and " +
           up_to(drawn("explored_choices", "glmm.lr.p", with_participants(2, 4))) +
           " with fewer than five participants"},
      {"findings/tidy/families/psyfit.cpp",
       "in simulations of equal functions the Type I error rate at α = .05 was " +
           up_to(drawn("psychometric", "lr.same.function.p"))},
      {"findings/tidy/families/psyfit.cpp",
       "in simulations of the fitted function the Type I error rate at α = .05 was " +
           up_to(drawn("psychometric", "deviance.p.chisq"))},
      {"findings/tidy/families/ordinal.cpp",
       "in simulations without differences the Type I error rate at α = .05 was " +
           up_to(drawn("ordered_categories", "wald.p")) + "\""},
      {"findings/tidy/families/ordinal.cpp",
       "in simulations without differences the Type I error rate at α = .05 was " +
           up_to(drawn("ordered_categories", "lr.p", with_participants(3, 20))) + ", and " +
           greatest_size(drawn("ordered_categories", "lr.p", with_participants(2, 2))) +
           " % with 2 participants"},
  };
}

/// A rate of another simulation, and the words of docs/analysis.md that describe it.
struct OtherRate {
  StatedRate stated{};
  std::string documented{};
};

const std::vector<OtherRate>& rates_of_other_simulations() {
  static const std::vector<OtherRate> kRates{
      {{"findings/shared/anchors.cpp",
        "in simulations with 2 to 20 participants, its coverage was 94 to 100 %, and 92 to 100 % "
        "for ratings near an end of their scale"},
       "it contained the true change in 94 to 100 % of the studies that had one for ratings in the "
       "middle of the scale (from 5 participants in 94 to 96 %), and in 92 to 100 % for ratings "
       "near an end"},
      {{"findings/shared/anchors.cpp",
        "in simulations with 2 to 20 participants, the coverage of a t-based CI was 92 to 100 %"},
       "a t-based CI contained the true change in 92 to 100 % of the studies that had one"},
      {{"findings/outcome/study_findings.cpp",
        "In simulations with 2 to 20 participants, its coverage was at least 91 %"},
       "With SD 2 the smallest coverage was .91"},
      {{"findings/methods/rating/rating_constructs.cpp",
        "in simulations with 7 to 20 participants its coverage was 87 to 92 %"},
       "in simulations with 7 to 20 participants its coverage was 87 to 92 %"},
      {{"findings/methods/rating/rating_components.cpp",
        "A percentile bootstrap contained the true first proportion in 0 to 32 % of simulations"},
       "it contained the true first proportion in 0 to 32 % of simulations"},
      {{"findings/methods/rating/rating_models.cpp",
        "in simulations in which these varied with an SD of 0.5 its likelihood-ratio test had a "
        "Type I error rate of 21 %"},
       "the likelihood-ratio test of the cumulative link mixed model 3 and 21 % (SD 0 and 0.5)"},
      {{"findings/methods/discrimination/discrimination_tables.cpp",
        "in simulations in which 27 and 34 % of the thresholds were left out, the t-based CI of "
        "the others contained the true mean in 75 and 48 % of the studies"},
       "27 and 34 % of the thresholds were left out, the mean of the others was too high by "
       "factors of 1.17 and 1.26, and its CI contained the true mean in 75 and 48 % of the "
       "studies"},
      {{"findings/shared/equal_roughness.cpp",
        "such CIs contained the true mean in 48 to 75 % of simulated studies"},
       "the t-based CI of the mean of the others contained the true mean in 75 and 48 % of 200 "
       "simulated studies each"},
      // The numbers are those of docs/data/interval_coverage.tsv.
      {{"findings/methods/discrimination/thresholds/discrimination_coverage.cpp",
        "In simulations of this procedure (%1), the 95 % CI of the threshold contained the true "
        "threshold for: %2."},
       "a note states the coverage if it is outside 93 to 97 %"},
  };
  return kRates;
}

/// In one line, with the parts of a literal joined, and without lines of comments.
std::string joined_source(const std::filesystem::path& file) {
  std::istringstream lines(read_file(file));
  std::string joined{};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos || line.compare(begin, 2, "//") == 0) continue;
    if (joined.ends_with('"') && line[begin] == '"') {
      joined.pop_back();
      joined += line.substr(begin + 1);
    } else {
      joined += ' ' + line.substr(begin);
    }
  }
  return joined;
}

/// The sources of the texts of analyses and reports, by their paths in app/.
std::map<std::string, std::string> sources_of_texts() {
  std::map<std::string, std::string> sources{};
  const std::filesystem::path app = std::filesystem::path(ASPERITY_SOURCE_DIR) / "app";
  for (const char* const folder : {"findings", "report"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(app / folder)) {
      if (entry.path().extension() != ".cpp") continue;
      sources[entry.path().lexically_relative(app).generic_string()] = joined_source(entry.path());
    }
  }
  return sources;
}

/// Where a text states a simulated rate.
constexpr std::array kMarks{"imulations ",    "imulations.",          "imulated studies",
                            "simulated JNDs", "simulated_coverage({", "CoverageSpan{"};

TEST(StatedRates, AreThoseOfTheSimulationsAndHaveNoOthersNextToThem) {
  std::map<std::string, std::string> sources = sources_of_texts();
  const auto take_out = [&sources](const StatedRate& stated) {
    std::string& source = sources[stated.file];
    const std::size_t place = source.find(stated.text);
    ASSERT_NE(place, std::string::npos)
        << "app/" << stated.file << " does not state: " << stated.text;
    source.erase(place, stated.text.size());
  };
  for (const StatedRate& stated : rates_of_intervals()) take_out(stated);
  for (const StatedRate& stated : rates_of_tests()) take_out(stated);
  for (const OtherRate& other : rates_of_other_simulations()) take_out(other.stated);
  for (const auto& [file, source] : sources) {
    for (const char* const mark : kMarks) {
      const std::size_t place = source.find(mark);
      EXPECT_EQ(place, std::string::npos)
          << "app/" << file << " states a rate that this test does not know: "
          << (place == std::string::npos ? "" : source.substr(place, 120));
    }
  }
}

TEST(StatedRates, OfOtherSimulationsAreDocumented) {
  const std::string page = page_in_one_line();
  for (const OtherRate& other : rates_of_other_simulations()) {
    EXPECT_NE(page.find(other.documented), std::string::npos) << other.documented;
  }
}

}  // namespace
}  // namespace asperity
