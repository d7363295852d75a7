#include "experiments/readings/hadamard.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

namespace slfb::readings {
namespace {

constexpr std::size_t most_columns = 256;

bool is_prime(std::size_t number) {
  if (number < 2) return false;
  for (std::size_t divisor = 2; divisor * divisor <= number; ++divisor)
    if (number % divisor == 0) return false;
  return true;
}

/// Of order prime + 1, for a prime of the form 4 n + 3.
HadamardMatrix from_squares(std::size_t prime) {
  std::vector<int> sign(prime, -1);  // 1 for a square modulo the prime
  for (std::size_t root = 1; root < prime; ++root) sign[root * root % prime] = 1;
  HadamardMatrix matrix(prime + 1, std::vector<int>(prime + 1, 1));
  for (std::size_t row = 1; row <= prime; ++row)
    for (std::size_t column = 1; column <= prime; ++column)
      matrix[row][column] = row == column ? -1 : -sign[(row + prime - column) % prime];
  return matrix;
}

std::optional<HadamardMatrix> of_order(std::size_t order) {
  if (order == 1) return HadamardMatrix{{1}};
  if (order % 4 == 0 && is_prime(order - 1)) return from_squares(order - 1);
  if (order % 2 != 0) return std::nullopt;
  const auto half = of_order(order / 2);
  if (!half) return std::nullopt;
  HadamardMatrix matrix;
  for (const int lower : {1, -1})
    for (const std::vector<int>& row : *half) {
      matrix.push_back(row);
      for (const int value : row) matrix.back().push_back(lower * value);
    }
  return matrix;
}

}  // namespace

HadamardMatrix hadamard_matrix(std::size_t columns) {
  if (columns == 0 || columns > most_columns)
    throw std::invalid_argument(
        fmt::format("a design with {} columns; allowed are 1 to {} columns", columns, most_columns));
  for (std::size_t order = columns;; ++order)
    if (auto matrix = of_order(order)) return *matrix;
}

}  // namespace slfb::readings
