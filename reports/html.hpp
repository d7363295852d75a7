#pragma once

#include <string>
#include <vector>

/// Text, numbers and whole pages as HTML. Everything returned is HTML unless it is said otherwise.
namespace slfb {

/// `text` with the characters that HTML gives a meaning to replaced by entities.
std::string escape_html(const std::string& text);

/// Subscripts of symbols set as such: "U_L" becomes U<sub>L</sub>; names of files and keys stay as they are.
std::string with_subscripts(const std::string& html);

/// A sentence: escape_html and with_subscripts.
std::string prose_html(const std::string& text);

/// Four significant digits, without an exponent where that is readable: "0.0424", "51750", "1.2·10<sup>-5</sup>". A
/// dash for what is not a number. The result is HTML.
std::string readable_number(double value);

/// Bounds of a range: "0.1 … 300", "≥ 2" without an upper end, "any" from 0 without one. An infinite end is ±infinity.
std::string readable_range(double lower, double upper);

/// Seconds as a reader takes them in: "42 s", "12 min", "3.4 h".
std::string readable_duration(double seconds);

/// GitHub markdown as HTML, subscripts of symbols set as such. Its first heading is left out, since the page has its
/// own; the others become third-level ones. Throws std::runtime_error where md4c cannot read the text.
std::string markdown_html(const std::string& text);

/// A table that folds up on a phone. `headings` and the cells of `rows` are HTML; the first cell of a row leads it.
/// Every row needs as many cells as there are headings.
std::string table_html(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows);

/// A whole page in the style of reports/report.css. `title` and `body` are HTML; `body` holds everything from the
/// header to </main>. `html_class`: class of the root element, none where empty. Throws std::runtime_error where the
/// style sheet cannot be read.
std::string html_page(const std::string& title, const std::string& body, const std::string& html_class = "");

}  // namespace slfb
