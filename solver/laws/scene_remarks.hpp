#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.hpp"

namespace slfb {

/// What a user should know of a valid scene before it runs, a sentence each: times that are rounded to whole liquid
/// steps, and a drag law of the suite that will be asked outside the range that it states for itself (of the bed packed
/// at a voidage of 0.4 and of a dropped sphere alone at its terminal velocity). Runs no code from a file.
std::vector<std::string> remarks_on(const Scene& scene);

}  // namespace slfb
