#include "pipeline/commands/frame_files.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include "calib/ingest/made_by_lumi.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "meshing/surface/file_ending.h"
#include "pipeline/stages/file_stems.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Nobody calls a folder so.
constexpr std::array<const char*, 7> kOtherVideos{".avi", ".gif", ".m4v", ".mkv",
                                                  ".mov", ".mpg", ".webm"};

bool is_of_a_sequence(const std::string& name) {
    return is_sequence_frame_name(name) || is_mark_of_lumi(name);
}

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

std::vector<fs::path> frames_of_views(const fs::path& folder, const std::vector<std::string>& views,
                                      const std::string& kind,
                                      const std::vector<std::string>& photographs) {
    std::set<fs::path> of_photographs;
    for (const std::string& name : photographs) of_photographs.insert(fs::path(name).filename());
    std::vector<fs::path> frames;
    for (const std::string& stem : file_stems_without_dots(views)) {
        frames.push_back(folder / (stem + '.' + kind + ".png"));
        std::error_code status;
        const fs::file_type there = fs::symlink_status(frames.back(), status).type();
        if (there == fs::file_type::not_found) continue;
        if (there != fs::file_type::regular) refuse_loss(frames.back(), "is there already");
        if (of_photographs.contains(frames.back().filename()))
            refuse_loss(frames.back(), "is named like a photograph of the capture");
    }
    return frames;
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
        expect_only_files_of_ours(frames_folder_of_video(out), is_of_a_sequence);
        return require_writable_file(out);
    }
    const std::string extension = lower_case_ending(out);
    if (std::find(kOtherVideos.begin(), kOtherVideos.end(), extension) != kOtherVideos.end())
        throw Error(ErrorKind::kUsage, "E-RENDER-OUT", out.string() + ": videos are MP4 files",
                    "let --out end in .mp4, or name a folder for PNG files");
    expect_only_files_of_ours(out, is_of_a_sequence);
    require_writable_whole_folder(out);
}

}  // namespace lumi
