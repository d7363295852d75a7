// Articles: places of a template are filled, and what cannot be filled names its line.
#include "reports/article.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace slfb::reports {
namespace {

std::string fill(const std::string& words) {
  if (words == "answer") return "42";
  throw std::invalid_argument("no \"" + words + "\" here");
}

std::string problem(const std::string& text) {
  try {
    fill_template(text, "a.md", fill);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Article, PlacesAreFilled) {
  EXPECT_EQ(fill_template("It is {{answer}}, {{answer}}.\n", "a.md", fill), "It is 42, 42.\n");
  EXPECT_EQ(fill_template("{ } }} none", "a.md", fill), "{ } }} none");
}

TEST(Article, ProblemsNameTheirLine) {
  EXPECT_EQ(problem("one\n\nthree {{question}}"), "a.md:3: no \"question\" here");
  EXPECT_EQ(problem("one\ntwo {{answer"), "a.md:2: \"{{\" without \"}}\"");
}

TEST(Article, ThePageHasTitleTextAndTables) {
  const std::string page =
      article_html("# Lift & drag\n\nThe **text**.\n\n## Methods\n\n| a | b |\n|---|---|\n| 1 | 2 |\n");
  for (const char* part : {"<title>Lift &amp; drag</title>", "<h1>Lift &amp; drag</h1>", "<strong>text</strong>",
                           "<h3>Methods</h3>", "<td>1</td>", "class=\"article\""})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_THROW(article_html("No title"), std::runtime_error);
}

}  // namespace
}  // namespace slfb::reports
