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
///
/// The column is cut into parts of some layers, each with its own storage, and the threads share the parts within one
/// parallel region per solution, so that little passes from one to another. The tridiagonal systems are eliminated from
/// both ends towards the middle. The parts are the same however many threads there are, and so is the result.
class PressureEquation {
 public:
  /// The grid must outlive the equation. \param closed no outlet at the top: the pressure is then tied to 0 in cell 0,
  /// through which nothing must flow
  PressureEquation(const ColumnGrid& grid, bool closed, int threads = 1);

  /// Coefficients of the faces across x, y (face * layers + layer) and z (cell * (layers + 1) + face, from below; the
  /// highest is the outlet's). 0 where the velocity is given [m³/(Pa s)].
  std::array<std::vector<double>, 3> coefficient;

  struct Outcome {
    int iterations = 0;
    double relative_residual = 0.0;  ///< Euclidean norm over that of b
  };
  /// Solves for x [Pa], starting from 0, until the residual is `tolerance` of b [m³/s] or after `most` iterations; both
  /// have grid.size() values. Throws nothing: the caller looks at the residual.
  Outcome solve(const std::vector<double>& b, std::vector<double>& x, double tolerance, int most);

  /// Largest |b − A x| over the cells as the last iteration left it [m³/s].
  [[nodiscard]] double largest_residual() const;

 private:
  /// A face between a cell of the section and another, and where its coefficients begin.
  struct Link {
    std::size_t axis, start;
    int neighbour;
  };
  /// Some layers of the column; fields are layer by cell.
  struct Part {
    int first = 0, count = 0;  ///< layers
    Eigen::ArrayXXd diagonal, residual, direction, image, preconditioned;
    Eigen::MatrixXf scaled;  ///< residual, then result of the preconditioner
    double product = 0.0;    ///< scalar product of what each function says
    double squared = 0.0;    ///< of the residual
  };
  static constexpr int parts = 4;
  /// Parts, cells and modes come in whole multiples of this in the products of matrices; what is added is 0.
  static constexpr int width = 8;
  /// The parts that a thread works on.
  struct ThreadPartition {
    int first, last;
  };

  // What follows is called by all threads of a parallel region together; it waits for the others where it must.
  Outcome iterate(const ThreadPartition& own, const std::vector<double>& b, std::vector<double>& x, double tolerance,
                  int most);
  void update_diagonal(Part& part);
  void update_preconditioner(const ThreadPartition& own);
  /// preconditioned from residual, whose `magnitude` is taken out while numbers are short; their scalar product.
  void precondition(const ThreadPartition& own, double magnitude);
  /// The part that holds a layer; any for a layer outside the column.
  [[nodiscard]] const Part& part_of(int layer) const;
  /// image = A direction, and their scalar product.
  void multiply(Part& part);
  /// The thread that eliminates a half of the column is that of the half's first part.
  [[nodiscard]] static bool is_owner(const ThreadPartition& own, int half) {
    return own.first <= half * (parts / 2) && half * (parts / 2) < own.last;
  }
  [[nodiscard]] int middle() const { return parts_[parts / 2].first; }

  const ColumnGrid& grid_;
  bool closed_;
  int threads_;
  std::vector<std::vector<Link>> links_;  ///< per cell of the section
  std::array<Part, parts> parts_;
  double lateral_sum_ = 0.0;                          ///< of face area over distance in a layer [m]
  std::vector<double> lateral_mean_, vertical_mean_;  ///< coefficient over that sum, and over the section's area
  Eigen::ArrayXd eigenvalues_;
  Eigen::MatrixXf modes_;                     ///< eigenvectors of the section, one per column
  Eigen::MatrixXf pivot_, multiplier_;        ///< of the tridiagonal systems, mode by layer; towards the middle
  std::array<Eigen::ArrayXd, 2> eliminated_;  ///< what the layer next to the middle leaves on it, from each side
  std::array<Eigen::ArrayXf, 2> beyond_;      ///< solution in the layer that was last done, per half
  Eigen::MatrixXf transformed_;               ///< mode by layer
};

}  // namespace slfb::fluid
