#pragma once

#include <filesystem>
#include <string>

/// The laws of the catalogue as pages: what each says, where it comes from, where it holds and how it looks.
namespace slfb {

/// The list of all laws as an HTML table: formula, range, source and how each formula came to us. Its links lead to the
/// pages of write_law_pages in the folder laws/ beside the page that shows it.
std::string law_section();

/// Writes a page per law into `folder`/laws, NAME.html, and variants.html, which shows how far apart sources are that
/// print different formulas under one name, with the pictures of both (gnuplot). All comes from the catalogue, from
/// reference-data/law_checks and from reference-data/references.bib. Throws std::runtime_error naming the file that
/// cannot be read or written, or the source that the bibliography lacks.
void write_law_pages(const std::filesystem::path& folder);

}  // namespace slfb
