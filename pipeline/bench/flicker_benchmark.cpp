#include "pipeline/bench/flicker_benchmark.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "pipeline/bench/picture_change.h"
#include "render/paths/pose_between.h"
#include "render/renderer/offscreen_renderer.h"

namespace lumi {
namespace {

/// So many pairs of frames are looked at more closely, and the way between them halved so often:
/// what is continuous has changed by a thousandth of what it did.
constexpr std::size_t kPairsLookedAt = 4;
constexpr int kJumpHalvings = 10;

using DrawPicture = std::function<ColorImage(const Eye&)>;

double share_that_changes(const ColorImage& a, const ColorImage& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const Rgb8& p = a.pixels()[i];
        const Rgb8& q = b.pixels()[i];
        const int most = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
        count += most > kSeen_steps ? 1 : 0;
    }
    return static_cast<double>(count) / static_cast<double>(a.pixels().size());
}

/// By how much each change is larger than those before and after.
std::vector<double> spikes_of(const std::vector<double>& changes) {
    std::vector<double> spikes;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        const double before = changes[i > 0 ? i - 1 : i];
        const double after = changes[std::min(i + 1, changes.size() - 1)];
        spikes.push_back(changes[i] - 0.5 * (before + after));
    }
    return spikes;
}

/// The pairs of frames with the largest spikes.
std::vector<std::size_t> pairs_to_look_at(const std::vector<double>& changes) {
    const std::vector<double> spikes = spikes_of(changes);
    std::vector<std::size_t> pairs(changes.size());
    std::iota(pairs.begin(), pairs.end(), std::size_t{0});
    const std::size_t count = std::min(kPairsLookedAt, pairs.size());
    std::partial_sort(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(count),
                      pairs.end(),
                      [&](std::size_t a, std::size_t b) { return spikes[a] > spikes[b]; });
    pairs.resize(count);
    return pairs;
}

Jump jump_between(const Eye& first, const Eye& second, std::size_t frame, const DrawPicture& draw) {
    double begin = 0;
    double end = 1;
    Jump jump{frame, 0.0, 0.0, draw(first), draw(second)};
    for (int i = 0; i < kJumpHalvings; ++i) {
        const double middle = 0.5 * (begin + end);
        ColorImage drawn =
            draw({first.camera, pose_between(first.cam_from_world, second.cam_from_world, middle)});
        if (change(drawn, jump.before) > change(jump.after, drawn)) {
            end = middle;
            jump.after = std::move(drawn);
        } else {
            begin = middle;
            jump.before = std::move(drawn);
        }
    }
    jump.change = change(jump.after, jump.before);
    jump.pixel_share = share_that_changes(jump.after, jump.before);
    return jump;
}

Jump largest_jump(const std::vector<Eye>& path, const std::vector<double>& changes,
                  const DrawPicture& draw) {
    Jump largest;
    for (const std::size_t pair : pairs_to_look_at(changes)) {
        Jump jump = jump_between(path[pair], path[pair + 1], pair + 1, draw);
        if (largest.frame == 0 || jump.change > largest.change) largest = std::move(jump);
    }
    return largest;
}

FlickerFigures measured(const std::string& mode, const std::vector<Eye>& path,
                        const std::vector<ColorImage>& truths, const DrawPicture& draw,
                        Progress& progress) {
    FlickerFigures figures;
    figures.mode = mode;
    progress.begin(mode, path.size());
    ColorImage before = draw(path.front());
    double sum = 0;
    double worst = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        progress.throw_if_interrupted();
        ColorImage now = draw(path[i]);
        figures.changes.push_back(change(now, before));
        if (!truths.empty()) {
            const double unlike = unlike_change(now, before, truths[i], truths[i - 1]);
            sum += unlike;
            worst = std::max(worst, unlike);
        }
        before = std::move(now);
        progress.advance();
    }
    if (!truths.empty()) {
        figures.flicker = sum / static_cast<double>(path.size() - 1);
        figures.worst_flicker = worst;
    }
    figures.jump = largest_jump(path, figures.changes, draw);
    return figures;
}

}  // namespace

std::vector<FlickerFigures> benchmark_flicker(const Lumigraph& lumigraph,
                                              const std::vector<Eye>& path,
                                              const TruePicture& truth, Progress& progress) {
    std::vector<ColorImage> truths;
    if (truth) {
        progress.begin("photographing", path.size());
        for (const Eye& eye : path) {
            progress.throw_if_interrupted();
            truths.push_back(truth(eye));
            progress.advance();
        }
    }
    OffscreenRenderer renderer(lumigraph);
    std::vector<FlickerFigures> all;
    for (const RenderMode mode : all_render_modes()) {
        const RenderOptions options{.mode = mode,
                                    .fade_beyond_capture = lumigraph.drawing.fade_beyond_capture};
        all.push_back(measured(
            name_of(mode), path, truths,
            [&](const Eye& eye) { return renderer.draw(eye, options).color; }, progress));
    }
    if (truth) all.push_back(measured("the scene itself", path, truths, truth, progress));
    return all;
}

}  // namespace lumi
