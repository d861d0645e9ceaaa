// Recognition: identification of one of m stimuli, with confusions, sensitivity, information and
// similarity.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/choices/confusion.h"
#include "analysis/choices/equal_error_information.h"
#include "analysis/choices/forced_choice.h"
#include "analysis/choices/information_transfer.h"
#include "analysis/choices/similarity_choice.h"
#include "analysis/dissimilarity/dissimilarity.h"
#include "analysis/numbers/proportion.h"
#include "analysis/tests/effect_size.h"
#include "analysis/tests/pooled_share.h"
#include "analysis/tests/t_test.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

struct Trials {
  std::vector<std::string> labels{};
  ConfusionCounts counts{};
  std::vector<HitCount> participants{};
  std::vector<std::string> names{};                ///< of those participants
  std::vector<std::vector<LabelPair>> answered{};  ///< by participant
  std::size_t missing = 0;
};

Trials read_trials(const TidyInput& input) {
  Trials trials{.labels = input.options.texts("labels")};
  if (trials.labels.size() < 2) {
    throw std::runtime_error("the option \"labels\" must name at least two stimuli, not " +
                             std::to_string(trials.labels.size()) + "; add the others");
  }
  const TidyTable& table = input.table();
  const LabelColumn subjects = table.all_labels("subject");
  const LabelColumn stimuli = table.labels("stimulus", trials.labels);
  const LabelColumn responses = table.labels("response", trials.labels);
  std::vector<std::vector<LabelPair>> answered(subjects.names.size());
  std::vector<HitCount> participants(subjects.names.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (stimuli.codes[row] == LabelColumn::kMissing) {
      table.refuse(row, "stimulus", "the stimulus is missing; enter it, or remove the row");
    }
    if (responses.codes[row] == LabelColumn::kMissing) {
      ++trials.missing;
      continue;
    }
    answered[subjects.codes[row]].push_back(
        {.stimulus = stimuli.codes[row], .answer = responses.codes[row]});
    HitCount& participant = participants[subjects.codes[row]];
    ++participant.trials;
    participant.hits += stimuli.codes[row] == responses.codes[row] ? 1 : 0;
  }
  for (std::size_t person = 0; person < participants.size(); ++person) {
    if (participants[person].trials == 0) continue;
    trials.participants.push_back(participants[person]);
    trials.names.push_back(subjects.names[person]);
  }
  trials.counts = confusion_counts(std::span<const LabelPair>(), trials.labels.size());
  for (const std::vector<LabelPair>& own : answered) {
    trials.counts += confusion_counts(own, trials.labels.size());
  }
  trials.answered = std::move(answered);
  return trials;
}

/// Writes the findings of one table of trials.
class Recognition final {
 public:
  Recognition(const Trials& trials, double confidence)
      : trials_(trials), confidence_(confidence), right_(right_answers(trials.counts)) {}

  /// The proportions correct of the participants, and their test against the chance level.
  std::vector<Finding> findings_of_participants() {
    shares();
    participants();
    return list_.take();
  }

  std::vector<Finding> findings() {
    counts();
    shares();
    participants();
    labels();
    sensitivity();
    information();
    similarity();
    structure("shepard", shepard_dissimilarities(trials_.counts),
              "max(0, −ln η) of the counts plus ½");
    structure("linear", linear_dissimilarities(trials_.counts),
              "1 − (p_ij + p_ji)/2 of the counts plus ½");
    return list_.take();
  }

