// A state by name: parts keep their own names, and a field that is missing is named.
#include "solver/support/named_fields.hpp"

#include <gtest/gtest.h>

namespace slfb {
namespace {

TEST(NamedFields, PartsComeBackUnderTheirOwnNames) {
  const NamedFields forces{{"slip_x", {1.0, 2.0}}, {"slip_y", {}}};
  NamedFields state{{"liquid_volume", {3.0}}};
  add_part(state, "forces", forces);
  EXPECT_EQ(field_of(state, "forces/slip_x"), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(part_of(state, "forces"), forces);
  EXPECT_TRUE(part_of(state, "force").empty());
}

TEST(NamedFields, AMissingFieldIsNamed) {
  const NamedFields state{{"pressure", {0.0}}};
  try {
    field_of(state, "velocity_x");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("velocity_x"), std::string::npos);
  }
}

}  // namespace
}  // namespace slfb
