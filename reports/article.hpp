#pragma once

#include <functional>
#include <string>

/// An article whose text is Markdown with places that are filled from data.
namespace slfb::reports {

/// What stands for the words between double braces, as Markdown. Throws std::invalid_argument saying what is wrong.
using Fill = std::function<std::string(const std::string& words)>;

/// `text` with every "{{words}}" filled. Throws std::runtime_error "ORIGIN:LINE: …" for braces without an end and for
/// words that `fill` refuses.
std::string fill_template(const std::string& text, const std::string& origin, const Fill& fill);

/// The article as one page to read or to print. Its first heading, "# TITLE", is the title. Throws std::runtime_error
/// for a text without one.
std::string article_html(const std::string& markdown);

}  // namespace slfb::reports
