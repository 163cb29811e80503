#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace lumi {

/// What finding depth takes at most at one time, in bytes.
struct DepthMemory {
    std::uint64_t in_use = 0;     ///< By the process, before.
    std::uint64_t choosing = 0;   ///< On top of it, while "auto" predicts photographs; else 0.
    std::uint64_t matching = 0;   ///< On top of it, while photographs are compared.
    std::uint64_t finishing = 0;  ///< And while maps are confirmed and filled.
    int views_tried = 1;          ///< At one time, while "auto" predicts photographs.
    int views_matched = 1;        ///< At one time.
    int views_filled = 1;

    [[nodiscard]] std::uint64_t peak() const {
        return in_use + std::max({choosing, matching, finishing});
    }
};

/// Predicted from the pixels of each depth map and the model ("auto": what it may take at most). As
/// many views are worked on at one time as `threads` and `budget` bytes for the whole process
/// allow, and at least one. How finely each pixel is searched is known only afterwards, and taken
/// as photographs of walls, statues and rooms had it on average. `max_neighbours`: what a view is
/// compared with, by which "auto" predicts a photograph.
[[nodiscard]] DepthMemory predicted_depth_memory(const std::vector<std::uint64_t>& map_pixels,
                                                 const std::string& model, int threads,
                                                 std::uint64_t budget, std::uint64_t in_use,
                                                 int max_neighbours);

/// What "auto" takes once it is known what it chose: `before` is its prediction as "auto",
/// `predicted_photographs`: whether it had to, or the points told enough.
[[nodiscard]] DepthMemory predicted_memory_of_choice(const DepthMemory& before,
                                                     const std::vector<std::uint64_t>& map_pixels,
                                                     const std::string& chosen,
                                                     bool predicted_photographs, int threads,
                                                     std::uint64_t budget);

/// Throws Error (E-DEPTH-MEMORY) when the machine has less left than the prediction wants on top of
/// what is in use. `available`: as from memory_available().
void require_memory(const DepthMemory& predicted, std::uint64_t available);

}  // namespace lumi
