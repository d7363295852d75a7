#pragma once

#include <functional>
#include <optional>
#include <string>

namespace slfb {

/// Does `work` in a copy of this process and waits for its end: what crashes, or does not end, does so there. Nothing
/// that `work` changes is seen here, and its exceptions count as an end like any other.
/// \param patience after which the copy is ended [s]
/// \return nothing if it came to its end, else how it ended: "ends with signal 11 (Segmentation fault)"
std::optional<std::string> trouble_in_child(const std::function<void()>& work, unsigned patience);

}  // namespace slfb
