#include "calib/known_poses/known_poses.h"

#include <algorithm>
#include <fstream>

#include "calib/capture/colmap_model.h"
#include "calib/known_poses/middlebury_par.h"
#include "calib/known_poses/poses_bounds.h"
#include "calib/known_poses/strecha_camera.h"
#include "calib/known_poses/transforms_json.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStrechaEnding = ".camera";
constexpr const char* kMiddleburyEnding = "_par.txt";

[[noreturn]] void refuse_format(const fs::path& path, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-IMPORT-FORMAT", path.string() + ": " + what,
                "give a COLMAP model folder, transforms.json, poses_bounds.npy, a Middlebury "
                "*_par.txt, a .camera file or a folder of them");
}

std::vector<fs::path> sorted_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

KnownPoses read_colmap(const fs::path& folder) {
    Capture capture = read_colmap_model(folder);
    KnownPoses known;
    known.format = "COLMAP model";
    for (const Camera& camera : capture.cameras) {
        known.lenses.push_back({camera, std::nullopt});
    }
    known.views = std::move(capture.views);
    known.points = std::move(capture.points);
    return known;
}

KnownPoses read_strecha_files(const std::vector<fs::path>& files) {
    KnownPoses known;
    known.format = "Strecha .camera files";
    for (const fs::path& file : files) {
        if (file.extension() != kStrechaEnding) continue;
        const StrechaCamera camera = read_strecha_camera(file);
        known.views.push_back({file.stem().string(),
                               index_of_lens(known.lenses, {camera.camera, std::nullopt}),
                               camera.cam_from_world});
    }
    return known;
}

bool is_single_file_of_poses(const fs::path& file) {
    const std::string name = file.filename().string();
    return name == "transforms.json" || name == "poses_bounds.npy" ||
           name.ends_with(kMiddleburyEnding);
}

KnownPoses read_folder(const fs::path& folder) {
    const std::vector<fs::path> files = sorted_files(folder);
    const auto has = [&](const char* name) { return fs::exists(folder / name); };
    if ((has("cameras.bin") && has("images.bin")) || (has("cameras.txt") && has("images.txt"))) {
        return read_colmap(folder);
    }
    if (std::any_of(files.begin(), files.end(),
                    [](const fs::path& file) { return file.extension() == kStrechaEnding; })) {
        return read_strecha_files(files);
    }
    if (std::count_if(files.begin(), files.end(), is_single_file_of_poses) == 1) {
        return read_known_poses(*std::find_if(files.begin(), files.end(), is_single_file_of_poses));
    }
    refuse_format(folder, "holds no poses in a known format, or more than one");
}

}  // namespace

KnownPoses read_known_poses(const fs::path& path) {
    if (fs::is_directory(path)) return read_folder(path);
    if (!fs::is_regular_file(path)) refuse_format(path, "no such file or folder");
    std::ifstream stream(path, std::ios::binary);
    std::string beginning(256, '\0');
    stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    beginning.resize(static_cast<std::size_t>(stream.gcount()));
    // It begins with a digit, too, but each file is one view.
    if (path.extension() == kStrechaEnding) return read_strecha_files({path});
    if (beginning.starts_with("\x93NUMPY")) return read_poses_bounds(path);
    const std::string_view text = without_byte_order_mark(beginning);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first != std::string_view::npos && text[first] == '{') return read_transforms_json(path);
    if (first != std::string_view::npos && std::isdigit(static_cast<unsigned char>(text[first]))) {
        return read_middlebury_par(path);
    }
    refuse_format(path, "not a file of poses in a known format");
}

int index_of_lens(std::vector<KnownLens>& lenses, const KnownLens& lens) {
    const auto same = std::find(lenses.begin(), lenses.end(), lens);
    const auto index = static_cast<int>(same - lenses.begin());
    if (same == lenses.end()) lenses.push_back(lens);
    return index;
}

}  // namespace lumi
