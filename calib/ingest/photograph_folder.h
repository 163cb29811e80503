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
/// only once; hidden files and whatever neither is nor claims to be a picture are passed over in
/// silence. So is the outermost that lumi made (made_by_lumi.h) of the folders around
/// `working_folder`, or where there is none that folder alone, should it lie inside, and others of
/// lumi's beside that one. Elsewhere these and `other_folders`, which hold masks or boards, are
/// left out by name (E-INGEST-OWN), unless one of the latter is `folder` itself. Folders that
/// cannot be read are left out, too. Throws Error (E-INGEST-NOFOLDER).
[[nodiscard]] PhotographFolder list_photographs(
    const std::filesystem::path& folder, const std::filesystem::path& working_folder,
    const std::vector<std::filesystem::path>& other_folders);

}  // namespace lumi
