#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "experiments/reference/reference_numbers.hpp"

namespace slfb {

/// One row of Table 2: z = intercept − velocity·t, t from the start of fluidisation.
struct Table2Row {
  double superficial_velocity = 0.0;     ///< U_L [m/s]
  double classification_velocity = 0.0;  ///< V_2 [m/s]
  double intercept = 0.0;                ///< [m]
  double r_squared = 0.0;                ///< [-]
};

/// A printed pair of superficial velocity and bed voidage (captions of Figs. 13, 14).
struct VoidagePoint {
  double superficial_velocity = 0.0;  ///< [m/s]
  double voidage = 0.0;               ///< [-]
};

/// Everything printed in Peng et al. (2014) that the suite compares with.
class Peng2014 : public ReferenceNumbers {
 public:
  /// Reads the folder; throws std::runtime_error naming file and line on anything unexpected. Rows of tables are
  /// addressed as "table2/classification_velocity/0.06", "table2/intercept/0.06", "table2/r_squared/0.06" and
  /// "figure13/voidage/0.06"; the line through the packed bed as "figure5/packed_line/0.03" (and 0.04).
  explicit Peng2014(const std::filesystem::path& folder);

  [[nodiscard]] const std::vector<Table2Row>& table2() const { return table2_; }
  [[nodiscard]] const std::vector<VoidagePoint>& figure13() const { return figure13_; }

 private:
  std::vector<Table2Row> table2_;
  std::vector<VoidagePoint> figure13_;
};

/// The paper's numbers, read once.
const Peng2014& peng_2014();

}  // namespace slfb
