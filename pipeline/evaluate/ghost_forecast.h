#pragma once

#include <optional>
#include <vector>

#include "calib/capture/image.h"
#include "render/frame/frame.h"

namespace lumi {

constexpr int kGhostBlockPx = 16;

/// How well ghost energy, which needs no truth, foretells the error where the truth is known:
/// Spearman's rank correlation of its mean with the mean squared luma error.
class GhostForecast {
 public:
    /// One held-out view; blocks that are not covered throughout do not count.
    void add(const FloatImage& ghost_energy, const ColorImage& photograph, const Frame& rendering);

    /// Over blocks of kGhostBlockPx x kGhostBlockPx pixels of all views.
    [[nodiscard]] std::optional<double> between_blocks() const;
    /// Over the means of views.
    [[nodiscard]] std::optional<double> between_views() const;

 private:
    /// Pairs of ghost energy and squared error.
    struct Pairs {
        std::vector<double> energies;
        std::vector<double> errors;
    };
    Pairs blocks_;
    Pairs views_;
};

}  // namespace lumi
