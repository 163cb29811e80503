#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "calib/work/whole_folder.h"
#include "pipeline/bench/rival_measurement.h"

namespace lumi {

/// What methods draw at held-out places, as files: SCENE/frame-N.METHOD.png, N from 1, so that the
/// pictures of one place stand beside each other. Each scene's folder is written whole or not at
/// all, and replaces that of an earlier run.
class RivalPictureFiles {
 public:
    /// Throws Error (E-OUT-EXISTS): other files lie in a scene's folder. E-FILE-WRITE.
    RivalPictureFiles(const std::filesystem::path& folder, const std::vector<std::string>& scenes);

    /// Of one of the scenes.
    void write(const RivalPicture& picture);
    void put_in_place();

 private:
    std::map<std::string, WholeFolder> folder_of_scene_;
};

}  // namespace lumi
