#include "pipeline/bench/rival_measurement.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "calib/work/mean.h"
#include "pipeline/bench/picture_change.h"
#include "pipeline/evaluate/image_metrics.h"
#include "render/surroundings/surroundings.h"

namespace lumi {
namespace {

constexpr int kGrossError = 51;      // A fifth of the range.
constexpr int kSilhouette_px = 2;    // Around which pixels may show either surface.
constexpr double kDepthStep = 0.03;  // Share of the inverse depth that makes a silhouette.

bool is_by_a_silhouette(const FloatImage& z, int x, int y) {
    float nearest = 0;
    float farthest = 1e30F;
    for (int row = y - kSilhouette_px; row <= y + kSilhouette_px; ++row) {
        for (int column = x - kSilhouette_px; column <= x + kSilhouette_px; ++column) {
            if (!z.contains(column, row)) continue;
            const float q = z(column, row) > 0 ? 1 / z(column, row) : 0.0F;
            nearest = std::max(nearest, q);
            farthest = std::min(farthest, q);
        }
    }
    return static_cast<double>(nearest - farthest) > kDepthStep * static_cast<double>(nearest);
}

/// Numbers of pixels.
struct WrongLayers {
    long covered = 0;
    long wrong = 0;
    long avoidable = 0;  ///< Where some photograph shows what is there.
};

void count_wrong_layers(const Frame& drawn, const TrueFrame& truth, WrongLayers& counts) {
    for (int y = 0; y < truth.picture.height(); ++y) {
        for (int x = 0; x < truth.picture.width(); ++x) {
            if (drawn.coverage(x, y) == 0) continue;
            ++counts.covered;
            const Rgb8& a = drawn.color(x, y);
            const Rgb8& b = truth.picture(x, y);
            const int error =
                std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
            if (error <= kGrossError || is_by_a_silhouette(truth.depth, x, y)) continue;
            ++counts.wrong;
            if (truth.shown(x, y) != 0) ++counts.avoidable;
        }
    }
}

std::optional<double> share_of_covered(long pixels, const WrongLayers& counts) {
    if (counts.covered == 0) return std::nullopt;
    return static_cast<double>(pixels) / static_cast<double>(counts.covered);
}

std::vector<ColorImage> surroundings_of(const std::vector<TrueFrame>& frames,
                                        const Lumigraph& lumigraph) {
    std::vector<ColorImage> pictures;
    for (const TrueFrame& frame : frames)
        pictures.push_back(surroundings_picture(lumigraph, frame.eye));
    return pictures;
}

std::string key_of(const std::string& method, const std::string& settings) {
    return method + ", " + settings;
}

std::optional<double> mean_of_covered(const std::vector<RivalFrameFigures>& frames) {
    std::vector<double> values;
    for (const RivalFrameFigures& frame : frames)
        if (frame.psnr_covered_db) values.push_back(*frame.psnr_covered_db);
    return values.empty() ? std::nullopt : std::optional(mean_of(values));
}

}  // namespace

RivalMeasurement::RivalMeasurement(const RivalCapture& capture, RivalPictureSink keep)
    : capture_(capture),
      keep_(std::move(keep)),
      held_out_surroundings_(surroundings_of(capture.held_out, capture.lumigraph)),
      off_cameras_surroundings_(surroundings_of(capture.off_cameras, capture.lumigraph)),
      path_surroundings_(surroundings_of(capture.path, capture.lumigraph)) {
    for (std::size_t i = 0; i < capture.held_out.size(); ++i)
        keep_({capture.name, "photograph", i, capture.held_out[i].picture});
}

RivalFigures RivalMeasurement::measured(const RivalMethod& method, const DrawFrame& draw) {
    RivalFigures figures;
    figures.method = method.method;
    figures.settings = method.settings;
    figures.pictures = method.pictures;
    const auto count = static_cast<double>(capture_.held_out.size());
    WrongLayers wrong_layers;
    for (std::size_t i = 0; i < capture_.held_out.size(); ++i) {
        const TrueFrame& truth = capture_.held_out[i];
        const Frame as_drawn = draw(truth.eye);
        keep_({capture_.name, key_of(method.method, method.settings), i, as_drawn.color});
        const Frame drawn = filled(as_drawn, held_out_surroundings_[i]);
        common_.add({key_of(method.method, method.settings), method.has_say}, std::to_string(i),
                    truth.picture, drawn);
        const RivalFrameFigures frame{psnr_db(drawn.color, truth.picture),
                                      psnr_db(as_drawn.color, truth.picture),
                                      psnr_db(drawn.color, truth.picture, drawn.coverage),
                                      {},
                                      covered_share(drawn.coverage)};
        figures.psnr_db += frame.psnr_db / count;
        figures.psnr_as_drawn_db += frame.psnr_as_drawn_db / count;
        figures.coverage += frame.coverage / count;
        figures.covered_frames += frame.psnr_covered_db ? 1 : 0;
        count_wrong_layers(drawn, truth, wrong_layers);
        figures.frames.push_back(frame);
    }
    figures.psnr_covered_db = mean_of_covered(figures.frames);
    figures.wrong_layer_share = share_of_covered(wrong_layers.wrong, wrong_layers);
    figures.avoidable_wrong_layer_share = share_of_covered(wrong_layers.avoidable, wrong_layers);
    figures.off_cameras = off_cameras_of(method, draw);
    if (capture_.path.size() > 1) figures.flicker = flicker_of(draw);
    return figures;
}

OffCamerasFigures RivalMeasurement::off_cameras_of(const RivalMethod& method,
                                                   const DrawFrame& draw) {
    OffCamerasFigures figures;
    std::vector<double> covered_db;
    std::vector<double> coverages;
    for (std::size_t i = 0; i < capture_.off_cameras.size(); ++i) {
        const TrueFrame& truth = capture_.off_cameras[i];
        const Frame drawn = filled(draw(truth.eye), off_cameras_surroundings_[i]);
        off_cameras_common_.add({key_of(method.method, method.settings), method.has_say},
                                std::to_string(i), truth.picture, drawn);
        if (const auto db = psnr_db(drawn.color, truth.picture, drawn.coverage))
            covered_db.push_back(*db);
        coverages.push_back(covered_share(drawn.coverage));
    }
    if (!covered_db.empty()) figures.psnr_covered_db = mean_of(covered_db);
    figures.coverage = mean_of(coverages);
    return figures;
}

double RivalMeasurement::flicker_of(const DrawFrame& draw) const {
    const auto drawn_at = [&](std::size_t i) {
        return filled(draw(capture_.path[i].eye), path_surroundings_[i]).color;
    };
    ColorImage before = drawn_at(0);
    double flicker = 0;
    for (std::size_t i = 1; i < capture_.path.size(); ++i) {
        ColorImage now = drawn_at(i);
        flicker +=
            unlike_change(now, before, capture_.path[i].picture, capture_.path[i - 1].picture);
        before = std::move(now);
    }
    return flicker / static_cast<double>(capture_.path.size() - 1);
}

void RivalMeasurement::measure_common_pixels(std::vector<RivalFigures>& rivals) const {
    for (RivalFigures& rival : rivals) {
        const std::string key = key_of(rival.method, rival.settings);
        for (std::size_t i = 0; i < rival.frames.size(); ++i)
            rival.frames[i].psnr_common_db = common_.psnr_db(key, std::to_string(i));
        rival.psnr_common_db = common_.mean_psnr_db(key);
        rival.off_cameras.psnr_common_db = off_cameras_common_.mean_psnr_db(key);
    }
}

}  // namespace lumi
