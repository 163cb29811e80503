#include "calib/ingest/cut_outs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "calib/pictures/image_io.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

fs::path folder_in(const fs::path& copies_folder) { return copies_folder / "cut-outs"; }

/// With the photograph's own extension before its own: two may differ in nothing else.
fs::path file_of(const std::string& name, const fs::path& copies_folder) {
    return folder_in(copies_folder) / (name + ".png");
}

struct PhotographsOfSize {
    std::size_t count = 0;
    std::vector<fs::path> masks;  ///< Of those with an alpha channel.
};

/// How many of the masks, all of one size, hide each pixel; empty where there is none.
Image<std::uint32_t> hidden_in(const std::vector<fs::path>& masks) {
    Image<std::uint32_t> counts;
    for (const fs::path& file : masks) {
        const GrayImage mask = read_gray_png(file);
        if (counts.empty()) counts = {mask.width(), mask.height()};
        for (std::size_t i = 0; i < mask.pixels().size(); ++i)
            if (mask.pixels()[i] == 0) ++counts.pixels()[i];
    }
    return counts;
}

/// The share of what lies within a border, as wide as this share of either side, that any of the
/// masks hides.
double share_hidden_within(double border_share, const Image<std::uint32_t>& counts) {
    const int left = static_cast<int>(border_share * counts.width());
    const int top = static_cast<int>(border_share * counts.height());
    std::ptrdiff_t hidden_px = 0;
    for (int y = top; y < counts.height() - top; ++y) {
        const std::uint32_t* row = counts.row(y);
        hidden_px += std::count_if(row + left, row + counts.width() - left,
                                   [](std::uint32_t count) { return count > 0; });
    }
    const int all_px = (counts.width() - 2 * left) * (counts.height() - 2 * top);
    return static_cast<double>(hidden_px) / std::max(1, all_px);
}

/// What straightening a lens leaves: a little of the rim, and the same in all photographs.
bool is_left_by_straightening(const PhotographsOfSize& photographs) {
    constexpr double kLittle = 0.3;
    constexpr double kSame = 0.9;
    const Image<std::uint32_t> counts = hidden_in(photographs.masks);
    const auto hidden_in_all = static_cast<double>(
        std::count_if(counts.pixels().begin(), counts.pixels().end(),
                      [&](std::uint32_t count) { return count >= photographs.count; }));
    const double hidden_share = share_hidden_within(0, counts);
    return hidden_in_all >= kSame * hidden_share * static_cast<double>(counts.pixels().size()) &&
           hidden_share <= kLittle && share_hidden_within(0.25, counts) == 0;
}

/// Of a photograph of its own size no other tells whether they hide the same. But a rim hides
/// hardly anything farther inside, while around a subject that a picture was cropped to, corners
/// are hidden.
bool is_left_along_the_rim(const PhotographsOfSize& photographs) {
    constexpr double kRim = 0.1;
    constexpr double kHardlyAnything = 0.01;
    return is_left_by_straightening(photographs) &&
           share_hidden_within(kRim, hidden_in(photographs.masks)) <= kHardlyAnything;
}

using PhotographsBySize = std::map<std::pair<int, int>, PhotographsOfSize>;

/// Whether what is hidden is around a subject. Where most photographs have a size of their own,
/// they were cropped to what they show.
bool are_outlines(const PhotographsBySize& by_size) {
    std::size_t all = 0;
    std::size_t alone = 0;
    for (const auto& [size, photographs] : by_size) {
        all += photographs.count;
        if (photographs.count == 1) ++alone;
    }
    const bool are_cropped = 2 * alone > all;
    return std::any_of(by_size.begin(), by_size.end(), [&](const auto& entry) {
        const bool is_cropped = are_cropped && entry.second.count == 1;
        return !(is_cropped ? is_left_along_the_rim(entry.second)
                            : is_left_by_straightening(entry.second));
    });
}

}  // namespace

void write_cut_out(const std::string& name, const GrayImage& shown, const fs::path& copies_folder) {
    write_png(file_of(name, copies_folder), shown);
}

void complete_cut_outs(const std::vector<Photograph>& photographs, const fs::path& copies_folder) {
    std::set<fs::path> wanted;
    std::vector<const Photograph*> opaque;
    PhotographsBySize by_size;
    std::error_code status;
    for (const Photograph& photograph : photographs) {
        const fs::path file = file_of(photograph.name, copies_folder);
        wanted.insert(file);
        PhotographsOfSize& alike =
            by_size[{photograph.original_width_px, photograph.original_height_px}];
        ++alike.count;
        if (fs::exists(file, status)) {
            alike.masks.push_back(file);
        } else {
            opaque.push_back(&photograph);
        }
    }
    if (!are_outlines(by_size)) return clear_cut_outs(copies_folder);
    std::vector<fs::path> stale;
    for (const auto& entry : fs::recursive_directory_iterator(folder_in(copies_folder)))
        if (entry.is_regular_file() && !wanted.contains(entry.path()))
            stale.push_back(entry.path());
    for (const fs::path& path : stale) fs::remove(path, status);
    for (const Photograph* photograph : opaque)
        write_cut_out(photograph->name, GrayImage(photograph->width_px, photograph->height_px, 255),
                      copies_folder);
}

void clear_cut_outs(const fs::path& copies_folder) {
    std::error_code status;
    fs::remove_all(folder_in(copies_folder), status);
}

fs::path cut_out_folder(const fs::path& copies_folder) {
    std::error_code status;
    const fs::path folder = folder_in(copies_folder);
    return fs::is_directory(folder, status) ? folder : fs::path();
}

}  // namespace lumi
