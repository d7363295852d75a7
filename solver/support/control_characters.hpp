#pragma once

namespace slfb {

/// Whether a byte steers a terminal, as the escape does that begins a command to it: the control characters of ASCII
/// but line feed and tab.
inline bool is_control_character(char letter) {
  const auto code = static_cast<unsigned char>(letter);
  return (code < 0x20 && letter != '\n' && letter != '\t') || code == 0x7f;
}

}  // namespace slfb
