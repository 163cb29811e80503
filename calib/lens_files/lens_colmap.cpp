#include "calib/capture/colmap_text.h"
#include "calib/lens_files/lens_readers.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

[[noreturn]] void refuse(const std::string& what_and_where) {
    throw Error(ErrorKind::kBadInput, "E-LENS-FILE", what_and_where,
                "give a cameras.txt of COLMAP with one camera: CAMERA_ID MODEL WIDTH HEIGHT "
                "PARAMETERS");
}

std::map<std::uint32_t, Camera> cameras_in(const std::filesystem::path& path) {
    try {
        return read_colmap_cameras(path);
    } catch (const Error& error) {
        if (error.code() != "E-COLMAP-MODEL") throw;
        refuse(error.what());
    }
}

}  // namespace

Camera read_lens_colmap(const std::filesystem::path& path) {
    const std::map<std::uint32_t, Camera> cameras = cameras_in(path);
    if (cameras.size() != 1) {
        refuse(path.string() + ": expected one camera, found " + std::to_string(cameras.size()));
    }
    validate(cameras.begin()->second, path.string());
    return cameras.begin()->second;
}

}  // namespace lumi
