#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/viewer/commands.h"
#include "render/viewer/frame_statistics.h"
#include "render/viewer/path_recording.h"

namespace lumi {

/// Where screenshots and paths go: the working folder, by its whole name unless it is gone.
[[nodiscard]] std::filesystem::path written_into();

/// The path of a window's eye, recorded and replayed as its state wishes. Times are those of a
/// steady clock.
class WindowPath {
 public:
    /// Takes in the present eye, or writes what was recorded; what there is to tell goes into the
    /// statistics.
    void record(const Eigen::Vector2i& size_px, double clock_s, ViewerState& state,
                FrameStatistics& statistics);
    /// Stands at one eye alone, and replays more, in place of what was recorded.
    void show(std::vector<TimedEye> eyes, ViewerState& state);
    /// Carries the eye along; true while it does.
    bool replay(double clock_s, ViewerState& state);
    /// Writes what is recorded; what people are told, as of PathRecording::end.
    std::string end() { return recording_.end(written_into()); }
    void forget() { recording_ = PathRecording(); }

 private:
    PathRecording recording_;
    std::optional<double> replay_began_s_;
};

}  // namespace lumi
