// A state is written and read back by name: nothing may be missing, unknown or of another length.
#include "solver/io/state_group.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/io/hdf5_file.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb::io {
namespace {

class StateGroupTest : public testing::Test {
 protected:
  void write(const StateGroup::Exchange& exchange) {
    Hdf5File target = Hdf5File::create(file());
    write_state(target, exchange);
    target.close();
  }
  void read(const StateGroup::Exchange& exchange) { read_state(Hdf5File::open(file()), exchange); }
  /// What reading fails with.
  std::string failure(const StateGroup::Exchange& exchange) {
    try {
      read(exchange);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "state.h5"; }

 private:
  Folder folder_;
};

struct Clock {
  std::int64_t steps = 0;
  double sum = 0.0;
  bool running = false;
  std::vector<double> heights;
  std::vector<std::int64_t> counts;

  void exchange(StateGroup& group) {
    group.value("steps", steps);
    group.part("sums", [&](StateGroup& sums) { sums.value("force", sum, "N"); });
    group.value("running", running);
    group.values("heights", heights, "m", 3);
    group.values("counts", counts);
  }
};

StateGroup::Exchange as_part(Clock& clock) {
  return [&](StateGroup& state) { state.part("clock", [&](StateGroup& group) { clock.exchange(group); }); };
}

TEST_F(StateGroupTest, OneListWritesAndReadsTheSameState) {
  Clock written{-7, 0.1, true, {1.0, -1e-300, 1e300}, {}}, read_back;
  write(as_part(written));
  read(as_part(read_back));
  EXPECT_EQ(read_back.steps, written.steps);
  EXPECT_EQ(read_back.sum, written.sum);
  EXPECT_EQ(read_back.running, written.running);
  EXPECT_EQ(read_back.heights, written.heights);
  EXPECT_EQ(read_back.counts, written.counts);
  EXPECT_EQ(Hdf5File::open(file()).read_string_attribute("clock/sums/force", "unit"), "N");
}

TEST_F(StateGroupTest, AMissingNameIsNamed) {
  std::int64_t steps = 3, stage = 0;
  write([&](StateGroup& state) { state.part("clock", [&](StateGroup& group) { group.value("steps", steps); }); });
  const std::string message = failure([&](StateGroup& state) {
    state.part("clock", [&](StateGroup& group) {
      group.value("steps", steps);
      group.value("stage", stage);
    });
  });
  EXPECT_NE(message.find(file().string()), std::string::npos) << message;
  EXPECT_NE(message.find("\"clock/stage\" is missing"), std::string::npos) << message;
}

TEST_F(StateGroupTest, AnUnknownNameIsNamed) {
  std::int64_t steps = 3, stage = 1;
  const auto both = [&](StateGroup& group) {
    group.value("steps", steps);
    group.value("stage", stage);
  };
  write([&](StateGroup& state) { state.part("clock", both); });
  const auto one = [&](StateGroup& group) { group.value("steps", steps); };
  EXPECT_NE(failure([&](StateGroup& state) { state.part("clock", one); }).find("\"clock/stage\" is not a name"),
            std::string::npos);
  EXPECT_NE(failure([](StateGroup&) {}).find("\"clock\" is not a name"), std::string::npos);
}

TEST_F(StateGroupTest, AWrongLengthIsNamed) {
  std::vector<double> heights{1.0, 2.0};
  write([&](StateGroup& state) { state.values("heights", heights); });
  const std::string message = failure([&](StateGroup& state) { state.values("heights", heights, "m", 3); });
  EXPECT_NE(message.find("\"heights\" has 2 values instead of 3"), std::string::npos) << message;
  double height = 0.0;
  EXPECT_NE(failure([&](StateGroup& state) { state.value("heights", height); }).find("instead of 1"),
            std::string::npos);
}

TEST_F(StateGroupTest, FieldsKeepTheNamesOfTheirParts) {
  const NamedFields fields{{"pressure", {1.0, 2.0}}, {"interval/steps", {3.0}}, {"empty", {}}};
  write([&](StateGroup& state) { state.part("liquid", [&](StateGroup& group) { group.write_fields(fields); }); });
  NamedFields read_back;
  read([&](StateGroup& state) { state.part("liquid", [&](StateGroup& group) { read_back = group.read_fields(); }); });
  EXPECT_EQ(read_back, fields);
}

}  // namespace
}  // namespace slfb::io
