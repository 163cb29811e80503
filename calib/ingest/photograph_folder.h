#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/pictures/image_format.h"

namespace lumi {

/// A file that holds a picture by its first bytes.
struct PhotographFile {
    std::string name;  ///< Below the folder, '/' between folders.
    std::filesystem::path path;
    ImageFormat format = ImageFormat::kJpeg;
};

struct PhotographFolder {
    std::vector<PhotographFile> files;  ///< Sorted by name.
    std::vector<LeftOut> left_out;      ///< Pictures by their name that are none of the formats.
};

/// The photographs in `folder` and below. Links are followed, to a folder that was walked before
/// only once; hidden files, whatever neither is nor claims to be a picture, `working_folder` and
/// all that lumi made (made_by_lumi.h) are passed over in silence. `other_folders`, which hold
/// masks or boards, are left out by name (E-INGEST-OWN), unless one is `folder` itself; so are
/// folders that cannot be read. Throws Error (E-INGEST-NOFOLDER).
[[nodiscard]] PhotographFolder list_photographs(
    const std::filesystem::path& folder, const std::filesystem::path& working_folder,
    const std::vector<std::filesystem::path>& other_folders);

}  // namespace lumi
