#pragma once

#include <vector>

namespace CLI {
class App;
}

/// The commands of `slfb`. Each function adds one of them to `app`, with its options, its help and what it does; the
/// file experiments/commands/NAME.cpp holds it. A command writes results to standard output and messages to standard
/// error. On wrong arguments it throws CLI::ValidationError; where the exit status is not 0 for another reason, such as
/// a gate that does not hold or Ctrl-C (130), it throws CLI::RuntimeError with that status.
namespace slfb {

struct Work;
using Works = std::vector<const Work*>;

/// The works of the suite (works.cpp), among which --work ID chooses.
const Works& works();

/// `slfb figures`: simulates what figures still need, draws them and writes the report.
void add_figures_command(CLI::App& app, const Works& works = slfb::works());

/// `slfb check`: every claim with its verdict. The exit status is 0 only when every gate holds.
void add_check_command(CLI::App& app, const Works& works = slfb::works());

/// `slfb history`: what versions said to the claims, and what has changed.
void add_history_command(CLI::App& app);

/// `slfb article`: the reproduction as an article, its numbers and figures filled from data.
void add_article_command(CLI::App& app, const Works& works = slfb::works());

/// `slfb compare`: laws, those of the suite and a user's own, side by side, in the bed that a work hands over.
void add_compare_command(CLI::App& app, const Works& works = slfb::works());

/// `slfb run`: simulates one scene file.
///
/// `--json` writes one object to standard output. With `--dry-run`: {"scene", "hash", "spheres", "liquid_cells",
/// "steps_per_contact", "dem_time_step", "dem_time_step_bound", "liquid_time_step", "simulated_seconds",
/// "simulated_seconds_at_most", "particle_steps", "estimated_wall_seconds", "result", "result_exists"}; else {"scene",
/// "hash", "status" ("finished", "existed", "interrupted", "failed"), "result", and for a result "wall_seconds",
/// "cpu_seconds", "simulated_seconds", "particle_steps", "particle_steps_per_second", "particles_removed",
/// "measurements": {quantity: {"value", "half_width", "unit", "samples"}}, "drops": [{"species", "release_time",
/// "bottom_time", "classification_velocity", "r_squared"}]}. A number that does not exist is null.
void add_run_command(CLI::App& app);

/// `slfb plan`: which models, grid and steps a scene needs for what is asked of it.
void add_plan_command(CLI::App& app);

/// `slfb frontier`: error against cost of methods.
void add_frontier_command(CLI::App& app);

/// `slfb stability`: maps of where methods fail.
void add_stability_command(CLI::App& app);

/// `slfb laws`: the catalogue of literature laws as a table or as JSON.
void add_laws_command(CLI::App& app);

/// `slfb law`: one law with the values that it gives for the arguments it takes.
void add_law_command(CLI::App& app);

/// `slfb league`: every law against all measurements, and the laws that were near in beds like one that is asked for.
void add_league_command(CLI::App& app);

/// `slfb predict`: what is to be expected of a scene's bed, with its uncertainty.
void add_predict_command(CLI::App& app);

/// `slfb bench`: how fast the parts of the solver are on this machine.
void add_bench_command(CLI::App& app);

/// `slfb campaign`: the runs of a profile as jobs of a scheduler; `slfb campaign merge`: results of several machines.
void add_campaign_command(CLI::App& app);

/// `slfb show`: what a finished run holds, printed, and drawn on one page.
void add_show_command(CLI::App& app);

/// `slfb movie`: pictures of the spheres of a run, one per snapshot, joined to a film where ffmpeg is installed.
void add_movie_command(CLI::App& app);

/// `slfb completion`: what a shell needs to complete commands and options.
void add_completion_command(CLI::App& app);

/// `slfb list`: figures, claims, the runs of each profile, scenes; `slfb list quantities`: what is measured.
void add_list_command(CLI::App& app, const Works& works = slfb::works());

}  // namespace slfb
