#include "solver/fluid/pressure_equation.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace slfb::fluid {
namespace {

std::size_t at(int section, int layer, int layers) {
  return static_cast<std::size_t>(section) * static_cast<std::size_t>(layers) + static_cast<std::size_t>(layer);
}

std::size_t as_index(int value) { return static_cast<std::size_t>(value); }

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<Eigen::Index>(a.size());
  return Eigen::Map<const Eigen::VectorXd>(a.data(), n).dot(Eigen::Map<const Eigen::VectorXd>(b.data(), n));
}

}  // namespace

PressureEquation::PressureEquation(const ColumnGrid& grid, bool closed) : grid_(grid), closed_(closed) {
  const auto layers = static_cast<std::size_t>(grid.layers()), cells = static_cast<std::size_t>(grid.cells());
  for (std::size_t a : {std::size_t{0}, std::size_t{1}}) coefficient[a].assign(grid.faces(a).size() * layers, 0.0);
  coefficient[2].assign(cells * (layers + 1), 0.0);
  for (auto* field : {&diagonal_, &residual_, &direction_, &image_, &preconditioned_}) field->assign(grid.size(), 0.0);
  transformed_.resize(grid.cells(), grid.layers());
  scaled_.resize(grid.layers(), grid.cells());

  // Liquid without spheres: coefficients per area of the faces, of which only the section's Laplacian is needed.
  Eigen::MatrixXd section = Eigen::MatrixXd::Zero(grid.cells(), grid.cells());
  Eigen::VectorXd area(grid.cells());
  for (int c = 0; c < grid.cells(); ++c) area[c] = grid.area(c);
  for (std::size_t a : {std::size_t{0}, std::size_t{1}})
    for (const ColumnGrid::Face& face : grid.faces(a)) {
      const double g = face.length * grid.cell_height() / grid.spacing(a);
      section(face.first, face.first) += g;
      section(face.second, face.second) += g;
      section(face.first, face.second) -= g;
      section(face.second, face.first) -= g;
      lateral_sum_ += g;
    }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(section, area.asDiagonal().toDenseMatrix());
  modes_ = eigen.eigenvectors().cast<float>();
  eigenvalues_ = eigen.eigenvalues().cwiseMax(0.0);
  pivot_.resize(grid.cells(), grid.layers());
  multiplier_.resize(grid.cells(), grid.layers());
  lateral_mean_.resize(layers);
  vertical_mean_.resize(layers + 1);
}

void PressureEquation::update_diagonal() {
  const int layers = grid_.layers();
  for (int c = 0; c < grid_.cells(); ++c) {
    const double* vertical = &coefficient[2][at(c, 0, layers + 1)];
    double* diagonal = &diagonal_[at(c, 0, layers)];
    for (int k = 0; k < layers; ++k) diagonal[k] = vertical[k] + vertical[k + 1];
  }
  for (std::size_t a : {std::size_t{0}, std::size_t{1}})
    for (std::size_t f = 0; f < grid_.faces(a).size(); ++f) {
      const ColumnGrid::Face& face = grid_.faces(a)[f];
      const double* lateral = &coefficient[a][f * static_cast<std::size_t>(layers)];
      double *first = &diagonal_[at(face.first, 0, layers)], *second = &diagonal_[at(face.second, 0, layers)];
      for (int k = 0; k < layers; ++k) first[k] += lateral[k], second[k] += lateral[k];
    }
  // Without an outlet the pressure is free by a constant: tie it to 0 in one cell, through which nothing flows then.
  if (closed_) diagonal_[0] *= 2.0;
}

/// The layers' means of the coefficients, and the tridiagonal matrix of each mode factorised.
void PressureEquation::update_preconditioner() {
  const int layers = grid_.layers();
  std::fill(lateral_mean_.begin(), lateral_mean_.end(), 0.0);
  std::fill(vertical_mean_.begin(), vertical_mean_.end(), 0.0);
  for (std::size_t a : {std::size_t{0}, std::size_t{1}})
    for (std::size_t f = 0; f < grid_.faces(a).size(); ++f)
      for (int k = 0; k < layers; ++k)
        lateral_mean_[as_index(k)] += coefficient[a][at(static_cast<int>(f), k, layers)] / lateral_sum_;
  for (int c = 0; c < grid_.cells(); ++c)
    for (int k = 1; k <= layers; ++k)
      vertical_mean_[as_index(k)] += coefficient[2][at(c, k, layers + 1)] / grid_.section_area();
  Eigen::ArrayXd above = Eigen::ArrayXd::Zero(grid_.cells());
  for (int k = 0; k < layers; ++k) {
    const double below = vertical_mean_[as_index(k)], next = vertical_mean_[as_index(k) + 1];
    // The mean of a closed column is free; any stiffness that ties it will do.
    const double tie = closed_ && k == 0 ? next : 0.0;
    const Eigen::ArrayXd pivot =
        (lateral_mean_[as_index(k)] * eigenvalues_.array() + (below + next + tie) - above * below).inverse();
    above = next * pivot;
    pivot_.col(k) = pivot.cast<float>();
    multiplier_.col(k) = above.cast<float>();
  }
}

