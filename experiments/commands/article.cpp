#include "experiments/work/article.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/works.hpp"
#include "solver/support/folders.hpp"

namespace slfb {

void add_article_command(CLI::App& app, const Works& works) {
  struct Options {
    std::string work, profile;
    std::filesystem::path out = build_folder();
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("article", "Write the reproduction as an article, its numbers filled from data");
  add_work_option(*command, works, options->work);
  command->add_option("--profile", options->profile,
                      "simulations whose numbers it has (default: " + find_work(works, "").default_profile + ")");
  command->add_option("--out", options->out, "folder of runs/ and article/")->type_name("DIR")->capture_default_str();
  command->footer(
      fmt::format("The text is experiments/WORK/article/article.md, with metadata.yaml beside it as ReScience C wants "
                  "it. Nothing is\n"
                  "simulated; `make article` prints it as PDF. Between double braces the text may name:\n{}",
                  article_places));
  command->callback([options, &works] {
    const Work& work = find_work(works, options->work);
    const Profile profile = load_profile(work, options->profile.empty() ? work.default_profile : options->profile);
    const auto folder = options->out / "article";
    write_article(work, judge(work, profile, load_claims(work), options->out), options->out, folder);
    fmt::print("article: {}\n", (folder / "article.html").string());
  });
}

}  // namespace slfb
