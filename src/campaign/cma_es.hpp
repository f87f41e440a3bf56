// SPDX-License-Identifier: MIT
#pragma once
/// \file  Searches for the least value of a function of which nothing is known but its values, and
/// these only in their order: CMA-ES, the evolution strategy with covariance matrix adaptation.
#include <cstdint>
#include <span>
#include <vector>

namespace eyrie::campaign {

/// N. Hansen, The CMA Evolution Strategy: A Tutorial (arXiv:1604.00772), with its default strategy
/// parameters and without active update; the covariance matrix is taken apart by Cholesky, as in
/// Krause, Arbones & Igel, CMA-ES with Optimal Covariance Update and Storage Complexity (NIPS
/// 2016). The same seed and the same order of losses give the same bits.
class CmaEs {
 public:
  using Point = std::vector<double>;

  /// Begins at `start` with the standard deviation `sigma` in every direction. `population` points
  /// a generation, at least 4; 0: as many as the tutorial says, 4 + 3 ln(dimensions). Where noise
  /// is all that is left sigma grows without end, but not beyond `most_sigma`.
  CmaEs(Point start, double sigma, std::uint64_t seed, std::size_t population = 0,
        double most_sigma = 1e300);

  /// The points of this generation.
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  /// What they cost, in their order; less is better. Then the next generation begins.
  void tell(std::span<const double> losses);

  [[nodiscard]] std::uint64_t generation() const { return generation_; }  ///< from 0
  /// The center from which the points are drawn: the best guess where losses have noise.
  [[nodiscard]] const Point& mean() const { return mean_; }
  [[nodiscard]] double sigma() const { return sigma_; }

 private:
  void draw();

  std::size_t n_;
  std::uint64_t seed_, generation_ = 0;
  double sigma_, most_sigma_;
  Point mean_, path_, sigma_path_;
  std::vector<Point> covariance_, root_;  ///< root_: lower triangle, root_ root_^T = covariance_
  std::vector<double> weights_;           ///< of the better half, the best first
  double selected_;                       ///< effective number of them, mu_eff
  std::vector<Point> normals_, points_;
};

}  // namespace eyrie::campaign
