#include "pipeline/evaluate/edge_sharpness.h"

#include "pipeline/evaluate/equal_sizes.h"
#include "pipeline/evaluate/image_metrics.h"

namespace lumi {
namespace {

double gradient_energy(const Image<double>& luma, int x, int y) {
    const double along_x = luma(x + 1, y) - luma(x - 1, y);
    const double along_y = luma(x, y + 1) - luma(x, y - 1);
    return along_x * along_x + along_y * along_y;
}

bool is_covered_around(const GrayImage& coverage, int x, int y) {
    return coverage(x, y) != 0 && coverage(x - 1, y) != 0 && coverage(x + 1, y) != 0 &&
           coverage(x, y - 1) != 0 && coverage(x, y + 1) != 0;
}

}  // namespace

std::optional<double> edge_sharpness(const ColorImage& photograph, const ColorImage& rendering,
                                     const GrayImage& coverage) {
    expect_equal_sizes(photograph, rendering);
    expect_equal_sizes(photograph, coverage);
    const Image<double> truth = luma(photograph);
    const Image<double> drawn = luma(rendering);
    double truth_energy = 0.0;
    double drawn_energy = 0.0;
    for (int y = 1; y + 1 < truth.height(); ++y) {
        for (int x = 1; x + 1 < truth.width(); ++x) {
            if (!is_covered_around(coverage, x, y)) continue;
            truth_energy += gradient_energy(truth, x, y);
            drawn_energy += gradient_energy(drawn, x, y);
        }
    }
    if (truth_energy <= 0.0) return std::nullopt;
    return drawn_energy / truth_energy;
}

}  // namespace lumi
