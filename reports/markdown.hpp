#pragma once

#include <string>

namespace slfb {

/// A README as HTML, subscripts of symbols set as such. Its first heading is left out, since the page has its own; the
/// others become third-level ones.
std::string markdown_html(const std::string& text);

}  // namespace slfb
