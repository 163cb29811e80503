#pragma once

#include <string_view>

namespace lumi {

/// The text of a file in this folder, named without ".glsl"; it is compiled into the library.
[[nodiscard]] std::string_view shader_source(std::string_view name);

}  // namespace lumi
