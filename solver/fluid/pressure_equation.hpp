#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "solver/fluid/column_grid.hpp"

namespace slfb::fluid {

/// The pressure equation of a column, Σ_faces a_f (x − x_neighbour) = b, by conjugate gradients.
///
/// Its preconditioner is the same equation with each layer's mean of the coefficients. On a section extruded in equal
/// layers that is separable: with the eigenvectors of the section's Laplacian (areas as weights, found once), it falls
/// into one tridiagonal system per eigenvector and is solved exactly. What is left for the iterations is how the void
/// fraction varies within a layer, whatever the size of the grid. Single precision is enough for it and twice as fast;
/// the iterations themselves, and the residual that ends them, are in double precision.
class PressureEquation {
 public:
  /// `closed`: no outlet at the top; the pressure is then tied to 0 in cell 0, through which nothing must flow.
  PressureEquation(const ColumnGrid& grid, bool closed);

  /// Coefficients of the faces across x, y (face * layers + layer) and z (cell * (layers + 1) + face, from below; the
  /// highest is the outlet's). 0 where the velocity is given [m³/(Pa s)].
  std::array<std::vector<double>, 3> coefficient;

  struct Outcome {
    int iterations = 0;
    double relative_residual = 0.0;  ///< Euclidean norm over that of b
  };
  /// Solves for x, starting from 0, until the residual is `tolerance` of b or after `most` iterations.
  Outcome solve(const std::vector<double>& b, std::vector<double>& x, double tolerance, int most);

  /// b − A x as the last iteration left it.
  [[nodiscard]] const std::vector<double>& residual() const { return residual_; }

  /// A x.
  void multiply(const std::vector<double>& x, std::vector<double>& result) const;

 private:
  void update_diagonal();
  void update_preconditioner();
  /// `magnitude`: of the residual, which is taken out while numbers are short.
  void precondition(const std::vector<double>& residual, double magnitude, std::vector<double>& result);

  const ColumnGrid& grid_;
  bool closed_;
  std::vector<double> diagonal_;
  double lateral_sum_ = 0.0;                          ///< of face area over distance in a layer [m]
  std::vector<double> lateral_mean_, vertical_mean_;  ///< coefficient over that sum, and over the section's area
  Eigen::VectorXd eigenvalues_;
  Eigen::MatrixXf modes_;               ///< eigenvectors of the section, one per column
  Eigen::MatrixXf pivot_, multiplier_;  ///< of the tridiagonal systems, mode by layer
  Eigen::MatrixXf transformed_;         ///< mode by layer
  Eigen::MatrixXf scaled_;              ///< residual, then result: layer by cell
  std::vector<double> residual_, direction_, image_, preconditioned_;
};

}  // namespace slfb::fluid
