#include "pipeline/commands/frame_files.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "meshing/surface/file_ending.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Nobody calls a folder so.
constexpr std::array<const char*, 7> kOtherVideos{".avi", ".gif", ".m4v", ".mkv",
                                                  ".mov", ".mpg", ".webm"};

}  // namespace

std::string sequence_frame_name(std::size_t index) {
    char name[32];
    std::snprintf(name, sizeof(name), "frame-%06zu.png", index + 1);
    return name;
}

bool is_sequence_frame_name(const std::string& name) {
    std::size_t number = 0;
    return std::sscanf(name.c_str(), "frame-%zu.png", &number) == 1 && number > 0 &&
           name == sequence_frame_name(number - 1);
}

bool names_video(const fs::path& out) { return lower_case_ending(out) == ".mp4"; }

fs::path frames_folder_of_video(const fs::path& video) { return video.string() + ".frames"; }

void check_picture_out(const fs::path& out, const std::string& option) {
    if (lower_case_ending(out) != ".png")
        throw Error(ErrorKind::kUsage, "E-RENDER-OUT", out.string() + ": pictures are PNG files",
                    "let " + option + " end in .png");
    require_writable_file(out);
}

void check_frames_folder(const fs::path& out) {
    std::error_code status;
    if (fs::exists(out, status) && !fs::is_directory(out, status))
        refuse_loss(out, "is there already and is not a folder");
    require_writable_folder(out);
}

void check_path_out(const fs::path& out) {
    if (names_video(out)) {
        expect_only_files_of_ours(frames_folder_of_video(out), is_sequence_frame_name);
        return require_writable_file(out);
    }
    const std::string extension = lower_case_ending(out);
    if (std::find(kOtherVideos.begin(), kOtherVideos.end(), extension) != kOtherVideos.end())
        throw Error(ErrorKind::kUsage, "E-RENDER-OUT", out.string() + ": videos are MP4 files",
                    "let --out end in .mp4, or name a folder for PNG files");
    expect_only_files_of_ours(out, is_sequence_frame_name);
    require_writable_whole_folder(out);
}

}  // namespace lumi
