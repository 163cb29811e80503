#include "calib/capture/colmap_model.h"

#include "calib/capture/colmap_binary.h"
#include "calib/capture/colmap_ids.h"
#include "calib/capture/colmap_text.h"
#include "calib/work/error.h"

namespace lumi {

Capture read_colmap_model(const std::filesystem::path& folder) {
    const auto has = [&](const char* file) { return std::filesystem::exists(folder / file); };
    if (has("cameras.bin") && has("images.bin")) {
        return capture_from_records(read_colmap_binary(folder), folder.string());
    }
    if (has("cameras.txt") && has("images.txt")) {
        return capture_from_records(read_colmap_text(folder), folder.string());
    }
    throw Error(ErrorKind::kBadInput, "E-COLMAP-MODEL",
                folder.string() + ": expected cameras and images as .bin or .txt",
                "give the folder that holds cameras.bin, images.bin and points3D.bin");
}

}  // namespace lumi
