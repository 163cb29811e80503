#include "render/viewer/path_recording.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "calib/work/counted.h"
#include "calib/work/error_of_exception.h"
#include "calib/work/formatted.h"
#include "calib/work/whole_file.h"
#include "render/lumigraph/same_eye.h"
#include "render/paths/photograph_eye.h"
#include "render/viewer/eye_json.h"

namespace lumi {

namespace {

std::string length_of(const std::vector<TimedEye>& path) {
    return counted(path.size(), "eye") + formatted(", %.1f s", path.back().time_s);
}

}  // namespace

void write_path_file(const std::filesystem::path& path, std::span<const TimedEye> eyes) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const TimedEye& timed : eyes) {
        nlohmann::ordered_json eye{{"time_s", timed.time_s}};
        eye.update(eye_json(timed.eye));
        list.push_back(std::move(eye));
    }
    write_whole_text(path, nlohmann::ordered_json{{"eyes", std::move(list)}}.dump(1) + "\n");
}

std::filesystem::path next_path_file(const std::filesystem::path& folder) {
    for (int number = 1;; ++number) {
        char name[32];
        std::snprintf(name, sizeof(name), "lumi-path-%04d.json", number);
        if (!std::filesystem::exists(folder / name)) return folder / name;
    }
}

void PathRecording::add(const TimedEye& timed) {
    // A rest has a beginning and an end, between which the eye must not creep.
    const std::size_t count = path_.size();
    const bool rests = is_same_eye(path_.back().eye, timed.eye);
    if (rests && count > 1 && is_same_eye(path_[count - 2].eye, timed.eye)) {
        path_.back() = timed;
    } else {
        path_.push_back(timed);
    }
}

std::string PathRecording::append(const Eye& eye, int width_px, int height_px, double clock_s,
                                  bool has_jumped) {
    if (!std::exchange(is_recording_, true)) {
        path_ = {{0.0, fitted_to(eye, width_px, height_px)}};
        is_unwritten_ = true;
        began_at_s_ = clock_s;
    }
    const Camera& first = path_.front().eye.camera;
    const TimedEye now{clock_s - began_at_s_, fitted_to(eye, first.width_px, first.height_px)};
    if (now.time_s > path_.back().time_s) {
        if (has_jumped) add({now.time_s, path_.back().eye});
        add(now);
    }
    std::string words = "recording: " + length_of(path_);
    if (width_px != first.width_px || height_px != first.height_px)
        words += ", in the size of its beginning: " + std::to_string(first.width_px) + " x " +
                 std::to_string(first.height_px);
    return words;
}

std::string PathRecording::end(const std::filesystem::path& folder) {
    is_recording_ = false;
    if (!is_unwritten_) return {};
    try {
        const std::filesystem::path path = next_path_file(folder);
        write_path_file(path, path_);
        is_unwritten_ = false;
        return "wrote " + path.string() + ": " + length_of(path_);
    } catch (const std::exception& exception) {
        const std::optional<Error> error = error_of_exception(exception);
        if (!error) throw;
        return std::string(error->what()) + " - " + error->advice();
    }
}

}  // namespace lumi
