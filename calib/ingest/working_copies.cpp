#include "calib/ingest/working_copies.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calib/ingest/cut_outs.h"
#include "calib/ingest/duplicates.h"
#include "calib/pictures/image_io.h"
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

/// 000001.png, 000001.png.aBcDeF that an interrupted run left behind, and masks of what was laid
/// over them.
bool is_of_working_copies(const std::string& file_name) {
    if (file_name.starts_with(kOverlayPrefix)) return true;
    const std::size_t digits = std::min(file_name.find_first_not_of("0123456789"), kDigits + 1);
    return digits == kDigits && file_name.compare(kDigits, 4, ".png") == 0;
}

[[noreturn]] void refuse_folder(const fs::path& folder, const std::error_code& status) {
    throw Error(ErrorKind::kBadInput, "E-FILE-WRITE",
                folder.string() + ": cannot write: " + status.message(),
                "check that you may write there");
}

std::string size_text(int width_px, int height_px) {
    return std::to_string(width_px) + "x" + std::to_string(height_px);
}

std::pair<int, int> working_size(const ColorImage& raster, int max_width_px) {
    const int longer = std::max(raster.width(), raster.height());
    if (max_width_px == 0 || longer <= max_width_px) return {raster.width(), raster.height()};
    const double scale = static_cast<double>(max_width_px) / longer;
    const auto scaled = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(scale * side)));
    };
    return {scaled(raster.width()), scaled(raster.height())};
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
    const auto [width_px, height_px] = working_size(raster, options.max_width_px);
    const bool as_it_is = width_px == raster.width() && height_px == raster.height();
    // Never scaled up: a tiny original has a tiny copy.
    if (std::min(width_px, height_px) < options.min_width_px) {
        const std::string size = size_text(raster.width(), raster.height()) + " pixels" +
                                 (as_it_is ? "" : ", scaled to " + size_text(width_px, height_px));
        candidate.left_out = LeftOut{
            name, "E-INGEST-TINY",
            size + "; the shorter side needs at least " + std::to_string(options.min_width_px)};
        return candidate;
    }
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
