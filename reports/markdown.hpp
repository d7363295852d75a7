#pragma once

#include <string>

namespace slfb {

/// The paragraphs of a README as HTML: bold words, code between backticks, blank lines between paragraphs; the heading
/// is left out, since the page has its own. The READMEs of the experiments use nothing else.
std::string markdown_html(const std::string& text);

}  // namespace slfb
