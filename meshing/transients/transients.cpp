#include "meshing/transients/transients.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "calib/work/parallel_for.h"
#include "meshing/transients/counterparts.h"
#include "meshing/transients/unlike_others.h"

namespace lumi {
namespace {

/// As OpenCV sees it: the same pixels.
cv::Mat matrix_of(GrayImage& image) {
    return {image.height(), image.width(), CV_8U, image.pixels().data()};
}

cv::Mat disc(int radius_px) {
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * radius_px + 1, 2 * radius_px + 1});
}

/// Lines along outlines and texture, where surfaces lie a pixel off, are no patches.
GrayImage without_lines(GrayImage mask) {
    const int radius_px = std::max(1, mask.width() / 400);
    const cv::Mat matrix = matrix_of(mask);
    cv::morphologyEx(matrix, matrix, cv::MORPH_CLOSE, disc(1));
    cv::morphologyEx(matrix, matrix, cv::MORPH_OPEN, disc(radius_px));
    return mask;
}

/// Connected pixels.
struct Patch {
    std::vector<std::pair<int, int>> pixels;
};

std::vector<Patch> patches_of(GrayImage mask) {
    cv::Mat labels;
    const int count = cv::connectedComponents(matrix_of(mask), labels, 8, CV_32S);
    std::vector<Patch> patches(static_cast<std::size_t>(count));
    for (int y = 0; y < labels.rows; ++y) {
        for (int x = 0; x < labels.cols; ++x) {
            const int label = labels.at<int>(y, x);
            if (label > 0) patches[static_cast<std::size_t>(label)].pixels.emplace_back(x, y);
        }
    }
    return patches;
}

/// How much of a patch may stand still.
double standing_share(const Patch& patch, const DepthMap& agreed,
                      const Counterparts& counterparts) {
    constexpr std::size_t kSamples = 200;
    const std::size_t samples = std::min(kSamples, patch.pixels.size());
    std::size_t standing = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        const auto& [x, y] = patch.pixels[i * patch.pixels.size() / samples];
        if (counterparts.has(x, y, static_cast<double>(agreed.inverse_depth(x, y)))) ++standing;
    }
    return static_cast<double>(standing) / static_cast<double>(samples);
}

/// Of pixels of a patch and those to their right, how many lie on two surfaces. What is known of a
/// surface that hides itself comes from views that see through it, and alternates from pixel to
/// pixel.
double torn_share(const Patch& patch, const DepthMap& agreed, float thickness) {
    std::size_t pairs = 0;
    std::size_t torn = 0;
    for (const auto& [x, y] : patch.pixels) {
        if (x + 1 >= agreed.confidence.width()) continue;
        if (agreed.confidence(x, y) == 0 || agreed.confidence(x + 1, y) == 0) continue;
        ++pairs;
        const float step = agreed.inverse_depth(x + 1, y) - agreed.inverse_depth(x, y);
        if (std::abs(step) > thickness) ++torn;
    }
    return pairs == 0 ? 1.0 : static_cast<double>(torn) / static_cast<double>(pairs);
}

/// 255 from this level on, else 0.
GrayImage from_level(std::uint8_t level, GrayImage unlike) {
    for (std::uint8_t& pixel : unlike.pixels()) pixel = pixel >= level ? 255 : 0;
    return unlike;
}

void mark(const Patch& patch, GrayImage& mask) {
    for (const auto& [x, y] : patch.pixels) mask(x, y) = 255;
}

/// Patches that certainly are transients; and where there are any, those that may be parts of
/// them. Empty without any.
GrayImage certain_transients(const OthersAgree& others, float thickness,
                             const Counterparts& counterparts) {
    constexpr double kMostTorn = 0.1;
    constexpr double kMostByChance = 0.07;
    constexpr double kMostOfParts = 0.4;
    if (others.is_unlike.empty()) return {};
    const double least =
        kLeastTransientShare * static_cast<double>(others.is_unlike.pixels().size());
    GrayImage marked(others.is_unlike.width(), others.is_unlike.height());
    bool is_any_certain = false;
    const GrayImage unlike = from_level(OthersAgree::kUnlike, others.is_unlike);
    for (const Patch& patch : patches_of(without_lines(unlike))) {
        if (static_cast<double>(patch.pixels.size()) < least) continue;
        if (torn_share(patch, others.agreed, thickness) > kMostTorn) continue;
        const double standing = standing_share(patch, others.agreed, counterparts);
        if (standing > kMostOfParts) continue;
        mark(patch, marked);
        is_any_certain = is_any_certain || standing <= kMostByChance;
    }
    return is_any_certain ? marked : GrayImage{};
}

