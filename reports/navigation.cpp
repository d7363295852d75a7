#include "reports/navigation.hpp"

#include <fmt/format.h>

#include "reports/html.hpp"

namespace slfb::reports {

std::string navigation(const ReportContents& contents, std::string_view current, const std::string& prefix) {
  std::string html = "<nav><div>";
  const auto link = [&](const std::string& file, const std::string& label) {
    html +=
        fmt::format("<a href=\"{}{}\"{}>{}</a>", prefix, file, label == current ? " aria-current=\"page\"" : "", label);
  };
  link("index.html", "Overview");
  link("claims.html", "Claims");
  for (const FeaturedPage& page : contents.texts.featured)
    link("figures/" + page.figure + ".html", escape_html(page.label));
  link("inconsistencies.html", "What does not add up");
  link("methods.html", "Methods");
  link("laws.html", "Laws");
  link("quantities.html", "Quantities");
  link("data.html", "Data of a run");
  link("flow.html", "How data flows");
  link("provenance.html", "Provenance");
  link("print.html", "All on one page");
  return html + fmt::format(
                    "<form action=\"{}search.html\" role=\"search\"><input type=\"search\" name=\"q\" "
                    "placeholder=\"Search\" aria-label=\"search the report\" /></form></div></nav>\n",
                    prefix);
}

}  // namespace slfb::reports
