#include "calib/ingest/cut_outs.h"

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

}  // namespace

void write_cut_out(const std::string& name, const GrayImage& shown, const fs::path& copies_folder) {
    write_png(file_of(name, copies_folder), shown);
}

void complete_cut_outs(const std::vector<Photograph>& photographs, const fs::path& copies_folder) {
    std::set<fs::path> wanted;
    std::vector<const Photograph*> opaque;
    for (const Photograph& photograph : photographs) {
        const fs::path file = file_of(photograph.name, copies_folder);
        wanted.insert(file);
        if (!fs::exists(file)) opaque.push_back(&photograph);
    }
    if (opaque.size() == photographs.size()) return clear_cut_outs(copies_folder);
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
