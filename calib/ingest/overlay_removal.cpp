#include "calib/ingest/overlay_removal.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <tuple>

#include "calib/ingest/own_bars.h"
#include "calib/ingest/working_copies.h"
#include "calib/pictures/image_io.h"
#include "calib/pictures/inpainting.h"
#include "calib/work/formatted.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Rasters are as stored: what a camera prints upright turns in them with the EXIF orientation.
using Raster = std::tuple<int, int, int>;  // Width, height, EXIF orientation.

std::map<Raster, std::vector<Photograph*>> by_raster(std::vector<Photograph>& photographs) {
    std::map<Raster, std::vector<Photograph*>> groups;
    for (Photograph& photograph : photographs) {
        groups[{photograph.width_px, photograph.height_px, photograph.exif_orientation}].push_back(
            &photograph);
    }
    return groups;
}

bool has_bars(const Overlay& overlay, const Photograph& photograph) {
    return overlay.picture.width_px < photograph.width_px ||
           overlay.picture.height_px < photograph.height_px;
}

constexpr std::size_t kFew = 24;  ///< Looked at first; all are only where these show something.

/// At most kFew.
std::vector<Photograph*> few_of(const std::vector<Photograph*>& photographs) {
    const std::size_t count = std::min(kFew, photographs.size());
    std::vector<Photograph*> few;
    for (std::size_t i = 0; i < count; ++i)
        few.push_back(photographs[i * photographs.size() / count]);
    return few;
}

StandingPixels standing_pixels_of(const std::vector<Photograph*>& photographs,
                                  const Progress& progress) {
    StandingPixels standing(photographs.front()->width_px, photographs.front()->height_px);
    for (const Photograph* photograph : photographs) {
        progress.throw_if_interrupted();
        standing.add(read_color_image(photograph->picture_path));
    }
    return standing;
}

bool is_any(const Overlay& overlay, const Photograph& photograph) {
    return has_bars(overlay, photograph) || !overlay.mask.empty();
}

/// What bars have to leave. Where others are judged, copies are smaller than those.
int least_side_px(const IngestOptions& options) {
    return options.judged_width_px ? 1 : options.min_width_px;
}

/// An overlay that two of few lack, though nearly all others have it, is missed.
Overlay overlay_over(const std::vector<Photograph*>& photographs, int min_side_px,
                     const Progress& progress) {
    const Overlay first =
        overlay_of(standing_pixels_of(few_of(photographs), progress), min_side_px);
    if (photographs.size() <= kFew || !is_any(first, *photographs.front())) return first;
    return overlay_of(standing_pixels_of(photographs, progress), min_side_px);
}

/// Of the copy, its part, the mask, and what painting takes.
std::size_t bytes_to_paint(const Photograph& photograph) {
    constexpr std::size_t kBytesPerPixel = 24;
    return kBytesPerPixel * static_cast<std::size_t>(photograph.width_px) *
           static_cast<std::size_t>(photograph.height_px);
}

ImageRectangle whole_of(const Photograph& photograph) {
    return {0, 0, photograph.width_px, photograph.height_px};
}

/// Of photographs of one raster: the whole of it where no bars are, or where they would leave too
/// little.
std::vector<ImageRectangle> pictures_between_own_bars(const std::vector<Photograph*>& photographs,
                                                      int min_side_px, int threads,
                                                      Progress& progress) {
    std::vector<ImageRectangle> pictures(photographs.size());
    parallel_for(
        static_cast<int>(photographs.size()),
        threads_within_memory(bytes_to_paint(*photographs.front()), threads), [&](int i) {
            progress.throw_if_interrupted();
            const auto index = static_cast<std::size_t>(i);
            const Photograph& photograph = *photographs[index];
            pictures[index] = picture_between_own_bars(read_color_image(photograph.picture_path));
            if (std::min(pictures[index].width_px, pictures[index].height_px) < min_side_px)
                pictures[index] = whole_of(photograph);
        });
    return pictures;
}

/// Where nothing may be cut off, the mask lies in the whole raster.
Overlay without_crop(const Overlay& overlay, const Photograph& photograph) {
    Overlay whole{whole_of(photograph), {}, 0.0};
    if (overlay.mask.empty()) return whole;
    const double kept = 1.0 * overlay.mask.width() * overlay.mask.height() /
                        (1.0 * photograph.width_px * photograph.height_px);
    whole.share = kept * overlay.share;
    whole.mask = GrayImage(photograph.width_px, photograph.height_px, 255);
    for (int y = 0; y < overlay.mask.height(); ++y) {
        const std::uint8_t* row = overlay.mask.row(y);
        std::copy(row, row + overlay.mask.width(),
                  whole.mask.row(overlay.picture.top + y) + overlay.picture.left);
    }
    return whole;
}

ColorImage cropped(const ColorImage& picture, const ImageRectangle& to) {
    ColorImage part(to.width_px, to.height_px);
    for (int y = 0; y < to.height_px; ++y) {
        const Rgb8* row = picture.row(to.top + y) + to.left;
        std::copy(row, row + to.width_px, part.row(y));
    }
    return part;
}

