#pragma once

#include <cstddef>
#include <vector>

namespace slfb::readings {

/// A square matrix of +1 and -1 whose rows are orthogonal to one another, and so are its columns. Its first column is
/// +1 throughout.
using HadamardMatrix = std::vector<std::vector<int>>;

/// The smallest matrix with at least `columns` columns that can be made from squares modulo a prime (Paley 1933,
/// J. Math. Phys. 12, 311) and by doubling (Sylvester 1867): orders 4, 8, 12, 16, 20, 24, 32 and others. Without its
/// first column it is a design of Plackett and Burman (1946, Biometrika 33, 305).
/// Throws std::invalid_argument for none, or more than 256 columns.
HadamardMatrix hadamard_matrix(std::size_t columns);

}  // namespace slfb::readings
