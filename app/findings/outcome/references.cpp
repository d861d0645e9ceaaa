// A table in alphabetical order of key, short form and full reference.

#include "app/findings/outcome/references.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace asperity {

namespace {

constexpr std::array kReferences{
    Reference{"Anderson 2001", "Anderson, 2001",
              "Anderson, M. J. (2001). A new method for non-parametric multivariate analysis of "
              "variance. Austral Ecology, 26(1), 32–46."},
    Reference{"Bakeman 2005", "Bakeman, 2005",
              "Bakeman, R. (2005). Recommended effect size statistics for repeated measures "
              "designs. Behavior Research Methods, 37(3), 379–384."},
    Reference{"Carroll 1970", "Carroll & Chang, 1970",
              "Carroll, J. D., & Chang, J.-J. (1970). Analysis of individual differences in "
              "multidimensional scaling via an N-way generalization of “Eckart–Young” "
              "decomposition. Psychometrika, 35(3), 283–319."},
    Reference{"Chang 1969", "Chang & Carroll, 1969",
              "Chang, J.-J., & Carroll, J. D. (1969). How to use PROFIT, a computer program "
              "for property fitting by optimizing nonlinear or linear correlation. Bell "
              "Telephone Laboratories."},
    Reference{"Cohen 1988", "Cohen, 1988",
              "Cohen, J. (1988). Statistical power analysis for the behavioral sciences (2nd ed.). "
              "Lawrence Erlbaum."},
    Reference{"Dorfman 1969", "Dorfman & Alf, 1969",
              "Dorfman, D. D., & Alf, E. (1969). Maximum-likelihood estimation of parameters of "
              "signal-detection theory and determination of confidence intervals: Rating-method "
              "data. Journal of Mathematical Psychology, 6(3), 487–496."},
    Reference{"Efron 1982", "Efron, 1982",
              "Efron, B. (1982). The jackknife, the bootstrap and other resampling plans. SIAM."},
    Reference{"Ernst 2004", "Ernst, 2004",
              "Ernst, M. D. (2004). Permutation methods: A basis for exact inference. Statistical "
              "Science, 19(4), 676–685."},
    Reference{"Fligner 1986", "Fligner & Verducci, 1986",
              "Fligner, M. A., & Verducci, J. S. (1986). Distance based ranking models. Journal of "
              "the Royal Statistical Society: Series B, 48(3), 359–369."},
    Reference{"Friedman 1937", "Friedman, 1937",
              "Friedman, M. (1937). The use of ranks to avoid the assumption of normality implicit "
              "in the analysis of variance. Journal of the American Statistical Association, "
              "32(200), 675–701."},
    Reference{"Frijters 1979", "Frijters, 1979",
              "Frijters, J. E. R. (1979). Variations of the triangular method and the relationship "
              "of its unidimensional probabilistic models to three-alternative forced-choice "
              "signal detection theory models. British Journal of Mathematical and Statistical "
              "Psychology, 32(2), 229–241."},
    Reference{"Gower 1975", "Gower, 1975",
              "Gower, J. C. (1975). Generalized Procrustes analysis. Psychometrika, 40(1), "
              "33–51."},
    Reference{"Greenhouse 1959", "Greenhouse & Geisser, 1959",
              "Greenhouse, S. W., & Geisser, S. (1959). On methods in the analysis of profile "
              "data. Psychometrika, 24(2), 95–112."},
    Reference{"Hacker 1979", "Hacker & Ratcliff, 1979",
              "Hacker, M. J., & Ratcliff, R. (1979). A revised table of d′ for M-alternative "
              "forced choice. Perception & Psychophysics, 26(2), 168–170."},
    Reference{"Hautus 1995", "Hautus, 1995",
              "Hautus, M. J. (1995). Corrections for extreme proportions and their biasing effects "
              "on estimated values of d′. Behavior Research Methods, Instruments, & Computers, "
              "27(1), 46–51."},
    Reference{"Hedges 1981", "Hedges, 1981",
              "Hedges, L. V. (1981). Distribution theory for Glass’s estimator of effect size and "
              "related estimators. Journal of Educational Statistics, 6(2), 107–128."},
    Reference{"Hesterberg 2015", "Hesterberg, 2015",
              "Hesterberg, T. C. (2015). What teachers should know about the bootstrap: Resampling "
              "in the undergraduate statistics curriculum. The American Statistician, 69(4), "
              "371–386."},
    Reference{"Holm 1979", "Holm, 1979",
              "Holm, S. (1979). A simple sequentially rejective multiple test procedure. "
              "Scandinavian Journal of Statistics, 6(2), 65–70."},
    Reference{"Horn 1965", "Horn, 1965",
              "Horn, J. L. (1965). A rationale and test for the number of factors in factor "
              "analysis. Psychometrika, 30(2), 179–185."},
    Reference{"Kaernbach 1991", "Kaernbach, 1991",
              "Kaernbach, C. (1991). Simple adaptive testing with the weighted up-down method. "
              "Perception & Psychophysics, 49(3), 227–229."},
    Reference{"Kaernbach 2001", "Kaernbach, 2001",
              "Kaernbach, C. (2001). Adaptive threshold estimation with unforced-choice tasks. "
              "Perception & Psychophysics, 63(8), 1377–1388."},
    Reference{"Kendall 1939", "Kendall & Babington Smith, 1939",
              "Kendall, M. G., & Babington Smith, B. (1939). The problem of m rankings. The Annals "
              "of Mathematical Statistics, 10(3), 275–287."},
    Reference{"Kontsevich 1999", "Kontsevich & Tyler, 1999",
              "Kontsevich, L. L., & Tyler, C. W. (1999). Bayesian adaptive estimation of "
              "psychometric slope and threshold. Vision Research, 39(16), 2729–2737."},
    Reference{"Kruskal 1964", "Kruskal, 1964",
              "Kruskal, J. B. (1964). Multidimensional scaling by optimizing goodness of fit "
              "to a nonmetric hypothesis. Psychometrika, 29(1), 1–27."},
    Reference{"Laird 1982", "Laird & Ware, 1982",
              "Laird, N. M., & Ware, J. H. (1982). Random-effects models for longitudinal data. "
              "Biometrics, 38(4), 963–974."},
    Reference{"Levitt 1971", "Levitt, 1971",
              "Levitt, H. (1971). Transformed up-down methods in psychoacoustics. The Journal of "
              "the Acoustical Society of America, 49(2B), 467–477."},
    Reference{"Macmillan 2005", "Macmillan & Creelman, 2005",
              "Macmillan, N. A., & Creelman, C. D. (2005). Detection theory: A user’s guide (2nd "
              "ed.). Lawrence Erlbaum."},
    Reference{"McCullagh 1980", "McCullagh, 1980",
              "McCullagh, P. (1980). Regression models for ordinal data. Journal of the Royal "
              "Statistical Society: Series B, 42(2), 109–142."},
    Reference{"Miller 1955", "Miller, 1955",
              "Miller, G. A. (1955). Note on the bias of information estimates. In H. Quastler "
              "(Ed.), Information theory in psychology (pp. 95–100). Free Press."},
    Reference{
        "Prins 2013", "Prins, 2013",
        "Prins, N. (2013). The psi-marginal adaptive method: How to give nuisance parameters "
        "the attention they deserve (no more, no less). Journal of Vision, 13(7), Article 3."},
    Reference{"Satterthwaite 1946", "Satterthwaite, 1946",
              "Satterthwaite, F. E. (1946). An approximate distribution of estimates of variance "
              "components. Biometrics Bulletin, 2(6), 110–114."},
    Reference{"Shrout 1979", "Shrout & Fleiss, 1979",
              "Shrout, P. E., & Fleiss, J. L. (1979). Intraclass correlations: Uses in assessing "
              "rater reliability. Psychological Bulletin, 86(2), 420–428."},
    Reference{"Simpson 1973", "Simpson & Fitter, 1973",
              "Simpson, A. J., & Fitter, M. J. (1973). What is the best index of detectability? "
              "Psychological Bulletin, 80(6), 481–488."},
    Reference{"Watson 2017", "Watson, 2017",
              "Watson, A. B. (2017). QUEST+: A general multidimensional Bayesian adaptive "
              "psychometric method. Journal of Vision, 17(3), Article 10."},
    Reference{
        "Wilcoxon 1945", "Wilcoxon, 1945",
        "Wilcoxon, F. (1945). Individual comparisons by ranking methods. Biometrics Bulletin, "
        "1(6), 80–83."},
    Reference{"Williams 1949", "Williams, 1949",
              "Williams, E. J. (1949). Experimental designs balanced for the estimation of "
              "residual effects of treatments. Australian Journal of Scientific Research, Series "
              "A, 2(2), 149–168."}};

}  // namespace

std::span<const Reference> references() { return kReferences; }

const Reference& reference(std::string_view key) {
  const auto* const found = std::find_if(kReferences.begin(), kReferences.end(),
                                         [key](const Reference& each) { return each.key == key; });
  if (found == kReferences.end()) {
    throw std::out_of_range("there is no reference \"" + std::string(key) +
                            "\"; add it to kReferences");
  }
  return *found;
}

}  // namespace asperity
