#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace lumi {

/// The number of triangles with errors relaxed so much; nothing where they are more than `most`.
using TrianglesAt = std::function<std::optional<std::size_t>(double relaxation, std::size_t most)>;

/// The factor, 1 to 1024, by which errors are to be relaxed so that there are at most `most`
/// triangles (0: any number). It is the last one for which `triangles_at` gave a number.
///
/// Relaxations are powers of the fourth root of two. Most pictures need none, and the search begins
/// with it. Where that leaves too many, it goes up in growing steps until they are few enough, then
/// down to where their number, taken to fall as a power of the error, would be as many as may be;
/// it ends as soon as nearly that many are used. Where even the largest relaxation leaves more,
/// they are drawn.
[[nodiscard]] double least_relaxation(std::size_t most, const TrianglesAt& triangles_at);

}  // namespace lumi
