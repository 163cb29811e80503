#include "pipeline/bench/rival_pictures.h"

#include "calib/ingest/made_by_lumi.h"
#include "calib/pictures/image_io.h"
#include "pipeline/text/hyphenated.h"

namespace lumi {
namespace {

constexpr const char* kFrame = "frame-";

bool is_rival_picture(const std::string& file_name) {
    return is_mark_of_lumi(file_name) ||
           (file_name.starts_with(kFrame) && file_name.ends_with(".png"));
}

}  // namespace

RivalPictureFiles::RivalPictureFiles(const std::filesystem::path& folder,
                                     const std::vector<std::string>& scenes) {
    for (const std::string& scene : scenes)
        expect_only_files_of_ours(folder / scene, is_rival_picture);
    for (const std::string& scene : scenes) {
        const auto& [entry, is_new] = folder_of_scene_.try_emplace(scene, folder / scene);
        // It may lie among photographs, and these pictures are none.
        if (is_new) mark_as_made_by_lumi(entry->second.staging());
    }
}

void RivalPictureFiles::write(const RivalPicture& picture) {
    const std::string name =
        kFrame + std::to_string(picture.index + 1) + '.' + hyphenated(picture.method) + ".png";
    write_png(folder_of_scene_.at(picture.scene).staging() / name, picture.picture);
}

void RivalPictureFiles::put_in_place() {
    for (auto& [scene, folder] : folder_of_scene_) folder.put_in_place();
}

}  // namespace lumi