void PressureEquation::multiply(const std::vector<double>& x, std::vector<double>& result) const {
  const int layers = grid_.layers();
  for (int c = 0; c < grid_.cells(); ++c) {
    const double *in = &x[at(c, 0, layers)], *vertical = &coefficient[2][at(c, 0, layers + 1)],
                 *diagonal = &diagonal_[at(c, 0, layers)];
    double* out = &result[at(c, 0, layers)];
    for (int k = 0; k < layers; ++k) out[k] = diagonal[k] * in[k];
    for (int k = 1; k < layers; ++k) out[k] -= vertical[k] * in[k - 1];
    for (int k = 0; k + 1 < layers; ++k) out[k] -= vertical[k + 1] * in[k + 1];
  }
  for (std::size_t a : {std::size_t{0}, std::size_t{1}})
    for (std::size_t f = 0; f < grid_.faces(a).size(); ++f) {
      const ColumnGrid::Face& face = grid_.faces(a)[f];
      const double* lateral = &coefficient[a][f * static_cast<std::size_t>(layers)];
      const double *first = &x[at(face.first, 0, layers)], *second = &x[at(face.second, 0, layers)];
      double *to_first = &result[at(face.first, 0, layers)], *to_second = &result[at(face.second, 0, layers)];
      for (int k = 0; k < layers; ++k) {
        to_first[k] -= lateral[k] * second[k];
        to_second[k] -= lateral[k] * first[k];
      }
    }
}

void PressureEquation::precondition(const std::vector<double>& residual, double magnitude,
                                    std::vector<double>& result) {
  const Eigen::Index layers = grid_.layers(), cells = grid_.cells();
  scaled_ = (Eigen::Map<const Eigen::MatrixXd>(residual.data(), layers, cells) / magnitude).cast<float>();
  transformed_.noalias() = modes_.transpose() * scaled_.transpose();
  for (Eigen::Index k = 1; k < layers; ++k)
    transformed_.col(k).array() += multiplier_.col(k - 1).array() * transformed_.col(k - 1).array();
  transformed_.col(layers - 1).array() *= pivot_.col(layers - 1).array();
  for (Eigen::Index k = layers - 1; k-- > 0;)
    transformed_.col(k).array() = pivot_.col(k).array() * transformed_.col(k).array() +
                                  multiplier_.col(k).array() * transformed_.col(k + 1).array();
  scaled_.noalias() = transformed_.transpose() * modes_.transpose();
  Eigen::Map<Eigen::MatrixXd>(result.data(), layers, cells) = magnitude * scaled_.cast<double>();
}

PressureEquation::Outcome PressureEquation::solve(const std::vector<double>& b, std::vector<double>& x,
                                                  double tolerance, int most) {
  update_diagonal();
  update_preconditioner();
  const std::size_t n = b.size();
  std::fill(x.begin(), x.end(), 0.0);
  residual_ = b;
  double squared = dot(b, b), previous = 0.0;
  const double wanted = tolerance * tolerance * squared, norm_b = std::sqrt(squared);
  Outcome outcome;
  while (squared > wanted && outcome.iterations < most) {
    precondition(residual_, std::sqrt(squared), preconditioned_);
    const double product = dot(residual_, preconditioned_);
    const double keep = outcome.iterations == 0 ? 0.0 : product / previous;
    for (std::size_t i = 0; i < n; ++i) direction_[i] = preconditioned_[i] + keep * direction_[i];
    previous = product;
    multiply(direction_, image_);
    const double length = product / dot(direction_, image_);
    for (std::size_t i = 0; i < n; ++i) {
      x[i] += length * direction_[i];
      residual_[i] -= length * image_[i];
    }
    squared = dot(residual_, residual_);
    ++outcome.iterations;
  }
  outcome.relative_residual = norm_b > 0.0 ? std::sqrt(squared) / norm_b : 0.0;
  return outcome;
}

}  // namespace slfb::fluid
