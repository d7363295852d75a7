#pragma once

#include "reports/report_contents.hpp"

namespace slfb {

/// This program, this machine and the packages that the suite is built on, as they are installed now. What cannot be
/// found out is left empty.
reports::Certificate certificate();

}  // namespace slfb
