#include "experiments/peng_2014/reference.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slfb {

Peng2014::Peng2014(const std::filesystem::path& folder) : ReferenceNumbers("peng-2014") {
  for (const char* name : {"table1.toml", "fitted_lines.toml", "statements.toml"}) read_values(folder / name);
  const ReferenceTable table2{"table2.csv",
                              "Table 2, p. 54",
                              {{"table2/classification_velocity", "classification velocity at {} m/s", "m/s", 0.0005},
                               {"table2/intercept", "intercept of the fitted line at {} m/s", "m", 0.0005},
                               {"table2/r_squared", "R² of the fitted line at {} m/s", "-", 0.00005}}};
  for (const auto& row : read_table(folder, table2)) table2_.push_back({row[0], row[1], row[2], row[3]});
  const ReferenceTable figure13{"figure13.csv",
                                "captions of Figs. 13 and 14, p. 56",
                                {{"figure13/voidage", "mean bed voidage at {} m/s", "-", 0.005}}};
  for (const auto& row : read_table(folder, figure13)) figure13_.push_back({row[0], row[1]});

  // Printed lines evaluated where the paper shows points of its own, and printed numbers taken together.
  for (const double velocity : {0.03, 0.04}) {
    const std::string where = fmt::format("{:.2f}", velocity);
    add({"figure5/packed_line/" + where, "pressure drop on the line through the packed bed at " + where + " m/s",
         value("packed_line_slope") * velocity + value("packed_line_intercept"), "Pa",
         at("packed_line_slope").uncertainty * velocity, "Fig. 5, line evaluated"},
        (folder / "fitted_lines.toml").string());
  }
  for (const Table2Row& row : table2_) {
    const std::string where = fmt::format("{:.2f}", row.superficial_velocity);
    // The window of height is 0.1 to 0.2 m (§5.2); the drop is at 20 s on the clock of the lines.
    const double fall = (row.intercept - 0.15) / row.classification_velocity;
    add({"table2/time_to_window/" + where, "time from the release to the middle of the window at " + where + " m/s",
         fall - value("drop_time_water"), "s",
         std::hypot(0.0005 / row.classification_velocity, fall * 0.0005 / row.classification_velocity),
         "Table 2, p. 54, line evaluated"},
        (folder / "table2.csv").string());
    add({"table2/line_residual/" + where, "√(1 − R²) of the fitted line at " + where + " m/s",
         std::sqrt(1.0 - row.r_squared), "-", 0.00005 / (2.0 * std::sqrt(1.0 - row.r_squared)),
         "Table 2, p. 54, from R²"},
        (folder / "table2.csv").string());
  }
  add({"line_residual_largest", "largest √(1 − R²) of the lines of Table 2",
       std::sqrt(1.0 - value("r_squared_minimum")), "-", 0.0012, "§5.2, p. 27; Table 2, p. 54, from R²"},
      (folder / "statements.toml").string());
  add({"computing_cost", "computing time per simulated time", value("computing_time") * 3600.0 / value("computed_time"),
       "s/s", 3600.0 * 0.5 / value("computed_time"), "§3.2, p. 20: 66 h for 23 s"},
      (folder / "statements.toml").string());
}

const Peng2014& peng_2014() {
  static const Peng2014 data(reference_data_folder() / "peng_2014");
  return data;
}

}  // namespace slfb