 private:
  Basis basis(std::string method) const {
    return {.n = trials_.participants.size(), .method = std::move(method)};
  }
  /// The basis of numbers that pool the answered trials.
  Basis of_trials(std::string method) const {
    return {.n = right_.trials, .method = std::move(method)};
  }
  void number(const char* quantity, const FindingKey& key, double value, std::string method) {
    list_.number(quantity, key, value, basis(std::move(method)));
  }
  double chance() const { return 1.0 / static_cast<double>(trials_.labels.size()); }
  const std::string& label(Eigen::Index i) const {
    return trials_.labels[static_cast<std::size_t>(i)];
  }
  FindingKey pair(Eigen::Index i, Eigen::Index j) const { return {label(i), label(j)}; }
  void of_pairs(const std::string& quantity, const Eigen::MatrixXd& matrix,
                const std::string& method) {
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      for (Eigen::Index j = i + 1; j < matrix.cols(); ++j) {
        number(quantity.c_str(), pair(i, j), matrix(i, j), method);
      }
    }
  }

  void counts() {
    list_.count("n.missing", "", trials_.missing, basis("trials without a response, left out"));
    for (Eigen::Index i = 0; i < trials_.counts.rows(); ++i) {
      for (Eigen::Index j = 0; j < trials_.counts.cols(); ++j) {
        number("confusion", pair(i, j), trials_.counts(i, j), "trials: stimulus|response");
      }
    }
    list_.count("n", "", right_.trials, basis("trials with a response"));
    list_.count("correct", "", right_.hits, basis("correct responses"));
  }

  void shares() {
    const ConfidenceInterval wilson = wilson_interval(right_, confidence_);
    const ConfidenceInterval exact = clopper_pearson_interval(right_, confidence_);
    Basis pooled =
        basis("proportion correct of all trials; Wilson interval, trials treated as independent" +
              simulated_coverage({90, 98}, {62, 97}));
    pooled.interval = wilson;
    pooled.confidence = confidence_;
    list_.number("pc", "", proportion(right_), pooled);
    number("pc.wilson.lower", "", wilson.low, "Wilson interval");
    number("pc.wilson.upper", "", wilson.high, "Wilson interval");
    number("pc.cp.lower", "", exact.low, "Clopper–Pearson interval");
    number("pc.cp.upper", "", exact.high, "Clopper–Pearson interval");
    list_.number("pc.p.greater", "", binomial_upper_tail(right_, chance()),
                 of_trials("exact binomial test, one-sided against the chance level 1/m, trials "
                           "treated as independent"));
    list_.count("pc.k", "", right_.hits, of_trials("correct responses"));
    add_cohen_h("pc.h", "", right_, {.chance = chance(), .confidence = confidence_}, list_);
  }

  void participants() {
    std::vector<double> shares{};
    for (std::size_t i = 0; i < trials_.participants.size(); ++i) {
      shares.push_back(proportion(trials_.participants[i]));
      list_.number("subject.share", trials_.names[i], shares.back(),
                   {.n = 1, .method = "proportion correct of a participant"});
    }
    const OneSampleT t = one_sample_t(shares, {.null_mean = chance(), .confidence = confidence_});
    add_mean_share("subj.mean", "", trials_.participants,
                   "mean of the participants' own proportions", {.confidence = confidence_}, list_);
    const auto of_spread = [this](const char* method) {
      Basis made = basis(method);
      made.undefined =
          "differences between participants cannot be estimated from one participant: add "
          "participants";
      return made;
    };
    list_.number("subj.sd", "", t.sd.value_or(kUndefined),
                 of_spread("SD of the participants' proportions"));
    add_spread("", shares, list_);
    if (t.test) {
      number("subj.t", "", t.test->t, "t over participants against the chance level 1/m");
      number("subj.t.df", "", t.test->df, "degrees of freedom of t");
      const double d = (t.mean - chance()) / *t.sd;
      Basis effect = basis(
          "Cohen's d of the participants' proportions against the chance level 1/m; interval from "
          "the noncentral t distribution");
      effect.interval = standardised_mean_interval(d, static_cast<double>(t.n), confidence_);
      effect.confidence = confidence_;
      list_.number("subj.d", "", d, effect);
      number("subj.t.p.two", "", t.test->p,
             "two-sided t test over participants against the chance level 1/m");
      number("subj.ci.lower", "", t.test->interval.low,
             "t interval over participants, not truncated");
      number("subj.ci.upper", "", t.test->interval.high,
             "t interval over participants, not truncated");
    } else if (t.n < 2) {
      list_.word("subj.t", "", "undefined_one_participant",
                 "differences between participants cannot be estimated from one participant: add "
                 "participants",
                 basis("t over participants"));
    } else {
      list_.word(
          "subj.t", "", "undefined_zero_variance",
          "all participants have the same proportion, so that t is undefined: add participants",
          basis("t over participants"));
    }
    list_.number("pc.se.cluster", "", pooled_share(trials_.participants).clustered_standard_error,
                 of_spread("standard error of the proportion correct, participants as clusters"));
  }

  void labels() {
    for (std::size_t i = 0; i < trials_.labels.size(); ++i) {
      const FindingKey& key = trials_.labels[i];
      const std::optional<HitCount> hits = recall(trials_.counts, i);
      if (!hits) {
        Basis never = basis("proportion correct of the trials with this stimulus");
        never.undefined = "this stimulus was never presented, so that no trial could be correct";
        list_.number("recall", key, kUndefined, never);
        continue;
      }
      const ConfidenceInterval wilson = wilson_interval(*hits, confidence_);
      Basis shown = basis("proportion correct of the trials with this stimulus; Wilson interval");
      shown.interval = wilson;
      shown.confidence = confidence_;
      list_.number("recall", key, proportion(*hits), shown);
      number("recall.wilson.lower", key, wilson.low, "Wilson interval");
      number("recall.wilson.upper", key, wilson.high, "Wilson interval");
      const std::optional<HitCount> precise = precision(trials_.counts, i);
      number("precision", key, precise ? proportion(*precise) : kUndefined,
             "proportion correct of the trials with this response");
    }
    number("kappa", "", kappa(trials_.counts).value_or(kUndefined), "Cohen's κ");
    number("balanced.pc", "", balanced_share(trials_.counts).value_or(kUndefined),
           "mean recall of the stimuli that were presented");
  }

  void sensitivity() {
    const ForcedChoice choice{.alternatives = trials_.labels.size()};
    const ConfidenceInterval wilson = wilson_interval(right_, confidence_);
    const ConfidenceInterval limits{.low = choice.dprime(wilson.low),
                                    .high = choice.dprime(wilson.high)};
    const double dprime = choice.dprime(proportion(right_));
    Basis estimate = of_trials(
        "d′ for m alternatives without response bias; interval from the Wilson limits of pc; n: "
        "number of responses" +
        simulated_coverage({77, 98}, {62, 97}));
    estimate.interval = limits;
    estimate.confidence = confidence_;
    list_.number("dprime", "", dprime, estimate);
    const auto n = static_cast<double>(right_.trials);
    if (right_.hits > 0 && right_.hits < right_.trials) {
      const double pc = proportion(right_);
      number("dprime.se", "", std::sqrt(pc * (1.0 - pc) / n) / choice.slope(dprime),
             "delta method, trials treated as independent");
    } else {
      const double end = 1.0 / (2.0 * n);
      number("dprime.corrected", "", choice.dprime(right_.hits == 0 ? end : 1.0 - end),
             "an extreme proportion replaced by 1/(2N) or 1 − 1/(2N)");
    }
    number("dprime.lower", "", limits.low, "d′ at the Wilson limit");
    number("dprime.upper", "", limits.high, "d′ at the Wilson limit");
  }

  void bits(const char* quantity, double value, std::string method) {
    Basis in_bits = of_trials(std::move(method));
    in_bits.unit = "bit";
    list_.number(quantity, "", value, in_bits);
  }

  void information() {
    const InformationTransfer it = information_transfer(trials_.counts);
    bits("H.stimulus", it.stimulus_bits, "entropy of the stimuli");
    bits("H.response", it.answer_bits, "entropy of the responses");
    bits("IT.plugin", it.plug_in_bits, "transmitted information, biased upwards in small samples");
    number("IT.relative", "", it.relative.value_or(kUndefined),
           "proportion of the entropy of the stimuli");
    number("IT.items", "", std::exp2(it.plug_in_bits),
           "discriminable items: 2 to the power of the transmitted information in bits");
    bits("IT.millermadow", it.miller_madow_bits, "Miller–Madow correction, occupied cells");
    bits("IT.miller1955", it.miller_bits, "minus (r−1)(c−1)/(2N ln 2)");
    bits("IT.jackknife", it.jackknife_bits.value_or(kUndefined), "jackknife over the trials");
    number("G", "", it.G, "likelihood-ratio statistic against independence");
    number("G.df", "", it.df, "degrees of freedom of G");
    list_.number(
        "G.p", "", it.p.value_or(kUndefined),
        of_trials("χ² test of G, trials treated as independent; liberal with few trials: in "
                  "simulations of 24 to 144 trials without transmitted information the Type I "
                  "error rate at α = .05 was 6 to 12 %"));
    permutations();
    bits("IT.from.pc", equal_error_bits(proportion(right_), trials_.labels.size()),
         "equal-error (Fano) estimate of the transmitted information");
    list_.truth("IT.N.enough", "", it.enough_trials,
                basis("whether there are at least 5m² trials"));
  }

  void permutations() {
    const auto test = information_test(trials_.answered, trials_.labels.size());
    const std::size_t drawn = test ? test->drawn : 0;
    Basis permuted =
        of_trials("permutation test of each participant's responses over the trials, " +
                  (test ? way_of_counting(drawn) : std::string("random")));
    permuted.undefined =
        "no participant has both two different stimuli and two different responses: add trials";
    list_.number("G.perm.p", "", test ? test->p : kUndefined, permuted);
    Basis smallest =
        of_trials("smallest attainable p: that of the largest G among the permutations");
    smallest.undefined = permuted.undefined;
    list_.number("G.perm.smallest", "", test ? test->smallest : kUndefined, smallest);
    list_.count("G.perm.draws", "", drawn,
                of_trials("permutations of the responses drawn at random"));
  }

  void similarity() {
    const SimilarityChoice model = similarity_choice(trials_.counts);
    number("scm.added", "", model.added, "added to every cell before the fit");
    number("scm.G2", "", model.G2, "deviance of Luce's similarity choice model");
    number("scm.X2", "", model.X2, "Pearson's X² of Luce's similarity choice model");
    number("scm.df", "", model.df, "(m−1)(m−2)/2");
    number("scm.p", "", model.p.value_or(kUndefined), "χ² test of the deviance");
    const PairConfusions pairs = pair_confusions(trials_.counts);
    list_.count("scm.confusions", "", pairs.confusions, of_trials("incorrect responses"));
    list_.count("scm.pairs", "", pairs.pairs, of_trials("pairs of stimuli"));
    list_.count("scm.pairs.never", "", pairs.never_confused,
                of_trials("pairs that were never confused: their dissimilarity is set by the ½ "
                          "added to every count"));
    list_.truth("scm.too.few", "", pairs.are_too_few(),
                of_trials("whether at least half of the pairs were never confused"));
    if (!model.parameters) {
      list_.word("scm.status", "", "boundary",
                 "the maximum-likelihood similarities are 0 or infinite: collect more responses",
                 basis("Luce's similarity choice model"));
      return;
    }
    of_pairs("scm.eta", model.parameters->similarity, "similarity, maximum likelihood");
    for (Eigen::Index i = 0; i < model.parameters->bias.size(); ++i) {
      number("scm.bias", label(i), model.parameters->bias(i), "response bias, sum 1");
    }
  }

  void structure(const std::string& name, const Dissimilarities& d, const std::string& method) {
    if (name == "shepard") {
      std::size_t clamped = 0;
      for (Eigen::Index i = 0; i < d.rows(); ++i) {
        for (Eigen::Index j = i + 1; j < d.cols(); ++j) clamped += d(i, j) == 0.0 ? 1 : 0;
      }
      list_.count("dis.shepard.clamped", "", clamped,
                  basis("pairs confused more often than recognised, set to 0"));
    }
    of_pairs("dis." + name, d, method);
    const ClassicalScaling map = classical_scaling(d);
    const std::string mds = "mds." + name;
    for (Eigen::Index i = 0; i < map.eigenvalues.size(); ++i) {
      number((mds + ".eig").c_str(), std::to_string(i + 1), map.eigenvalues(i),
             "eigenvalue of classical scaling");
    }
    number((mds + ".gof1").c_str(), "", map.fit_of_absolute.value_or(kUndefined),
           "first two eigenvalues as a proportion of the sum of |eigenvalues|");
    number((mds + ".gof2").c_str(), "", map.fit_of_positive.value_or(kUndefined),
           "first two eigenvalues as a proportion of the sum of positive eigenvalues");
    for (Eigen::Index i = 0; i < map.points.rows(); ++i) {
      number((mds + ".x").c_str(), label(i), map.points(i, 0),
             "first coordinate of the MDS configuration");
      number((mds + ".y").c_str(), label(i), map.points(i, 1),
             "second coordinate of the MDS configuration");
    }
    if (map.plane_is_unique) {
      Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(d.rows(), d.cols());
      for (Eigen::Index i = 0; i < d.rows(); ++i) {
        distances.col(i) = (map.points.rowwise() - map.points.row(i)).rowwise().norm();
      }
      of_pairs(mds + ".dist2d", distances, "distance in two dimensions");
    }
    tree(name, "average", agglomerate(d, Linkage::average));
    tree(name, "complete", agglomerate(d, Linkage::complete));
    tree(name, "single", agglomerate(d, Linkage::single));
  }

  void tree(const std::string& name, const std::string& linkage, const Tree& tree) {
    const std::string start = "hclust." + name + '.' + linkage;
    const std::string method = "clusters by " + linkage + " linkage";
    number((start + ".cophcor").c_str(), "", tree.cophenetic_correlation.value_or(kUndefined),
           method + ", correlation of cophenetic with original distances");
    for (std::size_t join = 0; join < tree.joins.size(); ++join) {
      number((start + ".height").c_str(), std::to_string(join + 1), tree.joins[join].height,
             method);
      list_.word(start + ".first", std::to_string(join + 1), trials_.labels[tree.joins[join].first],
                 "ok", basis(method + ", a member of the first cluster"));
      list_.word(start + ".second", std::to_string(join + 1),
                 trials_.labels[tree.joins[join].second], "ok",
                 basis(method + ", a member of the second cluster"));
    }
    of_pairs(start + ".cophenetic", tree.cophenetic, method);
  }

  const Trials& trials_;
  double confidence_ = 0.95;
  HitCount right_{};
  FindingList list_{};
};

}  // namespace

std::vector<Finding> recognition_findings(const TidyInput& input) {
  const std::string parts = input.options.text_or("parts", "all");
  if (parts != "all" && parts != "participants") {
    throw std::runtime_error(
        "the option \"parts\" is \"" + parts +
        "\"; it must be all or participants (the proportions correct of the participants alone)");
  }
  const Trials trials = read_trials(input);
  if (trials.counts.sum() == 0.0) {
    FindingList list{};
    list.count("n.missing", "", trials.missing);
    list.word("status", "", "no_data",
              "no trial has a response, so that nothing can be "
              "estimated: add responses");
    return list.take();
  }
  Recognition recognition(trials, input.options.confidence());
  return parts == "participants" ? recognition.findings_of_participants() : recognition.findings();
}

}  // namespace asperity
