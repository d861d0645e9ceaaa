// The names of the quantities that are read from findings; the compiler checks them.

#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "analysis/numbers/finding.h"

namespace asperity {

/// Every quantity that an analysis, a sentence, a figure or a test reads under a fixed name, in alphabetical order. A test fails for
/// one that nothing writes (tests/scripts/quantity_names_test.py).
// clang-format off
inline constexpr auto kQuantities = std::to_array<std::string_view>({
    "F", "G", "G.df", "G.p", "G.perm.draws", "G.perm.p", "G.perm.smallest", "H.response", "H.stimulus", "IT.N.enough",
    "IT.from.pc", "IT.items", "IT.jackknife", "IT.miller1955", "IT.millermadow", "IT.plugin", "IT.relative",
    "agreement.mean", "agreement.r", "auc", "auc.lower", "auc.mean", "auc.se.delong", "auc.upper", "balanced.pc", "block",
    "bound.beta", "bt.ability", "bt.ability.sumzero.cluster", "bt.cluster.status", "bt.firth.ability", "bt.firth.status",
    "bt.order.status", "bt.se.cluster", "bt.se.sumzero.cluster", "bt.status", "bt.worth", "cell.ci.half.morey", "cell.mean",
    "cells.with.k", "cochran.Q", "cochran.n.complete", "cohen.d", "cohen.h", "configuration.level", "confusion", "correct",
    "cp.lower", "cp.upper", "cramer.w", "criterion.loglinear", "cronbach.alpha", "curve.descending", "curve.inverted_u",
    "curve.other", "cv.above", "cv.above.se", "cv.chosen", "cv.error", "deviance", "deviance.df", "deviance.p.chisq", "df",
    "df1", "df2", "diff", "dimensions", "dimensions.items", "dimensions.too.many", "dis.shepard", "disparity",
    "dissimilarity", "distance", "dprime", "dprime.corrected", "dprime.diff.loglinear", "dprime.io", "dprime.io.loglinear",
    "dprime.loglinear", "dprime.mean", "dprime.se", "dprime.with.guess", "dz", "eigenvalue", "eps.GG", "equivalence.margin",
    "equivalent", "ev.mu", "exact.midp.greater", "exact.p.greater", "exact.p.less", "exponent.df", "exponent.mean",
    "exponent.p", "exponent.subject", "exponent.t", "fa", "fisher.or.cond", "fisher.p.greater", "fisher.p.less",
    "fit.alpha", "fit.beta", "fit.design", "fit.detection.alpha", "fit.detection.beta", "fit.detection.criterion",
    "fit.gamma", "fit.lambda", "friedman.chisq", "friedman.df", "friedman.p", "geomean", "geomean.ci.lower.morey",
    "geomean.jnd", "geomean.jnd.dprime1", "geomean.jnd.posterior", "geomean.pse", "geomean.status", "geomean.weber", "ges",
    "glm.se.cluster", "glm.status", "glmm.beta", "glmm.p", "glmm.proportion", "glmm.sigma", "glmm.status", "glmm.t",
    "glmm.t.df", "glmm.t.p", "group.diff", "group.hedges.g", "group.mean", "group.perm.draws", "group.perm.p.two",
    "half.difference", "half.difference.status", "half.first", "half.ratio", "half.ratio.status", "half.second",
    "hclust.average.cophcor", "hclust.average.cophenetic", "hclust.average.first", "hclust.average.height",
    "hclust.average.second", "hclust.shepard.average.cophcor", "hclust.shepard.average.cophenetic",
    "hclust.shepard.average.first", "hclust.shepard.average.height", "hclust.shepard.average.second", "hedges.g", "hit",
    "hits", "icc", "icc.mean", "identical.difference", "identical.mean", "indscal.fit", "indscal.fit.mean",
    "indscal.weight", "intercept.mean", "invU.p", "invU.significant", "jnd", "jnd.dprime1", "jnd.posterior", "jzs.bf10",
    "k.diff.loglinear", "kappa", "kendall.W", "level", "lmm.F", "lmm.F.df1", "lmm.F.df2", "lmm.F.p", "lmm.beta", "lmm.df",
    "lmm.icc", "lmm.p", "lmm.ratio", "lmm.status", "lmm.t", "loading", "loading.corrected", "loglik", "logodds", "lr.chisq",
    "lr.equal.variance", "lr.equal.variance.p", "lr.p", "mallows.lr", "mallows.se", "mallows.theta", "mauchly.W",
    "mauchly.p.car", "mauchly.p.firstorder", "mds.shepard.dist2d", "mds.shepard.gof1", "mds.shepard.gof2", "mds.shepard.x",
    "mds.shepard.y", "mean", "mean.correct", "mean.jnd", "mean.jnd.dprime1", "mean.jnd.posterior", "mean.pse", "mean.rank",
    "mean.score", "mean.score.compared", "mean.weber", "mean.zeta", "measurements", "median", "mixed.lr.group.p",
    "mixed.sigma", "mixed.status", "model.equal.df", "model.equal.lr", "model.equal.p", "model.fit.below_five",
    "model.fit.df", "model.fit.is_chi_squared", "model.fit.lr", "model.fit.p", "model.fit.smallest_expected", "model.order",
    "model.order.df", "model.order.lr", "model.order.p", "model.tie", "multinom.exact.p", "n", "n.categories", "n.cells",
    "n.complete", "n.left_out", "n.missing", "n.noise", "n.reversals", "n.rows", "n.signal", "n.stages", "n.subjects",
    "n.targets", "n.trials", "n.trials.permutation", "n.untimed", "n.valid", "norm.estimate", "null.lower", "null.mean",
    "null.pmf", "null.sd", "null.upper", "odds_ratio", "order.difference", "orders.mean", "orders.r", "ordinal.collapsed",
    "ordinal.disparities", "p", "p.GG", "p.HF", "p.greater", "p.lower", "p.two", "pair.diff", "pairwise.binom.p.two",
    "parallel.limit", "pc", "pc.h", "pc.k", "pc.p.greater", "pc.se.cluster", "peak", "peak.fieller.lower",
    "peak.fieller.upper", "peak.height", "peak.status", "peakratio", "peakratio.df", "peakratio.p", "peakratio.t",
    "perfect.h", "perfect.p.greater", "perfect.relabel.p.greater", "perfect.relabel.smallest", "perfect.subj.mean",
    "perfect.trials", "perm.draws", "perm.p.two", "pes", "phat", "pl.cluster.status", "pl.loglik",
    "pl.logworth.sumzero.cluster", "pl.status", "pl.worth", "place.proportion", "pooled.deff", "pooled.k",
    "pooled.linear.r2", "pooled.n", "pooled.quad.r2", "pooled.se.cluster", "position", "power", "precision", "predictor",
    "profile.diff", "profile.incomplete", "profile.mean", "profile.perm.draws", "profile.perm.p", "profile.perm.smallest",
    "profile.r2", "prop", "prop.correct", "property.direction", "property.draws", "property.perm.p", "property.r2",
    "proportion", "proportion.corrected", "protest.p", "protest.r2", "pse", "quad.c.t", "quad.coef", "quartile.lower",
    "quartile.upper", "rate", "ratio.jnd", "ratio.jnd.dprime1", "recall", "region.angle", "region.major", "region.minor",
    "relabel.W", "relabel.X2", "relabel.draws", "relabel.exact.p", "relabel.exact.smallest", "relabel.null.lower",
    "relabel.null.upper", "relabel.p.greater", "relabel.smallest", "relabel.z", "replicates", "responses", "retained",
    "retest.mean", "retest.r", "reversal.trials", "roc.fa", "roc.hit", "scm.G2", "scm.X2", "scm.bias", "scm.confusions",
    "scm.eta", "scm.p", "scm.pairs", "scm.pairs.never", "scm.status", "scm.too.few", "score", "sd", "se", "se.beta",
    "signflip.d", "signflip.diff", "signflip.draws", "signflip.n", "signflip.p.two", "signflip.smallest", "slope",
    "slope.at.threshold", "slope.ratio", "slope.ratio.status", "standard", "status", "stress.ordinal", "stress.perm.draws",
    "stress.perm.mean", "stress.perm.observed", "stress.perm.p", "stress.perm.p05", "stress.perm.smallest", "stress.ratio",
    "subj.ci.lower", "subj.ci.upper", "subj.d", "subj.diff", "subj.maximum", "subj.mean", "subj.median", "subj.minimum",
    "subj.n", "subj.sd", "subj.t", "subj.t.df", "subj.t.p.two", "subject.block", "subject.geomean", "subject.mean",
    "subject.share", "subject.value", "subjects.dropped", "subjects.incomplete", "t", "t.p.two", "t1.prop", "texture.h",
    "texture.hits", "texture.p.greater", "texture.prop", "texture.relabel.p.greater", "texture.relabel.smallest",
    "threshold", "thurstone.firstchoice.mu", "tost.p", "tost.p.lower", "tost.p.upper", "total.correct", "total.items",
    "trend.t", "trials.with.k", "unfinished.tracks", "uv.az", "uv.az.mean", "uv.da", "uv.mu", "uv.sigma", "uv.sigma.se",
    "values.hedges.g", "values.log.perm.p.two", "values.mean", "values.missing", "values.perm.draws", "values.perm.p.two",
    "values.perm.smallest", "values.ratio", "values.shift", "values.welch.p.two", "weber", "welch.t", "wilcoxon.Wplus",
    "wilcoxon.exact.p.two", "wilcoxon.exact.smallest", "wilcoxon.n", "wilcoxon.rankbiserial", "wilson.lower",
    "wilson.upper", "without"});
// clang-format on
static_assert(std::is_sorted(kQuantities.begin(), kQuantities.end()));

void no_such_quantity();  ///< Not defined: the compiler names it in its error.

/// The name of a quantity that is read. A literal that is not one of kQuantities does not compile. It does not own its text.
class QuantityName final : public std::string_view {
 public:
  constexpr QuantityName() noexcept = default;  ///< of no finding
  consteval QuantityName(const char* name) : std::string_view(name) {
    if (!empty() && !std::binary_search(kQuantities.begin(), kQuantities.end(), *this)) {
      no_such_quantity();
    }
  }

  operator std::string() const { return {data(), size()}; }

  friend constexpr bool operator==(QuantityName a, QuantityName b) noexcept {
    return std::string_view(a) == std::string_view(b);
  }
  /// A name that is composed while the program runs: FACTOR.p.
  friend constexpr QuantityName composed_quantity(std::string_view name) noexcept;

 private:
  constexpr explicit QuantityName(std::string_view name) noexcept : std::string_view(name) {}
};

constexpr QuantityName composed_quantity(std::string_view name) noexcept {
  return QuantityName(name);
}

/// Whether a finding is of this quantity.
inline bool is(const Finding& finding, QuantityName quantity) {
  return finding.quantity == quantity;
}

}  // namespace asperity
