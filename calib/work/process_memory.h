#pragma once

#include <cstdint>
#include <optional>

namespace lumi {

/// Memory of this process and of the machine, in bytes; empty where the system does not tell.
[[nodiscard]] std::optional<std::uint64_t> memory_in_use();  ///< Resident now.
[[nodiscard]] std::optional<std::uint64_t> peak_memory();    ///< Resident at most so far.
[[nodiscard]] std::optional<std::uint64_t>
memory_available();  ///< What the machine can still give.

/// As many pieces of work as may go on at one time so that they, each with so many bytes, stay
/// within a budget beside what is kept: at least one, at most `most`.
[[nodiscard]] int pieces_within(double budget, double kept, double per_piece, int most);

/// Gives back to the system what was freed.
void release_free_memory();

/// From now on, what is freed in pieces of 8 MiB or more goes back to the system at once, and no
/// more than that is kept of the rest. Otherwise the peak depends on the order of what came before.
void keep_little_free_memory();

/// From now on, up to 256 MiB of what is freed are kept, for work that takes as much again and
/// again: software OpenGL takes and frees megabytes for each frame, and to get them from the system
/// page by page costs a frame of many triangles up to a tenth of its time.
void keep_free_memory();

/// Begins `peak_memory` anew with what is in use now. False where the system does not allow it.
[[nodiscard]] bool forget_peak_memory();

}  // namespace lumi
