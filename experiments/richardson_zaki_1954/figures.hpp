#pragma once

#include "experiments/figures/figure.hpp"

/// The figures of the measured beds, each a folder with its code and README.
namespace slfb::richardson_zaki {

/// Voidage over superficial velocity of every bed: measured line, simulations, laws.
namespace expansion {
Figure figure();
}
/// Our voidages against the measured ones.
namespace parity {
Figure figure();
}
/// Error of the voidage of the near drag laws: homogeneous beds, and simulated ones.
namespace three_dimensions {
Figure figure();
}
/// Error of the voidage over the terminal Reynolds number, by law.
namespace deviation {
Figure figure();
}

}  // namespace slfb::richardson_zaki
