#include "calib/ingest/cut_outs.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <system_error>

#include "calib/pictures/image_io.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

fs::path folder_in(const fs::path& copies_folder) { return copies_folder / "cut-outs"; }

/// With the photograph's own extension before its own: two may differ in nothing else.
fs::path file_of(const std::string& name, const fs::path& copies_folder) {
    return folder_in(copies_folder) / (name + ".png");
}

/// Of masks of one size, that of the first.
bool all_hide_the_same(const std::vector<fs::path>& files) {
    Image<std::size_t> hiding;
    std::size_t masks = 0;
    for (const fs::path& file : files) {
        const GrayImage mask = read_gray_png(file);
        if (masks == 0) hiding = Image<std::size_t>(mask.width(), mask.height(), 0);
        if (mask.width() != hiding.width() || mask.height() != hiding.height()) continue;
        ++masks;
        for (std::size_t i = 0; i < mask.pixels().size(); ++i)
            if (mask.pixels()[i] == 0) ++hiding.pixels()[i];
    }
    const auto hidden = [&](std::size_t least) {
        return std::count_if(hiding.pixels().begin(), hiding.pixels().end(),
                             [&](std::size_t count) { return count >= least; });
    };
    constexpr double kSame = 0.9;
    return static_cast<double>(hidden(masks)) >= kSame * static_cast<double>(hidden(1));
}

}  // namespace

void write_cut_out(const std::string& name, const GrayImage& shown, const fs::path& copies_folder) {
    write_png(file_of(name, copies_folder), shown);
}

void complete_cut_outs(const std::vector<Photograph>& photographs, const fs::path& copies_folder) {
    std::set<fs::path> wanted;
    std::vector<const Photograph*> opaque;
    std::vector<fs::path> cut_out;
    for (const Photograph& photograph : photographs) {
        const fs::path file = file_of(photograph.name, copies_folder);
        wanted.insert(file);
        if (fs::exists(file)) {
            cut_out.push_back(file);
        } else {
            opaque.push_back(&photograph);
        }
    }
    if (cut_out.empty() || all_hide_the_same(cut_out)) return clear_cut_outs(copies_folder);
    std::error_code status;
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
