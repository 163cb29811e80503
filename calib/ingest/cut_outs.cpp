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

/// Whether any count in the middle half of the picture is not 0.
bool is_any_in_the_middle(const Image<std::uint32_t>& counts) {
    for (int y = counts.height() / 4; y < counts.height() - counts.height() / 4; ++y) {
        const std::uint32_t* row = counts.row(y);
        if (std::any_of(row + counts.width() / 4, row + counts.width() - counts.width() / 4,
                        [](std::uint32_t count) { return count > 0; }))
            return true;
    }
    return false;
}

/// What straightening a lens leaves: a little of the rim, no more than this share, and the same in
/// all photographs.
bool is_left_by_straightening(const PhotographsOfSize& photographs, double most_share) {
    constexpr double kSame = 0.9;
    const Image<std::uint32_t> counts = hidden_in(photographs.masks);
    const auto hidden_px = [&](std::size_t least) {
        return static_cast<double>(
            std::count_if(counts.pixels().begin(), counts.pixels().end(),
                          [&](std::uint32_t count) { return count >= least; }));
    };
    return hidden_px(photographs.count) >= kSame * hidden_px(1) &&
           hidden_px(1) <= most_share * static_cast<double>(counts.pixels().size()) &&
           !is_any_in_the_middle(counts);
}

using PhotographsBySize = std::map<std::pair<int, int>, PhotographsOfSize>;

/// Whether what is hidden is around a subject. Of a photograph of its own size no other tells
/// whether they hide the same; but where most are, they were cropped to what they show, while
/// straightening leaves them the size of their camera.
bool are_outlines(const PhotographsBySize& by_size) {
    constexpr double kLittle = 0.3;
    constexpr double kVeryLittle = 0.05;
    std::size_t all = 0;
    std::size_t alone = 0;
    for (const auto& [size, photographs] : by_size) {
        all += photographs.count;
        if (photographs.count == 1) ++alone;
    }
    const bool are_cropped = 2 * alone > all;
    return std::any_of(by_size.begin(), by_size.end(), [&](const auto& entry) {
        const bool is_cropped = are_cropped && entry.second.count == 1;
        return !is_left_by_straightening(entry.second, is_cropped ? kVeryLittle : kLittle);
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
