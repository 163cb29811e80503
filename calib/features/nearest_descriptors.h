#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "calib/features/features.h"

namespace lumi {

/// The two descriptors of another photograph that are most similar to one of this, by dot product.
/// Of equally similar ones the first in order is the best. 0 stands for "none".
struct NearestDescriptors {
    std::uint32_t best = 0;    ///< Dot product with the best.
    std::uint32_t second = 0;  ///< Dot product with the second best.
    std::uint32_t index = 0;   ///< Of the best.
    friend bool operator==(const NearestDescriptors&, const NearestDescriptors&) = default;
};

struct NearestBothWays {
    std::vector<NearestDescriptors> of_first;   ///< One per descriptor of the first photograph.
    std::vector<NearestDescriptors> of_second;  ///< One per descriptor of the second.
};

/// What the comparison is made with; the result is the same for all.
enum class DescriptorInstructions { kPortable, kAvx2, kAvx512Vnni };

[[nodiscard]] std::string_view name_of(DescriptorInstructions instructions);
/// Those that this machine has, the fastest last.
[[nodiscard]] std::vector<DescriptorInstructions> descriptor_instructions_here();

/// Compares all descriptors of two photographs with one another, in exact integer arithmetic: the
/// product of the two matrices is taken once, and serves both directions. Throws
/// std::invalid_argument for a descriptor whose squared length is 2^19 or more (RootSIFT's is
/// 2^18 up to rounding), and for instructions that the machine does not have.
[[nodiscard]] NearestBothWays nearest_descriptors(std::span<const Descriptor> first,
                                                  std::span<const Descriptor> second,
                                                  DescriptorInstructions instructions);

}  // namespace lumi