void remove_from(Photograph& photograph, const Overlay& overlay) {
    ColorImage picture = cropped(read_color_image(photograph.picture_path), overlay.picture);
    if (!overlay.mask.empty()) paint_from_rim(overlay.mask, picture);
    write_png(photograph.picture_path, picture);
    // Exactly as before where nothing was cut off: a known lens may go by it.
    const auto of_original = [](int original_px, int kept_px, int all_px) {
        return static_cast<int>(std::lround(1.0 * original_px * kept_px / all_px));
    };
    photograph.original_width_px =
        of_original(photograph.original_width_px, picture.width(), photograph.width_px);
    photograph.original_height_px =
        of_original(photograph.original_height_px, picture.height(), photograph.height_px);
    photograph.width_px = picture.width();
    photograph.height_px = picture.height();
}

RemovedOverlay remove_from_all(const std::vector<Photograph*>& photographs, const Overlay& overlay,
                               const fs::path& mask_path, int threads, Progress& progress) {
    const Photograph before = *photographs.front();
    RemovedOverlay removed{static_cast<int>(photographs.size()),
                           static_cast<int>(photographs.size()),
                           before.width_px,
                           before.height_px,
                           overlay.picture,
                           overlay.share,
                           {}};
    if (!overlay.mask.empty()) {
        removed.mask_path = mask_path;
        write_png(mask_path, overlay.mask);
    }
    progress.begin("taking out what was laid over photographs", photographs.size());
    parallel_for(static_cast<int>(photographs.size()),
                 threads_within_memory(bytes_to_paint(before), threads), [&](int i) {
                     progress.throw_if_interrupted();
                     remove_from(*photographs[static_cast<std::size_t>(i)], overlay);
                     progress.advance();
                 });
    return removed;
}

/// Where some photographs of a raster have bars and others have none, cuts off those that two or
/// more have alike.
void cut_own_bars(std::vector<Photograph>& photographs, const IngestOptions& options, int threads,
                  std::vector<RemovedOverlay>& removed, Progress& progress) {
    constexpr std::size_t kFewest = 3;
    for (const auto& [raster, group] : by_raster(photographs)) {
        if (group.size() < kFewest) continue;
        progress.begin("looking for bars beside single photographs", 0);
        const ImageRectangle whole = whole_of(*group.front());
        const auto pictures_of = [&](const std::vector<Photograph*>& some) {
            return pictures_between_own_bars(some, least_side_px(options), threads, progress);
        };
        std::vector<ImageRectangle> pictures = pictures_of(few_of(group));
        if (std::count(pictures.begin(), pictures.end(), whole) == std::ssize(pictures)) continue;
        if (group.size() > kFew) pictures = pictures_of(group);
        std::map<ImageRectangle, std::vector<Photograph*>> alike;
        for (std::size_t i = 0; i < group.size(); ++i) alike[pictures[i]].push_back(group[i]);
        if (!alike.contains(whole)) continue;
        for (const auto& [picture, barred] : alike) {
            if (picture == whole || barred.size() < 2) continue;
            removed.push_back(remove_from_all(barred, {picture, {}, 0.0}, {}, threads, progress));
            removed.back().of_photographs = static_cast<int>(group.size());
        }
    }
}

/// "56 pixels above, 56 below"; empty without bars.
std::string bars_text(const RemovedOverlay& overlay) {
    const ImageRectangle& picture = overlay.picture;
    std::string text;
    const auto add = [&](int pixels, const std::string& where) {
        if (pixels <= 0) return;
        text += (text.empty() ? "" : ", ") + std::to_string(pixels) + " pixels " + where;
    };
    add(picture.top, "above");
    add(overlay.height_px - picture.top - picture.height_px, "below");
    add(picture.left, "to the left");
    add(overlay.width_px - picture.left - picture.width_px, "to the right");
    return text;
}

}  // namespace

std::vector<RemovedOverlay> remove_overlays(std::vector<Photograph>& photographs,
                                            const IngestOptions& options,
                                            const fs::path& copies_folder, int threads,
                                            Progress& progress) {
    std::vector<RemovedOverlay> removed;
    for (const auto& [raster, group] : by_raster(photographs)) {
        if (group.size() < static_cast<std::size_t>(kFewestForOverlay)) continue;
        progress.begin("looking for what was laid over photographs", 0);
        Overlay overlay = overlay_over(group, least_side_px(options), progress);
        if (!options.crop_bars) overlay = without_crop(overlay, *group.front());
        if (!is_any(overlay, *group.front())) continue;
        const fs::path mask_path =
            copies_folder / (kOverlayPrefix + std::to_string(removed.size() + 1) + ".png");
        removed.push_back(remove_from_all(group, overlay, mask_path, threads, progress));
    }
    if (options.crop_bars) cut_own_bars(photographs, options, threads, removed, progress);
    return removed;
}

std::string text_of(const RemovedOverlay& overlay) {
    const std::string bars = bars_text(overlay);
    const std::string size = formatted("%d photographs of %dx%d pixels", overlay.of_photographs,
                                       overlay.width_px, overlay.height_px);
    const std::string leaves_it_in = " ([capture] keep_overlays = true leaves it in)";
    if (overlay.photographs < overlay.of_photographs) {
        return std::to_string(overlay.photographs) + " of " + size + " have bars of one colour, " +
               "which were cut off: " + bars + leaves_it_in;
    }
    std::string text = "something stands still in all of " + size;
    if (!bars.empty()) text += "; bars were cut off: " + bars;
    if (overlay.share > 0) {
        text += formatted(
            "; a stamp, logo, watermark or black corner was painted over: %.1f %% of the picture",
            100 * overlay.share);
    }
    return text + leaves_it_in;
}

}  // namespace lumi
