#pragma once

#include <string>

#include "reports/gnuplot.hpp"

namespace slfb {

/// Eq. 40 and Grbavčić's force with f = 0 over the voidage, and van der Wielen's at the velocities of Table 2, as
/// tables of these names.
DataTable collision_force_laws(const std::string& name);
DataTable van_der_wielen_of_table_2(const std::string& name);

/// Axes and a plot command of `collision_force_laws(name)` and `van_der_wielen_of_table_2(name + "_van_der_wielen")`
/// without an end, so that others can go on with ", …".
std::string collision_force_plot(const std::string& name);

}  // namespace slfb
