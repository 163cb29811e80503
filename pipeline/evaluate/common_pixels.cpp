#include "pipeline/evaluate/common_pixels.h"

#include <vector>

#include "calib/work/mean.h"
#include "pipeline/evaluate/image_metrics.h"

namespace lumi {

void CommonPixels::add(const ComparedMethod& method, const std::string& view,
                       const ColorImage& truth, const Frame& frame) {
    const auto [found, is_new] = views_.try_emplace(view);
    View& of_view = found->second;
    if (is_new) {
        of_view.truth = truth;
        of_view.common = GrayImage(truth.width(), truth.height(), 255);
    }
    of_view.drawn[method.name] = frame.color;
    if (!method.has_say) return;
    for (std::size_t i = 0; i < of_view.common.pixels().size(); ++i)
        if (frame.coverage.pixels()[i] == 0) of_view.common.pixels()[i] = 0;
}

std::optional<double> CommonPixels::psnr_db(const std::string& method,
                                            const std::string& view) const {
    const View& of_view = views_.at(view);
    return lumi::psnr_db(of_view.drawn.at(method), of_view.truth, of_view.common);
}

std::optional<double> CommonPixels::mean_psnr_db(const std::string& method) const {
    std::vector<double> values;
    for (const auto& [view, of_view] : views_)
        if (const auto value = psnr_db(method, view)) values.push_back(*value);
    return values.empty() ? std::nullopt : std::optional(mean_of(values));
}

double CommonPixels::share() const {
    std::vector<double> shares;
    for (const auto& [view, of_view] : views_) shares.push_back(covered_share(of_view.common));
    return mean_of(shares);
}

bool covers_by_depth(RenderMode mode) {
    return mode != RenderMode::kLightField && mode != RenderMode::kHeigl;
}

Frame filled(Frame frame, const ColorImage& surroundings) {
    for (std::size_t i = 0; i < surroundings.pixels().size(); ++i)
        if (frame.coverage.pixels()[i] == 0) frame.color.pixels()[i] = surroundings.pixels()[i];
    return frame;
}

}  // namespace lumi
