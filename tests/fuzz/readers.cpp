#include "tests/fuzz/readers.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "experiments/claims/measured_file.hpp"
#include "experiments/numerics/plan/rules.hpp"
#include "experiments/numerics/pressure_noise/noise_study.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/quantities/json_file.hpp"
#include "experiments/quantities/run_summary.hpp"
#include "experiments/reference/reference_numbers.hpp"
#include "experiments/runs/sphere_frames.hpp"
#include "experiments/work/measured_systems.hpp"
#include "experiments/work/profiles.hpp"
#include "solver/io/run_result.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/laws/user_law.hpp"
#include "solver/run/checkpoint_files.hpp"
#include "solver/run/model.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "tests/hostile_hdf5.hpp"

namespace slfb::fuzz {
namespace {

namespace fs = std::filesystem;

/// By this name errors have to call an input.
constexpr const char* input_name = "input";

std::string text_of(const fs::path& file) { return read_file(source_folder() / file); }

/// A reader of a file: the input is put into one.
template <class Read>
Reader of_file(const std::string& name, std::vector<std::string> seeds, Read read, const std::string& ending = "") {
  return {name, std::move(seeds), [read, ending](const std::string& input, const fs::path& folder) {
            const fs::path file = folder / (input_name + ending);
            write_file(file, input);
            read(file);
          }};
}

Scene two_spheres() {
  Scene scene;
  scene.geometry.diameter = 0.03;
  scene.geometry.height = 0.05;
  scene.liquid = {998.2, 1e-3, 0.05};
  scene.fluid.cells_across = 4;
  scene.fluid.cell_height = 0.0075;
  scene.fluid.time_step = 1e-3;
  scene.species = {{"glass", 0.005, 2230, 2}};
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 1e-4;
  return scene;
}

/// The HDF5 part of files that the suite wrote.
struct Written {
  std::string result, checkpoint, records;
};

Written written_files(const fs::path& folder) {
  const Scene scene = two_spheres();
  simulation::Model model(scene, 1);
  model.fill();
  for (int k = 0; k < 2; ++k) model.advance(simulation::Surroundings::liquid);
  RunResult result;
  result.name = "a-run";
  result.scene_text = canonical_toml(scene);
  result.bed.time = {0.0, 0.1};
  for_each_column(result.bed, [](std::vector<double>& column) { column.resize(2, 0.5); });
  result.drops.emplace_back().species = "glass";
  for_each_column(result.drops[0], [](std::vector<double>& column) { column.resize(3, 0.25); });
  const simulation::CheckpointFiles files(folder, "a scene");
  files.save(result, 1, [&](io::StateGroup& state) { model.exchange(state); });
  save_result(result, folder / "result.h5");
  const auto content = [&](const char* name) { return hostile::bytes_of(folder / name).substr(512); };
  return {content("result.h5"), content("checkpoint.h5"), content("records_1.h5")};
}

/// What a library crashes on is no fault of ours where it is kept in a process of its own.
void read_checkpoint(const std::string& content, const std::string& records, const fs::path& folder) {
  fs::create_directories(folder);
  hostile::set_bytes(folder / "checkpoint.h5", hostile::sealed(content));
  hostile::set_bytes(folder / "records_1.h5", hostile::sealed(records));
  const auto read = [&] {
    const Scene scene = two_spheres();
    simulation::Model model(scene, 1);
    RunResult result;
    simulation::CheckpointFiles(folder, "a scene").load(result, [&](io::StateGroup& state) { model.exchange(state); });
    // What was taken for a state has to be one that a step can be made of, or that is said to be broken.
    try {
      if (model.particles().size() > 0) model.advance(simulation::Surroundings::liquid);
    } catch (const std::runtime_error&) {
    }
  };
  io::read_with_care(folder / input_name, read);
}

}  // namespace

std::vector<Reader> readers() {
  const fs::path scratch = fs::temp_directory_path() / fmt::format("slfb-fuzz-seeds-{}", getpid());
  fs::create_directories(scratch);
  const Written written = written_files(scratch);
  fs::remove_all(scratch);

  const Work& work = peng_2014_work();
  const std::vector<Claim> claims = load_claims(work);
  const std::string scene = text_of("experiments/peng_2014/scenes/6in5W.toml");
  std::vector<Reader> list;
  const auto read_scene = [](const std::string& input, const fs::path&) {
    const NoForeignCode guard;
    (void)parse_scene(input, input_name);
  };
  list.push_back({"scene", {scene, text_of("experiments/scenes/fluidised_box.toml")}, read_scene});
  list.push_back({"overrides",
                  {"contact.stiffness=1e3 N/m", "stage[2].repetitions=5\nspecies[0].count=7", "seed=3"},
                  [scene](const std::string& input, const fs::path&) {
                    const NoForeignCode guard;
                    Overrides overrides;
                    for (std::size_t from = 0; from <= input.size();) {
                      const std::size_t to = std::min(input.find('\n', from), input.size());
                      overrides.push_back(input.substr(from, to - from));
                      from = to + 1;
                    }
                    // Errors of overrides begin with the option.
                    try {
                      (void)parse_scene(scene, input_name, overrides);
                    } catch (const SceneError& error) {
                      if (std::string_view(error.what()).find("--set ") == std::string_view::npos) throw;
                    }
                  }});
  const MeasuredSystems systems = measured_systems(work);
  list.push_back(of_file("measured",
                         {measured_template(claims, systems),
                          "[[series]]\nsystem = \"6in5W\"\nsuperficial_velocity = \"6 cm/s\"\ndrops = [\"a.csv\"]\n"},
                         [claims, systems](const fs::path& file) {
                           const NoForeignCode guard;
                           (void)load_measured(file, claims, systems);
                         }));
  list.push_back(of_file("spheres",
                         {"time [ms],x [m],y [m],z [m],id\n0,0,0,1,1\n1,0,0,2,1\n",
                          "ITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id x y z radius\n1 0 0 1 0.5\n"},
                         [](const fs::path& file) { for_each_frame(file, {}, [](const SphereFrame&) {}); }));
  list.push_back(of_file("claims", {text_of("reference-data/peng_2014/claims.toml")}, [&work](const fs::path& file) {
    (void)load_claims(file, *work.reference, system_names(work));
  }));
  list.push_back(of_file("rules", {text_of("experiments/numerics/plan/rules.toml")},
                         [](const fs::path& file) { (void)plan::load_rules(file); }));
  list.push_back({"profiles",
                  {text_of("experiments/peng_2014/profiles.toml")},
                  [&work](const std::string& input, const fs::path& folder) {
                    Work changed = work;
                    changed.folders.experiments = folder / input_name;
                    fs::create_directories(changed.folders.experiments);
                    write_file(changed.folders.experiments / "profiles.toml", input);
                    for (const std::string& name : profile_names(changed)) (void)load_profile(changed, name);
                  }});
  list.push_back(of_file("values", {text_of("reference-data/peng_2014/statements.toml")}, [](const fs::path& file) {
    ReferenceNumbers numbers("a work");
    numbers.read_values(file);
  }));
  list.push_back(of_file("table", {text_of("reference-data/peng_2014/table2.csv"), "a,b\n1,2\n"},
                         [](const fs::path& file) { (void)read_columns(file, 2); }));
  list.push_back(of_file("noise-study", {text_of("experiments/numerics/pressure_noise/pressure_noise.csv")},
                         [](const fs::path& file) { (void)noise::load_study(file); }));
  list.push_back(of_file("summary", {text_of("reports/published/peng_2014/runs/causes/6in5W_0.06_added-mass.json")},
                         [](const fs::path& file) { (void)load_summary(file); }));
  list.push_back(of_file("json", {"{\"a\": [1, null, \"x\"]}"}, [](const fs::path& file) {
    read_json(file, "a list", [](const nlohmann::ordered_json& json) { return whole_number(json.at("a").at(0)); });
  }));
  list.push_back(of_file("result", {written.result}, [](const fs::path& file) { (void)load_result(file); }));
  list.push_back({"sealed-result", {written.result}, [](const std::string& input, const fs::path& folder) {
                    const fs::path file = folder / input_name;
                    hostile::set_bytes(file, hostile::sealed(input));
                    io::read_with_care(file, [&] { (void)load_result(file); });
                  }});
  list.push_back({"checkpoint",
                  {written.checkpoint},
                  [records = written.records](const std::string& input, const fs::path& folder) {
                    read_checkpoint(input, records, folder / input_name);
                  }});
  return list;
}

std::string fault_of(const Reader& reader, const std::string& input, const fs::path& folder) {
  std::string fault;
  try {
    reader.read(input, folder);
  } catch (const std::runtime_error& error) {
    if (std::string_view(error.what()).find(input_name) == std::string_view::npos)
      fault = fmt::format("an error that does not name its input: {}", error.what());
  } catch (const std::exception& error) {
    fault = fmt::format("an exception that is no std::runtime_error: {}", error.what());
  }
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) fs::remove_all(entry.path(), ignored);
  return fault;
}

}  // namespace slfb::fuzz
