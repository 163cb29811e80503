#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/ingest/overlay.h"
#include "calib/work/config_section.h"
#include "calib/work/progress.h"

namespace lumi {

/// What is accepted as a photograph, and how large the working copies are.
struct IngestOptions {
    int max_width_px = 1600;  ///< Longer sides are scaled down to this. 0: as they are.
    int min_width_px = 64;    ///< Shorter sides of copies below this are "tiny". > 0.
    /// As max_width_px, of the copies that are asked whether they are tiny; none: of these.
    std::optional<int> judged_width_px = {};
    int min_photographs = 2;  ///< Fewer than this left over: E-INGEST-TOOFEW.
    double video_fps = 2.0;   ///< Frames taken from each second of a video. > 0.
    /// Whether what was laid over photographs (overlay.h, own_bars.h) is left in them.
    bool keep_overlays = false;
    /// Whether bars beside the picture are cut off: not where something was made for the raster
    /// with them, as known poses, a calibrated lens or masks.
    /// Photographs that are cut out keep them in any case.
    bool crop_bars = true;
    /// Of masks, boards or depth maps: no photographs, should they lie among these.
    std::vector<std::filesystem::path> other_folders = {};
    /// In which nothing is a photograph, though nothing marks it yet; empty: that of the copies.
    std::filesystem::path workspace = {};
};

void validate(const IngestOptions& options);
[[nodiscard]] IngestOptions read_ingest_options(const ConfigSection& section);

/// A photograph as the rest of the line sees it.
///
/// The raster is as stored (the EXIF orientation is kept here and applied by nobody but a display).
struct Photograph {
    std::string name;                    ///< Below the photographs' folder, '/' between folders.
    std::filesystem::path picture_path;  ///< The working copy: 8-bit sRGB PNG.
    int width_px = 0;                    ///< Of the working copy.
    int height_px = 0;
    int original_width_px = 0;  ///< Of what the copy shows, before it was scaled.
    int original_height_px = 0;
    int exif_orientation = 1;               ///< 1 to 8.
    std::optional<double> focal_length_px;  ///< From EXIF, for the working copy.
    std::string camera_key;  ///< Photographs of one camera and zoom have equal keys (size, make,
                             ///< model, focal length).
};

/// In their order.
[[nodiscard]] std::vector<std::string> names_of(const std::vector<Photograph>& photographs);

/// What was taken out of working copies of one size.
struct RemovedOverlay {
    int photographs = 0;
    int of_photographs = 0;  ///< Of that size; all, where something stands still in them.
    int width_px = 0;        ///< Of the copies before.
    int height_px = 0;
    ImageRectangle picture;  ///< What of them was kept.
    double share = 0.0;      ///< Of `picture` that was painted over; 0: nothing.
    /// Beside the copies, in the raster of `picture`: 0 where it was; empty: nothing was.
    std::filesystem::path mask_path;
};

struct IngestResult {
    std::vector<Photograph> photographs;  ///< Sorted by name.
    std::vector<LeftOut> left_out;
    std::vector<RemovedOverlay> overlays;
    std::vector<std::string> color_notes;  ///< Sentences (color_notes.h).
};

/// Reads a folder of photographs (JPEG, PNG, TIFF, HEIF, WebP by content; sub-folders too) or one
/// video file, and writes canonical working copies `000001.png ...` into `copies_folder`; those of
/// an earlier run are removed. What is unreadable, truncated, tiny, the same picture as another, or
/// taken from the very place of the one before is left out with a reason, and the work goes on.
/// Other numbers than 8-bit sRGB are converted (image_io.h). Where an alpha channel cuts out
/// photographs, masks lie beside the copies (cut_outs.h). What was laid over photographs is
/// taken out of the copies (overlay_removal.h). Throws Error: E-INGEST-NOFOLDER, E-INGEST-NOVIDEO,
/// E-INGEST-TOOFEW.
[[nodiscard]] IngestResult ingest(const std::filesystem::path& photographs_or_video,
                                  const IngestOptions& options,
                                  const std::filesystem::path& copies_folder, int threads,
                                  Progress& progress);

}  // namespace lumi
