#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "render/paths/timed_path.h"

namespace lumi {

/// Writes a path of eyes as `lumi render --path` reads it: {"eyes": [{"time_s", "camera",
/// "cam_from_world"}, ...]}, whole or not at all. Throws Error (E-FILE-WRITE).
void write_path_file(const std::filesystem::path& path, std::span<const TimedEye> eyes);

/// lumi-path-0001.json, or the first number that is free in the folder.
[[nodiscard]] std::filesystem::path next_path_file(const std::filesystem::path& folder);

/// The eyes of a window while its path is recorded.
class PathRecording {
 public:
    PathRecording() = default;
    /// One that has ended.
    explicit PathRecording(std::vector<TimedEye> path) : path_(std::move(path)) {}

    /// The eye as a window of this size shows it; all eyes get the size of the window in which the
    /// recording began. While the eye rests only the end of the rest is added. Times are those of a
    /// steady clock and grow. An eye that has jumped did not fly from the one before: that one
    /// rests until then, and two eyes have one time. Returns what people are told.
    std::string append(const Eye& eye, int width_px, int height_px, double clock_s,
                       bool has_jumped = false);
    /// Ends the recording, and writes what was recorded and is not written yet into the folder.
    /// Returns what people are told: nothing where there is nothing to write, and why where it
    /// cannot be written; it can then be tried again until the next recording begins.
    std::string end(const std::filesystem::path& folder);
    [[nodiscard]] bool is_recording() const { return is_recording_; }
    /// Whether a path that has ended could not be written.
    [[nodiscard]] bool is_unwritten() const { return !is_recording_ && is_unwritten_; }
    /// The path that was recorded last, whole once it has ended; empty before the first.
    [[nodiscard]] const std::vector<TimedEye>& path() const { return path_; }

 private:
    void add(const TimedEye& timed);

    std::vector<TimedEye> path_;
    bool is_recording_ = false;
    bool is_unwritten_ = false;
    double began_at_s_ = 0.0;  ///< By the clock.
};

}  // namespace lumi
