#pragma once

#include <filesystem>

namespace slfb {

/// Writes a page per law into `folder`/laws, NAME.html, and variants.html, which shows how far apart sources are that
/// print different formulas under one name. All comes from the catalogue, from reference-data/law_checks and from the
/// bibliography.
void write_law_pages(const std::filesystem::path& folder);

}  // namespace slfb
