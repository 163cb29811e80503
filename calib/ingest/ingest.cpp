#include "calib/ingest/ingest.h"

#include <algorithm>
#include <utility>

#include "calib/ingest/color_notes.h"
#include "calib/ingest/cut_outs.h"
#include "calib/ingest/duplicates.h"
#include "calib/ingest/exif.h"
#include "calib/ingest/overlay_removal.h"
#include "calib/ingest/photograph_folder.h"
#include "calib/ingest/video.h"
#include "calib/ingest/working_copies.h"
#include "calib/pictures/image_io.h"
#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Why a picture could not be read, in the words of a photographer.
LeftOut left_out_because_of(const Error& error, const PhotographFile& file) {
    std::string detail = error.what();
    if (const std::string prefix = file.path.string() + ": "; detail.starts_with(prefix)) {
        detail.erase(0, prefix.size());
    }
    if (error.code() == "E-IMAGE-TRUNCATED") {
        return {file.name, "E-INGEST-TRUNCATED",
                "the file is damaged or was copied only in part (" + detail + ")"};
    }
    if (error.code() == "E-IMAGE-TOOBIG") return {file.name, "E-INGEST-TOOBIG", detail};
    if (error.code() == "E-IMAGE-FORMAT") {
        return {file.name, "E-INGEST-FORMAT", detail + ": " + error.advice()};
    }
    return {file.name, "E-INGEST-UNREADABLE", detail};
}

Candidate left_out(LeftOut reason) {
    Candidate candidate;
    candidate.left_out = std::move(reason);
    return candidate;
}

void add_exif(const PhotographFile& file, Photograph& photograph) {
    const ExifFacts exif = read_exif(file.path, file.format);
    const ImageSize original{photograph.original_width_px, photograph.original_height_px};
    photograph.exif_orientation = exif.orientation;
    photograph.camera_key = camera_key_of(exif, original);
    if (const auto focal_length_px = focal_length_px_of(exif, original)) {
        photograph.focal_length_px =
            *focal_length_px * photograph.width_px / photograph.original_width_px;
    }
}

Candidate ingest_file(const PhotographFile& file, const IngestOptions& options,
                      const fs::path& copies_folder, std::size_t number) {
    SrgbPicture read;
    try {
        read = read_srgb_picture(file.path);
    } catch (const Error& error) {
        return left_out(left_out_because_of(error, file));
    }
    if (read.conversion.hidden_share == 1) {
        return left_out({file.name, "E-INGEST-HIDDEN",
                         "its alpha channel hides all of it: export it without one"});
    }
    Candidate candidate =
        make_working_copy(read.picture, file.name, options, copies_folder, number);
    candidate.conversion = std::move(read.conversion);
    if (candidate.left_out) return candidate;
    add_exif(file, candidate.photograph);
    if (!read.shown.empty()) write_cut_out(file.name, read.shown, copies_folder);
    return candidate;
}

/// Of the file, the raster and its copies; of the largest photograph. Deep rasters are read into
/// samples as large as their file before they become pictures.
std::size_t bytes_of_one(const std::vector<PhotographFile>& files, int threads) {
    constexpr std::size_t kBytesPerPixel = 12;
    std::vector<std::size_t> bytes(files.size(), 1);
    parallel_for(static_cast<int>(files.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        try {
            const ImageSize size = read_image_size(files[index].path);
            std::error_code ignored;
            bytes[index] = 2 * fs::file_size(files[index].path, ignored) +
                           kBytesPerPixel * static_cast<std::size_t>(std::max(size.width_px, 1)) *
                               static_cast<std::size_t>(std::max(size.height_px, 1));
        } catch (const Error&) {
            // Found again, and reported, when the picture is decoded.
        }
    });
    return bytes.empty() ? 1 : *std::max_element(bytes.begin(), bytes.end());
}

std::vector<Candidate> ingest_folder(const PhotographFolder& folder, const IngestOptions& options,
                                     const fs::path& copies_folder, int threads,
                                     Progress& progress) {
    progress.begin("ingest photographs", folder.files.size());
    std::vector<Candidate> candidates(folder.files.size());
    parallel_for(static_cast<int>(folder.files.size()),
                 threads_within_memory(bytes_of_one(folder.files, threads), threads), [&](int i) {
                     progress.throw_if_interrupted();
                     const auto index = static_cast<std::size_t>(i);
                     candidates[index] =
                         ingest_file(folder.files[index], options, copies_folder, index + 1);
                     progress.advance();
                 });
    return candidates;
}

std::string advice_for_more(const IngestOptions& options, bool is_video) {
    if (is_video) {
        return "film longer, or raise [capture] video_fps (" +
               formatted("%.3g", options.video_fps) + " frames a second are kept)";
    }
    return "give a folder with more photographs of the scene (" + std::string(kImageFormats) + ")";
}

void refuse_too_few(const IngestResult& result, const IngestOptions& options,
                    const fs::path& source, bool is_video) {
    if (static_cast<int>(result.photographs.size()) >= options.min_photographs) return;
    std::string what =
        source.string() + ": " +
        counted(result.photographs.size(), is_video ? "usable frame" : "usable photograph") +
        ", expected at least " + std::to_string(options.min_photographs);
    constexpr std::size_t kMaxNamed = 5;
    for (std::size_t i = 0; i < std::min(kMaxNamed, result.left_out.size()); ++i) {
        what += "; " + result.left_out[i].name + ": " + result.left_out[i].reason;
    }
    throw Error(ErrorKind::kBadInput, "E-INGEST-TOOFEW", what, advice_for_more(options, is_video));
}

}  // namespace

std::vector<std::string> names_of(const std::vector<Photograph>& photographs) {
    std::vector<std::string> names;
    for (const Photograph& photograph : photographs) names.push_back(photograph.name);
    return names;
}

IngestResult ingest(const fs::path& photographs_or_video, const IngestOptions& options,
                    const fs::path& copies_folder, int threads, Progress& progress) {
    validate(options);
    IngestResult result;
    std::vector<Candidate> candidates;
    std::error_code status;
    const bool is_video = fs::is_regular_file(photographs_or_video, status);
    if (is_video) {
        clear_working_copies(copies_folder);
        candidates = ingest_video(photographs_or_video, options, copies_folder, progress);
    } else {
        PhotographFolder folder = list_photographs(
            photographs_or_video, options.workspace.empty() ? copies_folder : options.workspace,
            options.other_folders);
        result.left_out = std::move(folder.left_out);
        clear_working_copies(copies_folder);
        candidates = ingest_folder(folder, options, copies_folder, threads, progress);
    }
    leave_out_duplicates(candidates);
    for (const Candidate& candidate : candidates) {
        if (candidate.left_out) result.left_out.push_back(*candidate.left_out);
    }
    std::stable_sort(result.left_out.begin(), result.left_out.end(),
                     [](const LeftOut& a, const LeftOut& b) { return a.name < b.name; });
    result.color_notes = color_notes(candidates);
    result.photographs = number_working_copies(candidates, copies_folder);
    refuse_too_few(result, options, photographs_or_video, is_video);
    complete_cut_outs(result.photographs, copies_folder);
    if (!options.keep_overlays) {
        IngestOptions removal = options;
        removal.crop_bars &= cut_out_folder(copies_folder).empty();
        result.overlays =
            remove_overlays(result.photographs, removal, copies_folder, threads, progress);
    }
    return result;
}

}  // namespace lumi
