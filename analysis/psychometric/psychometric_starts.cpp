// Evaluates a grid of α, ln β, γ and λ, kept while the levels are the same, and returns the best distinct points.

#include "analysis/psychometric/psychometric_starts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>

namespace asperity {
namespace {

constexpr int kGridPositions = 41;
constexpr std::array kBelowSteepest{0.0, 0.15, 0.4, 0.7, 1.0, 1.4, 1.8,
                                    2.2, 2.6,  3.0, 3.5, 4.0, 5.0};  // of ln β

struct Rates {
  std::vector<double> gammas{};
  std::vector<double> lambdas{};
};

Rates rates_of(const PsychometricModel& model) {
  return {.gammas =
              model.gamma ? std::vector<double>{*model.gamma} : std::vector<double>{0.01, 0.1, 0.3},
          .lambdas = model.lambda ? std::vector<double>{*model.lambda}
                                  : std::vector<double>{0.05 * model.greatest_lambda,
                                                        0.6 * model.greatest_lambda}};
}

double range_of(const PsychometricLikelihood& data) {
  return data.levels().back() - data.levels().front();
}

std::vector<double> key_of(const PsychometricLikelihood& data) {
  const Rates rates = rates_of(data.model());
  std::vector<double> key{static_cast<double>(data.model().shape), data.bounds().low(1),
                          data.bounds().high(1), static_cast<double>(rates.gammas.size())};
  key.insert(key.end(), rates.gammas.begin(), rates.gammas.end());
  key.insert(key.end(), rates.lambdas.begin(), rates.lambdas.end());
  for (const PsychometricBlock& block : data.blocks()) key.push_back(block.x);
  return key;
}

}  // namespace

void PsychometricStarts::make_grid(const PsychometricLikelihood& data) {
  const Rates rates = rates_of(data.model());
  const CurveBounds& bounds = data.bounds();
  points_.clear();
  of_blocks_.clear();
  for (int i = 0; i < kGridPositions; ++i) {
    const double place = data.levels().front() + range_of(data) * i / (kGridPositions - 1);
    const double alpha = is_weibull(data.model().shape) ? std::exp(place) : place;
    for (const double less : kBelowSteepest) {
      for (const double gamma : rates.gammas) {
        for (const double lambda : rates.lambdas) {
          const double log_beta = std::max(bounds.low(1), bounds.high(1) - less);
          points_.push_back(
              {.at = CurveParameters(alpha, log_beta, gamma, lambda), .place = place});
          const std::vector<LogProbabilities> of_blocks = data.log_probabilities(points_.back().at);
          of_blocks_.insert(of_blocks_.end(), of_blocks.begin(), of_blocks.end());
        }
      }
    }
  }
}

std::vector<CurveParameters> PsychometricStarts::best(const PsychometricLikelihood& data) {
  constexpr std::size_t kMost = 6;
  if (std::vector<double> key = key_of(data); key != key_) {
    make_grid(data);
    key_ = std::move(key);
  }
  const std::span<const LogProbabilities> all(of_blocks_);
  const std::size_t blocks = data.blocks().size();
  std::vector<double> values{};
  for (std::size_t i = 0; i < points_.size(); ++i) {
    values.push_back(data.value(all.subspan(i * blocks, blocks)));
  }
  std::vector<std::size_t> order(points_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&values](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  std::vector<const Point*> kept{};
  for (const std::size_t i : order) {
    const Point& point = points_[i];
    const bool is_new = std::all_of(kept.begin(), kept.end(), [&](const Point* other) {
      return std::abs(point.place - other->place) > 3.0 * range_of(data) / kGridPositions ||
             std::abs(point.at(1) - other->at(1)) > 0.8;
    });
    if (is_new) kept.push_back(&point);
    if (kept.size() == kMost) break;
  }
  std::vector<CurveParameters> starts{};
  for (const Point* point : kept) starts.push_back(point->at);
  return starts;
}

}  // namespace asperity
