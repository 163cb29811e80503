#include "calib/ingest/working_copies.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calib/ingest/cut_outs.h"
#include "calib/ingest/duplicates.h"
#include "calib/pictures/image_io.h"
#include "calib/pictures/lost_color.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDigits = 6;

fs::path copy_path(const fs::path& folder, std::size_t number) {
    char name[32];
    std::snprintf(name, sizeof(name), "%06zu.png", number);
    return folder / name;
}

/// 000001.png, and masks of what was laid over such copies.
bool is_of_working_copies(const std::string& file_name) {
    return file_name.starts_with(kOverlayPrefix) ||
           (file_name.find_first_not_of("0123456789") == kDigits &&
            file_name.substr(kDigits) == ".png");
}

[[noreturn]] void refuse_folder(const fs::path& folder, const std::error_code& status) {
    throw Error(ErrorKind::kBadInput, "E-FILE-WRITE",
                folder.string() + ": cannot write: " + status.message(),
                "check that you may write there");
}

std::string size_text(ImageSize size) {
    return std::to_string(size.width_px) + "x" + std::to_string(size.height_px);
}

ImageSize working_size(ImageSize original, int max_width_px) {
    const int longer = std::max(original.width_px, original.height_px);
    if (max_width_px == 0 || longer <= max_width_px) return original;
    const double scale = static_cast<double>(max_width_px) / longer;
    const auto scaled = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(scale * side)));
    };
    return {scaled(original.width_px), scaled(original.height_px)};
}

/// Why a photograph of this size is left out: the shorter side of the copy that it is judged by is
/// tiny. None where it is not.
std::optional<LeftOut> left_out_as_tiny(const std::string& name, ImageSize original,
                                        const IngestOptions& options) {
    const ImageSize copy =
        working_size(original, options.judged_width_px.value_or(options.max_width_px));
    // Never scaled up: a tiny original has a tiny copy.
    if (std::min(copy.width_px, copy.height_px) >= options.min_width_px) return std::nullopt;
    const bool is_scaled =
        copy.width_px != original.width_px || copy.height_px != original.height_px;
    return LeftOut{name, "E-INGEST-TINY",
                   size_text(original) + " pixels" +
                       (is_scaled ? ", scaled to " + size_text(copy) : "") +
                       "; the shorter side needs at least " + std::to_string(options.min_width_px)};
}

}  // namespace

int threads_within_memory(std::size_t bytes_of_photograph, int threads) {
    constexpr std::size_t kBudgetBytes = std::size_t{2} << 30;
    const std::size_t affordable = std::max<std::size_t>(1, kBudgetBytes / bytes_of_photograph);
    return static_cast<int>(
        std::min(static_cast<std::size_t>(resolve_threads(threads)), affordable));
}

void clear_working_copies(const fs::path& folder) {
    std::error_code status;
    fs::create_directories(folder, status);
    if (status) refuse_folder(folder, status);
    clear_cut_outs(folder);
    std::vector<fs::path> stale;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (is_of_working_copies(entry.path().filename().string())) stale.push_back(entry.path());
    }
    for (const fs::path& path : stale) {
        fs::remove(path, status);
        if (status) refuse_folder(folder, status);
    }
}

Candidate make_working_copy(const ColorImage& raster, const std::string& name,
                            const IngestOptions& options, const fs::path& folder,
                            std::size_t number) {
    Candidate candidate;
    const ImageSize original{raster.width(), raster.height()};
    candidate.left_out = left_out_as_tiny(name, original, options);
    if (candidate.left_out) return candidate;
    const auto [width_px, height_px] = working_size(original, options.max_width_px);
    const bool as_it_is = width_px == raster.width() && height_px == raster.height();
    Photograph& photograph = candidate.photograph;
    photograph.name = name;
    photograph.picture_path = copy_path(folder, number);
    photograph.width_px = width_px;
    photograph.height_px = height_px;
    photograph.original_width_px = raster.width();
    photograph.original_height_px = raster.height();
    candidate.pixels_sha256 = pixels_sha256(raster);
    const ColorImage scaled = as_it_is ? ColorImage() : resized(raster, width_px, height_px);
    const ColorImage& copy = as_it_is ? raster : scaled;
    candidate.thumbnail = thumbnail_of(copy);
    candidate.has_color = has_color(copy);
    write_png(photograph.picture_path, copy);
    return candidate;
}

std::vector<Photograph> number_working_copies(const std::vector<Candidate>& candidates,
                                              const fs::path& folder) {
    std::vector<Photograph> photographs;
    std::error_code status;
    for (const Candidate& candidate : candidates) {
        const fs::path& provisional = candidate.photograph.picture_path;
        if (candidate.left_out) {
            if (!provisional.empty()) fs::remove(provisional, status);
            continue;
        }
        // Numbers only become smaller, so no copy lands on one that is still to be renamed.
        photographs.push_back(candidate.photograph);
        photographs.back().picture_path = copy_path(folder, photographs.size());
        fs::rename(provisional, photographs.back().picture_path, status);
        if (status) refuse_folder(folder, status);
    }
    return photographs;
}

}  // namespace lumi
