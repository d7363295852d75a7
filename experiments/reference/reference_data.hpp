#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Numbers of the literature, read from reference-data/ (its README describes the format).
namespace slfb {

/// One printed number.
struct ReferenceValue {
  std::string id;
  std::string quantity;
  double value = 0.0;
  std::string unit;
  double uncertainty = 0.0;  ///< half the last printed digit unless the source states more, in `unit`
  std::string source;        ///< table, figure, section and page of the accepted manuscript
};

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
class Peng2014 {
 public:
  /// Reads the folder; throws std::runtime_error naming file and line on anything unexpected.
  explicit Peng2014(const std::filesystem::path& folder);

  /// The number with this id; throws std::out_of_range with the id when there is none. Rows of tables are addressed
  /// as "table2/classification_velocity/0.06", "table2/intercept/0.06", "table2/r_squared/0.06" and
  /// "figure13/voidage/0.06"; the line through the packed bed as "figure5/packed_line/0.03" (and 0.04).
  [[nodiscard]] const ReferenceValue& at(std::string_view id) const;
  [[nodiscard]] double value(std::string_view id) const { return at(id).value; }

  [[nodiscard]] const std::vector<Table2Row>& table2() const { return table2_; }
  [[nodiscard]] const std::vector<VoidagePoint>& figure13() const { return figure13_; }
  [[nodiscard]] const std::map<std::string, ReferenceValue, std::less<>>& values() const { return values_; }

 private:
  void add(ReferenceValue value, const std::string& origin);
  std::map<std::string, ReferenceValue, std::less<>> values_;
  std::vector<Table2Row> table2_;
  std::vector<VoidagePoint> figure13_;
};

/// A measured bounce of a sphere on a wall in a liquid.
struct WetBounce {
  double stokes = 0.0;       ///< ρ_P U d/(9 μ) [-]
  double restitution = 0.0;  ///< speed after over speed before [-]
};
/// Gondret, Lance & Petit (2002), two bounces.
std::vector<WetBounce> gondret_2002();

/// Joseph et al. (2001): no rebound below the first Stokes number, the dry restitution above the second [-].
struct StokesLimits {
  double no_rebound_below = 0.0, dry_above = 0.0;
};
StokesLimits joseph_2001();

/// The folder reference-data/ of the source tree.
std::filesystem::path reference_data_folder();

/// The paper's numbers, read once.
const Peng2014& peng_2014();

}  // namespace slfb
