#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plumbline {

/// RFC 4648, with padding.
std::string encode_base64(std::string_view bytes);

/// Blanks are skipped; several padded pieces one after the other are joined, as VTK writes them.
/// Empty if `text` has any other character, or does not end with a whole group of four.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace plumbline
