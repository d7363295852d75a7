#pragma once

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <vector>

namespace slfb::fluid {

/// Preconditioner of the pressure equation: each vertical line of cells solved exactly, plus the mean of each layer.
///
/// A column is many cells high and few wide. What is slow for a local preconditioner is the vertical balance of whole
/// layers; summed over its layers the matrix is tridiagonal, and solving that directly takes those modes out:
/// M⁻¹ = T⁻¹ + P (Pᵀ A P)⁻¹ Pᵀ, T the vertical lines of A and P constant over a layer. Cells are numbered line after
/// line. Against incomplete Cholesky this needs a few more iterations, each at half the cost, and no factorisation.
class SectionMeanPreconditioner {
 public:
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic };

  void set_layers(int layers) { layers_ = static_cast<std::size_t>(layers); }

  template <class Matrix>
  SectionMeanPreconditioner& analyzePattern(const Matrix&) {
    return *this;
  }

  template <class Matrix>
  SectionMeanPreconditioner& factorize(const Matrix& matrix) {
    const auto n = static_cast<std::size_t>(matrix.outerSize());
    lines_.reset(n);
    mean_.reset(layers_);
    sum_.resize(layers_);
    for (std::size_t row = 0; row < n; ++row)
      for (typename Matrix::InnerIterator entry(matrix, static_cast<Eigen::Index>(row)); entry; ++entry) {
        const auto column = static_cast<std::size_t>(entry.index());
        const std::size_t i = row % layers_, j = column % layers_;
        if (column == row) lines_.pivot[row] = entry.value();
        if (column == row + 1 && j == i + 1) lines_.above[row] = entry.value();
        if (i == j) mean_.pivot[i] += entry.value();
        if (j == i + 1) mean_.above[i] += entry.value();
      }
    lines_.factorize();
    mean_.factorize();
    return *this;
  }

  template <class Matrix>
  SectionMeanPreconditioner& compute(const Matrix& matrix) {
    return analyzePattern(matrix).factorize(matrix);
  }

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& residual) const {
    Eigen::VectorXd result = residual;
    lines_.solve(result.data(), layers_);
    std::fill(sum_.begin(), sum_.end(), 0.0);
    const auto n = static_cast<std::size_t>(residual.size());
    for (std::size_t first = 0; first < n; first += layers_)
      for (std::size_t k = 0; k < layers_; ++k) sum_[k] += residual.data()[first + k];
    mean_.solve(sum_.data(), layers_);
    for (std::size_t first = 0; first < n; first += layers_)
      for (std::size_t k = 0; k < layers_; ++k) result.data()[first + k] += sum_[k];
    return result;
  }

  [[nodiscard]] Eigen::ComputationInfo info() const { return Eigen::Success; }

 private:
  /// Symmetric tridiagonal matrix: L D Lᵀ in place, D⁻¹ in `pivot` and the multipliers in `above`. Lines that do not
  /// touch follow each other with a zero between them.
  struct Tridiagonal {
    std::vector<double> pivot, above;
    void reset(std::size_t n) {
      pivot.assign(n, 0.0);
      above.assign(n, 0.0);
    }
    void factorize() {
      for (std::size_t k = 0; k < pivot.size(); ++k) {
        if (k > 0) pivot[k] -= above[k - 1] * above[k - 1] * pivot[k - 1];
        pivot[k] = 1.0 / pivot[k];
        if (k > 0) above[k - 1] *= pivot[k - 1];
      }
    }
    /// Lines of `length` each. Eight go side by side, since each is one long chain of dependent operations.
    void solve(double* x, std::size_t length) const {
      constexpr std::size_t together = 8;
      std::size_t first = 0;
      for (; first + together * length <= pivot.size(); first += together * length)
        solve_lines<together>(x, first, length);
      for (; first < pivot.size(); first += length) solve_lines<1>(x, first, length);
    }
    template <std::size_t count>
    void solve_lines(double* x, std::size_t first, std::size_t length) const {
      for (std::size_t i = first + 1; i < first + length; ++i)
        for (std::size_t n = i; n < i + count * length; n += length) x[n] -= above[n - 1] * x[n - 1];
      for (std::size_t n = first; n < first + count * length; ++n) x[n] *= pivot[n];
      for (std::size_t i = first + length - 1; i-- > first;)
        for (std::size_t n = i; n < i + count * length; n += length) x[n] -= above[n] * x[n + 1];
    }
  };

  std::size_t layers_ = 1;
  Tridiagonal lines_, mean_;
  mutable std::vector<double> sum_;  ///< scratch of solve, which Eigen's interface wants const
};

}  // namespace slfb::fluid
