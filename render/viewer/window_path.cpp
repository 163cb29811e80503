#include "render/viewer/window_path.h"

#include <system_error>
#include <utility>

namespace lumi {

std::filesystem::path written_into() {
    std::error_code gone;
    const std::filesystem::path folder = std::filesystem::current_path(gone);
    return gone ? std::filesystem::path(".") : folder;
}

void WindowPath::record(const Eigen::Vector2i& size_px, double clock_s, ViewerState& state,
                        FrameStatistics& statistics) {
    statistics.recording.clear();
    const bool is_asked_again = std::exchange(state.writes_path_again, false);
    if (state.records_path) {
        statistics.recording = recording_.append(state.navigation.eye, size_px.x(), size_px.y(),
                                                 clock_s, state.has_jumped);
    } else if (recording_.is_recording() || is_asked_again) {
        const std::string message = end();
        if (recording_.is_unwritten()) {
            statistics.tell_failure(message);
        } else if (!message.empty()) {
            statistics.tell(message);
        }
    }
    state.has_jumped = false;
    state.has_path = !state.records_path && !recording_.path().empty();
    state.has_unwritten_path = recording_.is_unwritten();
}

void WindowPath::show(std::vector<TimedEye> eyes, ViewerState& state) {
    go_to_eye(eyes.front().eye, state);
    if (eyes.size() < 2) return;
    recording_ = PathRecording(std::move(eyes));
    replay_began_s_.reset();
    state.has_path = true;
    state.replays_path = true;
}

bool WindowPath::replay(double clock_s, ViewerState& state) {
    state.replays_path = state.replays_path && state.has_path && !state.records_path;
    if (!state.replays_path) {
        replay_began_s_.reset();
        return false;
    }
    if (!replay_began_s_) replay_began_s_ = clock_s;
    const double time_s = clock_s - *replay_began_s_;
    state.navigation = carried_to(state.navigation, eye_at_time(recording_.path(), time_s));
    if (time_s < recording_.path().back().time_s) return true;
    state.replays_path = false;
    replay_began_s_.reset();
    return true;
}

}  // namespace lumi
