#include "experiments/work/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "solver/support/folders.hpp"

namespace slfb {

WorkFolders folders_of(const std::string& id) {
  const auto source = source_folder();
  return {source / "experiments" / id, source / "reference-data" / id, source / "reports" / "published" / id / "runs"};
}

const Work& find_work(const Works& works, const std::string& id) {
  const auto found = std::ranges::find_if(
      works, [&](const Work* work) { return id.empty() ? !work->figures.empty() : work->id == id; });
  if (found != works.end()) return **found;
  std::string known;
  for (const Work* work : works) known += (known.empty() ? "" : ", ") + work->id;
  throw std::invalid_argument(id.empty() ? "no work has figures; known: " + known
                                         : fmt::format("there is no work \"{}\"; known: {}", id, known));
}

std::set<std::string> system_names(const Work& work) {
  std::set<std::string> names;
  for (const System& system : work.systems) names.insert(system.name);
  return names;
}

bool needs_run(const Work& work, const MeasureKey& key) {
  return key.subject == all_systems ||
         std::ranges::find(work.systems, key.subject, &System::name) != work.systems.end();
}

std::vector<Claim> load_claims(const Work& work) {
  std::vector<Claim> claims;
  const auto file = work.folders.reference_data / "claims.toml";
  static const ReferenceNumbers none("a work without numbers");
  if (std::filesystem::exists(file))
    claims = load_claims(file, work.reference == nullptr ? none : *work.reference, system_names(work));
  if (work.claims) std::ranges::move(work.claims(), std::back_inserter(claims));
  return claims;
}

}  // namespace slfb
