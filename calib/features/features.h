#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace lumi {

constexpr int kDescriptorSize = 128;

/// RootSIFT (Arandjelović and Zisserman, CVPR 2012), each of the 128 values times 512 and rounded:
/// the dot product of two descriptors is 512² times the cosine between them. Values above 255,
/// which only a descriptor with almost all its weight in a few bins has, are cut.
using Descriptor = std::array<std::uint8_t, kDescriptorSize>;

struct Keypoint {
    Eigen::Vector2f pixel = Eigen::Vector2f::Zero();  ///< (0.5, 0.5): centre of the first pixel.
    float scale_px = 0;
};

/// The features of one photograph, the largest first.
struct Features {
    std::vector<Keypoint> keypoints;
    std::vector<Descriptor> descriptors;

    [[nodiscard]] std::size_t size() const { return keypoints.size(); }
};

/// A feature of one photograph and a feature of another that look alike.
struct FeatureMatch {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    friend bool operator==(const FeatureMatch&, const FeatureMatch&) = default;
};

}  // namespace lumi
