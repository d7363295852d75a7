#include "solver/run/drop_protocol.hpp"

#include <limits>

namespace slfb::simulation {

void DropProtocol::begin() {
  repetition_ = 0;
  falling_ = false;
  phase_steps_ = relaxation_steps();  // as if after a drop
}

void DropProtocol::count_step() {
  ++phase_steps_;
  if (!falling_ && phase_steps_ == relaxation_steps()) ++repetition_;
}

bool DropProtocol::release_is_due() const { return !falling_ && phase_steps_ >= relaxation_steps() && !finished(); }

bool DropProtocol::waited_too_long() const {
  return phase_steps_ - relaxation_steps() >= schedule_.steps_in(schedule_.stage().duration);
}

void DropProtocol::released() {
  falling_ = true;
  phase_steps_ = 0;
}

void DropProtocol::taken_out() {
  falling_ = false;
  phase_steps_ = 0;
}

void DropProtocol::exchange(io::StateGroup& group) {
  constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();
  group.value("repetition", repetition_, 0, any);
  group.value("falling", falling_);
  group.value("phase_steps", phase_steps_, 0, any);
}

}  // namespace slfb::simulation
