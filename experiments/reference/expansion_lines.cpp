#include "experiments/reference/expansion_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "experiments/reference/reference_numbers.hpp"

namespace slfb {
namespace {

ExpansionLine line_of(const Record& record, const std::string& work, BedMotion motion) {
  return {work,
          record.text(0),
          record.text(1),
          record.text(4),
          motion,
          {1e-3 * record.positive(2), record.positive(3)},
          {record.positive(6), 1e-3 * record.positive(5)},
          1e-3 * record.positive(7),
          1e-2 * std::pow(10.0, record.number(8)),
          record.positive(9),
          record.text(11)};
}

std::vector<std::string> headings(const std::string& tube, const std::string& velocity, const std::string& terminal) {
  return {"name",
          "particle",
          "diameter [mm]",
          "particle density [kg/m3]",
          "liquid",
          "viscosity [mPa s]",
          "liquid density [kg/m3]",
          tube + " diameter [mm]",
          "intercept of log10 " + velocity + " in cm/s [-]",
          "exponent [-]",
          terminal,
          "remark"};
}

}  // namespace

std::string ExpansionLine::group() const {
  return fmt::format("{}: {:g} mm of {:g} kg/m³ in {} of {:g} kg/m³ and {:g} mPa s", work, 1e3 * sphere.diameter,
                     sphere.density, liquid_name, liquid.density, 1e3 * liquid.viscosity);
}

double ExpansionLine::velocity(double voidage) const { return intercept * std::pow(voidage, exponent); }

std::vector<ExpansionLine> expansion_lines(const std::filesystem::path& folder) {
  std::vector<ExpansionLine> lines;
  std::set<std::string> names;
  const auto read = [&](const std::string& name, const std::vector<std::string>& columns, BedMotion motion) {
    if (!std::filesystem::exists(folder / name)) return;
    for (const Record& record : read_records(folder / name, columns)) {
      lines.push_back(line_of(record, folder.filename().string(), motion));
      if (!names.insert(lines.back().name).second) throw record.problem("\"" + lines.back().name + "\" occurs twice");
    }
  };
  read("fluidised_lines.csv", headings("column", "U", "terminal velocity [cm/s]"), BedMotion::fluidised);
  read("settling_lines.csv", headings("tube", "V", "terminal Reynolds number [-]"), BedMotion::settling);
  return lines;
}

std::vector<PackedBedPoint> packed_bed_points(const std::filesystem::path& folder) {
  std::vector<PackedBedPoint> points;
  const auto file = folder / "packed_beds.csv";
  if (!std::filesystem::exists(file)) return points;
  for (const Record& record : read_records(file, {"series", "reynolds over solids [-]", "friction factor [-]"}))
    points.push_back({record.text(0), record.positive(1), record.positive(2)});
  return points;
}

std::vector<std::filesystem::path> reference_data_folders() {
  std::vector<std::filesystem::path> folders;
  for (const auto& entry : std::filesystem::directory_iterator(reference_data_folder()))
    if (entry.is_directory()) folders.push_back(entry.path());
  std::ranges::sort(folders);
  return folders;
}

}  // namespace slfb
