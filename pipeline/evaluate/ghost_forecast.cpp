#include "pipeline/evaluate/ghost_forecast.h"

#include "pipeline/evaluate/image_metrics.h"
#include "pipeline/evaluate/rank_correlation.h"

namespace lumi {
namespace {

/// Sums over a block.
struct Block {
    double ghost_energy = 0.0;
    double squared_error = 0.0;
};

/// Empty when a pixel of the block is not covered.
std::optional<Block> block_at(const FloatImage& ghost_energy, const Image<double>& truth,
                              const Image<double>& drawn, const GrayImage& coverage, int left,
                              int top) {
    Block block;
    for (int y = top; y < top + kGhostBlockPx; ++y) {
        for (int x = left; x < left + kGhostBlockPx; ++x) {
            if (coverage(x, y) == 0) return std::nullopt;
            const double error = truth(x, y) - drawn(x, y);
            block.squared_error += error * error;
            block.ghost_energy += static_cast<double>(ghost_energy(x, y));
        }
    }
    return block;
}

}  // namespace

void GhostForecast::add(const FloatImage& ghost_energy, const ColorImage& photograph,
                        const Frame& rendering) {
    const Image<double> truth = luma(photograph);
    const Image<double> drawn = luma(rendering.color);
    Block sum;
    int count = 0;
    for (int top = 0; top + kGhostBlockPx <= truth.height(); top += kGhostBlockPx) {
        for (int left = 0; left + kGhostBlockPx <= truth.width(); left += kGhostBlockPx) {
            const auto block = block_at(ghost_energy, truth, drawn, rendering.coverage, left, top);
            if (!block) continue;
            blocks_.energies.push_back(block->ghost_energy);
            blocks_.errors.push_back(block->squared_error);
            sum.ghost_energy += block->ghost_energy;
            sum.squared_error += block->squared_error;
            ++count;
        }
    }
    if (count == 0) return;
    views_.energies.push_back(sum.ghost_energy / count);
    views_.errors.push_back(sum.squared_error / count);
}

std::optional<double> GhostForecast::between_blocks() const {
    return rank_correlation(blocks_.energies, blocks_.errors);
}

std::optional<double> GhostForecast::between_views() const {
    return rank_correlation(views_.energies, views_.errors);
}

}  // namespace lumi
