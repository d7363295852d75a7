#include "experiments/commands/works.hpp"

#include <CLI/CLI.hpp>

#include "experiments/peng_2014/work.hpp"
#include "experiments/richardson_zaki_1954/work.hpp"

namespace slfb {

const Works& works() {
  static const Works list{&peng_2014_work(), &richardson_zaki_1954_work()};
  return list;
}

void add_work_option(CLI::App& command, const Works& works, std::string& id) {
  std::vector<std::string> known;
  for (const Work* work : works) known.push_back(work->id);
  command.add_option("--work", id, "publication or set of measurements (default: the first that has figures)")
      ->check(CLI::IsMember(known))
      ->option_text("ID");
}

}  // namespace slfb