/// With the pixels around them that may be theirs, where a third of such a patch is certain.
GrayImage grown(const GrayImage& certain, const GrayImage& unlike) {
    constexpr std::size_t kMostGrowth = 3;
    GrayImage transients = certain;
    const GrayImage possible = from_level(OthersAgree::kPerhapsUnlike, unlike);
    for (const Patch& patch : patches_of(without_lines(possible))) {
        const auto seeds = static_cast<std::size_t>(std::count_if(
            patch.pixels.begin(), patch.pixels.end(),
            [&](const auto& pixel) { return certain(pixel.first, pixel.second) != 0; }));
        if (seeds > 0 && patch.pixels.size() <= kMostGrowth * seeds) mark(patch, transients);
    }
    return transients;
}

bool reaches_border(const Patch& patch, const GrayImage& mask) {
    return std::any_of(patch.pixels.begin(), patch.pixels.end(), [&](const auto& pixel) {
        return pixel.first == 0 || pixel.second == 0 || pixel.first == mask.width() - 1 ||
               pixel.second == mask.height() - 1;
    });
}

/// With what transients enclose, where that is no more than they are: nobody knows what lies
/// behind it, or it has the same colour.
void fill_holes(GrayImage& transients) {
    GrayImage rest = transients;
    for (std::uint8_t& pixel : rest.pixels()) pixel = pixel == 0 ? 255 : 0;
    const auto kept = static_cast<std::size_t>(
        std::count(rest.pixels().begin(), rest.pixels().end(), std::uint8_t{0}));
    for (const Patch& patch : patches_of(rest)) {
        if (patch.pixels.size() <= kept && !reaches_border(patch, rest)) mark(patch, transients);
    }
}

/// Where something is in the colours of what it hides, and along its rim, too.
GrayImage with_gaps_and_rim(GrayImage transients) {
    const int reach_px = std::max(2, transients.width() / 100);
    const int rim_px = std::max(1, transients.width() / 250);
    const cv::Mat matrix = matrix_of(transients);
    cv::morphologyEx(matrix, matrix, cv::MORPH_CLOSE, disc(reach_px));
    fill_holes(transients);
    cv::dilate(matrix, matrix, disc(rim_px));
    return transients;
}

}  // namespace

std::vector<GrayImage> transients_of(const std::vector<KnownView>& views, int threads,
                                     Progress& progress) {
    std::vector<std::vector<Witness>> witnesses(views.size());
    std::vector<OthersAgree> others(views.size());
    std::vector<PatchColors> colors(views.size());
    progress.begin("looking for what moved between photographs", 2 * views.size());
    parallel_for(static_cast<int>(views.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(i);
        if (!views[index].picture.empty()) {
            witnesses[index] = witnesses_of(views, i);
            others[index] = others_agree(views, witnesses[index], i);
            colors[index] =
                patch_colors(from_level(OthersAgree::kPerhapsUnlike, others[index].is_unlike),
                             views[index].picture);
        }
        progress.advance();
    });
    std::vector<GrayImage> transients(views.size());
    parallel_for(static_cast<int>(views.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(i);
        const Counterparts counterparts(views, colors, witnesses[index], i);
        const auto thickness = static_cast<float>(2 / views[index].disparity_px_per_inverse_depth);
        const GrayImage certain = certain_transients(others[index], thickness, counterparts);
        if (!certain.empty()) {
            transients[index] = with_gaps_and_rim(grown(certain, others[index].is_unlike));
        }
        progress.advance();
    });
    return transients;
}

}  // namespace lumi
