#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "correlations/catalogue.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/work/work.hpp"

namespace slfb {
namespace {

constexpr const char* examples = R"(Examples:
  slfb completion bash > ~/.local/share/bash-completion/completions/slfb
  source <(slfb completion bash)              in this shell alone
  autoload -U bashcompinit && bashcompinit && source <(slfb completion bash)     zsh)";

/// What may stand behind a command: its options, and names that it takes.
std::vector<std::string> words_of(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  if (command.get_name() == "figures" || command.get_name() == "check")
    for (const Figure& figure : find_work(works(), "").figures) words.push_back(figure.id);
  if (command.get_name() == "law")
    for (const CatalogueEntry& law : catalogue()) words.emplace_back(law.info.name);
  return words;
}

std::string bash_script(const CLI::App& app) {
  std::string cases, commands;
  for (const CLI::App* command : app.get_subcommands({})) {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), fmt::join(words_of(*command), " "));
  }
  return fmt::format(R"(# Completion of slfb for bash, written by `slfb completion bash`.
_slfb() {{
  local words="{} --help --version"
  if [ "$COMP_CWORD" -gt 1 ]; then
    case "${{COMP_WORDS[1]}}" in
    help) ;;
{}    *) words="" ;;
    esac
  fi
  COMPREPLY=($(compgen -W "$words" -- "${{COMP_WORDS[COMP_CWORD]}}"))
}}
complete -o default -F _slfb slfb
)",
                     commands + " help", cases);
}

}  // namespace

void add_completion_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("completion", "What a shell needs to complete commands and options");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash; zsh reads the same")->required()->check(CLI::IsMember({"bash", "zsh"}));
  command->footer(examples);
  command->callback([&app, shell] { fmt::print("{}", bash_script(app)); });
}

}  // namespace slfb
