#pragma once

#include <array>
#include <string_view>

/// The pairs of foreign sphere and bed that the paper simulates (Figs. 20 and 26) and how each is drawn.
namespace slfb {

enum class BedLiquid { water, sodium_iodide };

struct BedSystem {
  std::string_view name;    ///< foreign in bed diameter [mm], W water, N sodium iodide
  double foreign_diameter;  ///< [m]
  double bed_diameter;      ///< [m]
  BedLiquid liquid;
  std::string_view title;
  int line_style;  ///< of reports/style.gp
};

/// In the order of the paper's legends.
inline constexpr std::array<BedSystem, 8> bed_systems{
    {{"6in3W", 0.006, 0.003, BedLiquid::water, "6 in 3 mm, water", 31},
     {"6in4W", 0.006, 0.004, BedLiquid::water, "6 in 4 mm, water", 32},
     {"6in5W", 0.006, 0.005, BedLiquid::water, "6 in 5 mm, water", 33},
     {"5in5W", 0.005, 0.005, BedLiquid::water, "5 in 5 mm, water", 34},
     {"4in5W", 0.004, 0.005, BedLiquid::water, "4 in 5 mm, water", 35},
     {"3in5W", 0.003, 0.005, BedLiquid::water, "3 in 5 mm, water", 36},
     {"6in3N", 0.006, 0.003, BedLiquid::sodium_iodide, "6 in 3 mm, NaI", 37},
     {"6in5N", 0.006, 0.005, BedLiquid::sodium_iodide, "6 in 5 mm, NaI", 38}}};

}  // namespace slfb
