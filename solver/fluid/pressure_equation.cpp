#include "solver/fluid/pressure_equation.hpp"

#include <omp.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <span>

#include "solver/fluid/momentum_nodes.hpp"

namespace slfb::fluid {
namespace {

/// Lowest and highest layer of each half of a column whose halves meet in `middle`, which is in neither: a walk from
/// the end to the middle.
struct Walk {
  int from, step, count;
};

Walk walk_to_middle(int half, int middle, int layers) {
  return half == 0 ? Walk{0, 1, middle} : Walk{layers - 1, -1, layers - 1 - middle};
}

}  // namespace

PressureEquation::PressureEquation(const ColumnGrid& grid, bool closed, int threads)
    : grid_(grid), closed_(closed), threads_(threads), links_(as_index(grid.cells())) {
  const auto layers = as_index(grid.layers()), cells = as_index(grid.cells());
  const int padded = (grid.cells() + width - 1) / width * width;
  for (std::size_t a : {std::size_t{0}, std::size_t{1}}) {
    coefficient[a].assign(grid.faces(a).size() * layers, 0.0);
    for (std::size_t f = 0; f < grid.faces(a).size(); ++f) {
      const ColumnGrid::Face& face = grid.faces(a)[f];
      links_[as_index(face.first)].push_back({a, f * layers, face.second});
      links_[as_index(face.second)].push_back({a, f * layers, face.first});
    }
  }
  coefficient[2].assign(cells * (layers + 1), 0.0);
  for (int p = 0; p < parts; ++p) {
    Part& part = parts_[as_index(p)];
    const auto start = [&](int q) { return q == parts ? grid.layers() : grid.layers() * q / parts / width * width; };
    part.first = start(p);
    part.count = start(p + 1) - part.first;
    for (auto* field : {&part.diagonal, &part.residual, &part.direction, &part.image, &part.preconditioned})
      field->setZero(part.count, grid.cells());
    part.scaled.setZero(part.count, padded);
  }

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
  modes_.setZero(padded, padded);
  modes_.topLeftCorner(grid.cells(), grid.cells()) = eigen.eigenvectors().cast<float>();
  eigenvalues_.setOnes(padded);
  eigenvalues_.head(grid.cells()) = eigen.eigenvalues().cwiseMax(0.0).array();
  for (auto* field : {&transformed_, &pivot_, &multiplier_}) field->setZero(padded, grid.layers());
  lateral_mean_.resize(layers);
  vertical_mean_.resize(layers + 1);
  for (auto& eliminated : eliminated_) eliminated.setZero(padded);
  for (auto& beyond : beyond_) beyond.setZero(padded);
}

void PressureEquation::update_diagonal(Part& part) {
  const int layers = grid_.layers();
  for (int c = 0; c < grid_.cells(); ++c) {
    const double* in_column = &coefficient[2][index_of(c, part.first, layers + 1)];
    const Eigen::Map<const Eigen::ArrayXd> below(in_column, part.count), above(in_column + 1, part.count);
    part.diagonal.col(c) = below + above;
    for (const Link& link : links_[as_index(c)])
      part.diagonal.col(c) +=
          Eigen::Map<const Eigen::ArrayXd>(&coefficient[link.axis][link.start] + part.first, part.count);
  }
  // Without an outlet the pressure is free by a constant: tie it to 0 in one cell, through which nothing flows then.
  if (closed_ && part.first == 0 && part.count > 0) part.diagonal(0, 0) *= 2.0;
}

/// The layers' means of the coefficients, and the tridiagonal matrix of each mode factorised from both ends.
void PressureEquation::update_preconditioner(const ThreadPartition& own) {
  const int layers = grid_.layers();
  double *lateral_mean = lateral_mean_.data(), *vertical_mean = vertical_mean_.data();
  const int first = parts_[as_index(own.first)].first,
            last = parts_[as_index(own.last - 1)].first + parts_[as_index(own.last - 1)].count;
  std::fill(lateral_mean + first, lateral_mean + last, 0.0);
  std::fill(vertical_mean + first + 1, vertical_mean + last + 1, 0.0);
  for (std::size_t a : {std::size_t{0}, std::size_t{1}})
    for (std::size_t f = 0; f < grid_.faces(a).size(); ++f) {
      const double *lateral = &coefficient[a][f * as_index(layers)], share = 1.0 / lateral_sum_;
#pragma omp simd
      for (int k = first; k < last; ++k) lateral_mean[k] += share * lateral[k];
    }
  for (int c = 0; c < grid_.cells(); ++c) {
    const double *in_column = &coefficient[2][index_of(c, 0, layers + 1)], share = 1.0 / grid_.section_area();
#pragma omp simd
    for (int k = first + 1; k <= last; ++k) vertical_mean[k] += share * in_column[k];
  }
#pragma omp barrier
  // The mean of a closed column is free; any stiffness that ties it will do.
  const auto diagonal = [&](int k) {
    const double below = k > 0 ? vertical_mean[k] : 0.0, above = vertical_mean[k + 1];
    return lateral_mean[k] * eigenvalues_ + (below + above + (closed_ && k == 0 ? above : 0.0));
  };
  for (int half = 0; half < 2; ++half) {
    if (!is_owner(own, half)) continue;
    Eigen::ArrayXd& eliminated = eliminated_[as_index(half)];
    eliminated.setZero();
    const Walk walk = walk_to_middle(half, middle(), layers);
    for (int n = 0, k = walk.from; n < walk.count; ++n, k += walk.step) {
      const double inwards = vertical_mean[half == 0 ? k + 1 : k];
      pivot_.col(k) = (diagonal(k) - eliminated).inverse().cast<float>();
      eliminated = inwards / (diagonal(k) - eliminated);
      multiplier_.col(k) = eliminated.cast<float>();
      eliminated *= inwards;
    }
  }
#pragma omp barrier
  if (is_owner(own, 1))
    pivot_.col(middle()) = (diagonal(middle()) - eliminated_[0] - eliminated_[1]).inverse().cast<float>();
}

const PressureEquation::Part& PressureEquation::part_of(int layer) const {
  const auto found = std::find_if(parts_.begin(), parts_.end(), [layer](const Part& part) {
    return layer >= part.first && layer < part.first + part.count;
  });
  return found == parts_.end() ? parts_.front() : *found;
}

void PressureEquation::multiply(Part& part) {
  const int layers = grid_.layers(), count = part.count;
  if (count == 0) return;
  const Part &below = part_of(part.first - 1), &above = part_of(part.first + count);
  for (int c = 0; c < grid_.cells(); ++c) {
    const double* in_column = &coefficient[2][index_of(c, part.first, layers + 1)];
    const double *in = &part.direction(0, c), *diagonal = &part.diagonal(0, c);
    double* out = &part.image(0, c);
#pragma omp simd
    for (int k = 0; k < count; ++k) out[k] = diagonal[k] * in[k];
#pragma omp simd
    for (int k = 1; k < count; ++k) out[k] -= in_column[k] * in[k - 1];
#pragma omp simd
    for (int k = 0; k < count - 1; ++k) out[k] -= in_column[k + 1] * in[k + 1];
    if (part.first > 0) out[0] -= in_column[0] * below.direction(below.count - 1, c);
    if (part.first + count < layers) out[count - 1] -= in_column[count] * above.direction(0, c);
    for (const Link& link : links_[as_index(c)]) {
      const double* lateral = &coefficient[link.axis][link.start] + part.first;
      const double* there = &part.direction(0, link.neighbour);
#pragma omp simd
      for (int k = 0; k < count; ++k) out[k] -= lateral[k] * there[k];
    }
  }
  part.product = (part.direction * part.image).sum();
}

void PressureEquation::precondition(const ThreadPartition& own, double magnitude) {
  const int layers = grid_.layers();
  for (int p = own.first; p < own.last; ++p) {
    Part& part = parts_[as_index(p)];
    part.scaled.leftCols(grid_.cells()) = (part.residual / magnitude).matrix().cast<float>();
    transformed_.middleCols(part.first, part.count).noalias() = modes_.transpose() * part.scaled.transpose();
  }
#pragma omp barrier
  const int centre = middle();
  for (int half = 0; half < 2; ++half) {
    if (!is_owner(own, half)) continue;
    const Walk walk = walk_to_middle(half, centre, grid_.layers());
    for (int n = 1, k = walk.from + walk.step; n < walk.count; ++n, k += walk.step)
      transformed_.col(k).array() += multiplier_.col(k - walk.step).array() * transformed_.col(k - walk.step).array();
  }
#pragma omp barrier
  for (int half = 0; half < 2; ++half) {
    if (!is_owner(own, half)) continue;
    // Both owners work the middle out for themselves.
    Eigen::ArrayXf& beyond = beyond_[as_index(half)];
    beyond = transformed_.col(centre).array();
    if (centre > 0) beyond += multiplier_.col(centre - 1).array() * transformed_.col(centre - 1).array();
    if (centre + 1 < layers) beyond += multiplier_.col(centre + 1).array() * transformed_.col(centre + 1).array();
    beyond *= pivot_.col(centre).array();
  }
#pragma omp barrier
  for (int half = 0; half < 2; ++half) {
    if (!is_owner(own, half)) continue;
    Eigen::ArrayXf& beyond = beyond_[as_index(half)];
    if (half == 1) transformed_.col(centre) = beyond.matrix();
    const Walk walk = walk_to_middle(half, centre, grid_.layers());
    for (int n = walk.count, k = walk.from + walk.step * (walk.count - 1); n > 0; --n, k -= walk.step) {
      beyond = pivot_.col(k).array() * transformed_.col(k).array() + multiplier_.col(k).array() * beyond;
      transformed_.col(k) = beyond.matrix();
    }
  }
#pragma omp barrier
  for (int p = own.first; p < own.last; ++p) {
    Part& part = parts_[as_index(p)];
    part.scaled.noalias() = transformed_.middleCols(part.first, part.count).transpose() * modes_.transpose();
    part.preconditioned = magnitude * part.scaled.leftCols(grid_.cells()).cast<double>().array();
    part.product = (part.residual * part.preconditioned).sum();
  }
}

PressureEquation::Outcome PressureEquation::iterate(const ThreadPartition& own, const std::vector<double>& b,
                                                    std::vector<double>& x, double tolerance, int most) {
  const Eigen::Index layers = grid_.layers(), cells = grid_.cells();
  const Eigen::Map<const Eigen::ArrayXXd> right_hand_side(b.data(), layers, cells);
  Eigen::Map<Eigen::ArrayXXd> solution(x.data(), layers, cells);
  const std::span<Part> parts_here(&parts_[as_index(own.first)], as_index(own.last - own.first));
  for (Part& part : parts_here) update_diagonal(part);
  update_preconditioner(own);
  for (Part& part : parts_here) {
    solution.middleRows(part.first, part.count) = 0.0;
    part.residual = right_hand_side.middleRows(part.first, part.count);
    part.squared = part.residual.square().sum();
  }
#pragma omp barrier
  const auto sum_of = [this](double Part::*value) {
    double sum = 0.0;
    for (const Part& part : parts_) sum += part.*value;
    return sum;
  };
  double squared = sum_of(&Part::squared), previous = 0.0;
  const double wanted = tolerance * tolerance * squared, norm_b = std::sqrt(squared);
  Outcome outcome;
  while (squared > wanted && outcome.iterations < most) {
    precondition(own, std::sqrt(squared));
#pragma omp barrier
    const double along = sum_of(&Part::product), keep = outcome.iterations == 0 ? 0.0 : along / previous;
    previous = along;
    for (Part& part : parts_here) part.direction = part.preconditioned + keep * part.direction;
#pragma omp barrier
    for (Part& part : parts_here) multiply(part);
#pragma omp barrier
    const double length = along / sum_of(&Part::product);
    for (Part& part : parts_here) {
      solution.middleRows(part.first, part.count) += length * part.direction;
      part.residual -= length * part.image;
      part.squared = part.residual.square().sum();
    }
#pragma omp barrier
    squared = sum_of(&Part::squared);
    ++outcome.iterations;
  }
  outcome.relative_residual = norm_b > 0.0 ? std::sqrt(squared) / norm_b : 0.0;
  return outcome;
}

PressureEquation::Outcome PressureEquation::solve(const std::vector<double>& b, std::vector<double>& x,
                                                  double tolerance, int most) {
  Outcome outcome;
#pragma omp parallel num_threads(std::min(threads_, parts))
  {
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();
    const Outcome own = iterate({parts * thread / threads, parts * (thread + 1) / threads}, b, x, tolerance, most);
    if (thread == 0) outcome = own;
  }
  return outcome;
}

double PressureEquation::largest_residual() const {
  double largest = 0.0;
  for (const Part& part : parts_)
    if (part.count > 0) largest = std::max(largest, part.residual.abs().maxCoeff());
  return largest;
}

}  // namespace slfb::fluid
