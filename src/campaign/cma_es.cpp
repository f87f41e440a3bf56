// SPDX-License-Identifier: MIT
#include "campaign/cma_es.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/assert.hpp"
#include "core/draw.hpp"
#include "core/math.hpp"

namespace eyrie::campaign {
namespace {

double norm_squared(std::span<const double> x) {
  return std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
}

/// What a lower triangle makes of a point.
CmaEs::Point times(const std::vector<CmaEs::Point>& lower, std::span<const double> z) {
  CmaEs::Point y(z.size());
  for (std::size_t i = 0; i < z.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      y[i] += lower[i][j] * z[j];
  return y;
}

/// The lower triangle whose product with its transpose a matrix is.
void take_apart(const std::vector<CmaEs::Point>& matrix, std::vector<CmaEs::Point>& lower) {
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k)
        rest -= lower[i][k] * lower[j][k];
      lower[i][j] = i == j ? std::sqrt(std::max(rest, 1e-300)) : rest / lower[j][j];
    }
}

}  // namespace

CmaEs::CmaEs(Point start, double sigma, std::uint64_t seed, std::size_t population,
             double most_sigma)
    : n_(start.size()),
      seed_(seed),
      sigma_(sigma),
      most_sigma_(most_sigma),
      mean_(std::move(start)),
      path_(n_),
      sigma_path_(n_),
      covariance_(n_, Point(n_)) {
  EYRIE_DEMAND(n_ > 0 && (population == 0 || population >= 4), "nothing to search, or by too few");
  if (population == 0)
    population = 4 + static_cast<std::size_t>(3 * math::log(static_cast<double>(n_)));
  for (std::size_t i = 0; i < n_; ++i)
    covariance_[i][i] = 1;
  root_ = covariance_;
  // equations 49 to 53
  for (std::size_t i = 0; i < population / 2; ++i)
    weights_.push_back(math::log(0.5 * (static_cast<double>(population) + 1)) -
                       math::log(static_cast<double>(i + 1)));
  const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  for (double& w : weights_)
    w /= sum;
  selected_ = 1 / norm_squared(weights_);
  normals_.resize(population);
  points_.resize(population);
  draw();
}

void CmaEs::draw() {
  for (std::size_t p = 0; p < points_.size(); ++p) {
    Draw draw(seed_, PlayerId{static_cast<std::uint32_t>(p + 1)}, Stream::search, generation_);
    normals_[p].resize(n_);
    for (double& z : normals_[p])
      z = draw.normal();
    points_[p] = times(root_, normals_[p]);
    for (std::size_t i = 0; i < n_; ++i)
      points_[p][i] = mean_[i] + sigma_ * points_[p][i];
  }
}

void CmaEs::tell(std::span<const double> losses) {
  EYRIE_DEMAND(losses.size() == points_.size(), "a loss for each point");
  std::vector<std::size_t> order(points_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return losses[i]; });

  // selection and recombination: the mean goes where the better half is
  Point z(n_);
  for (std::size_t r = 0; r < weights_.size(); ++r)
    for (std::size_t i = 0; i < n_; ++i)
      z[i] += weights_[r] * normals_[order[r]][i];
  const Point y = times(root_, z);
  for (std::size_t i = 0; i < n_; ++i)
    mean_[i] += sigma_ * y[i];

  // the tutorial's table 1
  const auto n = static_cast<double>(n_);
  const double c_sigma = (selected_ + 2) / (n + selected_ + 5);
  const double damping = 1 + 2 * std::max(0.0, std::sqrt((selected_ - 1) / (n + 1)) - 1) + c_sigma;
  const double c_path = (4 + selected_ / n) / (n + 4 + 2 * selected_ / n);
  const double c_one = 2 / ((n + 1.3) * (n + 1.3) + selected_);
  const double c_mu =
      std::min(1 - c_one, 2 * (selected_ - 2 + 1 / selected_) / ((n + 2) * (n + 2) + selected_));
  const double expected = std::sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));

  // step-size control: longer steps while they go one way
  for (std::size_t i = 0; i < n_; ++i)
    sigma_path_[i] =
        (1 - c_sigma) * sigma_path_[i] + std::sqrt(c_sigma * (2 - c_sigma) * selected_) * z[i];
  const double length = std::sqrt(norm_squared(sigma_path_));
  sigma_ = std::min(most_sigma_, sigma_ * math::exp(c_sigma / damping * (length / expected - 1)));

  // covariance matrix adaptation: the shape follows the steps that were taken
  const double begun = 1 - math::pow(1 - c_sigma, 2 * static_cast<double>(generation_ + 1));
  const bool is_stalled = length / std::sqrt(begun) >= (1.4 + 2 / (n + 1)) * expected;
  for (std::size_t i = 0; i < n_; ++i)
    path_[i] = (1 - c_path) * path_[i] +
               (is_stalled ? 0 : std::sqrt(c_path * (2 - c_path) * selected_) * y[i]);
  const double lost = is_stalled ? c_one * c_path * (2 - c_path) : 0;
  std::vector<Point> steps;
  for (std::size_t r = 0; r < weights_.size(); ++r)
    steps.push_back(times(root_, normals_[order[r]]));
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t j = 0; j < n_; ++j) {
      double taken = 0;
      for (std::size_t r = 0; r < steps.size(); ++r)
        taken += weights_[r] * steps[r][i] * steps[r][j];
      covariance_[i][j] = (1 + lost - c_one - c_mu) * covariance_[i][j] +
                          c_one * path_[i] * path_[j] + c_mu * taken;
    }
  take_apart(covariance_, root_);
  ++generation_;
  draw();
}

}  // namespace eyrie::campaign
