#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace lumi {

/// The name of frame `index` of a sequence, from 0: frame-000001.png.
[[nodiscard]] std::string sequence_frame_name(std::size_t index);

/// Whether it is the name of a frame of any sequence.
[[nodiscard]] bool is_sequence_frame_name(const std::string& name);

/// Where frames from the places of views go, each in `folder` by its view and the kind of frame,
/// such as its mode: STEM.KIND.png (file_stems_without_dots). Such a file may stand there from
/// before and is then replaced. Throws Error (E-OUT-EXISTS) where it is no file, or is named like
/// one of `photographs`, which are all that are known of the capture.
[[nodiscard]] std::vector<std::filesystem::path> frames_of_views(
    const std::filesystem::path& folder, const std::vector<std::string>& views,
    const std::string& kind, const std::vector<std::string>& photographs);

/// Whether frames of a path go to one video file there, instead of a folder.
[[nodiscard]] bool names_video(const std::filesystem::path& out);

/// Where the frames of a video are drawn, and where they stay when it cannot be made of them.
[[nodiscard]] std::filesystem::path frames_folder_of_video(const std::filesystem::path& video);

/// To be called before anything is drawn: pictures are PNG files. `option` is what named the file.
/// Throws Error (E-RENDER-OUT, E-FILE-WRITE).
void check_picture_out(const std::filesystem::path& out, const std::string& option = "--out");

/// The same for frames of all photographs, which go into a folder beside whatever is there. Throws
/// Error (E-OUT-EXISTS, E-FILE-WRITE).
void check_frames_folder(const std::filesystem::path& out);

/// The same for the frames of a path: videos are MP4 files, and a folder of other things would be
/// lost. Throws Error (E-RENDER-OUT, E-OUT-EXISTS, E-FILE-WRITE).
void check_path_out(const std::filesystem::path& out);

}  // namespace lumi
